#pragma once
// Degree reduction (Forrest 1972; The NURBS Book 5.6, A5.11; Piegl and Tiller 1995): a curve of degree q = p - 1 close
// to a given one of degree p, with the same ends, and a bound E on the error.
//
// A Bezier curve with the points B[0..p]: if it were the elevated curve of Q[0..q],
//
//     B[i] = alpha[i] Q[i-1] + (1 - alpha[i]) Q[i],   alpha[i] = i/p,   i = 0..p.
//
// These are one equation more than points; they are solved from both ends up to the middle, r = floor((p-1)/2):
//     Q[i] = (B[i] - alpha[i] Q[i-1]) / (1 - alpha[i]),   Q[i-1] = (B[i] - (1 - alpha[i]) Q[i]) / alpha[i];
//   p even: all of Q comes out, and the equation left over is off by e = |B[r+1] - (Q[r] + Q[r+1]) / 2|;
//   p odd:  both sides know Q[r], as L and as R; Q[r] = (L + R) / 2, and e = (1 - alpha[r]) / 2 |L - R|.
// No point of the curve moves farther than e. Of a rational curve that holds for the homogeneous points.
//
// A B-spline curve, in phases: decompose (into Bezier segments), reduce (each of them), join: the joints are inner
// knots of multiplicity q now. As far as the tolerance allows they are removed again, each down to one copy less than
// it had, as reducing the degree of a curve with as many derivatives there asks for. E is the largest e plus the bounds
// of all removals. So a curve that was elevated before comes back exactly.

#include "kernel/degree_elevation.hpp"
#include "kernel/knot_removal.hpp"

namespace blossom {

// (A + B) / 2
struct HalfWay {
  static constexpr std::string_view name = "half_way";
  static constexpr std::string_view formula = "({0} + {1}) / 2";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B) {
    return (A + B) / S(2);
  }
};

// |B - (Q + R) / 2|, weights included
struct MissedMiddle {
  static constexpr std::string_view name = "missed_middle";
  static constexpr std::string_view formula = "|{0} - ({1} + {2}) / 2|";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& B, const HPoint<S>& Q, const HPoint<S>& R) {
    return removal::length<S>(B - (Q + R) / S(2));
  }
};

// (1 - a) / 2 |L - R|, weights included
struct SharedGap {
  static constexpr std::string_view name = "shared_gap";
  static constexpr std::string_view formula = "(1 - {0}) / 2 · |{1} - {2}|";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const HPoint<S>& L, const HPoint<S>& R) {
    return (S(1) - a) / S(2) * removal::length<S>(L - R);
  }
};

namespace reduction {

template <class R>
using PointCells = elevation::PointCells<R>;
template <class R>
using Numbers = Cells<typename R::Number, typename R::Id>;

// One segment, B[first..first+p], to Q[0..p-1], named by `name`; its error e[j]. `alpha[i]` stands at i - 1.
template <class R, class NameOf>
Traced<typename R::Number, typename R::Id> reduce_segment(R& rec, const PointCells<R>& B, int first, int p, int j,
                                                          const Numbers<R>& alpha, NameOf&& name, PointCells<R>& Q) {
  using Point = Traced<HPoint<typename R::Number>, typename R::Id>;
  const int r = (p - 1) / 2;
  std::vector<Point> made(static_cast<std::size_t>(p));
  const auto at = [&](int i) -> Point& { return made[static_cast<std::size_t>(i)]; };
  const auto given = [&](int i) { return B[first + i]; };
  const auto from_left = [&](int i, const Name& n) {
    return rec.apply(UnblendBegin{}, n, alpha[i - 1], given(i), at(i - 1));
  };
  const auto from_right = [&](int i, const Name& n) {
    return rec.apply(UnblendEnd{}, n, alpha[i], given(i + 1), at(i + 1));
  };
  const bool even = p % 2 == 0;
  at(0) = rec.apply(Relabel{}, name(0), given(0));
  at(p - 1) = rec.apply(Relabel{}, name(p - 1), given(p));
  for (int i = 1; i <= (even ? r : r - 1); ++i) at(i) = from_left(i, name(i));
  for (int i = p - 2; i > r; --i) at(i) = from_right(i, name(i));
  Traced<typename R::Number, typename R::Id> error{};
  if (even) {
    error = rec.apply(MissedMiddle{}, "e"_v(j), given(r + 1), at(r), at(r + 1));
  } else {
    const auto L = from_left(r, "L"_v(j));
    const auto right = from_right(r, "R"_v(j));
    at(r) = rec.apply(HalfWay{}, name(r), L, right);
    error = rec.apply(SharedGap{}, "e"_v(j), alpha[r - 1], L, right);
  }
  for (int i = 0; i < p; ++i) Q.push_back(at(i));
  if constexpr (R::recording)
    for (int i = 0; i <= p; ++i) rec.retire(given(i).id);
  return error;
}

// The polar labels of a segment's points over [a, b]: f(a^{q-i}, b^i).
template <class R>
void label_segment(R& rec, const PointCells<R>& Q, int first, int q, const typename R::Number& a,
                   const typename R::Number& b) {
  using S = typename R::Number;
  if constexpr (R::recording) {
    std::vector<S> arguments(static_cast<std::size_t>(q), a);
    for (int i = 0; i <= q; ++i) {
      if (i > 0) arguments[static_cast<std::size_t>(q - i)] = b;
      rec.polar_net(Q[first + i].id, std::span<const S>(arguments), {});
    }
  }
}

// The segments as one curve: each joint a knot of multiplicity q, or q + 1 where the curve jumps.
template <class R, class CurveIn>
MadeCurve<R> joined(const CurveIn& curve, const std::vector<int>& begins, const PointCells<R>& Q) {
  const int q = curve.degree - 1;
  MadeCurve<R> made;
  made.degree = q;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  const auto knot = [&](int at, int times) {
    for (int i = 0; i < times; ++i) made.U.push_back(curve.U[at]);
  };
  knot(begins.front(), q + 1);
  for (std::size_t part = 0; part < begins.size(); ++part) {
    const bool jump = part > 0 && begins[part] - begins[part - 1] > curve.degree;
    if (part > 0) knot(begins[part], jump ? q + 1 : q);
    const int skip = part > 0 && !jump ? 1 : 0;
    made.P.append(Q, static_cast<int>(part) * (q + 1) + skip, q + 1 - skip);
  }
  knot(begins.back() + 1, q + 1);
  return made;
}

// Takes the joints' knots out again, as far as they can go.
template <class R, class CurveIn, class Number>
MadeCurve<R> remove_joints(R& rec, const CurveIn& curve, const std::vector<int>& begins, MadeCurve<R> made,
                           const Number& tolerance, const Number& rounding, Numbers<R>& bounds) {
  using S = typename R::Number;
  int count = 0;
  auto knots = rec.apply(Gather{}, "Ubar"_v, slice(made.U, 0, made.U.size()));
  for (std::size_t part = 1; part < begins.size(); ++part) {
    const S u = curve.U[begins[part]].value;
    const int wanted = multiplicity(curve.U.values(), u) - 1;
    for (int copies = multiplicity(made.U.values(), u); copies > wanted; --copies) {
      auto phase = rec.phase({"removal", count++, true, "knot_removal"});
      const auto knot = rec.apply(SameNumber{}, "u"_v, curve.U[begins[part]]);
      auto tried = remove_knot(rec, std::move(made), std::move(knots), knot, tolerance, rounding);
      made = std::move(tried.curve);
      knots = std::move(tried.knots);
      if (!tried.removed) break;
      bounds.push_back(tried.bound);
    }
  }
  return made;
}

}  // namespace reduction

