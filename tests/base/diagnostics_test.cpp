#include "base/diagnostics.hpp"

#include <catch2/catch.hpp>

#include "base/utf8.hpp"

using namespace blossom;

TEST_CASE("a diagnostic is one line, and leaves out what is unknown") {
  CHECK(to_string(Diagnostic{"a.json", 3, 7, "curve.degree", "is wrong"}) == "a.json:3:7: curve.degree: is wrong");
  CHECK(to_string(Diagnostic{"a.json", 3, 0, "", "is wrong"}) == "a.json:3: is wrong");
  CHECK(to_string(Diagnostic{"a.json", 0, 0, "", "is wrong"}) == "a.json: is wrong");
  CHECK(to_string(Diagnostic{"", 0, 0, "u", "is wrong"}) == "u: is wrong");
  CHECK(to_string(Diagnostic{"", 0, 0, "", "is wrong"}) == "is wrong");
  CHECK(to_string(Diagnostic{"", 2, 5, "", "is wrong"}) == "line 2, column 5: is wrong");
}

TEST_CASE("a hostile name cannot reach the terminal") {
  CHECK(to_string(Diagnostic{"a\n.json", 1, 1, "x\x1B[31m", "\x7F"}) == "a\\x0A.json:1:1: x\\x1B[31m: \\x7F");
  CHECK(to_string(Diagnostic{"", 0, 0, "", std::string("nul\0", 4)}) == "nul\\x00");
  CHECK(to_string(Diagnostic{"", 0, 0, "",
                             "\xC2\x9B"
                             "31m"}) ==
        "\\xC2\\x9B"
        "31m");
  CHECK(to_string(Diagnostic{"", 0, 0, "", "\xFF\xC3"}) == "\\xFF\\xC3");
  CHECK(to_string(Diagnostic{"", 0, 0, "", "B\xC3\xA9zier"}) == "B\xC3\xA9zier");
}

TEST_CASE("what breaks a line or turns the direction of a text is written out, its neighbours are not") {
  for (const char* turning : {"\xE2\x80\xA8", "\xE2\x80\xA9", "\xE2\x80\xAA", "\xE2\x80\xAE", "\xE2\x81\xA6",
                              "\xE2\x81\xA9", "\xC2\x80", "\xC2\x9F"}) {
    INFO(printable(turning));
    CHECK(is_control(turning));
    CHECK(printable(turning).starts_with("\\x"));
    CHECK(to_string(Diagnostic{turning, 0, 0, "", "x"}) == printable(turning) + ": x");
  }
  // U+2027, U+202F, U+2065, U+206A, U+00A0, U+20AC
  for (const char* harmless :
       {"\xE2\x80\xA7", "\xE2\x80\xAF", "\xE2\x81\xA5", "\xE2\x81\xAA", "\xC2\xA0", "\xE2\x82\xAC"}) {
    CHECK_FALSE(is_control(harmless));
    CHECK(printable(harmless) == harmless);
  }
  CHECK(printable("user\xE2\x80\xAEtxt.exe") == "user\\xE2\\x80\\xAEtxt.exe");
}

TEST_CASE("diagnostics are listed by place") {
  const Diagnostics diagnostics{
      {"b", 1, 1, "", "4"}, {"a", 10, 1, "", "3"}, {"a", 2, 9, "", "2"}, {"a", 2, 1, "", "1"}};
  CHECK(to_string(diagnostics) == "a:2:1: 1\na:2:9: 2\na:10:1: 3\nb:1:1: 4\n");
  CHECK(to_string(Diagnostics{}).empty());
}

TEST_CASE("an excerpt of a long text ends at a character") {
  CHECK(excerpt("abc") == "\"abc\"");
  CHECK(excerpt(std::string(40, 'a')) == "\"" + std::string(40, 'a') + "\"");
  CHECK(excerpt(std::string(41, 'a')) == "\"" + std::string(40, 'a') + "...\"");
  std::string greek, forty;
  for (int i = 0; i < 50; ++i) greek += "\xCE\xB1";
  for (int i = 0; i < 40; ++i) forty += "\xCE\xB1";
  CHECK(excerpt(greek) == "\"" + forty + "...\"");
}

TEST_CASE("an excerpt is one harmless line") {
  CHECK(excerpt("a\n\x1B[2Jb") == R"("a\x0A\x1B[2Jb")");
  CHECK(excerpt("\xFF\xC2\x9B") == R"("\xFF\xC2\x9B")");
  CHECK(excerpt("B\xC3\xA9zier") == "\"B\xC3\xA9zier\"");
  // A diagnostic that quotes it does not escape it again.
  CHECK(to_string(Diagnostic{"", 0, 0, "", "not " + excerpt("\n")}) == R"(not "\x0A")");
}

TEST_CASE("a typing mistake finds what was meant, another word does not") {
  const std::vector<std::string> keys{"degree", "knots", "points", "weights", "u"};
  CHECK(did_you_mean("pionts", keys) == "points");
  CHECK(did_you_mean("Points", keys) == "points");
  CHECK(did_you_mean("weigth", keys) == "weights");
  CHECK(did_you_mean("knot", keys) == "knots");
  CHECK_FALSE(did_you_mean("colour", keys).has_value());
  CHECK_FALSE(did_you_mean("x", keys).has_value());
  CHECK_FALSE(did_you_mean("", keys).has_value());
  CHECK_FALSE(did_you_mean(std::string(100'000, 'p'), keys).has_value());
}

TEST_CASE("the length of a text is that of its characters") {
  CHECK(utf8_count("") == 0);
  CHECK(utf8_count("B\xC3\xA9zier") == 6);
  CHECK(utf8_count("\xF0\x9F\x98\x80\xE2\x82\xAC") == 2);
  CHECK(utf8_count("a\xFF\xE2\x82z") == 5);  // bytes that are no character count one each
}

TEST_CASE("UTF-8 characters are told from what only looks like them") {
  CHECK(utf8_length("a", 0) == 1);
  CHECK(utf8_length("\xC3\xA9", 0) == 2);
  CHECK(utf8_length("\xE2\x82\xAC", 0) == 3);
  CHECK(utf8_length("\xF0\x9F\x98\x80", 0) == 4);
  CHECK(utf8_length("", 0) == 0);
  for (const char* bad : {"\x80", "\xC3", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                          "\xF5\x80\x80\x80", "\xE2\x82", "\xF0\x9F\x98", "\xF0\x80\x80\x80"}) {
    CHECK(utf8_length(bad, 0) == 0);
  }
}
