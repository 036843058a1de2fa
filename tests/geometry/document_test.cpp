#include "geometry/document.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <string>

using namespace blossom;

namespace {

template <class Read>
auto read_with(const std::string& text, std::string& said, Read&& read) {
  const auto document = JsonDocument::parse("f", text);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  Diagnostics diagnostics;
  auto result = read(Cursor(*document, diagnostics));
  said = to_string(diagnostics);
  INFO("text " << text << "\n" << said);
  CHECK(result.has_value() == diagnostics.empty());  // a value or reasons, never both, never neither
  return result;
}

Curve<Exact> curve_of(const std::string& text) {
  std::string said;
  const auto curve = read_with(text, said, read_curve);
  INFO(said);
  REQUIRE(curve);
  return *curve;
}

Surface<Exact> surface_of(const std::string& text) {
  std::string said;
  const auto surface = read_with(text, said, read_surface);
  INFO(said);
  REQUIRE(surface);
  return *surface;
}

std::string curve_errors(const std::string& text) {
  std::string said;
  read_with(text, said, read_curve);
  return said;
}

std::string surface_errors(const std::string& text) {
  std::string said;
  read_with(text, said, read_surface);
  return said;
}

const std::string square = "[[0, 0], [0, 1], [1, 1], [1, 0]]";

Exact random_number(std::mt19937& random) {
  return Exact::ratio(static_cast<int>(random() % 2001) - 1000, 1 + static_cast<int>(random() % 60));
}

// Knots for n + 1 points: runs of multiplicity up to p at random distances, the ends clamped or not.
std::vector<Exact> random_knots(std::mt19937& random, int p, int points) {
  const bool clamped = random() % 2 == 0;
  const auto size = static_cast<std::size_t>(points + p + 1), order = static_cast<std::size_t>(p + 1);
  std::vector<Exact> U;
  Exact u = random_number(random);
  const auto next = [&] { return u += Exact::ratio(1 + static_cast<int>(random() % 9), 7); };
  if (clamped) U.insert(U.end(), order, u);
  while (U.size() < size - (clamped ? order : 0)) {
    const std::size_t room = size - (clamped ? order : 0) - U.size();
    U.insert(U.end(), std::min(room, 1 + random() % static_cast<unsigned>(p)), next());
  }
  if (clamped) U.insert(U.end(), order, next());
  return U;
}

HPoint<Exact> random_point(std::mt19937& random, bool rational, int dimension) {
  const Exact w = rational ? Exact::ratio(1 + static_cast<int>(random() % 20), 1 + static_cast<int>(random() % 6)) : 1;
  const Exact z = dimension == 3 ? random_number(random) : Exact(0);
  return {w * random_number(random), w * random_number(random), w * z, w};
}

}  // namespace

TEST_CASE("a curve of each of the four kinds") {
  const auto bezier = curve_of(R"({"degree": 3, "points": )" + square + "}");
  CHECK(bezier.bezier);
  CHECK_FALSE(bezier.rational);
  CHECK(bezier.n() == 3);
  CHECK(bezier.m() == 7);
  CHECK(bezier.knots == std::vector<Exact>{0, 0, 0, 0, 1, 1, 1, 1});
  CHECK(bezier.points[2] == HPoint<Exact>(1, 1, 0, 1));
  CHECK(bezier.dimension == 2);

  const auto arc = curve_of(R"({"degree": 2, "points": [[1,0],[1,1],[0,1]], "weights": [1, 1, "2"]})");
  CHECK(arc.rational);
  CHECK(arc.points[2] == HPoint<Exact>(0, 2, 0, 2));

  const auto spline =
      curve_of(R"({"degree": 2, "knots": [0,0,0,"0.4",1,1,1], "points": [[0,0,"1/3"],[0,1,2],[1,1,0.1],[1,0,0]]})");
  CHECK_FALSE(spline.bezier);
  CHECK(spline.dimension == 3);
  CHECK(spline.knots[3] == Exact::ratio(2, 5));
  CHECK(spline.points[2].z == Exact::ratio(1, 10));
  CHECK(spline.domain_begin() == Exact(0));
  CHECK(spline.domain_end() == Exact(1));

  const auto unclamped =
      curve_of(R"({"degree": 2, "knots": [0,1,2,3,4,5,6], "points": )" + square + R"(, "weights": [1,2,2,1]})");
  CHECK(unclamped.domain_begin() == Exact(2));
  CHECK(unclamped.domain_end() == Exact(4));
}

