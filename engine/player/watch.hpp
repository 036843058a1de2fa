#pragma once
// Tells when a file was changed on disk, also when an editor replaces it by renaming. Polled: its times, size and inode
// are looked at, and the bytes only when one of those changed, so that touching a file is no change. A change is told
// when the file has been quiet for one poll, not half-written. Until a file is two seconds old its bytes are looked at
// in any case: two writings within one tick of the file system's clock leave the same time.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace blossom {

class FileWatch {
 public:
  FileWatch() = default;
  explicit FileWatch(std::filesystem::path file);
  bool poll();  // true: its bytes are other ones than at the last true (or the start); a missing file is no change
  // Once, after the poll that finds it missing a second time: an editor that replaces it is done by then.
  bool has_gone() const { return missing_ == 2 && bytes_hash_.has_value(); }

 private:
  struct Stamp {
    std::int64_t modified = 0, changed = 0;  // nanoseconds since 1970
    std::uint64_t size = 0, inode = 0;
    bool operator==(const Stamp&) const = default;
    bool young() const;
  };
  static std::optional<Stamp> stamp_of(const std::filesystem::path&);
  static std::optional<std::size_t> hash_of(const std::filesystem::path&);

  std::filesystem::path file_;
  Stamp stamp_;
  std::optional<std::size_t> bytes_hash_;  // nothing: there was no file
  bool settling_ = false;                  // its bytes are to be looked at
  int missing_ = 0;                        // for so many polls, as far as that matters
};

}  // namespace blossom
