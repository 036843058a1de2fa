// What `blossom new` writes: for every algorithm of the table a lesson that is in order.

#include "lesson/starter.hpp"

#include <set>

#include "lesson/slider_check.hpp"
#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::filesystem::path shipped = std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons";

// Whether it has a slider.
bool check_start(const Algorithm& algorithm, const std::filesystem::path& lessons) {
  const auto inputs = starting_inputs(algorithm, lessons);
  INFO(to_string(inputs.diagnostics));
  REQUIRE(inputs);
  const std::string text = starting_lesson(algorithm, *inputs, {"a-start", "en", "lesson.schema.json"});
  INFO(text);
  const auto document = parsed(text);
  const auto lesson = load_lesson(document);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  CHECK(to_string(check_sliders(document)).empty());
  CHECK(lesson->id == "a-start");
  CHECK(lesson->algorithm == &algorithm);
  const auto run = record<Exact>(algorithm, lesson->inputs);
  REQUIRE(run);
  const std::uint32_t steps = run->trace.step_count();
  CHECK(lesson->beats.size() >= std::min<std::size_t>(4, steps));
  CHECK(lesson->beats.size() <= 6);
  CHECK(lesson->beats.front().step == 0);
  CHECK(lesson->beats.back().step + 1 == steps);
  // What it says between the start and the end is what the algorithm says of these steps.
  const Narrator<Exact> narrator(*run);
  for (std::size_t i = 1; i + 1 < lesson->beats.size(); ++i) {
    const std::uint32_t step = lesson->beats[i].step;
    INFO("step " << step);
    CHECK(lesson->narration(narrator, step) == narrator.text(step));
  }
  CHECK(lesson->narration(narrator, 0) == narrator.text(0));
  std::size_t checkpoints = 0, sliders = 0, numbers = 0;
  for (const Beat& each : lesson->beats) {
    checkpoints += each.checkpoint ? 1 : 0;
    sliders += each.sliders.size();
  }
  CHECK(checkpoints == 1);
  for (const InputSpec& spec : algorithm.inputs)
    numbers += spec.type == InputSpec::Type::number && inputs->find(spec.name) != nullptr ? 1 : 0;
  CHECK(sliders <= (numbers > 0 ? 1u : 0u));  // none where a number cannot be moved, as a knot that is removed
  CHECK(text.find("\"$comment\"") != std::string::npos);
  return sliders > 0;
}

}  // namespace

TEST_CASE("there is a start for every algorithm, from a lesson about it") {
  std::set<std::string_view> with_slider;
  for (const Algorithm* algorithm : algorithms()) {
    INFO(algorithm->id);
    if (check_start(*algorithm, shipped)) with_slider.insert(algorithm->id);
  }
  for (const char* id : {"de_casteljau", "de_boor", "surface_evaluation", "knot_insertion"}) {
    INFO(id);
    CHECK(with_slider.contains(id));
  }
}

TEST_CASE("there is a start for every algorithm, where there are no lessons") {
  std::set<std::string_view> with_slider;
  for (const Algorithm* algorithm : algorithms()) {
    INFO(algorithm->id);
    if (check_start(*algorithm, "/nowhere")) with_slider.insert(algorithm->id);
  }
  for (const char* id : {"de_casteljau", "de_boor", "surface_evaluation", "knot_insertion"}) {
    INFO(id);
    CHECK(with_slider.contains(id));
  }
}
