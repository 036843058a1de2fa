// The true sweep: sections in rotation-minimising frames, and an error that says how good the skin between them is.

#include "algorithms/construction.hpp"
#include "kernel/frame.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const char* half_ring = R"({"degree": 2, "points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]})";

std::string sweep_text(const std::string& profile, const std::string& trajectory, const std::string& more) {
  return R"({"profile": )" + profile + R"(, "trajectory": )" + trajectory + more + "}";
}

Run<Exact> swept(const std::string& profile, const std::string& trajectory, const std::string& more) {
  return run_of("sweep", sweep_text(profile, trajectory, more));
}

Point<double> rounded_point(const Surface<Exact>& surface, const Exact& u, const Exact& v) {
  return rounded(*point(surface, u, v));
}

// The largest distance between a surface and the true sweep at places between its sections, the frames carried along in
// steps so small that they are as good as exact, by a kernel that shares no code with the sweep's.
double largest_distance(const Run<Exact>& run) {
  const auto& surface = surface_of(run);
  const auto profile = convert<double>(run.inputs.curve("profile"));
  const auto trajectory = convert<double>(run.inputs.curve("trajectory"));
  const double begin = trajectory.domain_begin(), end = trajectory.domain_end();
  constexpr int steps = 1200;
  std::vector<double> v;
  for (int i = 0; i <= steps; ++i) v.push_back(begin + (end - begin) * i / steps);
  v.back() = end;
  const auto t = frame(trajectory, begin)->tangent;
  std::vector<std::optional<MovingFrame>> frames;
  rotation_minimising_frames(trajectory, v, frames, Point<double>(-t.y, t.x, 0));
  const auto made = convert<double>(surface);
  double largest = 0;
  for (int i = 0; i <= steps; i += 3) {
    const auto& f = *frames[static_cast<std::size_t>(i)];
    for (int k = 0; k <= 16; ++k) {
      const double u = profile.domain_begin() + (profile.domain_end() - profile.domain_begin()) * k / 16;
      const auto P = *point(profile, u);
      const auto there = f.point + f.normal * P.x + f.binormal * P.y + f.tangent * P.z;
      const auto here = *point(made, u, v[static_cast<std::size_t>(i)]);
      largest = std::max(largest, distance(here, there));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("along a straight line a sweep is the translation, exactly", "[sweep]") {
  // The direction is (3, 4, 0)/5: n = (-4, 3, 0)/5, b = (0, 0, 1).
  for (const char* frame : {R"(, "frame": "fixed")", R"(, "frame": "rotation-minimising")"}) {
    const auto run = swept(half_ring, R"({"degree": 1, "points": [[1, 2, 3], [7, 10, 3]]})", frame);
    const auto& surface = surface_of(run);
    CHECK(number_of(run, "error") == Exact(0));
    std::mt19937 random(1);
    const auto& profile = run.inputs.curve("profile");
    for (int i = 0; i < 30; ++i) {
      const Exact u = random_u(random, surface), v = random_v(random, surface);
      const auto P = *point(profile, u);
      CHECK(*point(surface, u, v) == Point<Exact>(Exact(1) + Exact(6) * v - P.x * Exact::ratio(4, 5),
                                                  Exact(2) + Exact(8) * v + P.x * Exact::ratio(3, 5), Exact(3) + P.y));
    }
  }
}

TEST_CASE("a third coordinate of the profile runs along the trajectory", "[sweep]") {
  const auto run =
      swept(R"({"degree": 1, "points": [[1, 2, 3], [4, 5, 6]]})", R"({"degree": 1, "points": [[0, 0], [10, 0]]})", "");
  CHECK(*point(surface_of(run), 0, 0) == Point<Exact>(3, 1, 2));
  CHECK(*point(surface_of(run), 1, 0) == Point<Exact>(6, 4, 5));
}

TEST_CASE("the sections stand in the surface, at the knots of the trajectory and evenly between", "[sweep]") {
  const auto run = swept(half_ring,
                         R"({"degree": 3, "knots": [0, 0, 0, 0, "1/4", 1, 1, 1, 1],
                             "points": [[0, 0, 0], [4, 0, 1], [4, 5, 3], [0, 6, 4], [-3, 2, 9]]})",
                         R"(, "sections": 9)");
  const auto& surface = surface_of(run);
  REQUIRE(surface.columns == 9);
  for (int l = 0; l < 9; ++l) {
    const std::string name = std::to_string(l);
    const Exact v = number_of(run, "v[" + name + "]");
    CHECK(v == (l <= 4 ? Exact::ratio(l, 16) : Exact::ratio(1, 4) + Exact::ratio(3 * (l - 4), 16)));
    const auto X = numbers_of(run, "section[" + name + "].X");
    const auto on_trajectory = *point(run.inputs.curve("trajectory"), v);
    for (int i = 0; i <= 8; ++i) {
      const Exact u = Exact::ratio(i, 8);
      const auto P = rounded(*point(run.inputs.curve("profile"), u));
      const auto vector = [&](const char* which) {
        const auto d = numbers_of(run, "section[" + name + "]." + which);
        return Point<double>(d[0].to_double(), d[1].to_double(), d[2].to_double());
      };
      const auto expected = rounded(on_trajectory) + vector("n") * P.x + vector("b") * P.y;
      CHECK(distance(rounded_point(surface, u, v), expected) < 1e-11);
      CHECK(X[0] == on_trajectory.x);
    }
  }
}

TEST_CASE("around a circle the frame comes back as it began", "[sweep]") {
  const auto run = swept(half_ring,
                         R"({"degree": 3, "knots": [0, 0, 0, 0, "1/2", "1/2", "1/2", 1, 1, 1, 1],
                             "points": [[5, 0], [5, 10], [-5, 10], [-5, 0], [-5, -10], [5, -10], [5, 0]],
                             "weights": [1, "1/3", "1/3", 1, "1/3", "1/3", 1]})",
                         R"(, "sections": 17)");
  const auto& surface = surface_of(run);
  for (int i = 0; i < surface.rows; ++i)
    CHECK(distance(rounded(*affine_point(surface.at(i, 0))),
                   rounded(*affine_point(surface.at(i, surface.columns - 1)))) < 1e-12);
  for (int l = 0; l < 17; ++l) CHECK(numbers_of(run, "section[" + std::to_string(l) + "].b").at(2) == Exact(1));
}

