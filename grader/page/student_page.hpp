#pragma once
// The page a student gets: one HTML file that needs nothing else and no network. Score and verdicts, the advice, and a
// player that steps through their own trace beside the right one, by buttons and arrow keys; it prints as a table of
// all steps and reads well aloud. What the exercise's level of feedback hides is not in the file.

#include <string>

#include "base/html.hpp"
#include "grader/result.hpp"

namespace blossom {

std::string student_page(const StudentResult&);

}  // namespace blossom
