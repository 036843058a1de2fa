#pragma once
// Clamping (The NURBS Book, 12.2): the same curve with the ends of its domain as knots of multiplicity p + 1, so that
// it begins and ends in a control point. Each end is inserted until it has multiplicity p (Boehm, see
// knot_insertion.hpp); then the knots and points that the domain does not see are left out, and the end knot is written
// once more.
//
// A closed curve with periodic knots becomes one whose first and last control points coincide.

#include "kernel/compatible.hpp"

namespace blossom {

// A curve that an algorithm goes on with, and its knot vector as one value.
template <class R>
struct KnownCurve {
  MadeCurve<R> curve;
  Traced<std::vector<typename R::Number>, typename R::Id> knots;
};

template <class R, class CurveIn, class KnotList>
KnownCurve<R> known_curve(const CurveIn& given, const KnotList& knots) {
  KnownCurve<R> known;
  known.curve.degree = given.degree;
  known.curve.dimension = given.dimension;
  known.curve.rational = given.rational;
  known.curve.U.append(given.U, 0, given.U.size());
  known.curve.P.append(given.P, 0, given.P.size());
  known.knots = {{knots.value.begin(), knots.value.end()}, knots.id};
  return known;
}

// The same curve, clamped in a phase of its own where it is not yet.
template <class R, class CurveIn, class KnotList>
KnownCurve<R> clamped(R& rec, const CurveIn& given, const KnotList& knots) {
  auto known = known_curve<R>(given, knots);
  if (compatible::is_clamped<R>(known.curve)) return known;
  auto phase = rec.phase({"clamp"});
  known.curve = compatible::clamp(rec, std::move(known.curve));
  known.knots = rec.apply(Gather{}, "W"_v, slice(known.curve.U, 0, known.curve.U.size()));
  return known;
}

// A made curve as a plain value, of which every point may have been made.
template <class R>
Curve<typename R::Number> plain_curve(MadeCurve<R>&& made) {
  const int count = made.P.size();
  return plain_curve<R>(std::move(made), 0, count);
}

// The points of a result under their own names, all in one step.
template <class R, class Points>
void name_points(R& rec, const NameMaker& symbol, const Points& points) {
  if constexpr (R::recording) {
    auto step = rec.one_step();
    for (int i = 0; i < points.size(); ++i) rec.apply(Same{}, symbol(i), points[i]);
  }
}

// The whole algorithm on a curve.
template <class R>
Curve<typename R::Number> clamping(const Curve<typename R::Number>& curve, R& rec) {
  const auto list = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  auto made = clamped(rec, given, list).curve;
  {
    auto phase = rec.phase({"collect"});
    name_points(rec, "Q"_v, made.P);
  }
  auto result = plain_curve<R>(std::move(made));
  result.bezier = curve.bezier;
  return result;
}

}  // namespace blossom
