#pragma once
// Random curves and surfaces with short rational numbers, for tests that hold for any: made in exact arithmetic, and
// rounded to double where a test needs both.

#include <random>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"

namespace blossom::test {

inline Exact random_ratio(std::mt19937& random, int from, int to, int denominator) {
  return Exact::ratio(std::uniform_int_distribution<int>(from * denominator, to * denominator)(random), denominator);
}

inline int random_int(std::mt19937& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}

// Knots for at least p + 1 control points: `spans` nonempty spans in the domain, interior multiplicities 1..highest,
// and either clamped ends or p single knots beyond each end.
inline std::vector<Exact> random_knots(std::mt19937& random, int p, int spans, int highest, bool clamped) {
  Exact u = random_ratio(random, -2, 2, 2);
  std::vector<Exact> U;
  const auto advance = [&] { u += random_ratio(random, 0, 2, 4) + Exact::ratio(1, 4); };
  for (int i = 0; i <= p; ++i) {
    if (!clamped && i > 0) advance();
    U.push_back(u);
  }
  for (int i = 1; i < spans; ++i) {
    advance();
    const int times = random_int(random, 1, highest);
    U.insert(U.end(), static_cast<std::size_t>(times), u);
  }
  for (int i = 0; i <= p; ++i) {
    if (!clamped || i == 0) advance();
    U.push_back(u);
  }
  return U;
}

inline HPoint<Exact> random_point(std::mt19937& random, bool rational) {
  const Exact w = rational ? random_ratio(random, 0, 3, 2) + Exact::ratio(1, 4) : Exact(1);
  const auto coordinate = [&] { return w * random_ratio(random, -5, 5, 3); };
  const Exact x = coordinate();
  const Exact y = coordinate();
  return {x, y, coordinate(), w};
}

inline Curve<Exact> random_curve(std::mt19937& random, int p, int spans, int highest, bool clamped, bool rational) {
  Curve<Exact> curve;
  curve.degree = p;
  curve.dimension = 3;
  curve.rational = rational;
  curve.knots = random_knots(random, p, spans, highest, clamped);
  for (std::size_t i = 0; i + static_cast<std::size_t>(p) + 1 < curve.knots.size(); ++i) {
    curve.points.push_back(random_point(random, rational));
  }
  return curve;
}

inline Surface<Exact> random_surface(std::mt19937& random, int p, int q, int spans, bool clamped, bool rational) {
  Surface<Exact> surface;
  surface.degree = {p, q};
  surface.knots = {random_knots(random, p, spans, p, clamped), random_knots(random, q, spans, q, clamped)};
  surface.rows = static_cast<int>(surface.knots[0].size()) - p - 1;
  surface.columns = static_cast<int>(surface.knots[1].size()) - q - 1;
  surface.rational = rational;
  for (int i = 0; i < surface.rows * surface.columns; ++i) surface.points.push_back(random_point(random, rational));
  return surface;
}

inline std::vector<double> rounded(const std::vector<Exact>& values) {
  std::vector<double> result;
  for (const Exact& value : values) result.push_back(value.to_double());
  return result;
}

inline HPoint<double> rounded(const HPoint<Exact>& P) {
  return {P.x.to_double(), P.y.to_double(), P.z.to_double(), P.w.to_double()};
}
inline Point<double> rounded(const Point<Exact>& P) { return {P.x.to_double(), P.y.to_double(), P.z.to_double()}; }

inline std::vector<HPoint<double>> rounded(const std::vector<HPoint<Exact>>& points) {
  std::vector<HPoint<double>> result;
  for (const auto& P : points) result.push_back(rounded(P));
  return result;
}

inline Curve<double> rounded(const Curve<Exact>& curve) {
  return {curve.degree, rounded(curve.knots), rounded(curve.points), curve.dimension, curve.rational, curve.bezier};
}

inline Surface<double> rounded(const Surface<Exact>& surface) {
  return {surface.degree,
          {rounded(surface.knots[0]), rounded(surface.knots[1])},
          surface.rows,
          surface.columns,
          rounded(surface.points),
          surface.rational,
          surface.bezier};
}

// A parameter of the domain [u_p, u_{n+1}], in sixteenths of the way.
inline Exact random_parameter(std::mt19937& random, const std::vector<Exact>& U, int p) {
  const Exact& begin = U[static_cast<std::size_t>(p)];
  const Exact& end = U[U.size() - static_cast<std::size_t>(p) - 1];
  return begin + (end - begin) * random_ratio(random, 0, 1, 16);
}

template <class Vector>
double distance(const Vector& a, const Vector& b) {
  double largest = 0;
  for (int i = 0; i < Vector::length(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

inline Exact q(const std::string& text) { return *Exact::parse(text); }  // q("2/5")

// A curve in the plane, of affine points and their weights.
struct PlanePoint {
  Exact x, y, w = 1;
};
inline Curve<Exact> plane_curve(int p, std::vector<Exact> knots, const std::vector<PlanePoint>& points) {
  Curve<Exact> curve;
  curve.degree = p;
  curve.knots = std::move(knots);
  for (const auto& [x, y, w] : points) {
    curve.points.push_back({x * w, y * w, Exact(0), w});
    if (w != Exact(1)) curve.rational = true;
  }
  return curve;
}

}  // namespace blossom::test
