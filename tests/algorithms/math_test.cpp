// Formulas: what is read, what is a mistake, and the three ways out.
#include <catch2/catch.hpp>
#include <random>

#include "algorithms/curves.hpp"
#include "algorithms/math.hpp"
#include "algorithms/narrate.hpp"
#include "algorithms/typeset.hpp"

using namespace blossom;

namespace {

Math formula(std::string_view tex) {
  MathMistake mistake;
  const auto made = parse_math(tex, mistake);
  INFO(tex << ": " << mistake.at << ": " << mistake.what);
  REQUIRE(made);
  return *made;
}

std::string mistake_in(std::string_view tex) {
  MathMistake mistake;
  REQUIRE(!parse_math(tex, mistake));
  REQUIRE(mistake.at <= tex.size());
  return std::to_string(mistake.at) + ": " + mistake.what;
}

std::string plain(std::string_view tex) { return plain_math(formula(tex)); }

// A random formula in TeX that uses everything there is.
class Formulas {
 public:
  explicit Formulas(unsigned seed) : random_(seed) {}

  std::string row(int levels) {
    std::string tex;
    for (int i = 0, n = 1 + below(3); i < n; ++i) tex += item(levels);
    return tex;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string pick(const std::vector<std::string>& some) {
    return some[static_cast<std::size_t>(below(static_cast<int>(some.size())))];
  }
  std::string group(int levels) { return "{" + row(levels - 1) + "}"; }
  std::string base(int levels) {
    if (levels <= 0 || below(2) == 0)
      return pick({"x",
                   "P",
                   "12",
                   "0.25",
                   "+",
                   "-",
                   "=",
                   "<",
                   "(",
                   ")",
                   "[",
                   "]",
                   "|",
                   ",",
                   ";",
                   ":",
                   "!",
                   "/",
                   "'",
                   "\\alpha ",
                   "\\Omega ",
                   "\\cdot ",
                   "\\le ",
                   "\\sum ",
                   "\\int ",
                   "\\sin ",
                   "\\max ",
                   "\\ldots ",
                   "\\text{if so}",
                   "\\mathbf{P}",
                   "\\mathrm{d}",
                   "\\,",
                   "\\quad ",
                   "\\{",
                   "\\}",
                   "\\infty ",
                   "."});
    switch (below(7)) {
      case 0:
        return "\\frac" + group(levels) + group(levels);
      case 1:
        return "\\binom" + group(levels) + group(levels);
      case 2:
        return "\\sqrt" + group(levels);
      case 3:
        return "\\sqrt[{" + row(levels - 1) + "}]" + group(levels);
      case 4:
        return pick({"\\bar", "\\vec", "\\hat"}) + group(levels);
      case 5:
        return "\\left" + pick({"(", "[", "|", "\\{", "."}) + row(levels - 1) + "\\right" +
               pick({")", "]", "|", "\\}", "."});
      default:
        return group(levels);
    }
  }
  std::string item(int levels) {
    std::string tex = base(levels);
    if (tex == "'") return "{'}";
    if (levels > 0 && below(3) == 0) tex += "_" + group(levels);
    if (below(4) == 0) tex += "'";
    if (levels > 0 && below(3) == 0) tex += "^" + group(levels);
    return tex;
  }
  std::mt19937 random_;
};

}  // namespace

TEST_CASE("formulas: letters, numbers and scripts", "[math]") {
  const Math row = formula("P_{i}^{(r)} = 2x");
  REQUIRE(row.kind == Math::Kind::row);
  REQUIRE(row.parts.size() == 4);
  CHECK(row.parts[0].kind == Math::Kind::scripts);
  CHECK(row.parts[0].parts[0].text == "P");
  CHECK(row.parts[0].parts[1].text == "i");
  CHECK(row.parts[0].parts[2].parts.size() == 3);
  CHECK(row.parts[1].of == Math::Class::relation);
  CHECK(row.parts[2].of == Math::Class::number);
  // Blanks mean nothing, and scripts may come in either order.
  CHECK(formula("P ^ { ( r ) } _ i=2 x") == row);
  CHECK(formula("0.25").parts.size() == 1);
  // A script without braces is one character.
  CHECK(formula("x^12") == formula("x^{1}2"));
  CHECK(formula("\\frac12") == formula("\\frac{1}{2}"));
  CHECK(formula("f'") == formula("f^{'}"));
}

TEST_CASE("formulas: as plain text", "[math]") {
  CHECK(plain("\\frac{u - u_3}{u_6 - u_3}") == "(u - u₃)/(u₆ - u₃)");
  CHECK(plain("P_{2}^{(1)}") == "P₂⁽¹⁾");
  CHECK(plain("-x+1") == "-x + 1");
  CHECK(plain("x=-\\frac{3}{5}") == "x = -3/5");
  CHECK(plain("(3,\\frac{1}{2})") == "(3, 1/2)");
  CHECK(plain("\\sum_{i=0}^{n} B_{i,n}(u) P_i") == "∑_{i=0}^n B_{i,n}(u)P_i");
  CHECK(plain("\\sqrt{a+b} \\cdot \\sqrt[3]{2}") == "√(a + b) ⋅ ³√2");
  CHECK(plain("\\binom{n}{i}") == "(n choose i)");
  CHECK(plain("\\bar{U}") == "U\u0304");
  CHECK(plain("f''(u) \\ne 0") == "f′′(u) ≠ 0");
  CHECK(plain("\\sin x + \\cos(x)") == "sin x + cos(x)");
  CHECK(plain("\\left\\{ \\frac{1}{2} \\right.") == "{1/2");
  CHECK(plain("a \\text{ if } b") == "a if b");
}

TEST_CASE("formulas: as MathML", "[math]") {
  CHECK(mathml(formula("x<1")) == "<math alttext=\"x &lt; 1\"><mrow><mi>x</mi><mo>&lt;</mo><mn>1</mn></mrow></math>");
  CHECK(mathml(formula("\\frac{1}{u_3}"), true) ==
        "<math display=\"block\" alttext=\"1/u₃\"><mfrac><mn>1</mn><msub><mi>u</mi><mn>3</mn></msub></mfrac></math>");
  CHECK(mathml(formula("\\sum_{i=0}^{n}")).find("<munderover><mo>∑</mo>") != std::string::npos);
  CHECK(mathml(formula("\\int_0^1")).find("<msubsup><mo>∫</mo>") != std::string::npos);
  CHECK(mathml(formula("\\mathbf{P}")).find("<mi>\U0001D40F</mi>") != std::string::npos);
  CHECK(mathml(formula("\\text{<b>\"&}")).find("<mtext>&lt;b&gt;&quot;&amp;</mtext>") != std::string::npos);
}

TEST_CASE("formulas: LaTeX reads back as the same formula", "[math]") {
  CHECK(latex(formula("\\frac12 x")) == "\\frac{1}{2}x");
  CHECK(latex(formula("\\alpha_i \\le \\beta")) == "\\alpha_{i}\\le \\beta");
  const unsigned seed = std::random_device{}();
  INFO("seed " << seed);
  Formulas formulas(seed);
  for (int i = 0; i < 2000; ++i) {
    const std::string tex = formulas.row(2);
    if (tex.size() > 800) continue;
    INFO(tex);
    const Math math = formula(tex);
    INFO(latex(math));
    CHECK(formula(latex(math)) == math);
    // The ways out of every formula are valid: each element is closed by its own end.
    std::vector<std::string> open;
    const std::string page = mathml(math);
    for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
      const std::size_t end = page.find_first_of(" >", at);
      if (page[at + 1] != '/') {
        open.push_back(page.substr(at + 1, end - at - 1));
        continue;
      }
      REQUIRE(!open.empty());
      REQUIRE(open.back() == page.substr(at + 2, end - at - 2));
      open.pop_back();
    }
    CHECK(open.empty());
  }
}

