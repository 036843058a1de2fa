#pragma once
// Where an instance of something stands: its points are scaled along the axes, then turned about x, y and z in this
// order, then moved. Affine maps commute with every algorithm that blends points, so the control points are mapped and
// the weights stay (The NURBS Book 3.1, 4.2: affine invariance).

#include "geometry/geometry.hpp"

namespace blossom {

struct Placement {
  Point<Exact> scale{Exact(1), Exact(1), Exact(1)};
  Point<Exact> turn{Exact(0), Exact(0), Exact(0)};  // degrees; by multiples of 90 exact
  Point<Exact> move{Exact(0), Exact(0), Exact(0)};

  bool is_identity() const { return *this == Placement{}; }
  bool operator==(const Placement&) const = default;
};

Point<Exact> placed(const Point<Exact>&, const Placement&);
// A plane curve whose placement leaves the plane z = 0 becomes a spatial one.
Curve<Exact> placed(const Curve<Exact>&, const Placement&);
Surface<Exact> placed(const Surface<Exact>&, const Placement&);
PointRow<Exact> placed(const PointRow<Exact>&, const Placement&);
PointNet<Exact> placed(const PointNet<Exact>&, const Placement&);

// The same about another centre than the origin: scaling and turning leave `centre` where it is.
Placement about(const Placement&, const Point<Exact>& centre);

}  // namespace blossom