TEST_CASE("a surface, with and without knots and weights") {
  const auto patch = surface_of(R"({"degree": [1, 2], "points": [[[0,0,0],[0,1,2],[0,2,0]], [[1,0,0],[1,1,2],[1,2,0]]],
                                    "weights": [[1,2,1],[1,"1/2",1]]})");
  CHECK(patch.bezier);
  CHECK(patch.rational);
  CHECK(patch.rows == 2);
  CHECK(patch.columns == 3);
  CHECK(patch.at(1, 1) == HPoint<Exact>(Exact::ratio(1, 2), Exact::ratio(1, 2), 1, Exact::ratio(1, 2)));
  CHECK(patch.knots[1] == std::vector<Exact>{0, 0, 0, 1, 1, 1});

  const auto spline = surface_of(R"({"degree": [1, 1], "knots": [[0,0,1,2,2],[0,0,3,3]],
                                     "points": [[[0,0],[0,1]], [[1,0],[1,1]], [[2,0],[2,1]]]})");
  CHECK_FALSE(spline.bezier);
  CHECK(spline.knots[0][2] == Exact(1));
  CHECK(spline.at(2, 1) == HPoint<Exact>(2, 1, 0, 1));
}

TEST_CASE("every mistake in a curve is said at once, each at its place") {
  CHECK(curve_errors(R"({"degree": 30,
 "knots": [0, 0, 2, 1, "x", 0],
 "pionts": [],
 "weights": 3})") == R"(f:1:1: missing key "points"
f:1:12: degree: must be a whole number from 1 to 25, not 30
f:2:21: knots[3]: knots must not decrease; 1 comes after 2
f:2:24: knots[4]: must be a number or an exact string such as "2/5", not "x"
f:2:29: knots[5]: knots must not decrease; 0 comes after 1
f:3:2: unknown key "pionts"; did you mean "points"?
)");
  CHECK(curve_errors(R"({"degree": 3, "knots": [0,0,0,0,1,1,1,1],
 "points": [[0,0], [1], [1,2,3], [4,null], 5],
 "weights": [1, 1, -2, 1]})") == R"(f:1:24: knots: needs 9 knots (5 points + degree 3 + 1), not 8
f:2:20: points[1]: a point must have 2 or 3 coordinates, not 1
f:2:25: points[2]: must have 2 coordinates, as the first point has, not 3
f:2:37: points[3][1]: must be a number or an exact string such as "2/5", not null
f:2:44: points[4]: must be an array, not 5
f:3:13: weights: must have 5 items, not 4
)");
  CHECK(curve_errors("[]") ==
        "f:1:1: must be an object with keys among \"degree\", \"knots\", \"points\" and \"weights\", not an array\n");
  CHECK(curve_errors("{}") == "f:1:1: missing key \"degree\"\nf:1:1: missing key \"points\"\n");
}

TEST_CASE("the number of points") {
  CHECK(curve_errors(R"({"degree": 2, "points": )" + square + "}") ==
        "f:1:25: points: without knots it is a Bezier one, which needs 3 points (degree 2 + 1), not 4\n");
  CHECK(curve_errors(R"({"degree": 3, "knots": [0,0,0,0,1,1,1], "points": [[0,0],[1,1],[2,0]]})") ==
        "f:1:51: points: needs at least 4 points (degree 3 + 1), not 3\n");
  CHECK(curve_errors(R"({"degree": 1, "points": []})").find("needs 2 points (degree 1 + 1), not 0") !=
        std::string::npos);
}

