// Grades to be read: a block for each exercise of each student, and for several students a table of scores.

#include <algorithm>
#include <array>

#include "base/utf8.hpp"
#include "grader/report/facts.hpp"

namespace blossom {
namespace {

std::string pad(std::string text, std::size_t to) {
  const std::size_t has = utf8_count(text);
  if (has < to) text.append(to - has, ' ');
  return text;
}

std::string pad_left(const std::string& text, std::size_t to) {
  const std::size_t has = utf8_count(text);
  return has < to ? std::string(to - has, ' ') + text : text;
}

std::string number(const Exact& x) { return format_short(x.to_double(), 2); }
std::string of(const Exact& points, const Exact& most) { return number(points) + "/" + number(most); }
std::string percent(double score) { return format_short(100 * score, 1) + " %"; }

class TextReport final : public Report {
 public:
  explicit TextReport(const ReportContext& context) : several_(context.students > 1) {}

  void add(const StudentResult& result, std::string& out) override {
    const ResultFacts facts = facts_of(result);
    Row row{printable(result.student.id.empty() ? "standard input" : result.student.id),
            percent(result.score()),
            of(result.points, result.max_points),
            {}};
    for (const ExerciseFacts& exercise : facts.exercises) {
      const double score = exercise.max_points == Exact(0) ? 0 : (exercise.points / exercise.max_points).to_double();
      out += row.name + ": " + percent(score) + " (" + of(exercise.points, exercise.max_points) + " points) in " +
             printable(exercise.id) + "\n";
      write_parts(exercise, out);
      for (const std::string& note : exercise.notes) out += "  " + note + "\n";
      out += "\n";
      // How many of each verdict there are is said of the exercises that say so themselves.
      if (exercise.grade == nullptr || exercise.grade->exercise->feedback == Feedback::none) continue;
      with_verdicts_ = true;
      for (const PartGrade& part : exercise.grade->parts) ++row.counts[static_cast<std::size_t>(part.verdict)];
    }
    if (facts.exercises.size() != 1)
      out += row.name + ": " + row.score + " (" + row.points + " points) in all\n" + (facts.notes.empty() ? "\n" : "");
    for (const std::string& note : facts.notes) out += "  " + note + "\n";
    if (!facts.notes.empty()) out += "\n";
    if (several_) rows_.push_back(std::move(row));
  }

  void finish(std::string& out) override {
    if (!several_) return;
    std::size_t names = std::string_view("name").size(), scores = 5, points = 6;
    for (const Row& row : rows_) {
      names = std::max(names, utf8_count(row.name));
      scores = std::max(scores, utf8_count(row.score));
      points = std::max(points, utf8_count(row.points));
    }
    out += pad("name", names) + "  " + pad_left("score", scores) + "  " + pad_left("points", points);
    for (std::size_t v = 0; with_verdicts_ && v < verdict_count; ++v)
      out += "  " + std::string(verdict_name(static_cast<Verdict>(v)));
    out += "\n";
    for (const Row& row : rows_) {
      out += pad(row.name, names) + "  " + pad_left(row.score, scores) + "  " + pad_left(row.points, points);
      for (std::size_t v = 0; with_verdicts_ && v < verdict_count; ++v)
        out += "  " + pad_left(row.counts[v] == 0 ? "." : std::to_string(row.counts[v]),
                               verdict_name(static_cast<Verdict>(v)).size());
      out += "\n";
    }
  }

 private:
  struct Row {
    std::string name;
    std::string score;
    std::string points;
    std::array<std::size_t, verdict_count> counts{};
  };

  // A part's feedback; advice that this student has read already is only named.
  static std::string feedback(const PartGrade& part, const Exercise& exercise, const std::string& text,
                              std::vector<std::string_view>& given) {
    if (part.misconception.empty()) return text;
    if (std::ranges::find(given, part.misconception) == given.end()) {
      given.push_back(part.misconception);
      return text;
    }
    const Misconception* const m = find_misconception(exercise, part.misconception);
    const std::string advice = advice_of(*m);
    if (!text.starts_with(advice)) return text;
    return "As above: " + std::string(m->title) + "." + text.substr(advice.size());
  }

  static void write_parts(const ExerciseFacts& facts, std::string& out) {
    std::vector<std::string_view> given;
    std::size_t names = 0, verdicts = 0, points = 0;
    for (const PartFacts& part : facts.parts) {
      names = std::max(names, part.name.size());
      verdicts = std::max(verdicts, part.verdict.size());
      points = std::max(points, of(part.points, part.max_points).size());
    }
    for (std::size_t i = 0; i < facts.parts.size(); ++i) {
      const PartFacts& part = facts.parts[i];
      out += "  " + pad(std::string(part.name), names) + "  " + pad(std::string(part.verdict), verdicts) + "  " +
             pad_left(of(part.points, part.max_points), points) + (part.typed.empty() ? "" : "  typed " + part.typed) +
             "\n";
      if (!part.text.empty())
        out += "      " + feedback(facts.grade->parts[i], *facts.grade->exercise, part.text, given) + "\n";
    }
  }

  bool several_;
  bool with_verdicts_ = false;
  std::vector<Row> rows_;
};

}  // namespace

const ReportFormat& report_text() {
  static const ReportFormat format{
      "text", "to be read: a block for each student, then a table of scores", "txt", ReportFormat::Scope::course,
      [](const ReportContext& context) -> std::unique_ptr<Report> { return std::make_unique<TextReport>(context); }};
  return format;
}

}  // namespace blossom
