// Surfaces through and near nets of points.

#include "algorithms/surfaces.hpp"
#include "kernel/surface_approximation.hpp"
#include "kernel/surface_interpolation.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

PointNet<Exact> random_net(std::mt19937& random, int rows, int columns) {
  PointNet<Exact> net{rows, columns, {}};
  for (int k = 0; k < rows; ++k)
    for (int l = 0; l < columns; ++l)
      net.points.push_back(
          {Exact(3 * k), Exact(3 * l) + random_ratio(random, -1, 1, 3), random_ratio(random, -3, 3, 2), Exact(1)});
  return net;
}

// The points of The NURBS Book, example 9.1, moved along z: each row or column of the net has chords 5, 4, 5, 3.
std::string example_9_1(bool rows, int count) {
  const std::vector<std::string> points{"0, 0", "3, 4", "-1, 4", "-4, 0", "-4, -3"};
  const auto point = [&](int along, int across) {
    return "[" + points[static_cast<std::size_t>(along)] + ", " + std::to_string(across) + "]";
  };
  std::string text = "[";
  const int outer = rows ? count : 5, inner = rows ? 5 : count;
  for (int k = 0; k < outer; ++k) {
    text += k > 0 ? ", [" : "[";
    for (int l = 0; l < inner; ++l) text += (l > 0 ? ", " : "") + (rows ? point(l, k) : point(k, l));
    text += "]";
  }
  return text + "]";
}

template <Scalar S>
std::vector<S> parameters(const Trace<S>& trace, const std::string& name, int count) {
  std::vector<S> t;
  for (int k = 0; k < count; ++k) t.push_back(trace.numbers(*trace.find(name + "[" + std::to_string(k) + "]"))[0]);
  return t;
}

}  // namespace

TEST_CASE("the interpolating surface passes through every point at its parameters", "[surface_interpolation]") {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    std::mt19937 random(seed);
    const auto net = random_net(random, random_int(random, 2, 6), random_int(random, 2, 6));
    const int p = random_int(random, 1, std::min(3, net.rows - 1)),
              q = random_int(random, 1, std::min(3, net.columns - 1));
    INFO("seed " << seed << ", degrees " << p << ", " << q << "\n" << write_net(net));
    for (const auto way : {Parametrization::uniform, Parametrization::chord, Parametrization::centripetal}) {
      both_ways<Exact>([&](auto& rec) { return surface_interpolation(net, p, q, way, rec); });
      TraceRecorder<Exact> recorder;
      const auto surface = surface_interpolation(net, p, q, way, recorder);
      const auto trace = std::move(recorder).take();
      const auto u = parameters(trace, "u", net.rows), v = parameters(trace, "v", net.columns);
      CHECK(surface.rows == net.rows);
      CHECK(surface.columns == net.columns);
      CHECK(surface.degree == std::array{p, q});
      for (int k = 0; k < net.rows; ++k)
        for (int l = 0; l < net.columns; ++l) {
          const auto S = homogeneous_point(surface, u[static_cast<std::size_t>(k)], v[static_cast<std::size_t>(l)]);
          if (way == Parametrization::uniform)
            CHECK(S == net.at(k, l));
          else
            for (int c = 0; c < 4; ++c) CHECK(near(S[c].to_double(), net.at(k, l)[c].to_double(), 100.0));
        }
      if (way != Parametrization::uniform) continue;
      const auto labels = trace.polar_labels();
      for (ValueId x = 0; x < trace.value_count(); ++x) {
        if (trace.value(x).kind != ValueKind::point) continue;
        INFO(trace.name(x) << " = " << to_string(labels[x]));
        CHECK(is_surface_blossom_value(surface, labels[x], trace.numbers(x), false));
      }
    }
  }
}

TEST_CASE("published parameters and knots, in rows and in columns", "[surface_interpolation]") {
  for (const bool rows : {true, false}) {
    const auto run = run_of("surface_interpolation", "{\"points\": " + example_9_1(rows, 3) + "}");
    const std::vector<Exact> t{0, q("5/17"), q("9/17"), q("14/17"), 1};
    CHECK(parameters(run.trace, rows ? "v" : "u", 5) == t);
    CHECK(parameters(run.trace, rows ? "u" : "v", 3) == std::vector<Exact>{0, q("1/2"), 1});
    const auto& surface = std::get<Surface<Exact>>(run.outcome);
    CHECK(surface.degree == (rows ? std::array{2, 3} : std::array{3, 2}));  // 3, or less where there are 3 rows
    CHECK(surface.knots[rows ? 1 : 0] == knots({"0", "0", "0", "0", "28/51", "1", "1", "1", "1"}));
  }
}

TEST_CASE("parameters are means over the rows, and a row that is one point has no say", "[surface_interpolation]") {
  // Chords 1 : 3 in one row, 1 : 1 in the other: v = (1/4 + 1/2) / 2; then with a pole as a third row.
  const std::string two = "[[0,0,0],[1,0,0],[4,0,0]], [[0,5,0],[2,5,0],[4,5,0]]";
  const auto mean = run_of("surface_interpolation", "{\"points\": [" + two + "]}");
  CHECK(number_of(mean, "v[1]") == q("3/8"));
  const auto pole = run_of("surface_interpolation", "{\"points\": [" + two + ", [[0,9,0],[0,9,0],[0,9,0]]]}");
  CHECK(number_of(pole, "v[1]") == q("3/8"));
}

