// Results as JSON, one line for each student.

#include <algorithm>

#include "grader/result.hpp"

namespace blossom {
namespace {

void write_text(std::string_view text, std::string& out) {
  const bool plain = std::ranges::all_of(text, [](char c) { return 0x20 <= c && c < 0x7F && c != '"' && c != '\\'; });
  if (!plain) {
    out += json_quote(text);
    return;
  }
  out += '"';
  out += text;
  out += '"';
}

void write_key(std::string_view key, std::string& out) {
  if (out.back() != '{') out += ',';
  out += '"';
  out += key;
  out += "\":";
}

void write_member(std::string_view key, std::string_view text, std::string& out) {
  write_key(key, out);
  write_text(text, out);
}

void write_member(std::string_view key, const Exact& number, std::string& out) {
  write_key(key, out);
  out += number.is_integer() ? number.to_string() : format_number(number.to_double());
}

// What was typed, as it was typed. It may be nested: without recursion.
void write_answer(const Json& answer, std::string& out) {
  struct Open {
    const Json* json;
    std::size_t next;
  };
  std::vector<Open> open;
  const auto begin = [&](const Json& json) {
    switch (json.kind) {
      case Json::Kind::null:
        out += "null";
        break;
      case Json::Kind::boolean:
        out += json.boolean ? "true" : "false";
        break;
      case Json::Kind::number:
        out += json.text;
        break;
      case Json::Kind::string:
        write_text(json.text, out);
        break;
      case Json::Kind::array:
      case Json::Kind::object:
        out += json.kind == Json::Kind::array ? '[' : '{';
        open.push_back({&json, 0});
        break;
    }
  };
  begin(answer);
  while (!open.empty()) {
    auto& [json, next] = open.back();
    if (next == json->items.size()) {
      out += json->kind == Json::Kind::array ? ']' : '}';
      open.pop_back();
      continue;
    }
    const std::size_t i = next++;
    if (i > 0) out += ',';
    if (json->kind == Json::Kind::object) {
      write_text(json->keys[i], out);
      out += ':';
    }
    begin(json->items[i]);
  }
}

// How much of a grade its reader may see.
struct Shown {
  bool parts = true;
  bool reasons = true;  // what is wrong, not only that it is
  bool answers = true;
};

Shown shown_to(Audience audience, Feedback level) {
  if (audience == Audience::instructor) return {};
  return {level != Feedback::none, level == Feedback::hint || level == Feedback::full, false};
}

void write_parts(const Grade& grade, const Json* answers, const Shown& shown, std::string& out) {
  const Exercise& exercise = *grade.exercise;
  write_key("parts", out);
  out += '[';
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const PartGrade& made = grade.parts[i];
    const Part& part = exercise.parts[i];
    out += i > 0 ? ",{" : "{";
    write_member("value", part.name, out);
    // Which kind of wrong it is would be a reason.
    const bool is_wrong = made.verdict == Verdict::misconception || made.verdict == Verdict::slip;
    write_member("verdict", verdict_name(is_wrong && !shown.reasons ? Verdict::wrong : made.verdict), out);
    if (shown.reasons && !made.misconception.empty()) write_member("misconception", made.misconception, out);
    write_member("points", made.points, out);
    write_member("max_points", part.points, out);
    write_member("feedback", shown.reasons ? made.feedback : std::string(), out);
    if (shown.reasons && !made.note.empty()) write_member("note", made.note, out);
    if (const Json* answer = shown.answers && answers != nullptr ? answers->find(part.name) : nullptr) {
      write_key("answer", out);
      write_answer(*answer, out);
    }
    out += '}';
  }
  out += ']';
}

void write_explanation(const Explanation& explanation, std::string& out) {
  write_key("explanation", out);
  out += '{';
  write_key("misconceptions", out);
  out += '[';
  for (const Misconception* misconception : explanation.misconceptions) {
    if (out.back() != '[') out += ',';
    write_text(misconception->id, out);
  }
  out += ']';
  write_member("covered", Exact(static_cast<std::int64_t>(explanation.covered)), out);
  write_member("wrong", Exact(static_cast<std::int64_t>(explanation.wrong)), out);
  out += '}';
}

// blossom.grade/1, with what was typed.
void write_grade(const ExerciseResult& result, const Shown& shown, std::string& out) {
  const Grade& grade = *result.grade;
  const Exercise& exercise = *grade.exercise;
  write_key("grade", out);
  out += '{';
  write_member("schema", "blossom.grade/1", out);
  write_member("exercise", exercise.id, out);
  if (!grade.student.empty()) write_member("student", grade.student, out);
  write_member("score", exercise.max_points == Exact(0) ? Exact(0) : grade.points / exercise.max_points, out);
  write_member("points", grade.points, out);
  write_member("max_points", exercise.max_points, out);
  const Json* answers =
      result.answers != nullptr && grade.reason.empty() ? result.answers->root().find("answers") : nullptr;
  write_parts(grade, answers, shown, out);
  if (!grade.reason.empty()) write_member("reason", grade.reason, out);
  if (!grade.notes.empty()) {
    write_key("notes", out);
    out += '[';
    for (std::size_t i = 0; i < grade.notes.size(); ++i) {
      if (i > 0) out += ',';
      write_text(grade.notes[i], out);
    }
    out += ']';
  }
  if (shown.reasons && grade.explanation) write_explanation(*grade.explanation, out);
  out += '}';
}

void write_exercise(const StudentResult& student, const ExerciseResult& result, Audience audience, std::string& out) {
  out += '{';
  write_member("exercise", student.assignment->items[result.item].exercise.id, out);
  write_member("points", result.points, out);
  write_member("max_points", result.max_points, out);
  write_member("state", result.grade ? "graded" : "missing", out);
  if (!result.source.empty()) write_member("source", result.source, out);
  if (result.submitted) write_member("submitted", format_time(*result.submitted), out);
  if (result.days_late > 0) write_member("days_late", Exact(result.days_late), out);
  if (!result.digest.empty()) write_member("digest", result.digest, out);
  if (result.varies) {
    write_key("varies", out);
    out += "true";
  }
  if (result.grade) {
    const Shown shown = shown_to(audience, result.grade->exercise->feedback);
    if (shown.parts) write_grade(result, shown, out);
  }
  out += '}';
}

}  // namespace

