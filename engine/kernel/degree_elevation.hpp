#pragma once
// Degree elevation (Forrest 1972; The NURBS Book 5.5): the same curve, one degree higher, `times` times.
//
// A Bezier curve:  Q[i] = i/(p+1) P[i-1] + (1 - i/(p+1)) P[i],  i = 0..p+1.
//
// A B-spline curve, in three phases (NB 5.5, with another third phase):
//   decompose  every knot of the domain is inserted up to multiplicity p, so that the curve falls into Bezier segments;
//   elevate    each segment j is elevated by the formula above: E[j][i];
//   recompose  the control points over the elevated knot vector V, in which the multiplicity of each knot has grown by
//              `times` and no more, are blossom values of the segments (Ramshaw): Q[j] = f(v_{j+1}, ..., v_{j+q}),
//              q = p + times. Arguments other than the segment's two ends a, b are put in one by one,
//                  f(..., c) = (1 - beta) f(..., a) + beta f(..., b),  beta = (c - a) / (b - a),
//              in the longest segment the point can be read from, which keeps beta small. (The book removes knots here
//              instead; this needs fewer steps and no tolerance.)

#include <utility>

#include "kernel/knot_insertion.hpp"

namespace blossom {

// i/(p+1) A + (1 - i/(p+1)) B
struct Elevate {
  static constexpr std::string_view name = "elevate";
  static constexpr std::string_view formula = "{0} {1} + (1 - {0}) {2}";
  static constexpr Polar polar = Polar::merge;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A, const HPoint<S>& B) {
    return Blend::apply<S>(a, B, A);
  }
};

// The ends stay: f(a, ..., a) with one argument more is the same point.
struct ElevateEnd {
  static constexpr std::string_view name = "elevate_end";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::repeat;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// The knots of the elevated curve: over the domain, every knot `times` more often than before.
struct ElevateKnots {
  static constexpr std::string_view name = "elevate_knots";
  static constexpr std::string_view formula = "each knot of {2} {1} times more (degree {0})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(int p, int times, std::span<const S> U) {
    std::vector<S> V;
    V.reserve(U.size() * (1 + static_cast<std::size_t>(times)));
    for (std::size_t i = 0; i < U.size(); ++i) {
      V.push_back(U[i]);
      if (i + 1 == U.size() || U[i] < U[i + 1]) V.insert(V.end(), static_cast<std::size_t>(times), U[i]);
    }
    // Unclamped ends: just q knots up to the last copy of the domain's begin remain before it, and likewise behind.
    const std::size_t q = static_cast<std::size_t>(p) + static_cast<std::size_t>(times);
    const S& a = U[static_cast<std::size_t>(p)];
    const S& b = U[U.size() - static_cast<std::size_t>(p) - 1];
    const std::size_t begin = static_cast<std::size_t>(std::upper_bound(V.begin(), V.end(), a) - V.begin()) - 1;
    const std::size_t end = static_cast<std::size_t>(std::lower_bound(V.begin(), V.end(), b) - V.begin());
    V.erase(V.begin() + static_cast<std::ptrdiff_t>(end + q + 1), V.end());
    V.erase(V.begin(), V.begin() + static_cast<std::ptrdiff_t>(begin - q));
    return V;
  }
  template <Scalar S>
  static bool defined(int p, int times, std::span<const S> U) {
    return p >= 1 && times >= 0 && times <= max_degree && U.size() >= 2 * static_cast<std::size_t>(p) + 2 &&
           std::is_sorted(U.begin(), U.end()) &&
           U[static_cast<std::size_t>(p)] < U[U.size() - static_cast<std::size_t>(p) - 1];
  }
};

