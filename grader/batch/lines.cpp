#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

class LineSource : public SubmissionSource {
 public:
  LineSource(Descriptor file, const SourceLimits& limits) : file_(std::move(file)), limits_(limits) {
    struct stat status {};
    if (::fstat(file_, &status) == 0 && S_ISREG(status.st_mode)) size_ = static_cast<std::uint64_t>(status.st_size);
  }

  bool next(Found& found) override {
    std::string_view line;
    bool whole = true;
    do {
      if (!next_line(line, whole)) return false;
    } while (whole && line.find_first_not_of(" \t\r") == std::string_view::npos);
    found = whole ? read_line(line, limits_) : Found{{}, {"", {}, "", too_long(limits_)}};
    if (!found.submission.problem.empty())
      found.submission.problem = "line " + std::to_string(number_) + ": " + found.submission.problem;
    return true;
  }

  std::optional<double> progress() const override {
    if (size_ == 0) return std::nullopt;
    const std::uint64_t done = read_ - (buffer_.size() - at_);
    return std::min(1.0, static_cast<double>(done) / static_cast<double>(size_));
  }

 private:
  // The next line without its end; of one that is too long (`whole` is false then) nothing is kept.
  bool next_line(std::string_view& line, bool& whole) {
    whole = true;
    std::size_t looked_at = at_;
    for (;;) {
      const void* found = std::memchr(buffer_.data() + looked_at, '\n', buffer_.size() - looked_at);
      const bool at_end = found == nullptr && ended_;
      if (at_end && at_ == buffer_.size() && whole) return false;
      if (found != nullptr || at_end) {
        const std::size_t end =
            at_end ? buffer_.size() : static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data());
        line = std::string_view(buffer_).substr(at_, end - at_);
        at_ = std::min(end + 1, buffer_.size());
        ++number_;
        return true;
      }
      if (buffer_.size() - at_ > most_line_bytes(limits_) + 1) {  // a carriage return may stand at its end
        whole = false;
        at_ = buffer_.size();
      }
      looked_at = buffer_.size() - at_;
      if (!fill()) return false;
    }
  }

  // Reads on behind what is not used yet, which moves to the front.
  bool fill() {
    constexpr std::size_t chunk = 64u << 10;
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t before = buffer_.size();
    buffer_.resize(before + chunk);
    ssize_t got = 0;
    do {
      got = ::read(file_, buffer_.data() + before, chunk);
    } while (got < 0 && errno == EINTR);
    const int error = errno;
    buffer_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0) {
      failure_ = "cannot be read on behind line " + std::to_string(number_) + ": " + system_says(error);
      return false;
    }
    ended_ = got == 0;
    read_ += static_cast<std::uint64_t>(got);
    return true;
  }

  Descriptor file_;
  SourceLimits limits_;
  std::string buffer_;
  std::size_t at_ = 0;  // how much of the buffer has been given out
  bool ended_ = false;
  std::uint64_t read_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t number_ = 0;
};

}  // namespace

std::unique_ptr<SubmissionSource> lines_of(Descriptor file, const SourceLimits& limits) {
  return std::make_unique<LineSource>(std::move(file), limits);
}

}  // namespace blossom
