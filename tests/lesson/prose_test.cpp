// What lessons say: what is Markdown in it, what is only text, and the ways out.
#include <catch2/catch.hpp>
#include <random>

#include "lesson/catalog.hpp"
#include "lesson/prose.hpp"

using namespace blossom;

namespace {

const Algorithm& algorithm() { return *find_algorithm("de_casteljau"); }

Prose read(std::string_view text) {
  std::vector<ProseMistake> mistakes;
  Prose prose = read_prose(text, &mistakes);
  INFO(text);
  for (const ProseMistake& mistake : mistakes) FAIL(mistake.at << ": " << mistake.what);
  return prose;
}

std::string mistakes_in(std::string_view text) {
  std::vector<ProseMistake> mistakes;
  read_prose(text, &mistakes);
  std::string all;
  for (const auto& [at, what] : mistakes) {
    REQUIRE(at <= text.size());
    all += (all.empty() ? "" : "\n") + std::to_string(at) + ": " + what;
  }
  return all;
}

std::string html(std::string_view text) { return prose_html(read(text), algorithm()); }
std::string as_latex(std::string_view text) { return prose_latex(read(text), algorithm()); }
std::string words(const RichText& runs) {
  std::string text;
  for (const TextRun& run : runs) text += run.text;
  return text;
}

bool same(const Prose& a, const Prose& b) {
  const auto same_span = [](const Span& x, const Span& y) {
    return x.kind == y.kind && x.text == y.text && x.bold == y.bold && x.italic == y.italic && x.link == y.link &&
           (x.math == nullptr) == (y.math == nullptr) && (x.math == nullptr || *x.math == *y.math);
  };
  return std::ranges::equal(a, b, [&](const Block& x, const Block& y) {
    return x.kind == y.kind && x.level == y.level && x.number == y.number &&
           std::ranges::equal(x.spans, y.spans, same_span);
  });
}

}  // namespace

TEST_CASE("prose: text with the signs of names and formulas is only text", "[prose]") {
  for (const std::string text : {"P[1][*] and P[2][*]",
                                 "u_4 = 1/4 lies between u_3 and u_5.",
                                 "(a, b) * 2 = (2 a, 2 b)",
                                 "2*3*4, a*b and *",
                                 "N[0](u) + P[1](u) in [0, 1]",
                                 "alpha[1..2][*], *[2]",
                                 "a < b and b > c, a<b>c",
                                 "f(x)*g(x)*h(x)",
                                 "de Boor's P[0][1], Q[r][i+1]",
                                 "a & b &amp; c",
                                 "x = -3/5",
                                 "1/2 - 1/3",
                                 "100% #1 at home!",
                                 "u_(k+1) ~ v",
                                 "{placeholder} stays",
                                 "see [1] and [u_3, u_4)",
                                 "P* and Q*",
                                 "1998. A year",
                                 "| a | = 3",
                                 "https://a.b stays"}) {
    INFO(text);
    const Prose prose = read(text);
    REQUIRE(prose.size() == 1);
    CHECK(prose[0].kind == Block::Kind::paragraph);
    CHECK(plain_text(prose) == text);
    CHECK(same(read(prose_markdown(prose)), prose));
  }
}

TEST_CASE("prose: bold, emphasis, code, links", "[prose]") {
  const Prose prose = read("a **bold *both*** *em* `P[1] *x*` [words *here*](https://w3.org/x_(y)) \\*star\\* \\$5");
  REQUIRE(prose.size() == 1);
  CHECK(html("**P[1][2]** and *u_3*") ==
        "<p><strong><i>P</i><sub>2</sub><sup>(1)</sup></strong> and <em><i>u</i><sub>3</sub></em></p>\n");
  CHECK(html("`a < b*c*`") == "<p><code>a &lt; b*c*</code></p>\n");
  CHECK(html("[the page](notes.html#u)") == "<p><a href=\"notes.html#u\">the page</a></p>\n");
  CHECK(html("(*so*), \"**this**\"") == "<p>(<em>so</em>), &quot;<strong>this</strong>&quot;</p>\n");
  CHECK(plain_text(read("\\*star\\* costs \\$5, \\`tick\\` \\[a\\](b) \\\\")) == "*star* costs $5, `tick` [a](b) \\");
  CHECK(as_latex("**50%** of `a_b` \\$") == "\\textbf{50\\%} of \\texttt{a\\_b} \\$\n");
  CHECK(as_latex("P[1][2] is {x}") == "$P_{2}^{(1)}$ is \\{x\\}\n");
}

