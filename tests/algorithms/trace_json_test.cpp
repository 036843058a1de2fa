// Traces as files: what is written, and what a reader that trusts nobody says to files that were not written so.

#include "algorithms/trace_json.hpp"

#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string arc = R"({"curve": {"degree": 2, "points": [[1,0],[1,1],[0,1]], "weights": [1,1,2]}, "u": "1/2"})";
const std::string insertion =
    R"({"curve": {"degree": 2, "knots": [0,0,0,1,2,2,2], "points": [[0,0],[1,1],[2,0],[3,1]]}, "u": "1/2"})";
const std::string lofted = R"({"degree_v": 1, "profiles": [{"degree": 2, "points": [[0,0,0],[1,1,0],[2,0,0]]},
  {"degree": 1, "knots": [0,0,1,2,2], "points": [[0,0,1],[1,1,1],[2,0,2]]}]})";

std::string written(const char* id, const std::string& inputs) {
  const auto run = run_of(id, inputs);
  return write_trace(Narrator<Exact>(run));
}

std::string replaced(std::string text, const std::string& old, const std::string& with) {
  const std::size_t at = text.find(old);
  INFO(old << " in " << text);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), with);
}

std::string complaints(const std::string& text) {
  const auto document = JsonDocument::parse("t", text);
  if (!document) return to_string(document.diagnostics);
  const auto read = read_trace(*document);
  CHECK(read.value.has_value() == read.diagnostics.empty());
  return to_string(read.diagnostics);
}

// The good trace with one thing changed.
std::string complaints(const char* id, const std::string& inputs, const std::string& old, const std::string& with) {
  return complaints(replaced(written(id, inputs), old, with));
}

using Catch::Matchers::Contains;

}  // namespace

TEST_CASE("an exact trace is written with strings for numbers, weights, labels and operands by name", "[trace_json]") {
  const std::string text = written("de_casteljau", arc);
  CHECK_THAT(text, Contains(R"({"schema": "blossom.trace/1", "algorithm": "de_casteljau",)"));
  CHECK_THAT(text, Contains(R"("exact": true, "dimension": 2, "rational": true,)"));
  CHECK_THAT(
      text,
      Contains(
          R"j({"name": "P[1][1]", "kind": "point", "value": ["1/3", "1"], "weight": "3/2", "step": 2, "rule": "blend", "from": ["u", "P[0][1]", "P[0][2]"], "polar": "b(1/2, 1)"})j"));
  CHECK_THAT(text,
             Contains(R"({"name": "u", "kind": "scalar", "value": "1/2", "step": 0, "rule": "input", "from": []})"));
  CHECK_THAT(text, Contains(R"("result": {"point": ["3/5", "4/5"]}})"));
}

TEST_CASE("a double trace is written with numbers that read back as they are", "[trace_json]") {
  const Algorithm& algorithm = *find_algorithm("de_casteljau");
  const auto run = record<double>(
      algorithm, *inputs_of(algorithm, R"({"curve": {"degree": 1, "points": [[0.1,-0.0],[3,1e-7]]}, "u": 0.1})"));
  const std::string text = write_trace(Narrator<double>(*run));
  CHECK_THAT(text, Contains(R"("exact": false, "dimension": 2, "rational": false)"));
  CHECK_THAT(text, Contains(R"("value": [0.1, 0])"));
  CHECK_THAT(text, Contains(R"("value": [3, 1e-07])"));
}

TEST_CASE("phases, scopes and lives are written", "[trace_json]") {
  const std::string text = written("skinning", lofted);
  CHECK_THAT(text, Contains(R"({"id": "compatible", "first_step": 1, "last_step": )"));
  CHECK_THAT(
      text,
      Contains(
          R"({"id": "raise", "index": 1, "scoped": true, "algorithm": "degree_elevation", "parent": 0, "first_step": 2,)"));
  CHECK_THAT(text, Contains(R"("phase": ["compatible", "raise[1]"])"));
  CHECK_THAT(text, Contains(R"("name": "raise[1].V")"));
  CHECK_THAT(text, Contains(R"("retired": )"));
  CHECK_THAT(text, Contains(R"j("polar": "b(0, 0; 0)")j"));
  CHECK_THAT(text, Contains(R"("approximate": true)"));
}

