#pragma once
// The system's dialog for choosing a file: zenity or kdialog, whichever is installed, as a program of its own, so that
// the window goes on living beside it.

#include <filesystem>
#include <memory>
#include <optional>

namespace blossom {

class FileDialog {
 public:
  // Nothing when the system has none.
  static std::unique_ptr<FileDialog> open(bool to_save, const std::filesystem::path& suggested);
  ~FileDialog();  // closes it
  FileDialog(const FileDialog&) = delete;

  // The answer, once there is one: an empty path when it was cancelled.
  std::optional<std::filesystem::path> poll();

 private:
  FileDialog() = default;
  int process_ = -1, output_ = -1;
  std::string answer_;
};

}  // namespace blossom
