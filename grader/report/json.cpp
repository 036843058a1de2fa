// Grades as JSON, one object per line, so that a class of any size is written and read line by line.

#include "grader/report/report.hpp"

namespace blossom {
namespace {

// A quoted text; most of ours needs no escapes.
void write_text(std::string_view text, std::string& out) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7F || c == '"' || c == '\\') {
      out += json_quote(text);
      return;
    }
  }
  out += '"';
  out += text;
  out += '"';
}

void write_number(const Exact& x, std::string& out) {
  if (x.is_integer())
    out += x.to_string();
  else
    out += format_number(x.to_double());
}

class JsonReport final : public Report {
 public:
  void add(const Grade& grade, std::string& out) override {
    write_json(grade, out);
    out += '\n';
  }
};

}  // namespace

void write_json(const Grade& grade, std::string& out) {
  const Exercise& exercise = *grade.exercise;
  out += R"({"schema":"blossom.grade/1","exercise":)";
  write_text(exercise.id, out);
  if (!grade.student.empty()) {
    out += R"(,"student":)";
    write_text(grade.student, out);
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
    write_text(exercise.parts[i].name, out);
    out += R"(,"verdict":")";
    out += verdict_name(part.verdict);
    out += R"(","points":)";
    write_number(part.points, out);
    out += R"(,"max_points":)";
    write_number(exercise.parts[i].points, out);
    out += R"(,"feedback":)";
    write_text(part.feedback, out);
    out += '}';
  }
  out += ']';
  if (!grade.reason.empty()) {
    out += R"(,"reason":)";
    write_text(grade.reason, out);
  }
  if (!grade.notes.empty()) {
    out += R"(,"notes":[)";
    for (std::size_t i = 0; i < grade.notes.size(); ++i) {
      if (i > 0) out += ',';
      write_text(grade.notes[i], out);
    }
    out += ']';
  }
  out += '}';
}

const ReportFormat& report_json() {
  static const ReportFormat format{
      "json", "one JSON object per submission and line (schema blossom.grade/1)",
      [](const Exercise&, std::size_t) -> std::unique_ptr<Report> { return std::make_unique<JsonReport>(); }};
  return format;
}

}  // namespace blossom