TEST_CASE("numbers longer than anybody types come back", "[trace_json]") {
  const std::string u(180, '7');
  const auto run =
      run_of("de_casteljau",
             R"({"curve": {"degree": 4, "points": [[0,1],[1,0],[2,5],[3,0],[1,1]]}, "u": ")" + u + "/8" + u + R"("})");
  const std::string text = write_trace(Narrator<Exact>(run));
  CHECK(numbers_of(run, "C")[0].to_string().size() > 800);
  const auto read = read_trace(*JsonDocument::parse("t", text));
  INFO(to_string(read.diagnostics));
  REQUIRE(read);
  CHECK(std::get<Run<Exact>>(*read).trace == run.trace);
}

TEST_CASE("a stored trace can be narrated and stepped as the run itself", "[trace_json]") {
  const auto run = run_of("skinning", lofted);
  const auto read = read_trace(*JsonDocument::parse("t", write_trace(Narrator<Exact>(run))));
  REQUIRE(read);
  const Narrator<Exact> before(run);
  const Narrator<Exact> after(std::get<Run<Exact>>(*read));
  for (std::uint32_t k = 0; k < run.trace.step_count(); ++k) CHECK(after.text(k) == before.text(k));
  CHECK(std::get<Run<Exact>>(*read).outcome == run.outcome);
}

