#pragma once
// What a folder of results was made of (run.json), so that a run is only gone on with, or left as it is, where nothing
// it depends on has changed.

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "grader/batch/batch.hpp"

namespace blossom {

struct Manifest {
  bool finished = false;
  Time now{};
  // Digests of what the results depend on.
  std::string assignment;   // with its exercises
  std::string roster;       // empty: none
  std::string options;      // formats, pages
  std::string secret;       // the course's
  std::string program;      // its version
  std::string submissions;  // names, sizes and times; of standard input nothing can be told
};

Manifest manifest_of(const BatchOptions&, const Assignment&, const std::string& secret, Time now);

// Empty if results made of the one are results made of the other; otherwise what is different, as the end of a
// sentence.
std::string difference(const Manifest& there, const Manifest& wanted);

// What the folder has. Nothing where it has none, or one that cannot be read.
std::optional<Manifest> read_manifest(const std::filesystem::path& out);
void write_manifest(const Manifest&, const std::filesystem::path& out, const std::filesystem::path& work);

// Of a secret; empty: none.
std::string digest_of_secret(const std::string& secret);

}  // namespace blossom
