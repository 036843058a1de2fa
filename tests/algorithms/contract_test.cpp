// What holds for every algorithm in the table, on random inputs of every kind: the contract that lessons, pictures and
// grades stand on.

#include <catch2/catch.hpp>
#include <set>

#include "algorithms/inputs.hpp"
#include "algorithms/narrate.hpp"
#include "algorithms/trace_json.hpp"
#include "trace/timeline.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr unsigned runs = 40;

// Equal to rounding, measured against the largest number of the trace: elimination and extrapolation cancel.
bool agree(double x, double right, double scale) { return std::abs(x - right) <= 1e-9 * std::max(1.0, scale); }

// Phases, steps and values: what does not pass through geometry files, which keep coordinates and weights apart.
std::string recorded_part(const std::string& json) {
  const std::size_t begin = json.find("\"phases\"");
  return json.substr(begin, json.find("\n\"result\"") - begin);
}

const Algorithm& owner_of(const Run<Exact>& run, ValueId v) {
  return Narrator<Exact>(run).algorithm_at(run.trace.value(v).step);
}

}  // namespace

TEMPLATE_TEST_CASE("a recorded run gives what an unrecorded one gives, bit for bit", "[contract]", double, Exact) {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto recorded = record<TestType>(algorithm, inputs);
    const auto plain = run_plain<TestType>(algorithm, inputs);
    REQUIRE(recorded);
    REQUIRE(plain);
    CHECK(recorded->outcome == *plain);
  });
}

TEST_CASE("the double trace takes the steps of the exact one and agrees with it to rounding", "[contract]") {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto exact = record<Exact>(algorithm, inputs);
    const auto rounded = record<double>(algorithm, inputs);
    REQUIRE(exact);
    REQUIRE(rounded);
    const auto& a = exact->trace;
    const auto& b = rounded->trace;
    REQUIRE(a.step_count() == b.step_count());
    REQUIRE(a.value_count() == b.value_count());
    CHECK(a.phases() == b.phases());
    double scale = 0;
    for (ValueId v = 0; v < a.value_count(); ++v)
      for (const Exact& x : a.numbers(v)) scale = std::max(scale, std::abs(x.to_double()));
    for (ValueId v = 0; v < a.value_count(); ++v) {
      INFO(a.name(v));
      CHECK(a.name(v) == b.name(v));
      CHECK(a.value(v).rule == b.value(v).rule);
      CHECK(a.value(v).step == b.value(v).step);
      CHECK(a.retired_at(v) == b.retired_at(v));
      REQUIRE(a.numbers(v).size() == b.numbers(v).size());
      for (std::size_t i = 0; i < a.numbers(v).size(); ++i)
        CHECK(agree(b.numbers(v)[i], a.numbers(v)[i].to_double(), scale));
    }
  });
}

TEST_CASE("the state reached by seeking is the state reached by stepping from the beginning", "[contract]") {
  for_each_run(8, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<double>(algorithm, inputs);
    REQUIRE(run);
    const auto& trace = run->trace;
    std::vector<TimelineState> stepped;
    Timeline timeline(trace);
    do stepped.push_back(timeline.state());
    while (timeline.forward());
    REQUIRE(stepped.size() == trace.step_count());

    std::mt19937 random(1);
    bool same = true;
    for (int jump = 0; jump < 200; ++jump) {
      timeline.seek(static_cast<std::uint32_t>(random_int(random, 0, static_cast<int>(timeline.last()))));
      same = same && timeline.state() == stepped[timeline.position()];
    }
    CHECK(same);
    timeline.seek(timeline.last());
    while (timeline.back()) same = same && timeline.state() == stepped[timeline.position()];
    CHECK(same);
    for (std::uint32_t k = 0; k < trace.step_count(); ++k) {
      std::vector<ValueId> alive;
      for (ValueId v = 0; v < trace.value_count(); ++v)
        if (trace.alive(v, k)) alive.push_back(v);
      same = same && stepped[k].alive == alive && stepped[k].phases == trace.phase_path(trace.step(k).phase);
    }
    CHECK(same);
  });
}

