#pragma once
// A class without a roster: everybody who hands in is a student, in the order in which they first did. The names stay
// on the disk; memory holds 11 to 22 bytes for each.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

class Newcomers {
 public:
  // Begins anew in two files, FILE and FILE.ends, or opens what was finished. Throws std::system_error like all here.
  static Newcomers begin(const std::filesystem::path& file);
  static Newcomers open(const std::filesystem::path& file);
  Newcomers(Newcomers&&) noexcept;
  Newcomers& operator=(Newcomers&&) = delete;
  ~Newcomers();

  std::uint64_t size() const { return size_; }
  std::uint64_t index_of(std::string_view id);  // adds who is new
  std::string id(std::uint64_t index) const;
  void finish();  // all is on the disk; nobody is added afterwards

 private:
  struct Slot {
    std::uint32_t tag = 0;
    std::uint32_t number = 0;  // index + 1; 0: free
  };
  // A file that is appended to, and read anywhere.
  struct Appended {
    int fd = -1;
    std::uint64_t written = 0;
    std::string pending;
    void append(std::string_view bytes);
    void flush();
    std::string read(std::uint64_t at, std::uint64_t size) const;
  };
  Newcomers(const std::filesystem::path& file, int flags);
  void grow();
  std::uint64_t end(std::uint64_t index) const;

  Appended names_;
  Appended ends_;
  std::uint64_t size_ = 0;
  std::vector<Slot> slots_;
};

}  // namespace blossom