TEST_CASE("formulas: mistakes say where and what would be right", "[math]") {
  CHECK(mistake_in("") == "0: the formula is empty");
  CHECK(mistake_in("x_1_2") == "3: two subscripts at one thing; write x_{ab} or {x_{a}}_{b}");
  CHECK(mistake_in("a + \\frca{1}{2}") == "4: there is no command \\frca in formulas here; did you mean \\frac?");
  CHECK(mistake_in("\\leq") == "0: there is no command \\leq in formulas here; write \\le");
  CHECK(mistake_in("\\frac{1}") == "8: something is missing at the end of the formula");
  CHECK(mistake_in("{x") == "0: a { has no } behind it");
  CHECK(mistake_in("x}") == "1: a } has no { before it; a brace that is to be seen is \\}");
  CHECK(mistake_in("2*3") == "1: * is written \\cdot or \\times");
  CHECK(mistake_in("α") == "0: α is written \\alpha");
  CHECK(mistake_in("\\left( x").starts_with("0: \\left has no \\right"));
  CHECK(mistake_in("x \\right)").starts_with("2: \\right has no \\left"));
  CHECK(mistake_in("^2").starts_with("0: ^ needs something before it"));
  CHECK(mistake_in("\\text{a\\b}").starts_with("7: "));
  CHECK(mistake_in("\\").starts_with("0: "));
  CHECK(mistake_in("\\input{/etc/passwd}").starts_with("0: there is no command \\input"));
}

