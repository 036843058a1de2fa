#include "geometry/geometry.hpp"

namespace blossom {
namespace {

template <Scalar S>
std::vector<S> convert_all(const std::vector<Exact>& numbers) {
  std::vector<S> result;
  result.reserve(numbers.size());
  for (const Exact& x : numbers) result.push_back(from_exact<S>(x));
  return result;
}

template <Scalar S>
std::vector<HPoint<S>> convert_all(const std::vector<HPoint<Exact>>& points) {
  std::vector<HPoint<S>> result;
  result.reserve(points.size());
  for (const HPoint<Exact>& P : points) {
    result.emplace_back(from_exact<S>(P.x), from_exact<S>(P.y), from_exact<S>(P.z), from_exact<S>(P.w));
  }
  return result;
}

}  // namespace

template <Scalar S>
Curve<S> convert(const Curve<Exact>& curve) {
  return {.degree = curve.degree,
          .knots = convert_all<S>(curve.knots),
          .points = convert_all<S>(curve.points),
          .dimension = curve.dimension,
          .rational = curve.rational,
          .bezier = curve.bezier};
}

template <Scalar S>
Surface<S> convert(const Surface<Exact>& surface) {
  return {.degree = surface.degree,
          .knots = {convert_all<S>(surface.knots[0]), convert_all<S>(surface.knots[1])},
          .rows = surface.rows,
          .columns = surface.columns,
          .points = convert_all<S>(surface.points),
          .rational = surface.rational,
          .bezier = surface.bezier};
}

template <Scalar S>
PointRow<S> convert(const PointRow<Exact>& row) {
  return {convert_all<S>(row.points), row.dimension};
}

template <Scalar S>
PointNet<S> convert(const PointNet<Exact>& net) {
  return {net.rows, net.columns, convert_all<S>(net.points)};
}

template Curve<double> convert(const Curve<Exact>&);
template Curve<Exact> convert(const Curve<Exact>&);
template Surface<double> convert(const Surface<Exact>&);
template Surface<Exact> convert(const Surface<Exact>&);
template PointRow<double> convert(const PointRow<Exact>&);
template PointRow<Exact> convert(const PointRow<Exact>&);
template PointNet<double> convert(const PointNet<Exact>&);
template PointNet<Exact> convert(const PointNet<Exact>&);

}  // namespace blossom
