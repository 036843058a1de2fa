#pragma once
// Submissions put in the order of the class without holding them: records are appended to part files, each for a range
// of students, and a part is read back sorted. Memory stays below 8 MiB while writing, whatever there is to write, and
// costs 8 bytes for each record of the one part that is read.
//
//   000.part ... 255.part   a record is: student u64, length u32 (little-endian), then its bytes
//   complete                written last, renamed into place: of each part its size, its records and its digest
//
// A spool without `complete` was interrupted and is begun again. Parts that are not as `complete` says (torn, foreign,
// changed) are told, never trusted.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

inline constexpr std::size_t most_spool_parts = 256;
inline constexpr std::uint64_t most_spool_part_size = 1u << 24;  // students
inline constexpr std::uint64_t most_spool_part_bytes = 1ull << 40;
inline constexpr std::uint32_t most_spool_record_bytes = 64u << 20;

// What is known of a part.
struct SpoolPart {
  std::uint64_t bytes = 0;
  std::uint64_t records = 0;
  std::uint64_t digest = 0;  // of its bytes (FNV-1a over whole records: against accidents, not against forgery)
  friend bool operator==(const SpoolPart&, const SpoolPart&) = default;
};

class Spool {
 public:
  // Begins anew in this folder, which is made if need be; what an earlier spool left in it is removed. Student s goes
  // to part s / part_size. Throws std::system_error, here and below, when the disk is full or the folder can't be
  // written.
  Spool(std::filesystem::path folder, std::uint64_t part_size);

  // Throws std::length_error beyond the limits above.
  void add(std::uint64_t student, std::string_view record);
  // All is on the disk, and says so. Nothing is added afterwards.
  void finish();

 private:
  void flush(std::size_t part);

  std::filesystem::path folder_;
  std::uint64_t part_size_;
  std::array<SpoolPart, most_spool_parts> parts_{};
  std::array<std::string, most_spool_parts> buffers_{};
};

class Descriptor;

class SpoolReader {
 public:
  // Nothing when there is no spool that was finished.
  static std::optional<SpoolReader> open(const std::filesystem::path& folder);

  std::uint64_t part_size() const { return part_size_; }
  std::size_t parts() const { return parts_.size(); }  // up to the last that has records; those between may be empty
  std::uint64_t records(std::size_t part) const { return parts_[part].records; }
  std::uint64_t records() const;

  // The records of a part one by one: by student, and each student's as they were added.
  class Walk {
   public:
    // False at the end, and when the part cannot be read any more: then `failure` says why.
    bool next(std::uint64_t& student, std::string& record);
    const std::string& failure() const { return failure_; }

   private:
    friend class SpoolReader;
    std::shared_ptr<const Descriptor> file_;
    std::vector<std::uint64_t> order_;
    std::size_t at_ = 0;
    std::uint64_t first_ = 0;  // student of the part
    std::string failure_;
  };
  // A part that is not as it was finished is a diagnostic.
  Checked<Walk> walk(std::size_t part) const;

  using Visit = std::function<void(std::uint64_t student, std::string_view record)>;
  // All records of a part: by student, and each student's as they were added. The record is gone after the visit. A
  // part that is not as it was finished is a diagnostic, before anything is visited.
  Checked<bool> read(std::size_t part, const Visit&) const;

 private:
  std::filesystem::path folder_;
  std::uint64_t part_size_ = 0;
  std::vector<SpoolPart> parts_;
};

}  // namespace blossom
