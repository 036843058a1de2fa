// Scripts that are wrong, and files that are: what the player says, and how it ends.
#include "app/program.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

struct Played {
  Ended ended;
  Scratch scratch;
  std::string script;

  explicit Played(const std::string& text) : script(scratch.write("script.txt", text)) {
    ended =
        test::blossom({"play", "--headless-script", script, "--out", scratch / "out", "--state", scratch / "state"});
  }
};

void check_fails(const std::string& text, const std::string& place, const std::string& message) {
  const Played played(text);
  SHOW(played.ended);
  INFO(text);
  CHECK(played.ended.status == 1);
  CHECK(played.ended.out.empty());
  CHECK(contains(played.ended.err, played.script + ":" + place + ": "));
  CHECK(contains(played.ended.err, message));
}

}  // namespace

TEST_CASE("All mistakes of a script are told by line and column, and nothing of it is done") {
  const Played played("shot first\nopen\nclikc \"tab inputs\"\nkey Hime\n\nwait soon\ndrag a by 1\n");
  SHOW(played.ended);
  CHECK(played.ended.status == 1);
  for (const char* place : {":2:5: ", ":3:1: ", ":4:5: ", ":6:6: ", ":7:12: "}) {
    INFO(place);
    CHECK(contains(played.ended.err, played.script + place));
  }
  CHECK(contains(played.ended.err, "click"));  // what was probably meant
  CHECK(contains(played.ended.err, "Home"));
  CHECK_FALSE(fs::exists(played.scratch / "out/first.png"));
}

TEST_CASE("A script that names what is not there fails at its line") {
  const std::string opened = "open lessons/22-de-boor.json\n";
  check_fails(opened + "click \"tab inptus\"\n", "2:1", "\"tab inptus\"");
  check_fails(opened + "click \"step.forwrd\"\n", "2:1", "did you mean \"step.forward\"?");
  check_fails(opened + "drag \"viewport P[0][3]\" to \"viewport P[0][33]\"\n", "2:1", "\"viewport P[0][33]\"");
  check_fails(opened + "\nexpect-thing nonsense\n", "3:1", "\"nonsense\"");
  check_fails(opened + "expect-no-thing step.forward\n", "2:1", "\"step.forward\"");
  check_fails(opened + "expect nonsense 1\n", "2:1", "\"nonsense\"");
  check_fails("click step.forward\n", "1:1", "\"step.forward\"");  // nothing is open
}

TEST_CASE("A script whose expectation does not hold fails and says what is") {
  const std::string opened = "open tests/play/data/22-de-boor.json\nkey Right\n";
  check_fails(opened + "expect step 2\nshot after\n", "3:1", "expected step to be \"2\", not \"1\"");
  check_fails(opened + "expect-near step 3 1.5\n", "3:1", "not 1");
  check_fails(opened + "expect-near title 3 1\n", "3:1", "to be a number");
  const Played played(opened + "expect step 2\nshot after\n");
  CHECK_FALSE(fs::exists(played.scratch / "out/after.png"));  // the script ends there
}

TEST_CASE("A script that is missing, a folder, empty or enormous is a mistake") {
  const Scratch scratch;
  for (const std::string& script :
       {scratch / "missing.txt", scratch.path(), scratch.write("empty.txt", "# nothing\n"),
        scratch.write("binary.txt", std::string(5000, '\0')), scratch.write("large.txt", std::string(3u << 20, '#')),
        scratch.write("long.txt", [] {
          std::string text;
          for (int i = 0; i < 10001; ++i) text += "key Right\n";
          return text;
        }())}) {
    INFO(script);
    const Ended ended = test::blossom({"play", "--headless-script", script, "--out", scratch / "out"});
    SHOW(ended);
    CHECK(ended.status == 1);
    CHECK(contains(ended.err, script));
    CHECK(ended.err.size() < 2000);
  }
}

TEST_CASE("Pictures that cannot be written are a mistake") {
  const Scratch scratch;
  const std::string file = scratch.write("file", "");
  const std::string script = scratch.write("s.txt", "shot one\n");
  const Ended ended = test::blossom({"play", "--headless-script", script, "--out", file + "/out"});
  SHOW(ended);
  CHECK(ended.status != 0);
  CHECK(contains(ended.err, "one.png"));
}

TEST_CASE("What is opened or dropped and cannot be read keeps the old document and lists what is wrong") {
  const Scratch files;
  const std::string lesson = read_all(fs::path(BLOSSOM_SOURCE_DIR) / "tests/play/data/22-de-boor.json");
  std::string many = "{\"curve\": {\"degree\": 1, \"points\": [[0,0]";
  for (int i = 0; i < 300000; ++i) many += ",[1,2]";
  many += "]}, \"u\": 0}";
  struct Hostile {
    std::string file, says;
  };
  const std::vector<Hostile> hostile = {
      {files.write("broken.json", lesson.substr(0, lesson.size() / 2)), "broken.json:"},
      {files.write("wrong.json", std::string(lesson).replace(lesson.find("\"2/5\""), 5, "\"7/5\"")), "wrong.json:17:"},
      {files.write("deep.json", std::string(200000, '[')), "deep.json:1:"},
      {files.write("huge.json", many), "huge.json"},
      {files.write("zeros.json", std::string(100000, '\0')), "zeros.json:1:"},
      {files.write("na me.json", "{"), "na me.json:1:"},
      {files / "missing.json", "missing.json"},
      {files.path(), ""},
      {"/dev/zero", "/dev/zero"},
  };
  for (const char* verb : {"open", "drop"})
    for (const Hostile& bad : hostile) {
      const Played played("open tests/play/data/22-de-boor.json\nkey Right\nkey Right\n" + std::string(verb) + " \"" +
                          bad.file +
                          "\"\nexpect title \"De Boor's algorithm: a point on a B-spline curve\"\nexpect step 2\n" +
                          "state after\nshot after\nkey Escape\nexpect problems \"\"\nkey Right\nexpect step 3\n");
      SHOW(played.ended);
      INFO(verb << " " << bad.file);
      CHECK(played.ended.status == 0);
      const std::string state = read_all(played.scratch / "out/after.json");
      CHECK_FALSE(contains(state, "\"problems\": \"\""));
      CHECK(contains(state, bad.says));
    }
}

TEST_CASE("A lesson that is wrong when the player starts is told before there is a window") {
  const Scratch scratch;
  const std::string bad = scratch.write("bad.json", "{\"schema\": \"blossom.lesson/1\"}");
  const std::string script = scratch.write("s.txt", "key Right\n");
  const Ended ended = test::blossom({"play", bad, "--headless-script", script, "--out", scratch / "out"});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, bad + ":1:"));
}

TEST_CASE("A script makes the same pictures every time") {
  const std::string text =
      "open lessons/22-de-boor.json\nkey End\nshot last\nkey Home\nkey Right\nwait 0.2\nshot moving\nkey T\nshot "
      "dark\n";
  const Played once(text), again(text);
  SHOW(once.ended);
  REQUIRE(once.ended.status == 0);
  for (const char* name : {"out/last.png", "out/moving.png", "out/dark.png"}) {
    INFO(name);
    CHECK(read_all(once.scratch / name) == read_all(again.scratch / name));
  }
  CHECK(read_all(once.scratch / "out/last.png") != read_all(once.scratch / "out/dark.png"));
}
