#pragma once
// What is counted of a class, for its page. Everything here is bounded: lists keep their first entries and count the
// rest.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grader/grade.hpp"

namespace blossom {

inline constexpr std::size_t histogram_bins = 20;
inline constexpr std::size_t fine_bins = 1000;

// How two quantities go together, one observation at a time (Welford's updates, which lose no digits to large sums).
class Correlation {
 public:
  void add(double x, double y);
  std::uint64_t count() const { return count_; }
  double mean_x() const { return mean_x_; }
  bool defined() const { return count_ > 1 && xx_ > 1e-12 && yy_ > 1e-12; }
  double value() const;  // Pearson's; precondition: defined

 private:
  std::uint64_t count_ = 0;
  double mean_x_ = 0, mean_y_ = 0, xx_ = 0, yy_ = 0, xy_ = 0;
};

struct ItemFigures {
  std::string exercise, value;
  const Algorithm* algorithm = nullptr;  // null: its names are shown as they are typed
  std::array<std::uint64_t, verdict_count> verdicts{};
  Correlation with_rest;  // share of points, with the share of all other points
  std::string asked;      // by a lesson's question; empty: it is a value that is asked for
};

struct Example {
  std::string student, page, exercise, value, answer, told;
  const Algorithm* algorithm = nullptr;
};

struct MistakeFigures {
  std::uint64_t values = 0;    // that show it
  std::uint64_t students = 0;  // with at least one such value, or whose whole answer it explains
  std::uint64_t explains = 0;  // submissions in which nothing is wrong but by it, alone or with one more
  Example example;
};

struct Worth {  // a look
  std::string student, page, exercise, why;
};
struct WorthList {
  std::vector<Worth> first;
  std::uint64_t count = 0;
};

struct StudentRow {
  std::string id, name, section, page, flags;
  double points = 0, max_points = 0;
  int days_late = 0;
};

// Who gave the same answers: the same wrong ones or, where the numbers vary, the same ones at all. 16 bytes a
// submission, and the ID.
class Fingerprints {
 public:
  struct Answers {
    std::uint64_t hash = 0;
    std::size_t exercise = 0;
    bool varies = false;
    bool right = false;  // all of them, for this student's numbers
  };
  void add(const Answers&, std::string_view id, std::string_view page);
  struct Group {
    std::size_t exercise = 0;
    bool varies = false;
    std::uint64_t size = 0;
    std::uint64_t right = 0;                                    // for whose numbers they are right
    std::vector<std::pair<std::string, std::string>> students;  // ID and page, the first few; those of `right` lead
  };
  // Groups of at least two, not all of them right, and, where everybody has the same numbers, few enough to be no
  // accident of the exercise.
  std::vector<Group> groups(const std::vector<std::uint64_t>& handed_in);
  bool complete() const { return complete_; }

 private:
  struct Entry {
    std::uint64_t hash;
    std::uint32_t id_at;
    std::uint16_t exercise;  // the highest bits: its numbers vary; the answers are right
    std::uint16_t page;      // how the page follows from the ID
  };
  static_assert(sizeof(Entry) == 16);
  std::uint16_t pattern_of(std::string_view id, std::string_view page);
  std::string page_of(const Entry&) const;
  std::string id_of(const Entry& entry) const { return ids_.data() + entry.id_at; }

  std::vector<Entry> entries_;
  std::string ids_;                                                      // each with a NUL behind it
  std::vector<std::pair<std::string, std::string>> patterns_{{"", ""}};  // before and behind the file name; 0: no page
  bool complete_ = true;
};

struct ClassFigures {
  std::string title, assignment;
  std::uint64_t students = 0, with_work = 0, late = 0;
  double sum_of_scores = 0;
  std::array<std::uint64_t, histogram_bins> histogram{};
  std::array<std::uint64_t, fine_bins + 1> fine{};
  std::vector<std::string> exercises;
  std::vector<std::uint64_t> handed_in;  // by exercise
  std::vector<ItemFigures> items;
  bool all_items = true;
  std::map<std::string, MistakeFigures, std::less<>> mistakes;  // misconceptions and notes, by their stable words
  std::map<std::string, std::uint64_t, std::less<>> incidents;
  WorthList unexplained, unread;
  Fingerprints fingerprints;

  double quantile(double share) const;  // of the scores, to a thousandth
};

// "not readable" for an incident's kind.
std::string incident_words(std::string_view kind);

// "the weights are swapped" for a misconception's id, or what a note's word means.
std::string mistake_title(std::string_view word);

std::string class_html(ClassFigures&, const std::vector<StudentRow>& rows, std::size_t table_pages);
std::string class_table_html(const ClassFigures&, const std::vector<StudentRow>& rows, std::size_t page, bool is_last);
std::string class_json(ClassFigures&);

}  // namespace blossom
