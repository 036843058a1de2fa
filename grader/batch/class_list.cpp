#include "grader/batch/class_list.hpp"

#include "base/diagnostics.hpp"

namespace blossom {
namespace {

constexpr std::size_t longest_id = 200;  // bytes, of one that nobody vouches for

}  // namespace

Student ClassList::student(std::uint64_t index) const {
  if (roster_) return roster_->student(index);
  Student student;
  student.id = newcomers_->id(index);
  return student;
}

std::optional<std::uint64_t> ClassList::find(const std::vector<StudentKey>& keys, std::string& why_not) {
  why_not.clear();
  if (keys.empty() || keys.front().text.empty()) return std::nullopt;
  if (!roster_) {
    if (keys.front().text.size() <= longest_id) return newcomers_->index_of(keys.front().text);
    why_not = "its student's name is too long";
    return std::nullopt;
  }
  const Roster::Match match = roster_->match(keys);
  if (match.index) return *match.index;
  why_not = match.ambiguous ? "more than one on the roster may be meant by " : "nobody on the roster is known as ";
  for (const StudentKey& key : keys) {
    if (&key != &keys.front()) why_not += " or by ";
    why_not += key.kind == StudentKey::Kind::lms_number ? "the number " + key.text : excerpt(key.text);
  }
  return std::nullopt;
}

void ClassList::finish() {
  if (newcomers_) newcomers_->finish();
}

}  // namespace blossom
