#pragma once
// A rational plane curve and the polynomial curve in space whose shadow it is (The NURBS Book 1.4 and 4.2): the plane
// is that of the points (x, y, 1), and the control point (x, y) of weight w becomes the point (w x, w y, w) of space.
// Seen from the origin, the curve in space covers the plane one.

#include "geometry/geometry.hpp"

namespace blossom {

// (x, y) as the point (x, y, 1) of space. Precondition: its weight is not 0.
template <Scalar S>
HPoint<S> at_height_one(const HPoint<S>& P) {
  return {P.x / P.w, P.y / P.w, S(1), S(1)};
}

// The plane curve at height 1.
template <Scalar S>
Curve<S> at_height_one(Curve<S> curve) {
  for (auto& P : curve.points) P.z = P.w;
  curve.dimension = 3;
  return curve;
}

// The curve in space above it.
template <Scalar S>
Curve<S> lifted(Curve<S> curve) {
  for (auto& P : curve.points) P = {P.x, P.y, P.w, S(1)};
  curve.dimension = 3;
  curve.rational = false;
  return curve;
}

}  // namespace blossom
