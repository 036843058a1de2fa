// What is for paper: the handout and the LaTeX document. Their readers are poppler's programs and pdflatex; where these
// are missing, that part says so and is not tested.

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "export/latex_text.hpp"
#include "export/paper_view.hpp"
#include "export/short_lesson.hpp"
#include "export/tikz_canvas.hpp"
#include "render/rich_text.hpp"
#include "scratch.hpp"

using namespace blossom;
using namespace blossom::test;
namespace fs = std::filesystem;

namespace {

std::string file_bytes(const fs::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

bool is_installed(const std::string& program) {
  if (std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0) return true;
  WARN("not tested: " + program + " is not installed");
  return false;
}

int run_in(const fs::path& folder, const std::string& command) {
  return std::system(("cd '" + folder.string() + "' && " + command + " >/dev/null 2>&1").c_str());
}

fs::path exported(const std::string& format, const Story& story, const fs::path& folder, int per_page = 2) {
  LessonExportOptions options = small_pages();
  options.per_page = per_page;
  const fs::path out = folder / ("lesson." + format);
  const auto written = find_lesson_format(format)->write(story, out, options);
  INFO(to_string(written.diagnostics));
  REQUIRE(written);
  return out;
}

// Words without blanks and line ends, which are where a page has room for them.
std::string squeezed(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\f' || c == '\r'; });
  return text;
}

// The words of four letters and more that are no names of values: those are set in pieces.
std::vector<std::string> plain_words(const Prose& prose) {
  std::vector<std::string> words;
  std::istringstream all(plain_text(prose));
  for (std::string word; all >> word;)
    if (word.size() > 3 && word != "alpha" &&
        std::ranges::all_of(word, [](unsigned char c) { return std::isalpha(c) != 0; }))
      words.push_back(word);
  return words;
}

std::string text_of(const fs::path& pdf, const fs::path& folder, const std::string& how = "") {
  REQUIRE(run_in(folder, "pdftotext " + how + " '" + pdf.string() + "' words.txt") == 0);
  return file_bytes(folder / "words.txt");
}

int pages_of(const fs::path& pdf, const fs::path& folder) {
  const std::string text = text_of(pdf, folder);
  return static_cast<int>(std::ranges::count(text, '\f'));
}

Story shipped(const std::string& file) { return story_of(file_bytes(fs::path(BLOSSOM_SOURCE_DIR) / "lessons" / file)); }

void require_compiles(const fs::path& tex, const fs::path& folder) {
  const int status = run_in(folder, "pdflatex -interaction=nonstopmode -halt-on-error '" + tex.string() + "'");
  const std::string log = file_bytes(folder / "lesson.log");
  INFO(log.substr(log.size() - std::min<std::size_t>(log.size(), 3000)));
  REQUIRE(status == 0);
  CHECK(log.find("\n!") == std::string::npos);
}

std::vector<LatexLine> as_latex(const RichText& text) {
  const auto fonts = Fonts::load();
  REQUIRE(fonts);
  return latex_lines(**fonts, set_text(**fonts, text, 14, TextAlign::left).runs);
}

}  // namespace

TEST_CASE("a handout says every step's words, in order", "[export][paper]") {
  if (!is_installed("pdftotext")) return;
  const Scratch scratch;
  const Story story = shipped("29-subdivision.json");
  for (const int per_page : {1, 2, 4, 6}) {
    INFO("per page: " << per_page);
    // Raw: in the order in which it was written, and that is the order of the steps.
    const std::string text =
        squeezed(text_of(exported("pdf", story, scratch.path(), per_page), scratch.path(), "-raw"));
    CHECK(text.find(squeezed(story.title)) != std::string::npos);
    std::size_t at = 0;
    for (const StoryStep& told : story.scenes[0].steps) {
      at = text.find("Step" + std::to_string(told.step), at);
      INFO("step " << told.step);
      REQUIRE(at != std::string::npos);
      for (const std::string& word : plain_words(told.prose)) {
        at = text.find(word, at);
        INFO("word " << word);
        REQUIRE(at != std::string::npos);
      }
    }
  }
}

TEST_CASE("a handout has as many steps on a page as is asked for", "[export][paper]") {
  if (!is_installed("pdftotext")) return;
  const Scratch scratch;
  const Story story = shipped("29-subdivision.json");
  const auto steps = static_cast<int>(story.step_count());
  int before = steps + 2;
  for (const int per_page : {1, 2, 4, 6}) {
    INFO("per page: " << per_page);
    const int pages = pages_of(exported("pdf", story, scratch.path(), per_page), scratch.path());
    CHECK(pages >= steps / per_page);
    CHECK(pages <=
          steps / per_page + 4);  // the head takes room of the first one, and the answers have one of their own
    CHECK(pages <= before);  // not always fewer: questions and long words take room, however small the pictures are
    before = pages;
  }
}

TEST_CASE("a handout asks its lesson's questions, with room for answers, which are its last page", "[export][paper]") {
  if (!is_installed("pdftotext")) return;
  const Scratch scratch;
  const std::string text = text_of(exported("pdf", story_of(short_lesson), scratch.path()), scratch.path());
  CHECK(text.find("Question") != std::string::npos);
  CHECK(text.find("And then?") != std::string::npos);
  CHECK(text.find("the second leg") != std::string::npos);
  CHECK(text.find("Name") != std::string::npos);
  CHECK(text.find("There is another leg.") == std::string::npos);
  const std::size_t answers = text.find("Answers");
  REQUIRE(answers != std::string::npos);
  CHECK(text[answers - 1] == '\f');  // a page of their own
  CHECK(text.find("the second leg", answers) != std::string::npos);
}

TEST_CASE("on paper a step that tells what was asked does not stand beside the question", "[export][paper]") {
  if (!is_installed("pdftotext")) return;
  const Scratch scratch;
  const Story story = shipped("22-de-boor.json");
  for (const int per_page : {2, 4, 6}) {
    INFO("per page: " << per_page);
    std::string text = text_of(exported("pdf", story, scratch.path(), per_page), scratch.path());
    const std::size_t answers = text.find("\fAnswers");
    REQUIRE(answers != std::string::npos);
    for (std::size_t at = 0; at < answers;) {
      const std::size_t end = text.find('\f', at);
      const std::string page = text.substr(at, end - at);
      at = end + 1;
      // Its first step asks for the span, and the next one has it.
      if (page.find("Index of the knot span:") != std::string::npos) CHECK(page.find("k = 4") == std::string::npos);
    }
  }
}

TEST_CASE("letters on paper can be read", "[export][paper]") {
  const Story story = shipped("22-de-boor.json");
  const StoryScene& scene = story.scenes[0];
  View view = scene.picture(8, 500, 300);
  enlarge_letters(view, light_theme(), {12, 16});
  View knots = knots_view(scene, 8, 500, true);
  CHECK(knots.height > 100);
  CHECK(knots_view(shipped("11-de-casteljau.json").scenes[0], 1, 500, false).height == 0);
  REQUIRE_FALSE(view.labels.empty());
  for (const Label& label : view.labels)
    CHECK(label.size_scale * light_theme()[label.role].text_size >=
          (label.role == Role::text_quiet && label.placement != Label::Placement::around ? 12 : 16));
}

TEST_CASE("in LaTeX a name that stands for two values has its phase", "[export][paper]") {
  const Scratch scratch;
  const std::string text = file_bytes(exported("tex", shipped("50-point-on-a-surface.json"), scratch.path()));
  CHECK(text.find("\\blossomformula{P_{2} = P_{2} ") == std::string::npos);
  CHECK(text.find("\\begin{blossomquestion}") != std::string::npos);
}

TEST_CASE("words without end go on on the next pages of a handout, to the last one", "[export][paper]") {
  if (!is_installed("pdftotext")) return;
  const Scratch scratch;
  std::string lesson = short_lesson, many;
  for (int i = 0; i < 1500; ++i) many += "word" + std::to_string(i) + " ";
  const std::string first = "Three control points make a parabola.";
  lesson.replace(lesson.find(first), first.size(), many);
  const std::string text = text_of(exported("pdf", story_of(lesson), scratch.path(), 6), scratch.path(), "-raw");
  std::size_t at = 0;
  for (int i = 0; i < 1500; ++i) {
    at = text.find("word" + std::to_string(i), at);
    INFO("word " << i);
    REQUIRE(at != std::string::npos);
  }
  CHECK(text.find("Step 0, continued") != std::string::npos);
}

TEST_CASE("the same lesson makes the same bytes on paper", "[export][paper]") {
  const Scratch one, other;
  for (const std::string format : {"pdf", "tex"}) {
    INFO(format);
    const Story story = shipped("11-de-casteljau.json");
    const std::string bytes = file_bytes(exported(format, story, one.path()));
    CHECK(bytes.size() > 10000);
    CHECK(bytes == file_bytes(exported(format, shipped("11-de-casteljau.json"), other.path())));
  }
}

TEST_CASE("LaTeX documents compile, in the plane and in space", "[export][paper]") {
  if (!is_installed("pdflatex")) return;
  for (const std::string lesson :
       {"11-de-casteljau.json", "40-rational-quarter-circle.json", "60-ruled-hyperboloid.json"}) {
    INFO(lesson);
    const Scratch scratch;
    require_compiles(exported("tex", shipped(lesson), scratch.path()), scratch.path());
  }
}

TEST_CASE("whatever a lesson's texts hold, its LaTeX document compiles and shows it", "[export][paper]") {
  if (!is_installed("pdflatex") || !is_installed("pdftotext")) return;
  const Scratch scratch;
  Story story = story_of(short_lesson);
  story.title = "100% of $x_1 & \\evil{#} ~ ^ < | > \" -- \\end{document}";
  story.unit = "ä ß Ł đ ą „q“ «q» α ≤ √2 中文 \u200B ₃ ⁽²⁾ …";
  story.exercises = {{"a_b%", "", "", ""}, {"}{", "}{", "&_", ""}};
  story.scenes[0].heading = "\\input{/etc/passwd} %";
  story.scenes[0].steps[0].phase = "A_1 › B & C";
  require_compiles(exported("tex", story, scratch.path()), scratch.path());
  const std::string text = text_of(scratch / "lesson.pdf", scratch.path());
  CHECK(squeezed(text).find("&\\evil{#}") != std::string::npos);
  CHECK(text.find("root:") == std::string::npos);
}

TEST_CASE("names in TikZ pictures are formulas", "[export][paper]") {
  using Level = TextRun::Level;
  const RichText name{{"P", Level::base, true}, {"1", Level::sub}, {"(2)", Level::super}};
  REQUIRE(as_latex(name).size() == 1);
  CHECK(as_latex(name)[0].text == "$P_{1}^{(2)}$");
  CHECK(as_latex({{"α", Level::base, true}, {"2", Level::sub}})[0].text == "$\\alpha_{2}$");
  CHECK(as_latex({{"C", Level::base, true}})[0].text == "$C$");
  CHECK(as_latex({{"Q", Level::base, true, true}, {"3", Level::sub}})[0].text == "$\\boldsymbol{Q_{3}}$");
  CHECK(as_latex({{"50% of "}, {"P", Level::base, true}, {"1", Level::sub}, {" & more"}})[0].text ==
        "50\\% of $P_{1}$ \\& more");
  CHECK(as_latex({{"one\ntwo"}}).size() == 2);
}

TEST_CASE("a line in a TikZ picture keeps the points that are seen", "[export][paper]") {
  const auto fonts = Fonts::load();
  REQUIRE(fonts);
  TikzCanvas canvas(*fonts, 0.5);
  canvas.begin({100, 100, {255, 255, 255}, "", ""});
  std::vector<PixelPoint> corner;
  for (int i = 0; i <= 50; ++i) corner.push_back({static_cast<float>(i), 10, 0});
  for (int i = 1; i <= 50; ++i) corner.push_back({50, static_cast<float>(10 + i), 0});
  canvas.polyline(corner, false, {{0, 114, 178}, 2, 0, 0});
  canvas.finish();
  CHECK(canvas.picture().find("\\draw[draw=b0072B2,line width=1pt] (0,10) -- (50,10) -- (50,60);") !=
        std::string::npos);
  CHECK(TikzCanvas::preamble(canvas.colors()).find("\\definecolor{b0072B2}{HTML}{0072B2}") != std::string::npos);
}

TEST_CASE("what LaTeX would obey is written out", "[export][paper]") {
  CHECK(latex_text("100% of $x_1 & \\evil{#}") == "100\\% of \\$x\\_1 \\& \\textbackslash{}evil\\{\\#\\}");
  CHECK(latex_text("\"a\" b--c\x01") == "``a'' b-{}-c");
  CHECK(unicode_declarations("plain ä").empty());
  CHECK(unicode_declarations("α") == "\\DeclareUnicodeCharacter{03B1}{\\ensuremath{\\alpha}}\n");
  CHECK(unicode_declarations("中") == "\\DeclareUnicodeCharacter{4E2D}{\\texttt{[U+4E2D]}}\n");
}
