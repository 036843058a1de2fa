#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/json.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string get(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string refused(const fs::path& path, const JsonLimits& limits = {}) {
  const auto document = JsonDocument::load(path, limits);
  REQUIRE_FALSE(document);
  REQUIRE(document.diagnostics.size() == 1);
  CHECK(document.diagnostics[0].file == path.string());
  return document.diagnostics[0].message;
}

}  // namespace

TEST_CASE("a file is read, under its name") {
  const Scratch folder;
  put(folder / "a.json", "[1, 2]");
  const auto document = JsonDocument::load(folder / "a.json");
  REQUIRE(document);
  CHECK(document->root().items.size() == 2);
  CHECK(document->name() == folder / "a.json");
  CHECK(document->text() == "[1, 2]");
}

TEST_CASE("hostile: what is no readable file is said, and never waited for") {
  const Scratch folder;
  CHECK(refused(folder / "none.json") == "cannot be read: No such file or directory");
  CHECK(refused(folder / "") == "must be a file, not a folder");
  CHECK(refused("/dev/zero") == "must be a file, not a device; use - for standard input");
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK(refused(folder / "pipe") == "must be a file, not a pipe; use - for standard input");
  fs::create_symlink(folder / "loop", folder / "loop");
  CHECK(refused(folder / "loop") == "cannot be read: Too many levels of symbolic links");
  put(folder / "empty.json", "");
  CHECK(refused(folder / "empty.json") == "the document is empty; expected a value");
}

TEST_CASE("hostile: a file is not read beyond the limit") {
  const Scratch folder;
  put(folder / "exact.json", "[" + std::string(98, ' ') + "]");
  CHECK(JsonDocument::load(folder / "exact.json", {100, 32, 10}));
  put(folder / "more.json", "[" + std::string(99, ' ') + "]");
  CHECK(refused(folder / "more.json", {100, 32, 10}) == "too large; at most 100 bytes");
  put(folder / "sparse.json", "[");
  fs::resize_file(folder / "sparse.json", std::uintmax_t{1} << 36);  // 64 GB that take no room
  CHECK(refused(folder / "sparse.json", submission_limits) == "too large; at most 65536 bytes");
}

TEST_CASE("a file is written whole, keeps its permissions, and leaves nothing beside it") {
  const Scratch folder;
  CHECK(write_file(folder / "new.txt", "one"));
  CHECK(get(folder / "new.txt") == "one");
  const mode_t mask = ::umask(0);
  ::umask(mask);
  struct stat status {};
  REQUIRE(::stat((folder / "new.txt").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == (0666 & ~mask));

  REQUIRE(::chmod((folder / "new.txt").c_str(), 0640) == 0);
  const std::string big(1u << 20, 'x');
  CHECK(write_file(folder / "new.txt", big));
  CHECK(get(folder / "new.txt") == big);
  REQUIRE(::stat((folder / "new.txt").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
  CHECK(folder.count() == 1);

  fs::create_symlink(folder / "new.txt", folder / "link.txt");
  CHECK(write_file(folder / "link.txt", "through"));
  CHECK(fs::is_symlink(folder / "link.txt"));
  CHECK(get(folder / "new.txt") == "through");
}

TEST_CASE("what cannot be written says why, and leaves nothing behind") {
  const Scratch folder;
  const auto refused_writing = [](const fs::path& path) {
    const auto result = write_file(path, "x");
    REQUIRE_FALSE(result);
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].file == path.string());
    return result.diagnostics[0].message;
  };
  CHECK(refused_writing(folder / "none/x.txt") == "cannot be written: No such file or directory");
  fs::create_directory(folder / "sub");
  CHECK(refused_writing(folder / "sub") == "must be a file, not a folder");
  CHECK(refused_writing("/dev/null") == "must be a file, not a device");
  CHECK(refused_writing(folder / std::string(300, 'n').c_str()) == "cannot be written: File name too long");
  CHECK(folder.count() == 1);
}
