#pragma once
// What networks of curves must fulfil: the same weight everywhere, and curves that meet where they are to cross.

#include <cmath>

#include "algorithms/construction.hpp"
#include "kernel/evaluate.hpp"

namespace blossom {

using ReportAt = std::function<Cursor(std::string_view)>;

// Sums of surfaces are sums of points only where all weights are the same number.
inline bool check_weights(const Inputs<Exact>& inputs, const ReportAt& at) {
  const Exact w = inputs.curves("u_curves")[0].points[0].w;
  for (const char* name : {"u_curves", "v_curves"}) {
    const auto& curves = inputs.curves(name);
    for (std::size_t l = 0; l < curves.size(); ++l)
      for (const auto& P : curves[l].points)
        if (P.w != w || w == Exact(0)) {
          at(name).error("must be polynomial, or all curves must have the same weight everywhere: number " +
                         std::to_string(l) + " has the weight " + format_brief(P.w == w ? w : P.w) +
                         (P.w == w ? "" : ", the first curve " + format_brief(w)));
          return false;
        }
  }
  return true;
}

inline std::string place_text(const HPoint<Exact>& P) {
  return "(" + format_brief(P.x / P.w) + ", " + format_brief(P.y / P.w) + ", " + format_brief(P.z / P.w) + ")";
}

// Whether curve l along u at u meets curve k along v at v, to a billionth of their size: numbers may have been rounded.
inline bool check_meeting(const Inputs<Exact>& inputs, const ReportAt& at, std::size_t l, const Exact& u, std::size_t k,
                          const Exact& v) {
  const auto P = homogeneous_point(inputs.curves("u_curves")[l], u);
  const auto Q = homogeneous_point(inputs.curves("v_curves")[k], v);
  double size = 0, apart = 0;
  for (const auto& A : inputs.curves("u_curves")[l].points)
    for (int c = 0; c < 3; ++c) size = std::max(size, std::abs((A[c] / A.w).to_double()));
  for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs((P[c] / P.w - Q[c] / Q.w).to_double()));
  if (apart <= 1e-9 * size) return true;
  at("v_curves")
      .error("must meet the curves along u: number " + std::to_string(k) + " is at " + place_text(Q) +
             " for v = " + format_brief(v) + ", but number " + std::to_string(l) + " of u_curves is at " +
             place_text(P) + " for u = " + format_brief(u));
  return false;
}

// The values, phases and rules of making both families compatible, in the phases along_u and along_v.
inline void add_families(Algorithm& a, int line) {
  a.phases.push_back({"along_u", "Make the curves along u compatible", line,
                      "The curves along u get one degree and one knot vector, without changing shape."});
  a.phases.push_back({"along_v", "Make the curves along v compatible", line, "Likewise the curves along v."});
  add_compatible(a, line);
}

}  // namespace blossom
