// Surfaces made of surfaces, column by column or row by row: they stay the same surface, and each column or row is what
// the curve's algorithm makes of it.

#include "algorithms/surfaces.hpp"
#include "kernel/surface_degree_elevation.hpp"
#include "kernel/surface_knot_insertion.hpp"
#include "kernel/surface_knot_removal.hpp"
#include "kernel/surface_knot_splitting.hpp"
#include "kernel/surface_subdivision.hpp"

using namespace blossom;
using namespace blossom::test;
using tensor::Direction;

namespace {

void check_labels(const Surface<Exact>& surface, const Trace<Exact>& trace) {
  const auto labels = trace.polar_labels();
  for (ValueId x = 0; x < trace.value_count(); ++x) {
    if (trace.value(x).kind != ValueKind::point) continue;
    INFO(trace.name(x) << " = " << to_string(labels[x]));
    CHECK(is_surface_blossom_value(surface, labels[x], trace.numbers(x), false));
  }
}

}  // namespace

TEST_CASE("a knot inserted in u or v leaves the surface as it is", "[surface_knot_insertion]") {
  int inserted = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const auto d = seed % 2 == 0 ? Direction::u : Direction::v;
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const auto& U = surface.knots[index(d)];
    const Exact t = test::any_parameter(random, surface, index(d));
    const int p = surface.degree[index(d)], s = multiplicity<Exact>(U, t);
    INFO("seed " << seed << ", " << (d == Direction::u ? "u = " : "v = ") << t.to_string() << "\n"
                 << write_surface(surface));
    for (int times = 1; s + times <= p; ++times) {
      const auto made = both_ways<Exact>([&](auto& rec) { return surface_knot_insertion(surface, d, t, times, rec); });
      CHECK(multiplicity<Exact>(made.knots[index(d)], t) == s + times);
      CHECK(same_surface(made, surface));
      // Line by line it is the curve's algorithm.
      NoRecorder<Exact> none;
      const bool column = d == Direction::u;
      for (int line = 0; line < (column ? surface.columns : surface.rows); ++line)
        CHECK(line_of(made, column, line).points ==
              knot_insertion(line_of(surface, column, line), t, times, none).points);
      TraceRecorder<Exact> recorder;
      surface_knot_insertion(surface, d, t, times, recorder);
      if (seed <= 12) check_labels(surface, std::move(recorder).take());
      ++inserted;
    }
  }
  CHECK(inserted > 20);
}

TEST_CASE("the published ratios of a knot stand in every row", "[surface_knot_insertion]") {
  // NB example 5.1: p = 3, U = {0^4, 1, 2, 3, 4, 5^4}, 5/2: 5/6, 1/2, 1/6. Two rows, so degree 1 in u.
  const auto run = run_of("surface_knot_insertion", R"({"surface": {"degree": [1, 3],
    "knots": [[0,0,1,1], [0,0,0,0,1,2,3,4,5,5,5,5]],
    "points": [[[0,0,0],[1,0,0],[2,0,0],[3,0,6],[4,0,0],[5,0,0],[6,0,0],[7,0,0]],
               [[0,1,0],[1,1,0],[2,1,0],[3,1,0],[4,1,0],[5,1,0],[6,1,0],[7,1,0]]]}, "direction": "v", "t": "5/2"})");
  for (const std::string row : {"row[0].", "row[1]."}) {
    CHECK(number_of(run, row + "alpha[1][3]") == Exact::ratio(5, 6));
    CHECK(number_of(run, row + "alpha[1][4]") == Exact::ratio(1, 2));
    CHECK(number_of(run, row + "alpha[1][5]") == Exact::ratio(1, 6));
  }
  CHECK(numbers_of(run, "Q[0][3]") == std::vector<Exact>{q("17/6"), 0, 5, 1});
  CHECK(numbers_of(run, "Q[0][4]") == std::vector<Exact>{q("7/2"), 0, 3, 1});
  CHECK(numbers_of(run, "Q[1][5]") == std::vector<Exact>{q("25/6"), 1, 0, 1});
}

