#include "grader/assignment.hpp"

#include <algorithm>
#include <limits>

#include "grader/lesson_grader.hpp"
#include "lesson/document.hpp"
#include "lesson/file_kind.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_exercises = 100;
constexpr int most_points = 1'000'000;

template <class T>
std::optional<T> word(const Cursor& at, const std::vector<std::pair<std::string, T>>& words) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  std::vector<std::string> known;
  std::string message = "must be one of";
  for (const auto& [name, value] : words) {
    if (name == *text) return value;
    message += (known.empty() ? " " : ", ") + json_quote(name);
    known.push_back(name);
  }
  const auto near = did_you_mean(*text, known);
  at.error(message + ", not " + excerpt(*text) + (near ? "; did you mean " + json_quote(*near) + "?" : ""));
  return std::nullopt;
}

// The text of an array or object that begins at a token, with all before it blank: what is said of it stands at the
// line and column that it has in the whole.
std::string alone_in_its_place(const JsonDocument& document, const Json& json) {
  const auto [line, column] = document.line_and_column(json.token);
  const std::string& text = document.text();
  std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  std::string alone;
  for (int at_line = 1; at_line < line; ++begin)
    if (text[begin] == '\n') {
      alone += '\n';
      ++at_line;
    }
  const auto continues = [&](std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
  };
  for (int at_column = 1; at_column < column; ++at_column) {
    alone += ' ';
    do ++begin;
    while (continues(begin));
  }
  std::size_t end = begin;
  for (int depth = 0; end < text.size(); ++end) {
    const char c = text[end];
    if (c == '"')
      while (text[++end] != '"') end += text[end] == '\\' ? 1 : 0;
    else if (c == '{' || c == '[')
      ++depth;
    else if ((c == '}' || c == ']') && --depth == 0)
      break;
  }
  return alone + text.substr(begin, end + 1 - begin);
}

// An exercise, or the checkpoints of a lesson.
Checked<Exercise> read_one(const JsonDocument& document, std::string_view language) {
  return file_kind(document.root()) == FileKind::lesson ? read_sheet(document, language) : read_exercise(document);
}

class AssignmentReader {
 public:
  AssignmentReader(const JsonDocument& document, std::string_view language, Diagnostics& diagnostics)
      : document_(&document), language_(language), diagnostics_(&diagnostics), root_(document, diagnostics) {}

  void read() {
    if (!root_.expect_object({"$schema", "schema", "id", "title", "exercises", "due", "late", "attempts", "feedback",
                              "full_feedback_from", "lms_id", "source"}))
      return;
    expect_schema(root_, "blossom.assignment/1");
    if (const auto at = root_.required("id")) assignment.id = read_id(*at).value_or("");
    if (const auto at = root_.required("title")) assignment.title = read_text(*at).value_or("");
    if (const auto at = root_.optional("lms_id")) assignment.lms_id = read_text(*at).value_or("");
    if (const auto at = root_.optional("source")) at->string();
    if (const auto at = root_.optional("due")) {
      assignment.due = read_time(*at);
      if (assignment.due) assignment.offset = offset_in(at->json().text);
    }
    if (const auto at = root_.optional("late")) read_late(*at);
    if (const auto at = root_.optional("attempts"))
      assignment.attempts =
          word<Attempts>(*at, {{"last", Attempts::last}, {"best", Attempts::best}, {"first", Attempts::first}})
              .value_or(Attempts::last);
    if (const auto at = root_.optional("feedback"))
      assignment.feedback = word<Feedback>(*at, {{"none", Feedback::none},
                                                 {"verdict", Feedback::verdict},
                                                 {"hint", Feedback::hint},
                                                 {"full", Feedback::full}});
    if (const auto at = root_.optional("full_feedback_from")) {
      assignment.full_feedback_from = read_time(*at);
      if (assignment.full_feedback_from && !assignment.due) assignment.offset = offset_in(at->json().text);
      if (assignment.full_feedback_from && assignment.due && *assignment.full_feedback_from < *assignment.due)
        at->error("is before \"due\": everybody would have the solutions while answers are still handed in");
    }
    const auto exercises = root_.required("exercises");
    if (!exercises || !exercises->expect_array(1, most_exercises)) return;
    for (std::size_t i = 0; i < exercises->size(); ++i) read_item((*exercises)[i]);
    if (!root_.has_errors() && assignment.max_points == Exact(0))
      exercises->error("must be worth more than 0 points in all");
  }

