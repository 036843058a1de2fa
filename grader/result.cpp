#include "grader/result.hpp"

#include <algorithm>
#include <span>

#include "grader/digest.hpp"

namespace blossom {
namespace {

constexpr std::string_view incident_names[] = {"late",       "missing",  "duplicate", "unreadable", "misplaced",
                                               "foreign-id", "unlisted", "failed",    "refused"};

bool is_known_by(const Student& student, const std::string& name) {
  const std::string wanted = folded(name);
  for (const std::string* known : {&student.id, &student.login, &student.sis_id, &student.lms_id, &student.email})
    if (!known->empty() && folded(*known) == wanted) return true;
  return false;
}

// A submission that is for one of the exercises.
struct Candidate {
  std::size_t item = 0;
  Submission submission;
  Checked<JsonDocument> document;  // nothing: it cannot be read, and why
  std::string unreadable;          // why it is no answers file; empty if it is one
};

// Taken from the front of a path: the digits of a number without leading zeros, or one other character.
std::string_view next_piece(std::string_view& path) {
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  std::size_t end = 1;
  if (is_digit(path.front())) {
    while (end < path.size() && is_digit(path[end])) ++end;
    const std::string_view number = path.substr(0, end);
    path.remove_prefix(end);
    return number.substr(std::min(number.find_first_not_of('0'), number.size() - 1));
  }
  const std::string_view character = path.substr(0, end);
  path.remove_prefix(end);
  return character;
}

// As people number files: answers.json, answers-2.json, answers-10.json. What a folder holds stands together.
bool path_before(std::string_view a, std::string_view b) {
  const auto stem = [](std::string_view path) {
    const std::size_t point = path.find_last_of("./");
    return point != std::string_view::npos && path[point] == '.' ? path.substr(0, point) : path;
  };
  const auto rank = [](std::string_view piece) { return piece == "/" ? 0 : 1 + static_cast<unsigned char>(piece[0]); };
  std::string_view rest_a = stem(a), rest_b = stem(b);
  while (!rest_a.empty() && !rest_b.empty()) {
    const std::string_view one = next_piece(rest_a), other = next_piece(rest_b);
    if (one == other) continue;
    const bool numbers = '0' <= one[0] && one[0] <= '9' && '0' <= other[0] && other[0] <= '9';
    if (!numbers) return rank(one) < rank(other);
    return one.size() != other.size() ? one.size() < other.size() : one < other;
  }
  if (rest_a.empty() != rest_b.empty()) return rest_a.empty();
  return a < b;
}

// Handed in earlier, or at the same time and of a source that comes first. What has no time comes first.
bool earlier(const Submission& a, const Submission& b) {
  if (a.submitted != b.submitted) return a.submitted < b.submitted;
  return path_before(a.source, b.source);
}

std::string first_of(const Diagnostics& diagnostics) {
  if (diagnostics.empty()) return "cannot be read";
  Diagnostic first = diagnostics.front();
  first.file.clear();  // the author knows it, and it is a path of another machine
  return to_string(first);
}

const std::string* text_at(const Json& root, std::string_view key) {
  const Json* found = root.find(key);
  return found != nullptr && found->kind == Json::Kind::string ? &found->text : nullptr;
}

// A name that Windows takes for a device, whatever ending it has.
bool is_device(std::string_view name) {
  const std::string base = folded(name.substr(0, name.find('.')));
  constexpr std::string_view alone[] = {"con", "prn", "aux", "nul"};
  return std::ranges::find(alone, base) != std::end(alone) ||
         (base.size() == 4 && (base.starts_with("com") || base.starts_with("lpt")) && '0' <= base[3] && base[3] <= '9');
}

class StudentGrading {
 public:
  StudentGrading(Examiner& examiner, const Student& student)
      : examiner_(&examiner), assignment_(&examiner.assignment()) {
    result.assignment = assignment_;
    result.student = student;
    result.max_points = assignment_->max_points;
  }

  void sort(std::vector<Submission> submissions) {
    of_item_.resize(assignment_->items.size());
    for (Submission& submission : submissions) sort_one(std::move(submission));
    for (auto& candidates : of_item_)
      std::ranges::stable_sort(
          candidates, [](const Candidate& a, const Candidate& b) { return earlier(a.submission, b.submission); });
  }

