#pragma once
// Files that are read in one process and parsed in another.

#include <filesystem>
#include <string>

#include "base/diagnostics.hpp"

namespace blossom {

// What diagnostics call it: its path, or "standard input" for "-".
std::string file_title(const std::filesystem::path&);

// The bytes of a regular file, or of standard input; of more than `most` so many and one more.
Checked<std::string> read_text(const std::filesystem::path&, std::size_t most);

}  // namespace blossom