TEST_CASE("the surface is nowhere much farther from the true sweep than its error says", "[sweep]") {
  // Random trajectories without sharp turns. Between the middles the distance may be larger by a factor; frames are
  // carried from section to section with an error of their own.
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    Curve<Exact> trajectory;
    trajectory.degree = 3;
    trajectory.dimension = 3;
    trajectory.knots = knots({"0", "0", "0", "0", "1/2", "1", "1", "1", "1"});
    for (int i = 0; i < 5; ++i)
      trajectory.points.emplace_back(Exact(4 * i), Exact(random_int(random, -3, 3)), Exact(random_int(random, -3, 3)),
                                     1);
    INFO("seed " << seed << "\n" << write_curve(trajectory));
    const auto run = swept(half_ring, write_curve(trajectory), R"(, "sections": 17)");
    const double error = number_of(run, "error").to_double();
    const double largest = largest_distance(run);
    INFO("error " << error << ", found " << largest);
    CHECK(largest <= 2 * error);
    CHECK(error <= 2 * largest);
  }
}

TEST_CASE("sections = 0 doubles them until the tolerance is kept", "[sweep]") {
  const char* bend = R"({"degree": 3, "points": [[0, 0, 0], [6, 0, 2], [6, 6, 0], [0, 6, 5]]})";
  int columns = 0;
  for (const char* tolerance : {"1/2", "1/20", "1/200", "1/2000"}) {
    const auto run = swept(half_ring, bend, std::string(R"(, "sections": 0, "tolerance": ")") + tolerance + "\"");
    INFO(tolerance << ": " << surface_of(run).columns << " sections");
    CHECK(number_of(run, "error") <= q(tolerance));
    CHECK(surface_of(run).columns >= columns);
    columns = surface_of(run).columns;
    CHECK(largest_distance(run) <= 2 * q(tolerance).to_double());
  }
  CHECK(columns > 4);
  // At most 64: then the error says that the tolerance was not reached.
  const auto run = swept(half_ring, bend, R"(, "sections": 0, "tolerance": "1e-12")");
  CHECK(surface_of(run).columns == 49);
  CHECK(number_of(run, "error") > q("1e-12"));
}

TEST_CASE("a fixed frame keeps the profile's first place", "[sweep]") {
  const auto run = swept(half_ring, R"({"degree": 2, "points": [[0, 0], [5, 0], [5, 5]]})", R"(, "frame": "fixed")");
  const auto& surface = surface_of(run);
  for (int i = 0; i <= 8; ++i) {
    const Exact u = Exact::ratio(i, 8);
    const auto P = *point(run.inputs.curve("profile"), u);
    CHECK(*point(surface, u, 1) == Point<Exact>(5, Exact(5) + P.x, P.y));
  }
}

TEST_CASE("what has no tangent, jumps, or asks for one section is told", "[sweep]") {
  const auto message = [](const char* trajectory, const char* more = "") {
    return refusal("sweep", sweep_text(half_ring, trajectory, more));
  };
  CHECK(message(R"({"degree": 1, "points": [[0, 0], [1, 0]]})").empty());
  CHECK(message(R"({"degree": 1, "points": [[0, 0], [1, 0]]})", R"(, "sections": 1)").find("sections: must be 0") !=
        std::string::npos);
  CHECK(message(R"({"degree": 1, "points": [[0, 0], [1, 0]]})", R"(, "tolerance": 0)")
            .find("tolerance: must be above 0") != std::string::npos);
  CHECK(message(R"({"degree": 2, "points": [[0, 0], [0, 0], [1, 0]]})").find("trajectory: stands still at v = 0") !=
        std::string::npos);
  CHECK(message(R"({"degree": 1, "knots": [0, 0, 1, 1, 2, 2], "points": [[0, 0], [1, 0], [2, 0], [3, 0]]})")
            .find("trajectory: must be connected") != std::string::npos);
  CHECK(message(R"({"degree": 2, "points": [[0, 0], [5, 5], [0, 0]]})").find("trajectory: comes back to where") !=
        std::string::npos);
}
