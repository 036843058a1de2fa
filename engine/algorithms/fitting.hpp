#pragma once
// What the files of the algorithms share that fit curves to points.

#include "algorithms/common.hpp"
#include "kernel/parameters.hpp"

namespace blossom::fitting {

template <class In>
Parametrization parametrization(const In& inputs) {
  const auto& name = inputs.choice("parametrization");
  return name == "uniform"       ? Parametrization::uniform
         : name == "centripetal" ? Parametrization::centripetal
         : name == "universal"   ? Parametrization::universal
                                 : Parametrization::chord;
}

// t_k = k/n whatever the distances.
inline Misconception always_uniform() {
  return {"always-uniform", "the parameters are uniform",
          "The parameters follow the distances between the points: t grows more where the next point is farther away.",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (site.name().symbol != Symbol::of("t") || site.trace().value(site.value()).rule != &rule_info<Sum>)
              return {};
            const int n = static_cast<int>(site.inputs().points("points").points.size()) - 1;
            return {{Exact::ratio(site.name().index[0], n)}};
          }};
}

// The distance itself where its share of the whole is meant.
inline Misconception not_divided() {
  return {"not-divided", "the distances are not divided by the whole length",
          "Each distance counts by its share of the whole length, so that t runs from 0 to 1.",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (site.name().symbol != Symbol::of("e") || site.trace().value(site.value()).rule != &rule_info<Quotient>)
              return {};
            const auto d = site.operand(0);
            return {Numbers<Exact>(d.begin(), d.end())};
          }};
}

}  // namespace blossom::fitting
