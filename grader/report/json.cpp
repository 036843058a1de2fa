// Grades as JSON, one object per line, so that a class of any size is written and read line by line. It is for whoever
// grades and for programs, not for students: every part's verdict is in it at every level of feedback.

#include "grader/report/facts.hpp"

namespace blossom {
namespace {

void write_number(const Exact& x, std::string& out) {
  if (x.is_integer())
    out += x.to_string();
  else
    out += format_number(x.to_double());
}

class JsonReport final : public Report {
 public:
  void add(const StudentResult& result, std::string& out) override {
    for (const ExerciseResult& exercise : result.exercises) {
      if (!exercise.grade) continue;
      write_json(*exercise.grade, out);
      out += '\n';
    }
  }
};

}  // namespace

void write_json(const Grade& grade, std::string& out) {
  const Exercise& exercise = *grade.exercise;
  out += R"({"schema":"blossom.grade/1","exercise":)";
  append_json_text(exercise.id, out);
  if (!grade.student.empty()) {
    out += R"(,"student":)";
    append_json_text(grade.student, out);
  }
  out += R"(,"score":)";
  write_number(grade.points / exercise.max_points, out);
  out += R"(,"points":)";
  write_number(grade.points, out);
  out += R"(,"max_points":)";
  write_number(exercise.max_points, out);
  out += R"(,"parts":[)";
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const PartGrade& part = grade.parts[i];
    out += i > 0 ? R"(,{"value":)" : R"({"value":)";
    append_json_text(exercise.parts[i].name, out);
    out += R"(,"verdict":")";
    out += verdict_name(part.verdict);
    out += R"(","points":)";
    write_number(part.points, out);
    out += R"(,"max_points":)";
    write_number(exercise.parts[i].points, out);
    out += R"(,"feedback":)";
    append_json_text(part.feedback, out);
    if (!part.note.empty() && shows_notes(exercise.feedback)) {
      out += R"(,"note":)";
      append_json_text(part.note, out);
    }
    out += '}';
  }
  out += ']';
  if (!grade.reason.empty()) {
    out += R"(,"reason":)";
    append_json_text(grade.reason, out);
  }
  if (grade.explanation && shows_notes(exercise.feedback)) {
    out += R"(,"explanation":{"misconceptions":[)";
    for (const Misconception* misconception : grade.explanation->misconceptions) {
      if (out.back() != '[') out += ',';
      append_json_text(misconception->id, out);
    }
    out += R"(],"covered":)" + std::to_string(grade.explanation->covered);
    out += R"(,"wrong":)" + std::to_string(grade.explanation->wrong) + '}';
  }
  if (!grade.notes.empty()) {
    out += R"(,"notes":[)";
    for (std::size_t i = 0; i < grade.notes.size(); ++i) {
      if (i > 0) out += ',';
      append_json_text(grade.notes[i], out);
    }
    out += ']';
  }
  out += '}';
}

const ReportFormat& report_json() {
  static const ReportFormat format{
      "json", "one JSON object per submission and line (schema blossom.grade/1)", "jsonl", ReportFormat::Scope::course,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<JsonReport>(); }};
  return format;
}

}  // namespace blossom
