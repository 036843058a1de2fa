#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <limits>
#include <system_error>

#include "base/json.hpp"
#include "base/text_file.hpp"
#include "base/utf8.hpp"

namespace blossom {
namespace {

// An open file, closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ > STDIN_FILENO) ::close(fd_);
  }
  operator int() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

std::string system_says(int error) { return std::generic_category().message(error); }

Diagnostics problem(const std::string& file, std::string message) { return {{file, 0, 0, "", std::move(message)}}; }

std::string kind_of(const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "a folder";
  if (S_ISFIFO(status.st_mode)) return "a pipe";
  if (S_ISSOCK(status.st_mode)) return "a socket";
  return "a device";
}

// Up to `most` + 1 bytes: one more than allowed, so that the reader can see that it is too much. False: see errno.
bool read_all(int fd, std::size_t most, std::string& text) {
  constexpr std::size_t chunk = 64u << 10;
  while (text.size() <= most) {
    const std::size_t before = text.size();
    const std::size_t wanted = std::min(chunk, most + 1 - before);
    text.resize(before + wanted);
    const ssize_t got = ::read(fd, text.data() + before, wanted);
    text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return true;
    if (got < 0 && errno != EINTR) return false;
  }
  return true;
}

bool write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t put = ::write(fd, content.data(), content.size());
    if (put < 0 && errno != EINTR) return false;
    content.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(put, 0)));
  }
  return true;
}

// \uXXXX of a control character, which has at most 16 bits.
void append_escape(std::string_view character, std::string& out) {
  constexpr char digits[] = "0123456789abcdef";
  const auto bits = [&](std::size_t at) { return static_cast<unsigned>(character[at]) & 0x3Fu; };
  unsigned code = static_cast<unsigned char>(character[0]);
  if (character.size() == 2) code = (code & 0x1Fu) << 6 | bits(1);
  if (character.size() == 3) code = (code & 0x0Fu) << 12 | bits(1) << 6 | bits(2);
  out += "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) out += digits[code >> shift & 0xFu];
}

}  // namespace

std::string file_title(const std::filesystem::path& path) { return path == "-" ? "standard input" : path.string(); }

Checked<std::string> read_text(const std::filesystem::path& path, std::size_t most) {
  const bool standard_input = path == "-";
  const std::string name = file_title(path);
  // Without O_NONBLOCK opening a pipe would wait for a writer, perhaps for ever.
  const Descriptor fd(standard_input ? STDIN_FILENO
                                     : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (fd < 0) return problem(name, "cannot be read: " + system_says(errno));

  struct stat status {};
  if (!standard_input) {
    if (::fstat(fd, &status) != 0) return problem(name, "cannot be read: " + system_says(errno));
    if (!S_ISREG(status.st_mode))
      return problem(name, "must be a file, not " + kind_of(status) +
                               (S_ISDIR(status.st_mode) ? "" : "; use - for standard input"));
  }
  std::string text;
  if (!read_all(fd, most, text)) return problem(name, "cannot be read: " + system_says(errno));
  return text;
}

Checked<JsonDocument> JsonDocument::load(const std::filesystem::path& path, const JsonLimits& limits) {
  auto text = read_text(path, std::min<std::size_t>(limits.bytes, std::numeric_limits<std::uint32_t>::max()));
  if (!text) return text.diagnostics;
  return parse(file_title(path), std::move(*text), limits);
}

Checked<bool> write_file(const std::filesystem::path& path, std::string_view content, unsigned mode) {
  // Through a symbolic link the file it points to is replaced, not the link.
  std::error_code unresolved;
  const std::filesystem::path resolved = std::filesystem::canonical(path, unresolved);
  const std::filesystem::path target = unresolved ? path : resolved;
  const auto failed = [&](int error) { return problem(path.string(), "cannot be written: " + system_says(error)); };

  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) return problem(path.string(), "must be a file, not " + kind_of(status));

  static std::atomic<unsigned> count{0};
  const std::string name = ".blossom-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp";
  const std::filesystem::path temporary = target.parent_path() / name;
  Descriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (fd < 0) return failed(errno);
  const bool written = write_all(fd, content) && (!exists || ::fchmod(fd, status.st_mode & 07777) == 0) && fd.close() &&
                       ::rename(temporary.c_str(), target.c_str()) == 0;
  if (written) return true;
  const int error = errno;
  ::unlink(temporary.c_str());
  return failed(error);
}

std::string json_quote(std::string_view text) {
  std::string out = "\"";
  out.reserve(text.size() + 2);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view character = text.substr(i, length);
    if (length == 0)
      out += "\xEF\xBF\xBD";  // U+FFFD
    else if (character == "\"" || character == "\\")
      (out += '\\') += character;
    else if (character == "\n")
      out += "\\n";
    else if (character == "\r")
      out += "\\r";
    else if (character == "\t")
      out += "\\t";
    else if (is_control(character))  // JSON asks for those below U+0020 only; a terminal obeys others, too
      append_escape(character, out);
    else
      out += character;
    i += std::max<std::size_t>(length, 1);
  }
  return out += '"';
}

}  // namespace blossom
