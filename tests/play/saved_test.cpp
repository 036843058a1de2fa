// What is saved by the dialogs is what the other commands read.
#include "app/program.hpp"
#include "render/image.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Ended play(const Scratch& scratch, const std::string& text) {
  const std::string script = scratch.write("script.txt", text);
  return test::blossom({"play", "--headless-script", script, "--out", scratch / "out", "--state", scratch / "state"});
}

// Of a dialog that asks for a file.
std::string save_to(const std::string& file) {
  return "click \"dialog file\"\nkey Ctrl+A\ntype \"" + file +
         "\"\nkey Enter\nexpect dialog none\nexpect problems \"\"\n";
}

}  // namespace

TEST_CASE("Edited inputs are saved as a lesson, and the picture as PNG and SVG") {
  const Scratch scratch;
  const Ended ended =
      play(scratch,
           "open lessons/22-de-boor.json\nkey End\ndrag \"viewport P[0][3]\" by 40 -25\nexpect edited yes\n"
           "key Ctrl+S\nclick \"dialog title\"\nkey Ctrl+A\ntype \"My curve\"\n"
           "click \"dialog id\"\nkey Ctrl+A\ntype my-curve\n" +
               save_to(scratch / "mine.json") + "expect unsaved no\nkey Ctrl+E\n" + save_to(scratch / "step.png") +
               "key Ctrl+E\n" + save_to(scratch / "step.svg") + "open \"" +
               scratch / "mine.json\"\nexpect title \"My curve\"\nkey End\nstate mine\n");
  SHOW(ended);
  REQUIRE(ended.status == 0);
  const Ended lint = test::blossom({"lint", scratch / "mine.json"});
  SHOW(lint);
  CHECK(lint.status == 0);
  CHECK(contains(test::blossom({"trace", scratch / "mine.json", "--exact"}).out, "My curve"));
  const auto picture = read_png(scratch / "step.png");
  REQUIRE(picture);
  CHECK((picture->width > 1000 && picture->height > 500));
  CHECK(contains(read_all(scratch / "step.svg"), "<svg"));
}

TEST_CASE("Predictions are typed, marked when all are given, and saved as answers that blossom-grade takes") {
  const Scratch scratch;
  const auto answer = [](const std::string& value, const std::string& x, const std::string& y) {
    return "expect question \"" + value + "\"\nclick \"predict x\"\nkey Ctrl+A\ntype " + x +
           "\nclick \"predict y\"\nkey Ctrl+A\ntype " + y + "\nclick \"predict answer\"\n";
  };
  // The second one is wrong; the last goes on from it by the right rule.
  const Ended ended =
      play(scratch, "open exercises/11-de-casteljau.json\nkey End\nexpect step 0\n" + answer("P[1][0]", "1", "3") +
                        answer("P[1][1]", "7", "12") +
                        "expect undos 0\nclick edit.undo\nexpect undos 1\nexpect question \"P[1][1]\"\n" +
                        answer("P[1][1]", "6", "12") + answer("P[1][2]", "13", "10") +
                        "expect answered \"3 / 6\"\nkey Ctrl+Shift+S\n" + save_to(scratch / "answers.json"));
  SHOW(ended);
  REQUIRE(ended.status == 0);
  const Ended grade =
      run_program("blossom-grade", {"exercises/11-de-casteljau.json", scratch / "answers.json", "--format", "json"});
  SHOW(grade);
  CHECK(grade.status == 0);
  CHECK(contains(grade.out, "\"correct\""));
  CHECK(contains(read_all(scratch / "answers.json"), "P[1][2]"));
}
