#pragma once
// Edits of one curve or surface: pure functions from geometry to new geometry, or to what is wrong. What is valid is
// decided by the readers of files: no edit makes geometry that a file could not have. Paths of diagnostics begin at the
// geometry ("knots[4]", "points[0]", "degree").

#include "base/diagnostics.hpp"
#include "geometry/geometry.hpp"

namespace blossom {

enum class CurveKind { bezier, rational_bezier, bspline, nurbs };
std::string_view curve_kind_name(CurveKind);  // "Bézier", "rational Bézier", "B-spline", "NURBS"
CurveKind kind_of(const Curve<Exact>&);
CurveKind kind_of(const Surface<Exact>&);

// How the ends are: clamped, open (uniform knots: "unclamped"), closed (periodic: the last p points are the first p,
// the knots repeat).
enum class CurveForm { clamped, open, closed };
std::string_view curve_form_name(CurveForm);
CurveForm form_of(const Curve<Exact>&);
// How many of its control points are not repeated ones: of a closed curve all but the last p.
std::size_t own_points(const Curve<Exact>&);

// The place of a point as people type it, not multiplied with its weight (in 2D the third is 0).
Point<Exact> affine(const HPoint<Exact>&);
inline Point<Exact> affine(const Curve<Exact>& curve, std::size_t point) { return affine(curve.points[point]); }

namespace edit {

using EditedCurve = Checked<Curve<Exact>>;
using EditedSurface = Checked<Surface<Exact>>;

// What is done to a closed curve is done all around: it stays closed, but for set_kind to a Bezier curve, set_knots and
// set_form.

// A point of weight 0 has no place and cannot be moved. In a closed curve the point's twin moves along.
EditedCurve move_point(Curve<Exact>, std::size_t point, const Point<Exact>& to);
// A polynomial curve becomes rational by its first weight that is not 1. A point that gets weight 0 loses its place.
EditedCurve set_weight(Curve<Exact>, std::size_t point, const Exact& weight);
// Behind the point (SIZE_MAX: before the first), with weight 1. A curve with knots keeps its degree (a knot is added in
// the middle of the longest span near the point), a Bezier curve gets one degree more.
EditedCurve insert_point(Curve<Exact>, std::size_t behind, const Point<Exact>& at);
// With the inner knot nearest the point; a Bezier curve gets one degree less. A closed curve keeps at least 3 points.
EditedCurve delete_point(Curve<Exact>, std::size_t point);
// Knots stay in order: a value beyond a neighbour is refused at the knot itself. Equal ones: all that equal the one of
// this index. In a closed curve the knots one period away move along.
EditedCurve set_knot(Curve<Exact>, std::size_t index, const Exact& value);
EditedCurve set_equal_knots(Curve<Exact>, std::size_t index, const Exact& value);
EditedCurve set_knots(Curve<Exact>, std::vector<Exact> knots);  // all of them, typed
// The degree, with the same control points: uniform knots of the same form over the same domain (a Bezier curve: points
// are added by degree elevation, or the last ones left out).
EditedCurve set_degree(Curve<Exact>, int degree);
// To polynomial: weights are dropped, points keep their places. To Bezier: the degree becomes n (25 at most, or it is a
// diagnostic). To B-spline: the Bezier knots, written out.
EditedCurve set_kind(Curve<Exact>, CurveKind);
// Keeping the points, with uniform knots over the same domain. To closed: the first p again behind the last; from
// closed: those go, as long as p + 1 points are left.
EditedCurve set_form(Curve<Exact>, CurveForm);
EditedCurve set_dimension(Curve<Exact>, int dimension);  // to 2: z is dropped

// direction 0: u, 1: v
EditedSurface move_point(Surface<Exact>, int i, int j, const Point<Exact>& to);
EditedSurface set_weight(Surface<Exact>, int i, int j, const Exact& weight);
EditedSurface set_knot(Surface<Exact>, int direction, std::size_t index, const Exact& value);
EditedSurface set_equal_knots(Surface<Exact>, int direction, std::size_t index, const Exact& value);
EditedSurface set_knots(Surface<Exact>, int direction, std::vector<Exact> knots);
EditedSurface set_degree(Surface<Exact>, int direction, int degree);
EditedSurface set_kind(Surface<Exact>, CurveKind);
// A row (direction 0) halfway between `behind` and the next; a row less. As with a curve's points.
EditedSurface insert_row(Surface<Exact>, int direction, int behind);
EditedSurface delete_row(Surface<Exact>, int direction, int row);

}  // namespace edit

// A flat net in the xy-plane, of uniform clamped knots, centred: what a new surface begins with.
Surface<Exact> planar_surface(int rows, int columns, int degree_u, int degree_v, const Exact& size);

}  // namespace blossom
