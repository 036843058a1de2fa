// PrairieLearn's results.json for external grading, as its documentation has it (docs/externalGrading.md, "Grading
// results"; how it is shown: the element pl-external-grader-results).
//
// "score" is from 0 to 1. A submission of which nothing can be read is not "gradable": it has no score, costs no
// attempt and tells why in "format_errors". All texts are plain: PrairieLearn escapes them itself, after it has turned
// terminal colours into HTML, so no control characters may be in them. It refuses a file above 1 MiB; should feedback
// make it that large, it is cut, never the scores.

#include "grader/report/facts.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_bytes = 1u << 20;
constexpr std::string_view cut = " ... (cut: PrairieLearn takes 1 MiB at most)";

void add_points(std::string_view key, const Exact& points, std::string& out) {
  append_json_key(key, out);
  out += points_text(points);
}

class PrairieLearnReport final : public Report {
 public:
  void add(const StudentResult& result, std::string& out) override {
    const ResultFacts facts = facts_of(result);
    // Shorter and shorter texts until all of it fits; without any it is as long as the names, and names are short.
    std::string document;
    for (std::size_t longest = most_bytes;; longest /= 2) {
      document.clear();
      write(result, facts, longest, document);
      if (document.size() <= most_bytes || longest == 0) break;
    }
    out += document;
  }

 private:
  // A text of at most `longest` bytes, and a bit that says so.
  static void add_text(std::string_view key, const std::string& text, std::size_t longest, std::string& out) {
    append_json_key(key, out);
    append_json_text(shortened(text, longest), out);
  }

  static std::string shortened(const std::string& text, std::size_t longest) {
    if (text.size() <= longest) return text;
    if (longest < cut.size()) return {};
    std::size_t end = longest - cut.size();
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // not inside a character
    return text.substr(0, end) + std::string(cut);
  }

  static void write(const StudentResult& result, const ResultFacts& facts, std::size_t longest, std::string& out) {
    out += '{';
    append_json_key("gradable", out);
    out += facts.readable ? "true" : "false";
    if (!facts.readable) {
      append_json_key("format_errors", out);
      out += '[';
      for (const std::string& note : facts.all_notes()) {
        if (!out.ends_with('[')) out += ',';
        append_json_text(shortened(note, longest), out);
      }
      out += "]}\n";
      return;
    }
    append_json_key("score", out);
    out += format_number(result.score());
    add_text("message", points_of(result.points, result.max_points) + ".", longest, out);
    std::string notes;
    for (const std::string& note : facts.all_notes()) notes += note + "\n";
    if (!notes.empty()) add_text("output", notes, longest, out);
    append_json_key("tests", out);
    out += '[';
    for (const ExerciseFacts& exercise : facts.exercises) add_tests(exercise, facts.exercises.size() > 1, longest, out);
    out += "]}\n";
  }

  static void open_test(const std::string& name, const Exact& points, const Exact& max_points, std::string& out) {
    if (!out.ends_with('[')) out += ',';
    out += '{';
    append_json_key("name", out);
    append_json_text(name, out);
    add_points("points", points, out);
    add_points("max_points", max_points, out);
  }

  // A test for each part, or for the exercise as a whole where parts are not shown.
  static void add_tests(const ExerciseFacts& exercise, bool several, std::size_t longest, std::string& out) {
    const std::string title = printable(exercise.title);
    if (exercise.parts.empty()) {
      open_test(title, exercise.before_late, exercise.max_points, out);
      out += '}';
      return;
    }
    for (const PartFacts& part : exercise.parts) {
      open_test(std::string(part.name), part.points, part.max_points, out);
      if (several) add_text("description", title, longest, out);
      add_text("message", std::string(part.verdict), most_bytes, out);
      if (!part.text.empty()) add_text("output", part.text, longest, out);
      out += '}';
    }
  }
};

}  // namespace

const ReportFormat& report_prairielearn() {
  static const ReportFormat format{
      "prairielearn", "PrairieLearn's results.json for external grading, of one student", "json",
      ReportFormat::Scope::student,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<PrairieLearnReport>(); }};
  return format;
}

}  // namespace blossom