TEST_CASE("knots: multiplicity, empty domain, equal as doubles") {
  const auto errors = [](const std::string& degree, const std::string& knots) {
    return curve_errors("{\"degree\": " + degree + ", \"points\": " + square + ",\n\"knots\": " + knots + "}");
  };
  CHECK(errors("1", "[0,0,0,0,0,1]") ==
        "f:2:15: knots[2]: a knot may stand at most 2 times (degree + 1); 0 stands more often\n");
  CHECK(errors("3", "[0,1,2,3,3,4,5,6]") == "f:2:10: knots: the domain from u_3 to u_4 is empty: both are 3\n");
  CHECK(errors("2", "[0,0,0,1,1,1]") == "f:2:10: knots: needs 7 knots (4 points + degree 2 + 1), not 6\n");
  CHECK(errors("2", "[]") == "f:2:10: knots: needs 7 knots (4 points + degree 2 + 1), not 0\n");
  CHECK(errors("2", R"([0,0,0,"0.1","0.10000000000000000001",1,1])")
            .find("f:2:23: knots[4]: differs from the knot before by less") == 0);
  CHECK(errors("2", "[-1e308,-1e308,-1e308,0,1e308,1e308,1e308]") == "f:2:10: knots: the knots reach too far apart\n");
  // A knot of multiplicity p + 1 inside is a jump, and allowed.
  CHECK(errors("1", "[0,0,1,1,2,2]").empty());
}

TEST_CASE("a weight may be zero where the denominator stays positive") {
  const auto errors = [](const std::string& knots, const std::string& weights) {
    return curve_errors(R"({"degree": 2, "points": [[0,0],[1,0],[2,0],[3,0],[4,0]], "knots": )" + knots +
                        ",\n\"weights\": " + weights + "}");
  };
  const std::string clamped = "[0,0,0,1,2,3,3,3]", unclamped = "[0,1,2,3,4,5,6,7]", twice = "[0,0,0,1,1,3,3,3]";
  CHECK(errors(clamped, "[1,0,1,0,1]").empty());
  CHECK(errors(clamped, "[0,1,1,1,0]") ==
        "f:2:13: weights[0]: must be positive: at u = 0 no other point has influence\n"
        "f:2:21: weights[4]: must be positive: at u = 3 no other point has influence\n");
  CHECK(errors(clamped, "[1,0,0,0,1]") ==
        "f:2:15: weights[1]: the weights 1 to 2 must not all be zero: at u = 1 no other point has influence\n"
        "f:2:17: weights[2]: the weights 2 to 3 must not all be zero: at u = 2 no other point has influence\n");
  CHECK(errors(unclamped, "[0,1,0,1,0]").empty());
  CHECK(errors(unclamped, "[0,0,1,1,1]") ==
        "f:2:13: weights[0]: the weights 0 to 1 must not all be zero: at u = 2 no other point has influence\n");
  CHECK(errors(twice, "[1,1,0,1,1]") ==
        "f:2:17: weights[2]: must be positive: at u = 1 no other point has influence\n");
  CHECK(errors("[0,0,0,1,1,1,3,3]", "[1,1,0,1,1]") ==
        "f:2:17: weights[2]: must be positive: at u = 1 no other point has influence\n");
  CHECK(errors(clamped, "[1,-1,1,\"-1/2\",1]") ==
        "f:2:15: weights[1]: a weight must not be negative, not -1\n"
        "f:2:20: weights[3]: a weight must not be negative, not -1/2\n");
}