namespace elevation {

// One nonempty span [u_a, u_b] of the domain: a the last copy of its begin, b = a + 1 the first of its end.
template <class Knots>
std::vector<int> span_begins(const Knots& U, int p) {
  std::vector<int> begins;
  const auto knots = U.values();
  for (std::size_t a = static_cast<std::size_t>(p); a + static_cast<std::size_t>(p) + 1 < knots.size(); ++a)
    if (knots[a] < knots[a + 1]) begins.push_back(static_cast<int>(a));
  return begins;
}

// The knots seen from one span, [u_a, u_{a+1}]: u_a p + 1 times, then those behind.
template <class Knots>
struct Window {
  const Knots& U;
  int a, p;
  auto operator[](int i) const { return U[i <= p ? a : a + i - p]; }
};

template <class R>
using PointCells = Cells<HPoint<typename R::Number>, typename R::Id>;

// The Bezier points f(a^{p-i}, b^i) of every segment, p + 1 each, one segment behind the other. Runs from left to right
// in a window W_j = f(a^{p-j}, v_1, ..., v_j) (v: the knots behind a), so that n points cost O(n).
template <class R, class CurveIn>
PointCells<R> decompose(R& rec, const CurveIn& curve, const std::vector<int>& begins) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto& U = curve.U;
  const int p = curve.degree;
  const auto multiplicity_from = [&](int i, int step) {  // of the knot at i, counted from there, at most p
    int s = 1;
    while (s < p && i + s * step >= 0 && i + s * step < U.size() && U[i + s * step].value == U[i].value) ++s;
    return s;
  };
  PointCells<R> B;
  B.reserve(static_cast<int>(begins.size()) * (p + 1));
  TriangleRow<R> W, row, right;
  const auto entry = [](TriangleRow<R> & r, int j) -> auto& { return r[static_cast<std::size_t>(j)]; };
  const auto given = [&](int i) { return Traced<HPoint<S>, Id>{curve.P[i].value, curve.P[i].id}; };
  const auto parameter = [&](int i) { return Ref<S, Id>{U[i].value, U[i].id}; };

  // The first window. On a clamped curve these are the given points; otherwise the domain's begin is inserted.
  const int a0 = begins.front();
  int s = multiplicity_from(a0, -1);
  for (int j = p - s; j <= p; ++j) entry(W, j) = given(a0 - p + j);
  if (s < p) {
    auto phase = rec.phase({"knot", 0, true, "knot_insertion"});
    for (int j = 0; j <= p - s; ++j) entry(row, j) = given(a0 - p + j);
    triangle(rec, U, parameter(a0), row, p, s, a0 - s, p - s, {"Q"_v, 0, true},
             [&](int r) { entry(W, p - s - r) = entry(row, p - s); });
  }

  int shift = a0 - s;  // where W_0 stands in the curve refined so far
  for (std::size_t part = 0; part < begins.size(); ++part) {
    const int a = begins[part];
    s = multiplicity_from(a + 1, 1);
    // W_0..W_s are Bezier points already. Inserting b = v_1 = ... = v_s until it has multiplicity p gives the others on
    // the left edge of the triangle, and the next window on the right edge.
    for (int j = 0; j < s; ++j) B.push_back(entry(W, j));
    for (int j = 0; j <= p - s; ++j) entry(row, j) = entry(W, s + j);
    entry(right, 0) = entry(row, p - s);
    if (s < p) {
      auto phase = rec.phase({"knot", static_cast<int>(part) + 1, true, "knot_insertion"});
      const Window<std::remove_cvref_t<decltype(U)>> L{U, a, p};
      triangle(rec, L, parameter(a + 1), row, p, s, p, p - s, {"Q"_v, shift, true},
               [&](int r) { entry(right, r) = entry(row, p - s); });
    }
    for (int j = 0; j <= p - s; ++j) B.push_back(entry(row, j));
    if (part + 1 == begins.size()) break;

    const int next = begins[part + 1];
    for (int r = 0; r <= p - s; ++r) entry(W, p - s - r) = entry(right, r);
    for (int j = s < p ? p - s + 1 : 0; j <= p; ++j) entry(W, j) = given(next - p + j);
    shift += next - a > p ? p + 1 : p;  // a knot of multiplicity p + 1 has two points of its own
  }
  return B;
}

// The knots V as values: each is the knot of U it repeats.
template <class Made, class Knots, class S>
void name_knots(Made& made, const Knots& U, const std::vector<S>& V) {
  made.reserve(static_cast<int>(V.size()));
  int i = 0;
  for (const S& v : V) {
    while (U[i].value < v) ++i;
    made.push_back(U[i]);
  }
}

