#pragma once
// A JSON file that the player keeps for itself: private to the user, and never written over while something in it could
// not be read.

#include <filesystem>
#include <optional>

#include "base/json.hpp"

namespace blossom {

// Nothing, silently, while there is no such file; nothing, with diagnostics, if it cannot be read.
std::optional<JsonDocument> read_kept(const std::filesystem::path&, const JsonLimits&, Diagnostics&);

// Writes it with mode 0600, its missing folders with 0700. A file that is there and is `damaged` becomes FILE.bad
// first. False for an empty path: there is no place to keep anything.
Checked<bool> write_kept(const std::filesystem::path&, std::string_view content, bool damaged = false);

}  // namespace blossom
