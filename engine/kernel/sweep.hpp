#pragma once
// Sweeping (The NURBS Book 10.4, A10.1, with rotation-minimising frames): S(u, v) = T(v) + M(v) P(u). Such a surface is
// no NURBS surface in general, so it is approximated:
//
//   sections  the profile placed in the frame of the trajectory at v_0..v_K: at its knots, and evenly spaced between;
//   skin      the surface through the sections (skinning), of degree 3 across them or less, S(u, v_l) exact;
//   error     how far the surface is from the true sweep halfway between neighbouring sections: the largest distance of
//             corresponding control points there. As the basis functions are positive and sum up to 1, no point of the
//             profile, of positive weights, is farther away at these v.
//
// With sections = 0 the number of sections between knots is doubled until the error is at most the tolerance, or more
// than 64 sections would be needed. At a corner of the trajectory the frame behind it counts.

#include <optional>

#include "kernel/skinning.hpp"
#include "kernel/sweep_frame.hpp"
#include "kernel/tolerance.hpp"

namespace blossom {

inline constexpr int most_sections = 64;

namespace sweeping {

// What every attempt shares.
template <class R>
struct Sweep {
  MadeCurve<R> profile, trajectory;
  Traced<int, typename R::Id> q;                              // the trajectory's degree
  Traced<std::vector<typename R::Number>, typename R::Id> V;  // its knots
  std::vector<int> breaks;                                    // where each distinct knot of the domain stands in V
  bool fixed = false;                                         // all frames are the first
};

template <class R>
struct Attempt {
  Cells<typename R::Number, typename R::Id> v;
  std::vector<Frame<R>> frames;
  skin::Lofted<R> skin;
  Traced<typename R::Number, typename R::Id> error;
};

template <class R>
Cells<typename R::Number, typename R::Id> parameters(R& rec, const Sweep<R>& sweep, int parts) {
  auto phase = rec.phase({"parameters"});
  Cells<typename R::Number, typename R::Id> v;
  const auto m = rec.input("m"_v, parts);
  const auto& knots = sweep.trajectory.U;
  for (std::size_t s = 0; s < sweep.breaks.size(); ++s) {
    v.push_back(rec.apply(SameNumber{}, "v"_v(v.size()), knots[sweep.breaks[s]]));
    if (s + 1 == sweep.breaks.size()) break;
    for (int i = 1; i < parts; ++i) {
      const auto share = rec.input("i"_v(v.size()), i);
      v.push_back(
          rec.apply(SpanShare{}, "v"_v(v.size()), share, m, knots[sweep.breaks[s]], knots[sweep.breaks[s + 1]]));
    }
  }
  return v;
}

// The frame at v, seen from the one before; with none before it, the first.
template <class R, class Parameter>
Frame<R> frame_at(R& rec, const Sweep<R>& sweep, const Parameter& v, const Frame<R>* before) {
  Frame<R> frame;
  locate(rec, sweep.trajectory, sweep.q, sweep.V, v, frame);
  if (before == nullptr) {
    frame.n = rec.apply(FirstNormal{}, "n"_v, frame.t);
    frame.b = rec.apply(CrossProduct{}, "b"_v, frame.t, frame.n);
  } else if (sweep.fixed) {
    frame.t = before->t, frame.n = before->n, frame.b = before->b;
  } else {
    carry(rec, *before, frame);
  }
  return frame;
}

// The largest distance between the skin and the true sweep in the middle between the sections l and l + 1.
template <class R, class Degree, class KnotList>
Traced<typename R::Number, typename R::Id> deviation(R& rec, const Sweep<R>& sweep, const Attempt<R>& attempt, int l,
                                                     const Degree& degree, const KnotList& knots) {
  using S = typename R::Number;
  auto phase = rec.phase({"middle", l, true});
  const auto v = rec.apply(Mean{}, "v"_v, slice(attempt.v, l, 2));
  const auto frame = frame_at(rec, sweep, v, &attempt.frames[static_cast<std::size_t>(l)]);
  const int k = row_span(std::span<const S>(knots.value), degree.value, v.value);
  Cells<S, typename R::Id> M, distances;
  for (int j = k - degree.value; j <= k; ++j)
    M.push_back(rec.apply(BasisValue{}, "M"_v(j), rec.input("i"_v(j), j), degree, v, knots));
  for (int i = 0; i < sweep.profile.P.size(); ++i) {
    if (sweep.profile.P[i].value.w == S(0)) continue;  // no point, no distance
    TracedPoint<R> A{};
    for (int j = 0; j <= degree.value; ++j) {
      const auto Q = attempt.skin.net.at(i, k - degree.value + j);
      const auto name = "A"_v(i, k - degree.value + j);
      A = j == 0 ? rec.apply(WeighPoint{}, name, M[j], Q) : rec.apply(AddWeighed{}, name, A, M[j], Q);
    }
    const auto B = rec.apply(PlaceInFrame{}, "B"_v(i), sweep.profile.P[i], frame.X, frame.t, frame.n, frame.b);
    distances.push_back(rec.apply(Distance{}, "e"_v(i), A, B));
  }
  if (distances.size() == 0) throw KernelError{"profile", "has control points of weight 0 only"};
  return rec.apply(Largest{}, outer("e"_v(l)), slice(distances, 0, distances.size()));
}

template <class R>
Attempt<R> attempt(R& rec, const Sweep<R>& sweep, int parts) {
  Attempt<R> made{parameters(rec, sweep, parts), {}, {{}, construct::Net<R>(0, 0)}, {}};
  const int K = made.v.size() - 1;
  std::vector<MadeCurve<R>> sections;
  {
    auto phase = rec.phase({"sections"});
    made.frames.reserve(static_cast<std::size_t>(K) + 1);
    for (int l = 0; l <= K; ++l) {
      auto section_phase = rec.phase({"section", l, true});
      made.frames.push_back(frame_at(rec, sweep, made.v[l], l == 0 ? nullptr : &made.frames.back()));
      const auto& frame = made.frames.back();
      MadeCurve<R> section;
      for (int i = 0; i < sweep.profile.P.size(); ++i)
        section.P.push_back(
            rec.apply(PlaceInFrame{}, outer("R"_v(l, i)), sweep.profile.P[i], frame.X, frame.t, frame.n, frame.b));
      sections.push_back(std::move(section));
    }
  }
  const auto degree = rec.input("q"_v, std::min(3, K));
  {
    auto phase = rec.phase({"skin", -1, true, "skinning"});
    made.skin = skin::interpolate(rec, sections, made.v, degree);
  }
  auto phase = rec.phase({"errors"});
  const auto& knots = made.skin.knots;
  const auto list = rec.apply(Gather{}, "W"_v, slice(knots, 0, knots.size()));
  Cells<typename R::Number, typename R::Id> e;
  for (int l = 0; l < K; ++l) e.push_back(deviation(rec, sweep, made, l, degree, list));
  made.error = rec.apply(Largest{}, "e"_v, slice(e, 0, K));
  return made;
}

}  // namespace sweeping

// Preconditions: valid curves; a trajectory that does not jump; sections 0 or at least 2, tolerance > 0. Errors: see
// sweeping::locate and sweeping::carry.
template <class R>
Surface<typename R::Number> sweep(const Curve<typename R::Number>& profile, const Curve<typename R::Number>& trajectory,
                                  bool fixed, int sections, const typename R::Number& tolerance, R& rec) {
  using S = typename R::Number;
  const auto epsilon = rec.input("tol"_v, tolerance);
  sweeping::Sweep<R> sweep;
  sweep.fixed = fixed;
  sweep.profile = construct::given(rec, profile, -1, "U"_v, "P"_v);
  sweep.trajectory = construct::given(rec, trajectory, -1, "V"_v, "T"_v);
  if (!compatible::is_clamped<R>(sweep.trajectory)) {
    auto phase = rec.phase({"clamp", 1, true});
    sweep.trajectory = compatible::clamp(rec, std::move(sweep.trajectory));
  }
  sweep.q = rec.input("p"_v, trajectory.degree);
  const auto& knots = sweep.trajectory.U;
  sweep.V = rec.apply(Gather{}, "V"_v, slice(knots, 0, knots.size()));
  for (int j = 0; j < knots.size(); ++j)
    if (j == 0 || sweep.V.value[static_cast<std::size_t>(j) - 1] < knots[j].value) sweep.breaks.push_back(j);

  const int spans = static_cast<int>(sweep.breaks.size()) - 1;
  const bool by_tolerance = sections == 0;
  const int wanted = by_tolerance ? 4 : sections;
  int parts = (wanted - 1 + spans - 1) / spans;
  const S enough = epsilon.value + rounding_of<S>(trajectory.points);
  std::optional<sweeping::Attempt<R>> made;
  for (int round = 0;; ++round, parts *= 2) {
    auto phase = rec.phase({"attempt", round, by_tolerance});
    made = sweeping::attempt(rec, sweep, parts);
    if (!by_tolerance || made->error.value <= enough || 2 * parts * spans + 1 > most_sections) break;
  }

  auto phase = rec.phase({"result"});
  rec.apply(SameNumber{}, "error"_v, made->error);
  auto& net = made->skin.net;
  {
    auto step = rec.one_step();
    for (int i = 0; i < net.rows; ++i)
      for (int j = 0; j < net.columns; ++j) net.set(i, j, rec.apply(PutIntoNet{}, "Q"_v(i, j), net.at(i, j)));
  }
  const int across = std::min(3, net.columns - 1);
  return construct::surface(rec, std::move(net), profile.degree, sweep.profile.U.values(), across,
                            std::span<const S>(made->skin.knots.values()), profile.rational);
}

}  // namespace blossom
