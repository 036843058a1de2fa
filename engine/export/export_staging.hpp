#pragma once
// Several files that are written as one: into a hidden folder beside their places first, and moved there at the end. If
// it does not come to that, nothing is left.

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

class Staging {
 public:
  // For files in this folder, which is made where it is missing.
  static Checked<Staging> open(const std::filesystem::path& folder);
  ~Staging();
  Staging(Staging&&) noexcept;
  Staging& operator=(Staging&&) = delete;

  // Where to write what will be `name` in the folder; one folder below it is possible: "pictures/1.svg".
  std::filesystem::path path(const std::filesystem::path& name);
  // For what is needed on the way only.
  std::filesystem::path scratch(std::string_view name) const { return hidden_ / "scratch" / name; }
  // Each file to its place, as write_file does: the one that stood there is replaced, never a folder or a device. The
  // places in the order in which they were asked for.
  Checked<std::vector<std::filesystem::path>> publish();
  // Diagnostics of writing to path(name) name the place where it was to go.
  Diagnostics in_place(Diagnostics) const;

 private:
  explicit Staging(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_, hidden_;
  std::vector<std::filesystem::path> made_;  // folders that were missing, the outermost last
  std::vector<std::filesystem::path> names_;
};

}  // namespace blossom
