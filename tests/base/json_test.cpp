#include "base/json.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace blossom;

namespace {

JsonDocument accepted(const std::string& text, const JsonLimits& limits = {}) {
  auto document = JsonDocument::parse("f", text, limits);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  REQUIRE(document.diagnostics.empty());
  return *std::move(document);
}

// The one diagnostic of a text that is refused, as "line:column: message".
std::string refused(const std::string& text, const JsonLimits& limits = {}) {
  const auto document = JsonDocument::parse("", text, limits);
  INFO("text " << text.substr(0, 100));
  REQUIRE_FALSE(document);
  REQUIRE(document.diagnostics.size() == 1);
  const Diagnostic& d = document.diagnostics[0];
  CHECK(d.message.find("json.exception") == std::string::npos);
  return std::to_string(d.line) + ":" + std::to_string(d.column) + ": " + d.message;
}

constexpr auto any_value = "; expected a value: a number, a \"string\", [...], {...}, true, false or null";

}  // namespace

TEST_CASE("a document becomes a tree in the order of the file") {
  const auto document = accepted(R"({"b": [1, -2.50, "x\n\u00e9"], "a": {"t": true, "n": null}})");
  const Json& root = document.root();
  REQUIRE(root.kind == Json::Kind::object);
  CHECK(root.keys == std::vector<std::string>{"b", "a"});
  REQUIRE(root.find("b") != nullptr);
  const Json& b = *root.find("b");
  REQUIRE(b.items.size() == 3);
  CHECK(b.items[0].text == "1");
  CHECK(b.items[1].text == "-2.50");
  CHECK(b.items[2].text == "x\n\xC3\xA9");
  CHECK(root.find("a")->find("t")->boolean);
  CHECK(root.find("a")->find("n")->kind == Json::Kind::null);
  CHECK(root.find("c") == nullptr);
  CHECK(accepted("\xEF\xBB\xBF[1]").root().items.size() == 1);
}

TEST_CASE("a number keeps the text it was typed with") {
  for (const char* text : {"0", "-0", "12", "-7", "18446744073709551615", "18446744073709551616",
                           "-9223372036854775808", "-9223372036854775809", "123456789012345678901234567890", "0.1",
                           "1.50", "1E5", "1e-400", "-0.0", "2.5e+3", "0.1000000000000000055511151231257827"}) {
    CHECK(accepted(text).root().text == text);
  }
}

TEST_CASE("what is not JSON is refused with what would be right, at its place") {
  CHECK(refused("") == "1:1: the document is empty; expected a value");
  CHECK(refused("\n ") == "2:2: the document is empty; expected a value");
  CHECK(refused("\xEF\xBB\xBF") == "1:1: the document is empty; expected a value");
  CHECK(refused("\xEF\xBB") == "1:1: an incomplete byte order mark; the file must be saved as UTF-8");
  CHECK(refused("[1,\n ]") == std::string("2:2: unexpected \"]\" after a comma") + any_value);
  CHECK(refused("{\"a\":1,}") == "1:8: unexpected \"}\" after a comma; expected a key in double quotes");
  CHECK(refused("{\"a\" 1}") == "1:6: unexpected \"1\"; expected ':'");
  CHECK(refused("{a:1}") == "1:2: unexpected \"a\"; expected a key in double quotes");
  CHECK(refused("{'a':1}") == "1:2: text stands in double quotes, such as \"text\"");
  CHECK(refused("[1 2]") == "1:4: unexpected \"2\"; expected ',' or ']'");
  CHECK(refused("[1,2}") == "1:5: unexpected \"}\"; expected ',' or ']'");
  CHECK(refused("{\"a\":1 \"b\":2}") == "1:8: unexpected \"b\"; expected ',' or '}'");
  CHECK(refused("[2/5]") == "1:3: a fraction is written as a string, such as \"2/5\"");
  CHECK(refused("[.5]") == "1:2: a number starts with a digit or a minus sign, such as 0.5");
  CHECK(refused("[1.]") == "1:2: \"1.\" is not a number; digits must follow each sign, point and exponent");
  CHECK(refused("[NaN]") == std::string("1:2: unexpected \"NaN\"") + any_value);
  CHECK(refused("[tru3]") == std::string("1:2: unexpected \"tru3\"") + any_value);
  CHECK(refused("[1]//x") == "1:4: comments are not allowed in JSON");
  CHECK(refused("[1] [2]") == "1:5: unexpected \"[\"; expected the end of the document");
  CHECK(refused("[1]]") == "1:4: unexpected \"]\"; expected the end of the document");
  CHECK(refused("[1,2") == "1:5: the document ends too early; expected ',' or ']'");
  CHECK(refused("{\"a\"") == "1:5: the document ends too early; expected ':'");
  CHECK(refused("[\"a") == "1:2: a string without an end; close it with \"");
  CHECK(refused("[\"a\nb\"]") == "1:4: a line break inside a string; close the string with \", or write \\n");
  CHECK(refused("[\"\tb\"]") == "1:3: a control character inside a string; a tab is written \\t, others \\u00XX");
  CHECK(refused("[\"\\x\"]") == "1:4: an unknown escape; a backslash itself is written \\\\");
  CHECK(refused("[\"\\u12\"]") == "1:3: \\u must be followed by 4 hexadecimal digits");
  CHECK(refused("[\"" + std::string(1000, 'x') + "\" 1]").size() < 80);
}

