#pragma once
// What two versions of an assignment have different, as far as it can change a grade.

#include <map>
#include <string>

#include "grader/assignment.hpp"

namespace blossom {

class Revision {
 public:
  Revision(const Assignment& was, const Assignment& now);

  // Why a part of an exercise may count otherwise: "tolerance exact -> 0.001; points 1 -> 2". Empty: nothing of it has
  // changed.
  std::string of_part(const std::string& exercise, const std::string& part) const;
  // What concerns all of the exercise: that it is new or gone, and its points in the assignment.
  std::string of_exercise(const std::string& exercise) const;
  const std::string& of_lateness() const { return lateness_; }  // the date, and what it costs to miss it
  const std::string& of_attempts() const { return attempts_; }  // which submission counts
  // Whether anything of it has.
  bool touches(const std::string& exercise) const;

 private:
  void compare(const Assignment::Item& was, const Assignment::Item& now);

  std::string lateness_, attempts_;
  std::map<std::string, std::string> exercises_;
  std::map<std::string, std::map<std::string, std::string>> parts_;
};

std::string tolerance_words(const Tolerance&);

}  // namespace blossom
