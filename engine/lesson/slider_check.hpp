#pragma once
// Inputs moved: what a slider does to them, and whether it may.

#include <string_view>

#include "lesson/lesson.hpp"

namespace blossom {

// The number at a path such as "curve.points[1][0]" of an object of inputs; nullptr: the path leads to none.
Json* find_number(Json& inputs, std::string_view path);

// Whether a lesson's inputs are valid with each slider at both of its ends, and its own number is between them: what is
// wrong there, told at that end.
// Precondition: load_lesson accepts the document.
Diagnostics check_sliders(const JsonDocument&);

}  // namespace blossom
