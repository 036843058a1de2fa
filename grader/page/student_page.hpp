#pragma once
// The page a student gets: one HTML file that needs nothing else and no network. Score and verdicts, the advice, and a
// player that steps through their own trace beside the right one, by buttons and arrow keys; it prints as a table of
// all steps and reads well aloud. What the exercise's level of feedback hides is not in the file.

#include <string>

#include "grader/result.hpp"

namespace blossom {

std::string student_page(const StudentResult&);

// Text as it may stand in HTML, in an element or a quoted attribute: & < > " ' are escaped, control characters and
// invalid UTF-8 become U+FFFD.
std::string html_escape(std::string_view);

}  // namespace blossom
