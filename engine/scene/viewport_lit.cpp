// What is lit in the geometry of a step, and the places that can be pointed at.
#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "base/scalar.hpp"
#include "scene/camera.hpp"
#include "scene/panel_parts.hpp"
#include "scene/viewport_builder.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_shares = 64;  // rings of ancestors, those that weigh most
constexpr std::size_t most_share_texts = 12;
constexpr double least_share = 5e-4;  // would be written as 0
constexpr double spot_size = 22;
// Of another phase or retired: a long phase or a line of the pseudo-code lights tens of thousands.
constexpr std::size_t most_lit_elsewhere = 400, most_lit_names = 40;

}  // namespace

// Rings around what the lit value came from: the larger, the more it weighs.
void ViewportBuilder::add_shares() {
  struct Share {
    glm::dvec3 at;
    double share;
  };
  std::vector<Share> shares;
  for (const auto& [v, share] : options_.emphasis.shares) {
    if (!(std::abs(share) >= least_share) || options_.emphasis.lights(v)) continue;
    if (v >= graph_.value_count() || graph_.value(v).step > step_) continue;
    const auto d = std::ranges::lower_bound(samples_.drawables, v, {}, &Drawable::value);
    if (d != samples_.drawables.end() && d->value == v && is_around(*d)) shares.push_back({place(v), share});
  }
  std::ranges::stable_sort(shares,
                           [](const Share& a, const Share& b) { return std::abs(a.share) > std::abs(b.share); });
  // Values that stand at one place (a point that a step only carries over) are one ring.
  std::vector<Share> kept;
  for (const Share& share : shares) {
    if (kept.size() == most_shares) break;
    if (std::ranges::none_of(kept, [&](const Share& other) { return other.at == share.at; })) kept.push_back(share);
  }
  for (const Share& share : kept) {
    add_ring(share.at, 0.5 + 0.9 * std::sqrt(std::min(std::abs(share.share), 1.0)));
    if (kept.size() > most_share_texts) continue;
    Label label;
    label.anchor = share.at;
    label.text = {{parts::share_text(source_, share.share)}};
    label.role = Role::text_quiet;
    label.size_scale = 0.9;
    label.placement = Label::Placement::around;
    label.priority = 25;
    label.optional = true;
    view_.labels.push_back(std::move(label));
  }
}

// What is lit although it is not of this step: retired, or of another phase.
void ViewportBuilder::add_lit_elsewhere() {
  std::vector<ValueId> elsewhere;
  for (const ValueId v : options_.emphasis.lit) {
    if (v >= graph_.value_count() || graph_.value(v).step > step_ || !source_.points[v]) continue;
    if (std::ranges::binary_search(shown_, v, {}, [](const Drawable* d) { return d->value; })) continue;
    elsewhere.push_back(v);
  }
  const std::size_t stride = elsewhere.size() / most_lit_elsewhere + 1;
  for (std::size_t i = 0; i < elsewhere.size(); i += stride) {
    const ValueId v = elsewhere[i];
    add_ring(*source_.points[v], 1);
    if (elsewhere.size() > most_lit_names) continue;
    Label label;
    label.anchor = *source_.points[v];
    label.text = typeset_name(graph_.value(v).name, source_.algorithm_at(graph_.value(v).step));
    for (TextRun& run : label.text) run.bold = true;
    label.role = Role::text_quiet;
    label.placement = Label::Placement::around;
    label.priority = 40;
    view_.labels.push_back(std::move(label));
  }
}

void ViewportBuilder::add_spots() {
  const Lens lens(view_.camera, {view_.width, view_.height});
  std::vector<std::pair<double, Spot>> found;
  for (const Drawable* d : shown_) {
    const auto at = lens(place(d->value));
    if (!at || !(at->x >= 0 && at->x <= view_.width && at->y >= 0 && at->y <= view_.height)) continue;
    found.push_back({at->z,
                     {{Link::Kind::value, d->value},
                      at->x - spot_size / 2,
                      at->y - spot_size / 2,
                      spot_size,
                      spot_size,
                      graph_.name(d->value)}});
  }
  if (view_.camera.kind == Camera::Kind::orbit)
    std::ranges::stable_sort(found, {}, [](const auto& entry) { return entry.first; });
  sheet_.spots.reserve(found.size());
  for (auto& [z, spot] : found) sheet_.spots.push_back(std::move(spot));
}

}  // namespace blossom
