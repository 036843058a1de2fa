#include "grader/batch/regrade.hpp"

#include <algorithm>
#include <fstream>
#include <unordered_map>

#include "grader/batch/manifest.hpp"
#include "grader/batch/revision.hpp"
#include "grader/csv.hpp"
#include "grader/variant.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr JsonLimits result_limits{64u << 20, 64, 4'000'000};

const std::string no_text;

const std::string& text(const Json* object, std::string_view key) {
  const Json* found = object == nullptr ? nullptr : object->find(key);
  return found == nullptr ? no_text : found->text;
}

const Json* object(const Json* in, std::string_view key) { return in == nullptr ? nullptr : in->find(key); }

// None, where the line has been tampered with.
const Json* exercises(const Json& result) {
  static const Json none;
  const Json* found = result.find("exercises");
  return found == nullptr ? &none : found;
}

// The item of an array whose member `key` is this text.
const Json* item(const Json* array, std::string_view key, const std::string& value) {
  if (array != nullptr)
    for (const Json& each : array->items)
      if (text(&each, key) == value) return &each;
  return nullptr;
}

double number(const Json* object, std::string_view key) {
  const auto parsed = Exact::parse(text(object, key));
  return parsed ? parsed->to_double() : 0;
}

std::string points_of(const Json* object) {
  if (object == nullptr) return {};
  return format_short(number(object, "points"), 4) + " of " + format_short(number(object, "max_points"), 4);
}

void add(std::string& reasons, std::string_view reason) {
  if (!reason.empty()) reasons += (reasons.empty() ? "" : "; ") + std::string(reason);
}

std::string part_words(const Json* part) {
  return part == nullptr ? std::string() : text(part, "verdict") + ", " + points_of(part);
}

// A student's line.
struct Line {
  std::optional<JsonDocument> document;
  std::string student;
  std::uint64_t offset = 0;
};

class Results {
 public:
  explicit Results(const fs::path& folder) : path_(folder / "results.jsonl"), in_(path_, std::ios::binary) {}

  const fs::path& path() const { return path_; }
  bool is_open() const { return in_.is_open(); }

  // False at the end, or with a diagnostic where a line is no result.
  bool next(Line& line) {
    line.offset = offset_;
    std::string bytes;
    if (!std::getline(in_, bytes)) return false;
    offset_ += bytes.size() + 1;
    auto document = JsonDocument::parse(path_.string(), std::move(bytes), result_limits);
    if (!document) {
      diagnostics = document.diagnostics;
      return false;
    }
    line.student = text(object(&document->root(), "student"), "id");
    line.document = std::move(*document);
    return true;
  }

  void seek(std::uint64_t offset) {
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(offset));
    offset_ = offset;
  }

  Diagnostics diagnostics;

 private:
  fs::path path_;
  std::ifstream in_;
  std::uint64_t offset_ = 0;
};

class Comparing {
 public:
  Comparing(const Revision& revision, const std::function<void(const Change&)>& each)
      : revision_(&revision), each_(&each) {}

  void compare(const Json& was, const Json& now) {
    count(now);
    changes.mean_was += number(&was, "score");
    const std::string student = text(object(&now, "student"), "id");
    found_.clear();
    const Json *old_exercises = exercises(was), *new_exercises = exercises(now);
    for (const Json& exercise : new_exercises->items)
      compare_exercise(item(old_exercises, "exercise", text(&exercise, "exercise")), &exercise);
    for (const Json& exercise : old_exercises->items)
      if (item(new_exercises, "exercise", text(&exercise, "exercise")) == nullptr) compare_exercise(&exercise, nullptr);
    const bool other_points = points_of(&was) != points_of(&now);
    if (found_.empty() && !other_points) return;
    const double before = number(&was, "score"), after = number(&now, "score");
    ++(after > before ? changes.better : after < before ? changes.worse : changes.otherwise);
    (*each_)({student, {}, {}, points_of(&was), points_of(&now), {}});
    for (Change& change : found_) {
      change.student = student;
      (*each_)(change);
    }
  }

  void come(const Json& now) {
    count(now);
    ++changes.come;
    (*each_)({text(object(&now, "student"), "id"), {}, {}, {}, points_of(&now), "not among the old results"});
  }

  void gone(const Json& was) {
    ++changes.gone;
    (*each_)({text(object(&was, "student"), "id"), {}, {}, points_of(&was), {}, "not among the new results"});
  }

  Changes changes;

 private:
  void count(const Json& now) {
    ++changes.students;
    changes.mean_now += number(&now, "score");
  }

