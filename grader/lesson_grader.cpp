#include "grader/lesson_grader.hpp"

#include <algorithm>

#include "algorithms/typeset.hpp"
#include "base/json_write.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_shown = 40;  // characters of an answer that is said to be wrong

// A text of a lesson at its step.
std::string filled(const LocalText& text, const Narrator<Exact>& narrator, std::uint32_t step,
                   std::string_view language) {
  return text.empty() ? std::string() : narrator.fill(text.in(language), step);
}

// The same as it is read aloud.
std::string said(const LocalText& text, const Narrator<Exact>& narrator, std::uint32_t step,
                 std::string_view language) {
  return plain_text(read_prose(filled(text, narrator, step, language)));
}

std::string with_commas(std::string_view letters) {
  std::string text;
  for (const char c : letters) text += (text.empty() ? "" : ", ") + std::string(1, c);
  return text;
}

// What a letter or a line is called in a sentence: "b", "c, a, b", "line 4".
std::string name_of(const Question& question) {
  switch (question.kind) {
    case Checkpoint::Kind::line:
      return "line " + question.right;
    case Checkpoint::Kind::order:
      return with_commas(question.right);
    default:
      return question.right;
  }
}

// The checkpoint in this run, which may be another than the lesson's own.
Question question_of(const Checkpoint& checkpoint, const Narrator<Exact>& narrator, std::uint32_t step,
                     std::string_view language) {
  Question made;
  made.kind = checkpoint.kind;
  made.ask = filled(checkpoint.ask, narrator, step, language);
  made.praise = said(checkpoint.right, narrator, step, language);
  made.blame = said(checkpoint.wrong, narrator, step, language);
  if (made.is_value()) return made;
  made.right = right_letters(checkpoint);
  made.count = checkpoint.items.size() + checkpoint.choices.size();
  for (const Checkpoint::Choice& choice : checkpoint.choices) {
    made.options.push_back(filled(choice.text, narrator, step, language));
    made.feedback.push_back(said(choice.feedback, narrator, step, language));
  }
  if (!checkpoint.items.empty())
    for (const std::size_t item : shown_order(checkpoint))
      made.options.push_back(filled(checkpoint.items[item], narrator, step, language));
  if (checkpoint.kind == Checkpoint::Kind::line && step + 1 < narrator.trace().step_count()) {
    const auto& lines = narrator.algorithm_at(step + 1).pseudo_code;
    made.right = std::to_string(narrator.line(step + 1));
    made.count = lines.size();
    made.options.assign(lines.begin(), lines.end());
  }
  return made;
}

// The checkpoint's value as a part of an exercise on that run; nothing where the run has no such value.
std::optional<Part> value_part(const Checkpoint& checkpoint, const Narrator<Exact>& narrator) {
  const auto& trace = narrator.trace();
  const auto value = trace.find(checkpoint.value);
  if (!value) return std::nullopt;
  Part part;
  part.value = *value;
  part.name = checkpoint.id;
  part.kind = trace.value(*value).kind;
  part.points = checkpoint.points;
  part.tolerance = {Tolerance::Kind::decimals, checkpoint.decimals, 0};
  complete_part(part, narrator);
  if (part.right.empty()) {  // a point at infinity has no coordinates but these
    part.form = Form::homogeneous;
    complete_part(part, narrator);
  }
  return part;
}

void add(Exercise& exercise, Part part) {
  exercise.max_points += part.points;
  exercise.part_of_name.emplace(part.name, exercise.parts.size());
  exercise.parts.push_back(std::move(part));
}

std::string shown(const Json& answer) {
  switch (answer.kind) {
    case Json::Kind::string:
      return excerpt(answer.text.size() <= most_shown ? answer.text : answer.text.substr(0, most_shown) + "...");
    case Json::Kind::number:
      return answer.text.substr(0, most_shown);
    case Json::Kind::array:
      return "an array of " + std::to_string(answer.items.size());
    case Json::Kind::object:
      return "an object";
    case Json::Kind::null:
    case Json::Kind::boolean:
      break;
  }
  return "no text";
}

