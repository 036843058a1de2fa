#pragma once
// Random networks of curves that cross at common parameters: isoparametric curves of a random polynomial surface, some
// of them with a higher degree or more knots than they need.

#include <random>

#include "algorithms/algorithm.hpp"
#include "kernel/degree_elevation.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/splines.hpp"

namespace blossom::test {

struct Network {
  std::vector<Curve<Exact>> u_curves, v_curves;
  std::vector<Exact> u_parameters, v_parameters;
  Surface<Exact> surface;  // that they lie on
};

// The isoparametric curve of the surface along u (way 0) at v = t, or along v (way 1) at u = t.
inline Curve<Exact> isoparametric(const Surface<Exact>& surface, int way, const Exact& t) {
  Curve<Exact> curve;
  const std::size_t other = way == 0 ? 1 : 0;
  curve.degree = surface.degree[static_cast<std::size_t>(way)];
  curve.knots = surface.knots[static_cast<std::size_t>(way)];
  curve.dimension = 3;
  for (int i = 0; i < (way == 0 ? surface.rows : surface.columns); ++i) {
    Curve<Exact> across{surface.degree[other], surface.knots[other], {}, 3, false, false};
    for (int j = 0; j < (way == 0 ? surface.columns : surface.rows); ++j)
      across.points.push_back(way == 0 ? surface.at(i, j) : surface.at(j, i));
    curve.points.push_back(homogeneous_point(across, t));
  }
  return curve;
}

// The same curve, now and then written in a more complicated way.
inline Curve<Exact> rewritten(std::mt19937& random, Curve<Exact> curve) {
  NoRecorder<Exact> none;
  if (random_int(random, 0, 2) == 0) curve = degree_elevation(curve, 1, none);
  if (random_int(random, 0, 2) == 0) {
    const Exact u = curve.domain_begin() + (curve.domain_end() - curve.domain_begin()) * random_ratio(random, 0, 1, 8);
    if (multiplicity<Exact>(curve.knots, u) < curve.degree) curve = knot_insertion(curve, u, 1, none);
  }
  return curve;
}

inline Network random_network(std::mt19937& random, int u_count, int v_count, bool evenly) {
  Network network;
  network.surface = random_surface(random, random_int(random, 1, 3), random_int(random, 1, 3), random_int(random, 1, 2),
                                   random_int(random, 0, 3) > 0, false);
  const auto& s = network.surface;
  const auto parameters = [&](int way, int count) {
    const auto& knots = s.knots[static_cast<std::size_t>(way)];
    const Exact begin = knots[static_cast<std::size_t>(s.degree[static_cast<std::size_t>(way)])];
    const Exact end = knots[static_cast<std::size_t>(way == 0 ? s.rows : s.columns)];
    std::vector<Exact> t;
    for (int k = 0; k < count; ++k) {
      const bool inner = 0 < k && k < count - 1 && !evenly;
      const Exact share =
          Exact::ratio(k, count - 1) + (inner ? Exact::ratio(random_int(random, -2, 2), 6 * count) : Exact(0));
      t.push_back(begin + (end - begin) * share);
    }
    return t;
  };
  network.u_parameters = parameters(0, v_count);
  network.v_parameters = parameters(1, u_count);
  for (const Exact& v : network.v_parameters) network.u_curves.push_back(rewritten(random, isoparametric(s, 0, v)));
  for (const Exact& u : network.u_parameters) network.v_curves.push_back(rewritten(random, isoparametric(s, 1, u)));
  return network;
}

// As inputs, for algorithms that take a network. Algorithms without parameters want its four boundary curves: there the
// inner control points may be anywhere, too.
inline std::optional<InputValue<Exact>> network_input(std::string_view name, const Network& network) {
  if (name == "u_curves") return network.u_curves;
  if (name == "v_curves") return network.v_curves;
  if (name == "u_parameters") return network.u_parameters;
  if (name == "v_parameters") return network.v_parameters;
  return std::nullopt;
}
inline Network any_network(std::mt19937& random, const Algorithm& algorithm) {
  if (algorithm.input("u_parameters") != nullptr)
    return random_network(random, random_int(random, 2, 4), random_int(random, 2, 4), random_int(random, 0, 1) == 1);
  auto network = random_network(random, 2, 2, true);
  for (auto* curves : {&network.u_curves, &network.v_curves})
    for (auto& curve : *curves) {
      const bool clamped = curve.knots.front() == curve.domain_begin() && curve.knots.back() == curve.domain_end();
      for (std::size_t i = 1; clamped && i + 1 < curve.points.size(); ++i)
        curve.points[i] = random_point(random, false);
    }
  return network;
}

}  // namespace blossom::test
