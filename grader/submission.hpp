#pragma once
// Something handed in, before anybody looked at it.

#include <optional>
#include <string>
#include <string_view>

#include "grader/time.hpp"

namespace blossom {

struct Submission {
  std::string source;             // where it came from: a path inside the folder or archive; empty: a line of a stream
  std::optional<Time> submitted;  // when
  std::string text;               // its bytes
  std::string problem;            // not empty: it was not read (too large, a symbolic link, ...), and why
};

// What systems leave in folders by themselves: .DS_Store, ._answers.json, __MACOSX, .git, Thumbs.db, desktop.ini.
bool is_litter(std::string_view file_name);

}  // namespace blossom