// The letters of "cab", "C A B", "c, a, b" or ["c", "a", "b"], small; nothing if it is not made of letters.
std::optional<std::string> letters_in(const Json& answer) {
  std::string letters;
  const auto take = [&](const std::string& text) {
    if (text.size() > most_shown) return false;
    for (const char c : text) {
      const char small = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      if ('a' <= small && small <= 'z')
        letters += small;
      else if (c != ' ' && c != ',')
        return false;
    }
    return true;
  };
  if (answer.kind == Json::Kind::string) return take(answer.text) ? std::optional(letters) : std::nullopt;
  if (answer.kind != Json::Kind::array || answer.items.size() > most_shown) return std::nullopt;
  for (const Json& item : answer.items)
    if (item.kind != Json::Kind::string || !take(item.text)) return std::nullopt;
  return letters;
}

LetterMark mark_line(const Question& question, const Json& answer) {
  LetterMark mark;
  const bool is_number = answer.kind == Json::Kind::number || answer.kind == Json::Kind::string;
  const auto number = is_number ? parse_typed(answer.text) : std::nullopt;
  if (!number || !number->is_integer() || *number < Exact(1) ||
      Exact(static_cast<std::int64_t>(question.count)) < *number) {
    mark.problem =
        "must be the number of a line, from 1 to " + std::to_string(question.count) + ", not " + shown(answer);
    return mark;
  }
  mark.verdict = number->to_string() == question.right ? Verdict::correct : Verdict::wrong;
  mark.choice = static_cast<std::size_t>(number->to_double()) - 1;
  return mark;
}

bool is_in(const Lesson& lesson, std::string_view language) {
  return language == lesson.languages.own || std::ranges::count(lesson.languages.others, language) > 0;
}

const Beat* beat_of(const LessonScene& scene, const Checkpoint& checkpoint) {
  for (const Beat& beat : scene.beats)
    if (beat.checkpoint && beat.checkpoint->id == checkpoint.id) return &beat;
  return nullptr;
}

}  // namespace

LetterMark mark_letters(const Question& question, const Json& answer) {
  if (question.kind == Checkpoint::Kind::line) return mark_line(question, answer);
  LetterMark mark;
  const auto letters = letters_in(answer);
  const std::string last = letter_of(question.count - 1);
  const auto is_one = [&](char c) { return c <= last[0]; };
  if (question.kind == Checkpoint::Kind::order) {
    std::string sorted = letters.value_or("");
    std::ranges::sort(sorted);
    const bool each_once = std::ranges::adjacent_find(sorted) == sorted.end() && std::ranges::all_of(sorted, is_one);
    if (sorted.size() != question.count || !each_once) {
      mark.problem = "must have each of the letters a to " + last + " once, not " + shown(answer);
      return mark;
    }
  } else if (!letters || letters->size() != 1 || !is_one((*letters)[0])) {
    mark.problem = "must be one letter from a to " + last + ", not " + shown(answer);
    return mark;
  } else {
    mark.choice = static_cast<std::size_t>((*letters)[0] - 'a');
  }
  mark.verdict = *letters == question.right ? Verdict::correct : Verdict::wrong;
  return mark;
}

Checked<Exercise> make_sheet(const Lesson& lesson, std::string_view language) {
  Exercise sheet;
  sheet.id = lesson.id;
  sheet.title = lesson.title.in(language);
  sheet.prompt = lesson.summary.in(language);
  sheet.unit = lesson.unit.in(language);
  sheet.source = lesson.source;
  for (std::size_t s = 0; s < lesson.scene_count(); ++s) {
    const LessonScene& scene = lesson.scene_at(s);
    Exercise& of_scene = sheet.scenes.emplace_back();
    of_scene.id = lesson.id;
    of_scene.title = scene.heading.in(language);
    of_scene.tolerance = {Tolerance::Kind::decimals, Checkpoint().decimals, 0};
    auto run = record<Exact>(*scene.algorithm, scene.inputs);
    if (!run) return run.diagnostics;
    of_scene.run = std::move(*run);
    const Narrator<Exact> narrator(of_scene.run);
    for (const Beat& beat : scene.beats) {
      if (!beat.checkpoint) continue;
      const Checkpoint& checkpoint = *beat.checkpoint;
      Question question = question_of(checkpoint, narrator, beat.step, language);
      question.scene = s;
      Part part;
      part.name = checkpoint.id;
      part.value = absent;
      part.points = checkpoint.points;
      if (question.is_value()) {
        auto of_value = value_part(checkpoint, narrator);
        if (!of_value) continue;
        of_value->feedback = question.blame;
        question.part = of_scene.parts.size();
        part = *of_value;  // it is read and written down as the value is
        part.value = absent;
        add(of_scene, *std::move(of_value));
      } else {
        part.solution = name_of(question);
      }
      part.question = std::make_shared<const Question>(std::move(question));
      add(sheet, std::move(part));
    }
  }
  sheet.run = sheet.scenes.front().run;
  return sheet;
}

