#include "player/watch.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <string_view>

#include "base/json.hpp"

namespace blossom {
namespace {

// More is no file of ours: no reader takes it.
constexpr std::size_t most_bytes = JsonLimits().bytes + 1;

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

}  // namespace

FileWatch::FileWatch(std::filesystem::path file) : file_(std::move(file)) {
  const auto stamp = stamp_of(file_);
  if (!stamp) return;
  stamp_ = *stamp;
  bytes_hash_ = hash_of(file_);
  settling_ = stamp_.young();
}

bool FileWatch::Stamp::young() const {
  using namespace std::chrono;
  const std::int64_t now = duration_cast<std::chrono::nanoseconds>(system_clock::now().time_since_epoch()).count();
  const std::int64_t age = now - changed;
  // The clock of a file server may be ahead; a file from the far future is not young.
  return -2'000'000'000 < age && age < 2'000'000'000;
}

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::filesystem::path& file) {
  struct stat status {};
  if (file.empty() || ::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Stamp{nanoseconds(status.st_mtim), nanoseconds(status.st_ctim), static_cast<std::uint64_t>(status.st_size),
               static_cast<std::uint64_t>(status.st_ino)};
}

std::optional<std::size_t> FileWatch::hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::string bytes, chunk(64u << 10, '\0');
  while (bytes.size() < most_bytes &&
         (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), in.gcount() > 0))
    bytes.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) return std::nullopt;
  return std::hash<std::string_view>()(bytes);
}

bool FileWatch::poll() {
  const auto now = stamp_of(file_);
  if (!now) {
    stamp_ = {};  // it will be another one when it is there again
    missing_ = std::min(missing_ + 1, 3);
    return false;
  }
  missing_ = 0;
  if (*now != stamp_) {
    stamp_ = *now;
    settling_ = true;
    return false;
  }
  if (!settling_) return false;
  const auto hash = hash_of(file_);
  if (stamp_of(file_) != now) return false;  // it was written to while it was read; the next poll sees that
  settling_ = now->young();
  if (!hash || hash == bytes_hash_) return false;
  bytes_hash_ = hash;
  return true;
}

}  // namespace blossom
