#pragma once
// What the files of algorithms on surfaces share.

#include "algorithms/common.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

inline InputSpec surface_input() {
  return {"surface", InputSpec::Type::surface, "A surface of any kind; clamped or not."};
}
inline InputSpec direction_input(std::string_view description) {
  return {"direction", InputSpec::Type::choice, description, 0, 0, {"u", "v"}};
}

template <Scalar S>
tensor::Direction direction_of(const Inputs<S>& inputs) {
  return inputs.choice("direction") == "v" ? tensor::Direction::v : tensor::Direction::u;
}

// Whether the input `name` can be taken as a parameter of the surface in that direction.
inline bool check_surface_parameter(const Inputs<Exact>& inputs, std::string_view name, tensor::Direction d,
                                    const std::function<Cursor(std::string_view)>& at) {
  const auto& surface = inputs.surface("surface");
  return check_parameter(inputs.number(name), surface.degree[index(d)], surface.knots[index(d)], name,
                         d == tensor::Direction::u ? "u_" : "v_", at);
}

// The values of a surface as given.
inline std::vector<ValueSpec> surface_values() {
  return {
      {"U", {}, "the knots in u"},
      {"U", {"i"}, "the knot u_i"},
      {"V", {}, "the knots in v"},
      {"V", {"j"}, "the knot v_j"},
      {"P", {"i", "j"}, "the control point in row i and column j", 0, "", ValueSpec::Draw::net},
  };
}

inline void append(std::vector<ValueSpec>& values, std::vector<ValueSpec> more) {
  values.insert(values.end(), more.begin(), more.end());
}

}  // namespace blossom
