#pragma once
// The graders of an assignment: one for everybody where an exercise's numbers are the same for all, one for each
// student where they vary.

#include <memory>
#include <optional>
#include <vector>

#include "grader/assignment.hpp"
#include "grader/grade.hpp"
#include "grader/variant.hpp"

namespace blossom {

class Examiner {
 public:
  // `now` decides which level of feedback is given. The secret may be empty where nothing varies.
  Examiner(Assignment assignment, std::string secret, Time now);

  const Assignment& assignment() const { return assignment_; }
  Time now() const { return now_; }
  bool varies(std::size_t item) const { return varies_[item]; }
  // Shared by everybody, or made for this student (the last few are kept). Nothing, with the reason, when no variant
  // can be made. Not for several threads at once.
  Checked<std::shared_ptr<const Grader>> grader(std::size_t item, const std::string& student_id);

 private:
  Assignment assignment_;
  std::string secret_;
  Time now_;
  std::vector<bool> varies_;
  std::vector<std::shared_ptr<const Grader>> shared_;  // by item; null where it varies
  std::vector<std::optional<VariantMaker>> makers_;    // likewise the other way round
  struct Made {
    std::size_t item;
    std::string student;
    std::shared_ptr<const Grader> grader;
  };
  std::vector<Made> made_;
};

}  // namespace blossom
