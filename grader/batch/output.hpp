#pragma once
// Files of the folder of results. Each is written inside .work first and renamed to its place, so that a run that is
// killed leaves nothing half written and nothing to be cleared away.

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace blossom {

// All throw std::system_error when the machine is at fault.
void place_file(const std::filesystem::path& work, const std::filesystem::path& target, std::string_view content);
void make_folder(const std::filesystem::path&);
void move_file(const std::filesystem::path& from, const std::filesystem::path& to);

// A file that is appended to, of any size.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path&);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  void write(std::string_view);
  void close();

 private:
  std::filesystem::path path_;
  std::FILE* file_;
};

}  // namespace blossom
