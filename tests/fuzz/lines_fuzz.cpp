// Any bytes as a line of JSON Lines: it is somebody's submission or has a problem, and graded as a line of a stream it
// gives one line of JSON with a score.

#include <algorithm>

#include "fuzz.hpp"
#include "grader/batch/source.hpp"
#include "grader/batch/stream.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

Examiner make_examiner() {
  auto assignment = load_assignment(BLOSSOM_SOURCE_DIR "/exercises/22-de-boor.json");
  require(assignment.value.has_value(), "the exercise is one", to_string(assignment.diagnostics));
  return Examiner(std::move(*assignment), "a secret of 20 bytes", Time());
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Examiner examiner = make_examiner();
  std::string line = text_of(data, size);
  std::replace(line.begin(), line.end(), '\n', ' ');
  const Found found = read_line(line);
  require(!found.keys.empty() || !found.submission.problem.empty(), "a line is somebody's, or has a problem");
  require(is_harmless(found.submission.problem), "a problem is harmless text", found.submission.problem);
  require(!found.submission.problem.empty() || found.submission.text.size() <= SourceLimits().submission_bytes,
          "a submission keeps its limit");

  std::string written;
  grade_line(examiner, line, written);
  if (written.ends_with('\n')) written.pop_back();
  require(written.find('\n') == std::string::npos && is_harmless(written), "a grade is one harmless line", written);
  const auto grade = JsonDocument::parse("grade", written);
  require(grade.value.has_value(), "a grade is JSON", written);
  const Json* score = grade->root().find("score");
  require(score != nullptr && score->kind == Json::Kind::number, "a grade has a score", written);
  const auto share = Exact::parse(score->text);
  require(share && Exact(0) <= *share && *share <= Exact(1), "a score is from 0 to 1", written);
  return 0;
}
