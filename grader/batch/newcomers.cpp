#include "grader/batch/newcomers.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace blossom {
namespace {

constexpr std::size_t buffered = 64u << 10;

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

int open_or_fail(const std::filesystem::path& file, int flags) {
  const int fd = ::open(file.c_str(), flags | O_CLOEXEC, 0600);
  if (fd < 0) fail(file.string());
  return fd;
}

}  // namespace

void Newcomers::Appended::append(std::string_view bytes) {
  pending += bytes;
  if (pending.size() >= buffered) flush();
}

void Newcomers::Appended::flush() {
  std::string_view left = pending;
  while (!left.empty()) {
    const ssize_t n = ::write(fd, left.data(), left.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("the list of students cannot be written");
    left.remove_prefix(static_cast<std::size_t>(n));
  }
  written += pending.size();
  pending.clear();
}

std::string Newcomers::Appended::read(std::uint64_t at, std::uint64_t size) const {
  if (at >= written) return pending.substr(at - written, size);
  std::string bytes(size, '\0');
  const ssize_t n = ::pread(fd, bytes.data(), size, static_cast<off_t>(at));
  if (n < 0) fail("the list of students cannot be read");
  if (static_cast<std::uint64_t>(n) != size) throw std::runtime_error("the list of students ends too early");
  return bytes;
}

Newcomers::Newcomers(const std::filesystem::path& file, int flags) {
  names_.fd = open_or_fail(file, flags);
  ends_.fd = open_or_fail(file.string() + ".ends", flags);
}

Newcomers::Newcomers(Newcomers&& other) noexcept
    : names_(std::move(other.names_)),
      ends_(std::move(other.ends_)),
      size_(other.size_),
      slots_(std::move(other.slots_)) {
  other.names_.fd = other.ends_.fd = -1;
}

Newcomers::~Newcomers() {
  for (const int fd : {names_.fd, ends_.fd})
    if (fd >= 0) ::close(fd);
}

Newcomers Newcomers::begin(const std::filesystem::path& file) {
  Newcomers newcomers(file, O_RDWR | O_CREAT | O_TRUNC);
  newcomers.slots_.resize(1024);
  return newcomers;
}

Newcomers Newcomers::open(const std::filesystem::path& file) {
  Newcomers newcomers(file, O_RDONLY);
  const auto size_of = [](Appended& appended) {
    struct stat status {};
    if (::fstat(appended.fd, &status) != 0) fail("the list of students cannot be read");
    appended.written = static_cast<std::uint64_t>(status.st_size);
    return appended.written;
  };
  size_of(newcomers.names_);
  newcomers.size_ = size_of(newcomers.ends_) / sizeof(std::uint64_t);
  return newcomers;
}

std::uint64_t Newcomers::end(std::uint64_t index) const {
  std::uint64_t end = 0;
  std::memcpy(&end, ends_.read(index * sizeof end, sizeof end).data(), sizeof end);
  return end;
}

std::string Newcomers::id(std::uint64_t index) const {
  const std::uint64_t begin = index == 0 ? 0 : end(index - 1);
  return names_.read(begin, end(index) - begin);
}

std::uint64_t Newcomers::index_of(std::string_view id) {
  const std::uint64_t hash = std::hash<std::string_view>()(id);
  const auto tag = static_cast<std::uint32_t>(hash >> 32);
  std::size_t at = hash & (slots_.size() - 1);
  for (; slots_[at].number != 0; at = (at + 1) & (slots_.size() - 1))
    if (slots_[at].tag == tag && this->id(slots_[at].number - 1) == id) return slots_[at].number - 1;
  if (size_ + 1 == std::numeric_limits<std::uint32_t>::max()) throw std::length_error("too many students");
  slots_[at] = {tag, static_cast<std::uint32_t>(++size_)};
  names_.append(id);
  const std::uint64_t end = names_.written + names_.pending.size();
  ends_.append({reinterpret_cast<const char*>(&end), sizeof end});
  if (4 * size_ > 3 * slots_.size()) grow();
  return size_ - 1;
}

// The names are read again for their hashes: memory for those would be as much as for the slots.
void Newcomers::grow() {
  const std::size_t size = 2 * slots_.size();
  slots_ = {};
  slots_.resize(size);
  for (std::uint64_t i = 0; i < size_; ++i) {
    const std::uint64_t hash = std::hash<std::string_view>()(id(i));
    std::size_t at = hash & (slots_.size() - 1);
    while (slots_[at].number != 0) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = {static_cast<std::uint32_t>(hash >> 32), static_cast<std::uint32_t>(i + 1)};
  }
}

void Newcomers::finish() {
  names_.flush();
  ends_.flush();
  slots_ = {};
}

}  // namespace blossom
