#include "grader/batch/revision.hpp"

#include "base/json_write.hpp"
#include "grader/variant.hpp"

namespace blossom {
namespace {

std::string number(const Exact& x) { return x.is_integer() ? x.to_string() : format_number(x.to_double()); }

void add(std::string& reasons, const std::string& reason) { reasons += (reasons.empty() ? "" : "; ") + reason; }

void add_change(std::string& reasons, const std::string& what, const std::string& was, const std::string& now) {
  if (was != now) add(reasons, what + " " + was + " -> " + now);
}

std::string voided_words(Voided voided) {
  return voided == Voided::no       ? "no longer voided"
         : voided == Voided::credit ? "voided: everybody whose answers could be read gets its points"
                                    : "voided: it counts for nobody";
}

std::string form_words(Form form) {
  return form == Form::affine ? "affine" : form == Form::homogeneous ? "homogeneous" : "weight";
}

std::string part_reasons(const Part& was, const Part& now) {
  std::string reasons;
  if (was.voided != now.voided) add(reasons, voided_words(now.voided));
  add_change(reasons, "points", number(was.points), number(now.points));
  if (was.voided != now.voided && now.voided != Voided::no) return reasons;  // how it is judged is no matter then
  add_change(reasons, "tolerance", tolerance_words(was.tolerance), tolerance_words(now.tolerance));
  add_change(reasons, "form", form_words(was.form), form_words(now.form));
  if (was.right != now.right) add(reasons, "the right value has changed");
  if (was.as_set != now.as_set) add(reasons, now.as_set ? "any order counts" : "the order counts");
  return reasons;
}

std::string due_words(const std::optional<Time>& due) { return due ? format_time(*due) : "never"; }

std::string late_words(const LatePolicy& late) {
  return number(late.per_day) + " a day after " + std::to_string(late.grace_minutes) + " minutes" +
         (late.at_most_days ? ", at most " + std::to_string(*late.at_most_days) + " days" : "");
}

std::string attempts_words(Attempts attempts) {
  return attempts == Attempts::last ? "last" : attempts == Attempts::best ? "best" : "first";
}

}  // namespace

std::string tolerance_words(const Tolerance& tolerance) {
  switch (tolerance.kind) {
    case Tolerance::Kind::exact:
      return "exact";
    case Tolerance::Kind::decimals:
      return std::to_string(tolerance.digits) + " decimals";
    case Tolerance::Kind::significant:
      return std::to_string(tolerance.digits) + " significant digits";
    case Tolerance::Kind::absolute:
      return number(tolerance.amount);
    case Tolerance::Kind::relative:
      return number(tolerance.amount) + " of the value";
  }
  return {};
}

Revision::Revision(const Assignment& was, const Assignment& now) {
  add_change(lateness_, "due", due_words(was.due), due_words(now.due));
  add_change(lateness_, "lateness costs", late_words(was.late), late_words(now.late));
  add_change(attempts_, "attempts", attempts_words(was.attempts), attempts_words(now.attempts));
  for (const Assignment::Item& item : now.items) {
    if (const auto before = was.item(item.exercise.id))
      compare(was.items[*before], item);
    else
      add(exercises_[item.exercise.id], "the exercise is new");
  }
  for (const Assignment::Item& item : was.items)
    if (!now.item(item.exercise.id)) add(exercises_[item.exercise.id], "the exercise is no longer there");
}

void Revision::compare(const Assignment::Item& was, const Assignment::Item& now) {
  const Exercise &before = was.exercise, &after = now.exercise;
  std::string& whole = exercises_[after.id];
  add_change(whole, "points in the assignment", number(was.points), number(now.points));
  std::string shares;
  add_change(shares, "share of what is carried", number(before.carried), number(after.carried));
  add_change(shares, "share of a misconception", number(before.misconception), number(after.misconception));
  add_change(shares, "share of a slip", number(before.slip), number(after.slip));
  if (varies(was.document) != varies(now.document)) add(shares, "whether numbers are each student's own has changed");
  const auto drawn = [](const JsonDocument& document, std::string_view key) {
    const Json* member = document.root().find(key);
    return member == nullptr ? std::string() : write_json(*member);
  };
  if (varies(was.document) && varies(now.document))
    for (const auto* key : {"vary", "inputs"})
      if (drawn(was.document, key) != drawn(now.document, key)) {
        add(shares, "the numbers students are given, and so the right values, have changed");
        break;
      }
  for (const Part& part : after.parts) {
    const auto other = before.part(part.name);
    std::string reasons = other ? part_reasons(before.parts[*other], part) : "it was not asked before";
    if (!shares.empty()) add(reasons, shares);
    if (!reasons.empty()) parts_[after.id][part.name] = reasons;
  }
  for (const Part& part : before.parts)
    if (!after.part(part.name)) parts_[after.id][part.name] = "it is no longer asked";
}

std::string Revision::of_part(const std::string& exercise, const std::string& part) const {
  const auto parts = parts_.find(exercise);
  if (parts == parts_.end()) return {};
  const auto found = parts->second.find(part);
  return found == parts->second.end() ? std::string() : found->second;
}

std::string Revision::of_exercise(const std::string& exercise) const {
  const auto found = exercises_.find(exercise);
  return found == exercises_.end() ? std::string() : found->second;
}

bool Revision::touches(const std::string& exercise) const {
  return parts_.contains(exercise) || !of_exercise(exercise).empty();
}

}  // namespace blossom