TEST_CASE("more than full multiplicity is refused", "[surface_knot_insertion]") {
  const auto message = [](const char* t, int times) {
    return to_string(inputs_of(*find_algorithm("surface_knot_insertion"),
                               std::string(R"({"surface": {"degree": [2, 1], "knots": [[0,0,0,1,2,2,2],[0,0,1,1]],
        "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]],[[2,0,1],[2,1,1]],[[3,0,0],[3,1,0]]]}, "direction": "u", "t": )") +
                                   t + ", \"times\": " + std::to_string(times) + "}")
                         .diagnostics);
  };
  CHECK(message("1", 1).empty());
  CHECK(message("1", 2).find("times: must be at most 1 here: t has multiplicity 1") != std::string::npos);
  CHECK(message("2", 1).find("t: is a knot of multiplicity 3 already") != std::string::npos);
  CHECK(message("3", 1).find("t: must lie in the domain [0, 2]") != std::string::npos);
}

TEST_CASE("an elevated surface is the same surface, one direction at a time", "[surface_degree_elevation]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto d = seed % 2 == 0 ? Direction::u : Direction::v;
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const int times = random_int(random, 1, 2);
    INFO("seed " << seed << ", " << (d == Direction::u ? "u" : "v") << " by " << times << "\n"
                 << write_surface(surface));
    const auto made = both_ways<Exact>([&](auto& rec) { return surface_degree_elevation(surface, d, times, rec); });
    CHECK(made.degree[index(d)] == surface.degree[index(d)] + times);
    CHECK(made.degree[index(tensor::other(d))] == surface.degree[index(tensor::other(d))]);
    CHECK(same_surface(made, surface));
    // Labels of the new net say so: they are values of the new surface's blossom, of as many arguments.
    TraceRecorder<Exact> recorder;
    surface_degree_elevation(surface, d, times, recorder);
    const auto trace = std::move(recorder).take();
    const auto labels = trace.polar_labels();
    for (int i = 0; i < made.rows; ++i)
      for (int j = 0; j < made.columns; ++j) {
        const auto Q = trace.find("Q[" + std::to_string(i) + "][" + std::to_string(j) + "]");
        REQUIRE(Q);
        INFO(trace.name(*Q) << " = " << to_string(labels[*Q]));
        CHECK(is_surface_blossom_value(made, labels[*Q], trace.numbers(*Q), false));
      }
  }
}

TEST_CASE("the elevated parabola of every column", "[surface_degree_elevation]") {
  const auto run = run_of("surface_degree_elevation", R"({"surface": {"degree": [2, 1],
    "points": [[[-3,0,0],[-3,1,0]],[[0,0,3],[0,1,6]],[[3,0,0],[3,1,0]]]}, "direction": "u"})");
  CHECK(numbers_of(run, "Q[1][0]") == std::vector<Exact>{-1, 0, 2, 1});
  CHECK(numbers_of(run, "Q[2][0]") == std::vector<Exact>{1, 0, 2, 1});
  CHECK(numbers_of(run, "Q[1][1]") == std::vector<Exact>{-1, 1, 4, 1});
  CHECK(numbers_of(run, "Q[3][1]") == std::vector<Exact>{3, 1, 0, 1});
}

TEST_CASE("a surface cut in two is the two together, which meet in the cut", "[surface_subdivision]") {
  int cut = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto d = seed % 2 == 0 ? Direction::u : Direction::v;
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const auto line = line_of(surface, d == Direction::u, 0);
    const Exact t = test::any_parameter(random, surface, index(d));
    if (t == line.domain_begin() || t == line.domain_end()) continue;
    INFO("seed " << seed << ", " << (d == Direction::u ? "u = " : "v = ") << t.to_string() << "\n"
                 << write_surface(surface));
    const auto parts = both_ways<Exact>([&](auto& rec) { return surface_subdivision(surface, d, t, rec); });
    REQUIRE(parts.size() == 2);
    for (std::size_t part = 0; part < 2; ++part) {
      const auto& made = parts[part];
      const auto& U = made.knots[index(d)];
      CHECK(U.front() == (part == 0 ? line.domain_begin() : t));
      CHECK(U.back() == (part == 0 ? t : line.domain_end()));
      CHECK(made.rows * made.columns == static_cast<int>(made.points.size()));
      for (int a = 0; a < 5; ++a)
        for (int b = 0; b < 5; ++b) {
          const Exact along = U.front() + (U.back() - U.front()) * Exact::ratio(2 * a + 1, 10);
          const auto& W = made.knots[index(tensor::other(d))];
          const auto q = static_cast<std::size_t>(made.degree[index(tensor::other(d))]);
          const Exact across = W[q] + (W[W.size() - q - 1] - W[q]) * Exact::ratio(b, 4);
          const Exact &u = d == Direction::u ? along : across, &v = d == Direction::u ? across : along;
          CHECK(homogeneous_point(made, u, v) == homogeneous_point(surface, u, v));
        }
    }
    const bool column = d == Direction::u;
    for (int i = 0; i < (column ? surface.columns : surface.rows); ++i)
      CHECK(line_of(parts[0], column, i).points.back() == line_of(parts[1], column, i).points.front());
    TraceRecorder<Exact> recorder;
    surface_subdivision(surface, d, t, recorder);
    check_labels(surface, std::move(recorder).take());
    ++cut;
  }
  CHECK(cut > 15);
}

