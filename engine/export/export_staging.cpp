#include "export/export_staging.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

namespace blossom {
namespace {

namespace fs = std::filesystem;

Diagnostics failed(const fs::path& path, const std::string& why) {
  return {{path.string(), 0, 0, "", "cannot be written: " + why}};
}

std::string system_says(int error) { return std::generic_category().message(error); }

// A file that is replaced keeps its permissions; through a symbolic link the file it points to is replaced.
Checked<bool> move(const fs::path& from, const fs::path& to) {
  std::error_code unresolved;
  const fs::path resolved = fs::canonical(to, unresolved);
  const fs::path target = unresolved ? to : resolved;
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) {
    if (!S_ISREG(status.st_mode))
      return Diagnostics{{to.string(), 0, 0, "",
                          std::string("must be a file, not a ") + (S_ISDIR(status.st_mode) ? "folder" : "device")}};
    if (::chmod(from.c_str(), status.st_mode & 07777) != 0) return failed(to, system_says(errno));
  }
  if (::rename(from.c_str(), target.c_str()) != 0) return failed(to, system_says(errno));
  return true;
}

}  // namespace

Checked<Staging> Staging::open(const fs::path& given) {
  const fs::path folder = given.empty() ? fs::path(".") : given;
  Staging staging(folder);
  std::error_code error;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) staging.made_.push_back(at);
  fs::create_directories(folder, error);
  if (error) return failed(folder, error.message());
  static std::atomic<unsigned> count{0};
  const fs::path hidden = folder / (".blossom-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
  if (!fs::create_directory(hidden, error) || error)
    return failed(folder, error ? error.message() : "its place is taken");
  staging.hidden_ = hidden;
  fs::create_directory(hidden / "scratch", error);
  if (error) return failed(folder, error.message());
  return staging;
}

Staging::Staging(Staging&& other) noexcept
    : folder_(std::move(other.folder_)),
      hidden_(std::move(other.hidden_)),
      made_(std::move(other.made_)),
      names_(std::move(other.names_)) {
  other.hidden_.clear();
  other.made_.clear();
}

Staging::~Staging() {
  std::error_code error;
  if (!hidden_.empty()) fs::remove_all(hidden_, error);
  for (const fs::path& folder : made_) ::rmdir(folder.c_str());  // those that are empty
}

fs::path Staging::path(const fs::path& name) {
  std::error_code error;  // is told when the file is written
  if (name.has_parent_path()) fs::create_directories(hidden_ / name.parent_path(), error);
  names_.push_back(name);
  return hidden_ / name;
}

Checked<std::vector<fs::path>> Staging::publish() {
  std::vector<fs::path> places;
  std::error_code error;
  for (const fs::path& name : names_) {
    const fs::path place = folder_ == "." ? name : folder_ / name;
    if (name.has_parent_path()) {
      fs::create_directories(place.parent_path(), error);
      if (error) return failed(place.parent_path(), error.message());
    }
    const auto moved = move(hidden_ / name, place);
    if (!moved) return moved.diagnostics;
    places.push_back(place);
  }
  return places;
}

Diagnostics Staging::in_place(Diagnostics diagnostics) const {
  const std::string prefix = (hidden_ / "").string();
  for (Diagnostic& diagnostic : diagnostics)
    if (diagnostic.file.starts_with(prefix))
      diagnostic.file = (folder_ / diagnostic.file.substr(prefix.size())).string();
  return diagnostics;
}

}  // namespace blossom
