// A point on a surface, row by row: against the sum of basis functions, and by hand.

#include "kernel/surface_evaluation.hpp"

#include "algorithms/surfaces.hpp"

using namespace blossom;
using namespace blossom::test;
using tensor::Direction;

TEST_CASE("both orders give the sum of control points times basis functions", "[surface_evaluation]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const Exact u = test::any_parameter(random, surface, 0), v = test::any_parameter(random, surface, 1);
    INFO("seed " << seed << "\n" << write_surface(surface) << " at " << u.to_string() << ", " << v.to_string());
    const auto S = homogeneous_point(surface, u, v);
    for (const auto order : {Direction::u, Direction::v}) {
      const auto made = both_ways<Exact>([&](auto& rec) { return surface_evaluation(surface, u, v, order, rec); });
      CHECK(made == S / S.w);
      const auto rounded = convert<double>(surface);
      const auto near_it = both_ways<double>(
          [&](auto& rec) { return surface_evaluation(rounded, u.to_double(), v.to_double(), order, rec); });
      for (int c = 0; c < 4; ++c) CHECK(near(near_it[c], made[c].to_double(), 100.0));
    }
  }
}

TEST_CASE("every point on the way is the value of the surface's blossom that its label says", "[surface_evaluation]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const Exact u = test::any_parameter(random, surface, 0), v = test::any_parameter(random, surface, 1);
    INFO("seed " << seed << "\n" << write_surface(surface) << " at " << u.to_string() << ", " << v.to_string());
    TraceRecorder<Exact> recorder;
    surface_evaluation(surface, u, v, seed % 2 == 0 ? Direction::u : Direction::v, recorder);
    const auto trace = std::move(recorder).take();
    const auto labels = trace.polar_labels();
    for (ValueId x = 0; x < trace.value_count(); ++x) {
      if (trace.value(x).kind != ValueKind::point) continue;
      INFO(trace.name(x) << " = " << to_string(labels[x]));
      CHECK(is_surface_blossom_value(surface, labels[x], trace.numbers(x), trace.value(x).rule == &rule_info<Project>));
    }
  }
}

TEST_CASE("a bilinear patch: two points on its sides, and the point between them", "[surface_evaluation]") {
  const std::string inputs =
      R"({"surface": {"degree": [1, 1], "points": [[[0,0,0],[0,4,0]],[[4,0,0],[4,4,8]]]}, "u": "1/4", "v": "1/2")";
  const auto run = run_of("surface_evaluation", inputs + "}");
  CHECK(numbers_of(run, "R[0]") == std::vector<Exact>{0, 2, 0, 1});
  CHECK(numbers_of(run, "R[1]") == std::vector<Exact>{4, 2, 4, 1});
  CHECK(numbers_of(run, "S") == std::vector<Exact>{1, 2, 1, 1});
  CHECK(numbers_of(run, "row[1].P[1][1]") == std::vector<Exact>{4, 2, 4, 1});
  const auto other = run_of("surface_evaluation", inputs + R"(, "order": "u then v"})");
  CHECK(numbers_of(other, "R[0]") == std::vector<Exact>{1, 0, 0, 1});
  CHECK(numbers_of(other, "R[1]") == std::vector<Exact>{1, 4, 2, 1});
  CHECK(numbers_of(other, "S") == std::vector<Exact>{1, 2, 1, 1});
}

TEST_CASE("only rows in force are evaluated, and at a double knot of degree 2 a single one", "[surface_evaluation]") {
  const auto count = [](const char* u) {
    const auto run = run_of("surface_evaluation", std::string(R"({"surface": {"degree": [2, 1],
      "knots": [[0,0,0,1,1,2,2,2],[0,0,1,1]],
      "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]],[[2,0,1],[2,1,1]],[[3,0,0],[3,1,0]],[[4,0,0],[4,1,0]]]},
      "v": "1/2", "u": )") + u + "}");
    return std::ranges::count(run.trace.phases(), "row", &PhaseRecord::id);
  };
  CHECK(count("\"1/2\"") == 3);
  CHECK(count("1") == 1);
  CHECK(count("0") == 1);
  CHECK(count("2") == 1);
}

TEST_CASE("a parameter outside of the surface is told at its input", "[surface_evaluation]") {
  const auto wrong =
      inputs_of(*find_algorithm("surface_evaluation"),
                R"({"surface": {"degree": [1, 1], "points": [[[0,0,0],[0,4,0]],[[4,0,0],[4,4,8]]]}, "u": -1, "v": 2})");
  CHECK(to_string(wrong.diagnostics).find("u: must lie in the domain [0, 1], not at -1") != std::string::npos);
  CHECK(to_string(wrong.diagnostics).find("v: must lie in the domain [0, 1], not at 2") != std::string::npos);
}
