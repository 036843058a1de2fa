#include <algorithm>
#include <cmath>

#include "kernel/frame.hpp"
#include "kernel/tessellate.hpp"
#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"
#include "scene/workspace_view.hpp"

namespace blossom {
namespace {

using parts::Box;

constexpr double title_room = 17, gap = 10, least_height = 46;
constexpr double small = 0.74;
constexpr double far_out = 4;  // times what 95 in 100 samples do not exceed: such peaks leave the plot

struct Samples {
  std::vector<double> u;
  std::vector<std::optional<FrenetFrame>> frames;
};

Samples sampled(const Curve<double>& curve, double width) {
  Samples made;
  int spans = 0;
  for (std::size_t k = static_cast<std::size_t>(curve.degree); k < curve.points.size(); ++k)
    spans += curve.knots[k] < curve.knots[k + 1] ? 1 : 0;
  span_parameters(curve.knots, curve.degree, std::clamp(static_cast<int>(width / 2) / std::max(spans, 1), 3, 160),
                  made.u);
  sample_frames(curve, made.u, made.frames);
  return made;
}

std::optional<double> value_of(const FrenetFrame& frame, CurvePlot plot, bool plane) {
  switch (plot) {
    case CurvePlot::speed:
      return frame.speed;
    case CurvePlot::curvature:
      return plane ? frame.signed_curvature : frame.curvature;
    case CurvePlot::torsion:
      return frame.torsion;
  }
  return std::nullopt;
}

// From 0, both ways; peaks far beyond nearly everything else do not flatten the rest.
std::pair<double, double> range_of(const std::vector<std::optional<double>>& values) {
  std::vector<double> sizes;
  for (const auto& value : values)
    if (value && std::isfinite(*value)) sizes.push_back(std::abs(*value));
  if (sizes.empty()) return {0, 1};
  std::ranges::sort(sizes);
  const double usual = sizes[sizes.size() * 95 / 100];
  const double limit = usual > 0 ? far_out * usual : sizes.back();
  double low = 0, high = 0;
  for (const auto& value : values)
    if (value && std::isfinite(*value)) {
      low = std::min(low, std::max(*value, -limit));
      high = std::max(high, std::min(*value, limit));
    }
  // Rounding alone: a line, or a plane curve's torsion.
  if (!(high - low > 1e-9)) return {low - 1, high + 1};
  return {low, high};
}

class Plot {
 public:
  Plot(Sheet& sheet, const KnotAxis& axis, const Box& box, std::pair<double, double> range)
      : sheet_(sheet), axis_(axis), box_(box), low_(range.first), high_(range.second) {}

  double place(double value) const {
    return box_.bottom() - 3 - (std::clamp(value, low_, high_) - low_) / (high_ - low_) * (box_.height - 6);
  }
  bool inside(double value) const { return low_ <= value && value <= high_; }

  void add_ground(const Curve<double>& curve) {
    View& view = sheet_.view;
    const double begin = axis_.place(curve.domain_begin()), end = axis_.place(curve.domain_end());
    parts::fill(view, {begin, box_.y, end - begin, box_.height}, Role::panel);
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
      const double knot = curve.knots[i];
      if (!(knot > curve.domain_begin() && knot < curve.domain_end()) || (i > 0 && knot == curve.knots[i - 1]))
        continue;
      parts::stroke(view, {{axis_.place(knot), box_.y, 0}, {axis_.place(knot), box_.bottom(), 0}}, Role::grid);
    }
    parts::stroke(view, {{begin, place(0), 0}, {end, place(0), 0}}, Role::axis);
    const auto number = [&](double value) {
      parts::text(view, begin - 5, place(value) + 4, {{parts::significant(value)}}, Role::text_quiet, small,
                  Label::Placement::right);
    };
    number(0);
    if (place(0) - place(high_) > 11) number(high_);
    if (place(low_) - place(0) > 11) number(low_);
  }