TEST_CASE("rows that coincide are told", "[surface_interpolation]") {
  const auto message = [](const char* points) {
    const auto inputs =
        inputs_of(*find_algorithm("surface_interpolation"), std::string("{\"points\": ") + points + "}");
    REQUIRE(inputs);
    return to_string(record<Exact>(*find_algorithm("surface_interpolation"), *inputs).diagnostics);
  };
  CHECK(message("[[[0,0,0],[1,0,0]],[[0,0,0],[1,0,0]]]").find("points: neighbouring rows of points coincide") !=
        std::string::npos);
  CHECK(message("[[[0,0,0],[0,0,0]],[[1,0,0],[1,0,0]]]").find("points: neighbouring columns of points coincide") !=
        std::string::npos);
}

TEST_CASE("with as many control points as points the approximation interpolates", "[surface_approximation]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    const auto net = random_net(random, random_int(random, 2, 5), random_int(random, 2, 5));
    INFO("seed " << seed << "\n" << write_net(net));
    TraceRecorder<Exact> recorder;
    surface_approximation(net, 1, 1, net.rows, net.columns, Parametrization::uniform, recorder);
    CHECK(recorder.trace().numbers(*recorder.trace().find("E"))[0] == Exact(0));
  }
}

TEST_CASE("points of a surface with few control points give it back", "[surface_approximation]") {
  // z = x y, of degree 1 in each direction: whatever the net of its points, nothing is left of the error.
  PointNet<Exact> net{5, 6, {}};
  for (int k = 0; k < 5; ++k)
    for (int l = 0; l < 6; ++l) net.points.push_back({Exact(k), Exact(l), Exact(k * l), Exact(1)});
  TraceRecorder<Exact> recorder;
  const auto surface = surface_approximation(net, 1, 1, 2, 2, Parametrization::uniform, recorder);
  CHECK(recorder.trace().numbers(*recorder.trace().find("E"))[0] == Exact(0));
  CHECK(surface.at(1, 1) == HPoint<Exact>(4, 5, 20, 1));
  CHECK(surface.at(0, 1) == HPoint<Exact>(0, 5, 0, 1));
}

TEST_CASE("in each column the sum of squares is least, and the corners stay", "[surface_approximation]") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const auto net = random_net(random, random_int(random, 5, 7), random_int(random, 4, 6));
    const int rows = random_int(random, 3, net.rows - 1), columns = random_int(random, 3, net.columns - 1);
    const int p = random_int(random, 1, 2), q = random_int(random, 1, 2);
    INFO("seed " << seed << ", " << rows << " x " << columns << ", degrees " << p << ", " << q << "\n"
                 << write_net(net));
    const auto way = Parametrization::uniform;
    const auto surface =
        both_ways<Exact>([&](auto& rec) { return surface_approximation(net, p, q, rows, columns, way, rec); });
    for (const int i : {0, rows - 1})
      for (const int j : {0, columns - 1})
        CHECK(surface.at(i, j) == net.at(i == 0 ? 0 : net.rows - 1, j == 0 ? 0 : net.columns - 1));

    TraceRecorder<Exact> recorder;
    surface_approximation(net, p, q, rows, columns, way, recorder);
    const auto trace = std::move(recorder).take();
    const auto u = parameters(trace, "u", net.rows), v = parameters(trace, "v", net.columns);
    // The curve of each column: at the least sum the residuals are orthogonal to every basis function between the ends.
    for (int l = 0; l < net.columns; ++l) {
      Curve<Exact> curve;
      curve.degree = p;
      curve.knots = surface.knots[0];
      for (int i = 0; i < rows; ++i) {
        const auto R = trace.numbers(*trace.find("R[" + std::to_string(i) + "][" + std::to_string(l) + "]"));
        curve.points.push_back({R[0], R[1], R[2], R[3]});
      }
      for (int i = 1; i + 1 < rows; ++i) {
        HPoint<Exact> sum(0, 0, 0, 0);
        for (int k = 1; k + 1 < net.rows; ++k) {
          const Exact& t = u[static_cast<std::size_t>(k)];
          sum += (net.at(k, l) - homogeneous_point(curve, t)) * basis_function<Exact>(curve.knots, p, i, t);
        }
        CHECK(sum == HPoint<Exact>(0, 0, 0, 0));
      }
    }
    // The error is that of the surface.
    double largest = 0;
    for (int k = 0; k < net.rows; ++k)
      for (int l = 0; l < net.columns; ++l) {
        const auto r =
            net.at(k, l) - homogeneous_point(surface, u[static_cast<std::size_t>(k)], v[static_cast<std::size_t>(l)]);
        largest = std::max(largest, std::sqrt((r.x * r.x + r.y * r.y + r.z * r.z).to_double()));
      }
    CHECK(trace.numbers(*trace.find("E"))[0].to_double() == Approx(largest));
  }
}

TEST_CASE("more control points than points are refused", "[surface_approximation]") {
  const auto wrong = inputs_of(*find_algorithm("surface_approximation"),
                               "{\"points\": " + example_9_1(true, 3) + ", \"rows\": 4, \"columns\": 6}");
  CHECK(to_string(wrong.diagnostics).find("rows: must be from 2 to 3") != std::string::npos);
  CHECK(to_string(wrong.diagnostics).find("columns: must be from 2 to 5") != std::string::npos);
}