TEST_CASE("where a curve with zero weights is accepted, its denominator is positive everywhere") {
  // An independent route: the denominator by the Cox-de Boor recurrence at many parameters.
  const auto seed = GENERATE(1u, 2u);
  INFO("seed " << seed);
  std::mt19937 random(seed);
  int accepted = 0, refused = 0;
  for (int round = 0; round < 400; ++round) {
    const int p = 1 + static_cast<int>(random() % 3), points = p + 1 + static_cast<int>(random() % 5);
    Curve<Exact> curve{.degree = p, .knots = random_knots(random, p, points), .points = {}, .rational = true};
    for (int i = 0; i < points; ++i) {
      HPoint<Exact> P = random_point(random, true, 2);
      if (random() % 3 == 0) P = {0, 0, 0, 0};
      curve.points.push_back(P);
    }
    const auto& U = curve.knots;
    if (curve.domain_begin() == curve.domain_end()) continue;
    bool positive = true;
    const auto denominator = [&](const Exact& u, std::size_t span) {
      std::vector<Exact> N(U.size() - 1, Exact(0));
      N[span] = 1;
      for (std::size_t q = 1; q <= static_cast<std::size_t>(p); ++q) {
        for (std::size_t i = 0; i + q + 1 < U.size(); ++i) {
          const Exact left = U[i + q] == U[i] ? Exact(0) : (u - U[i]) / (U[i + q] - U[i]) * N[i];
          const Exact right =
              U[i + q + 1] == U[i + 1] ? Exact(0) : (U[i + q + 1] - u) / (U[i + q + 1] - U[i + 1]) * N[i + 1];
          N[i] = left + right;
        }
      }
      Exact sum = 0;
      for (std::size_t i = 0; i < curve.points.size(); ++i) sum += N[i] * curve.points[i].w;
      return sum;
    };
    for (std::size_t k = static_cast<std::size_t>(p); k < curve.points.size(); ++k) {
      if (U[k] == U[k + 1]) continue;
      for (const int step : {0, 1, 2, 3}) {
        positive = positive && denominator(U[k] + (U[k + 1] - U[k]) * Exact::ratio(step, 3), k) > Exact(0);
      }
    }
    std::string said;
    const auto read = read_with(write_curve(curve), said, read_curve);
    INFO(write_curve(curve) << "\n" << said);
    REQUIRE(read.has_value() == positive);
    (positive ? accepted : refused) += 1;
    if (read) REQUIRE(*read == curve);
  }
  CHECK(accepted > 50);
  CHECK(refused > 50);
}

TEST_CASE("every mistake in a surface is said at once, each at its place") {
  CHECK(surface_errors(R"({"degree": [2, 0],
 "knots": [[0,0,1,1], [0,1]],
 "points": [[[0,0,0],[1,0,0]], [[0,1,0]], 7, [[0,2],[1,2,0]]],
 "weights": [[1,1],[1,1]]})") == R"(f:1:16: degree[1]: must be a whole number from 1 to 25, not 0
f:3:32: points[1]: must have 2 points, as the first row has, not 1
f:3:43: points[2]: must be an array, not 7
f:3:47: points[3][0]: must have 3 coordinates, as the first point has, not 2
)");
  CHECK(surface_errors(R"({"degree": [1, 1], "knots": [[0,0,1,1], [0,1,0,1]],
 "points": [[[0,0,0],[1,0,0],[2,0,0]], [[0,1,0],[1,1,0],[2,1,0]]],
 "weights": [[1,1,-1],[1,1]]})") == R"(f:1:41: knots[1]: needs 5 knots (3 columns + degree 1 + 1), not 4
f:1:46: knots[1][2]: knots must not decrease; 0 comes after 1
f:3:19: weights[0][2]: a weight must not be negative, not -1
f:3:23: weights[1]: must have 3 items, not 2
)");
  CHECK(surface_errors(R"({"degree": 3, "points": []})") == R"(f:1:12: degree: must be an array, not 3
f:1:25: points: must have at least 1 item, not 0
)");
  CHECK(surface_errors(R"({"degree": [2, 1], "points": [[[0,0],[1,0]],[[0,1],[1,1]]]})") ==
        "f:1:30: points: without knots it is a Bezier one, which needs 3 rows (degree 2 + 1), not 2\n");
}