TEST_CASE("prose: paragraphs and lists", "[prose]") {
  const Prose prose =
      read("First\nstill first.\n\nSecond:\n\n- one\n- two\n  - deep\n\n    more\n- three\n\n1. a\n2. b\n\nEnd.");
  std::string shape;
  for (const Block& block : prose)
    shape += (block.kind == Block::Kind::item ? (block.number > 0 ? std::to_string(block.number) : "-") : "p") +
             std::to_string(block.level) + " ";
  CHECK(shape == "p0 p0 -0 -0 -1 p2 -0 10 20 p0 ");
  CHECK(prose[0].spans[0].text == "First still first.");
  CHECK(plain_text(read("- one\n- two")) == "- one\n- two");
  CHECK(html("- one\n  - deep\n- two\n\n3. three") ==
        "<ul>\n<li>one<ul>\n<li>deep</li></ul>\n</li>\n<li>two</li></ul>\n<ol start=\"3\">\n<li>three</li></ol>\n");
  CHECK(as_latex("- one\n- [x] two") == "\\begin{itemize}\n\\item one\n\\item {}[x] two\n\\end{itemize}\n");
  CHECK(words(rich_text(read("Now:\n\n- one\n- two"), algorithm())) == "Now:\n• \tone\n• \ttwo");
  CHECK(same(read(prose_markdown(prose)), prose));
}

TEST_CASE("prose: formulas", "[prose]") {
  const Prose prose = read("So $u_{3}x$ is $a$$b$ and\n$$\\frac{1}{2}$$\nat **$x$**.");
  REQUIRE(prose.size() == 3);
  CHECK(prose[0].spans.size() == 6);
  CHECK(prose[0].spans[1].math != nullptr);
  CHECK(prose[1].kind == Block::Kind::formula);
  CHECK(prose[2].spans[1].bold);
  CHECK(plain_text(prose) == "So u₃x is ab and\n    1/2\nat x.");
  CHECK(html("$x<1$").find("<mo>&lt;</mo>") != std::string::npos);
  CHECK(html("$$x$$").find("<div class=\"formula\"><math display=\"block\"") == 0);
  CHECK(as_latex("$\\frac12$ and $$x$$") == "$\\frac{1}{2}$ and\n\\[x\\]\n");
  const RichText runs = rich_text(read("a $x^2$\n\n$$y$$"), algorithm());
  const auto formulas = std::ranges::count_if(runs, [](const TextRun& run) { return run.math != nullptr; });
  CHECK(formulas == 2);
  CHECK_FALSE(runs[1].display);
  CHECK(runs.back().display);
  CHECK(runs[1].text == "x²");
  CHECK(same(read(prose_markdown(prose)), prose));
}

TEST_CASE("prose: mistakes say where and what would be right", "[prose]") {
  CHECK(mistakes_in("costs $5") == "6: a $ has no partner in its paragraph; write \\$ for the sign");
  CHECK(mistakes_in("a $x\n\ny$").starts_with("2: a $ has no partner"));
  CHECK(mistakes_in("see $\\frca{1}{2}$") == "5: there is no command \\frca in formulas here; did you mean \\frac?");
  CHECK(mistakes_in("# Title").starts_with("0: there are no headings here"));
  CHECK(mistakes_in("a\n> b").starts_with("2: there are no quotes here"));
  CHECK(mistakes_in("```\ncode\n```").starts_with("0: there are no blocks of code here"));
  CHECK(mistakes_in("| a | b |\n|---|---|").starts_with("10: there are no tables here"));
  CHECK(mistakes_in("a ![x](y.png)").starts_with("2: there are no pictures"));
  CHECK(mistakes_in("a <b>c</b>").starts_with("2: there is no HTML here"));
  CHECK(mistakes_in("<script>alert(1)</script>").starts_with("0: there is no HTML here"));
  CHECK(mistakes_in("[x](javascript:alert(1))").starts_with("4: an address begins with https:"));
  CHECK(mistakes_in("[x](../../etc/passwd)").starts_with("4: an address begins with https:"));
  CHECK(mistakes_in("an _emphasized_ word").starts_with("3: emphasis is written *so*"));
  CHECK(mistakes_in("**open").starts_with("0: a ** has no partner"));
  CHECK(mistakes_in("a `b").starts_with("2: a ` has no partner"));
  CHECK(mistakes_in("* item").starts_with("0: a list begins with \"- \""));
  CHECK(mistakes_in("a\n\n---\n\nb").starts_with("3: a line of -"));
  // All at once, in the order of the text.
  CHECK(mistakes_in("# A\n\n$x_$ and $").find("\n") != std::string::npos);
}

