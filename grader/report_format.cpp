#include <algorithm>

#include "base/utf8.hpp"
#include "grader/csv.hpp"
#include "grader/page/student_run.hpp"
#include "grader/report/facts.hpp"

namespace blossom {
namespace {

// A control character of at most three bytes as JSON writes it by its number.
void append_escape(std::string_view character, std::string& out) {
  constexpr char digits[] = "0123456789abcdef";
  unsigned code = static_cast<unsigned char>(character[0]) & (character.size() == 1 ? 0x7Fu : 0x1Fu);
  for (const char c : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  out += "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) out += digits[code >> shift & 15];
}

bool is_passed(const Part& part, const PartGrade& grade) {
  return grade.verdict == Verdict::correct || grade.verdict == Verdict::carried || part.voided != Voided::no;
}

// An unreadable file is told by its grade's reason already.
bool is_told(const Incident& incident, const ExerciseResult& of) {
  return incident.kind == Incident::Kind::unreadable && of.grade && !of.grade->reason.empty() &&
         incident.source == of.source;
}

// For students, whom the kinds' own names tell nothing.
std::string_view words_for(Incident::Kind kind) {
  switch (kind) {
    case Incident::Kind::late:
      return "Late";
    case Incident::Kind::missing:
      return "Missing";
    case Incident::Kind::duplicate:
      return "Handed in more than once";
    case Incident::Kind::unreadable:
      return "Cannot be read";
    case Incident::Kind::misplaced:
      return "Not part of this assignment";
    case Incident::Kind::foreign_id:
      return "Another name in the file";
    case Incident::Kind::unlisted:
      return "Not on the class list";
    case Incident::Kind::failed:
      return "Could not be graded";
    case Incident::Kind::refused:
      return "Not looked at";
  }
  return {};
}

std::string sentence_of(const Incident& incident) {
  std::string text(words_for(incident.kind));
  if (!incident.source.empty()) text += " (" + printable(incident.source) + ")";
  return as_sentence(text + ": " + printable(incident.text));
}

void add_grade(const ExerciseResult& of, ExerciseFacts& facts) {
  const Grade& grade = *of.grade;
  const Exercise& exercise = *grade.exercise;
  const Exact scale = exercise.max_points == Exact(0) ? Exact(0) : of.max_points / exercise.max_points;
  facts.grade = &grade;
  facts.before_late = grade.points * scale;
  if (!grade.reason.empty()) facts.notes.push_back(as_sentence("Invalid: " + printable(grade.reason)));
  for (const std::string& note : grade.notes) facts.notes.push_back(as_sentence("Note: " + printable(note)));
  if (!grade.reason.empty() || exercise.feedback == Feedback::none) return;
  const Json* answers = of.answers ? of.answers->root().find("answers") : nullptr;
  const bool shows_text = exercise.feedback != Feedback::verdict;
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const Part& part = exercise.parts[i];
    const PartGrade& made = grade.parts[i];
    facts.parts.push_back({part.name,
                           verdict_name(made.verdict),
                           is_passed(part, made),
                           made.points * scale,
                           part.points * scale,
                           shows_text && made.verdict != Verdict::correct ? printable(made.feedback) : std::string(),
                           {}});
    if (made.verdict == Verdict::correct) continue;
    if (const Json* typed = answers != nullptr ? answers->find(part.name) : nullptr)
      facts.parts.back().typed = printable(typed_text(*typed));
  }
}

}  // namespace

const ReportFormat* find_report_format(std::string_view name) {
  for (const ReportFormat* format : report_formats())
    if (format->name == name) return format;
  return nullptr;
}

ResultFacts facts_of(const StudentResult& result) {
  ResultFacts all;
  std::vector<char> told(result.incidents.size(), 0);
  for (const ExerciseResult& of : result.exercises) {
    const Assignment::Item& item = result.assignment->items[of.item];
    ExerciseFacts& facts = all.exercises.emplace_back();
    facts.id = item.exercise.id;
    facts.title = item.exercise.title;
    facts.points = of.points;
    facts.max_points = of.max_points;
    if (of.grade) {
      add_grade(of, facts);
      all.readable = all.readable || of.grade->reason.empty();
    }
    for (std::size_t i = 0; i < result.incidents.size(); ++i) {
      const Incident& incident = result.incidents[i];
      if (incident.exercise != facts.id) continue;
      told[i] = 1;
      if (!is_told(incident, of)) facts.notes.push_back(sentence_of(incident));
    }
    if (!of.grade && facts.notes.empty()) facts.notes.emplace_back("Nothing was handed in.");
  }
  for (std::size_t i = 0; i < result.incidents.size(); ++i)
    if (told[i] == 0) all.notes.push_back(sentence_of(result.incidents[i]));
  return all;
}

std::vector<std::string> ResultFacts::all_notes() const {
  std::vector<std::string> lines;
  for (const ExerciseFacts& exercise : exercises)
    for (const std::string& note : exercise.notes)
      lines.push_back(exercises.size() > 1 ? printable(exercise.title) + ": " + note : note);
  lines.insert(lines.end(), notes.begin(), notes.end());
  return lines;
}

std::string points_text(const Exact& points) { return csv_number(points.to_double()); }

std::string points_of(const Exact& points, const Exact& max_points) {
  return points_text(points) + " of " + points_text(max_points) + " points";
}

void append_json_text(std::string_view text, std::string& out) {
  if (std::ranges::all_of(text, [](char c) { return 0x20 <= c && c < 0x7F && c != '"' && c != '\\'; })) {
    out += '"';
    out += text;
    out += '"';
    return;
  }
  const std::string quoted = json_quote(text);
  for (std::size_t i = 0; i < quoted.size();) {
    const std::string_view character = std::string_view(quoted).substr(i, utf8_length(quoted, i));
    i += character.size();
    if (is_control(character))
      append_escape(character, out);
    else
      out += character;
  }
}

void append_json_key(std::string_view key, std::string& out) {
  if (!out.ends_with('{')) out += ',';
  out += '"';
  out += key;
  out += "\":";
}

}  // namespace blossom
