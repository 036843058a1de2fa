#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "base/diagnostics.hpp"
#include "grader/batch/archive.hpp"
#include "grader/batch/bytes.hpp"
#include "grader/batch/sandbox.hpp"
#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

constexpr std::size_t memory_bytes = 256u << 20;   // for what the formats unpack into, beyond what the program has
constexpr int stalled_ms = 60'000;                 // progress is told every few megabytes
constexpr std::size_t frame_overhead = 16u << 10;  // beyond the text of a submission: its name, its problem

// What the process tells: frames of a length (u32), a letter and what belongs to it.
enum class Frame : char { open = 'o', found = 'f', progress = 'p', end = 'e' };

class FrameWriter {
 public:
  explicit FrameWriter(int pipe) : pipe_(pipe) {}

  template <class Fill>
  void write(Frame kind, Fill&& fill) {
    std::string payload(1, static_cast<char>(kind));
    fill(ByteWriter(payload));
    ByteWriter(buffer_).number(static_cast<std::uint32_t>(payload.size()));
    buffer_ += payload;
    if (buffer_.size() >= 64u << 10 || kind != Frame::found) flush();
  }

 private:
  void flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
      const ssize_t put = ::write(pipe_, rest.data(), rest.size());
      if (put < 0 && errno != EINTR) ::_exit(1);  // nobody listens any more
      rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(put, 0)));
    }
    buffer_.clear();
  }

  int pipe_;
  std::string buffer_;
};

void close_all_but(int file, int pipe) {
  ::close(STDIN_FILENO);
  ::close(STDOUT_FILENO);
  const auto low = static_cast<unsigned>(std::min(file, pipe)), high = static_cast<unsigned>(std::max(file, pipe));
  if (low > 3) ::close_range(3, low - 1, 0);
  if (high > low + 1) ::close_range(low + 1, high - 1, 0);
  ::close_range(high + 1, ~0u, 0);
}

[[noreturn]] void unpack(int file, int pipe, const SourceLimits& limits) {
  ::signal(SIGPIPE, SIG_DFL);
  close_all_but(file, pipe);
  prepare_archives();
  FrameWriter out(pipe);
  const std::string open_because = enter_sandbox(memory_bytes);
  out.write(Frame::open, [&](ByteWriter frame) { frame.text(open_because); });
  std::string failure;
  ArchiveSink sink;
  sink.found = [&](Found&& found) {
    out.write(Frame::found, [&](ByteWriter frame) {
      frame.number(static_cast<char>(found.refused ? 1 : 0));
      frame.number(static_cast<char>(found.keys.empty() ? 0 : 1));
      frame.number(found.submission.submitted ? found.submission.submitted->time_since_epoch().count()
                                              : std::int64_t{-1});
      frame.text(found.submission.source);
      frame.text(found.submission.problem);
      frame.text(found.submission.text);
    });
    return true;
  };
  sink.progress = [&](std::uint64_t consumed) {
    out.write(Frame::progress, [&](ByteWriter frame) { frame.number(consumed); });
  };
  try {
    read_archive(file, limits, sink, failure);
  } catch (const std::bad_alloc&) {
    failure = "cannot be read on: it takes more memory than " + std::to_string(memory_bytes >> 20) + " MiB";
  }
  out.write(Frame::end, [&](ByteWriter frame) { frame.text(failure); });
  ::_exit(0);
}