  // Where it leaves the plot the line ends at the edge.
  void add_line(const std::vector<double>& u, const std::vector<std::optional<double>>& values, Role role) {
    std::vector<glm::dvec3> run;
    const auto flush = [&] {
      if (run.size() > 1) parts::stroke(sheet_.view, run, role, role == Role::level_a ? 1.1 : 0.6);
      run.clear();
    };
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!values[i] || !std::isfinite(*values[i])) {
        flush();
        continue;
      }
      const bool here = inside(*values[i]);
      const bool before = i > 0 && values[i - 1] && inside(*values[i - 1]);
      if (here != before && i > 0 && values[i - 1] && std::isfinite(*values[i - 1])) {
        const double outside = here ? *values[i - 1] : *values[i], edge = std::clamp(outside, low_, high_);
        const double t = (edge - *values[i - 1]) / (*values[i] - *values[i - 1]);
        run.push_back({axis_.place(u[i - 1] + t * (u[i] - u[i - 1])), place(edge), 0});
      }
      if (here)
        run.push_back({axis_.place(u[i]), place(*values[i]), 0});
      else
        flush();
    }
    flush();
  }

 private:
  Sheet& sheet_;
  const KnotAxis& axis_;
  Box box_;
  double low_, high_;
};

}  // namespace

double add_curve_plots(Sheet& sheet, const Curve<double>& curve, double u, const std::vector<CurvePlot>& plots,
                       double x, double y, double width, double height) {
  using Level = TextRun::Level;
  const auto axis = knot_axis(curve, x, width);
  if (!axis || axis->right <= axis->left || plots.empty()) return 0;
  const auto count = static_cast<double>(plots.size());
  const double each = std::max(least_height, (height - gap * (count - 1)) / count - title_room);
  const bool plane = curve.dimension == 2;
  const Samples samples = sampled(curve, axis->right - axis->left);
  const double now = std::clamp(u, curve.domain_begin(), curve.domain_end());
  const auto here = frame(curve, now);
  View& view = sheet.view;

  double top = y;
  for (const CurvePlot plot : plots) {
    std::vector<std::optional<double>> values;
    for (const auto& f : samples.frames) values.push_back(f ? value_of(*f, plot, plane) : std::nullopt);
    const Box box{axis->left, top + title_room, axis->right - axis->left, each};
    Plot drawn(sheet, *axis, box, range_of(values));
    drawn.add_ground(curve);
    static constexpr Role roles[] = {Role::level_a, Role::result, Role::curve_result};
    const Role role = roles[static_cast<int>(plot)];
    drawn.add_line(samples.u, values, role);

    RichText title, symbol;
    if (plot == CurvePlot::speed) {
      title = {{"Speed", Level::base, false, true}};
      symbol = {{"|"}, {"C′", Level::base, true}, {" |"}};
    } else if (plot == CurvePlot::curvature) {
      title = {{plane ? "Curvature, positive to the left" : "Curvature", Level::base, false, true}};
      symbol = {{"κ", Level::base, true}};
    } else {
      title = {{"Torsion", Level::base, false, true}};
      symbol = {{"τ", Level::base, true}};
    }
    parts::text(view, axis->left, top + 12, title, Role::text_quiet, 0.8);
    const double at = axis->place(now);
    parts::stroke(view, {{at, box.y, 0}, {at, box.bottom(), 0}}, Role::current, 0.4);
    const auto value = here ? value_of(*here, plot, plane) : std::nullopt;
    if (value && drawn.inside(*value))
      view.markers.push_back({{at, drawn.place(*value), 0}, Role::current, Marker::Shape::disc, 0.6});
    symbol.push_back({value ? " = " + parts::significant(*value) : " does not exist here"});
    parts::text(view, axis->right, top + 12, std::move(symbol), Role::text_current, 0.85, Label::Placement::right);
    sheet.spots.push_back({{Link::Kind::parameter, 0},
                           at - 8,
                           box.y,
                           16,
                           box.height,
                           plot == CurvePlot::speed       ? "u on speed"
                           : plot == CurvePlot::curvature ? "u on curvature"
                                                          : "u on torsion"});
    top = box.bottom() + gap;
  }
  return top - gap - y;
}

}  // namespace blossom