  // An exercise alone.
  void read_only(Exercise exercise) {
    assignment.id = exercise.id;
    assignment.title = exercise.title;
    assignment.max_points = exercise.max_points;
    const Exact points = exercise.max_points;
    assignment.items.push_back({*document_, std::move(exercise), points});
  }

  Assignment assignment;

 private:
  void read_late(const Cursor& at) {
    if (!at.expect_object({"grace_minutes", "per_day", "at_most_days"})) return;
    if (root_.json().find("due") == nullptr) at.error("means nothing without \"due\"");
    LatePolicy& late = assignment.late;
    if (const auto grace = at.optional("grace_minutes"))
      late.grace_minutes = grace->integer(0, 7 * 24 * 60).value_or(0);
    if (const auto per_day = at.optional("per_day"))
      if (auto share = per_day->number()) {
        if (*share < Exact(0) || Exact(1) < *share)
          per_day->error("must be a share from 0 to 1, not " + excerpt(per_day->json().text));
        late.per_day = std::move(*share);
      }
    if (const auto days = at.optional("at_most_days")) late.at_most_days = days->integer(0, 3650);
  }

  void read_item(const Cursor& at) {
    if (!at.expect_object({"file", "exercise", "points"})) return;
    const auto file = at.optional("file");
    const auto inlined = at.optional("exercise");
    if (file.has_value() == inlined.has_value()) {
      at.error("must have either \"file\", the path of an exercise, or \"exercise\", the exercise itself");
      return;
    }
    std::optional<Exact> points;
    if (const auto given = at.optional("points")) {
      points = given->number();
      if (points && (*points < Exact(0) || Exact(most_points) < *points))
        given->error("must be from 0 to " + std::to_string(most_points) + ", not " + excerpt(given->json().text));
    }
    const Cursor& place = file ? *file : *inlined;
    auto document = file ? load(*file) : parse(*inlined);
    if (!document) return;
    auto exercise = read_one(*document, language_);
    if (!exercise) {
      for (Diagnostic& diagnostic : exercise.diagnostics) add(std::move(diagnostic), inlined);
      return;
    }
    if (const auto other = assignment.item(exercise->id)) {
      place.error("the exercise " + excerpt(exercise->id) + " is exercises[" + std::to_string(*other) +
                  "] already: answers name it by that id");
      return;
    }
    // Of an exercise whose parts are all dropped nothing is left to be earned.
    const Exact worth = exercise->max_points == Exact(0) ? Exact(0) : points.value_or(exercise->max_points);
    assignment.max_points += worth;
    assignment.items.push_back({std::move(*document), std::move(*exercise), worth});
  }

  std::optional<JsonDocument> load(const Cursor& at) {
    const auto name = read_text(at);
    if (!name) return std::nullopt;
    const auto folder = std::filesystem::path(document_->name()).parent_path();
    auto document = JsonDocument::load(folder / *name);
    if (document) {
      const FileKind kind = file_kind(document->root());
      if (kind == FileKind::exercise || kind == FileKind::lesson || kind == FileKind::unknown)
        return std::move(document.value);
      at.error("must be the path of an exercise, or of a lesson for its checkpoints; " + excerpt(*name) +
               " is of the kind " + std::string(file_kind_name(kind)));
      return std::nullopt;
    }
    for (Diagnostic& diagnostic : document.diagnostics) {
      if (diagnostic.line == 0)
        at.error(excerpt(*name) + " " + diagnostic.message);  // not to be found: the mistake is here
      else
        diagnostics_->push_back(std::move(diagnostic));
    }
    return std::nullopt;
  }

