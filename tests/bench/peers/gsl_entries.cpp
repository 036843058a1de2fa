// GSL: the basis functions that are not zero (gsl_bspline_eval_nonzero), which the caller combines with the points. It
// has no rational curves, no surfaces and none of the algorithms.

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_vector.h>

#include <memory>

#include "comparison.hpp"

namespace {

using peers::CurveRow;
using peers::work;

struct Workspace {
  std::shared_ptr<gsl_bspline_workspace> basis;
  std::shared_ptr<gsl_vector> values;
  std::vector<std::array<double, 3>> points;

  explicit Workspace(const peers::Curve<double>& curve) {
    auto breaks = curve.knots;  // clamped, and no inner knot twice
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    const std::size_t order = static_cast<std::size_t>(curve.degree) + 1;
    basis.reset(gsl_bspline_alloc(order, breaks.size()), gsl_bspline_free);
    values.reset(gsl_vector_alloc(order), gsl_vector_free);
    const auto view = gsl_vector_const_view_array(breaks.data(), breaks.size());
    gsl_bspline_knots(&view.vector, basis.get());
    for (const auto& P : curve.points) points.push_back({P.x, P.y, P.z});
  }
};

void add_points(const CurveRow& row) {
  peers::add_jobs<3>(row.name, "GSL", [&u = row.u, at = Workspace(row.curve)](std::size_t i, auto& out) {
    std::size_t first, last;
    gsl_bspline_eval_nonzero(u[i], at.values.get(), &first, &last, at.basis.get());
    out = {};
    for (std::size_t j = first; j <= last; ++j) {
      const double N = at.values->data[j - first];
      for (std::size_t c = 0; c < 3; ++c) out[c] += N * at.points[j][c];
    }
  });
}

void add_all() {
  for (const CurveRow& row : work().points) {
    if (!row.curve.rational) add_points(row);
  }
  add_points(work().bezier);
}

[[maybe_unused]] const bool added = (add_all(), true);

}  // namespace
