#pragma once
// Pages of lessons, as they are written, and what is compared with them.

#include <cctype>

#include "browser.hpp"
#include "export/short_lesson.hpp"

namespace blossom::test {

// Two scenes; a question of each kind; a formula on a line of its own; markup in places where it is but text.
inline constexpr const char* all_questions = R"({
  "schema": "blossom.lesson/1", "id": "all-questions", "title": "Questions </title><script>parent.x = 1</script>",
  "scenes": [
    {"id": "point", "title": "A point & <b>its</b> span", "algorithm": "de_boor",
     "inputs": {"curve": {"degree": 2, "knots": [0, 0, 0, 0.25, 0.5, 1, 1, 1],
                          "points": [[0, 0], [2, 8], [8, 8], [12, 2], [14, 6]]}, "u": "2/5"},
     "beats": [
       {"at": "start", "say": "The curve is $$C(u) = \\sum_{i=0}^{n} N_{i,p}(u) P_i$$ as ever.",
        "checkpoint": {"id": "span", "kind": "span", "ask": "In which span is {u}?", "wrong": "Count from 0."}},
       {"at": "k", "say": "It is \\<b>k = {k}\\</b>.",
        "checkpoint": {"id": "line", "kind": "line", "ask": "Which line comes next?"}},
       {"at": "alpha[1][2]", "say": "The ratio is {value}.",
        "checkpoint": {"id": "value", "kind": "predict", "value": "P[1][2]", "decimals": 2, "ask": "Where is P[1][2]?"}},
       {"at": "alpha[1][3]", "say": "Another ratio.",
        "checkpoint": {"id": "ratio", "kind": "predict", "value": "alpha[2][3]", "ask": "And the last ratio?"}},
       {"at": "P[1][3]", "say": "Two points.",
        "checkpoint": {"id": "order", "kind": "order", "ask": "What comes first?",
                       "items": ["find the span", "compute the ratio", "divide the leg"]}},
       {"at": "C", "say": "Done.", "pause": "wait",
        "checkpoint": {"id": "choice", "kind": "choice", "ask": "How many points took part?",
                       "choices": [{"text": "five", "feedback": "Only p + 1."}, {"text": "three", "right": true},
                                   {"text": "\\</script> two"}]}}]},
    {"id": "cut", "title": "A cut", "algorithm": "de_casteljau",
     "inputs": {"curve": {"degree": 3, "points": [[0, 0], [0, 10], [10, 10], [15, 0]]}, "u": "1/2"},
     "beats": [{"at": "P[1][1]", "say": "Half of the way."}]}]
})";

inline std::string page_of(const Story& story, bool checkpoints = true, const Theme& theme = light_theme()) {
  const Scratch scratch;
  LessonExportOptions options;
  options.theme = &theme;
  options.checkpoints = checkpoints;
  const auto exported = find_lesson_format("html")->write(story, scratch / "page.html", options);
  INFO(to_string(exported.diagnostics));
  REQUIRE(exported);
  REQUIRE(exported->files.size() == 1);
  return read_all(exported->files[0]);
}

// The same, for a script that is added at its end: the page's own policy names its own script alone.
inline std::string with_probe(std::string page, const std::string& script) {
  page = std::regex_replace(page, std::regex("script-src 'sha256-[^']*'"), "script-src 'unsafe-inline'");
  page.insert(page.rfind("</body>"), "<script>" + script + "</script>");
  return page;
}

inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

inline std::string without_blanks(const std::string& text) {
  std::string kept;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c))) kept += c;
  return kept;
}

// What is said, without what sets it: nothing where a formula is, whose letters depend on how it is set.
inline std::string letters_of(const Prose& prose, const Algorithm& algorithm) {
  std::string letters;
  for (const Block& block : prose) {
    if (block.kind != Block::Kind::paragraph) return {};
    for (const Span& span : block.spans)
      if (span.kind == Span::Kind::math) return {};
  }
  for (const TextRun& run : rich_text(prose, algorithm)) letters += run.text;
  return without_blanks(letters);
}

inline Story shipped(const std::string& name) {
  const auto document = JsonDocument::load("lessons/" + name + ".json");
  REQUIRE(document);
  const auto lesson = load_lesson(*document);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  auto story = make_story(*lesson, {});
  REQUIRE(story);
  return std::move(*story);
}

}  // namespace blossom::test
