#pragma once
// The steps of a run, the triangular scheme and the player as HTML. Every step's text stands in the document; the
// player shows one of them at a time and draws its picture.

#include <string>
#include <string_view>

#include "grader/page/student_run.hpp"

namespace blossom {

// How a verdict is shown: never by colour alone.
struct Sign {
  std::string_view style;  // a class of the style sheet
  std::string_view symbol;
  std::string_view word;
};
Sign sign_of(Verdict);
Sign sign_of(Standing);
std::string sign_html(const Sign&);

void append_run(std::string& out, const StudentRun&);

}  // namespace blossom
