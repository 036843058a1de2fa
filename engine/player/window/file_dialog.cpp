#include "player/window/file_dialog.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

extern char** environ;

namespace blossom {

namespace fs = std::filesystem;

namespace {

std::optional<fs::path> on_path(const char* program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / program;
    if (!folder.empty() && access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

std::vector<std::string> command(bool to_save, const fs::path& suggested) {
  if (const auto zenity = on_path("zenity")) {
    std::vector<std::string> words{*zenity, "--file-selection", "--title=Blossom", "--filename=" + suggested.string()};
    if (to_save) {
      words.insert(words.end(), {"--save", "--confirm-overwrite"});
    } else {
      words.insert(words.end(), {"--file-filter=Lessons and exercises | *.json", "--file-filter=All files | *"});
    }
    return words;
  }
  if (const auto kdialog = on_path("kdialog"))
    return {*kdialog, to_save ? "--getsavefilename" : "--getopenfilename", suggested.string()};
  return {};
}

}  // namespace

std::unique_ptr<FileDialog> FileDialog::open(bool to_save, const fs::path& suggested) {
  auto words = command(to_save, suggested);
  int ends[2];
  if (words.empty() || pipe2(ends, O_CLOEXEC) != 0) return nullptr;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  pid_t process = -1;
  const int failed = posix_spawn(&process, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) {
    close(ends[0]);
    return nullptr;
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  std::unique_ptr<FileDialog> dialog(new FileDialog);
  dialog->process_ = process;
  dialog->output_ = ends[0];
  return dialog;
}

FileDialog::~FileDialog() {
  if (output_ >= 0) close(output_);
  if (process_ > 0) {
    kill(process_, SIGKILL);  // it has nothing to keep, and the window is not to wait for it
    waitpid(process_, nullptr, 0);
  }
}

std::optional<fs::path> FileDialog::poll() {
  std::array<char, 4096> part{};
  ssize_t count = 0;
  while ((count = read(output_, part.data(), part.size())) > 0)
    answer_.append(part.data(), static_cast<std::size_t>(count));
  if (count < 0) return std::nullopt;  // nothing yet
  if (waitpid(process_, nullptr, WNOHANG) == process_) process_ = -1;
  while (!answer_.empty() && answer_.back() == '\n') answer_.pop_back();
  return fs::path(answer_);
}

}  // namespace blossom
