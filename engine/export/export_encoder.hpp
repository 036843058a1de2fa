#pragma once
// The program ffmpeg as a process that takes pictures.

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

// Where the program is; or what is missing, how it is installed and what there is instead.
Checked<std::filesystem::path> find_ffmpeg();

// Writes what it is given to the standard input of ffmpeg from a thread of its own, so that one picture is encoded
// while the next is drawn. Few pictures wait; whoever brings more waits, too.
class Encoder {
 public:
  // Asked while something takes time; false: stop.
  using GoOn = std::function<bool()>;

  // The arguments without the program's name; `log` is a file for what it says.
  static Checked<std::unique_ptr<Encoder>> start(const std::vector<std::string>& arguments,
                                                 const std::filesystem::path& log);
  ~Encoder();  // ends the program if it still runs
  Encoder(const Encoder&) = delete;

  // False: the program takes no more, or one is to stop; finish says why.
  bool put(std::vector<std::uint8_t> pixels, const GoOn&);
  // Waits until all is encoded. Diagnostics: what the program said. False: stopped.
  Checked<bool> finish(const GoOn&);

 private:
  Encoder(int pid, int pipe, std::filesystem::path log);
  void feed();
  void close_queue();

  int pid_, pipe_;
  std::filesystem::path log_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::vector<std::uint8_t>> waiting_;
  bool closed_ = false, broken_ = false, drop_ = false;
  std::thread feeder_;
};

}  // namespace blossom
