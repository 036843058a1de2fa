// The lessons in lessons/, and the schema that follows from the table of algorithms.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "lesson/algorithm_schema.hpp"
#include "lesson/catalog.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/links.hpp"
#include "lesson/prose.hpp"

using namespace blossom;

namespace {

const std::filesystem::path root_folder = BLOSSOM_SOURCE_DIR;
const std::filesystem::path lessons_folder = root_folder / "lessons";

// The units of the course, in their order, each with the numbers its lessons' files begin with.
struct Unit {
  std::string_view name;
  int first, last;
};
const std::vector<Unit> units{{"Parametric curves", 1, 9},
                              {"Bézier curves", 10, 19},
                              {"B-spline curves", 20, 39},
                              {"Rational curves and NURBS", 40, 49},
                              {"Surfaces", 50, 59},
                              {"Cross-sectional design", 60, 69},
                              {"Parameters and interpolation", 70, 79},
                              {"Blossoms", 80, 89}};

const Unit* unit_of(const std::string& name) {
  for (const Unit& unit : units)
    if (unit.name == name) return &unit;
  return nullptr;
}

template <Scalar S>
Run<S> run_through(const LessonScene& scene, const std::string& language = {}) {
  auto run = record<S>(*scene.algorithm, scene.inputs);
  REQUIRE(run);
  const Narrator<S> narrator(*run);
  for (const Beat& beat : scene.beats) {
    REQUIRE(beat.step < run->trace.step_count());
    CHECK(unresolved(beat.say.in(language), narrator, beat.step).empty());
  }
  for (std::uint32_t step = 0; step < run->trace.step_count(); ++step) {
    const std::string said = scene.narration(narrator, step, language);
    std::vector<ProseMistake> mistakes;
    const std::string plain = plain_text(read_prose(said, &mistakes));
    INFO("step " << step << ": " << said);
    CHECK_FALSE(plain.empty());
    for (const ProseMistake& mistake : mistakes) FAIL_CHECK(mistake.what);
  }
  return *std::move(run);
}

std::size_t checkpoints_of(const Lesson& lesson) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < lesson.scene_count(); ++i)
    for (const Beat& beat : lesson.scene_at(i).beats) count += beat.checkpoint ? 1 : 0;
  return count;
}

// What exercises there are: their ids, with the ids of their algorithms.
std::map<std::string, std::string> shipped_exercises() {
  std::map<std::string, std::string> found;
  Diagnostics diagnostics;
  for (const auto& file : json_files(root_folder / "exercises", diagnostics)) {
    const auto document = JsonDocument::load(file);
    if (!document || file_kind(document->root()) != FileKind::exercise) continue;
    const Json *id = document->root().find("id"), *algorithm = document->root().find("algorithm");
    if (id != nullptr && algorithm != nullptr) found[id->text] = algorithm->text;
  }
  return found;
}

}  // namespace

TEST_CASE("every shipped lesson is in order, and every algorithm has one") {
  const auto catalog = load_catalog(lessons_folder);
  CHECK(to_string(catalog.diagnostics) == "");
  CHECK(catalog.lessons.size() >= 30);
  std::set<const Algorithm*> taught;
  for (const auto& [file, lesson] : catalog.lessons) {
    INFO(file.string());
    CHECK(file.stem().string().substr(3) == lesson.id);
    for (std::size_t i = 0; i < lesson.scene_count(); ++i) {
      taught.insert(lesson.scene_at(i).algorithm);
      CHECK(lesson.scene_at(i).beats.front().step == 0);  // says what it is about before anything happens
    }
  }
  for (const Algorithm* algorithm : algorithms()) {
    INFO(algorithm->id);
    CHECK(taught.contains(algorithm));
  }
}

TEST_CASE("the course: units in their order, and each lesson has what a course needs of it") {
  const auto catalog = load_catalog(lessons_folder);
  const auto exercises = shipped_exercises();
  std::string missing;  // a line for each lesson
  std::set<std::string> earlier;
  std::size_t unit_before = 0;
  for (const auto& [file, lesson] : catalog.lessons) {
    std::string lacks;
    const auto lack = [&](const std::string& what) { lacks += (lacks.empty() ? "" : "; ") + what; };
    const std::string name = file.stem().string();
    const Unit* unit = unit_of(lesson.unit.own());
    if (unit == nullptr) {
      lack("no unit of the course is called \"" + lesson.unit.own() + "\"");
    } else {
      const int number = std::atoi(name.c_str());
      if (number < unit->first || unit->last < number) lack("its number is not one of its unit's");
      const auto place = static_cast<std::size_t>(unit - units.data());
      if (place < unit_before) lack("it stands behind a later unit");
      unit_before = std::max(unit_before, place);
    }
    if (lesson.summary.empty()) lack("no summary");
    if (lesson.source.empty()) lack("no source");
    if (lesson.minutes == 0) lack("no minutes");
    if (lesson.objectives.empty()) lack("no objectives");
    if (lesson.prerequisites.empty() && !earlier.empty()) lack("no prerequisites");
    for (const std::string& id : lesson.prerequisites)
      if (!earlier.contains(id)) lack("\"" + id + "\" does not come earlier");
    if (lesson.exercises.size() < 2) lack(std::to_string(lesson.exercises.size()) + " of 2 exercises");
    for (const std::string& id : lesson.exercises) {
      const auto exercise = exercises.find(id);
      if (exercise == exercises.end())
        lack("there is no exercise \"" + id + "\"");
      else if (find_algorithm(exercise->second) == nullptr)
        lack("the exercise \"" + id + "\" is about no algorithm");
    }
    if (checkpoints_of(lesson) == 0) lack("no checkpoint");
    if (!lacks.empty()) missing += name + ": " + lacks + "\n";
    earlier.insert(lesson.id);
  }
  INFO(missing);
  CHECK(missing.empty());
  std::set<std::string> taught;
  for (const auto& entry : catalog.lessons) taught.insert(entry.lesson.unit.own());
  for (const Unit& unit : units) {
    INFO(unit.name);
    CHECK(taught.contains(std::string(unit.name)));
  }
}

TEST_CASE("what the shipped lessons name in other files is there") {
  CourseIndex index;
  index.add_folder(lessons_folder);
  index.add_folder(root_folder / "exercises");
  for (const auto& entry : load_catalog(lessons_folder).lessons)
    CHECK(to_string(check_links(*JsonDocument::load(entry.file), index)).empty());
}

TEST_CASE("every shipped lesson runs to its end, and whatever it says is filled in, in both kinds of numbers") {
  for (const auto& [file, lesson] : load_catalog(lessons_folder).lessons) {
    INFO(file.string());
    for (std::size_t i = 0; i < lesson.scene_count(); ++i) {
      const LessonScene& scene = lesson.scene_at(i);
      const auto exact = run_through<Exact>(scene);
      const auto rounded = run_through<double>(scene);
      for (const std::string& language : lesson.languages.others) run_through<Exact>(scene, language);
      CHECK(exact.trace.step_count() == rounded.trace.step_count());
      CHECK(scene.beats.back().step + 1 == exact.trace.step_count());  // the last word is at the last step
    }
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
