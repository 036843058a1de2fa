#pragma once
// Refinement: many knots inserted into a curve, which stays the same (The NURBS Book 5.3). The new knots are put in
// order, and each different one is inserted as often as it is given, by Boehm's algorithm, in a phase of its own.
//
// A5.4 and the Oslo algorithm (Cohen, Lyche & Riesenfeld 1980) insert all knots in one pass, and touch each point less
// often; the control points that come out are the same ones, as the curve over its knots has no others.

#include <numeric>

#include "kernel/clamping.hpp"

namespace blossom {

namespace refine {

// The places of equal numbers, in the order of the numbers: {2, 1, 2} gives {1}, {0, 2}.
template <Scalar S>
std::vector<std::vector<int>> groups(std::span<const S> numbers) {
  std::vector<int> order(numbers.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) -> const S& { return numbers[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return at(i) < at(j); });
  std::vector<std::vector<int>> found;
  for (const int i : order) {
    if (found.empty() || at(found.back().front()) < at(i)) found.emplace_back();
    found.back().push_back(i);
  }
  return found;
}

}  // namespace refine

// Preconditions: a valid curve; each new knot in its domain, and with it of multiplicity p at most.
template <class R>
Curve<typename R::Number> refinement(const Curve<typename R::Number>& curve,
                                     const std::vector<typename R::Number>& new_knots, R& rec) {
  using S = typename R::Number;
  const auto X = rec.inputs("X"_v, std::span<const S>(new_knots));
  const auto list = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  auto [made, knots] = known_curve<R>(given, list);

  int number = 0;
  for (const auto& group : refine::groups(X.values())) {
    auto phase = rec.phase({"knot", number++, true, "knot_insertion"});
    const auto times = rec.input("h"_v, static_cast<int>(group.size()));
    const auto u = rec.apply(SameNumber{}, "u"_v, X[group.front()]);
    if constexpr (R::recording)
      if (number > 1) knots = compatible::name_curve(rec, made, number > 2);
    auto refined = insert_knot(rec, made, knots, u, times);
    made = std::move(refined.curve);
    if constexpr (R::recording)
      knots = std::move(refined.knots);
    else
      knots.value.assign(made.U.values().begin(), made.U.values().end());
  }
  {
    auto phase = rec.phase({"collect"});
    rec.apply(Gather{}, "Ubar"_v, slice(made.U, 0, made.U.size()));
    name_points(rec, "Q"_v, made.P);
  }
  return plain_curve<R>(std::move(made));
}

}  // namespace blossom
