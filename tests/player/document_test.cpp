#include "player/document.hpp"

#include <catch2/catch.hpp>

#include "algorithms/trace_json.hpp"
#include "geometry/document.hpp"
#include "lesson/catalog.hpp"
#include "player/edit.hpp"
#include "player/random_edits.hpp"
#include "scratch.hpp"

using namespace blossom;

namespace {

const auto root_folder = std::filesystem::path(BLOSSOM_SOURCE_DIR);

std::vector<std::filesystem::path> shipped_files() {
  Diagnostics none;
  auto files = json_files(root_folder / "lessons", none);
  for (auto& file : json_files(root_folder / "exercises", none)) files.push_back(std::move(file));
  REQUIRE(none.empty());
  REQUIRE(files.size() >= 24);
  return files;
}

Checked<Document> read(const std::string& text, std::string_view algorithm = {}) {
  auto json = JsonDocument::parse("file.json", text);
  INFO(to_string(json.diagnostics));
  REQUIRE(json);
  return read_document(std::move(*json), algorithm);
}

std::string mistakes(const std::string& text, std::string_view algorithm = {}) {
  const auto document = read(text, algorithm);
  CHECK(document.value.has_value() == document.diagnostics.empty());
  return to_string(document.diagnostics);
}

Document opened(const std::filesystem::path& file) {
  auto document = open_document(file);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  return std::move(*document);
}

Lesson loaded(const std::string& text) {
  const auto json = JsonDocument::parse("saved.json", text);
  INFO(text);
  REQUIRE(json);
  auto lesson = load_lesson(*json);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  return std::move(*lesson);
}

const std::string curve_text = R"({"degree": 2, "knots": [0, 0, 0, 1, 3, 3, 3],
  "points": [[0, 0], [1, 2], [3, 3], [5, 1]]})";

}  // namespace

TEST_CASE("every shipped lesson and exercise opens as what it is") {
  for (const auto& file : shipped_files()) {
    INFO(file.string());
    const Document document = opened(file);
    const bool is_lesson = file.parent_path().filename() == "lessons";
    CHECK((document.kind == Document::Kind::lesson) == is_lesson);
    CHECK((document.kind == Document::Kind::exercise) == !is_lesson);
    CHECK(document.lesson.has_value() == is_lesson);
    CHECK((document.grader != nullptr) == !is_lesson);
    CHECK(document.marking == (is_lesson ? Marking::at_once : Marking::at_end));
    CHECK(document.file.is_absolute());
    CHECK_FALSE(document.title().empty());
    CHECK(record<double>(*document.algorithm, document.inputs));
    if (!is_lesson) CHECK(document.asks.size() > 0);
  }
}

TEST_CASE("a trace opens as the inputs it is of") {
  const auto lesson = opened(root_folder / "lessons/45-de-boor-nurbs.json");
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  REQUIRE(run);
  const test::Scratch scratch;
  const Document document = opened(scratch.write("trace.json", write_trace(Narrator<Exact>(*run))));
  CHECK(document.kind == Document::Kind::inputs);
  CHECK(document.algorithm == lesson.algorithm);
  CHECK(document.inputs == lesson.inputs);
  CHECK(document.id() == "trace");
  CHECK(document.title() == "trace.json");
}

TEST_CASE("a curve alone is evaluated in the middle of its domain, or goes to the algorithm that is named") {
  const auto document = read(curve_text);
  REQUIRE(document);
  CHECK(document->algorithm->id == "de_boor");
  CHECK(document->inputs.number("u") == Exact::ratio(3, 2));
  const auto elevated = read(curve_text, "degree_elevation");
  REQUIRE(elevated);
  CHECK(elevated->inputs.integer("times") == 1);
  CHECK_THAT(mistakes(curve_text, "skinning"), Catch::Contains("skinning needs more: its input \"profiles\""));
  CHECK(mistakes(R"({"degree": 2, "points": [[0, 0], [1, 2]]})") ==
        "file.json:1:25: points: without knots it is a Bezier one, which needs 3 points (degree 2 + 1), not 2\n");
}

