// Edits that change how many points, knots or curves there are, or what the knots are.

#include <algorithm>
#include <cmath>

#include "kernel/degree_elevation.hpp"
#include "player/edit_parts.hpp"

namespace blossom {

using namespace edits;

namespace {

using Problem = std::optional<Diagnostic>;

std::string text(std::size_t number) { return std::to_string(number); }

// ---- which knot goes with a point -----------------------------------------------------------------------------------

// The longest span of the domain in u_first..u_last; of the whole domain if there is none. Its end is at index + 1.
std::size_t longest_span(const Curve<Exact>& curve, std::size_t first, std::size_t last) {
  const std::vector<Exact>& U = curve.knots;
  const std::size_t begin = static_cast<std::size_t>(curve.degree), end = curve.points.size();
  const auto longest = [&](std::size_t from, std::size_t to) {
    std::size_t best = from;
    for (std::size_t i = from; i < to; ++i)
      if (U[best + 1] - U[best] < U[i + 1] - U[i]) best = i;
    return best;
  };
  const std::size_t from = std::max(first, begin), to = std::min(last, end);
  if (from < to)
    if (const std::size_t best = longest(from, to); U[best] < U[best + 1]) return best;
  return longest(begin, end);
}

// The inner knot nearest to where the point has most influence: the mean of its p knots (Greville).
std::size_t knot_near(const Curve<Exact>& curve, std::size_t point) {
  const std::size_t p = static_cast<std::size_t>(curve.degree);
  Exact place = 0;
  for (std::size_t i = point + 1; i <= point + p; ++i) place += curve.knots[i];
  place /= Exact(curve.degree);
  std::size_t best = p + 1;
  for (std::size_t i = p + 1; i < curve.points.size(); ++i)
    if (abs(curve.knots[i] - place) < abs(curve.knots[best] - place)) best = i;
  return best;
}

template <class T>
void insert_at(std::vector<T>& list, std::size_t index, T item) {
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(index), std::move(item));
}
template <class T>
void erase_at(std::vector<T>& list, std::size_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace

Edited insert_point(const Algorithm& algorithm, const Inputs<Exact>& inputs, const PointAddress& behind,
                    const Point<Exact>& at) {
  return change_curve(
      algorithm, inputs, {behind.input, behind.curve}, [&](Curve<Exact>& curve, const std::string& path) -> Problem {
        const std::size_t i = behind.point, p = static_cast<std::size_t>(curve.degree);
        if (i >= curve.points.size()) return wrong(path + ".points[" + text(i) + "]", "there is no such control point");
        if (curve.bezier && curve.degree == max_degree)
          return wrong(path + ".points", "a Bézier curve has at most " + text(p + 1) + " control points (degree " +
                                             text(p) + "); make it a B-spline curve first");
        if (curve.bezier) {
          ++curve.degree;
          curve.knots = bezier_knots<Exact>(curve.degree);
        } else {
          const std::size_t span = longest_span(curve, i, i + p + 2);
          insert_at(curve.knots, span + 1, (curve.knots[span] + curve.knots[span + 1]) / Exact(2));
        }
        insert_at(curve.points, i + 1, HPoint<Exact>(at.x, at.y, curve.dimension == 3 ? at.z : Exact(0), Exact(1)));
        return std::nullopt;
      });
}

Edited delete_point(const Algorithm& algorithm, const Inputs<Exact>& inputs, const PointAddress& address) {
  return change_curve(
      algorithm, inputs, {address.input, address.curve}, [&](Curve<Exact>& curve, const std::string& path) -> Problem {
        const std::size_t i = address.point, p = static_cast<std::size_t>(curve.degree);
        if (i >= curve.points.size()) return wrong(path + ".points[" + text(i) + "]", "there is no such control point");
        if (curve.bezier && p == 1)
          return wrong(path + ".points[" + text(i) + "]", "a curve has at least 2 control points");
        if (!curve.bezier && curve.points.size() == p + 1)
          return wrong(path + ".points[" + text(i) + "]", "a curve of degree " + text(p) + " has at least " +
                                                              text(p + 1) + " control points; lower the degree first");
        if (curve.bezier) {
          --curve.degree;
          curve.knots = bezier_knots<Exact>(curve.degree);
        } else {
          erase_at(curve.knots, knot_near(curve, i));
        }
        erase_at(curve.points, i);
        return std::nullopt;
      });
}

// ---- knots ----------------------------------------------------------------------------------------------------------

namespace {

// The knots of [first, last] become `value`; `index` is the one that was meant.
Problem set_knots(Curve<Exact>& curve, const std::string& path, std::size_t first, std::size_t last, std::size_t index,
                  const Exact& value) {
  std::vector<Exact>& U = curve.knots;
  const std::string place = path + ".knots[" + text(index) + "]";
  const auto named = [&](std::size_t i) { return "u_" + text(i) + " = " + format_brief(U[i]); };
  if (first > 0 && value < U[first - 1])
    return wrong(place,
                 "knots must not decrease: it must be at least " + named(first - 1) + ", not " + format_brief(value));
  if (last + 1 < U.size() && U[last + 1] < value)
    return wrong(place,
                 "knots must not decrease: it must be at most " + named(last + 1) + ", not " + format_brief(value));
  std::fill(U.begin() + static_cast<std::ptrdiff_t>(first), U.begin() + static_cast<std::ptrdiff_t>(last) + 1, value);
  return std::nullopt;
}

Edited change_knots(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address,
                    std::size_t index, const Exact& value, bool equal_ones) {
  return change_curve(algorithm, inputs, address, [&](Curve<Exact>& curve, const std::string& path) -> Problem {
    const std::vector<Exact>& U = curve.knots;
    if (index >= U.size()) return wrong(path + ".knots[" + text(index) + "]", "there is no such knot");
    std::size_t first = index, last = index;
    while (equal_ones && first > 0 && U[first - 1] == U[index]) --first;
    while (equal_ones && last + 1 < U.size() && U[last + 1] == U[index]) ++last;
    return set_knots(curve, path, first, last, index, value);
  });
}

}  // namespace

Edited set_knot(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address, std::size_t index,
                const Exact& value) {
  return change_knots(algorithm, inputs, address, index, value, false);
}
Edited set_equal_knots(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address,
                       std::size_t index, const Exact& value) {
  return change_knots(algorithm, inputs, address, index, value, true);
}

// ---- degree and kind ------------------------------------------------------------------------------------------------

namespace {

std::vector<Exact> clamped_uniform_knots(const Exact& a, const Exact& b, std::size_t degree, std::size_t points) {
  std::vector<Exact> knots(degree + 1, a);
  const std::size_t spans = points - degree;
  for (std::size_t i = 1; i < spans; ++i)
    knots.push_back(a + (b - a) * Exact::ratio(static_cast<std::int64_t>(i), static_cast<std::int64_t>(spans)));
  knots.insert(knots.end(), degree + 1, b);
  return knots;
}

// Its degree becomes n.
void make_bezier(Curve<Exact>& curve) {
  curve.bezier = true;
  curve.degree = curve.n();
  curve.knots = bezier_knots<Exact>(curve.degree);
}

void make_polynomial(Curve<Exact>& curve) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point<Exact> P = affine(curve, i);
    curve.points[i] = {P.x, P.y, P.z, Exact(1)};
  }
  curve.rational = false;
}

}  // namespace