// The process has read what nobody can trust, and so it is not trusted either: whatever it writes comes to no more than
// what an archive could have held.
class ArchiveSource : public SubmissionSource {
 public:
  ArchiveSource(Descriptor file, const SourceLimits& limits) : limits_(limits) {
    struct stat status {};
    if (::fstat(file, &status) == 0) size_ = static_cast<std::uint64_t>(status.st_size);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) {
      failure_ = "cannot be read: " + system_says(errno);
      return;
    }
    pipe_ = Descriptor(ends[0]);
    const Descriptor child_end(ends[1]);
    child_ = ::fork();
    if (child_ == 0) unpack(file, child_end, limits);
    if (child_ < 0) failure_ = "cannot be read: " + system_says(errno);
  }
  ~ArchiveSource() override { stop(true); }
  ArchiveSource(const ArchiveSource&) = delete;
  ArchiveSource& operator=(const ArchiveSource&) = delete;

  bool next(Found& found) override {
    std::string frame;
    while (child_ > 0 && next_frame(frame)) {
      try {
        if (take(frame, found)) return true;
      } catch (const std::runtime_error&) {
        give_up("what unpacks it does not make sense any more");
      }
    }
    return false;
  }

  std::optional<double> progress() const override {
    return size_ == 0 ? std::nullopt
                      : std::optional(std::min(1.0, static_cast<double>(consumed_) / static_cast<double>(size_)));
  }

 private:
  // True for a submission.
  bool take(std::string_view frame, Found& found) {
    ByteReader in(frame.substr(1));
    switch (static_cast<Frame>(frame.front())) {
      case Frame::progress:
        consumed_ = std::max(consumed_, in.number<std::uint64_t>());
        return false;
      case Frame::end:
        failure_ = printable(in.text());
        stop(false);
        return false;
      case Frame::open:
        open_because_ = printable(in.text());
        return false;
      case Frame::found:
        break;
      default:
        throw std::runtime_error("no such frame");
    }
    found = {};
    found.refused = in.number<char>() != 0;
    const bool has_keys = in.number<char>() != 0;
    if (const auto seconds = in.number<std::int64_t>(); seconds >= 0) found.submission.submitted = time_of(seconds);
    found.submission.source = printable(in.text());
    found.submission.problem = printable(in.text());
    found.submission.text = in.text();
    if (found.submission.text.size() > limits_.submission_bytes || !in.at_end() || ++entries_ > limits_.entries)
      throw std::runtime_error("more than there can be");
    if (has_keys) found.keys = keys_of(found.submission.source);
    return true;
  }

  bool next_frame(std::string& frame) {
    std::uint32_t length = 0;
    while (buffer_.size() - at_ < sizeof length)
      if (!fill()) return false;
    std::memcpy(&length, buffer_.data() + at_, sizeof length);
    if (length == 0 || length > limits_.submission_bytes + frame_overhead) {
      give_up("what unpacks it does not make sense any more");
      return false;
    }
    while (buffer_.size() - at_ < sizeof length + length)
      if (!fill()) return false;
    frame.assign(buffer_, at_ + sizeof length, length);
    at_ += sizeof length + length;
    return true;
  }

  bool fill() {
    constexpr std::size_t chunk = 64u << 10;
    buffer_.erase(0, at_);
    at_ = 0;
    pollfd waiting{pipe_, POLLIN, 0};
    int ready = 0;
    do {
      ready = ::poll(&waiting, 1, stalled_ms);
    } while (ready < 0 && errno == EINTR);
    if (ready == 0) {
      give_up("nothing has come for " + std::to_string(stalled_ms / 1000) + " seconds");
      return false;
    }
    const std::size_t before = buffer_.size();
    buffer_.resize(before + chunk);
    ssize_t got = 0;
    do {
      got = ::read(pipe_, buffer_.data() + before, chunk);
    } while (got < 0 && errno == EINTR);
    buffer_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got > 0) return true;
    const int status = stop(false);
    failure_ = "cannot be read on: what unpacks it ";
    if (WIFSIGNALED(status))
      failure_ += "died of signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
    else
      failure_ += "ended too early";
    return false;
  }

  void give_up(std::string why) {
    stop(true);
    failure_ = "cannot be read on: " + std::move(why);
  }

  // Waits for the process to end; its status.
  int stop(bool kill) {
    if (child_ <= 0) return 0;
    if (kill) ::kill(child_, SIGKILL);
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return status;
  }

  SourceLimits limits_;
  Descriptor pipe_;
  pid_t child_ = -1;
  std::string buffer_;
  std::size_t at_ = 0;  // how much of the buffer has been used
  std::size_t entries_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t consumed_ = 0;
};

}  // namespace

std::unique_ptr<SubmissionSource> archive_of(Descriptor file, const SourceLimits& limits) {
  return std::make_unique<ArchiveSource>(std::move(file), limits);
}

}  // namespace blossom
