#pragma once
// Making curves compatible: one degree, one domain, one knot vector, each curve unchanged as a set of points (The NURBS
// Book, 8.4 and 10.3): clamp, elevate to the highest degree, map the domains to [0, 1] where they differ, then insert
// into each curve the knots it lacks of the union of all knot vectors (highest multiplicity of each).

#include "kernel/degree_elevation.hpp"

namespace blossom {

// Two knot vectors in one, each knot as often as in the one that has it more often.
struct UniteKnots {
  static constexpr std::string_view name = "unite_knots";
  static constexpr std::string_view formula = "the knots of {0} and {1}, each with its higher multiplicity";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(std::span<const S> U, std::span<const S> V) {
    std::vector<S> all;
    all.reserve(U.size() + V.size());
    std::set_union(U.begin(), U.end(), V.begin(), V.end(), std::back_inserter(all));  // a multiset's union, as wanted
    return all;
  }
  template <Scalar S>
  static bool defined(std::span<const S> U, std::span<const S> V) {
    return std::is_sorted(U.begin(), U.end()) && std::is_sorted(V.begin(), V.end());
  }
};

// A point over mapped knots: it stays, its polar label is told by the knots
struct Reparametrize {
  static constexpr std::string_view name = "reparametrize";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

namespace compatible {

// The knots as one value; without recording they are that already.
template <class R>
auto knot_list(R& rec, const MadeCurve<R>& curve) {
  if constexpr (R::recording)
    return rec.apply(Gather{}, "U"_v, slice(curve.U, 0, curve.U.size()));
  else
    return Traced<std::span<const typename R::Number>, NoId>{curve.U.values(), {}};
}

// The curve in hand under names of its own, U[i] and P[i], in the phase that goes on with it, and its knots as one
// value. `again`: it has been named in an earlier phase, whose points leave the picture.
template <class R>
auto name_curve(R& rec, MadeCurve<R>& curve, bool again) {
  auto step = rec.one_step();
  if constexpr (R::recording) {
    for (int i = 0; i < curve.U.size(); ++i) curve.U.set(i, rec.apply(SameNumber{}, "U"_v(i), curve.U[i]));
    for (int i = 0; i < curve.P.size(); ++i) {
      const auto before = curve.P[i].id;
      curve.P.set(i, rec.apply(Same{}, "P"_v(i), curve.P[i]));
      if (again) rec.retire(before);
    }
  }
  return knot_list(rec, curve);
}

// The same curve with its domain's ends as knots of multiplicity p + 1 (they had less: an unclamped curve).
template <class R>
MadeCurve<R> clamp(R& rec, MadeCurve<R> curve) {
  using S = typename R::Number;
  const int p = curve.degree;
  bool changed = false;
  for (const bool front : {true, false}) {
    const int at = front ? p : curve.U.size() - p - 1;
    const S u = curve.U[at].value;
    const int s = multiplicity(curve.U.values(), u);
    if (s < p) {
      auto phase = rec.phase({"end", front ? 0 : 1, true, "knot_insertion"});
      const auto times = rec.input("h"_v, p - s);
      const auto end = rec.apply(SameNumber{}, "u"_v, curve.U[at]);
      const auto list = changed ? name_curve(rec, curve, false) : knot_list(rec, curve);
      curve = insert_knot(rec, curve, list, end, times).curve;
      changed = true;
    }
  }
  // Only what the domain sees remains, with p + 1 copies of each end.
  const auto knots = curve.U.values();
  const S a = knots[static_cast<std::size_t>(p)];
  const S b = knots[knots.size() - static_cast<std::size_t>(p) - 1];
  const int first = static_cast<int>(std::upper_bound(knots.begin(), knots.end(), a) - knots.begin()) - 1 - p;
  const int last = static_cast<int>(std::lower_bound(knots.begin(), knots.end(), b) - knots.begin()) - 1;
  MadeCurve<R> made;
  made.degree = p;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  const auto begin = curve.U[first + p];
  const auto end = curve.U[last + 1];
  for (int i = 0; i <= p; ++i) made.U.push_back(begin);
  for (int i = first + p + 1; i <= last; ++i) made.U.push_back(curve.U[i]);
  for (int i = 0; i <= p; ++i) made.U.push_back(end);
  for (int i = first; i <= last; ++i) made.P.push_back(curve.P[i]);
  return made;
}

template <class R>
bool is_clamped(const MadeCurve<R>& curve) {
  const int p = curve.degree;
  return curve.U[0].value == curve.U[p].value &&
         curve.U[curve.U.size() - 1].value == curve.U[curve.U.size() - p - 1].value;
}

}  // namespace compatible

// Preconditions: valid curves, at least one. Afterwards all have the same degree and the same knots, clamped.
template <class R>
void make_compatible(R& rec, std::vector<MadeCurve<R>>& curves) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int count = static_cast<int>(curves.size());
  const auto curve = [&](int l) -> MadeCurve<R>& { return curves[static_cast<std::size_t>(l)]; };

