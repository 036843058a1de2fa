#include "studio/edit_curve.hpp"

#include <algorithm>

#include "kernel/degree_elevation.hpp"
#include "studio/edit_parts.hpp"

namespace blossom {

std::string_view curve_kind_name(CurveKind kind) {
  switch (kind) {
    case CurveKind::bezier:
      return "Bézier";
    case CurveKind::rational_bezier:
      return "rational Bézier";
    case CurveKind::bspline:
      return "B-spline";
    case CurveKind::nurbs:
      return "NURBS";
  }
  return {};
}

namespace {

CurveKind kind(bool bezier, bool rational) {
  if (bezier) return rational ? CurveKind::rational_bezier : CurveKind::bezier;
  return rational ? CurveKind::nurbs : CurveKind::bspline;
}

}  // namespace

CurveKind kind_of(const Curve<Exact>& curve) { return kind(curve.bezier, curve.rational); }
CurveKind kind_of(const Surface<Exact>& surface) { return kind(surface.bezier, surface.rational); }

std::string_view curve_form_name(CurveForm form) {
  return form == CurveForm::clamped ? "clamped" : form == CurveForm::open ? "open" : "closed";
}

// With k spans between the ends of the domain, u_{i+k} = u_i + T for all i, and P_{i+k} = P_i.
CurveForm form_of(const Curve<Exact>& curve) {
  const std::vector<Exact>& U = curve.knots;
  const auto p = static_cast<std::size_t>(curve.degree), k = curve.points.size() - p;
  if (U[0] == U[p] && U[k + p] == U.back()) return CurveForm::clamped;
  const Exact period = U[k + p] - U[p];
  for (std::size_t i = 0; i <= 2 * p; ++i)
    if (U[i + k] - U[i] != period) return CurveForm::open;
  for (std::size_t i = 0; i < p; ++i)
    if (curve.points[i + k] != curve.points[i]) return CurveForm::open;
  return CurveForm::closed;
}

std::size_t own_points(const Curve<Exact>& curve) {
  return curve.points.size() - (form_of(curve) == CurveForm::closed ? static_cast<std::size_t>(curve.degree) : 0);
}

Point<Exact> affine(const HPoint<Exact>& P) {
  if (P.w == Exact(0) || P.w == Exact(1)) return {P.x, P.y, P.z};
  return {P.x / P.w, P.y / P.w, P.z / P.w};
}

namespace edit {

using namespace parts;

namespace {

// ---- closed curves: points and knots that repeat for ever, of which the curve holds as much as it needs -------------

struct Ring {
  int degree;
  std::vector<HPoint<Exact>> points;  // k of them
  std::vector<Exact> knots;           // u_p .. u_{p+k-1}
  Exact period;

  explicit Ring(const Curve<Exact>& curve) : degree(curve.degree), period(curve.domain_end() - curve.domain_begin()) {
    const auto k = static_cast<std::ptrdiff_t>(curve.points.size()) - degree;
    points.assign(curve.points.begin(), curve.points.begin() + k);
    knots.assign(curve.knots.begin() + degree, curve.knots.begin() + degree + k);
  }
  // Uniform, from a to b.
  Ring(int p, std::vector<HPoint<Exact>> own, const Exact& a, const Exact& b)
      : degree(p), points(std::move(own)), period(b - a) {
    for (int i = 0; i < count(); ++i) knots.push_back(a + period * Exact::ratio(i, count()));
  }

