// blossom convert, and what else is done with scenes at the command line.

#include "app/program.hpp"

using namespace blossom::test;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("convert writes a scene in every format that can be written, and says what is lost") {
  const Scratch scratch;
  for (const char* extension : {".obj", ".stl", ".glb", ".csv", ".svg"}) {
    const std::string file = scratch / (std::string("vase") + extension);
    const Ended ended = run_program("blossom", {"convert", "lessons/scenes/vase.json", file});
    INFO(extension << "\n" << ended.err);
    CHECK(ended.status == 0);
    CHECK(has(ended.err, "note: "));
    CHECK(std::filesystem::file_size(file) > 100);
  }
}

TEST_CASE("what convert has read becomes a scene that lint finds in order") {
  const Scratch scratch;
  const std::string points = scratch.write("points.csv", "0,0\n1,2\n\n5,1\n3,0\n2,2\n");
  const std::string scene = scratch / "scene.json";
  CHECK(run_program("blossom", {"convert", points, scene}).status == 0);
  const Ended lint = run_program("blossom", {"lint", scene});
  INFO(lint.out << lint.err);
  CHECK(lint.status == 0);
  CHECK(has(read_all(scene), "blossom.scene/1"));
}

TEST_CASE("convert says what it cannot read or write, and leaves no file behind") {
  const Scratch scratch;
  const std::string out = scratch / "out.xyzzy";
  const Ended unknown = run_program("blossom", {"convert", "lessons/scenes/vase.json", out});
  CHECK(unknown.status == 1);
  CHECK(has(unknown.err, ".obj"));
  CHECK(!std::filesystem::exists(out));
  const std::string bad = scratch.write("bad.obj", "v 0 0\n");
  const Ended damaged = run_program("blossom", {"convert", bad, scratch / "out.obj"});
  CHECK(damaged.status == 1);
  CHECK(has(damaged.err, "bad.obj:1:"));
  CHECK(!std::filesystem::exists(scratch / "out.obj"));
}

TEST_CASE("the shipped scenes are listed, and a mistake in one has its place") {
  CHECK(has(run_program("blossom", {"list"}).out, "skinned-tube"));
  const Scratch scratch;
  const std::string file =
      scratch.write("s.json",
                    "{\"schema\": \"blossom.scene/1\", \"objects\": [\n{\"name\": \"a\", \"made\": {\"algorithm\": "
                    "\"revolution\", \"inputs\": {\"profile\": {\"object\": \"b\"}}}}]}\n");
  const Ended ended = run_program("blossom", {"lint", file});
  CHECK(ended.status == 1);
  CHECK(has(ended.out + ended.err, "s.json:2:"));
}