// Preconditions: a valid curve of degree at least 2, tolerance at least 0.
template <class R>
Curve<typename R::Number> degree_reduction(const Curve<typename R::Number>& curve, const typename R::Number& tolerance,
                                           R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int p = curve.degree;
  const int q = p - 1;
  const auto tol = rec.input("tol"_v, tolerance);
  const auto rounding = rec.input("eps"_v, rounding_of(std::span<const HPoint<S>>(curve.points)));
  const auto degree = rec.input("p"_v, p);
  rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  const auto begins = elevation::span_begins(given.U, p);
  const bool several = begins.size() > 1 || static_cast<int>(curve.points.size()) != p + 1 ||
                       !(curve.knots.front() == curve.domain_begin()) || !(curve.knots.back() == curve.domain_end());

  elevation::PointCells<R> B, Q;
  if (several) {
    auto phase = rec.phase({"decompose"});
    B = elevation::decompose(rec, given, begins);
  } else {
    B.append(given.P, 0, p + 1);
  }

  Cells<S, Id> errors, bounds;
  {
    auto phase = rec.phase({"reduce"});
    Cells<S, Id> alpha;
    for (int i = 1; i < p; ++i) alpha.push_back(rec.apply(Fraction{}, "alpha"_v(i), rec.input("i"_v(i), i), degree));
    for (int j = 0; j < static_cast<int>(begins.size()); ++j) {
      const auto name = [&](int i) { return several ? "Q"_v(j, i) : "Q"_v(i); };
      errors.push_back(reduction::reduce_segment(rec, B, j * (p + 1), p, j, alpha, name, Q));
      const auto begin = static_cast<std::size_t>(begins[static_cast<std::size_t>(j)]);
      reduction::label_segment(rec, Q, j * p, q, curve.knots[begin], curve.knots[begin + 1]);
    }
  }
  bounds.push_back(rec.apply(Largest{}, several ? "E"_v(0) : "E"_v(), slice(errors, 0, errors.size())));

  auto made = reduction::joined<R>(given, begins, Q);
  if (several) {
    {
      auto phase = rec.phase({"join"});
      made = reduction::remove_joints(rec, given, begins, std::move(made), tol, rounding, bounds);
    }
    auto phase = rec.phase({"collect"});
    rec.apply(Total{}, "E"_v, slice(bounds, 0, bounds.size()));
    if constexpr (R::recording) {
      auto step = rec.one_step();
      for (int i = 0; i < made.P.size(); ++i) {
        const auto point = rec.apply(Relabel{}, "Q"_v(i), made.P[i]);
        rec.polar_net(point.id, made.U.values().subspan(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(q)),
                      {});
      }
    }
  }
  const int count = made.P.size();
  auto plain = plain_curve<R>(std::move(made), 0, count);
  plain.bezier = curve.bezier;
  return plain;
}

}  // namespace blossom
