#include "studio/seams.hpp"

#include <algorithm>

#include "studio/remake.hpp"

namespace blossom {
namespace {

// One end of a curve, or one side of a surface: its points in order and the next ones inside, by their places in the
// net.
struct Border {
  std::vector<std::size_t> on, inside;
  int degree = 1;
  Exact span{1};  // the length of the end span

  // What a difference at the border is multiplied with to be the derivative there.
  Exact scale() const { return Exact(degree) / span; }
};

bool is_clamped(const std::vector<Exact>& U, int p, bool at_end) {
  const auto n = U.size(), k = static_cast<std::size_t>(p);
  return at_end ? U[n - 1] == U[n - 1 - k] : U[0] == U[k];
}
Exact end_span(const std::vector<Exact>& U, int p, bool at_end) {
  const auto n = U.size(), k = static_cast<std::size_t>(p);
  return at_end ? U[n - 1] - U[n - 2 - k] : U[k + 1] - U[0];
}

std::vector<Border> borders_of(const Geometry& geometry) {
  std::vector<Border> borders;
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) {
    const std::size_t n = curve->points.size();
    for (const bool at_end : {false, true})
      if (is_clamped(curve->knots, curve->degree, at_end))
        borders.push_back(
            {{at_end ? n - 1 : 0}, {at_end ? n - 2 : 1}, curve->degree, end_span(curve->knots, curve->degree, at_end)});
  } else if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) {
    for (const std::size_t d : {std::size_t{0}, std::size_t{1}})
      for (const bool at_end : {false, true}) {
        const int p = surface->degree[d];
        if (!is_clamped(surface->knots[d], p, at_end)) continue;
        Border border{{}, {}, p, end_span(surface->knots[d], p, at_end)};
        const int across = d == 0 ? surface->rows : surface->columns, along = d == 0 ? surface->columns : surface->rows;
        const auto place = [&](int line, int at) {
          const int i = d == 0 ? line : at, j = d == 0 ? at : line;
          return static_cast<std::size_t>(i * surface->columns + j);
        };
        for (int at = 0; at < along; ++at) {
          border.on.push_back(place(at_end ? across - 1 : 0, at));
          border.inside.push_back(place(at_end ? across - 2 : 1, at));
        }
        borders.push_back(std::move(border));
      }
  }
  return borders;
}

using Points = std::vector<HPoint<Exact>>;
const Points& points_of(const Geometry& geometry) {
  return std::visit([](const auto& g) -> const Points& { return g.points; }, geometry);
}
Points& points_of(Geometry& geometry) {
  return std::visit([](auto& g) -> Points& { return g.points; }, geometry);
}

HPoint<Exact> plus(const HPoint<Exact>& a, const HPoint<Exact>& b, const Exact& t) {
  return {a.x + t * b.x, a.y + t * b.y, a.z + t * b.z, a.w + t * b.w};
}
HPoint<Exact> difference(const HPoint<Exact>& a, const HPoint<Exact>& b) { return plus(a, b, Exact(-1)); }

// To rounding, for what is approximate.
bool same(const HPoint<Exact>& a, const HPoint<Exact>& b) {
  if (a == b) return true;
  for (int k = 0; k < 4; ++k) {
    const double x = a[k].to_double(), y = b[k].to_double();
    if (!(std::abs(x - y) <= 1e-9 * std::max({1.0, std::abs(x), std::abs(y)}))) return false;
  }
  return true;
}

struct Seam {
  Border x, y;
  Exact ratio;
};

std::optional<Seam> seam_of(const Geometry& X, const Geometry& Y) {
  const Points &P = points_of(X), &Q = points_of(Y);
  const auto of_y = borders_of(Y);
  for (const Border& x : borders_of(X))
    for (const Border& y : of_y) {
      if (x.on.size() != y.on.size()) continue;
      const Exact ratio = x.scale() / y.scale();
      bool smooth = true;
      for (std::size_t k = 0; smooth && k < x.on.size(); ++k)
        smooth = same(P[x.on[k]], Q[y.on[k]]) &&
                 same(Q[y.inside[k]], plus(Q[y.on[k]], difference(P[x.on[k]], P[x.inside[k]]), ratio));
      if (smooth) return Seam{x, y, ratio};
    }
  return std::nullopt;
}

// Y after X was edited. Y stands as it was before the edit, and so do the differences across the border.
void follow(const Seam& seam, Points& P, Points& Q) {
  for (std::size_t k = 0; k < seam.x.on.size(); ++k) {
    HPoint<Exact>&b = P[seam.x.on[k]], &inside = P[seam.x.inside[k]], &on = Q[seam.y.on[k]];
    const HPoint<Exact> moved = difference(b, on);
    const HPoint<Exact> inside_before = plus(on, difference(Q[seam.y.inside[k]], on), Exact(-1) / seam.ratio);
    if (!same(b, on) && same(inside, inside_before)) inside = plus(inside, moved, Exact(1));
    on = b;
    Q[seam.y.inside[k]] = plus(b, difference(b, inside), seam.ratio);
  }
}

bool has_points_alone(const Geometry& g) {
  return !std::holds_alternative<Curve<Exact>>(g) && !std::holds_alternative<Surface<Exact>>(g);
}

}  // namespace

bool share_smooth_border(const Geometry& a, const Geometry& b) {
  return !has_points_alone(a) && !has_points_alone(b) && a.index() == b.index() && seam_of(a, b).has_value();
}

Workspace seams_kept(const Workspace& before, Workspace edited, std::size_t changed, bool quick) {
  if (before.objects.size() != edited.objects.size() || changed >= edited.objects.size()) return edited;
  std::vector<bool> done(edited.objects.size());
  std::vector<std::size_t> open{changed}, followed;
  done[changed] = true;
  while (!open.empty()) {
    const std::size_t x = open.back();
    open.pop_back();
    for (std::size_t y = 0; y < edited.objects.size(); ++y) {
      const Geometry& was = before.objects[x].geometry;
      if (done[y] || has_points_alone(was) || was.index() != before.objects[y].geometry.index()) continue;
      Geometry &X = edited.objects[x].geometry, &Y = edited.objects[y].geometry;
      if (points_of(X).size() != points_of(was).size() ||
          points_of(Y).size() != points_of(before.objects[y].geometry).size())
        continue;
      const auto seam = seam_of(was, before.objects[y].geometry);
      if (!seam) continue;
      follow(*seam, points_of(X), points_of(Y));
      edited.objects[x].recipe.reset();
      edited.objects[y].recipe.reset();
      done[y] = true;
      open.push_back(y);
      followed.push_back(y);
    }
  }
  if (followed.empty()) return edited;
  followed.push_back(changed);
  remake_after(edited, followed, quick);
  return edited;
}

}  // namespace blossom
