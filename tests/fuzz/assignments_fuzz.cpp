// Any document as an assignment, beside the shipped exercises: an accepted one has exercises that are worth its points.

#include "fuzz.hpp"
#include "grader/assignment.hpp"

using namespace blossom;
using namespace blossom::fuzz;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse(BLOSSOM_SOURCE_DIR "/exercises/f.json", text);
  if (!document) return 0;
  const auto assignment = read_assignment(*document);
  if (!assignment) {
    require(!assignment.diagnostics.empty(), "what is refused has a reason");
    for (const Diagnostic& d : assignment.diagnostics) require(is_harmless(to_string(d)), "a mistake is harmless text");
    return 0;
  }
  Exact points = 0;
  for (std::size_t i = 0; i < assignment->items.size(); ++i) {
    points += assignment->items[i].points;
    require(assignment->item(assignment->items[i].exercise.id) == i, "an exercise is found by its id");
  }
  require(Exact(0) < points && points == assignment->max_points, "points add up");
  Exact before = 1;
  for (const int days : {0, 1, 2, 30, 4000}) {
    const Exact share = assignment->late.share(days);
    require(Exact(0) <= share && share <= before, "later is never better");
    before = share;
  }
  return 0;
}