  for (int l = 0; l < count; ++l) {
    if (compatible::is_clamped<R>(curve(l))) continue;
    auto phase = rec.phase({"clamp", l, true});
    curve(l) = compatible::clamp(rec, std::move(curve(l)));
  }

  int p = 0;
  for (const auto& c : curves) p = std::max(p, c.degree);
  for (int l = 0; l < count; ++l) {
    if (curve(l).degree == p) continue;
    auto phase = rec.phase({"raise", l, true, "degree_elevation"});
    const auto times = rec.input("t"_v, p - curve(l).degree);
    curve(l) = elevate_degree(rec, curve(l), compatible::knot_list(rec, curve(l)), times);
  }

  const auto same_domain = [&](int l) {
    return curve(l).U[p].value == curve(0).U[p].value &&
           curve(l).U[curve(l).P.size()].value == curve(0).U[curve(0).P.size()].value;
  };
  bool one_domain = true;
  for (int l = 1; l < count; ++l) one_domain = one_domain && same_domain(l);
  if (!one_domain) {
    for (int l = 0; l < count; ++l) {
      auto phase = rec.phase({"domain", l, true});
      const auto& U = curve(l).U;
      const auto a = U[0];
      const auto b = U[U.size() - 1];
      Cells<S, Id> mapped;
      mapped.reserve(U.size());
      for (int i = 0; i < U.size(); ++i) mapped.push_back(rec.apply(Ratio{}, "U"_v(i), U[i], a, b));
      if constexpr (R::recording) {
        auto step = rec.one_step();
        for (int i = 0; i < curve(l).P.size(); ++i) {
          const auto before = curve(l).P[i].id;
          const auto point = rec.apply(Reparametrize{}, "P"_v(i), curve(l).P[i]);
          rec.retire(before);
          rec.polar_knots(point.id, mapped[i + 1].id, p);
          curve(l).P.set(i, point);
        }
      }
      curve(l).U = std::move(mapped);
    }
  }

  bool one_vector = true;
  for (int l = 1; l < count; ++l)
    one_vector = one_vector && std::ranges::equal(curve(l).U.values(), curve(0).U.values());
  if (one_vector) return;

  auto phase = rec.phase({"merge", -1, false});
  auto all = rec.apply(Gather{}, "W"_v(0), slice(curve(0).U, 0, curve(0).U.size()));
  for (int l = 1; l < count; ++l) {
    const auto own = rec.apply(Gather{}, "U"_v(l), slice(curve(l).U, 0, curve(l).U.size()));
    all = rec.apply(UniteKnots{}, "W"_v(l), all, own);
  }
  for (int l = 0; l < count; ++l) {
    if (curve(l).U.size() == static_cast<int>(all.value.size())) continue;
    auto phase_of_profile = rec.phase({"refine", l, true});
    int inserted = 0;
    Traced<std::vector<S>, Id> knots;
    for (std::size_t i = 0; i < all.value.size();) {
      const S u = all.value[i];
      const int wanted = multiplicity(std::span<const S>(all.value), u);
      const int missing = wanted - multiplicity(curve(l).U.values(), u);
      i += static_cast<std::size_t>(wanted);
      if (missing == 0) continue;
      auto inner = rec.phase({"knot", inserted, true, "knot_insertion"});
      const auto times = rec.input("h"_v, missing);
      const auto knot = rec.input("u"_v, u);
      const auto insert = [&](const auto& list) { return insert_knot(rec, curve(l), list, knot, times); };
      auto refined = R::recording && inserted > 0 ? insert(knots) : insert(compatible::knot_list(rec, curve(l)));
      curve(l) = std::move(refined.curve);
      knots = std::move(refined.knots);
      ++inserted;
    }
  }
}

}  // namespace blossom
