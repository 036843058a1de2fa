#pragma once
// Something handed in, before anybody looked at it.

#include <optional>
#include <string>

#include "grader/time.hpp"

namespace blossom {

struct Submission {
  std::string source;             // where it came from: a path inside the folder or archive; empty: a line of a stream
  std::optional<Time> submitted;  // when
  std::string text;               // its bytes
  std::string problem;            // not empty: it was not read (too large, a symbolic link, ...), and why
};

}  // namespace blossom
