#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>

#include "base/diagnostics.hpp"
#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

// The names in a folder, sorted by their bytes: one text and 8 bytes for each, some 20 MB for a million.
class Names {
 public:
  // Reads at most so many. False: see errno.
  bool read(int folder, std::size_t most) {
    const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* stream = again < 0 ? nullptr : ::fdopendir(again);
    if (stream == nullptr) {
      const int error = errno;
      if (again >= 0) ::close(again);
      errno = error;
      return false;
    }
    errno = 0;
    while (const dirent* entry = ::readdir(stream)) {
      const std::string_view name = entry->d_name;
      if (name == "." || name == ".." || is_litter(name)) continue;
      if (begins_.size() == most) {
        is_whole_ = false;
        break;
      }
      begins_.push_back(all_.size());
      all_.append(name).push_back('\0');
    }
    const int error = errno;
    ::closedir(stream);
    errno = error;
    std::ranges::sort(begins_, {}, [this](std::size_t begin) { return std::string_view(all_.data() + begin); });
    return error == 0;
  }

  std::size_t size() const { return begins_.size(); }
  const char* operator[](std::size_t i) const { return all_.data() + begins_[i]; }
  bool is_whole() const { return is_whole_; }

 private:
  std::string all_;
  std::vector<std::size_t> begins_;
  bool is_whole_ = true;
};

std::string kind_of(mode_t mode) {
  if (S_ISLNK(mode)) return "a symbolic link";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

// Each folder is opened inside the one it is in, by its own name, and never through a link: whatever is renamed
// meanwhile, nothing outside is reached.
class FolderSource : public SubmissionSource {
 public:
  FolderSource(Descriptor folder, const SourceLimits& limits) : limits_(limits) { enter(std::move(folder), ""); }

  bool next(Found& found) override {
    while (!open_.empty() && failure_.empty()) {
      Level& level = open_.back();
      if (level.at == level.names.size()) {
        open_.pop_back();
        continue;
      }
      const char* name = level.names[level.at++];
      if (look(level, name, found)) return true;
    }
    return false;
  }

  std::optional<double> progress() const override {
    if (open_.empty()) return 1.0;
    const Level& top = open_.front();
    return top.names.size() == 0 ? 1.0 : static_cast<double>(top.at) / static_cast<double>(top.names.size());
  }

 private:
  struct Level {
    Descriptor folder;
    std::string path;  // "s17/deeper/", printable
    Names names;
    std::size_t at = 0;
  };

  // False, with errno, if it cannot be read.
  bool enter(Descriptor folder, std::string path) {
    Level level{std::move(folder), std::move(path), {}, 0};
    const bool read = level.names.read(level.folder, limits_.entries - entries_);
    const int error = errno;
    entries_ += level.names.size();
    if (!level.names.is_whole())
      failure_ = "more than " + std::to_string(limits_.entries) + " entries; nothing of " +
                 (level.path.empty() ? "the folder" : excerpt(level.path)) + " and what follows was read";
    else if (!read && open_.empty())
      failure_ = "cannot be read: " + system_says(error);
    else
      open_.push_back(std::move(level));
    errno = error;
    return read;
  }

  // One entry; true if it is to be told of.
  bool look(Level& level, const char* name, Found& found) {
    const std::string path = level.path + printable(name);
    found = {};
    found.submission.source = path;
    struct stat status {};
    if (::fstatat(level.folder, name, &status, AT_SYMLINK_NOFOLLOW) != 0)
      return errno != ENOENT && unreadable(path, errno, found);  // removed meanwhile: as though it had not been there
    const bool is_folder = S_ISDIR(status.st_mode);
    if (*name == '.') return refuse(std::string(hidden_name), found);
    if (!is_folder && !S_ISREG(status.st_mode)) return refuse("not read: " + kind_of(status.st_mode), found);
    if (!is_folder && !is_json_name(name)) return refuse(std::string(no_json_name), found);
    if (is_folder && static_cast<int>(open_.size()) > limits_.depth) return refuse(too_deep(limits_), found);

    // It may be something else by now: so nothing is followed, nothing waited for, and it is looked at again.
    Descriptor file(::openat(level.folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file < 0 || ::fstat(file, &status) != 0) return unreadable(path, errno, found);
    if (is_folder != S_ISDIR(status.st_mode) || (!is_folder && !S_ISREG(status.st_mode)))
      return refuse("not read: it was exchanged for something else meanwhile", found);
    if (is_folder) return !enter(std::move(file), path + "/") && failure_.empty() && unreadable(path, errno, found);

    found.keys = keys_of(path);
    found.submission.submitted = time_of(status.st_mtim.tv_sec);
    return read(file, static_cast<std::size_t>(status.st_size), path, found);
  }

  // Up to one byte more than allowed, so that one sees that it is too much.
  bool read(const Descriptor& file, std::size_t size_told, const std::string& path, Found& found) {
    std::string& text = found.submission.text;
    text.resize(std::min(limits_.submission_bytes, size_told) + 1);
    std::size_t size = 0;
    while (size <= limits_.submission_bytes) {
      if (size == text.size()) text.resize(limits_.submission_bytes + 1);  // it has grown
      const ssize_t got = ::read(file, text.data() + size, text.size() - size);
      if (got < 0 && errno != EINTR) return unreadable(path, errno, found);
      if (got == 0) break;
      size += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    text.resize(size);
    if (size > limits_.submission_bytes) {
      text.clear();
      found.submission.problem = too_large(limits_);
    }
    return true;
  }

  static bool refuse(std::string why, Found& found) {
    found.keys = keys_of(found.submission.source);
    found.refused = true;
    found.submission.problem = std::move(why);
    return true;
  }
  static bool unreadable(const std::string& path, int error, Found& found) {
    found.keys = keys_of(path);
    found.submission.text.clear();
    found.submission.problem = "cannot be read: " + system_says(error);
    return true;
  }

  SourceLimits limits_;
  std::vector<Level> open_;
  std::size_t entries_ = 0;
};

}  // namespace

std::unique_ptr<SubmissionSource> folder_of(Descriptor folder, const SourceLimits& limits) {
  return std::make_unique<FolderSource>(std::move(folder), limits);
}

}  // namespace blossom