TEST_CASE("a file of inputs is opened for the algorithm that is named") {
  const std::string inputs = R"({"curve": )" + curve_text + R"(, "u": 2})";
  const auto document = read(inputs, "knot_insertion");
  REQUIRE(document);
  CHECK(document->kind == Document::Kind::inputs);
  CHECK(document->inputs.integer("times") == 1);
  std::string fitting;
  for (const Algorithm* algorithm : algorithms())
    if (algorithm->input("curve") != nullptr && algorithm->input("u") != nullptr)
      fitting += (fitting.empty() ? "" : ", ") + std::string(algorithm->id);
  CHECK_THAT(fitting, Catch::Contains("de_boor, de_casteljau"));
  CHECK_THAT(fitting, !Catch::Contains("skinning"));
  CHECK(mistakes(inputs) ==
        "file.json:1:1: is no lesson, exercise, trace or curve; to open it as inputs, say of which algorithm (" +
            fitting + "): --algorithm ID\n");
  CHECK(mistakes(inputs, "de_bor") == "there is no algorithm \"de_bor\"; did you mean \"de_boor\"?\n");
  CHECK(mistakes(R"({"curve": )" + curve_text + R"(, "u": 4})", "de_boor") ==
        "file.json:2:53: u: must lie in the domain [0, 3], not at 4\n");
}

TEST_CASE("what turns out impossible in the run is said where it stands in the file") {
  CHECK(mistakes(R"({"profiles": [{"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[0, 0, 1], [1, 0, 1]]}], "degree_v": 1})",
                 "skinning") ==
        "file.json:2:1: profiles[1]: coincides with the profile before it: neighbouring profiles must differ\n");
}

