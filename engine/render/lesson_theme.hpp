#pragma once
// A theme with the colours that a lesson asks for.

#include "lesson/colors.hpp"
#include "render/theme.hpp"

namespace blossom {

// Lines, points, faces and text of these roles in the lesson's colours, text darker or lighter where it would not have
// 4.5:1 on the background. Without colours the theme as it is.
Theme with_colors(const Theme&, const LessonColors&);

}  // namespace blossom