TEST_CASE("columns are counted in characters") {
  CHECK(refused("{\"\xC3\xA9\xE2\x82\xAC\": x}").starts_with("1:8: "));
  CHECK(refused("\xEF\xBB\xBF[x]").starts_with("1:2: "));
  CHECK(refused("[\r\n x]").starts_with("2:2: "));
}

TEST_CASE("hostile: lone surrogates and invalid UTF-8") {
  CHECK(refused(R"(["\ud800"])").starts_with("1:3: half a surrogate pair"));
  CHECK(refused(R"(["\udc00"])").starts_with("1:3: half a surrogate pair"));
  CHECK(refused(R"(["\ud800\ud800"])").find("half a surrogate pair") != std::string::npos);
  CHECK(accepted(R"(["\ud83d\ude00"])").root().items[0].text == "\xF0\x9F\x98\x80");
  for (const char* bad : {"\xFF", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC3"}) {
    CHECK(refused("[\"" + std::string(bad) + "\"]") == "1:3: invalid UTF-8; the file must be saved as UTF-8");
    CHECK_FALSE(JsonDocument::parse("", bad));
    CHECK_FALSE(JsonDocument::parse("", "{\"" + std::string(bad) + "\": 1}"));
  }
}

TEST_CASE("hostile: a NUL byte anywhere, above all after the document") {
  CHECK(refused(std::string("[1]\0", 4)) == "1:4: a NUL byte; JSON is text, saved as UTF-8");
  CHECK(refused(std::string("[1]\0[2]", 7)) == "1:4: a NUL byte; JSON is text, saved as UTF-8");
  CHECK(refused(std::string("\0", 1)).starts_with("1:1: a NUL byte"));
  CHECK(refused(std::string("[\"\0\"]", 5)).starts_with("1:3: a NUL byte"));
  CHECK(accepted(R"(["\u0000"])").root().items[0].text == std::string("\0", 1));
}

TEST_CASE("hostile: duplicate keys") {
  CHECK(refused("{\"a\": 1,\n \"b\": 2,\n \"a\": 3}") ==
        "3:2: duplicate key \"a\"; each key may stand once in an object");
  CHECK(refused(R"([{"a": {"x": 1, "\u0078": 2}}])").starts_with("1:17: duplicate key \"x\""));
  CHECK(refused(R"({"": 1, "": 2})").starts_with("1:9: duplicate key \"\""));
  CHECK(accepted(R"({"a": {"a": 1}, "b": {"a": 1}})").root().items.size() == 2);

  std::string many = "{";
  for (int i = 0; i < 100'000; ++i) many += "\"k" + std::to_string(i) + "\":0,\n";
  CHECK(accepted(many + "\"z\":0}").root().keys.size() == 100'001);
  CHECK(refused(many + "\"z\":0,\"k7\":0,\"k6\":0}").starts_with("100001:7: duplicate key \"k7\""));
}

TEST_CASE("hostile: numbers above the largest double; below the smallest they are exact numbers") {
  CHECK(refused("[1e400]") == "1:2: the number \"1e400\" is too large; at most about 1.8e308");
  CHECK(refused("[" + std::string(5000, '9') + "]").size() < 120);
  Diagnostics diagnostics;
  const auto document = accepted("1e-400");
  CHECK(*Cursor(document, diagnostics).number() * *Exact::parse("1e400") == Exact(1));
}

TEST_CASE("hostile: too large, too deep, too many") {
  const JsonLimits limits{100, 4, 5};
  CHECK(refused(std::string(101, ' '), limits) == "0:0: too large; at most 100 bytes");
  CHECK(accepted("[[[[]]]]", limits).root().items.size() == 1);
  CHECK(refused("[[[ [\n  []]]]]", limits) == "2:3: nested too deep; at most 4 levels");
  CHECK(refused(R"({"a":{"b":{"c":{"d":{}}}}})", limits) == "1:21: nested too deep; at most 4 levels");
  CHECK(accepted("[1,2,3,4]", limits).root().items.size() == 4);
  CHECK(refused("[1,2,3,4,\"five\"]", limits) == "1:10: too many values; at most 5");
  CHECK(refused(std::string(100'000, '[')) == "1:33: nested too deep; at most 32 levels");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  CHECK(refused(objects) == "1:161: nested too deep; at most 32 levels");
}

TEST_CASE("hostile: after a limit the rest is not looked at") {
  const std::string bomb(16u << 20, '[');
  const auto start = std::chrono::steady_clock::now();
  CHECK_FALSE(JsonDocument::parse("", bomb));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
  CHECK(refused("[1,2,3 this is not even JSON", {100, 32, 2}) == "1:4: too many values; at most 2");
}

TEST_CASE("hostile: any truncation or changed byte of a document is refused or read, never a crash") {
  const std::string good = R"({"k": [1, -2.5e3, "t\u00e9\n", {"x": null}], "b": [true, false, ""]})";
  accepted(good);
  for (std::size_t i = 0; i < good.size(); ++i) CHECK_FALSE(JsonDocument::parse("", good.substr(0, i)));
  std::mt19937 random(5);
  for (int i = 0; i < 20'000; ++i) {
    std::string text = good;
    for (int changes = 1 + static_cast<int>(random() % 3); changes > 0; --changes) {
      text[random() % text.size()] =
          static_cast<char>(random() % 2 == 0 ? random() % 256 : good[random() % good.size()]);
    }
    const auto document = JsonDocument::parse("f", text);
    INFO("text " << text);
    REQUIRE(document.diagnostics.size() == (document ? 0 : 1));
    if (!document) {
      const Diagnostic& d = document.diagnostics[0];
      REQUIRE(d.line >= 1);
      REQUIRE(d.column >= 1);
      REQUIRE(d.message.size() < 250);
    }
  }
}

TEST_CASE("every key and value knows its line and column") {
  // Random documents are written with random blanks; what was written where is what must be said.
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    std::string text = round % 3 == 0 ? "\xEF\xBB\xBF" : "";
    int line = 1, column = 1;
    std::vector<std::pair<int, int>> places;
    const auto put = [&](std::string_view piece) {
      for (const char c : piece) {
        text += c;
        if (c == '\n') {
          ++line;
          column = 1;
        } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {
          ++column;
        }
      }
    };
    const auto blank = [&] {
      for (auto n = random() % 3; n > 0; --n) put(random() % 3 == 0 ? "\n" : random() % 2 == 0 ? " " : "\t");
    };
    const auto token = [&](std::string_view piece) {
      blank();
      places.emplace_back(line, column);
      put(piece);
      blank();
    };
    const std::vector<std::string> scalars{
        "1", "-2.5e-3", "true", "null", "\"\"", "\"[,]{:}\\\"\\\\\"", "\"\xE2\x82\xAC\"", "false"};
    const std::function<void(int)> value = [&](int depth) {
      const auto kind = depth == 0 ? 0 : random() % 3;
      if (kind == 0) return token(scalars[random() % scalars.size()]);
      token(kind == 1 ? "[" : "{");
      const auto count = random() % 4;
      for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) put(",");
        if (kind == 2) {
          token("\"k\\\"" + std::to_string(i) + "\"");
          put(":");
        }
        value(depth - 1);
      }
      put(kind == 1 ? "]" : "}");
    };
    value(4);
    blank();
    INFO("round " << round << "\n" << text);
    const auto document = accepted(text);
    std::size_t seen = 0;
    const std::function<void(const Json&)> check = [&](const Json& json) {
      ++seen;
      REQUIRE(document.line_and_column(json.token) == places.at(json.token));
      for (std::size_t i = 0; i < json.items.size(); ++i) {
        if (json.kind == Json::Kind::object) {
          ++seen;
          REQUIRE(document.line_and_column(json.key_tokens[i]) == places.at(json.key_tokens[i]));
        }
        check(json.items[i]);
      }
    };
    check(document.root());
    REQUIRE(seen == places.size());
  }
}

TEST_CASE("a JSON string literal is read back as what it was") {
  const std::string all = [] {
    std::string text;
    for (int c = 1; c < 128; ++c) text += static_cast<char>(c);
    return text + "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80" + std::string("\0", 1);
  }();
  CHECK(accepted(json_quote(all)).root().text == all);
  CHECK(json_quote("a\"b\\c\n") == R"("a\"b\\c\n")");
  // What a terminal obeys, or what turns the direction of text, is escaped, though JSON would take it as it is.
  const std::string obeyed = "\x1B\x7F\xC2\x9B\xE2\x80\xA8\xE2\x80\xAE\xE2\x81\xA9";
  CHECK(json_quote(obeyed) == R"("\u001b\u007f\u009b\u2028\u202e\u2069")");
  CHECK(accepted(json_quote(obeyed)).root().text == obeyed);
  CHECK(json_quote("x\xFFy\xED\xA0\x80") == "\"x\xEF\xBF\xBDy\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"");
}
