#pragma once
// Variants on paper: one page for each student with their own numbers and room for the answers, or the instructor's
// solutions to them.

#include <cstdint>
#include <string>
#include <string_view>

#include "grader/exercise.hpp"
#include "grader/student.hpp"

namespace blossom {

// Who else in the class has a student's numbers.
enum class Sharing : std::uint8_t { nobody_else, some, everybody };

// A file is a head, the students' pages, and an end.
std::string sheet_head(std::string_view title);
// The values asked stand on it only if `solutions`.
std::string sheet_page(const Exercise& variant, const Student& student, bool solutions, Sharing);
std::string sheet_end();

}  // namespace blossom
