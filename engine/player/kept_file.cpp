#include "player/kept_file.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <system_error>

namespace blossom {
namespace fs = std::filesystem;
namespace {

// As the XDG specification says: "an attempt should be made to create it with permission 0700".
Diagnostics make_private_folders(const fs::path& folder) {
  fs::path path;
  for (const fs::path& part : folder) {
    path /= part;
    std::error_code error;
    if (fs::is_directory(path, error)) continue;
    if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST)
      return {{path.string(), 0, 0, "", "this folder cannot be made: " + std::generic_category().message(errno)}};
  }
  return {};
}

}  // namespace

std::optional<JsonDocument> read_kept(const fs::path& file, const JsonLimits& limits, Diagnostics& diagnostics) {
  std::error_code error;
  if (file.empty() || fs::status(file, error).type() == fs::file_type::not_found) return std::nullopt;
  auto document = JsonDocument::load(file, limits);
  diagnostics.insert(diagnostics.end(), document.diagnostics.begin(), document.diagnostics.end());
  return std::move(document.value);
}

Checked<bool> write_kept(const fs::path& file, std::string_view content, bool damaged) {
  if (file.empty()) return false;
  if (auto wrong = make_private_folders(file.parent_path()); !wrong.empty()) return wrong;
  if (damaged) {
    fs::path aside = file;
    aside += ".bad";
    std::error_code error;
    fs::rename(file, aside, error);
    if (error) return Diagnostics{{file.string(), 0, 0, "", "cannot be renamed to FILE.bad: " + error.message()}};
  }
  return write_file(file, content, 0600);
}

}  // namespace blossom