Edited set_degree(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address, int degree) {
  return change_curve(algorithm, inputs, address, [&](Curve<Exact>& curve, const std::string& path) -> Problem {
    const int most = curve.bezier ? max_degree : std::min(max_degree, curve.n());
    if (degree < 1 || degree > most)
      return wrong(path + ".degree",
                   "must be from 1 to " + std::to_string(most) +
                       (most < max_degree ? " (" + text(curve.points.size()) + " control points)" : std::string()) +
                       ", not " + std::to_string(degree));
    if (degree == curve.degree) return std::nullopt;
    if (!curve.bezier) {
      const Exact a = curve.domain_begin(), b = curve.domain_end();
      curve.degree = degree;
      curve.knots = clamped_uniform_knots(a, b, static_cast<std::size_t>(degree), curve.points.size());
    } else if (degree < curve.degree) {
      curve.points.resize(static_cast<std::size_t>(degree) + 1);
      make_bezier(curve);
    } else {
      NoRecorder<Exact> nobody;
      curve = degree_elevation(curve, degree - curve.degree, nobody);
    }
    return std::nullopt;
  });
}

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

CurveKind kind_of(const Curve<Exact>& curve) {
  if (curve.bezier) return curve.rational ? CurveKind::rational_bezier : CurveKind::bezier;
  return curve.rational ? CurveKind::nurbs : CurveKind::bspline;
}

