#include "player/shelf.hpp"

#include "lesson/catalog.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;
namespace fs = std::filesystem;

namespace {

// "01-a.json a"
std::vector<std::string> listed(const Shelf& shelf) {
  std::vector<std::string> found;
  for (const auto& item : shelf.items()) found.push_back(item->file.filename().string() + " " + item->id);
  return found;
}

const ShelfItem& find(const std::vector<std::shared_ptr<const ShelfItem>>& items, const std::string& file) {
  for (const auto& item : items)
    if (item->file.filename() == file) return *item;
  FAIL("there is no " << file);
  std::abort();
}

std::string told_step(const ShelfItem& item) {
  const TraceGraph& graph = item.recording->graph();
  return graph.name(graph.main_value(item.telling_step));
}

std::string lesson(const std::string& id) {
  return R"({"schema": "blossom.lesson/1", "id": ")" + id + R"(", "title": "T", "algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"}, "beats": [{"at": "C", "say": "{C}"}]})";
}

}  // namespace

TEST_CASE("all shipped lessons and exercises are on the shelf, lessons first, by file name") {
  Shelf shelf("./lessons", "exercises/../exercises");
  shelf.wait();
  CHECK(shelf.done());
  CHECK(to_string(shelf.diagnostics()).empty());
  std::vector<fs::path> expected;
  Diagnostics none;
  for (const char* folder : {"lessons", "exercises"})
    for (const fs::path& file : json_files(folder, none)) expected.push_back(fs::absolute(file));
  std::vector<fs::path> found;
  const auto items = shelf.items();
  for (const auto& item : items) {
    found.push_back(item->file);
    CHECK(item->kind ==
          (item->file.parent_path().filename() == "lessons" ? Document::Kind::lesson : Document::Kind::exercise));
    CHECK_FALSE(item->id.empty());
    CHECK_FALSE(item->title.empty());
    CHECK_FALSE(item->summary.empty());
    REQUIRE(item->recording);
    CHECK_FALSE(item->recording->source().exact);
    CHECK(item->telling_step <= item->recording->last());
  }
  CHECK(found == expected);

  const ShelfItem& first = find(items, "11-de-casteljau.json");
  CHECK(first.id == "de-casteljau");
  CHECK(first.minutes > 0);
  CHECK_FALSE(first.unit.empty());
  // The triangle is complete: the last of its points is there.
  CHECK(told_step(first) == "P[3][0]");
  CHECK(told_step(find(items, "22-de-boor.json")) == "P[3][4]");
  CHECK(told_step(find(items, "28-knot-insertion.json")) == "Q[1][5]");
  // A surface is seen at the end.
  const ShelfItem& surface = find(items, "67-skinning.json");
  CHECK(surface.telling_step == surface.recording->last());
}

TEST_CASE("a file with mistakes is named, and the others are shown") {
  const Scratch scratch;
  fs::create_directory(scratch / "more");
  scratch.write("02-b.json", lesson("b"));
  scratch.write("03-cut-off.json", lesson("c").substr(0, 100));
  std::string wrong = lesson("d");
  wrong.replace(wrong.find("\"1/4\""), 5, "\"4\"");
  scratch.write("04-wrong.json", wrong);
  scratch.write("05-a.json", lesson("a"));
  scratch.write("curve.json", R"({"degree": 1, "points": [[0, 0], [1, 1]]})");
  scratch.write("lesson.schema.json", "{}");
  scratch.write("notes.txt", "no lesson");
  Shelf shelf(scratch.path(), "");
  shelf.wait();
  CHECK(listed(shelf) == std::vector<std::string>{"02-b.json b", "05-a.json a"});
  std::vector<std::string> files;
  for (const Diagnostic& diagnostic : shelf.diagnostics()) {
    CHECK(diagnostic.line > 0);
    files.push_back(fs::path(diagnostic.file).filename().string());
  }
  CHECK(files == std::vector<std::string>{"03-cut-off.json", "04-wrong.json"});
}

TEST_CASE("folders that are missing make an empty shelf") {
  Shelf shelf("/nowhere/at/all", "");
  shelf.wait();
  CHECK(shelf.items().empty());
  CHECK(shelf.diagnostics().empty());
}

TEST_CASE("the version grows with what there is to draw") {
  const Scratch scratch;
  for (const char* id : {"a", "b", "c"}) scratch.write(std::string(id) + ".json", lesson(id));
  Shelf shelf(scratch.path(), "");
  std::uint64_t version = 0;
  for (bool done = false; !done; std::this_thread::yield()) {
    done = shelf.done();
    const std::uint64_t before = shelf.version();
    const std::size_t count = shelf.items().size();
    if (before == version) continue;
    CHECK(before > version);
    CHECK(count >= std::min<std::size_t>(version, 3));  // every item that was loaded by then had made it grow
    version = before;
  }
  CHECK(shelf.version() > 3);
  CHECK(shelf.items().size() == 3);
}

TEST_CASE("what was taken from a shelf stays when the shelf is put away, be it still loading") {
  const Scratch scratch;
  for (int i = 0; i < 1000; ++i) scratch.write(std::to_string(i) + ".json", lesson("l" + std::to_string(i)));
  std::shared_ptr<const ShelfItem> kept;
  {
    const Shelf shelf(scratch.path(), "");
    while (shelf.items().empty()) std::this_thread::yield();
    kept = shelf.items().front();
  }
  CHECK(kept.use_count() == 1);
  CHECK(kept->id == "l0");
  CHECK(kept->recording->graph().name(kept->recording->graph().main_value(kept->recording->last())) == "C");
}
