#include "geometry/document.hpp"

namespace blossom {
namespace {

std::string json_number(double x) { return format_number(x); }
std::string json_number(const Exact& x) { return "\"" + x.to_string() + "\""; }

// "[a, b, c]" of what `item(i)` says for i = 0..count-1.
template <class Item>
std::string array(std::size_t count, Item&& item) {
  std::string out = "[";
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ", ";
    out += item(i);
  }
  return out + "]";
}

template <Scalar S>
std::string knot_array(const std::vector<S>& U) {
  return array(U.size(), [&](std::size_t i) { return json_number(U[i]); });
}

template <Scalar S>
std::string affine_point(const HPoint<S>& P, int dimension) {
  return array(static_cast<std::size_t>(dimension), [&](std::size_t i) {
    const S& x = i == 0 ? P.x : i == 1 ? P.y : P.z;
    return json_number(P.w == S(0) ? x : S(x / P.w));
  });
}

// A curve without knots in the file has just these; what was derived from a Bezier curve may have others.
template <Scalar S>
bool are_bezier_knots(const std::vector<S>& U, int degree) {
  return U == bezier_knots<S>(degree);
}

}  // namespace

template <Scalar S>
std::string write_curve(const Curve<S>& curve) {
  const auto& P = curve.points;
  std::string out = "{\"degree\": " + std::to_string(curve.degree);
  if (!curve.bezier || !are_bezier_knots(curve.knots, curve.degree)) out += ", \"knots\": " + knot_array(curve.knots);
  out += ", \"points\": " + array(P.size(), [&](std::size_t i) { return affine_point(P[i], curve.dimension); });
  if (curve.rational) out += ", \"weights\": " + array(P.size(), [&](std::size_t i) { return json_number(P[i].w); });
  return out + "}";
}

template <Scalar S>
std::string write_surface(const Surface<S>& surface) {
  const auto net = [&](auto&& item) {
    return array(static_cast<std::size_t>(surface.rows), [&](std::size_t i) {
      return array(static_cast<std::size_t>(surface.columns),
                   [&](std::size_t j) { return item(surface.at(static_cast<int>(i), static_cast<int>(j))); });
    });
  };
  std::string out =
      "{\"degree\": [" + std::to_string(surface.degree[0]) + ", " + std::to_string(surface.degree[1]) + "]";
  if (!surface.bezier || !are_bezier_knots(surface.knots[0], surface.degree[0]) ||
      !are_bezier_knots(surface.knots[1], surface.degree[1])) {
    out += ", \"knots\": [" + knot_array(surface.knots[0]) + ", " + knot_array(surface.knots[1]) + "]";
  }
  out += ", \"points\": " + net([](const HPoint<S>& P) { return affine_point(P, 3); });
  if (surface.rational) out += ", \"weights\": " + net([](const HPoint<S>& P) { return json_number(P.w); });
  return out + "}";
}

template <Scalar S>
std::string write_points(const PointRow<S>& row) {
  return array(row.points.size(), [&](std::size_t i) { return affine_point(row.points[i], row.dimension); });
}

template <Scalar S>
std::string write_net(const PointNet<S>& net) {
  return array(static_cast<std::size_t>(net.rows), [&](std::size_t i) {
    return array(static_cast<std::size_t>(net.columns),
                 [&](std::size_t j) { return affine_point(net.at(static_cast<int>(i), static_cast<int>(j)), 3); });
  });
}

template std::string write_curve(const Curve<double>&);
template std::string write_curve(const Curve<Exact>&);
template std::string write_surface(const Surface<double>&);
template std::string write_surface(const Surface<Exact>&);
template std::string write_points(const PointRow<double>&);
template std::string write_points(const PointRow<Exact>&);
template std::string write_net(const PointNet<double>&);
template std::string write_net(const PointNet<Exact>&);

}  // namespace blossom