  int count() const { return static_cast<int>(points.size()); }
  static int modulo(int i, int k) { return (i % k + k) % k; }
  const HPoint<Exact>& point(int i) const { return points[static_cast<std::size_t>(modulo(i, count()))]; }
  Exact knot(int i) const {
    const int k = static_cast<int>(knots.size()), inside = modulo(i - degree, k);
    return knots[static_cast<std::size_t>(inside)] + period * Exact((i - degree - inside) / k);
  }
  void write_to(Curve<Exact>& curve) const {
    const int k = count();
    curve.degree = degree;
    curve.points.clear();
    curve.knots.clear();
    for (int i = 0; i < k + degree; ++i) curve.points.push_back(point(i));
    for (int i = 0; i <= k + 2 * degree; ++i) curve.knots.push_back(knot(i));
  }
};

// Indices count on for ever both ways. A point behind point i and a knot behind u_s, i <= s <= i + p, leave the indices
// up to i and s as they are and shift those behind by one, and so again one period on.
void insert_into(Ring& ring, int behind, const HPoint<Exact>& point) {
  const int p = ring.degree, k = ring.count();
  int i = Ring::modulo(behind, k), s = i;
  for (int j = i; j <= i + p; ++j)
    if (ring.knot(s + 1) - ring.knot(s) < ring.knot(j + 1) - ring.knot(j)) s = j;
  const int turns = Ring::modulo(s - p, k) - (s - p);  // the knot into the domain, and the point along
  s += turns;
  i += turns;
  std::vector<HPoint<Exact>> points(static_cast<std::size_t>(k) + 1);
  const auto place = [&](int j) -> HPoint<Exact>& { return points[static_cast<std::size_t>(Ring::modulo(j, k + 1))]; };
  for (int j = i - k + 1; j <= i; ++j) place(j) = ring.point(j);
  place(i + 1) = point;
  insert_at(ring.knots, static_cast<std::size_t>(s - p) + 1, Exact((ring.knot(s) + ring.knot(s + 1)) / Exact(2)));
  ring.points = std::move(points);
}

// The reverse, with the knot nearest to the mean of the point's p knots; not the one the domain begins with.
void delete_from(Ring& ring, int point) {
  const int p = ring.degree, k = ring.count();
  int i = Ring::modulo(point, k);
  Exact greville(0);
  for (int j = i + 1; j <= i + p; ++j) greville += ring.knot(j);
  greville /= Exact(p);
  std::optional<int> nearest;
  for (int c = i + 1 - k; c <= i + p + k; ++c)
    if (Ring::modulo(c - p, k) != 0 && (!nearest || abs(ring.knot(c) - greville) < abs(ring.knot(*nearest) - greville)))
      nearest = c;
  const int turns = Ring::modulo(*nearest - p, k) - (*nearest - p);
  i += turns;
  std::vector<HPoint<Exact>> points(static_cast<std::size_t>(k) - 1);
  for (int j = i - k + 1; j < i; ++j) points[static_cast<std::size_t>(Ring::modulo(j, k - 1))] = ring.point(j);
  erase_at(ring.knots, static_cast<std::size_t>(*nearest + turns - p));
  ring.points = std::move(points);
}

bool is_closed(const Curve<Exact>& curve) { return form_of(curve) == CurveForm::closed; }

// The point and its twins: its index modulo k.
template <class Change>
void change_point(Curve<Exact>& curve, std::size_t point, Change&& change) {
  const std::size_t k = is_closed(curve) ? own_points(curve) : curve.points.size();
  for (std::size_t i = point % k; i < curve.points.size(); i += k) change(curve.points[i]);
}

std::optional<Diagnostics> no_such_point(const Curve<Exact>& curve, std::size_t point,
                                         std::string_view list = "points") {
  if (point < curve.points.size()) return std::nullopt;
  return refused(at(list, point), "there is no such control point");
}

void drop_weight(HPoint<Exact>& P) {
  const Point<Exact> place = affine(P);
  P = {place.x, place.y, place.z, Exact(1)};
}

void make_bezier(Curve<Exact>& curve) {
  curve.bezier = true;
  curve.degree = curve.n();
  curve.knots = bezier_knots<Exact>(curve.degree);
}

}  // namespace

// ---- points ---------------------------------------------------------------------------------------------------------

EditedCurve move_point(Curve<Exact> curve, std::size_t point, const Point<Exact>& to) {
  if (auto none = no_such_point(curve, point)) return *none;
  const Exact w = curve.points[point].w;
  if (w == Exact(0))
    return refused(at("weights", point), "is 0, so that the point has no place; give it a positive weight first");
  const HPoint<Exact> moved = weighted(to, w, curve.dimension);
  change_point(curve, point, [&](HPoint<Exact>& P) { P = moved; });
  if (is_readable(curve.dimension == 3 ? to : Point<Exact>(to.x, to.y, Exact(0)), w)) return curve;
  return as_read(curve);
}

EditedCurve set_weight(Curve<Exact> curve, std::size_t point, const Exact& weight) {
  if (auto none = no_such_point(curve, point, "weights")) return *none;
  const Point<Exact> place = affine(curve, point);
  const int dimension = curve.dimension;
  change_point(curve, point, [&](HPoint<Exact>& P) { P = weighted(place, weight, dimension); });
  curve.rational = curve.rational || weight != Exact(1);
  return as_read(curve);
}

EditedCurve insert_point(Curve<Exact> curve, std::size_t behind, const Point<Exact>& to) {
  if (behind != SIZE_MAX)
    if (auto none = no_such_point(curve, behind)) return *none;
  const HPoint<Exact> P = weighted(to, Exact(1), curve.dimension);
  if (curve.bezier && curve.degree == max_degree)
    return refused("points", "a Bézier curve has at most " + std::to_string(max_degree + 1) +
                                 " control points (degree " + std::to_string(max_degree) +
                                 "); make it a B-spline curve first");
  if (is_closed(curve)) {
    Ring ring(curve);
    insert_into(ring, behind == SIZE_MAX ? -1 : static_cast<int>(behind), P);
    ring.write_to(curve);
    return as_read(curve);
  }
  if (curve.bezier) {
    ++curve.degree;
    curve.knots = bezier_knots<Exact>(curve.degree);
  } else {
    add_knot(curve.knots, curve.degree, curve.points.size(), behind);
  }
  insert_at(curve.points, behind + 1, P);
  return as_read(curve);
}

EditedCurve delete_point(Curve<Exact> curve, std::size_t point) {
  if (auto none = no_such_point(curve, point)) return *none;
  const std::string place = at("points", point), p = std::to_string(curve.degree);
  if (is_closed(curve)) {
    if (own_points(curve) <= 3) return refused(place, "a closed curve has at least 3 control points");
    Ring ring(curve);
    delete_from(ring, static_cast<int>(point));
    ring.write_to(curve);
    return as_read(curve);
  }
  if (curve.bezier && curve.degree == 1) return refused(place, "a curve has at least 2 control points");
  if (!curve.bezier && curve.n() == curve.degree)
    return refused(place, "a curve of degree " + p + " has at least " + std::to_string(curve.degree + 1) +
                              " control points; lower the degree first");
  if (curve.bezier) {
    --curve.degree;
    curve.knots = bezier_knots<Exact>(curve.degree);
  } else {
    erase_at(curve.knots, knot_near(curve.knots, curve.degree, curve.points.size(), point));
  }
  erase_at(curve.points, point);
  return as_read(curve);
}

// ---- knots ----------------------------------------------------------------------------------------------------------

namespace {

// The knots of the same place one period on move along, and those of the domain's ends together.
std::optional<Diagnostic> change_ring_knots(Curve<Exact>& curve, std::size_t index, const Exact& value,
                                            bool equal_ones) {
  std::vector<Exact>& U = curve.knots;
  const std::vector<Exact> before = U;
  const int k = curve.n() + 1 - curve.degree;
  const Exact by = value - before[index];
  std::vector<bool> moves(static_cast<std::size_t>(k));
  for (int i = 0; i < static_cast<int>(U.size()); ++i)
    if (i == static_cast<int>(index) || (equal_ones && before[static_cast<std::size_t>(i)] == before[index]))
      moves[static_cast<std::size_t>(i % k)] = true;
  for (std::size_t i = 0; i < U.size(); ++i)
    if (moves[i % static_cast<std::size_t>(k)]) U[i] += by;
  if (std::is_sorted(U.begin(), U.end())) return std::nullopt;
  std::vector<Exact> alone = before;
  if (auto wrong = change_knots(alone, index, value, equal_ones, "knots")) return wrong;
  return wrong(at("knots", index), "knots must not decrease: those that move along with it would pass others");
}

EditedCurve change_knots_of(Curve<Exact> curve, std::size_t index, const Exact& value, bool equal_ones) {
  const bool ring = index < curve.knots.size() && is_closed(curve);
  if (auto wrong = ring ? change_ring_knots(curve, index, value, equal_ones)
                        : change_knots(curve.knots, index, value, equal_ones, "knots"))
    return Diagnostics{*std::move(wrong)};
  return as_read(curve);
}

}  // namespace

EditedCurve set_knot(Curve<Exact> curve, std::size_t index, const Exact& value) {
  return change_knots_of(std::move(curve), index, value, false);
}

EditedCurve set_equal_knots(Curve<Exact> curve, std::size_t index, const Exact& value) {
  return change_knots_of(std::move(curve), index, value, true);
}

EditedCurve set_knots(Curve<Exact> curve, std::vector<Exact> knots) {
  curve.knots = std::move(knots);
  curve.bezier = false;
  return as_read(curve);
}

// ---- degree, kind, form ---------------------------------------------------------------------------------------------

EditedCurve set_degree(Curve<Exact> curve, int degree) {
  const CurveForm form = form_of(curve);
  const int points = static_cast<int>(own_points(curve));
  const int most = curve.bezier ? max_degree : std::min(max_degree, std::max(points - 1, curve.degree));
  if (degree < 1 || degree > most)
    return refused("degree", "must be from 1 to " + std::to_string(most) +
                                 (most < max_degree ? " (" + std::to_string(points) + " control points)" : "") +
                                 ", not " + std::to_string(degree));
  if (degree == curve.degree) return curve;
  const Exact a = curve.domain_begin(), b = curve.domain_end();
  if (curve.bezier && degree > curve.degree) {
    NoRecorder<Exact> nobody;
    curve = degree_elevation(curve, degree - curve.degree, nobody);
  } else if (curve.bezier) {
    curve.points.resize(static_cast<std::size_t>(degree) + 1);
    make_bezier(curve);
  } else if (form == CurveForm::closed) {
    Ring(degree, Ring(curve).points, a, b).write_to(curve);
  } else {
    curve.degree = degree;
    curve.knots = form == CurveForm::open ? unclamped_uniform_knots(a, b, degree, curve.points.size())
                                          : clamped_uniform_knots(a, b, degree, curve.points.size());
  }
  return as_read(curve);
}

namespace {

// Without the points that are there again, as long as there are enough.
void drop_twins(Curve<Exact>& curve) {
  curve.points.resize(std::max(own_points(curve), static_cast<std::size_t>(curve.degree) + 1));
}

}  // namespace

EditedCurve set_kind(Curve<Exact> curve, CurveKind kind) {
  const bool bezier = kind == CurveKind::bezier || kind == CurveKind::rational_bezier;
  const bool rational = kind == CurveKind::rational_bezier || kind == CurveKind::nurbs;
  if (bezier && !curve.bezier) {
    drop_twins(curve);
    if (curve.n() > max_degree)
      return refused("points", "a Bézier curve has at most " + std::to_string(max_degree + 1) +
                                   " control points (degree " + std::to_string(max_degree) + "), not " +
                                   std::to_string(curve.points.size()));
    make_bezier(curve);
  }
  curve.bezier = bezier;
  if (curve.rational && !rational) std::ranges::for_each(curve.points, drop_weight);
  curve.rational = rational;
  return as_read(curve);
}

EditedCurve set_form(Curve<Exact> curve, CurveForm form) {
  const CurveForm before = form_of(curve);
  if (before == form) return curve;
  const Exact a = curve.domain_begin(), b = curve.domain_end();
  if (before == CurveForm::closed) drop_twins(curve);
  curve.bezier = false;
  if (form == CurveForm::closed) {
    if (curve.points.size() < 3) return refused("points", "a closed curve has at least 3 control points");
    Ring(curve.degree, curve.points, a, b).write_to(curve);
  } else {
    curve.knots = form == CurveForm::open ? unclamped_uniform_knots(a, b, curve.degree, curve.points.size())
                                          : clamped_uniform_knots(a, b, curve.degree, curve.points.size());
  }
  return as_read(curve);
}

EditedCurve set_dimension(Curve<Exact> curve, int dimension) {
  if (dimension != 2 && dimension != 3)
    return refused("points", "a point must have 2 or 3 coordinates, not " + std::to_string(dimension));
  curve.dimension = dimension;
  if (dimension == 2)
    for (HPoint<Exact>& P : curve.points) P.z = Exact(0);
  return as_read(curve);
}

}  // namespace edit
}  // namespace blossom