TEST_CASE("an end of the domain is no place to cut", "[surface_subdivision]") {
  const auto wrong = inputs_of(*find_algorithm("surface_subdivision"),
                               R"({"surface": {"degree": [1, 1], "points": [[[0,0,0],[0,4,0]],[[4,0,0],[4,4,8]]]},
                                   "direction": "v", "t": 1})");
  CHECK(to_string(wrong.diagnostics).find("t: is an end of the domain") != std::string::npos);
}

TEST_CASE("splitting a knot moves its copies and nothing else", "[surface_knot_splitting]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto d = seed % 2 == 0 ? Direction::u : Direction::v;
    std::mt19937 random(seed);
    auto surface = random_surface(random, 2, 2, 2, true, seed % 3 == 0);
    NoRecorder<Exact> none;
    const auto& U = surface.knots[index(d)];
    const Exact t = U[3];
    if (multiplicity<Exact>(U, t) == 1) surface = surface_knot_insertion(surface, d, t, 1, none);
    const Exact apart = random_ratio(random, 0, 1, 16) / Exact(2) + Exact::ratio(1, 8);
    INFO("seed " << seed << ", " << apart.to_string() << "\n" << write_surface(surface));
    const auto made = both_ways<Exact>([&](auto& rec) { return surface_knot_splitting(surface, d, t, apart, rec); });
    CHECK(made.points == surface.points);
    CHECK(made.knots[index(tensor::other(d))] == surface.knots[index(tensor::other(d))]);
    const auto& old = surface.knots[index(d)];
    const Exact h = apart * std::min(old[3] - old[2], old[5] - old[4]);
    auto expected = old;
    expected[3] = t - h;
    expected[4] = t + h;
    CHECK(made.knots[index(d)] == expected);
    // Line by line it is the curve's algorithm, and E bounds the change of a polynomial surface at t.
    TraceRecorder<Exact> recorder;
    surface_knot_splitting(surface, d, t, apart, recorder);
    const double E = recorder.trace().numbers(*recorder.trace().find("E"))[0].to_double();
    const bool column = d == Direction::u;
    for (int line = 0; line < (column ? surface.columns : surface.rows); ++line)
      CHECK(line_of(made, column, line) == knot_splitting(line_of(surface, column, line), t, apart, none));
    const auto& W = surface.knots[index(tensor::other(d))];
    for (int i = 0; !surface.rational && i <= 8; ++i) {
      const Exact w = W.front() + (W.back() - W.front()) * Exact::ratio(i, 8);
      const Exact &u = column ? t : w, &v = column ? w : t;
      const auto r = homogeneous_point(made, u, v) - homogeneous_point(surface, u, v);
      CHECK(std::sqrt((r.x * r.x + r.y * r.y + r.z * r.z).to_double()) <= E * (1 + 1e-12));
    }
  }
}

TEST_CASE("only a multiple knot inside can be split", "[surface_knot_splitting]") {
  const auto message = [](const char* t, const char* apart) {
    return to_string(inputs_of(*find_algorithm("surface_knot_splitting"),
                               std::string(R"({"surface": {"degree": [2, 1], "knots": [[0,0,0,1,2,2,3,3,3],[0,0,1,1]],
        "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]],[[2,0,1],[2,1,1]],[[3,0,0],[3,1,0]],[[4,0,0],[4,1,0]],
                   [[5,0,0],[5,1,0]]]}, "direction": "u", "t": )") +
                                   t + ", \"apart\": " + apart + "}")
                         .diagnostics);
  };
  CHECK(message("2", "0.5").empty());
  CHECK(message("1", "0.5").find("t: is a simple knot") != std::string::npos);
  CHECK(message("0.5", "0.5").find("t: is no knot") != std::string::npos);
  CHECK(message("3", "0.5").find("t: is an end of the domain") != std::string::npos);
  CHECK(message("2", "1").find("apart: must lie between 0 and 1") != std::string::npos);
}