// Each run of p + 1 points one degree higher, `times` times: the Bezier formula on each segment. The last round's
// values are called `point`, with the segment as first index when there are several.
template <class End, class R>
PointCells<R> elevate_segments(R& rec, PointCells<R> B, int p, int times, bool several) {
  using S = typename R::Number;
  using Id = typename R::Id;
  for (int t = 1; t <= times; ++t, ++p) {
    auto round = rec.phase({"round", t, t < times});
    const int segments = B.size() / (p + 1);
    const auto one = rec.input("q"_v, p + 1);
    Cells<S, Id> alpha;  // alpha[i] at i - 1
    alpha.reserve(p);
    for (int i = 1; i <= p; ++i) alpha.push_back(rec.apply(Fraction{}, "alpha"_v(i), rec.input("i"_v(i), i), one));
    PointCells<R> E;
    E.reserve(segments * (p + 2));
    for (int j = 0; j < segments; ++j) {
      const int first = j * (p + 1);
      const auto name = [&](int i) { return several ? "E"_v(j, i) : "Q"_v(i); };
      E.push_back(rec.apply(End{}, name(0), B[first]));
      for (int i = 1; i <= p; ++i)
        E.push_back(rec.apply(Elevate{}, name(i), alpha[i - 1], B[first + i - 1], B[first + i]));
      E.push_back(rec.apply(End{}, name(p + 1), B[first + p]));
      if constexpr (R::recording)
        for (int i = 0; i <= p; ++i) rec.retire(B[first + i].id);
    }
    B = std::move(E);
  }
  return B;
}

// The points Q[j] = f(v_{j+1}, ..., v_{j+q}) over the elevated knots V. Q[j] can be read from any segment inside
// [v_j, v_{j+q+1}]. The long ones are well-conditioned (small beta); of those, the one that needs the fewest steps is
// taken, and of several the first. "Long" is at least 1/1.618034 of the longest: a ratio that nobody's knots have, so
// that rounding never decides and every scalar takes the same steps.
template <class R, class Knots>
PointCells<R> recompose(R& rec, const PointCells<R>& E, const Knots& U, const std::vector<int>& begins, int q,
                        std::span<const typename R::Number> V) {
  using S = typename R::Number;
  const S golden = S(1618034) / S(1000000);
  const int count = static_cast<int>(V.size()) - q - 1;
  const auto knot = [&](int i) -> const S& { return V[static_cast<std::size_t>(i)]; };
  const auto begin_of = [&](int part) { return U[begins[static_cast<std::size_t>(part)]]; };
  const auto end_of = [&](int part) { return U[begins[static_cast<std::size_t>(part)] + 1]; };
  const auto others_of = [&](int part, int j) {  // arguments of Q[j] that are no end of this segment
    int found = 0;
    for (int i = j + 1; i <= j + q; ++i)
      found += knot(i) == begin_of(part).value || knot(i) == end_of(part).value ? 0 : 1;
    return found;
  };
  const int parts = static_cast<int>(begins.size());
  std::vector<S> length;
  length.reserve(begins.size());
  for (int part = 0; part < parts; ++part) length.push_back(end_of(part).value - begin_of(part).value);

  PointCells<R> Q;
  Q.reserve(count);
  TriangleRow<R> row;
  std::array<int, max_degree + 1> others{};  // arguments that are no end of the segment, as indices into U
  int first_part = 0;
  int first_in_U = 0;  // the first knot of U that is not below v_{j+1}
  for (int j = 0; j < count; ++j) {
    while (U[first_in_U].value < knot(j + 1)) ++first_in_U;
    while (first_part + 1 < parts && begin_of(first_part).value < knot(j)) ++first_part;
    int last_part = first_part;
    while (last_part + 1 < parts && !(knot(j + q + 1) < end_of(last_part + 1).value)) ++last_part;
    const S longest = *std::max_element(length.begin() + first_part, length.begin() + last_part + 1);
    int best = -1;
    int fewest = q + 1;
    for (int part = first_part; part <= last_part && fewest > 0; ++part) {
      if (golden * length[static_cast<std::size_t>(part)] < longest) continue;
      if (const int needed = others_of(part, j); needed < fewest) {
        best = part;
        fewest = needed;
      }
    }
    const auto a = begin_of(best);
    const auto b = end_of(best);
    int at_b = 0;
    int extra = 0;
    int in_U = first_in_U;
    for (int i = j + 1; i <= j + q; ++i) {
      if (knot(i) == b.value) {
        ++at_b;
      } else if (!(knot(i) == a.value)) {
        while (U[in_U].value < knot(i)) ++in_U;
        others[static_cast<std::size_t>(extra++)] = in_U;
      }
    }
    const int first = best * (q + 1) + at_b;
    if (extra == 0) {
      Q.push_back(rec.apply(Same{}, "Q"_v(j), E[first]));
      continue;
    }
    auto phase = rec.phase({"point", j, true});
    for (int i = 0; i <= extra; ++i) row[static_cast<std::size_t>(i)] = {E[first + i].value, E[first + i].id};
    for (int r = 1; r <= extra; ++r) {
      const auto beta = rec.apply(Ratio{}, "beta"_v(r), U[others[static_cast<std::size_t>(r) - 1]], a, b);
      for (int i = 0; i <= extra - r; ++i) {
        auto& left = row[static_cast<std::size_t>(i)];
        left = rec.apply(Blend{}, r == extra ? outer("Q"_v(j)) : "R"_v(r, i), beta, left,
                         row[static_cast<std::size_t>(i) + 1]);
      }
    }
    Q.push_back(row[0]);
  }
  if constexpr (R::recording)
    for (int i = 0; i < E.size(); ++i) rec.retire(E[i].id);
  return Q;
}

}  // namespace elevation