TEST_CASE("zero weights of a surface: no pair of knots may be without influence") {
  const auto errors = [](const std::string& weights) {
    return surface_errors(R"({"degree": [2, 1], "points": [[[0,0],[0,1],[0,2]],[[1,0],[1,1],[1,2]],[[2,0],[2,1],[2,2]]],
 "knots": [[0,0,0,1,1,1],[0,0,1,2,2]],
 "weights": )" + weights + "}");
  };
  CHECK(errors("[[1,1,1],[0,0,0],[1,1,1]]").empty());
  CHECK(errors("[[1,0,1],[1,1,1],[1,1,0]]") ==
        "f:3:17: weights[0][1]: must be positive: at (u, v) = (0, 1) no other point has influence\n"
        "f:3:35: weights[2][2]: must be positive: at (u, v) = (1, 2) no other point has influence\n");
}

TEST_CASE("hostile: numbers whose products no double can hold") {
  CHECK(curve_errors(R"({"degree": 1, "points": [[1e200,0],[1,1]], "weights": ["1e200", 1]})") ==
        "f:1:56: weights[0]: the point times this weight is too large; at most about 1.8e308\n");
  CHECK(curve_errors(R"({"degree": 1, "points": [[1,0],[1,1]], "weights": ["1e-400", 1]})") ==
        "f:1:52: weights[0]: too small for a weight; it must be 0 or at least 5e-324\n");
  CHECK(curve_errors(R"({"degree": 1, "points": [["1e400",0],[1,1]]})").find("too large") != std::string::npos);
}

TEST_CASE("hostile: more than 65,536 points") {
  std::string points = "[[0,0]";
  for (int i = 0; i < 65'536; ++i) points += ",[1,1]";
  CHECK(curve_errors(R"({"degree": 1, "points": )" + points + "]}") ==
        "f:1:25: points: must have at most 65536 items, not 65537\n");
  std::string rows = "[" + points + "]";
  CHECK(surface_errors(R"({"degree": [1, 1], "points": )" + rows + "," + points + "]]}")
            .find("must have at most 32768 items, not 65537") != std::string::npos);
}

TEST_CASE("hostile: any word of a good file replaced by another is refused or read, never half") {
  const std::string good =
      R"({"degree": [1, 2], "knots": [[0, 0, 1, 1], [0, 0, 0, 2, 2, 2]], "points": [[[0, 0, 0], [0, 1, 0],
    [0, 2, 0]], [[1, 0, 0], [1, 1, 0], [1, 2, 0]]], "weights": [[1, 1, 1], [1, 2, 1]]})";
  const std::string curve =
      R"({"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[0, 0], [0, 1], [1, 1]], "weights": [1, 0, 1]})";
  const std::vector<std::string> words{"[]", "{}",   "null", "-1",        "1e308",    "\"1/3\"",         "0",
                                       "99", "[[]]", "\"\"", "[0, 0, 0]", "[[0, 0]]", "{\"degree\": 1}", "1e-320"};
  for (const auto& [text, is_curve] : {std::pair(good, false), std::pair(curve, true)}) {
    int count = 0;
    for (std::size_t i = text.find(':') + 1; i < text.size(); ++i) {
      if (text[i] != '[' && (text[i] < '0' || text[i] > '9')) continue;
      std::size_t end = i + 1;
      for (int depth = text[i] == '[' ? 1 : 0; depth > 0; ++end)
        depth += text[end] == '[' ? 1 : text[end] == ']' ? -1 : 0;
      for (const std::string& word : words) {
        std::string said;
        const std::string changed = text.substr(0, i) + word + text.substr(end);
        if (is_curve) {
          read_with(changed, said, read_curve);
        } else {
          read_with(changed, said, read_surface);
        }
        ++count;
      }
    }
    CHECK(count > 200);
  }
}

