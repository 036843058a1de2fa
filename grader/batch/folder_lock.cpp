#include "grader/batch/folder_lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "grader/batch/output.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr int most_attempts = 1000;

// Whoever finishes removes the lock's file while holding it: somebody who had opened it by then holds a lock on
// nothing.
bool is_still(int fd, const fs::path& file) {
  struct stat mine {};
  struct stat there {};
  return ::fstat(fd, &mine) == 0 && ::stat(file.c_str(), &there) == 0 && mine.st_dev == there.st_dev &&
         mine.st_ino == there.st_ino;
}

bool is_alone(const fs::path& file) {
  std::error_code error;
  for (fs::directory_iterator it(file.parent_path(), error), end; !error && it != end; it.increment(error))
    if (it->path() != file) return false;
  return !error;
}

}  // namespace

// A record lock: processes that are forked while it is held do not hold it, too.
FolderLock::FolderLock(const fs::path& out, const fs::path& work) : out_(out), work_(work), file_(work / "lock") {
  std::error_code error;
  made_out_ = !fs::exists(out, error);
  for (int attempt = 1;; ++attempt) {
    try {
      make_folder(work_);
    } catch (const std::system_error& missing) {
      // Somebody who finished removed a folder after it was found or made (then making it says that it is there, and
      // it is not); but a link to nowhere is missing for ever, and a file in its place stays.
      const bool gone = missing.code() == std::errc::no_such_file_or_directory ||
                        (missing.code() == std::errc::file_exists && !fs::is_regular_file(work_, error));
      if (!gone || attempt == most_attempts) throw;
      continue;
    }
    fd_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (fd_ < 0 && errno == ENOENT && attempt < most_attempts) continue;  // removed since it was made
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), file_.string());
    struct flock lock {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    held_ = ::fcntl(fd_, F_SETLK, &lock) == 0;
    if (!held_ || is_still(fd_, file_)) return;
    ::close(fd_);
  }
}

FolderLock::~FolderLock() {
  if (held_ && is_alone(file_)) {
    // Neither folder goes where somebody else has put a lock of theirs into it meanwhile.
    std::error_code error;
    for (const fs::path& path : {file_, work_}) fs::remove(path, error);
    if (made_out_) fs::remove(out_, error);
  }
  ::close(fd_);
}

void FolderLock::clear_work() const {
  for (const fs::directory_entry& entry : fs::directory_iterator(work_))
    if (entry.path() != file_) fs::remove_all(entry.path());
}

}  // namespace blossom