Edited set_kind(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address, CurveKind kind) {
  return change_curve(algorithm, inputs, address, [&](Curve<Exact>& curve, const std::string& path) -> Problem {
    const bool bezier = kind == CurveKind::bezier || kind == CurveKind::rational_bezier;
    const bool rational = kind == CurveKind::rational_bezier || kind == CurveKind::nurbs;
    if (bezier && curve.n() > max_degree)
      return wrong(path + ".points", "a Bézier curve has at most " + text(max_degree + 1) + " control points (degree " +
                                         text(max_degree) + "), not " + text(curve.points.size()));
    if (bezier && !curve.bezier) make_bezier(curve);
    curve.bezier = bezier;
    if (curve.rational && !rational) make_polynomial(curve);
    curve.rational = rational;
    return std::nullopt;
  });
}

// ---- curves ---------------------------------------------------------------------------------------------------------

namespace {

Point<double> centre(const Curve<Exact>& curve) {
  Point<double> sum(0, 0, 0);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point<Exact> P = affine(curve, i);
    sum += Point<double>(P.x.to_double(), P.y.to_double(), P.z.to_double()) / static_cast<double>(curve.points.size());
  }
  return sum;
}

// How far a curve put in behind `at` lies from that one: halfway to the next, or, behind the last, as far as that one
// from the one before. In round numbers, and not nothing.
Point<Exact> shift_behind(const std::vector<Curve<Exact>>& curves, std::size_t at) {
  Point<double> shift(0, 0, 0);
  if (at + 1 < curves.size())
    shift = (centre(curves[at + 1]) - centre(curves[at])) * 0.5;
  else if (at > 0)
    shift = centre(curves[at]) - centre(curves[at - 1]);
  const double size = std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)});
  if (!(size > 1e-6) || !std::isfinite(shift.x + shift.y + shift.z))
    return curves[at].dimension == 3 ? Point<Exact>(0, 0, 1) : Point<Exact>(0, 1, 0);
  const double unit = size / 50;
  return {snapped(shift.x, unit), snapped(shift.y, unit), snapped(shift.z, unit)};
}

Edited change_curves(const Algorithm& algorithm, Inputs<Exact> inputs, const CurveAddress& address,
                     void (*change)(std::vector<Curve<Exact>>&, std::size_t)) {
  const auto found = inputs.values.find(address.input);
  auto* curves = found == inputs.values.end() ? nullptr : std::get_if<std::vector<Curve<Exact>>>(&found->second);
  if (curves == nullptr) return refused(address.input, "is one curve, not a list of them");
  if (address.curve >= curves->size()) return refused(path_of(inputs, address), "there is no such curve");
  change(*curves, address.curve);
  return checked_and_fitted(algorithm, std::move(inputs), address.input);
}

}  // namespace

Edited add_curve(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& behind) {
  return change_curves(algorithm, inputs, behind, [](std::vector<Curve<Exact>>& curves, std::size_t at) {
    const Point<Exact> shift = shift_behind(curves, at);
    Curve<Exact> copy = curves[at];
    for (HPoint<Exact>& P : copy.points) P += HPoint<Exact>(shift.x * P.w, shift.y * P.w, shift.z * P.w, Exact(0));
    insert_at(curves, at + 1, std::move(copy));
  });
}

Edited delete_curve(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address) {
  return change_curves(algorithm, inputs, address, [](auto& curves, std::size_t at) { erase_at(curves, at); });
}

}  // namespace blossom
