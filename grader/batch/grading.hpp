#pragma once
// The second stage of a class: students are graded by workers, portion by portion. A finished portion is one file,
//
//   portions/NUMBER    results, incidents and gradebook rows of portion_size students, in the order of the class
//
// and its students' own files are in their places by then.

#include <deque>
#include <functional>

#include "grader/batch/batch.hpp"
#include "grader/batch/class_list.hpp"
#include "grader/batch/spool.hpp"

namespace blossom {

inline constexpr std::uint64_t portion_size = 256;

// Where a student's file is, relative to the folder of results.
class StudentFiles {
 public:
  explicit StudentFiles(std::uint64_t students) : spread_(students > 5000) {}
  // folder/ID.extension, or folder/1f/ID.extension.
  std::string path(std::string_view folder, std::string_view id, std::string_view extension) const;
  void make_folders(const std::filesystem::path& out, std::string_view folder) const;

 private:
  bool spread_;
};

// What a portion's file holds.
struct PortionContent {
  std::uint64_t students = 0;
  std::string results;
  std::string incidents;
  std::vector<std::string> rows;  // by format of the course
  double score = 0;               // the sum
  IncidentCounts counts{};
};
std::filesystem::path portion_file(const std::filesystem::path& work, std::uint64_t number);
PortionContent read_portion(const std::filesystem::path&);

class Grading {
 public:
  Grading(const BatchOptions&, const ClassList&, const SpoolReader&, std::filesystem::path work);
  // Grades all portions that are not finished. Diagnostics when the spool is not what it was.
  Checked<bool> run(Workers&, const std::function<void(const BatchProgress&)>&);

 private:
  struct Portion {
    std::uint64_t number = 0;
    std::size_t left = 0;  // answers that are still to come
    std::vector<std::optional<WorkAnswer>> answers;
  };
  struct LostItem {
    WorkItem item;
    std::string text;
  };

  bool next(std::string& item);
  WorkItem next_student();
  void skip_finished();
  void open_part(std::uint64_t part);
  void fetch();
  void answer(std::string_view item, WorkAnswer);
  void finish(Portion&);
  void settle(Workers&, LostItem);

  const BatchOptions* options_;
  const ClassList* list_;
  const SpoolReader* spool_;
  std::filesystem::path work_;
  StudentFiles files_;
  std::vector<const ReportFormat*> of_student_;

  std::uint64_t next_ = 0;           // the next student to be handed out
  std::uint64_t part_ = UINT64_MAX;  // of the spool, that is read
  std::optional<SpoolReader::Walk> walk_;
  std::optional<std::uint64_t> fetched_;  // the student of the record that is read next
  std::string record_;
  Diagnostics torn_;
  std::deque<Portion> open_;
  std::deque<LostItem> lost_;
  std::uint64_t done_ = 0;
};

}  // namespace blossom