void write_json(const StudentResult& result, Audience audience, std::string& out) {
  out += '{';
  write_member("schema", "blossom.result/1", out);
  write_member("assignment", result.assignment->id, out);
  write_key("student", out);
  out += '{';
  write_member("id", result.student.id, out);
  if (!result.student.name.empty()) write_member("name", result.student.name, out);
  if (!result.student.section.empty()) write_member("section", result.student.section, out);
  out += '}';
  write_member("score", result.max_points == Exact(0) ? Exact(0) : result.points / result.max_points, out);
  write_member("points", result.points, out);
  write_member("max_points", result.max_points, out);
  write_key("exercises", out);
  out += '[';
  for (std::size_t i = 0; i < result.exercises.size(); ++i) {
    if (i > 0) out += ',';
    write_exercise(result, result.exercises[i], audience, out);
  }
  out += ']';
  write_key("incidents", out);
  out += '[';
  bool first = true;
  for (const Incident& incident : result.incidents) {
    if (audience == Audience::student && !concerns_student(incident.kind)) continue;
    out += first ? "{" : ",{";
    first = false;
    write_member("kind", incident_name(incident.kind), out);
    if (!incident.exercise.empty()) write_member("exercise", incident.exercise, out);
    if (!incident.source.empty()) write_member("source", incident.source, out);
    write_member("text", incident.text, out);
    out += '}';
  }
  out += "]}";
}

}  // namespace blossom
