#include <catch2/catch.hpp>
#include <climits>
#include <string>

#include "base/json.hpp"

using namespace blossom;

namespace {

// What reading `text` with `read` says, one diagnostic per line.
template <class Read>
std::string said(const std::string& text, Read&& read) {
  const auto document = JsonDocument::parse("f", text);
  REQUIRE(document);
  Diagnostics diagnostics;
  read(Cursor(*document, diagnostics));
  return to_string(diagnostics);
}

}  // namespace

TEST_CASE("a reader gets what it asks for, and nothing is said") {
  const std::string text =
      R"({"n": -2.5, "f": "2/5", "i": 7, "whole": 7.0, "s": "x", "b": false, "a": [[1, 2], [3, 4]]})";
  CHECK(said(text, [](const Cursor& at) {
          CHECK(at.expect_object({"n", "f", "i", "whole", "s", "b", "a", "absent"}));
          CHECK(at.required("n")->number() == Exact::ratio(-5, 2));
          CHECK(at.required("f")->number() == Exact::ratio(2, 5));
          CHECK(at.required("i")->integer(1, 25) == 7);
          CHECK(at.required("whole")->integer(7, 7) == 7);
          CHECK(at.required("s")->string() == "x");
          CHECK(at.required("b")->boolean() == false);
          const Cursor a = *at.optional("a");
          CHECK(a.expect_array(2, 2));
          CHECK(a[1][0].number() == Exact(3));
          CHECK(a[1][0].path() == "a[1][0]");
          CHECK(at.member(0).path() == "n");
          CHECK_FALSE(at.optional("absent").has_value());
          CHECK_FALSE(at.has_errors());
        }) == "");
}

TEST_CASE("every mistake is named at its own place with what would be right") {
  const std::string text = R"({"pionts": 1,
 "x": {"colour": 2, "degree": 30},
 "s": 5, "b": "yes", "n": "abc", "list": [1, [], null]})";
  CHECK(said(text, [](const Cursor& at) {
          CHECK(at.expect_object({"points", "x", "s", "b", "n", "list"}));
          CHECK_FALSE(at.required("points").has_value());
          const Cursor x = *at.required("x");
          x.expect_object({"degree", "knots"});
          x.required("degree")->integer(1, 25);
          at.required("s")->string();
          at.required("b")->boolean();
          at.required("n")->number();
          const Cursor list = *at.required("list");
          list.expect_array(4, 4);
          for (std::size_t i = 0; i < list.size(); ++i) list[i].number();
          list.expect_object({"u"});
          x.expect_array();
          CHECK(at.has_errors());
        }) == R"(f:1:1: missing key "points"
f:1:2: unknown key "pionts"; did you mean "points"?
f:2:7: x: must be an array, not an object
f:2:8: x: unknown key "colour"; the keys here are "degree" and "knots"
f:2:31: x.degree: must be a whole number from 1 to 25, not 30
f:3:7: s: must be a string, not 5
f:3:15: b: must be true or false, not "yes"
f:3:27: n: must be a number or an exact string such as "2/5", not "abc"
f:3:42: list: must have 4 items, not 3
f:3:42: list: must be an object with keys among "u", not an array
f:3:46: list[1]: must be a number or an exact string such as "2/5", not an array
f:3:50: list[2]: must be a number or an exact string such as "2/5", not null
)");
}

TEST_CASE("whole numbers: the range is said as a person would") {
  const auto says = [](const char* text, int least, int most) {
    return said(text, [&](const Cursor& at) { CHECK_FALSE(at.integer(least, most).has_value()); });
  };
  CHECK(says("2.5", INT_MIN, INT_MAX) == "f:1:1: must be a whole number, not 2.5\n");
  CHECK(says("\"14/2\"", 1, 25) == "f:1:1: is a count, and stands without quotation marks: 7\n");
  CHECK(says("-1", 0, INT_MAX) == "f:1:1: must be a whole number, at least 0, not -1\n");
  CHECK(says("1e300", INT_MIN, 9) == "f:1:1: must be a whole number, at most 9, not 1e300\n");
  CHECK(says("[]", 3, 3) == "f:1:1: must be the number 3, not an array\n");
  CHECK(says("99999999999999999999", INT_MIN, INT_MAX) == "f:1:1: must be a whole number, not 99999999999999999999\n");
  CHECK(says("\"nan\"", 1, 2) == "f:1:1: must be a whole number from 1 to 2, not \"nan\"\n");
}

TEST_CASE("hostile: numbers out of bounds are refused, as numbers and as strings") {
  const auto number = [](const Cursor& at) { CHECK_FALSE(at.number().has_value()); };
  CHECK(said("\"1e400\"", number) == "f:1:1: too large; at most about 1.8e308, not \"1e400\"\n");
  CHECK(said("1e-401", number).find("with an exponent from -400 to 400, not 1e-401") != std::string::npos);
  CHECK(said("\"1/0\"", number) == "f:1:1: must be a number or an exact string such as \"2/5\", not \"1/0\"\n");
  CHECK(said("0." + std::string(1000, '1'), number).size() < 200);
  CHECK(said("\"" + std::string(1000, '1') + "\"", number).size() < 200);
}

TEST_CASE("hostile: names stay short and on one line") {
  const std::string key(5000, 'k');
  const std::string text = "{\"" + key + "\": [\"a\\nb\"], \"P[1][2]\": {\"x y\": 0}}";
  const std::string lines = said(text, [](const Cursor& at) {
    at.expect_object({});
    at.member(0)[0].boolean();
    at.member(1).member(0).boolean();
  });
  CHECK(lines.size() < 500);
  CHECK(lines.find("[0]: must be true or false, not \"a\\x0Ab\"") != std::string::npos);
  CHECK(lines.find("[\"P[1][2]\"][\"x y\"]: must be true or false, not 0") != std::string::npos);
}

TEST_CASE("a string has line breaks and tabs, and no other control characters") {
  CHECK(said(R"("two\n\tlines, \u00e9\u20ac\u00a0")",
             [](const Cursor& at) { CHECK(at.string() == "two\n\tlines, \xC3\xA9\xE2\x82\xAC\xC2\xA0"); }) == "");
  for (const char* text : {R"("\u001b[2J")", R"("\r")", R"("\u007f")", R"("\u009b")", R"("a\u202eb")", R"("\u2066")",
                           R"("\u2028")", R"("\u2029")"}) {
    INFO(text);
    CHECK(said(text, [](const Cursor& at) { CHECK_FALSE(at.string().has_value()); }) ==
          "f:1:1: must not contain control characters: they act on a terminal or on the direction of the text\n");
  }
}

TEST_CASE("hostile: mistakes are listed up to a bound, in time that does not grow with their square") {
  std::string text = "[";
  for (int i = 0; i < 300'000; ++i) text += "null,";
  text += "0]";
  const auto document = JsonDocument::parse("f", text);
  REQUIRE(document);
  Diagnostics diagnostics;
  const Cursor at(*document, diagnostics);
  const std::size_t before = at.error_count();
  for (std::size_t i = 0; i < at.size(); ++i) at[i].number();
  CHECK(diagnostics.size() == most_diagnostics + 1);
  CHECK(diagnostics[9999].column == 2 + 5 * 9999);
  CHECK(diagnostics.back().message == "more than 10,000 mistakes; the others are not listed");
  CHECK(at.errors_since(before));
  CHECK(at.errors_since(at.error_count()));  // full: nobody can know any more
}
