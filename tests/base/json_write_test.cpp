#include "base/json_write.hpp"

#include <catch2/catch.hpp>

using namespace blossom;

namespace {

std::string rewritten(const std::string& text, int indent = 0) {
  const auto document = JsonDocument::parse("test", text);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  return write_json(document->root(), indent);
}

}  // namespace

TEST_CASE("what fits stands on one line, and numbers keep the text they were typed with") {
  CHECK(rewritten(R"([ 1,2.50 , "2/5",-1e-3,true,false,null,[],{ } ])") ==
        "[\n  1,\n  2.50,\n  \"2/5\",\n  -1e-3,\n  true,\n  false,\n  null,\n  [],\n  {}\n]");
  CHECK(rewritten(R"({"degree":2,"points":[[0,0],[2,4]]})") == R"({"degree": 2, "points": [[0, 0], [2, 4]]})");
  CHECK(rewritten(R"(["a \"word\"\n", "\u00fc"])") == R"(["a \"word\"\n", "ü"])");
}

TEST_CASE("what holds objects has a line for each of them, indented") {
  CHECK(rewritten(R"({"inputs":{"curve":{"degree":1},"u":1},"beats":[{"at":"end"}]})") == R"({
  "inputs": {
    "curve": {"degree": 1},
    "u": 1
  },
  "beats": [
    {"at": "end"}
  ]
})");
  CHECK(rewritten(R"({"a":{"b":1}})", 4) == "{\n      \"a\": {\"b\": 1}\n    }");
}

TEST_CASE("a long array is filled line by line, and no line is longer than 100 characters") {
  std::string text = R"({"degree": 3, "points": [)";
  for (int i = 0; i < 40; ++i) text += (i > 0 ? ", " : "") + ("[" + std::to_string(1000 * i) + ", \"1/3\"]");
  const std::string written = rewritten(text + "]}");
  std::size_t lines = 0;
  for (std::size_t at = 0; at < written.size(); ++lines) {
    const std::size_t end = std::min(written.find('\n', at), written.size());
    CHECK(end - at <= 100);
    at = end + 1;
  }
  CHECK(lines > 6);
  CHECK(lines < 14);
  CHECK(written.starts_with("{\n  \"degree\": 3,\n  \"points\": [\n    [0, \"1/3\"], [1000, \"1/3\"], "));
  CHECK(written.ends_with("]\n  ]\n}"));
}

TEST_CASE("exact numbers are written as decimals where these are their value, as fractions otherwise") {
  const auto text = [](const Exact& x) { return write_json(json_number(x)); };
  CHECK(text(0) == "0");
  CHECK(text(-12) == "-12");
  CHECK(text(Exact::ratio(1, 2)) == "0.5");
  CHECK(text(Exact::ratio(-3, 80)) == "-0.0375");
  CHECK(text(Exact::ratio(1234567, 1000)) == "1234.567");
  CHECK(text(Exact::ratio(1, 3)) == "\"1/3\"");
  CHECK(text(*Exact::parse("1e-20")) == "\"1/100000000000000000000\"");
  CHECK(text(*Exact::parse("1e20")) == "\"100000000000000000000\"");
  // Read again it is the same number.
  for (const Exact& x : {Exact::ratio(7, 64), Exact::ratio(-22, 7), *Exact::parse("123456789012345"),
                         *Exact::parse("0.000000000000001"), *Exact::parse("1234567890123456")}) {
    const auto document = JsonDocument::parse("x", text(x));
    REQUIRE(document);
    Diagnostics none;
    CHECK(Cursor(*document, none).number() == x);
  }
}

TEST_CASE("an object is made member by member") {
  CHECK(write_json(json_object({{"schema", json_string("blossom.lesson/1")},
                                {"minutes", json_number("5")},
                                {"knots", json_array({json_number(Exact(0)), json_number(Exact::ratio(2, 3))})}})) ==
        R"({"schema": "blossom.lesson/1", "minutes": 5, "knots": [0, "2/3"]})");
}
