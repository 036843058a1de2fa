#pragma once
// Variants on paper: one page for each student with their own numbers and room for the answers, or the instructor's
// solutions to them.

#include <string>
#include <string_view>

#include "grader/exercise.hpp"
#include "grader/student.hpp"

namespace blossom {

// A file is a head, the students' pages, and an end.
std::string sheet_head(std::string_view title);
// The values asked stand on it only if `solutions`.
std::string sheet_page(const Exercise& variant, const Student& student, bool solutions);
std::string sheet_end();

}  // namespace blossom
