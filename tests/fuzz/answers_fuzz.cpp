// Any bytes as answers to the shipped exercises and to the checkpoints of the shipped lessons (those they say they are
// for, otherwise the first exercise): there is a grade, its verdicts and points agree with each other and with the
// quick comparison, and its text is JSON.

#include <algorithm>
#include <filesystem>

#include "fuzz.hpp"
#include "grader/lesson_grader.hpp"
#include "grader/report/report.hpp"
#include "lesson/catalog.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

std::vector<std::unique_ptr<Grader>> all_graders() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(BLOSSOM_SOURCE_DIR "/exercises"))
    if (entry.path().extension() == ".json" && entry.path().stem().extension().empty()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::unique_ptr<Grader>> graders;
  for (const auto& file : files)
    if (auto exercise = load_exercise(file)) graders.push_back(std::make_unique<Grader>(std::move(*exercise)));
  require(!graders.empty(), "there are exercises");
  for (const CatalogEntry& entry : load_catalog(BLOSSOM_SOURCE_DIR "/lessons").lessons)
    if (auto sheet = make_sheet(entry.lesson); sheet && sheet->max_points != Exact(0))
      graders.push_back(std::make_unique<Grader>(std::move(*sheet)));
  return graders;
}

const Grader& grader_for(const Checked<JsonDocument>& document) {
  static const auto graders = all_graders();
  const Json* id = document ? document->root().find("exercise") : nullptr;
  if (id != nullptr)
    for (const auto& grader : graders)
      if (grader->exercise().id == id->text) return *grader;
  return *graders.front();
}

std::string written(const Grade& grade) {
  std::string out;
  write_json(grade, out);
  return out;
}

void check_part(const Exercise& exercise, const Part& part, const PartGrade& made, const Json* answer) {
  const bool right = answer != nullptr && match(part, *answer) == Match::right;
  const std::string& name = part.name;
  require(right == (made.verdict == Verdict::correct), "the quick comparison decides what is right", name);
  require((answer == nullptr) == (made.verdict == Verdict::missing), "what is not there is missing", name);
  require((made.verdict == Verdict::misconception) == !made.misconception.empty(), "a misconception is named", name);
  Exact share = 0;
  if (made.verdict == Verdict::correct) share = 1;
  if (made.verdict == Verdict::carried) share = exercise.carried;
  if (made.verdict == Verdict::misconception) share = exercise.misconception;
  if (made.verdict == Verdict::slip) share = exercise.slip;
  if (part.voided == Voided::no) require(made.points == share * part.points, "points follow from the verdict", name);
  if (answer != nullptr) {
    const Typed typed = read_typed(part, *answer);
    require(typed.problem.empty() || made.verdict == Verdict::invalid, "no shape, no verdict but invalid", name);
    require(!right || typed.problem.empty(), "what is right has the right shape", name);
    if (right && part.question == nullptr)
      require(agrees(part, exercise.run.trace.numbers(part.value), typed.numbers), "both ways agree", name);
  }
}

void check(const Grader& grader, const Checked<JsonDocument>& document) {
  const Exercise& exercise = grader.exercise();
  const Grade grade = grader.grade(document);
  require(grade.exercise == &exercise && grade.parts.size() == exercise.parts.size(), "each part has its grade");
  const auto answers = match_answers(exercise, document);
  require(answers.reason == grade.reason, "what is invalid says why", grade.reason);
  Exact points = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    points += grade.parts[i].points;
    const Verdict verdict = grade.parts[i].verdict;
    if (!grade.reason.empty())
      require(verdict == Verdict::invalid && grade.parts[i].points == Exact(0), "an invalid file has no points");
    else
      check_part(exercise, exercise.parts[i], grade.parts[i], answers.part[i]);
    if (verdict == Verdict::misconception || verdict == Verdict::slip || verdict == Verdict::wrong) ++wrong;
  }
  require(points == grade.points && Exact(0) <= points && points <= exercise.max_points, "points add up");
  require(grade.score() >= 0 && grade.score() <= 1, "a score is from 0 to 1");
  if (grade.explanation) {
    const Explanation& why = *grade.explanation;
    require(why.covered <= why.wrong && why.wrong <= grade.parts.size(), "what is explained is wrong");
    require(why.misconceptions.size() <= 2 && why.chance >= 0, "an explanation is one misconception or two");
  }
  const std::string text = written(grade);
  const auto report = JsonDocument::parse("grade", text);
  require(report.value.has_value() && text.find('\n') == std::string::npos, "a grade is one line of JSON", text);
  if (document) require(written(grader.grade(document->root())) == text, "graded again it is the same", text);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("answers.json", text, submission_limits);
  check_outcome(document, text);
  check(grader_for(document), document);
  return 0;
}