TEST_CASE("what cannot be opened says what it is, or what it would have to be") {
  CHECK(mistakes(R"({"schema": "blossom.answers/1", "exercise": "de-boor", "answers": {}})") ==
        "file.json:1:1: these are answers: open the exercise \"de-boor\", or grade them with blossom-grade\n");
  CHECK_THAT(mistakes(R"({"schema": "blossom.grade/1", "exercise": "de-boor", "parts": []})"),
             Catch::Contains("this is a grade: open the exercise \"de-boor\""));
  CHECK_THAT(mistakes(R"({"degree": [1, 1], "points": []})"), Catch::Contains("this is a surface"));
  CHECK_THAT(mistakes(R"({"$schema": "https://json-schema.org/draft/2020-12/schema"})"),
             Catch::Contains("this is a JSON Schema"));
  CHECK_THAT(mistakes("[]"), Catch::Contains("these are objects"));
  CHECK_THAT(mistakes(R"({"colour": "red"})"), Catch::Contains("it has no \"schema\""));
  CHECK_THAT(mistakes(R"({"schema": "blossom.trace/9", "algorithm": "de_boor", "inputs": {}})"),
             Catch::Contains("this program does not know that version"));
  CHECK_THAT(to_string(open_document("/no/such/file.json").diagnostics), Catch::StartsWith("/no/such/file.json: "));
}

TEST_CASE("what is predicted, and when it is marked, is said by the lesson and by the exercise") {
  const std::string head = R"({"schema": "blossom.lesson/1", "id": "a", "title": "A", "algorithm": "de_boor",
"inputs": {"curve": )" + curve_text +
                           R"(, "u": 2}, "beats": [{"at": "start", "say": "Look."}], "predict": )";
  const auto document = read(head + R"({"ask": ["P[1][*]", "C"], "marking": "at-end"}})");
  REQUIRE(document);
  CHECK(document->asks == std::vector<std::string>{"P[1][*]", "C"});
  CHECK(document->marking == Marking::at_end);
  const auto saved = loaded(as_lesson(*document, document->inputs, "b", "B"));
  CHECK(saved.asks == document->asks);
  CHECK(saved.marking == Marking::at_end);

  const auto exercise = opened(root_folder / "exercises/22-de-boor.json");
  const auto as_saved = loaded(as_lesson(exercise, exercise.inputs, "c", "C"));
  CHECK(as_saved.asks == exercise.asks);
  CHECK(as_saved.marking == Marking::at_end);
  CHECK(as_saved.beats[0].say.own() == exercise.grader->exercise().prompt);
}

TEST_CASE("example inputs are those of the first lesson about the algorithm") {
  for (const Algorithm* algorithm : algorithms()) {
    INFO(algorithm->id);
    const auto example = example_document(algorithm->id, root_folder / "lessons");
    REQUIRE(example);
    CHECK(example->kind == Document::Kind::inputs);
    CHECK(example->file.empty());
    CHECK(example->title() == algorithm->title);
  }
  // In a lesson of several scenes it is the first scene about it.
  const test::Scratch folder;
  for (const char* file : {"questions.json", "22-de-boor.json"})
    std::filesystem::copy_file(root_folder / "tests/play/data" / file,
                               folder / std::string(*file == 'q' ? "1.json" : "2.json"));
  const Document questions = opened(root_folder / "tests/play/data/questions.json");
  CHECK(example_document("de_boor", folder.path())->inputs == questions.lesson->scene_at(1).inputs);
  CHECK(example_document("de_casteljau", folder.path())->inputs == questions.lesson->scene_at(0).inputs);
  const test::Scratch empty;
  CHECK_THAT(to_string(example_document("de_boor", empty.path()).diagnostics),
             Catch::Contains("has no lesson about de_boor"));
  CHECK_THAT(to_string(example_document("deboor", root_folder / "lessons").diagnostics),
             Catch::Contains("did you mean \"de_boor\"?"));
}

TEST_CASE("a shipped lesson saved without edits is the same lesson") {
  for (const auto& file : shipped_files()) {
    INFO(file.string());
    const Document document = opened(file);
    const Lesson saved = loaded(as_lesson(document, document.inputs, document.id(), document.title()));
    CHECK(saved.id == document.id());
    CHECK(saved.title.own() == document.title());
    CHECK(saved.algorithm == document.algorithm);
    CHECK(saved.inputs == document.inputs);
    CHECK(saved.asks == document.asks);
    CHECK(saved.marking == document.marking);
    if (!document.lesson) continue;
    CHECK(saved.unit == document.lesson->unit);
    CHECK(saved.summary == document.lesson->summary);
    CHECK(saved.source == document.lesson->source);
    CHECK(saved.minutes == document.lesson->minutes);
    REQUIRE(saved.beats.size() == document.lesson->beats.size());
    for (std::size_t i = 0; i < saved.beats.size(); ++i) {
      CHECK(saved.beats[i].step == document.lesson->beats[i].step);
      CHECK(saved.beats[i].say == document.lesson->beats[i].say);
      CHECK(saved.beats[i].highlights == document.lesson->beats[i].highlights);
      CHECK(saved.beats[i].at == document.lesson->beats[i].at);
    }
  }
}

TEST_CASE("every lesson and exercise with edited inputs is saved as a lesson without a mistake") {
  const unsigned seed = 777;
  INFO("seed " << seed);
  test::RandomEdits edits(seed);
  int saved = 0, fewer_beats = 0;
  for (const auto& file : shipped_files()) {
    INFO(file.string());
    const Document document = opened(file);
    Inputs<Exact> inputs = document.inputs;
    for (int i = 0; i < 30; ++i) {
      auto [what, edited] = edits.next(*document.algorithm, inputs);
      if (!edited || !record<Exact>(*document.algorithm, *edited)) continue;  // what the player does not show
      inputs = std::move(*edited);
      INFO(what);
      const Lesson lesson = loaded(as_lesson(document, inputs, "edited", "Edited"));
      CHECK(lesson.inputs == inputs);
      ++saved;
      if (document.lesson && lesson.beats.size() < document.lesson->beats.size()) ++fewer_beats;
    }
  }
  CHECK(saved > 300);
  CHECK(fewer_beats > 20);  // so that what is left out was tested, too
}

TEST_CASE("a saved lesson looks like the shipped ones, and its id and title are what a lesson may have") {
  const auto document = read(curve_text);
  REQUIRE(document);
  CHECK(as_lesson(*document, document->inputs, "Ünser Kurve (2)", " ") == R"({
  "schema": "blossom.lesson/1",
  "id": "nser-kurve-2",
  "title": "de Boor's algorithm",
  "algorithm": "de_boor",
  "inputs": {
    "curve": {
      "degree": 2,
      "knots": [0, 0, 0, 1, 3, 3, 3],
      "points": [[0, 0], [1, 2], [3, 3], [5, 1]]
    },
    "u": 1.5
  },
  "beats": [
    {
      "at": "start",
      "say": ")" + std::string(document->algorithm->given_narration) +
                                                                              R"("
    }
  ]
}
)");
  loaded(as_lesson(*document, document->inputs, "???", "A\ttitle\nwith \"quotes\""));
}
