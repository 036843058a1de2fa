// Any document as an exercise: of an accepted one the right answers, typed as an exercise shows them, have full marks,
// and a submission without them has none. Reading it and grading end within a bounded amount of exact arithmetic.

#include "fuzz.hpp"
#include "grader/grade.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

constexpr std::uint64_t work = 1'000'000'000;  // some 10 s of exact arithmetic

// Exactly, or as the nearest double where that is within the tolerance: the decimals of a long fraction.
std::string typed(const Part& part, const Exact& x) {
  const std::string exactly = x.to_string();
  if (exactly.size() <= 25) return exactly;
  if (part.tolerance.kind == Tolerance::Kind::exact) {
    if (exactly.size() <= 400) return exactly;
    std::string digits = (x * *Exact::parse("1e400")).to_string();  // a decimal, or it would not be asked
    std::size_t zeros = 0;
    for (; zeros < 400 && digits.ends_with('0'); ++zeros) digits.pop_back();
    return digits + "e-" + std::to_string(400 - zeros);
  }
  const double rounded = x.to_double();
  const std::string decimal = format_number(rounded);
  const auto read = Exact::parse(decimal);
  return read && within(part.tolerance, x, *read) ? decimal : exactly;
}

std::string right_answers(const Exercise& exercise) {
  std::string text = R"({"schema": "blossom.answers/1", "exercise": )" + json_quote(exercise.id) + R"(, "answers": {)";
  for (std::size_t i = 0; i < exercise.parts.size(); ++i) {
    const Part& part = exercise.parts[i];
    std::string numbers;
    for (const Exact& x : part.right) numbers += (numbers.empty() ? "" : ", ") + json_quote(typed(part, x));
    text += (i > 0 ? ", " : "") + json_quote(part.name) + ": " + (part.is_single() ? numbers : "[" + numbers + "]");
  }
  return text + "}}";
}

void check(const Grader& grader) {
  const Exercise& exercise = grader.exercise();
  require(Exact(0) < exercise.max_points && !exercise.parts.empty(), "something is asked and is worth points");
  for (const Part& part : exercise.parts) {
    require(part.right.size() == part.windows.size(), "each number of a part has its window", part.name);
    require(exercise.part(part.name).has_value(), "a part is found by its name", part.name);
    require(is_harmless(part.solution) && is_harmless(part.formula), "a solution is harmless text", part.solution);
  }
  const std::string text = right_answers(exercise);
  const auto document = JsonDocument::parse("answers.json", text, submission_limits);
  require(document.value.has_value(), "the right answers can be handed in", to_string(document.diagnostics));
  const Grade grade = grader.grade(document);
  require(grade.reason.empty() && grade.notes.empty(), "the right answers can be read", grade.reason);
  for (std::size_t i = 0; i < grade.parts.size(); ++i)
    require(grade.parts[i].verdict == Verdict::correct, "the right answer is right",
            exercise.parts[i].name + "\n" + text);
  require(grade.points == exercise.max_points, "the right answers have full marks", text);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("f", text);
  if (!document) return 0;
  const ExactBudget budget(work);
  auto exercise = read_exercise(*document);
  check_outcome(exercise, text);
  if (exercise) check(Grader(std::move(*exercise)));
  return 0;
}