  void grade(std::size_t item) {
    ExerciseResult none;
    none.item = item;
    none.max_points = assignment_->items[item].points;
    auto& candidates = of_item_[item];
    std::vector<Candidate*> readable;
    for (Candidate& candidate : candidates)
      if (candidate.unreadable.empty()) readable.push_back(&candidate);
    Candidate* counting = nullptr;
    ExerciseResult counted = none;
    if (!readable.empty()) {
      std::span<Candidate* const> counted_ones = readable;
      if (assignment_->attempts == Attempts::first) counted_ones = counted_ones.first(1);
      if (assignment_->attempts == Attempts::last) counted_ones = counted_ones.last(1);
      for (Candidate* each : counted_ones) {
        ExerciseResult graded = grade(*each, none);
        if (counting != nullptr && graded.points <= counted.points) continue;
        counting = each;
        counted = std::move(graded);
      }
    } else if (!candidates.empty()) {
      counting = &candidates.back();
      counted = grade(*counting, none);
    } else {
      incident(Incident::Kind::missing, item, {},
               any_lost_ ? "nothing was handed in that can be read" : "nothing was handed in");
      // The page has the student's own numbers, handed in or not.
      if (examiner_->varies(item))
        if (auto grader = examiner_->grader(item, result.student.id)) counted.grader = std::move(*grader);
    }
    for (const Candidate& candidate : candidates)
      if (&candidate != counting && candidate.unreadable.empty())
        incident(Incident::Kind::duplicate, item, candidate.submission.source, another_counts(*counting));
    if (counting != nullptr) say_late(*counting, counted);
    result.points += counted.points;
    result.exercises.push_back(std::move(counted));
  }

  StudentResult result;

 private:
  void incident(Incident::Kind kind, std::optional<std::size_t> item, std::string source, std::string text) {
    result.incidents.push_back(
        {kind, item ? assignment_->items[*item].exercise.id : std::string(), std::move(source), std::move(text)});
  }

  void sort_one(Submission submission) {
    // With one exercise there is no doubt what is meant by a file, however little of it can be read.
    const std::optional<std::size_t> only =
        assignment_->items.size() == 1 ? std::optional<std::size_t>(0) : std::nullopt;
    const auto unreadable = [&](std::optional<std::size_t> item, Checked<JsonDocument> document, std::string why) {
      incident(Incident::Kind::unreadable, item, submission.source, why);
      any_lost_ = any_lost_ || !item;
      if (item) of_item_[*item].push_back({*item, std::move(submission), std::move(document), std::move(why)});
    };
    if (!submission.problem.empty()) {
      const std::string why = submission.problem;
      return unreadable(only, Diagnostics{{"", 0, 0, "", why}}, why);
    }
    auto document = JsonDocument::parse(submission.source, submission.text, submission_limits);
    if (!document) {
      const std::string why = first_of(document.diagnostics);
      return unreadable(only, std::move(document), why);
    }
    const Json& root = document->root();
    const std::string* id = text_at(root, "exercise");
    const auto item = id != nullptr ? assignment_->item(*id) : std::nullopt;
    if (id != nullptr && !item) {
      incident(Incident::Kind::misplaced, {}, submission.source, no_exercise_of(*assignment_, *id));
      return;
    }
    if (const std::string* author = text_at(root, "student");
        author != nullptr && !is_known_by(result.student, *author))
      incident(
          Incident::Kind::foreign_id, item, submission.source,
          "the file says that it is " + excerpt(*author) + "'s; it is graded as " + excerpt(result.student.id) + "'s");
    const std::size_t probe = item.value_or(0);
    std::string why = unreadable_because(assignment_->items[probe].exercise, root);
    if (!why.empty()) return unreadable(item ? item : only, std::move(document), std::move(why));
    of_item_[probe].push_back({probe, std::move(submission), std::move(document), {}});
  }

  // Only what is wrong takes the whole way through match_answers.
  static std::string unreadable_because(const Exercise& exercise, const Json& root) {
    const std::string* schema = text_at(root, "schema");
    const std::string* id = text_at(root, "exercise");
    const Json* answers = root.find("answers");
    if (schema != nullptr && *schema == "blossom.answers/1" && id != nullptr && *id == exercise.id &&
        answers != nullptr && answers->kind == Json::Kind::object)
      return {};
    return match_answers(exercise, root).reason;
  }

