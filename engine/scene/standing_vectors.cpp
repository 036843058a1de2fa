// Vectors that are seen where they stand: a derivative at the point of the curve, a tangent at its data point.
#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "scene/scene_samples.hpp"

namespace blossom {
namespace {

// 1, 0.5, 0.2, 0.1, ...: the largest that is not above `most`. Derivatives are often far longer than the curve.
double round_scale(double most) {
  if (!(most > 1e-9)) return 0;
  double scale = 1;
  for (int i = 0; scale > most; ++i) scale *= i % 3 == 1 ? 0.4 : 0.5;
  return scale;
}

}  // namespace

// All arrows of a run have one scale, so that they can be compared.
void SceneSamples::find_arrows() {
  const TraceGraph& graph = *source_->graph;
  if (std::ranges::all_of(source_->algorithm->values, [](const ValueSpec& spec) { return spec.foot.empty(); })) return;
  using Key = std::tuple<std::uint64_t, int, int>;
  const auto key = [](const Name& name) { return Key(name.symbol.packed, name.arity, name.index[0]); };
  double longest = 0;
  std::map<Key, glm::dvec3> points;  // so far, of at most one index
  for (ValueId v = 0; v < graph.value_count(); ++v) {
    const ValueRecord& record = graph.value(v);
    if (record.name.arity > 1 || (record.kind != ValueKind::point && record.kind != ValueKind::vector)) continue;
    if (source_->points[v]) points.emplace(key(record.name), *source_->points[v]);
    const ValueSpec* spec = source_->algorithm->spec(record.name);
    if (spec == nullptr || spec->foot.empty()) continue;
    const Name name = foot_of(record.name, *spec);
    const auto foot = name == record.name ? points.end() : points.find(key(name));
    if (foot == points.end()) continue;
    const auto numbers = source_->raw(v);
    arrows.push_back({v, foot->second, {numbers[0], numbers[1], numbers[2]}, 1, record.step});
    longest = std::max(longest, glm::length(arrows.back().along));
  }
  const double scale = round_scale(longest > 0 ? 0.7 * bounds.diagonal() / longest : 1);
  for (StandingArrow& arrow : arrows) {
    arrow.scale = scale;
    arrow.along *= scale;
    places_.push_back(arrow.foot + arrow.along);
    bounds.add(places_.back());
  }
}

}  // namespace blossom