  void compare_exercise(const Json* was, const Json* now) {
    const std::string& id = text(now != nullptr ? now : was, "exercise");
    const bool other_file = text(was, "digest") != text(now, "digest");
    const Json *old_parts = object(object(was, "grade"), "parts"), *new_parts = object(object(now, "grade"), "parts");
    const std::size_t before = found_.size();
    const auto compare_part = [&](const Json* old_part, const Json* new_part) {
      const std::string words = part_words(old_part), new_words = part_words(new_part);
      if (words == new_words) return;
      const std::string& part = text(new_part != nullptr ? new_part : old_part, "value");
      found_.push_back({{}, id, part, words, new_words, why(id, revision_->of_part(id, part), other_file)});
    };
    if (new_parts != nullptr)
      for (const Json& part : new_parts->items) compare_part(item(old_parts, "value", text(&part, "value")), &part);
    if (old_parts != nullptr)
      for (const Json& part : old_parts->items)
        if (item(new_parts, "value", text(&part, "value")) == nullptr) compare_part(&part, nullptr);
    if (points_of(was) == points_of(now)) return;
    std::string reason = revision_->of_exercise(id);
    const bool late = !text(was, "days_late").empty() || !text(now, "days_late").empty();
    if (late) add(reason, revision_->of_lateness());
    if (found_.size() > before) add(reason, "its values below");
    found_.insert(found_.begin() + static_cast<std::ptrdiff_t>(before),
                  {{}, id, {}, points_of(was), points_of(now), why(id, reason, other_file)});
  }

  std::string why(const std::string& exercise, const std::string& reason, bool other_file) const {
    std::string all = reason;
    if (other_file) {
      add(all, "another submission counts");
      add(all, revision_->of_attempts());
    }
    if (!all.empty()) return all;
    // What a part counts as may hang on the values before it.
    return revision_->touches(exercise) ? "it follows from what else has changed in the exercise"
                                        : "the grader has changed";
  }

  const Revision* revision_;
  const std::function<void(const Change&)>* each_;
  std::vector<Change> found_;
};

}  // namespace

Checked<Changes> find_changes(const fs::path& old_results, const fs::path& new_results,
                              const std::function<void(const Change&)>& each) {
  const auto was = load_assignment(old_results / "assignment.json");
  if (!was) return was.diagnostics;
  const auto now = load_assignment(new_results / "assignment.json");
  if (!now) return now.diagnostics;
  const Revision revision(*was, *now);
  Results old_lines(old_results), new_lines(new_results);
  for (const Results* results : {&old_lines, &new_lines})
    if (!results->is_open()) return Diagnostics{{results->path().string(), 0, 0, "", "cannot be read"}};

  Comparing comparing(revision, each);
  Line was_line, now_line;
  bool more_old = old_lines.next(was_line), more_new = new_lines.next(now_line);
  // The same class is in the same order in both.
  while (more_old && more_new && was_line.student == now_line.student) {
    comparing.compare(was_line.document->root(), now_line.document->root());
    more_old = old_lines.next(was_line);
    more_new = new_lines.next(now_line);
  }
  // From the first difference on, where each of the old lines is.
  std::unordered_map<std::string, std::uint64_t> left;
  for (; more_old; more_old = old_lines.next(was_line)) left.emplace(was_line.student, was_line.offset);
  for (; more_new; more_new = new_lines.next(now_line)) {
    const auto found = left.find(now_line.student);
    if (found == left.end()) {
      comparing.come(now_line.document->root());
      continue;
    }
    old_lines.seek(found->second);
    left.erase(found);
    if (old_lines.next(was_line)) comparing.compare(was_line.document->root(), now_line.document->root());
  }
  old_lines.seek(0);
  while (!left.empty() && old_lines.next(was_line))
    if (left.erase(was_line.student) > 0) comparing.gone(was_line.document->root());
  for (const Results* results : {&old_lines, &new_lines})
    if (!results->diagnostics.empty()) return results->diagnostics;

  Changes& changes = comparing.changes;
  const auto both = static_cast<double>(changes.students - changes.come);
  if (both > 0) changes.mean_was /= both;
  if (changes.students > 0) changes.mean_now /= static_cast<double>(changes.students);
  return changes;
}

Diagnostics other_secret(const fs::path& old_results, const BatchOptions& wanted) {
  const auto manifest = read_manifest(old_results);
  const auto assignment = load_assignment(wanted.assignment);
  if (!manifest || manifest->secret.empty() || !wanted.secret || !assignment) return {};
  const auto secret = load_secret(*wanted.secret);
  const bool varied = std::ranges::any_of(assignment->items, [](const auto& each) { return varies(each.document); });
  if (!secret || !varied || digest_of_secret(*secret) == manifest->secret) return {};
  return {{wanted.secret->string(), 0, 0, "",
           "is not the secret of " + old_results.string() +
               ": everybody would be graded against numbers that were never theirs"}};
}

std::string change_header() {
  std::string row;
  write_csv_row({"student", "exercise", "part", "was", "now", "why"}, row);
  return row;
}

void write_change(const Change& change, std::string& out) {
  write_csv_row({csv_text(change.student), csv_text(change.exercise), csv_text(change.part), csv_text(change.was),
                 csv_text(change.now), csv_text(change.why)},
                out);
}

}  // namespace blossom
