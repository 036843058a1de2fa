// Names and formulas as they stand in books.
#include "algorithms/typeset.hpp"

#include <catch2/catch.hpp>

#include "trace/rule.hpp"

using namespace blossom;

namespace {

// Runs as text: *italic*, _{sub}, ^{super}.
std::string marked(const RichText& runs) {
  std::string text;
  for (const TextRun& run : runs) {
    if (run.level == TextRun::Level::sub)
      text += "_{" + run.text + "}";
    else if (run.level == TextRun::Level::super)
      text += "^{" + run.text + "}";
    else
      text += run.italic ? "*" + run.text + "*" : run.text;
  }
  return text;
}

const Algorithm& algorithm(std::string_view id) {
  const auto* found = find_algorithm(id);
  REQUIRE(found != nullptr);
  return *found;
}

std::string set(std::string_view text, std::string_view id = "de_boor") {
  return marked(typeset_text(text, algorithm(id)));
}
std::string set_name(const Name& name, std::string_view id) { return marked(typeset_name(name, algorithm(id))); }

}  // namespace

TEST_CASE("A point of a triangular scheme has its index below and its level above") {
  CHECK(set_name("P"_v(1, 4), "de_boor") == "*P*_{4}^{(1)}");
  CHECK(set_name("P"_v(0, 4), "de_boor") == "*P*_{4}");  // level 0: the control point itself
  CHECK(set_name("alpha"_v(2, 3), "de_boor") == "*α*_{3}^{(2)}");
  CHECK(set_name("P"_v(2, 0), "de_casteljau") == "*P*_{0}^{(2)}");
}

TEST_CASE("Other names have all their indices below, or none") {
  CHECK(set_name("k"_v(), "de_boor") == "*k*");
  CHECK(set_name("C"_v(), "de_boor") == "*C*");
  CHECK(set_name("U"_v(), "de_boor") == "*U*");
  CHECK(set_name("P"_v(2, 3), "skinning") == "*P*_{2,3}");  // row and column of a net: no level
}

TEST_CASE("Names in running text are set, the words around them are left alone") {
  CHECK(set("Divide P[0][1] and P[0][2] at alpha[1][2] = 4/5.") ==
        "Divide *P*_{1} and *P*_{2} at *α*_{2}^{(1)} = 4/5.");
  CHECK(set("P[r][i] = (1-alpha[r][i]) P[r-1][i-1]") == "*P*_{i}^{(r)} = (1-*α*_{i}^{(r)}) *P*_{i-1}^{(r-1)}");
  CHECK(set("u lies in [u_k, u_{k+1}), so k = 4") == "*u* lies in [*u*_{k}, *u*_{k+1}), so *k* = 4");
  CHECK(set("(u_{i+p-r+1} - u_i)") == "(*u*_{i+p-r+1} - *u*_{i})");
  CHECK(set("P[1][*] and P[0][1..4]") == "*P*_{*}^{(1)} and *P*_{1..4}");
  CHECK(set("the end is P[3][4]. Then go on.") == "the end is *P*_{4}^{(3)}. Then go on.");
}

TEST_CASE("Words stay words") {
  for (const std::string words :
       {"A curve of degree three, and a knot vector.", "Let's see the curve's end; it isn't a Bézier curve.",
        "upper, kept, Cut, spans", "[0, 1), (2, 3)", "an unclosed [bracket", "", "café Ünïcödé",
        "no index: word[] and word["}) {
    INFO(words);
    CHECK(set(words).find('*') == std::string::npos);
    CHECK(set(words).find('^') == std::string::npos);
  }
  CHECK(set("Let's see the curve's end; it isn't Bézier.") == "Let's see the curve's end; it isn't Bézier.");
  CHECK(set("an unclosed [bracket and u_{").find("an unclosed [bracket and ") == 0);
}

TEST_CASE("A and I at the beginning of a sentence are words, where a value has their name") {
  const auto set = [](std::string_view text) {
    static const Algorithm table = [] {
      Algorithm made;
      made.id = "a_table";
      made.values = {{"A", {}, "a point"}, {"I", {}, "an integral"}, {"a", {}, "a scale"}};
      return made;
    }();
    return marked(typeset_text(text, table));
  };
  for (const std::string words :
       {"A curve is smooth.", "It ends. A line crosses it: A tangent, too.", "(A point)", "Then I see.\nA knot"}) {
    INFO(words);
    CHECK(set(words) == words);
  }
  CHECK(set("A = 3, and I = 4") == "*A* = 3, and *I* = 4");
  CHECK(set("A is near. Go from A to B, past the point A there.") ==
        "*A* is near. Go from *A* to B, past the point *A* there.");
  CHECK(set("A, I") == "*A*, *I*");
  CHECK(set("Set a tolerance: a times A, with a = 2.") == "Set a tolerance: *a* times *A*, with *a* = 2.");
  CHECK(set("A u") == "*A* u");
}

TEST_CASE("A single knot is a small u, as in the formulas of books") {
  CHECK(set_name("U"_v(7), "de_boor") == "*u*_{7}");
  CHECK(set_name("U"_v(1, 7), "skinning") == "*u*_{1,7}");
  CHECK(set("U[3] = 0", "knot_insertion") == "*u*_{3} = 0");
  CHECK(set_name("U"_v(7), "skinning") == "*U*_{7}");  // there it may also be the knot vector of a profile
}

TEST_CASE("The phase of a name stands before it") {
  CHECK(set("raise[1].Q[2] is made", "skinning") == "raise_{1}.*Q*_{2} is made");
  CHECK(set("elevate[1].P[0][2]", "degree_elevation") == "elevate_{1}." + set("P[0][2]", "degree_elevation"));
  CHECK(set("a[1].b[2].Q[2]", "skinning") == "a_{1}.b_{2}.*Q*_{2}");
}

TEST_CASE("Basis functions and homogeneous coordinates are set as such") {
  CHECK(set("N_(3,2)(v[3])", "skinning") == "*N*_{3,2}(*v*_{3})");
  CHECK(set("(wx, wy) / w of P[2][0]", "de_casteljau") == "(*wx*, *wy*) / *w* of *P*_{0}^{(2)}");
}

TEST_CASE("In messages a name is one line of plain text") {
  const auto plain = [](std::string_view text, std::string_view id) {
    return unicode_text(typeset_text(text, algorithm(id)));
  };
  CHECK(plain("P[1][12] moved", "de_boor") == "P₁₂⁽¹⁾ moved");
  CHECK(plain("P[0][3]", "de_boor") == "P₃");
  CHECK(plain("alpha[2][3] and U[4]", "de_boor") == "α₃⁽²⁾ and u₄");
  CHECK(plain("Q[1][2]", "skinning") == "Q₁,₂");
  CHECK(plain("P[r][i], u_{k+1}", "de_boor") == "P_i^{(r)}, u_{k+1}");
  CHECK(plain_name("Ubar"_v(), algorithm("knot_insertion")) == "Ū");
}

TEST_CASE("Text that goes in comes out, whatever it is") {
  for (const std::string text :
       {"u_", "u_{", "u_}", "P[", "P[]", "P[1", "P[1]]", "P[1][2][3]", "alpha", "\xff\xfe u", "_u_"}) {
    INFO(text);
    std::string letters;
    for (const TextRun& run : typeset_text(text, algorithm("de_boor"))) letters += run.text;
    const std::string expected = text == "alpha" ? "α" : text;
    for (const char c : expected)
      if (std::string("[]_{}").find(c) == std::string::npos) CHECK(letters.find(c) != std::string::npos);
  }
}
