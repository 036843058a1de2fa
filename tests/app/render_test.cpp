// `blossom render` as a user at the terminal meets it: which files it writes, and what it says of mistakes.
#include "app/program.hpp"

#if BLOSSOM_PLAYER

#include <unistd.h>

#include <algorithm>

using namespace blossom::test;

namespace {

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> names;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

// Width and height of a PNG, from its header.
std::pair<unsigned, unsigned> png_size(const std::string& file) {
  const std::string bytes = read_all(file);
  REQUIRE(bytes.size() > 1000);
  REQUIRE(bytes.starts_with("\x89PNG\r\n\x1a\n"));
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = 256 * value + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

Ended render(std::vector<std::string> arguments, const Setting& setting = {}) {
  arguments.insert(arguments.begin(), "render");
  return blossom::test::blossom(arguments, setting);
}

}  // namespace

TEST_CASE("render draws the last step, or the one that is asked for") {
  const Scratch scratch;
  const auto last = render({"22-de-boor", "--out", scratch.path()});
  SHOW(last);
  CHECK(last.status == 0);
  CHECK(last.err.empty());
  CHECK(contains(last.out, "1 picture in " + scratch.path()));
  CHECK(files_in(scratch.path()) == std::vector<std::string>{"de-boor-15.png"});
  CHECK(png_size(scratch / "de-boor-15.png") == std::pair(1120u, 700u));

  const auto fourth = render({"22", "--step", "4", "--size", "640x480", "--scale", "2", "--out", scratch.path()});
  SHOW(fourth);
  CHECK(fourth.status == 0);
  CHECK(png_size(scratch / "de-boor-04.png") == std::pair(1280u, 960u));
}

TEST_CASE("render --all draws every step, each its own picture") {
  const Scratch scratch;
  const auto ended = render({"11-de-casteljau", "--all", "--svg", "--out", scratch / "new/folder"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());  // no progress line when nobody looks at a terminal
  const auto names = files_in(scratch / "new/folder");
  REQUIRE(names.size() > 5);
  CHECK(contains(ended.out, std::to_string(names.size()) + " pictures"));
  std::vector<std::string> contents;
  for (const auto& name : names) {
    CHECK(name.ends_with(".svg"));
    contents.push_back(read_all(scratch / ("new/folder/" + name)));
    CHECK(contains(contents.back(), "<svg"));
    CHECK(contains(contents.back(), "</svg>"));
  }
  std::ranges::sort(contents);
  CHECK(std::ranges::adjacent_find(contents) == contents.end());
}

TEST_CASE("render --contact-sheet puts the steps on one picture") {
  const Scratch scratch;
  const auto ended = render({"11-de-casteljau", "--contact-sheet", scratch / "sheet.png", "--size", "640x480",
                             "--scale", "0.5", "--out", scratch / "each"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, scratch / "sheet.png"));
  CHECK(png_size(scratch / "sheet.png").first > 640);
  CHECK(files_in(scratch / "each").empty());  // the sheet alone was asked for
}

TEST_CASE("render in each theme is a picture of its own") {
  const Scratch scratch;
  std::vector<std::string> pictures;
  for (const std::string theme : {"light", "dark", "contrast"}) {
    const auto ended = render({"11", "--step", "2", "--theme", theme, "--size", "640x480", "--out", scratch / theme});
    SHOW(ended);
    CHECK(ended.status == 0);
    pictures.push_back(read_all(scratch / (theme + "/" + files_in(scratch / theme).at(0))));
  }
  CHECK(pictures[0] != pictures[1]);
  CHECK(pictures[1] != pictures[2]);
  CHECK(pictures[0] != pictures[2]);
}

TEST_CASE("render says every wrong option before it draws") {
  const Scratch scratch;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"22", "--theme", "sepia"}, "sepia"},
      {{"22", "--size", "12"}, "12"},
      {{"22", "--size", "100x100"}, "480x360"},
      {{"22", "--size", "640x480x3"}, "640x480x3"},
      {{"22", "--size", "99999x480"}, "99999x480"},
      {{"22", "--scale", "0"}, "--scale"},
      {{"22", "--scale", "nan"}, "--scale"},
      {{"22", "--all", "--step", "3"}, "--all"},
      {{"22", "--size", "8192x8192"}, "64 million"},
      {{"22", "--size", "4000x3000", "--scale", "4"}, "64 million"},
      {{"22", "--size", "8192x480", "--scale", "4"}, "16384"},
      {{"22", "--svg", "--size", "16384x16384"}, "64 million"},
      {{"22", "--step", "-1"}, "--step"},
      {{"22", "--step", "two"}, "--step"},
      {{"22", "--context", "metal"}, "metal"},
      {{}, "LESSON"}};
  for (auto [arguments, words] : cases) {
    arguments.insert(arguments.end(), {"--out", scratch / "out"});
    const auto ended = render(arguments);
    SHOW(ended);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(contains(ended.err, words));
    CHECK(ended.err.size() < 300);
  }
  const auto both = render({"22", "--theme", "sepia", "--size", "12", "--out", scratch / "out"});
  SHOW(both);
  CHECK(contains(both.err, "--theme"));
  CHECK(contains(both.err, "--size"));
  CHECK_FALSE(fs::exists(scratch / "out"));
}

TEST_CASE("Pages are bounded by their pixels, and the manual says so") {
  const Scratch scratch;
  const auto wide = render({"11", "--step", "1", "--svg", "--size", "8000x8000", "--out", scratch.path()});
  SHOW(wide);
  CHECK(wide.status == 0);
  CHECK(contains(render({"--help"}).out, "64 million"));
}

TEST_CASE("A step that the lesson has not is the input's fault") {
  const Scratch scratch;
  const auto ended = render({"22", "--step", "16", "--out", scratch / "out"});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, "from 0 to 15"));
  CHECK(files_in(scratch / "out").empty());
  CHECK(render({scratch / "none.json", "--out", scratch / "out"}).status == 1);
}

TEST_CASE("Pictures that cannot be written have status 3, and nothing half-written stays") {
  const Scratch scratch;
  const auto file = scratch.write("file", "in the way");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"01", "--step", "1", "--out", file + "/sub"},
        {"01", "--svg", "--step", "1", "--out", file},
        {"01", "--contact-sheet", scratch / "none/sheet.png", "--size", "640x480", "--scale", "0.25", "--out",
         scratch / "each"}}) {
    const auto ended = render(arguments);
    SHOW(ended);
    CHECK(ended.status == 3);
    CHECK(contains(ended.err, "cannot be written"));
  }
  CHECK(read_all(file) == "in the way");
  if (geteuid() == 0) return;  // who may write anywhere
  fs::create_directory(scratch / "closed");
  fs::permissions(scratch / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  const auto ended = render({"11", "--step", "1", "--out", scratch / "closed"});
  SHOW(ended);
  CHECK(ended.status == 3);
  CHECK(files_in(scratch / "closed").empty());
}

TEST_CASE("render draws what standard input describes") {
  const Scratch scratch;
  const auto ended =
      render({"--algorithm", "de_casteljau", "--inputs", "-", "--exact", "--svg", "--out", scratch.path()},
             {.input = R"({"curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}, "u": "1/3"})"});
  SHOW(ended);
  CHECK(ended.status == 0);
  const auto names = files_in(scratch.path());
  REQUIRE(names.size() == 1);
  CHECK(names[0].starts_with("de_casteljau-"));
  CHECK(contains(read_all(scratch / names[0]), "(2/3, 8/9)"));
}

#endif
