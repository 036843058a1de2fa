#pragma once
// Archives (zip; tar, also compressed with gzip, bzip2, xz, zstd) read entry by entry, nothing of them ever written to
// disk, nothing in them followed. Links, devices and names that lead outside are refused and told; so are encrypted
// entries, and names that differ from an earlier one only in case or in the form of their characters (Unicode's
// canonical equivalence), for on half of all machines they would be the same file.
//
// Memory: what libarchive takes, one submission, and 16 to 32 bytes for each entry.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "grader/batch/source.hpp"

namespace blossom {

// Loads what reading takes from files of the system (the locale of UTF-8 names), so that it can be done in a process
// that may open nothing any more, and sets the time zone of the process to UTC, which zip's times are read in.
void prepare_archives();

struct ArchiveSink {
  std::function<bool(Found&&)> found;                         // false: no more is wanted
  std::function<void(std::uint64_t consumed)> progress = {};  // bytes of the archive; now and then
};

// In this very process; what stands before a failure is told all the same. The file must allow seeking.
void read_archive(int file, const SourceLimits&, const ArchiveSink&, std::string& failure);
void read_archive(std::string_view bytes, const SourceLimits&, const ArchiveSink&, std::string& failure);

// What is wrong with the name of an entry, or nothing; without "." and doubled slashes, it comes back in `path`.
std::string problem_of_name(std::string_view name, const SourceLimits&, std::string& path);

// Tells names that were there before, ignoring case and Unicode's form.
class NamesSeen {
 public:
  NamesSeen();
  bool add(std::string_view name);  // false: it was there

 private:
  void grow();

  std::uint64_t key_[2];              // of the hash: drawn anew each time, so that nobody can make a name collide
  std::vector<std::uint64_t> slots_;  // open addressing; 0: free
  std::size_t count_ = 0;
};

// SipHash-2-4 (Aumasson and Bernstein, 2012).
std::uint64_t sip_hash(const std::uint64_t (&key)[2], std::string_view bytes);

}  // namespace blossom