TEST_CASE("a knot that was inserted can be removed again", "[surface_knot_removal]") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const auto d = seed % 2 == 0 ? Direction::u : Direction::v;
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const auto line = line_of(surface, d == Direction::u, 0);
    Exact t = test::any_parameter(random, surface, index(d));
    if (t == line.domain_begin() || t == line.domain_end()) t = (line.domain_begin() + line.domain_end()) / Exact(2);
    const int s = multiplicity<Exact>(line.knots, t);
    if (s >= line.degree) continue;
    INFO("seed " << seed << " at " << t.to_string() << "\n" << write_surface(surface));
    NoRecorder<Exact> none;
    const auto refined = surface_knot_insertion(surface, d, t, 1, none);
    auto back = both_ways<Exact>([&](auto& rec) { return surface_knot_removal(refined, d, t, Exact(0), rec); });
    back.bezier = surface.bezier;
    CHECK(back == surface);
  }
}

TEST_CASE("one column that does not allow it keeps the knot; a tolerance may", "[surface_knot_removal]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto d = seed % 2 == 0 ? Direction::u : Direction::v;
    std::mt19937 random(seed);
    const auto surface = random_surface(random, 2, 2, 1, true, seed % 3 == 0);
    const auto line = line_of(surface, d == Direction::u, 0);
    const Exact t = (line.domain_begin() + line.domain_end()) / Exact(2);
    NoRecorder<Exact> none;
    auto refined = surface_knot_insertion(surface, d, t, 1, none);
    INFO("seed " << seed << "\n" << write_surface(refined));
    const auto [i, j] = tensor::cell(d, 1, 1);
    refined.at(i, j).z += Exact::ratio(1, 4);
    CHECK(surface_knot_removal(refined, d, t, Exact(0), none) == refined);

    TraceRecorder<Exact> recorder;
    surface_knot_removal(refined, d, t, Exact(0), recorder);
    const Exact E = recorder.trace().numbers(*recorder.trace().find("E"))[0];
    CHECK(recorder.trace().numbers(*recorder.trace().find("e[0]"))[0] == Exact(0));
    CHECK(recorder.trace().numbers(*recorder.trace().find("e[1]"))[0] == E);
    CHECK(Exact(0) < E);
    const auto removed = surface_knot_removal(refined, d, t, E, none);
    CHECK(multiplicity<Exact>(removed.knots[index(d)], t) == 0);
    for (int a = 0; a <= 8; ++a)
      for (int b = 0; b <= 8; ++b) {
        const auto place = [](const std::vector<Exact>& U, int n) -> Exact {
          return U.front() + (U.back() - U.front()) * Exact::ratio(n, 8);
        };
        const Exact u = place(refined.knots[0], a), v = place(refined.knots[1], b);
        const auto r = homogeneous_point(removed, u, v) - homogeneous_point(refined, u, v);
        CHECK((r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w).to_double() <= (E * E).to_double() * (1 + 1e-9));
      }
  }
}

TEST_CASE("only an inner knot can be removed, and the tolerance is no less than 0", "[surface_knot_removal]") {
  const auto message = [](const char* t, const char* tolerance) {
    return to_string(inputs_of(*find_algorithm("surface_knot_removal"),
                               std::string(R"({"surface": {"degree": [2, 1], "knots": [[0,0,0,1,2,2,2],[0,0,1,1]],
        "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]],[[2,0,1],[2,1,1]],[[3,0,0],[3,1,0]]]}, "direction": "u", "t": )") +
                                   t + ", \"tolerance\": " + tolerance + "}")
                         .diagnostics);
  };
  CHECK(message("1", "0").empty());
  CHECK(message("0", "0").find("t: must be a knot between the ends of the domain") != std::string::npos);
  CHECK(message("0.5", "0").find("t: must be a knot between the ends of the domain") != std::string::npos);
  CHECK(message("1", "-1").find("tolerance: must not be negative") != std::string::npos);
}
