#pragma once
// What comes from the person, whatever the window is: a real one, or a script.

#include <string>

namespace blossom {

struct Event {
  enum class Kind : std::uint8_t { move, press, release, wheel, key_down, key_up, text, drop, leave, close };
  Kind kind = Kind::move;
  double x = 0, y = 0;  // pixels from the top left; wheel: notches right and up
  int button = 0;       // left, right, middle
  // Of keys: a letter or digit, or "Right", "Space", "F1", "Escape", ... (key_names()); punctuation by its character on
  // the key. text: UTF-8. drop: a path.
  std::string text;
  bool ctrl = false, shift = false, alt = false;
};

}  // namespace blossom