// Preconditions: a valid curve, times >= 1, degree + times <= max_degree. `knots` is the knot vector as one value; End
// the rule of the points that stay.
template <class End = ElevateEnd, class R, class CurveIn, class KnotList, class Times>
MadeCurve<R> elevate_degree(R& rec, const CurveIn& curve, const KnotList& knots, const Times& times) {
  const int p = curve.degree;
  const int q = p + times.value;
  const auto begins = elevation::span_begins(curve.U, p);
  const bool one_segment = curve.P.size() == p + 1 && curve.U[0].value == curve.U[p].value &&
                           curve.U[p + 1].value == curve.U[curve.U.size() - 1].value;

  MadeCurve<R> made;
  made.degree = q;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  const auto degree = rec.input("p"_v, p);
  if (one_segment) {
    elevation::PointCells<R> B;
    B.reserve(p + 1);
    for (int i = 0; i <= p; ++i) B.push_back(curve.P[i]);
    made.P = elevation::elevate_segments<End>(rec, std::move(B), p, times.value, false);
  } else {
    elevation::PointCells<R> B, E;
    {
      auto phase = rec.phase({"decompose"});
      B = elevation::decompose(rec, curve, begins);
    }
    {
      auto phase = rec.phase({"elevate"});
      E = elevation::elevate_segments<End>(rec, std::move(B), p, times.value, true);
    }
    auto phase = rec.phase({"recompose"});
    const auto V = rec.apply(ElevateKnots{}, "V"_v, degree, times, knots);
    made.P = elevation::recompose(rec, E, curve.U, begins, q, std::span<const typename R::Number>(V.value));
    elevation::name_knots(made.U, curve.U, V.value);
    return made;
  }
  const auto V = rec.apply(ElevateKnots{}, "V"_v, degree, times, knots);
  elevation::name_knots(made.U, curve.U, V.value);
  return made;
}

// The whole algorithm on a curve.
template <class R>
Curve<typename R::Number> degree_elevation(const Curve<typename R::Number>& curve, int times, R& rec) {
  const auto t = rec.input("t"_v, times);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  auto elevated = elevate_degree(rec, given, knots, t);
  const int count = elevated.P.size();
  auto made = plain_curve<R>(std::move(elevated), 0, count);
  made.bezier = curve.bezier;
  return made;
}

}  // namespace blossom
