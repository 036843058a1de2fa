#include "lesson/catalog.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;
namespace fs = std::filesystem;

namespace {

std::string lesson(const std::string& id) {
  return R"({"schema": "blossom.lesson/1", "id": ")" + id + R"(", "title": "T", "algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"}, "beats": [{"at": "C", "say": "{C}"}]})";
}

}  // namespace

TEST_CASE("a catalog has the lessons of a folder in the order of their file names") {
  const Scratch folder;
  folder.write("10-c.json", lesson("c"));
  folder.write("02-b.json", lesson("b"));
  folder.write("01-a.json", lesson("a"));
  folder.write("notes.txt", "no lesson");
  folder.write("lesson.schema.json", "{}");
  folder.write("curve.json", R"({"degree": 1, "points": [[0, 0], [1, 1]]})");
  fs::create_directory(folder / "more");
  const auto catalog = load_catalog(folder.path());
  CHECK(to_string(catalog.diagnostics).empty());
  std::vector<std::string> found;
  for (const auto& entry : catalog.lessons) found.push_back(entry.file.filename().string() + " " + entry.lesson.id);
  CHECK(found == std::vector<std::string>{"01-a.json a", "02-b.json b", "10-c.json c"});
  REQUIRE(catalog.find("b") != nullptr);
  CHECK(catalog.find("b")->file == folder / "02-b.json");
  CHECK(catalog.find("d") == nullptr);
}

TEST_CASE("broken lessons are named, and the others are there all the same") {
  const Scratch folder;
  folder.write("1.json", lesson("a"));
  folder.write("2.json", lesson("a"));
  folder.write("3.json", "{\"beats\": [");
  folder.write("4.json", "{}");
  folder.write("5.json", lesson("b"));
  const auto catalog = load_catalog(folder.path());
  REQUIRE(catalog.lessons.size() == 2);
  CHECK(catalog.lessons[1].lesson.id == "b");
  std::vector<std::string> files;
  for (const auto& diagnostic : catalog.diagnostics) {
    const std::string file = fs::path(diagnostic.file).filename().string();
    if (files.empty() || files.back() != file) files.push_back(file);
  }
  CHECK(files == std::vector<std::string>{"2.json", "3.json", "4.json"});
  CHECK(to_string(catalog.diagnostics[0]) ==
        (folder / "2.json") + ":1:38: id: \"a\" is the id of " + (folder / "1.json") + " already");
}

TEST_CASE("a folder that is not there") {
  const auto catalog = load_catalog("/nowhere/at/all");
  CHECK(catalog.lessons.empty());
  REQUIRE(catalog.diagnostics.size() == 1);
  CHECK(to_string(catalog.diagnostics[0]) == "/nowhere/at/all: cannot read this folder: No such file or directory");
}
