// Where beats stand: places that are looked for in a run.

#include "lesson/place.hpp"

#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::optional<Place> place_of(const std::string& text, std::string* mistake = nullptr) {
  const auto document = parsed(text, "place.json");
  Diagnostics diagnostics;
  auto place = read_place(Cursor(document, diagnostics));
  CHECK(place.has_value() == diagnostics.empty());
  if (mistake != nullptr) *mistake = to_string(diagnostics);
  return place;
}

Run<Exact> run_of(const std::string& beats_of) {
  const auto lesson = lesson_of(beat("\"start\""), beats_of);
  return *record<Exact>(*lesson.algorithm, lesson.inputs);
}

// The names of what the steps of a place make, or its phases.
std::vector<std::string> made_at(const std::string& place, const TraceGraph& trace) {
  std::vector<std::string> names;
  for (const std::uint32_t step : steps_of(*place_of(place), trace)) {
    const auto [first, end] = trace.values_of(step);
    const std::uint32_t phase = trace.introduced_by(step);
    names.push_back(step == 0         ? "given"
                    : phase != absent ? "phase " + trace.phases()[phase].label()
                                      : trace.name(first));
    CHECK((phase != absent || first < end));
  }
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("places are read as they are written") {
  for (const std::string text :
       {"\"start\"", "\"end\"", "{\"step\": 12}", "{\"phase\": \"raise[1].decompose\"}", "\"P[1..2][*]\"",
        "{\"last\": \"P[*][*]\"}", "{\"every\": \"alpha[*]\"}", "{\"level\": 2}", "{\"after\": \"elevate\"}"})
    CHECK(write_place(*place_of(text)) == text);
}

TEST_CASE("places of a triangular scheme") {
  const auto run = run_of(spline);
  const TraceGraph& trace = run.trace;
  CHECK(made_at("\"start\"", trace) == Names{"given"});
  CHECK(made_at("\"P[1][*]\"", trace) == Names{"P[1][1]"});  // the first that is made
  CHECK(made_at("{\"last\": \"P[1][*]\"}", trace) == Names{"P[1][2]"});
  CHECK(made_at("{\"every\": \"P[1..2][*]\"}", trace) == Names{"P[1][1]", "P[1][2]", "P[2][2]"});
  CHECK(made_at("{\"every\": \"alpha[*][*]\"}", trace) == Names{"alpha[1][1]", "alpha[1][2]", "alpha[2][2]"});
  // A level begins with what is made first of it, whatever that is.
  CHECK(made_at("{\"level\": 1}", trace) == Names{"alpha[1][1]"});
  CHECK(made_at("{\"level\": 2}", trace) == Names{"alpha[2][2]"});
  CHECK(made_at("{\"level\": 3}", trace).empty());
  CHECK(step_of(*place_of("\"end\""), trace) == std::optional<std::uint32_t>(trace.step_count() - 1));
  CHECK(steps_of(*place_of("{\"step\": 2}"), trace) == std::vector<std::uint32_t>{2});
  CHECK(steps_of(*place_of("{\"step\": 1000}"), trace).empty());
  CHECK_FALSE(step_of(*place_of("{\"every\": \"Q[*]\"}"), trace));
}

TEST_CASE("places of phases, and behind them") {
  const auto run = run_of(raised);
  const TraceGraph& trace = run.trace;
  CHECK(made_at("{\"phase\": \"elevate\"}", trace) == Names{"phase elevate"});
  CHECK(made_at("{\"phase\": \"elevate.round[2]\"}", trace) == Names{"phase round[2]"});
  const auto elevate = step_of(*place_of("{\"phase\": \"elevate\"}"), trace);
  const auto after = step_of(*place_of("{\"after\": \"elevate\"}"), trace);
  REQUIRE((elevate && after));
  // Not in the phase any more, and the step before is.
  const auto is_in = [&](std::uint32_t step) {
    for (const auto& phase : trace.phases())
      if (phase.label() == "elevate") return phase.first_step <= step && step <= phase.last_step;
    return false;
  };
  CHECK_FALSE(is_in(*after));
  CHECK(is_in(*after - 1));
  // Nothing is behind the last one.
  CHECK_FALSE(step_of(*place_of("{\"after\": \"recompose\"}"), trace));
  CHECK(why_nowhere(*place_of("{\"after\": \"recompose\"}"), trace) ==
        "nothing comes behind \"recompose\" in this run");
  CHECK(why_nowhere(*place_of("{\"after\": \"elevat\"}"), trace) ==
        "no phase of this run is called \"elevat\"; did you mean \"elevate\"?");
}

TEST_CASE("what is no place in any run, and what would be one") {
  const auto mistake = [](const std::string& text) {
    std::string told;
    CHECK_FALSE(place_of(text, &told));
    return told;
  };
  CHECK(mistake("7") ==
        "place.json:1:1: must be a selector such as \"P[1][0]\", \"start\", \"end\", or an object such as {\"phase\": "
        "\"parameters\"} or {\"step\": 3}\n");
  CHECK(mistake("\"P[1\"") == "place.json:1:1: is no selector: the bracket at character 2 is not closed\n");
  CHECK(mistake("{}") ==
        "place.json:1:1: must have one of \"last\", \"every\", \"level\", \"phase\", \"after\" and \"step\"\n");
  CHECK(mistake("{\"step\": 1, \"every\": \"P[*]\"}") == "place.json:1:10: step: must be the only key of its place\n");
  CHECK(mistake("{\"level\": -1}") == "place.json:1:11: level: must be a whole number from 0 to 1000000000, not -1\n");
  CHECK(mistake("{\"every\": \"P[\"}") ==
        "place.json:1:11: every: is no selector: the bracket at character 2 is not closed\n");
  CHECK(mistake("{\"evry\": \"P\"}") == "place.json:1:2: unknown key \"evry\"; did you mean \"every\"?\n");
}

TEST_CASE("what may be meant by a place that is none") {
  const auto said = [](const std::string& beats, const std::string& run = parabola) {
    const std::string told = mistakes(beats, run);
    return told.substr(told.find("called") + 7);
  };
  CHECK(said(beat("\"begin\"")) == "\"begin\"; did you mean \"start\"?\n");
  CHECK(said(beat("\"END\"")) == "\"END\"; did you mean \"end\"?\n");
  CHECK(said(beat("\"p[1][0]\"")) == "\"p[1][0]\"; did you mean \"P[1][0]\"?\n");
  CHECK(said(beat("\"P[9][*]\"")) == "\"P[9][*]\"; there are P[0][0..2], P[1][0..1], P[2][0]\n");
  CHECK(said(beat("{\"after\": \"raise\"}"), raised).starts_with("\"raise\"; the phases are \""));
  CHECK(said(beat("{\"phase\": \"elevate\"}")) == "\"elevate\"; this algorithm runs in one piece\n");
  CHECK(mistakes(beat("{\"level\": 7}")) ==
        "lesson.json:3:28: beats[0].at.level: no value that this run makes is of level 7; the levels are 1 to 2\n");
}