Checked<Exercise> read_sheet(const JsonDocument& document, std::string_view language) {
  const auto lesson = load_lesson(document);
  if (!lesson) return lesson.diagnostics;
  Diagnostics diagnostics;
  if (!language.empty() && !is_in(*lesson, language)) {
    std::string known = lesson->languages.own;
    for (const std::string& other : lesson->languages.others) known += ", " + other;
    Cursor(document, diagnostics).error("is not in the language " + excerpt(language) + "; it is in " + known);
    return diagnostics;
  }
  auto sheet = make_sheet(*lesson, language);
  if (!sheet || sheet->max_points != Exact(0)) return sheet;
  Cursor(document, diagnostics)
      .error(sheet->parts.empty() ? "has no checkpoints, so there is nothing to grade: give a beat a \"checkpoint\""
                                  : "must have a checkpoint that is worth more than 0 points");
  return diagnostics;
}

CheckpointMark mark_checkpoint(const Run<Exact>& run, std::uint32_t step, const Checkpoint& checkpoint,
                               const Json& answer, std::string_view language) {
  const Narrator<Exact> narrator(run);
  const Question question = question_of(checkpoint, narrator, step, language);
  const auto fill = [&](const LocalText& text) { return narrator.fill(text.in(language), step); };
  CheckpointMark mark;
  LocalText to_choice;
  if (question.is_value()) {
    auto part = value_part(checkpoint, narrator);
    if (!part) return mark;
    const bool is_hidden =
        !narrator.trace().scope(part->value).empty();  // of a run within the run: nobody's name for it
    mark.right = (is_hidden ? "" : checkpoint.value + " = ") + narrator.value_text(part->value);
    Exercise alone;
    alone.id = checkpoint.id;
    alone.feedback = Feedback::hint;
    alone.tolerance = part->tolerance;
    alone.run = run;
    add(alone, *std::move(part));
    const Grader grader(std::move(alone));
    const Grade grade = grader.grade(json_object({{"schema", json_string("blossom.answers/1")},
                                                  {"exercise", json_string(checkpoint.id)},
                                                  {"answers", json_object({{checkpoint.id, answer}})}}));
    const PartGrade& made = grade.parts.front();
    mark.verdict = made.verdict;
    mark.points = made.points;
    if (mark.verdict != Verdict::correct) mark.note = unicode_text(typeset_text(made.feedback, *run.algorithm));
  } else {
    const LetterMark letters = mark_letters(question, answer);
    mark.verdict = letters.verdict;
    mark.right = name_of(question);
    if (mark.verdict == Verdict::correct) mark.points = checkpoint.points;
    if (mark.verdict == Verdict::invalid)
      mark.note = "The answer cannot be read: it " + letters.problem + ".";
    else if (letters.choice < checkpoint.choices.size())
      to_choice = checkpoint.choices[letters.choice].feedback;
  }
  if (mark.verdict == Verdict::invalid) return mark;
  const LocalText& general = mark.verdict == Verdict::correct ? checkpoint.right : checkpoint.wrong;
  if (!to_choice.empty()) mark.words = fill(to_choice);
  if (!general.empty()) mark.words += (mark.words.empty() ? "" : "\n\n") + fill(general);
  return mark;
}

CheckpointMark mark_checkpoint(const Lesson& lesson, std::size_t scene, const Checkpoint& checkpoint,
                               const Json& answer, std::string_view language) {
  const LessonScene& here = lesson.scene_at(scene);
  const Beat* const beat = beat_of(here, checkpoint);
  const auto run = record<Exact>(*here.algorithm, here.inputs);
  if (beat == nullptr || !run) return {};
  return mark_checkpoint(*run, beat->step, checkpoint, answer, language);
}

}  // namespace blossom
