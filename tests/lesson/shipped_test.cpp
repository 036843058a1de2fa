// The lessons in lessons/, and the schema that follows from the table of algorithms.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "lesson/algorithm_schema.hpp"
#include "lesson/catalog.hpp"

using namespace blossom;

namespace {

const std::filesystem::path lessons_folder = std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons";

// Runs a lesson to the end; its last point, if it is one.
template <Scalar S>
Run<S> run_through(const Lesson& lesson) {
  auto run = record<S>(*lesson.algorithm, lesson.inputs);
  REQUIRE(run);
  const Narrator<S> narrator(*run);
  for (const Beat& beat : lesson.beats) {
    REQUIRE(beat.step < run->trace.step_count());
    std::vector<std::string> unresolved;
    narrator.fill(beat.say, beat.step, &unresolved);
    CHECK(unresolved.empty());
  }
  for (std::uint32_t step = 0; step < run->trace.step_count(); ++step) {
    const std::string said = lesson.narration(narrator, step);
    INFO("step " << step << ": " << said);
    CHECK_FALSE(said.empty());
    CHECK(said.find_first_of("{}") == std::string::npos);
  }
  return *std::move(run);
}

}  // namespace

TEST_CASE("every shipped lesson is in order") {
  const auto catalog = load_catalog(lessons_folder);
  CHECK(to_string(catalog.diagnostics).empty());
  CHECK(catalog.lessons.size() >= 8);
  std::set<const Algorithm*> taught;
  for (const auto& [file, lesson] : catalog.lessons) {
    INFO(file.string());
    taught.insert(lesson.algorithm);
    CHECK_FALSE(lesson.unit.empty());
    CHECK_FALSE(lesson.summary.empty());
    CHECK_FALSE(lesson.source.empty());
    CHECK(lesson.minutes > 0);
    CHECK(lesson.beats.front().step == 0);  // says what it is about before anything happens
  }
  CHECK(taught.size() == algorithms().size());
}

TEST_CASE("every shipped lesson runs to its end, and whatever it says is filled in, in both kinds of numbers") {
  for (const auto& [file, lesson] : load_catalog(lessons_folder).lessons) {
    INFO(file.string());
    const auto exact = run_through<Exact>(lesson);
    const auto rounded = run_through<double>(lesson);
    CHECK(exact.trace.step_count() == rounded.trace.step_count());
    CHECK(lesson.beats.back().step + 1 == exact.trace.step_count());  // the last word is at the last step
  }
}

TEST_CASE("the points the lessons arrive at") {
  const auto catalog = load_catalog(lessons_folder);
  const auto last = [&](std::string_view id, std::string_view name) {
    INFO(id);
    const CatalogEntry* entry = catalog.find(id);
    REQUIRE(entry != nullptr);
    const auto run = run_through<Exact>(entry->lesson);
    const auto value = run.trace.find(name);
    REQUIRE(value.has_value());
    return Narrator<Exact>(run).value_text(*value);
  };
  // The NURBS Book, sections 1.4 and 4.1; Shene's notes on rational curves, unclamped curves and knot insertion.
  CHECK(last("rational-quarter-circle", "C") == "(3/5, 4/5)");
  CHECK(last("forgotten-weight", "C") == "(1/2, 10/11)");
  CHECK(last("de-boor-nurbs", "C") == "(7/5, 6/5)");
  CHECK(last("de-boor-unclamped", "C") == "(-32/5, 16/5)");
  CHECK(last("degree-elevation", "round[1].Q[1]") == "(-1, 2)");
  CHECK(last("de-boor", "alpha[1][3]") == "8/15");
  CHECK(last("knot-insertion", "alpha[1][3]") == "5/6");
  CHECK(last("subdivision", "alpha[2][4]") == "3/4");
  // The blend of the four control points with the basis functions 2/125, 307/750, 202/375, 9/250.
  const Exact a = Exact::ratio(307, 750), b = Exact::ratio(202, 375), c = Exact::ratio(9, 250);
  CHECK(last("de-boor", "C") == "(" + (b * 30 + c * 30).to_string() + ", " + ((a + b) * 20).to_string() + ")");
}

TEST_CASE("the published schema of algorithms and inputs is that of the table of algorithms") {
  const auto file = lessons_folder / "algorithms.schema.json";
  if (std::getenv("BLOSSOM_WRITE_SCHEMA") != nullptr) REQUIRE(write_file(file, algorithm_schema()));
  std::ostringstream published;
  published << std::ifstream(file).rdbuf();
  INFO("an algorithm is new or has changed; BLOSSOM_WRITE_SCHEMA=1 ./dev test -R lesson writes the file anew");
  CHECK(published.str() == algorithm_schema());
}