TEST_CASE("every mistake in a trace is named where it is", "[trace_json]") {
  const auto casteljau = [](const char* old, const char* with) { return complaints("de_casteljau", arc, old, with); };
  CHECK(complaints(written("de_casteljau", arc)) == "");
  CHECK_THAT(casteljau("trace/1", "trace/2"), Contains("schema: must be \"blossom.trace/1\""));
  CHECK_THAT(casteljau("\"de_casteljau\"", "\"de_castelau\""), Contains("did you mean \"de_casteljau\"?"));
  CHECK_THAT(casteljau("\"rule\": \"blend\"", "\"rule\": \"blnd\""),
             Contains("there is no rule \"blnd\"; did you mean \"blend\"?"));
  CHECK_THAT(casteljau("\"rule\": \"blend\"", "\"rule\": \"ratio\""),
             Contains("makes a value of kind scalar, not point"));
  CHECK_THAT(casteljau("\"rule\": \"blend\"", "\"rule\": \"project\""),
             Contains("these are not the operands of the rule \"project\""));
  CHECK_THAT(casteljau("\"rule\": \"blend\"", "\"rule\": \"input\""),
             Contains("must be empty: an input is made from nothing"));
  CHECK_THAT(casteljau("[\"u\", \"P[0][0]\", \"P[0][1]\"]", "[\"u\", \"P[0][0]\", \"P[2][0]\"]"),
             Contains("there is no value \"P[2][0]\" before this one"));
  CHECK_THAT(casteljau("[\"u\", \"P[0][0]\", \"P[0][1]\"]", "[\"u\", \"P[0][0]\", \"P[1][0]\"]"),
             Contains("there is no value \"P[1][0]\" before this one"));
  CHECK_THAT(casteljau("[\"u\", \"P[0][0]\", \"P[0][1]\"]", "[\"u\", \"P[0][0]\"]"),
             Contains("these are not the operands of the rule \"blend\""));
  CHECK_THAT(casteljau("\"name\": \"P[1][0]\"", "\"name\": \"P[0][0]\""),
             Contains("there is a value \"P[0][0]\" already"));
  CHECK_THAT(casteljau("\"name\": \"P[1][0]\"", "\"name\": \"P[01][0]\""), Contains("its indices must be plain"));
  CHECK_THAT(casteljau("\"name\": \"P[1][0]\"", "\"name\": \"x.P[1][0]\""),
             Contains("must begin with the scope of its phase, \"\""));
  CHECK_THAT(casteljau("\"name\": \"P[1][0]\"", "\"name\": \"P[1][0][0]\""), Contains("with up to two indices"));
  CHECK_THAT(casteljau("\"name\": \"P[1][0]\"", "\"name\": \"P[99999999999]\""), Contains("with up to two indices"));
  CHECK_THAT(casteljau("\"name\": \"P[1][0]\"", "\"name\": \"controlpoint\""), Contains("1 to 8 letters"));
  CHECK_THAT(casteljau("\"kind\": \"point\"", "\"kind\": \"pint\""),
             Contains("there is no kind \"pint\"; did you mean \"point\"?"));
  CHECK_THAT(casteljau("\"weight\": \"3/2\"", "\"weight\": \"3/0\""), Contains("weight: must be a number"));
  CHECK_THAT(casteljau(", \"weight\": \"3/2\"", ""), Contains("missing key \"weight\""));
  CHECK_THAT(casteljau("\"weight\": \"3/2\"", "\"weight\": \"3/2\", \"homogeneous\": [\"1\", \"1\", \"0\", \"3/2\"]"),
             Contains("must be the homogeneous form of value and weight"));
  CHECK_THAT(casteljau("\"step\": 2", "\"step\": 0"), Contains("step: must be"));
  CHECK_THAT(casteljau("\"step\": 2", "\"step\": 200"), Contains("step: must be"));
  CHECK_THAT(casteljau("\"step\": 2", "\"step\": 2, \"retired\": 1"), Contains("retired: must be"));
  CHECK_THAT(casteljau("b(1/2, 1)", "b(1/2, 1/2)"), Contains("polar: must be \"b(1/2, 1)\""));
  CHECK_THAT(casteljau("b(0, 1)", "b(0 1)"), Contains("must be a polar label"));
  CHECK_THAT(casteljau("\"index\": 1", "\"index\": 7"), Contains("steps[1].index: must be"));
  CHECK_THAT(casteljau("\"phase\": []", "\"phase\": [\"x\"]"), Contains("phase: must have 0 items"));
  CHECK_THAT(casteljau("\"u\": \"1/2\"", "\"u\": \"3/2\""), Contains("inputs.u: must lie in the domain [0, 1]"));
  CHECK_THAT(casteljau("\"result\": {\"point\"", "\"result\": {\"pint\""), Contains("did you mean \"point\""));
  CHECK_THAT(casteljau("{\"point\": [\"3/5\", \"4/5\"]}", "{}"), Contains("must have one of"));
  CHECK_THAT(casteljau("\"dimension\": 2", "\"dimension\": 4"), Contains("dimension: must be"));
  CHECK_THAT(casteljau("\"exact\": true", "\"exact\": 1"), Contains("exact: must be true or false"));

  const auto loft = [](const char* old, const char* with) { return complaints("skinning", lofted, old, with); };
  CHECK(complaints(written("skinning", lofted)) == "");
  CHECK_THAT(loft("\"parent\": 0", "\"parent\": 1"), Contains("must have the parent 0, in which it begins"));
  CHECK_THAT(loft(", \"parent\": 0", ""), Contains("must have the parent 0, in which it begins"));
  CHECK_THAT(loft("\"scoped\": true", "\"scoped\": false"), Contains("must begin with the scope of its phase"));
  CHECK_THAT(loft("\"algorithm\": \"degree_elevation\"", "\"algorithm\": \"degree_elevatio\""),
             Contains("did you mean \"degree_elevation\"?"));
  CHECK_THAT(loft("\"first_step\": 2", "\"first_step\": 1"), Contains("must begin after the phase before it"));
  CHECK_THAT(loft("[\"compatible\", \"raise[1]\"]", "[\"compatible\", \"raise[2]\"]"),
             Contains("must be \"raise[1]\", the phase that this step is in"));
}

TEST_CASE("all mistakes at once", "[trace_json]") {
  auto text = written("knot_insertion", insertion);
  text = replaced(text, "\"rule\": \"blend\"", "\"rule\": \"blnd\"");
  text = replaced(text, "\"name\": \"s\"", "\"name\": \"S!\"");
  text = replaced(text, "\"step\": 3", "\"stp\": 3");
  const std::string said = complaints(text);
  CHECK_THAT(said, Contains("there is no rule") && Contains("1 to 8 letters") && Contains("unknown key \"stp\""));
}

