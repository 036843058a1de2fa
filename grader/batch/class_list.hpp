#pragma once
// The class in its order: the roster, or everybody who handed in.

#include <optional>
#include <string>
#include <vector>

#include "grader/batch/newcomers.hpp"
#include "grader/roster.hpp"

namespace blossom {

class ClassList {
 public:
  explicit ClassList(Roster roster) : roster_(std::move(roster)) {}
  explicit ClassList(Newcomers newcomers) : newcomers_(std::move(newcomers)) {}

  bool has_roster() const { return roster_.has_value(); }
  std::uint64_t size() const { return roster_ ? roster_->size() : newcomers_->size(); }
  Student student(std::uint64_t index) const;
  // Whose a submission is that may be known by these keys; without a roster, the first of them. Nobody's, if the roster
  // does not say clearly: then `why_not` is what is to be said of it, unless there are no keys.
  std::optional<std::uint64_t> find(const std::vector<StudentKey>& keys, std::string& why_not);
  void finish();

 private:
  std::optional<Roster> roster_;
  std::optional<Newcomers> newcomers_;
};

}  // namespace blossom
