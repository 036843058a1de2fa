// The curve in space above a rational plane curve: its shadow is the plane curve, and it is an ordinary B-spline curve.

#include "kernel/projection.hpp"
#include "algorithms/pieces.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Curve<Exact> plane_curve(std::mt19937& random, bool rational) {
  const int p = random_int(random, 1, 4);
  auto curve = random_curve(random, p, random_int(random, 1, 4), p, random_int(random, 0, 2) > 0, rational);
  curve.dimension = 2;
  for (auto& P : curve.points) P.z = Exact(0);
  return curve;
}

HPoint<Exact> numbers_of(const Trace<Exact>& trace, const std::string& name) {
  const auto P = trace.numbers(*trace.find(name));
  return {P[0], P[1], P[2], P[3]};
}

}  // namespace

TEST_CASE("the shadow of the point in space is the point of the plane curve", "[projection]") {
  for (unsigned seed = 1; seed <= 80; ++seed) {
    std::mt19937 random(seed);
    const auto curve = plane_curve(random, seed % 3 != 0);
    const Exact u = any_parameter(random, curve);
    INFO("seed " << seed << ", u = " << u.to_string() << "\n" << write_curve(curve));
    const auto C = both_ways<Exact>([&](auto& rec) { return projection(curve, u, rec); });
    const auto right = *point(curve, u);
    CHECK(C == HPoint<Exact>(right.x, right.y, 1, 1));
  }
}

TEST_CASE("what is done in space is done on the lifted curve, without weights", "[projection]") {
  for (unsigned seed = 1; seed <= 80; ++seed) {
    std::mt19937 random(seed);
    const auto curve = plane_curve(random, true);
    const Exact u = any_parameter(random, curve);
    INFO("seed " << seed << ", u = " << u.to_string() << "\n" << write_curve(curve));
    TraceRecorder<Exact> recorder;
    projection(curve, u, recorder);
    const auto trace = std::move(recorder).take();
    const auto space = lifted(curve);
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const auto H = numbers_of(trace, "H[" + std::to_string(i) + "]");
      CHECK(H == space.points[i]);
      CHECK(H.z == curve.points[i].w);  // the weight is the height
    }
    const auto top = numbers_of(trace, "Cw");
    CHECK(top == HPoint<Exact>(*point(space, u), 1));
    const auto plane = *point(at_height_one(curve), u);
    CHECK(plane.z == Exact(1));
    CHECK(plane * top.z == Point<Exact>(top.x, top.y, top.z));
  }
}

TEST_CASE("NURBS Book, example 4.1: the point in space and its shadow", "[projection]") {
  Curve<Exact> curve{
      2, {0, 0, 0, 1, 2, 3, 3, 3}, {{0, 0, 0, 1}, {4, 4, 0, 4}, {3, 2, 0, 1}, {4, 1, 0, 1}, {5, -1, 0, 1}}};
  curve.rational = true;
  TraceRecorder<Exact> recorder;
  const auto C = projection(curve, Exact(1), recorder);
  const auto trace = std::move(recorder).take();
  CHECK(numbers_of(trace, "Cw") == HPoint<Exact>(Exact::ratio(7, 2), 3, Exact::ratio(5, 2), 1));
  CHECK(C == HPoint<Exact>(Exact::ratio(7, 5), Exact::ratio(6, 5), 1, 1));
}

TEST_CASE("a control point of weight 0 and a curve in space have no plane at height 1", "[projection]") {
  const auto mistakes = [](const std::string& curve) {
    const auto document = JsonDocument::parse("inputs", R"({"curve": )" + curve + R"(, "u": "1/2"})");
    REQUIRE(document);
    Diagnostics found;
    CHECK(!read_inputs(*find_algorithm("projection"), Cursor(*document, found)));
    return to_string(found);
  };
  CHECK(
      mistakes(R"({"degree": 2, "points": [[0, 0], [1, 1], [2, 0]], "weights": [1, 0, 1]})").find("weight 0 at P_1") !=
      std::string::npos);
  CHECK(mistakes(R"({"degree": 1, "points": [[0, 0, 0], [1, 1, 1]]})").find("must be a plane curve") !=
        std::string::npos);
}
