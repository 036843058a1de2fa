// Edits of one curve among the inputs, and of how many there are.

#include <algorithm>
#include <cmath>

#include "player/edit_parts.hpp"

namespace blossom {

using namespace edits;

// ---- one curve ------------------------------------------------------------------------------------------------------

Edited move_point(const Algorithm& algorithm, const Inputs<Exact>& inputs, const PointAddress& address,
                  const Point<Exact>& to) {
  // Where a point lies leaves every other input as fit as it was.
  return change_curve(algorithm, inputs, {address.input, address.curve}, Others::stay,
                      [&](Curve<Exact> curve) { return edit::move_point(std::move(curve), address.point, to); });
}

Edited set_weight(const Algorithm& algorithm, const Inputs<Exact>& inputs, const PointAddress& address,
                  const Exact& weight) {
  return change_curve(algorithm, inputs, {address.input, address.curve}, Others::fit,
                      [&](Curve<Exact> curve) { return edit::set_weight(std::move(curve), address.point, weight); });
}

Edited insert_point(const Algorithm& algorithm, const Inputs<Exact>& inputs, const PointAddress& behind,
                    const Point<Exact>& at) {
  return change_curve(algorithm, inputs, {behind.input, behind.curve}, Others::fit,
                      [&](Curve<Exact> curve) { return edit::insert_point(std::move(curve), behind.point, at); });
}

Edited delete_point(const Algorithm& algorithm, const Inputs<Exact>& inputs, const PointAddress& address) {
  return change_curve(algorithm, inputs, {address.input, address.curve}, Others::fit,
                      [&](Curve<Exact> curve) { return edit::delete_point(std::move(curve), address.point); });
}

Edited set_knot(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address, std::size_t index,
                const Exact& value) {
  return change_curve(algorithm, inputs, address, Others::fit,
                      [&](Curve<Exact> curve) { return edit::set_knot(std::move(curve), index, value); });
}

Edited set_equal_knots(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address,
                       std::size_t index, const Exact& value) {
  return change_curve(algorithm, inputs, address, Others::fit,
                      [&](Curve<Exact> curve) { return edit::set_equal_knots(std::move(curve), index, value); });
}

Edited set_degree(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address, int degree) {
  return change_curve(algorithm, inputs, address, Others::fit,
                      [&](Curve<Exact> curve) { return edit::set_degree(std::move(curve), degree); });
}

Edited set_kind(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address, CurveKind kind) {
  return change_curve(algorithm, inputs, address, Others::fit,
                      [&](Curve<Exact> curve) { return edit::set_kind(std::move(curve), kind); });
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
    curves.insert(curves.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::move(copy));
  });
}

Edited delete_curve(const Algorithm& algorithm, const Inputs<Exact>& inputs, const CurveAddress& address) {
  return change_curves(algorithm, inputs, address, [](auto& curves, std::size_t at) {
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(at));
  });
}

}  // namespace blossom
