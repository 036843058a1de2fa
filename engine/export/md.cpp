// A lesson as one Markdown file, for course pages and wikis: of every step its picture, its words and its formula. The
// pictures are SVG files in a folder beside it. Questions have their answers folded away.

#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "base/json.hpp"
#include "export/export.hpp"
#include "export/export_staging.hpp"
#include "export/html_document.hpp"
#include "export/page_words.hpp"
#include "export/paper_view.hpp"
#include "render/picture.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr LetterSizes letters{10.5, 13};  // in pixels of the pictures

// Text that is not Markdown, on one line of it.
std::string escaped(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  Block paragraph;
  Span words;
  words.text = std::move(text);
  paragraph.spans.push_back(std::move(words));
  std::string line = prose_markdown({paragraph});
  while (line.ends_with('\n')) line.pop_back();
  return line;
}

std::string on_one_line(const Prose& prose) {
  std::string text = prose_markdown(prose);
  while (text.ends_with('\n')) text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// The names of values as books have them, in the signs that Unicode has: "P[1][0]" is P₀⁽¹⁾, as in the formulas.
Prose typeset(Prose prose, const Algorithm& algorithm) {
  for (Block& block : prose)
    for (Span& span : block.spans)
      if (span.kind == Span::Kind::text) span.text = unicode_text(typeset_text(span.text, algorithm));
  return prose;
}

std::string list_of(const std::string& heading, const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += "- " + item + "\n";
  return text.empty() ? "" : "**" + heading + "**\n\n" + text + "\n";
}

std::string linked(const StoryLink& link) {
  return link.page.empty() ? escaped(link.words())
                           : "[" + escaped(link.words()) + "](" + html_address(link.page + ".md") + ")";
}

std::string header(const Story& story, const PageWords& words) {
  const Algorithm& algorithm = story.scenes.front().recording->algorithm();
  const auto line = [&](const std::string& text) { return on_one_line(typeset(read_prose(text), algorithm)); };
  std::string text = "# " + escaped(story.title) + "\n\n";
  std::string facts = story.unit.empty() ? "" : "*" + escaped(story.unit) + "*";
  if (story.minutes > 0) facts += (facts.empty() ? "" : " · ") + words("minutes", std::to_string(story.minutes));
  if (!facts.empty()) text += facts + "\n\n";
  if (!story.summary.empty()) text += line(story.summary) + "\n\n";
  std::vector<std::string> objectives, before, exercises;
  for (const std::string& objective : story.objectives) objectives.push_back(line(objective));
  for (const StoryLink& link : story.prerequisites) before.push_back(linked(link));
  for (const StoryLink& link : story.exercises) exercises.push_back(linked(link));
  const auto word = [&](std::string_view key) { return std::string(words(key)); };
  text +=
      list_of(word("objectives"), objectives) + list_of(word("before"), before) + list_of(word("practise"), exercises);
  if (!story.source.empty()) text += "**" + word("source") + "**\n\n" + escaped(story.source) + "\n\n";
  return text;
}

std::string pseudo_code(const StoryScene& scene) {
  std::string text = "```\n";
  const auto& lines = scene.recording->algorithm().pseudo_code;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += (i < 9 ? " " : "") + std::to_string(i + 1) + "  " + std::string(lines[i]) + "\n";
  return text + "```\n\n";
}

// The equation of what the step makes, on lines of its own: with names, with numbers, and the value.
std::string formula(const StepSource& source, std::uint32_t step) {
  const ValueId v = source.graph->main_value(step);
  if (v == absent || source.graph->is_input(v)) return {};
  const Algorithm& algorithm = source.algorithm_at(step);
  const auto set = [&](const std::string& text) { return escaped(unicode_text(typeset_text(text, algorithm))); };
  const std::string names = source.formula(v), numbers = source.numbers(v), value = source.made_text(v);
  std::string text = "> " + set(source.own_name(v) + " = " + names);
  if (numbers != names) text += "\\\n> = " + escaped(numbers);
  if (value != numbers) text += "\\\n> = " + escaped(value);
  return text + "\n\n";
}

std::string question(const StoryStep::Question& asked, const Algorithm& algorithm, const PageWords& words) {
  const auto set = [&](const Prose& prose) { return typeset(prose, algorithm); };
  std::string text = "**" + std::string(words("question")) + ".** " + prose_markdown(set(asked.ask)) + "\n";
  for (std::size_t i = 0; i < asked.options.size(); ++i)
    text += "- **" + letter_of(i) + ")** " + on_one_line(set(asked.options[i])) + "\n";
  text += (asked.options.empty() ? "" : "\n") + std::string("<details><summary>") + std::string(words("asked")) +
          "</summary>\n\n" + escaped(asked.answer) + "\n\n";
  for (std::size_t i = 0; i < asked.feedback.size(); ++i)
    if (!asked.feedback[i].empty()) text += "- " + letter_of(i) + ": " + on_one_line(set(asked.feedback[i])) + "\n";
  if (!asked.right.empty()) text += "\n" + prose_markdown(set(asked.right));
  return text + "\n</details>\n\n";
}

std::string told(const StoryScene& scene, const StoryStep& step, const std::string& picture, bool with_question,
                 const PageWords& words) {
  const Algorithm& algorithm = scene.source().algorithm_at(step.step);
  const std::string number = std::to_string(step.step);
  std::string text = "### " + words("stepname", number) +
                     (step.phase.empty() ? "" : ": " + escaped(unicode_text(typeset_text(step.phase, algorithm)))) +
                     "\n\n";
  text += "![" + words("picture", number) + "](" + picture + ")\n\n";
  text += prose_markdown(typeset(step.prose, algorithm)) + "\n" + formula(scene.source(), step.step);
  const auto& code = algorithm.pseudo_code;
  if (step.line > 0 && static_cast<std::size_t>(step.line) <= code.size()) {
    std::string_view line = code[static_cast<std::size_t>(step.line) - 1];
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    text += std::string(words("lineasked")) + " " + std::to_string(step.line) + ": `" + std::string(line) + "`\n\n";
  }
  if (with_question && step.question) text += question(*step.question, algorithm, words);
  return text;
}

Checked<bool> draw(const StoryScene& scene, const StoryStep& step, const std::string& title, const fs::path& file,
                   const LessonExportOptions& options, const PageWords& words) {
  Scene picture = picture_with_knots(scene, step.step, std::round(options.width * 0.64),
                                     std::round(options.height * 0.64), *options.theme, letters);
  picture.title = title + ", " + words("stepname", std::to_string(step.step));
  picture.description = plain_text(step.prose);
  const auto text = draw_svg(picture, *options.theme);
  if (!text) return text.diagnostics;
  return write_file(file, *text);
}

Checked<LessonExported> write(const Story& story, const fs::path& out, const LessonExportOptions& options) {
  auto staging = Staging::open(out.parent_path());
  if (!staging) return staging.diagnostics;
  const fs::path document = staging->path(out.filename());
  const std::string pictures = out.stem().string() + "-files";
  const PageWords words(story.language);
  std::string text = header(story, words);
  std::size_t done = 0;
  for (const StoryScene& scene : story.scenes) {
    if (!scene.heading.empty()) text += "## " + escaped(scene.heading) + "\n\n";
    text += pseudo_code(scene);
    for (const StoryStep& step : scene.steps) {
      const std::string file = pictures + "/" + step_file_name(story, scene, step.step, ".svg");
      const auto drawn = draw(scene, step, story.title, staging->path(file), options, words);
      if (!drawn) return staging->in_place(drawn.diagnostics);
      text += told(scene, step, html_address(file), options.checkpoints, words);
      if (!report_progress(options, ++done, story.step_count())) return stopped();
    }
  }
  const auto written = write_file(document, text);
  if (!written) return staging->in_place(written.diagnostics);
  auto files = staging->publish();
  if (!files) return files.diagnostics;
  return LessonExported{*std::move(files), {}};
}

}  // namespace

const LessonFormat& lesson_md() {
  static const LessonFormat format{
      "md", "Markdown", ".md", false, "one Markdown file, its pictures in a folder beside it", write, export_use::size};
  return format;
}

}  // namespace blossom
