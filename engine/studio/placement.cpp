#include "studio/placement.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace blossom {
namespace {

struct CosSin {
  Exact cos, sin;
};

CosSin cos_sin(const Exact& degrees) {
  constexpr double countable = 9e15;  // whole numbers that a double tells apart
  const Exact quarters = degrees / Exact(90);
  if (quarters.is_integer() && std::abs(quarters.to_double()) < countable) {
    const auto turns = static_cast<std::int64_t>(quarters.to_double());
    constexpr std::array<int, 4> cosines{1, 0, -1, 0};
    const auto quarter = static_cast<std::size_t>((turns % 4 + 4) % 4);
    return {cosines[quarter], cosines[(quarter + 3) % 4]};
  }
  const double radians = std::remainder(degrees.to_double(), 360.0) * std::numbers::pi / 180;
  return {Exact::approximate(std::cos(radians)), Exact::approximate(std::sin(radians))};
}

// The linear part, row by row: the turn about x, then y, then z, of what is scaled.
using Matrix = std::array<std::array<Exact, 3>, 3>;

Matrix linear_part(const Placement& place) {
  Matrix M{};
  for (std::size_t i = 0; i < 3; ++i) M[i][i] = Exact(1);
  // Rows a and b of the matrix turn into each other; by nothing they stay exact.
  const auto turn = [&](std::size_t a, std::size_t b, const Exact& degrees) {
    if (degrees == Exact(0)) return;
    const auto [c, s] = cos_sin(degrees);
    for (std::size_t j = 0; j < 3; ++j) {
      const Exact x = M[a][j], y = M[b][j];
      M[a][j] = c * x - s * y;
      M[b][j] = s * x + c * y;
    }
  };
  turn(1, 2, place.turn.x);
  turn(2, 0, place.turn.y);
  turn(0, 1, place.turn.z);
  for (auto& row : M) {
    row[0] *= place.scale.x;
    row[1] *= place.scale.y;
    row[2] *= place.scale.z;
  }
  return M;
}

Exact sum_of(const std::array<Exact, 3>& row, const Exact& x, const Exact& y, const Exact& z) {
  // A coordinate of 0 leaves the others exact, whatever it is multiplied with.
  Exact sum(0);
  if (x != Exact(0) && row[0] != Exact(0)) sum += row[0] * x;
  if (y != Exact(0) && row[1] != Exact(0)) sum += row[1] * y;
  if (z != Exact(0) && row[2] != Exact(0)) sum += row[2] * z;
  return sum;
}

// (wx, wy, wz, w) goes to (M (wx, wy, wz) + w t, w).
void place_all(std::vector<HPoint<Exact>>& points, const Placement& place) {
  if (place.is_identity()) return;
  const Matrix M = linear_part(place);
  for (HPoint<Exact>& P : points)
    P = {sum_of(M[0], P.x, P.y, P.z) + P.w * place.move.x, sum_of(M[1], P.x, P.y, P.z) + P.w * place.move.y,
         sum_of(M[2], P.x, P.y, P.z) + P.w * place.move.z, P.w};
}

int dimension_of(const std::vector<HPoint<Exact>>& points, int before) {
  for (const HPoint<Exact>& P : points)
    if (P.z != Exact(0)) return 3;
  return before;
}

}  // namespace

Point<Exact> placed(const Point<Exact>& P, const Placement& place) {
  std::vector<HPoint<Exact>> one{{P.x, P.y, P.z, Exact(1)}};
  place_all(one, place);
  return {one[0].x, one[0].y, one[0].z};
}

Curve<Exact> placed(const Curve<Exact>& curve, const Placement& place) {
  Curve<Exact> result = curve;
  place_all(result.points, place);
  result.dimension = dimension_of(result.points, curve.dimension);
  return result;
}

Surface<Exact> placed(const Surface<Exact>& surface, const Placement& place) {
  Surface<Exact> result = surface;
  place_all(result.points, place);
  return result;
}

PointRow<Exact> placed(const PointRow<Exact>& row, const Placement& place) {
  PointRow<Exact> result = row;
  place_all(result.points, place);
  result.dimension = dimension_of(result.points, row.dimension);
  return result;
}

PointNet<Exact> placed(const PointNet<Exact>& net, const Placement& place) {
  PointNet<Exact> result = net;
  place_all(result.points, place);
  return result;
}

Placement about(const Placement& place, const Point<Exact>& centre) {
  Placement linear = place;
  linear.move = {Exact(0), Exact(0), Exact(0)};
  const Point<Exact> turned = placed(centre, linear);
  Placement result = place;
  result.move = {place.move.x + centre.x - turned.x, place.move.y + centre.y - turned.y,
                 place.move.z + centre.z - turned.z};
  return result;
}

}  // namespace blossom