TEST_CASE("a curve is written as text that reads back as the same curve") {
  const auto seed = GENERATE(31u, 32u, 33u);
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 100; ++round) {
    Curve<Exact> curve;
    curve.degree = 1 + static_cast<int>(random() % 6);
    curve.bezier = random() % 3 == 0;
    curve.rational = random() % 2 == 0;
    curve.dimension = random() % 2 == 0 ? 2 : 3;
    const int points = curve.degree + 1 + (curve.bezier ? 0 : static_cast<int>(random() % 8));
    curve.knots = curve.bezier ? bezier_knots<Exact>(curve.degree) : random_knots(random, curve.degree, points);
    for (int i = 0; i < points; ++i) curve.points.push_back(random_point(random, curve.rational, curve.dimension));
    if (curve.domain_begin() == curve.domain_end()) continue;

    const std::string text = write_curve(curve);
    INFO(text);
    REQUIRE(text.find('\n') == std::string::npos);
    REQUIRE(curve_of(text) == curve);
    REQUIRE(convert<Exact>(curve) == curve);

    // Doubles keep every digit: knots and weights come back bit for bit, points up to the division by the weight.
    const Curve<double> rounded = convert<double>(curve);
    const Curve<double> again = convert<double>(curve_of(write_curve(rounded)));
    REQUIRE(again.knots == rounded.knots);
    for (std::size_t i = 0; i < rounded.points.size(); ++i) {
      REQUIRE(again.points[i].w == rounded.points[i].w);
      REQUIRE(again.points[i].x == Approx(rounded.points[i].x).epsilon(1e-15));
      REQUIRE(rounded.points[i].x == curve.points[i].x.to_double());
    }
    if (!curve.rational) REQUIRE(again == rounded);
  }
}

TEST_CASE("a surface is written as text that reads back as the same surface") {
  const auto seed = GENERATE(41u, 42u);
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 60; ++round) {
    Surface<Exact> surface;
    surface.bezier = random() % 3 == 0;
    surface.rational = random() % 2 == 0;
    for (int& p : surface.degree) p = 1 + static_cast<int>(random() % 4);
    const auto count = [&](int p) { return p + 1 + (surface.bezier ? 0 : static_cast<int>(random() % 4)); };
    surface.rows = count(surface.degree[0]);
    surface.columns = count(surface.degree[1]);
    for (std::size_t d = 0; d < 2; ++d) {
      const int p = surface.degree[d], points = d == 0 ? surface.rows : surface.columns;
      do {
        surface.knots[d] = surface.bezier ? bezier_knots<Exact>(p) : random_knots(random, p, points);
      } while (surface.knots[d][static_cast<std::size_t>(p)] == surface.knots[d][static_cast<std::size_t>(points)]);
    }
    for (int i = 0; i < surface.rows * surface.columns; ++i) {
      surface.points.push_back(random_point(random, surface.rational, 3));
    }
    const std::string text = write_surface(surface);
    INFO(text);
    REQUIRE(surface_of(text) == surface);
    const Surface<double> rounded = convert<double>(surface);
    if (!surface.rational) REQUIRE(convert<double>(surface_of(write_surface(rounded))) == rounded);
  }
}

TEST_CASE("exact numbers are written as strings") {
  CHECK(
      write_curve(curve_of(
          R"({"degree": 1, "knots": [0,0,0.5,2,2], "points": [[1,0],["1/3",-2],[1e2,0]], "weights": [1,"0.5",0.1]})")) ==
      R"({"degree": 1, "knots": ["0", "0", "1/2", "2", "2"], "points": [["1", "0"], ["1/3", "-2"], ["100", "0"]], )"
      R"("weights": ["1", "1/2", "1/10"]})");
  CHECK(write_curve(convert<double>(curve_of(R"({"degree": 1, "points": [[0.1,0],["1/4",-2]]})"))) ==
        R"({"degree": 1, "points": [[0.1, 0], [0.25, -2]]})");
}

TEST_CASE("what came of a Bezier curve and has other knots is written with them") {
  auto curve = curve_of(R"({"degree": 1, "points": [[0,0],[1,1]]})");
  curve.knots = {0, 0, 2, 2};
  CHECK(write_curve(curve) == R"({"degree": 1, "knots": ["0", "0", "2", "2"], "points": [["0", "0"], ["1", "1"]]})");
}
