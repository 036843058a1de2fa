// Skinning rational profiles: identical circles placed along an L, as in a pipe's elbow.

#include "algorithms/construction.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

// A place in space with two directions of length 1 across the pipe.
struct Place {
  Point<Exact> centre, right, up;
};

// Along x, around the corner in a plane whose normal is (4, 0, 3)/5, and along z.
std::vector<Place> l_shape() {
  const Point<Exact> y(0, 1, 0), z(0, 0, 1);
  const Point<Exact> tilted(Exact::ratio(-3, 5), Exact(0), Exact::ratio(4, 5)), back(-1, 0, 0);
  return {{{0, 0, 0}, y, z}, {{4, 0, 0}, y, z}, {{7, 0, 1}, y, tilted}, {{8, 0, 4}, y, back}, {{8, 0, 8}, y, back}};
}

// The unit circle, exactly, at that place.
std::string circle_at(const Place& place) {
  const std::vector<std::array<int, 3>> corners = {{1, 0, 1},   {1, 1, 1},  {0, 1, 2},  {-1, 1, 1}, {-1, 0, 1},
                                                   {-1, -1, 1}, {0, -1, 2}, {1, -1, 1}, {1, 0, 1}};
  Curve<Exact> curve{2,    knots({"0", "0", "0", "1/4", "1/4", "1/2", "1/2", "3/4", "3/4", "1", "1", "1"}), {}, 3, true,
                     false};
  for (const auto& [x, y, w] : corners)
    curve.points.emplace_back((place.centre + place.right * Exact(x) + place.up * Exact(y)) * Exact(w), Exact(w));
  return write_curve(curve);
}

}  // namespace

TEST_CASE("circles placed in an L are skinned with all circles in the surface", "[skinning]") {
  const auto places = l_shape();
  std::string profiles;
  for (const auto& place : places) profiles += (profiles.empty() ? "" : ", ") + circle_at(place);
  for (const char* more : {R"("degree_v": 2)", R"("degree_v": 3)", R"("degree_v": 2, "parametrization": "uniform")",
                           R"("degree_v": 3, "parametrization": "centripetal")"}) {
    INFO(more);
    const auto run = run_of("skinning", R"({"profiles": [)" + profiles + "], " + more + "}");
    const auto& surface = surface_of(run);
    CHECK(surface.rational);
    // Equal weights on all profiles stay as they are across them, so that nothing is pulled anywhere between.
    for (int i = 0; i < surface.rows; ++i)
      for (int l = 0; l < surface.columns; ++l)
        CHECK(std::abs((surface.at(i, l).w - Exact(i == 2 || i == 6 ? 2 : 1)).to_double()) < 1e-12);
    for (std::size_t l = 0; l < places.size(); ++l) {
      const Exact v = number_of(run, "v[" + std::to_string(l) + "]");
      for (int i = 0; i <= 12; ++i) {
        const auto P = *point(surface, Exact::ratio(i, 12), v) - places[l].centre;
        CHECK(std::abs(dot(P, P).to_double() - 1) < 1e-11);
        CHECK(std::abs(dot(P, cross(places[l].right, places[l].up)).to_double()) < 1e-11);
      }
    }
  }
}
