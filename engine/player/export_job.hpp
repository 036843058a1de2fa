#pragma once
// A lesson that is being exported by another process, so that the window never waits: its progress, its end, and how to
// stop it. What is half written when it is stopped goes.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

class ExportJob {
 public:
  // Starts `program` with these arguments. A file of `scratch` (may be empty) is removed at the end.
  ExportJob(const std::filesystem::path& program, std::vector<std::string> arguments, std::filesystem::path out,
            std::filesystem::path scratch);
  ~ExportJob();  // stops it
  ExportJob(ExportJob&&) noexcept;
  ExportJob& operator=(ExportJob&&) = delete;

  // Reads what the process has said. True if something is new.
  bool poll();
  void wait();  // until it has ended
  void stop();

  bool running() const { return process_ > 0; }
  bool stopped() const { return stopped_; }
  std::size_t done() const { return done_; }
  std::size_t of() const { return of_; }  // 0: not known yet
  const std::filesystem::path& out() const { return out_; }
  // At its end: what went wrong; empty: it is written.
  const Diagnostics& wrong() const { return wrong_; }
  const std::vector<std::string>& notes() const { return notes_; }  // what else it said

 private:
  bool read_from(int& pipe, std::string& text);
  void take_line(const std::string&);
  void finish(int status);

  pid_t process_ = 0;
  int said_ = -1, complained_ = -1;
  std::string said_text_, complaints_;
  std::filesystem::path out_, scratch_;
  std::size_t done_ = 0, of_ = 0;
  bool stopped_ = false;
  Diagnostics wrong_;
  std::vector<std::string> notes_;
};

}  // namespace blossom
