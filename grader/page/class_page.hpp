#pragma once
// The page an instructor gets: the class at a glance. Made from results.jsonl alone, line by line, in bounded memory:
// for each submission at most 16 bytes and its student's ID.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "grader/result.hpp"

namespace blossom {

// Histogram of scores; the hardest cells; misconceptions by count with a typical example; item statistics (difficulty:
// mean share of points; discrimination: correlation of a part's share with the rest of the score); identical answers
// (as typed: 0.5 is not 1/2) and other submissions worth a look; a table of students with links.
class ClassStatistics {
 public:
  // Takes each file of the page as soon as it is whole, by its path relative to the folder of results: "class.html"
  // last. The table of a class of more than 1000 students goes to pages of its own, "class/1.html", "class/2.html", ...
  using Write = std::function<void(const std::string& file, std::string_view html)>;
  // The assignment, where there is one, says how the names of its exercises' values are typeset.
  ClassStatistics(std::string title, Write write, const Assignment* assignment = nullptr);
  ~ClassStatistics();
  ClassStatistics(const ClassStatistics&) = delete;
  ClassStatistics& operator=(const ClassStatistics&) = delete;

  // The results of one student (blossom.result/1, the instructor's), in the order of the class, and where the student's
  // page is, relative to the folder of results ("students/s17.html"; empty: there is none).
  void add(const Json& result, std::string_view page);
  // Something that is no student's of the class. What is `source` was handed in by or for `who`; both may be empty.
  void add_stray(std::string_view kind, std::string_view who, std::string_view source, std::string_view text);
  // Once, after the last student.
  void finish();

  // The figures as JSON, for summary.json.
  std::string json() const;

 private:
  struct Figures;
  std::unique_ptr<Figures> figures_;
};

}  // namespace blossom
