#pragma once
// Parentheses, brackets, braces and bars that are taller than a letter: one line each, as thick as the letters' stems.

#include "render/math_layout.hpp"

namespace blossom {

struct TallFence {
  TextStroke stroke;  // from x = 0 to the width, with room at both sides
  double width = 0;
};
// One of ( ) [ ] { } |, from `top` down to `bottom`, beside letters of that size.
TallFence tall_fence(char fence, double top, double bottom, double em);

}  // namespace blossom