TEST_CASE("every step is narrated, every value has a formula and an entry in a table", "[contract]") {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<Exact>(algorithm, inputs);
    REQUIRE(run);
    const Narrator<Exact> narrator(*run);
    const auto& trace = run->trace;
    for (std::uint32_t k = 0; k < trace.step_count(); ++k) {
      const std::string text = narrator.text(k);
      INFO("step " << k << ": " << text);
      CHECK(!text.empty());
      CHECK(text.find_first_of("{}") == std::string::npos);
      CHECK(narrator.line(k) <= static_cast<int>(narrator.algorithm_at(k).pseudo_code.size()));
    }
    for (ValueId v = 0; v < trace.value_count(); ++v) {
      INFO(trace.name(v));
      const Algorithm& owner = narrator.algorithm_at(trace.value(v).step);
      CHECK((owner.spec(trace.value(v).name) != nullptr || algorithm.spec(trace.value(v).name) != nullptr));
      if (trace.is_input(v)) continue;
      for (const std::string& text : {narrator.formula(v), narrator.numbers(v)}) {
        CHECK(!text.empty());
        CHECK(text.find_first_of("{}") == std::string::npos);
      }
    }
    for (std::uint32_t i = 0; i < trace.phases().size(); ++i) {
      INFO("phase " << trace.phases()[i].label());
      CHECK(narrator.algorithm_at(trace.phases()[i].first_step).phase(trace.phases()[i].id) != nullptr);
      CHECK(narrator.phase_title(i).find_first_of("{}") == std::string::npos);
    }
  });
}

TEMPLATE_TEST_CASE("a trace written to JSON and read back is the same trace", "[contract]", double, Exact) {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<TestType>(algorithm, inputs);
    REQUIRE(run);
    const std::string text = write_trace(Narrator<TestType>(*run));
    const auto document = JsonDocument::parse("trace", text);
    INFO(to_string(document.diagnostics));
    REQUIRE(document);
    const auto stored = read_trace(*document);
    INFO(to_string(stored.diagnostics));
    REQUIRE(stored);
    const auto* read = std::get_if<Run<TestType>>(&*stored);
    REQUIRE(read != nullptr);
    CHECK(read->algorithm == &algorithm);
    CHECK(read->trace == run->trace);
    CHECK(read->trace.approximate_values() == run->trace.approximate_values());
    CHECK(recorded_part(write_trace(Narrator<TestType>(*read))) == recorded_part(text));
    if (std::is_same_v<TestType, Exact>) CHECK(read->inputs == run->inputs);
  });
}

TEMPLATE_TEST_CASE("every number follows again by its rule from its operands", "[contract]", double, Exact) {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<TestType>(algorithm, inputs);
    REQUIRE(run);
    const auto again = run->trace.replay();
    for (ValueId v = 0; v < run->trace.value_count(); ++v) {
      INFO(run->trace.name(v));
      CHECK(std::ranges::equal(again[v], run->trace.numbers(v)));
    }
  });
}

TEST_CASE("names are unique, operands are made before, and values live for a while", "[contract]") {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<double>(algorithm, inputs);
    REQUIRE(run);
    const auto& trace = run->trace;
    std::set<std::string> names;
    for (ValueId v = 0; v < trace.value_count(); ++v) {
      INFO(trace.name(v));
      CHECK(names.insert(trace.name(v)).second);
      CHECK(trace.find(trace.name(v)) == v);
      for (const ValueId o : trace.operands(v)) CHECK(o < v);
      CHECK(trace.retired_at(v) > trace.value(v).step);
    }
  });
}

TEST_CASE("every rule that is used stands in the table of its algorithm", "[contract]") {
  for_each_run(runs, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<Exact>(algorithm, inputs);
    REQUIRE(run);
    for (ValueId v = 0; v < run->trace.value_count(); ++v) {
      const RuleInfo* rule = run->trace.value(v).rule;
      if (rule == nullptr) continue;
      INFO(run->trace.name(v) << " by " << rule->name);
      const auto& own = owner_of(*run, v).rules;
      const bool listed = std::ranges::count(own, rule) + std::ranges::count(algorithm.rules, rule) > 0;
      CHECK(listed);
      CHECK(find_rule(rule->name) == rule);
    }
  });
}

TEST_CASE("a run whose numbers overflow is refused in double, and exact in exact arithmetic", "[contract]") {
  const Algorithm& algorithm = *find_algorithm("degree_elevation");
  const auto document = JsonDocument::parse(
      "inputs",
      R"({"curve": {"degree": 2, "knots": [0,1,10,10.1,20,21], "points": [[1.7e308,0],[-1.7e308,0],[1.7e308,0]]}})");
  Diagnostics diagnostics;
  const auto inputs = read_inputs(algorithm, Cursor(*document, diagnostics));  // unclamped: new points are extrapolated
  REQUIRE(inputs);
  CHECK(to_string(record<double>(algorithm, *inputs).diagnostics).find("too large for double precision") !=
        std::string::npos);
  CHECK(to_string(run_plain<double>(algorithm, *inputs).diagnostics).find("too large for double precision") !=
        std::string::npos);
  CHECK(record<Exact>(algorithm, *inputs));
}
