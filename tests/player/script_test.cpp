#include "player/script.hpp"

#include <catch2/catch.hpp>

using namespace blossom;

namespace {

using Words = std::vector<std::string>;

Instruction only(const std::string& line) {
  const auto script = parse_script("s", line);
  INFO(to_string(script.diagnostics));
  REQUIRE(script);
  REQUIRE(script->size() == 1);
  return script->front();
}

std::string mistakes(const std::string& text) {
  const auto script = parse_script("s", text);
  CHECK_FALSE(script);
  return to_string(script.diagnostics);
}

}  // namespace

TEST_CASE("a script is what a person would do, line by line") {
  const auto script = parse_script("s", R"(# de Boor, in a small window
size 1280 720 3/2
  open lessons/22-de-boor.json   # as by the dialog

key Right
type 2/5
focus timeline
move P[1][4]
click "cell P[1][4]" double shift
drag point/P[3] to point/P[4]
drag point/P[3] by 40 -2.5 alt
wheel view -3
drop /tmp/a.json
wait 0.5
shot first
state first
things all_of.them-2
expect title "De Boor's algorithm"
expect-near zoom 1.5 1e-6
expect-thing button/next
expect-no-thing "dialog open"
close)");
  INFO(to_string(script.diagnostics));
  REQUIRE(script);
  std::vector<std::pair<std::string, Words>> found;
  for (const Instruction& instruction : *script) found.emplace_back(instruction.verb, instruction.words);
  CHECK(found == std::vector<std::pair<std::string, Words>>{
                     {"size", {"1280", "720", "3/2"}},
                     {"open", {"lessons/22-de-boor.json"}},
                     {"key", {"Right"}},
                     {"type", {"2/5"}},
                     {"focus", {"timeline"}},
                     {"move", {"P[1][4]"}},
                     {"click", {"cell P[1][4]", "double", "shift"}},
                     {"drag", {"point/P[3]", "to", "point/P[4]"}},
                     {"drag", {"point/P[3]", "by", "40", "-2.5", "alt"}},
                     {"wheel", {"view", "-3"}},
                     {"drop", {"/tmp/a.json"}},
                     {"wait", {"0.5"}},
                     {"shot", {"first"}},
                     {"state", {"first"}},
                     {"things", {"all_of.them-2"}},
                     {"expect", {"title", "De Boor's algorithm"}},
                     {"expect-near", {"zoom", "1.5", "1e-6"}},
                     {"expect-thing", {"button/next"}},
                     {"expect-no-thing", {"dialog open"}},
                     {"close", {}},
                 });
  CHECK(script->front().line == 2);
  CHECK(script->back().line == 22);
}

TEST_CASE("quotes keep blanks, comments and themselves") {
  CHECK(only(R"(type "a \"b\" \\ # c")").words == Words{R"(a "b" \ # c)"});
  CHECK(only("type a#b # a comment").words == Words{"a#b"});
  CHECK(only("expect problems \"\"").words == Words{"problems", ""});
  CHECK(only("\xEF\xBB\xBFtype\t\xC3\xBC\r\n\r\n").words == Words{"\xC3\xBC"});
}

TEST_CASE("keys are characters or have names") {
  for (const std::string key : {"Right", "F12", "?", "a", "\xC3\xBC", "+", "Ctrl+Z", "Ctrl+Shift+Z", "Shift+Ctrl+Left",
                                "Ctrl++", "Alt+F4", "\"#\"", "\"\\\"\""})
    CHECK(only("key " + key).verb == "key");
  CHECK(mistakes("key right") == "s:1:5: no key is called \"right\"; did you mean \"Right\"?\n");
  CHECK(mistakes("key Ctrl+Entre") == "s:1:5: no key is called \"Entre\"; did you mean \"Enter\"?\n");
  CHECK(
      mistakes("key Crtl+Z") ==
      "s:1:5: no key is called \"Crtl+Z\"; before a key there may be Ctrl+, Alt+ and Shift+; did you mean \"Ctrl\"?\n");
  CHECK(mistakes("key Ctrl+") != "");
  CHECK(mistakes("key \"\"") != "");
}

TEST_CASE("every mistake is told at its place, all of them at once") {
  CHECK(mistakes(R"(clik P
size 1280 tall
wheel "P[1][4]" 1.5 now
wait
drag P onto Q
drag P
drag P to
click P dobule right right
shot ../../etc/passwd
size 640 480 99
expect-near zoom 1.5
expect-near zoom 1.5 -1
type a b)") == R"(s:1:1: unknown instruction "clik"; did you mean "click"?
s:2:11: must be a whole number from 100 to 16384, not "tall"
s:3:21: wheel NAME NOTCHES: "now" is too much; words with blanks stand in double quotes
s:4:5: wait SECONDS: SECONDS is missing
s:5:8: must be to or by, not "onto"
s:6:7: drag NAME to|by ...: something is missing
s:7:10: drag NAME to NAME [shift|ctrl|alt|right|middle]: NAME is missing
s:8:9: must be right, double, shift or ctrl, not "dobule"; did you mean "double"?
s:8:22: "right" is said twice
s:9:6: must be a file name of at most 100 letters, digits, -, _ and ., without its ending, not "../../etc/passwd"
s:10:14: must be a number from 1 to 4, not "99"
s:11:21: expect-near KEY NUMBER TOLERANCE: TOLERANCE is missing
s:12:22: must be a number from 0 to 1000000000, not "-1"
s:13:8: type TEXT: "b" is too much; words with blanks stand in double quotes
)");
}

TEST_CASE("columns count characters") { CHECK(mistakes("expect \"\xC3\xBC\xC3\xBC\" a b").starts_with("s:1:15: ")); }

TEST_CASE("quotes that are wrong") {
  CHECK(mistakes("type \"abc").starts_with("s:1:6: this quote is not closed"));
  CHECK(mistakes("type \"a\\\"").starts_with("s:1:6: this quote is not closed"));
  CHECK(mistakes("type \"a\\n\"").starts_with("s:1:8: in quotes"));
  CHECK(mistakes("type \"a\"b").starts_with("s:1:9: a blank"));
  CHECK(mistakes("type a\"b\"").starts_with("s:1:7: a quote"));
}

TEST_CASE("two pictures of one name would be one picture") {
  CHECK(mistakes("shot a\nstate a\nshot a\nthings a\n") ==
        "s:3:6: a.png is written in line 1 already\ns:4:8: a.json is written in line 2 already\n");
}

TEST_CASE("a script that does nothing is a mistake") {
  CHECK(mistakes("") == "s: says nothing to do\n");
  CHECK(mistakes("\n  # shot a\n\n") == "s: says nothing to do\n");
}

TEST_CASE("a script has an end") {
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "key Right\n";
  const auto script = parse_script("s", text);
  REQUIRE(script);
  CHECK(script->size() == 10'000);
  CHECK(mistakes(text + "#").starts_with("s:10001: has more than 10,000 lines"));
  CHECK(only("type " + std::string(4091, 'x')).words[0].size() == 4091);
  CHECK(mistakes("\ntype " + std::string(4092, 'x')) == "s:2:1: has more than 4096 bytes\n");
}

TEST_CASE("bytes that are no text") {
  CHECK(mistakes("type \xFF") == "s:1:6: is no UTF-8\n");
  CHECK(mistakes(std::string("type a\0b", 8)).starts_with("s:1:7: a control character"));
  CHECK(mistakes("type \xE2\x80\xAE").starts_with("s:1:6: a control character"));
}