TEST_CASE("formulas: hostile ones are bounded", "[math]") {
  const auto repeated = [](std::string_view text, int times) {
    std::string made;
    for (int i = 0; i < times; ++i) made += text;
    return made;
  };
  CHECK(mistake_in(repeated("x", 2001)) == "2000: a formula has at most 2000 bytes");
  CHECK(mistake_in(repeated("{", 1000)).find("24 levels deep") != std::string::npos);
  CHECK(mistake_in(repeated("\\sqrt", 400)).find("24 levels deep") != std::string::npos);
  CHECK(mistake_in(repeated("\\left(", 300)).find("24 levels deep") != std::string::npos);
  CHECK(mistake_in(repeated("x^{", 600)).find("24 levels deep") != std::string::npos);
  CHECK(formula(repeated("{", 20) + "x" + repeated("}", 20)) == formula("x"));
  const unsigned seed = std::random_device{}();
  INFO("seed " << seed);
  std::mt19937 random(seed);
  // Whatever the bytes are, there is a formula or a mistake within them.
  const std::string_view pieces =
      "\\{}^_'[]()|.&%#$~ \n\x01\xCE\xB1"
      "frac2left";
  for (int i = 0; i < 20'000; ++i) {
    std::string tex;
    for (auto n = random() % 24; n > 0; --n) tex += pieces[random() % pieces.size()];
    MathMistake mistake;
    const auto math = parse_math(tex, mistake);
    if (math) {
      MathMistake none;
      const auto again = parse_math(latex(*math), none);
      INFO(tex << " -> " << latex(*math));
      REQUIRE(again);
      REQUIRE(*again == *math);
    } else {
      REQUIRE(!mistake.what.empty());
      REQUIRE(mistake.at <= tex.size());
    }
  }
}

TEST_CASE("formulas in running text end at their partner", "[math]") {
  CHECK(end_of_math("a $x$ b", 2) == 5u);
  CHECK(end_of_math("$$a$ b$$", 0) == 8u);
  CHECK(end_of_math("$a\\$b$", 0) == 6u);
  CHECK(end_of_math("$a\nb$", 0) == 5u);
  CHECK(!end_of_math("$a\n \nb$", 0));
  CHECK(!end_of_math("$a", 0));
  CHECK(end_of_code("`a` b", 0) == 3u);
  CHECK(end_of_code("``a`b``", 0) == 7u);
  CHECK(!end_of_code("``a`", 0));
}

TEST_CASE("formulas: values and names as TeX", "[math]") {
  CHECK(tex_value("3/5") == "\\frac{3}{5}");
  CHECK(tex_value("-3/5") == "-\\frac{3}{5}");
  CHECK(tex_value("(3, 1/2)") == "(3, \\frac{1}{2})");
  CHECK(tex_value("0.25") == "0.25");
  CHECK(tex_value("-1e-07") == "-1 \\cdot 10^{-7}");
  CHECK(tex_value("1.5e+12") == "1.5 \\cdot 10^{12}");
  CHECK(tex_value("(1, 2), w = 2") == "(1, 2), w = 2");
  CHECK(tex_value("no point, w = 0") == "\\text{no point}, w = 0");
  for (const std::string_view shown :
       {"(3, -1/2)", "at infinity, direction (1, 0)", "(1, 2, 2): (1/2, 1), w = 2", "2e+20"})
    CHECK(!formula(tex_value(shown)).parts.empty());
  const Algorithm& algorithm = *find_algorithm("de_casteljau");
  CHECK(tex_name(typeset_name({Symbol::of("P"), {1, 3}, 2}, algorithm)) == "P_{3}^{(1)}");
  CHECK(tex_name(typeset_name({Symbol::of("P"), {0, 3}, 2}, algorithm)) == "P_{3}");
  CHECK(tex_name(typeset_text("alpha[1][2]", algorithm)) == "\\alpha_{2}^{(1)}");
}

TEST_CASE("formulas: a lesson fills its values in", "[math]") {
  const Run<Exact> run =
      test::run_of("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [1, "1/2"], [2, -3]]}, "u": "2/5"})");
  const Narrator<Exact> narrator(run);
  const auto step = run.trace.value(*run.trace.find("P[1][1]")).step;
  const auto filled = [&](std::string_view say) {
    std::vector<std::string> errors;
    const std::string text = narrator.fill(say, step, &errors);
    CHECK(errors.empty());
    return text;
  };
  CHECK(filled("{u}: $u = \\value{u}$") == "2/5: $u = \\frac{2}{5}$");
  CHECK(filled("$\\name{P[r][i]} = \\value{P[r][i]}$") == "$P_{1}^{(1)} = (\\frac{7}{5}, -\\frac{9}{10})$");
  CHECK(filled("$\\name{name} = \\value{value}$") == "$P_{1}^{(1)} = (\\frac{7}{5}, -\\frac{9}{10})$");
  CHECK(filled("$$\\name{P[r-1][i]}\\value{r}^\\value{i}$$") == "$$P_{1}{1}^{1}$$");
  CHECK(filled("$\\frac{1}{2}$ \\$ {r}") == "$\\frac{1}{2}$ \\$ 1");
  CHECK(filled("`$` {r} $\\value{r}$") == "`$` 1 $1$");
  CHECK(filled("costs $ {r}") == "costs $ 1");
  std::vector<std::string> errors;
  CHECK(narrator.fill("$\\value{Q[7]} + \\value{formula}$ {Z}", step, &errors) ==
        "$\\value{Q[7]} + \\value{formula}$ {Z}");
  CHECK(errors == std::vector<std::string>{"Q[7]", "formula", "Z"});
}
