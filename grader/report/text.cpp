// Grades to be read: a block for each student, and for several of them a table of scores.

#include <algorithm>
#include <array>

#include "base/utf8.hpp"
#include "grader/report/report.hpp"

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
  TextReport(const Exercise& exercise, std::size_t submissions) : exercise_(&exercise), several_(submissions > 1) {}

  void add(const Grade& grade, std::string& out) override {
    Row row{printable(grade.student.empty() ? "standard input" : grade.student),
            percent(grade.score()),
            of(grade.points, exercise_->max_points),
            {},
            !grade.reason.empty()};
    for (const PartGrade& part : grade.parts) ++row.counts[static_cast<std::size_t>(part.verdict)];
    out += row.name + ": " + row.score + " (" + row.points + " points) in " + printable(exercise_->id) + "\n";
    if (!grade.reason.empty()) {
      out += "  invalid: " + printable(grade.reason) + "\n";
    } else if (exercise_->feedback != Feedback::none) {
      write_parts(grade, out);
    }
    for (const std::string& note : grade.notes) out += "  note: " + printable(note) + "\n";
    out += "\n";
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
    const bool with_verdicts = exercise_->feedback != Feedback::none;
    for (std::size_t v = 0; with_verdicts && v < verdict_count; ++v)
      out += "  " + std::string(verdict_name(static_cast<Verdict>(v)));
    out += "\n";
    for (const Row& row : rows_) {
      out += pad(row.name, names) + "  " + pad_left(row.score, scores) + "  " + pad_left(row.points, points);
      for (std::size_t v = 0; with_verdicts && v < verdict_count; ++v)
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
    bool invalid = false;
  };

  // A part's feedback; advice that this student has read already is only named.
  std::string feedback(const PartGrade& part, std::vector<std::string_view>& given) const {
    if (part.misconception.empty()) return part.feedback;
    if (std::ranges::find(given, part.misconception) == given.end()) {
      given.push_back(part.misconception);
      return part.feedback;
    }
    const auto& known = exercise_->run.algorithm->misconceptions;
    const auto m = std::ranges::find(known, part.misconception, &Misconception::id);
    const std::string advice = advice_of(*m);
    if (!part.feedback.starts_with(advice)) return part.feedback;
    return "As above: " + std::string(m->title) + "." + part.feedback.substr(advice.size());
  }

  void write_parts(const Grade& grade, std::string& out) const {
    std::vector<std::string_view> given;
    std::size_t names = 0, verdicts = 0, points = 0;
    for (std::size_t i = 0; i < grade.parts.size(); ++i) {
      names = std::max(names, exercise_->parts[i].name.size());
      verdicts = std::max(verdicts, verdict_name(grade.parts[i].verdict).size());
      points = std::max(points, of(grade.parts[i].points, exercise_->parts[i].points).size());
    }
    for (std::size_t i = 0; i < grade.parts.size(); ++i) {
      const PartGrade& part = grade.parts[i];
      out += "  " + pad(exercise_->parts[i].name, names) + "  " +
             pad(std::string(verdict_name(part.verdict)), verdicts) + "  " +
             pad_left(of(part.points, exercise_->parts[i].points), points);
      out += "\n";
      if (!part.feedback.empty() && part.verdict != Verdict::correct)
        out += "      " + printable(feedback(part, given)) + "\n";
    }
  }

  const Exercise* exercise_;
  bool several_;
  std::vector<Row> rows_;
};

}  // namespace

const ReportFormat& report_text() {
  static const ReportFormat format{"text", "to be read: a block for each student, then a table of scores",
                                   [](const Exercise& exercise, std::size_t submissions) -> std::unique_ptr<Report> {
                                     return std::make_unique<TextReport>(exercise, submissions);
                                   }};
  return format;
}

}  // namespace blossom