  std::optional<JsonDocument> parse(const Cursor& at) {
    if (!at.is(Json::Kind::object)) {
      at.error("must be an exercise, an object {\"schema\", \"id\", ...}");
      return std::nullopt;
    }
    auto document = JsonDocument::parse(document_->name(), alone_in_its_place(*document_, at.json()));
    for (Diagnostic& diagnostic : document.diagnostics) diagnostics_->push_back(std::move(diagnostic));
    return std::move(document.value);
  }

  void add(Diagnostic diagnostic, const std::optional<Cursor>& inlined) {
    if (inlined) diagnostic.path = inlined->path() + (diagnostic.path.empty() ? "" : ".") + diagnostic.path;
    diagnostics_->push_back(std::move(diagnostic));
  }

  const JsonDocument* document_;
  std::string_view language_;
  Diagnostics* diagnostics_;
  Cursor root_;
};

}  // namespace

int LatePolicy::days_late(Time due, Time submitted) const {
  if (submitted <= due + std::chrono::minutes(grace_minutes)) return 0;
  const auto days = std::chrono::ceil<std::chrono::days>(submitted - due).count();
  return static_cast<int>(std::min<std::int64_t>(days, std::numeric_limits<int>::max()));
}

Exact LatePolicy::share(int days) const {
  if (days <= 0) return 1;
  if (at_most_days && days > *at_most_days) return 0;
  return std::max(Exact(0), Exact(1) - Exact(days) * per_day);
}

std::optional<std::size_t> Assignment::item(std::string_view exercise_id) const {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].exercise.id == exercise_id) return i;
  return std::nullopt;
}

std::string no_exercise_of(const Assignment& assignment, std::string_view id) {
  constexpr std::size_t most_named = 8;
  std::vector<std::string> ids;
  std::string named;
  for (const Assignment::Item& item : assignment.items) {
    if (ids.size() < most_named) named += (ids.empty() ? "" : ", ") + excerpt(item.exercise.id);
    ids.push_back(item.exercise.id);
  }
  std::string text = excerpt(id) + " is no exercise of this assignment";
  if (const auto near = did_you_mean(id, ids)) return text + "; did you mean " + excerpt(*near) + "?";
  return text + (ids.size() == 1 ? ", which is " : ", which has ") + named + (ids.size() > most_named ? ", ..." : "");
}

Feedback Assignment::feedback_at(std::size_t item, Time now) const {
  if (full_feedback_from && *full_feedback_from <= now) return Feedback::full;
  return feedback.value_or(items[item].exercise.feedback);
}

Checked<Assignment> read_assignment(const JsonDocument& document, std::string_view language) {
  Diagnostics diagnostics;
  AssignmentReader reader(document, language, diagnostics);
  if (file_kind(document.root()) == FileKind::assignment) {
    reader.read();
    if (!diagnostics.empty()) return diagnostics;
    return std::move(reader.assignment);
  }
  if (const FileKind kind = file_kind(document.root());
      kind != FileKind::exercise && kind != FileKind::lesson && kind != FileKind::unknown) {
    Cursor(document, diagnostics)
        .error("is " + with_article(kind) +
               ", where an exercise, an assignment or a lesson is wanted (schema blossom.exercise/1, "
               "blossom.assignment/1 or blossom.lesson/1)");
    return diagnostics;
  }
  auto exercise = read_one(document, language);
  if (!exercise) return exercise.diagnostics;
  reader.read_only(std::move(*exercise));
  return std::move(reader.assignment);
}

Checked<Assignment> load_assignment(const std::filesystem::path& path, std::string_view language) {
  const auto document = JsonDocument::load(path);
  if (!document) return document.diagnostics;
  return read_assignment(*document, language);
}

}  // namespace blossom
