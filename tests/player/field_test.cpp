#include "player/field.hpp"

#include <catch2/catch.hpp>

#include "player/session.hpp"

using namespace blossom;

TEST_CASE("a field shows the value of the model until something is typed over it") {
  FieldTexts fields;
  CHECK(fields.text("u", "2/5") == "2/5");
  fields.type("u", "2/5", "2/");
  CHECK(fields.text("u", "2/5") == "2/");
  CHECK(fields.error("u", "2/5").empty());
  CHECK(fields.text("curve.knots[4]", "1") == "1");
}

TEST_CASE("a refused text stays with what is wrong with it until it is corrected or dropped") {
  FieldTexts fields;
  fields.refuse("u", "2/5", "7", "u must lie in the domain [0, 1]");
  CHECK(fields.text("u", "2/5") == "7");
  CHECK(fields.error("u", "2/5") == "u must lie in the domain [0, 1]");
  CHECK(fields.says("u must lie in the domain [0, 1]"));

  SECTION("typing on takes the message away, not the text") {
    fields.type("u", "2/5", "0.7");
    CHECK(fields.text("u", "2/5") == "0.7");
    CHECK(fields.error("u", "2/5").empty());
  }
  SECTION("dropped, it is the value again") {
    fields.drop("u");
    CHECK(fields.text("u", "2/5") == "2/5");
    CHECK(fields.empty());
  }
  SECTION("an edit from elsewhere makes it void") {
    CHECK(fields.text("u", "1/2") == "1/2");
    CHECK(fields.error("u", "1/2").empty());
  }
  SECTION("an edit of another field leaves it") {
    fields.accept("curve.knots[4]");
    CHECK(fields.text("u", "2/5") == "7");
  }
}

TEST_CASE("what was said of a button is over with the next edit that is taken") {
  FieldTexts fields;
  fields.refuse("curve.points[1]", "", "", "a curve has at least 2 control points");
  fields.accept("u");
  CHECK(fields.empty());
}

TEST_CASE("a row of a table knows whether one of its fields holds a text") {
  FieldTexts fields;
  fields.type("curve.points[12][1]", "3", "x");
  CHECK(fields.holds("curve.points[12]"));
  CHECK(fields.holds("curve.points[12][1]"));
  CHECK_FALSE(fields.holds("curve.points[1]"));
  CHECK_FALSE(fields.holds("curve.points[2]"));
  CHECK_FALSE(fields.holds("curve.weights[12]"));
}

TEST_CASE("numbers are typed with blanks and with the minus of books") {
  CHECK(typed_number(" 2 / 5 ") == Exact::ratio(2, 5));
  CHECK(typed_number("\u22120.5") == Exact::ratio(-1, 2));
  CHECK(typed_number("3") == Exact(3));
  for (const char* text : {"", " ", "abc", "1/0", "0,5", "2/5/7", "1..2", "u"}) {
    INFO(text);
    CHECK_FALSE(typed_number(text));
  }
}

TEST_CASE("numbers are shown exactly and as short as people write them") {
  const auto shown = [](const char* text, NumberStyle style) { return number_text(*Exact::parse(text), style); };
  const NumberStyle u = NumberStyle::parameter, x = NumberStyle::coordinate;
  CHECK(shown("0.4", u) == "2/5");
  CHECK(shown("0.37", u) == "0.37");
  CHECK(shown("0.45", u) == "0.45");
  CHECK(shown("1/64", u) == "1/64");
  CHECK(shown("1/3", u) == "1/3");
  CHECK(shown("-7", u) == "-7");
  CHECK(shown("2.5", x) == "2.5");
  CHECK(shown("137/100", x) == "1.37");
  CHECK(shown("1/3", x) == "1/3");
  CHECK(shown("-1/1024", x) == "-1/1024");
  for (const char* text : {"0.4", "22/7", "1/3", "-0.0625", "12345.678", "1/1024", "1e-9", "7/12"})
    for (const NumberStyle style : {u, x}) {
      INFO(text);
      CHECK(typed_number(shown(text, style)) == Exact::parse(text));
    }
}

TEST_CASE("the arrow keys count in the last place") {
  CHECK(nudged("3", 1) == "4");
  CHECK(nudged("0.40", 1) == "0.41");
  CHECK(nudged("0.99", 1) == "1.00");
  CHECK(nudged("0.0", -1) == "-0.1");
  CHECK(nudged("-0.05", 1) == "-0.04");
  CHECK(nudged("-1", 1) == "0");
  CHECK(nudged("2/5", 1) == "3/5");
  CHECK(nudged("2/4", 1) == "3/4");
  CHECK(nudged("5.", 1) == "6");
  CHECK_FALSE(nudged("abc", 1));
  CHECK_FALSE(nudged("1e3", 1));
}

TEST_CASE("undo takes half-typed texts along, for what they were about is gone") {
  auto document = open_document(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "tests/play/data/22-de-boor.json");
  REQUIRE(document);
  auto session = Session::open(std::move(*document), true);
  REQUIRE(session);
  Session& s = **session;
  REQUIRE(s.edit(set_number(s.algorithm(), s.inputs(), "u", s.inputs().curve("curve").domain_begin()), "u"));
  s.fields().refuse("u", "0", "x", "no number");
  REQUIRE(s.undo());
  CHECK(s.fields().empty());
}