TEST_CASE("files that are hostile are refused or harmless, and quickly", "[trace_json]") {
  CHECK_THAT(complaints("[]"), Contains("must be an object"));
  CHECK_THAT(complaints("{}"), Contains("missing key \"algorithm\""));
  CHECK(complaints(std::string(100'000, '[')) != "");
  // Labels that would double with every value.
  std::string values;
  std::string steps;
  for (int i = 0; i < 2000; ++i) {
    const std::string at = std::to_string(i);
    steps += (i > 0 ? "," : "") + std::string(R"({"index":)") + at + R"(,"kind":"","line":0,"phase":[],"text":""})";
    if (i == 0)
      values += R"j({"name":"a","kind":"scalar","value":"1","step":0,"rule":"input","from":[]},
      {"name":"P[0]","kind":"point","value":["0","0"],"step":0,"rule":"input","from":[],"polar":"b(0)"})j";
    else
      values += R"(,{"name":"P[)" + at + R"(]","kind":"point","value":["0","0"],"step":)" + at +
                R"(,"rule":"elevate_end","from":["P[)" + std::to_string(i - 1) + R"(]"]})";
  }
  const std::string growing =
      R"({"schema":"blossom.trace/1","algorithm":"de_casteljau","inputs":{"curve":{"degree":1,"points":[[0,0],[1,1]]},"u":0},
    "exact":true,"dimension":2,"rational":false,"phases":[],"steps":[)" +
      steps + R"(],"values":[)" + values + R"(],"result":{"point":[0,0]}})";
  CHECK(complaints(growing) == "");
  // Phases in phases in phases.
  std::string phases;
  for (int i = 0; i < 1000; ++i)
    phases += (i > 0 ? "," : "") + std::string(R"({"id":"a","scoped":true,)") +
              (i > 0 ? R"("parent":)" + std::to_string(i - 1) + "," : "") + R"("first_step":)" + std::to_string(i) +
              R"(,"last_step":1999})";
  CHECK_THAT(complaints(replaced(growing, "\"phases\":[]", "\"phases\":[" + phases + "]")),
             Contains("nested too deep"));
  CHECK_THAT(complaints(replaced(growing, "\"value\":\"1\"", "\"value\":\"" + std::string(30'000, '9') + "\"")),
             Contains("must be a number"));
}

TEST_CASE("a trace with anything in it broken never breaks the reader", "[trace_json]") {
  const std::string texts[] = {written("de_casteljau", arc), written("skinning", lofted),
                               written("knot_insertion", insertion)};
  std::mt19937 random(20);
  const std::string spare = "0123456789\",[]{}:-/.eb()uPQ; ";
  int accepted = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string text = texts[round % 3];
    const std::size_t from = text.find("\"exact\"");
    for (int change = random_int(random, 1, 3); change > 0; --change) {
      const auto at =
          static_cast<std::size_t>(random_int(random, static_cast<int>(from), static_cast<int>(text.size()) - 40));
      switch (random_int(random, 0, 2)) {
        case 0:
          text[at] = spare[static_cast<std::size_t>(random_int(random, 0, static_cast<int>(spare.size()) - 1))];
          break;
        case 1:
          text.erase(at, 1);
          break;
        case 2: {
          // A piece of one line in another's place.
          const std::size_t other =
              static_cast<std::size_t>(random_int(random, static_cast<int>(from), static_cast<int>(text.size()) - 40));
          text.replace(at, 8, text.substr(other, 8));
        }
      }
    }
    INFO("round " << round);
    const auto document = JsonDocument::parse("t", text);
    if (!document) continue;
    const auto read = read_trace(*document);
    CHECK(read.value.has_value() == read.diagnostics.empty());
    if (!read) continue;
    ++accepted;
    CHECK(!write_trace(Narrator<Exact>(std::get<Run<Exact>>(*read))).empty());  // and what is accepted can be told
  }
  CHECK(accepted > 0);
}
