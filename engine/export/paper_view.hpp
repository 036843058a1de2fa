#pragma once
// Pictures for paper and pages of text, where nobody can come nearer: their letters are as large as can be read.

#include "export/story.hpp"
#include "render/theme.hpp"

namespace blossom {

// Of the em, in the units of the view; numbers at a grid are quieter than names.
struct LetterSizes {
  double numbers = 0, names = 0;
};
// No letter is smaller.
void enlarge_letters(View&, const Theme&, const LetterSizes&);

// The knots of the curve at a step as a view of this width, with the basis functions above them if that is wished. Of
// no height where there are no knots, or several curves.
View knots_view(const StoryScene&, std::uint32_t step, double width, bool functions);

// A picture above the knots, on a page of its own.
Scene picture_with_knots(const StoryScene&, std::uint32_t step, double width, double height, const Theme&,
                         const LetterSizes&);

}  // namespace blossom
