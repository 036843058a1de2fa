// Vectors that are seen where they stand: a derivative at the point of the curve, a tangent at its data point.
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "scene/scene_samples.hpp"

namespace blossom {
namespace {

struct Standing {
  std::string_view algorithm;
  Symbol vector, foot;  // the vector of index i stands at the point of index i
  int foot_index = -1;  // unless all of them stand at one
};
const std::array standing_vectors{Standing{"curve_derivatives", Symbol::of("D"), Symbol::of("D"), 0},
                                  Standing{"local_interpolation", Symbol::of("V"), Symbol::of("D")}};

// 1, 0.5, 0.2, 0.1, ...: the largest that is not above `most`. Derivatives are often far longer than the curve.
double round_scale(double most) {
  if (!(most > 1e-9)) return 0;
  double scale = 1;
  for (int i = 0; scale > most; ++i) scale *= i % 3 == 1 ? 0.4 : 0.5;
  return scale;
}

}  // namespace

void SceneSamples::find_arrows() {
  const TraceGraph& graph = *source_->graph;
  for (const Standing& standing : standing_vectors) {
    if (source_->algorithm->id != standing.algorithm) continue;
    const std::size_t begin = arrows.size();
    double longest = 0;
    std::map<int, glm::dvec3> feet;
    for (ValueId v = 0; v < graph.value_count(); ++v) {
      const ValueRecord& record = graph.value(v);
      const Name& name = record.name;
      if (name.arity != 1) continue;
      if (name.symbol == standing.foot && source_->points[v]) feet.emplace(name.index[0], *source_->points[v]);
      if (record.kind != ValueKind::vector || name.symbol != standing.vector) continue;
      const auto foot = feet.find(standing.foot_index < 0 ? name.index[0] : standing.foot_index);
      if (foot == feet.end()) continue;
      const auto numbers = source_->raw(v);
      arrows.push_back({v, foot->second, {numbers[0], numbers[1], numbers[2]}, 1, record.step});
      longest = std::max(longest, glm::length(arrows.back().along));
    }
    const double scale = round_scale(longest > 0 ? 0.7 * bounds.diagonal() / longest : 1);
    for (std::size_t i = begin; i < arrows.size(); ++i) {
      arrows[i].scale = scale;
      arrows[i].along *= scale;
      places_.push_back(arrows[i].foot + arrows[i].along);
      bounds.add(places_.back());
    }
  }
}

}  // namespace blossom