  ExerciseResult grade(Candidate& candidate, const ExerciseResult& none) {
    ExerciseResult graded = none;
    graded.source = candidate.submission.source;
    graded.submitted = candidate.submission.submitted;
    graded.digest = sha256_hex(candidate.submission.text).substr(0, 16);
    graded.varies = examiner_->varies(candidate.item);
    auto grader = examiner_->grader(candidate.item, result.student.id);
    if (!grader) {
      incident(Incident::Kind::failed, candidate.item, graded.source,
               "no numbers could be drawn for this student: " + first_of(grader.diagnostics));
      return graded;
    }
    graded.grader = std::move(*grader);
    graded.grade = graded.grader->grade(candidate.document, result.student.id);
    if (candidate.document) graded.answers = std::make_shared<const JsonDocument>(std::move(*candidate.document.value));
    const auto due = result.student.due ? result.student.due : assignment_->due;
    if (due && graded.submitted) graded.days_late = assignment_->late.days_late(*due, *graded.submitted);
    const Exact& worth = graded.grader->exercise().max_points;
    if (worth != Exact(0))
      graded.points = graded.grade->points / worth * graded.max_points * assignment_->late.share(graded.days_late);
    return graded;
  }

  std::string another_counts(const Candidate& counting) const {
    const Submission& one = counting.submission;
    std::string text = "does not count; ";
    text += assignment_->attempts == Attempts::last    ? "the last one does"
            : assignment_->attempts == Attempts::first ? "the first one does"
                                                       : "the best one does";
    if (!one.source.empty()) text += ", " + printable(one.source);
    if (one.submitted)
      text += (one.source.empty() ? ", of " : " of ") + time_in_words(*one.submitted, assignment_->offset);
    return text;
  }

  void say_late(const Candidate& counting, const ExerciseResult& counted) {
    if (counted.days_late == 0) return;
    const auto due = result.student.due ? result.student.due : assignment_->due;
    const Exact lost = Exact(1) - assignment_->late.share(counted.days_late);
    std::string text = std::to_string(counted.days_late) + (counted.days_late == 1 ? " day" : " days") +
                       " late, handed in at " + format_time(*counted.submitted) + " and due at " + format_time(*due);
    text += lost == Exact(0)   ? "; it costs nothing"
            : lost == Exact(1) ? "; it earns nothing"
                               : "; it costs " + format_short(100 * lost.to_double(), 1) + " % of the points";
    incident(Incident::Kind::late, counted.item, counting.submission.source, std::move(text));
  }

  Examiner* examiner_;
  const Assignment* assignment_;
  std::vector<std::vector<Candidate>> of_item_;
  bool any_lost_ = false;  // something that cannot be read, and may be for any exercise
};

}  // namespace

std::string as_sentence(std::string text) { return text.ends_with('?') ? text : std::move(text) + "."; }

bool concerns_student(Incident::Kind kind) {
  using Kind = Incident::Kind;
  return kind != Kind::foreign_id && kind != Kind::unlisted && kind != Kind::refused;
}

std::string_view incident_name(Incident::Kind kind) { return incident_names[static_cast<std::size_t>(kind)]; }

double StudentResult::score() const { return max_points == Exact(0) ? 0 : (points / max_points).to_double(); }

StudentResult grade_student(Examiner& examiner, const Student& student, std::vector<Submission> submissions) {
  StudentGrading grading(examiner, student);
  grading.sort(std::move(submissions));
  for (std::size_t i = 0; i < examiner.assignment().items.size(); ++i) grading.grade(i);
  return std::move(grading.result);
}

std::string file_name_of(std::string_view id) {
  constexpr char digits[] = "0123456789ABCDEF";
  constexpr std::size_t longest = 150, kept = 100;  // a file system takes 255 bytes, an ending among them
  std::string name;
  for (const char c : id) {
    const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' ||
                       c == '-' || c == '@' || (c == '.' && !name.empty());
    if (plain) {
      name += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    name += '%';
    name += digits[byte >> 4];
    name += digits[byte & 15];
  }
  if (name.empty()) return "%";
  if (is_device(name)) name.replace(0, 1, {'%', digits[name[0] >> 4], digits[name[0] & 15]});
  if (name.size() > longest) return name.substr(0, kept) + "~" + sha256_hex(id).substr(0, 32);
  return name;
}

}  // namespace blossom
