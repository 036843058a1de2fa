#pragma once
// What somebody handed in: {"schema": "blossom.answers/1", "exercise": id, "student"?: id, "answers": {name: value,
// ...}}. A value is
//   a number                       3, -0.5, or as text "2/5", "0.4"
//   a point                        an array of its coordinates
//   a knot vector                  an array of any length
//   a set                          {"set": [...]}, or an array, where the exercise takes a list in any order
// Nothing in it is trusted: see base/json.hpp for what a document may be, and submission_limits for its size.

#include <string>
#include <vector>

#include "grader/exercise.hpp"

namespace blossom {

struct Answers {
  std::string reason;             // not empty: the whole is invalid, and why
  std::vector<const Json*> part;  // of each part of the exercise; nullptr: no answer. Points into the document.
  // Parts without an answer, with a name that is theirs but for capital and small letters. What stands under it does
  // not count.
  std::vector<std::pair<std::size_t, std::string>> misnamed;
  std::vector<const std::string*> ignored;  // names that are not asked; they point into the document
  std::vector<std::string> notes;           // what else was ignored
};

// Matches a document's answers with the parts they are for. The reason or the notes are for its author.
Answers match_answers(const Exercise&, const Checked<JsonDocument>&);
Answers match_answers(const Exercise&, const Json& root);

// The asked value that `name` seems to misspell. Not one of other indices, which are as likely meant as they are typed;
// none where `name` is another value of the run.
std::optional<std::string> nearest_asked(const Exercise&, const std::string& name);

// A part's answer with its numbers. `problem` is not empty when it has not the part's shape, and says what would be
// right.
struct Typed {
  std::vector<std::string_view> texts;  // as typed; of a set, in ascending order
  Numbers<Exact> numbers;
  std::string problem;
};
Typed read_typed(const Part&, const Json&);

// What accuracy is asked, in words, if the numbers are near the right ones, up to 20 times as far off as they may be,
// and yet outside: "3 decimals are asked". Else nothing.
std::string near_miss(const Part&, NumbersView<Exact> traced, const Typed&);

// Whether it is right, in the fast way: nothing is allocated (but for a set, which is sorted). `different` also stands
// for a wrong shape.
enum class Match : std::uint8_t { right, different };
Match match(const Part&, const Json&);

}  // namespace blossom