TEST_CASE("prose: hostile texts come out as text, in bounded time", "[prose]") {
  const auto repeated = [](std::string_view text, int times) {
    std::string made;
    for (int i = 0; i < times; ++i) made += text;
    return made;
  };
  for (const std::string& text : {std::string("<script>alert(1)</script>"),
                                  std::string("[x](javascript:alert(1))"),
                                  std::string("[x](JaVaScRiPt:alert)"),
                                  std::string("[x](data:text/html,a)"),
                                  std::string("[x](https://a\"onclick=b)"),
                                  std::string("$\\text{<script>}$"),
                                  std::string("`<script>`"),
                                  std::string("![x](javascript:a)"),
                                  std::string("<https://a.b>"),
                                  std::string("[a]: javascript:b\n\n[a]"),
                                  std::string("[x](//evil)"),
                                  repeated("[", 20000),
                                  repeated("*a ", 6000),
                                  repeated("**", 10000),
                                  repeated("- ", 10000),
                                  repeated("`", 20000),
                                  repeated("$", 20001),
                                  repeated("_a ", 6000),
                                  repeated("> ", 10000),
                                  repeated("[a](b", 4000),
                                  repeated("$`", 10000),
                                  repeated("<a ", 6000),
                                  repeated("\n", 20000),
                                  repeated("*a*", 6000),
                                  repeated("***a", 5000)}) {
    INFO(text.substr(0, 60));
    std::vector<ProseMistake> mistakes;
    const Prose prose = read_prose(text, &mistakes);
    CHECK(mistakes.size() <= 50);
    const std::string page = prose_html(prose, algorithm());
    CHECK(page.find("<script") == std::string::npos);
    CHECK(page.find("href") == std::string::npos);
    CHECK(prose_markdown(prose).size() <= 8 * text.size() + 8);
  }
  std::string nested;
  for (int i = 0; i < 150; ++i) nested += repeated(" ", 2 * i) + "- a\n";
  CHECK(mistakes_in(nested).find("lists go at most 3 deep") != std::string::npos);
  CHECK(mistakes_in(repeated("x", 30'000)).starts_with("20000: what is said has at most"));

  const unsigned seed = std::random_device{}();
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const std::vector<std::string> pieces{"*",    "**", "_",   "`",  "$",  "$$", "[", "](",  ")", "(a.b)",    "\n",
                                        "\n\n", "- ", "1. ", "  ", "\\", "<",  ">", "#",   "a", "P[1][0]",  "u_3",
                                        " ",    "!",  "&",   "=",  "~",  "|",  "+", "x^2", ".", "\xC3\xA4", "\xFF"};
  for (int i = 0; i < 5'000; ++i) {
    std::string text;
    for (auto n = random() % 16; n > 0; --n) text += pieces[random() % pieces.size()];
    INFO("text: " << text);
    std::vector<ProseMistake> mistakes;
    const Prose prose = read_prose(text, &mistakes);
    for (const auto& [at, what] : mistakes) REQUIRE(at <= text.size());
    const std::string page = prose_html(prose, algorithm());
    REQUIRE(page.find('\x00') == std::string::npos);
    // Stars that touch other signs may not come out as they went in.
    if (!mistakes.empty() || text.find('*') != std::string::npos || text.find("$$") != std::string::npos) continue;
    INFO("again: " << prose_markdown(prose));
    REQUIRE(plain_text(read_prose(prose_markdown(prose))) == plain_text(prose));
  }
}

TEST_CASE("prose: every shipped lesson is in order and says the same words as before", "[prose]") {
  const auto catalog = load_catalog(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons");
  REQUIRE(!catalog.lessons.empty());
  for (const auto& [file, lesson] : catalog.lessons) {
    INFO(file.string());
    const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
    REQUIRE(run);
    const Narrator<Exact> narrator(*run);
    for (std::uint32_t step = 0; step < run->trace.step_count(); ++step) {
      const std::string said = lesson.narration(narrator, step);
      const Prose prose = read(said);
      INFO(said);
      if (said.find_first_of("$`*\\\n") == std::string::npos) CHECK(plain_text(prose) == said);
    }
  }
}

TEST_CASE("prose: braces belong to placeholders outside of formulas, and to TeX inside", "[prose]") {
  CHECK(!open_brace("{u} and $\\frac{1}{2}$ and {P[1][0]}"));
  CHECK(open_brace("{u and $x$") == 0u);
  CHECK(open_brace("a {u {v}") == 2u);
  CHECK(!open_brace("$\\left\\{ x \\right.$ \\$ {u}"));
  CHECK(open_brace("\\$ {u") == 3u);
  CHECK(!open_brace("$x_{1$"));  // the formula's own mistake
  CHECK(open_brace("`$` {a $x$") == 4u);
}

TEST_CASE("prose: what was meant as a formula, as a price, as emphasis or as a link", "[prose]") {
  CHECK(mistakes_in("so \\alpha is") ==
        "3: \\alpha belongs between dollar signs: $\\alpha$; write \\\\ for a backslash");
  CHECK(mistakes_in("costs $5 and $6") ==
        "6: a $ with a blank before it or a digit behind it ends no formula; write \\$ for the sign of the dollar");
  CHECK(mistakes_in("costs \\$5 and \\$6, \\{a\\}, and $a$ is $b$.").empty());
  CHECK(mistakes_in("an *unpaired star") == "3: a * has no partner; write \\* for the sign");
  CHECK(mistakes_in("[words](http://x and on") == "0: the address of a link has no ) behind it in its line");
  CHECK(mistakes_in("on [0, 1](see below, P[1](u").empty());
}
