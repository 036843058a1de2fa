#pragma once
// Held while a run works in a folder of results; released by the system when the process ends, however it ends.

#include <filesystem>

namespace blossom {

class FolderLock {
 public:
  // Makes the folder of results, and the folder of work in it, if there is none. Throws std::system_error.
  FolderLock(const std::filesystem::path& out, const std::filesystem::path& work);
  // What was made and has stayed empty is removed again.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  bool held() const { return held_; }

  // Everything in the folder of work but the lock, which goes last.
  void clear_work() const;

 private:
  std::filesystem::path out_, work_, file_;
  bool made_out_ = false;
  int fd_ = -1;
  bool held_ = false;
};

}  // namespace blossom
