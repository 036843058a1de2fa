#pragma once
// What several algorithms' files share: what they demand of a parameter, and the misconceptions that any chain of
// affine combinations invites.

#include "algorithms/algorithm.hpp"

namespace blossom {

// Whether a parameter, the input `name`, lies in the domain of these knots, and is a knot in exact arithmetic if and
// only if it is one when rounded to double (else the two would take different steps). Says at the input if not. The
// knots are called `knot` with their index.
inline bool check_parameter(const Exact& u, int degree, const std::vector<Exact>& knots, std::string_view name,
                            std::string_view knot, const std::function<Cursor(std::string_view)>& at) {
  const Exact& begin = knots[static_cast<std::size_t>(degree)];
  const Exact& end = knots[knots.size() - static_cast<std::size_t>(degree) - 1];
  if (u < begin || end < u) {
    const std::string shown = format_brief(u);
    const bool told_apart = shown != format_brief(u < begin ? begin : end);
    at(name).error("must lie in the domain [" + format_brief(begin) + ", " + format_brief(end) + "]" +
                   (told_apart ? ", not at " + shown : "; it lies just outside"));
    return false;
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (u == knots[i] || u.to_double() != knots[i].to_double()) continue;
    at(name).error("differs from the knot " + std::string(knot) + std::to_string(i) + " = " + format_brief(knots[i]) +
                   " by less than a double can tell; make them equal or move them apart");
    return false;
  }
  return true;
}

// The same of the input u of the input curve.
inline bool check_parameter(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  return check_parameter(inputs.number("u"), curve.degree, curve.knots, "u", "u_", at);
}

inline bool is_blend(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<Blend>; }

// (1 - a) A + a B on plain numbers, homogeneous.
inline Numbers<Exact> blend(NumbersView<Exact> a, NumbersView<Exact> A, NumbersView<Exact> B) {
  Numbers<Exact> made;
  for (std::size_t i = 0; i < 4; ++i) made.push_back((Exact(1) - a[0]) * A[i] + a[0] * B[i]);
  return made;
}

// The two weights exchanged. The advice names the algorithm's own weights and points.
inline Misconception swapped_weights(std::string_view advice) {
  return {"swapped-weights", "the weights are swapped", advice, [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (!is_blend(site)) return {};
            return {blend(site.operand(0), site.operand(2), site.operand(1))};
          }};
}

// The homogeneous coordinates given as the point: C = (wx, wy).
inline Misconception missing_division() {
  return {
      "missing-division", "the division by the weight is forgotten",
      "The algorithm runs in homogeneous coordinates (wx, wy, w): the point itself is (wx/w, wy/w), so divide by the "
      "weight at the end.",
      [](const Site& site) -> std::vector<Numbers<Exact>> {
        if (!site.trace().rational) return {};
        Numbers<Exact> made;
        if (site.trace().value(site.value()).rule == &rule_info<Project>) {
          const auto A = site.operand(0);
          made.assign(A.begin(), A.end());
        } else if (is_blend(site)) {
          made = blend(site.operand(0), site.operand(1), site.operand(2));
        } else {
          return {};
        }
        made[3] = Exact(1);
        return {made};
      }};
}

// The points themselves are combined, as though all weights were equal.
inline Misconception unweighted_points() {
  return {
      "unweighted-points", "the control points are used instead of the weighted ones",
      "Multiply each control point by its weight first: it is (wx, wy, w) that is combined, and the point follows by "
      "dividing by the combined weight.",
      [](const Site& site) -> std::vector<Numbers<Exact>> {
        if (!site.trace().rational || !is_blend(site)) return {};
        const auto A = site.operand(1);
        const auto B = site.operand(2);
        if (A[3] == Exact(0) || B[3] == Exact(0)) return {};
        const Numbers<Exact> a{A[0] / A[3], A[1] / A[3], A[2] / A[3], Exact(1)};
        const Numbers<Exact> b{B[0] / B[3], B[1] / B[3], B[2] / B[3], Exact(1)};
        return {blend(site.operand(0), a, b)};
      }};
}

// The weight counts, but the given points' coordinates are not multiplied by it: (x, y, w) for (wx, wy, w).
inline Misconception unweighted_coordinates() {
  return {"unweighted-coordinates", "the coordinates of the control points are not multiplied by their weights",
          "A control point (x, y) of weight w enters the computation as (wx, wy, w), not as (x, y, w).",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (!site.trace().rational || !is_blend(site)) return {};
            bool any_given = false;
            const auto entered = [&](std::size_t operand) {
              const auto A = site.operand(operand);
              Numbers<Exact> point(A.begin(), A.end());
              if (!site.trace().is_input(site.trace().operands(site.value())[operand]) || A[3] == Exact(0))
                return point;
              any_given = true;
              for (std::size_t i = 0; i < 3; ++i) point[i] /= A[3];
              return point;
            };
            const auto A = entered(1), B = entered(2);
            if (!any_given) return {};
            return {blend(site.operand(0), A, B)};
          }};
}

// ---- of the triangle on knots: de Boor's algorithm and knot insertion ---------------------------------------------

// alpha[r][i] with u_{i+p} for u_{i+p-r+1}: the knots of the first level on every level.
inline Misconception neighbour_knot() {
  return {"neighbour-knot", "the denominator of alpha uses u_{i+p} on a later level",
          "Each level has one knot less between its ends: the denominator of alpha[r][i] is u_{i+p-r+1} - u_i.",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (site.trace().value(site.value()).rule != &rule_info<Ratio> || site.name().arity != 2) return {};
            const auto [r, i] = site.name().index;
            const int p = site.inputs().curve("curve").degree;
            const auto right = site.sibling_numbers("U"_v(i + p));
            if (r < 2 || !right || (*right)[0] == site.operand(1)[0]) return {};
            const Exact& a = site.operand(1)[0];
            return {{(site.operand(0)[0] - a) / ((*right)[0] - a)}};
          }};
}

// P[r-1][i+1] for P[r-1][i-1] as the partner of P[r-1][i].
inline Misconception wrong_pair() {
  return {
      "wrong-pair", "the wrong neighbour is taken",
      "The point of index i of a level lies between the points i-1 and i of the level before, not between i and i+1.",
      [](const Site& site) -> std::vector<Numbers<Exact>> {
        if (!is_blend(site) || site.name().arity != 2) return {};
        // The partner's right neighbour on its own level.
        Name next = site.trace().value(site.trace().operands(site.value())[2]).name;
        ++next.index[next.arity - 1];
        const auto numbers = site.sibling_numbers(next);
        if (!numbers) return {};
        return {blend(site.operand(0), site.operand(2), *numbers)};
      }};
}

// The knot span is off by one, or, at a knot, the one that ends there.
inline Misconception wrong_span() {
  return {"wrong-span", "the knot span is off by one",
          "k is the index with u_k <= u < u_{k+1}: indices start at 0, and at a knot the span begins with the last "
          "knot equal "
          "to u.",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (!(site.name() == "k"_v())) return {};
            const Exact& k = site.trace().numbers(site.value())[0];
            std::vector<Numbers<Exact>> candidates;
            if (const auto s = site.sibling("s"_v); s && Exact(1) < site.trace().numbers(*s)[0])
              candidates.push_back({k - site.trace().numbers(*s)[0]});
            candidates.push_back({k - Exact(1)});
            candidates.push_back({k + Exact(1)});
            return candidates;
          }};
}

}  // namespace blossom
