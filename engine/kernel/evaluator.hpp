#pragma once
// Evaluators: for many points of one curve or surface, in double.
//
// What depends on the knots only is computed once: the reciprocals of the knot differences (then no evaluation divides,
// but for the weight), and a table of equal buckets over the domain that leads to the span in O(1) for knots that are
// spread at all evenly, O(log n) for any. An evaluator holds a copy of the geometry.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/geometry.hpp"
#include "kernel/basis.hpp"
#include "kernel/blossom.hpp"
#include "kernel/derivatives.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/span.hpp"

namespace blossom {

// The nonempty spans of a knot vector, numbered from 0, with their reciprocals.
class SpanTable {
 public:
  SpanTable(Knots<double> U, int p) : knots_(U.begin(), U.end()), degree_(p), reciprocals_per_span_(p * (p + 1) / 2) {
    const int n = static_cast<int>(U.size()) - p - 2;
    for (int k = p; k <= n; ++k) {
      if (!(knots_[k] < knots_[k + 1])) continue;
      span_.push_back(k);
      begin_.push_back(knots_[k]);
    }
    assert(!span_.empty());
    reciprocals_.resize(span_.size() * reciprocals_per_span_);
    for (int s = 0; s < count(); ++s) {
      detail::knot_reciprocals<0>(knots_.data() + span_[s], p, reciprocals_.data() + s * reciprocals_per_span_);
    }
    fill_buckets(knots_[n + 1]);
  }

  int count() const { return static_cast<int>(span_.size()); }
  int span(int number) const { return span_[number]; }
  const double* knots_from(int number) const { return knots_.data() + span_[number]; }  // u_k, u_{k+1}, ...
  const double* reciprocals(int number) const { return reciprocals_.data() + number * reciprocals_per_span_; }
  int degree() const { return degree_; }
  double length() const { return length_; }  // of the domain

  // The number of the span that find_span finds. Precondition: u in the domain.
  int find(double u) const {
    const int b = bucket(u);
    const int first = first_[b];
    const int last = first_[b + 1];
    // At most one span begins within nearly every bucket; one comparison without a branch settles those.
    const int found = first + static_cast<int>(begin_[first + 1] <= u);
    return last - first <= 1 ? found : detail::last_not_above(begin_.data(), first, last, u);
  }

 private:
  static constexpr int buckets_per_span = 4;

  // In this order std::min also takes a NaN (infinity times 0, on a domain longer than the largest double) to the end.
  int bucket(double u) const { return static_cast<int>(std::min(last_bucket_, (u - begin_.front()) * scale_)); }

  // first_[b]: the last span that begins in a bucket before b (the first span for b = 0). So the span of a u in bucket
  // b is one of first_[b]..first_[b+1]: rounding in bucket() does no harm, as it is monotone.
  void fill_buckets(double domain_end) {
    length_ = domain_end - begin_.front();
    const int buckets = buckets_per_span * count();
    last_bucket_ = buckets - 1;
    scale_ = buckets / length_;
    if (!std::isfinite(scale_)) scale_ = 0;  // a tiny domain: all in bucket 0, and a binary search
    first_.assign(buckets + 1, 0);
    for (int s = 1; s < count(); ++s) first_[bucket(begin_[s]) + 1] = s;
    for (int b = 1; b <= buckets; ++b) first_[b] = std::max(first_[b], first_[b - 1]);
    begin_.push_back(std::numeric_limits<double>::infinity());
  }

  std::vector<double> knots_;
  int degree_;
  int reciprocals_per_span_;
  std::vector<int> span_;            // k
  std::vector<double> begin_;        // u_k; then infinity
  std::vector<double> reciprocals_;  // as detail::knot_reciprocals, span after span
  double length_ = 0;
  double last_bucket_ = 0;
  double scale_ = 0;  // buckets per unit of u
  std::vector<int> first_;
};

// Points come from the Bezier form of each span. With its control points b_i and t = (u - u_k) / (u_{k+1} - u_k),
//
//   C^w(u) = sum_i binom(p,i) (1-t)^(p-i) t^i b_i
//
// takes O(p) operations by Horner's rule (Farin, Curves and Surfaces for CAGD, section 5.1), where the basis functions
// take O(p^2). All terms have the sign of their b_i: rounding is as harmless as in de Casteljau's algorithm. The first
// half of the terms is summed by powers of 1-t from the front, the second by powers of t from the back: two chains of
// half the length, which a processor works on side by side.
class CurveEvaluator {
 public:
  explicit CurveEvaluator(const Curve<double>& curve)
      : spans_(curve.knots, curve.degree),
        points_(curve.points),
        weighted_(std::ranges::any_of(points_, [](const auto& P) { return P.w != 1; })) {
    const int p = curve.degree;
    for (int s = 0; s < spans_.count(); ++s) {
      const double* Uk = spans_.knots_from(s);
      pieces_.push_back({Uk[0], 1 / (Uk[1] - Uk[0])});
      for (int i = 0; i <= p; ++i) {
        // b_i is the blossom at p - i times the left end and i times the right end.
        std::array<double, max_degree> ends;
        std::fill_n(ends.begin(), p, Uk[0]);
        std::fill_n(ends.begin(), i, Uk[1]);
        const auto b = blossom<double>(curve, spans_.span(s), std::span(ends.data(), static_cast<std::size_t>(p)));
        scaled_.push_back(b * static_cast<double>(detail::binomial[p][i]));
      }
    }
  }

  HPoint<double> homogeneous_point(double u) const {
    const int s = spans_.find(u);
    return detail::with_degree<double>(spans_.degree(), [&](auto P) {
      const int p = P() > 0 ? P() : spans_.degree();
      const HPoint<double>* b = scaled_.data() + static_cast<std::ptrdiff_t>(s) * (p + 1);
      const double t = (u - pieces_[s].begin) * pieces_[s].reciprocal;
      const double r = 1 - t;
      const int middle = p / 2;
      double powers_of_t = 1;
      detail::Blend<double> C(b[0], 1);
      for (int i = 1; i <= middle; ++i) {
        powers_of_t *= t;
        C = detail::Blend<double>(C, r);
        C.add(b[i], powers_of_t);
      }
      double powers_of_r = 1;
      detail::Blend<double> back(b[p], 1);
      for (int i = p - 1; i > middle; --i) {
        powers_of_r *= r;
        back = detail::Blend<double>(back, t);
        back.add(b[i], powers_of_r);
      }
      C = detail::Blend<double>(C, powers_of_r * r);
      C.add(back, powers_of_t * t);
      return C.point();
    });
  }

  std::optional<Point<double>> point(double u) const {
    const HPoint<double> C = homogeneous_point(u);
    if (weighted_) return affine_point(C);
    const auto P = detail::xyz(C);
    return is_finite(P) ? std::optional(P) : std::nullopt;
  }

  // As the function derivatives(curve, u, d, C).
  [[nodiscard]] bool derivatives(double u, int d, std::span<Point<double>> C) const {
    assert(d >= 0 && d <= max_degree && C.size() > static_cast<std::size_t>(d));
    const int p = spans_.degree();
    const int s = spans_.find(u);
    const HPoint<double>* points = points_.data() + (spans_.span(s) - p);
    return detail::with_degree<double>(p, [&](auto P) {
      return detail::curve_derivatives<P()>(spans_.knots_from(s), p, spans_.reciprocals(s), points, u, d, C.data());
    });
  }

 private:
  struct Piece {
    double begin, reciprocal;  // u_k and 1 / (u_{k+1} - u_k)
  };

  SpanTable spans_;
  std::vector<HPoint<double>> points_;
  bool weighted_;  // some weight is not 1
  std::vector<Piece> pieces_;
  std::vector<HPoint<double>> scaled_;  // binom(p,i) b_i, span after span
};

class SurfaceEvaluator {
  struct Place {
    int p, q;
    const double *Uk, *Vl, *reciprocals_u, *reciprocals_v;
    const HPoint<double>* points;  // P_{k-p, l-q}
  };

  Place find(double u, double v) const {
    const auto [p, q] = surface_.degree;
    const int s = spans_[0].find(u);
    const int t = spans_[1].find(v);
    return {p,
            q,
            spans_[0].knots_from(s),
            spans_[1].knots_from(t),
            spans_[0].reciprocals(s),
            spans_[1].reciprocals(t),
            &surface_.at(spans_[0].span(s) - p, spans_[1].span(t) - q)};
  }

  // The unrolled loops serve surfaces of the same degree in both directions.
  template <class F>
  auto with_degrees(F&& f) const {
    return detail::with_degree<double>(surface_.degree[0] == surface_.degree[1] ? surface_.degree[0] : 0, f);
  }

 public:
  explicit SurfaceEvaluator(Surface<double> surface)
      : surface_(std::move(surface)),
        spans_{SpanTable(surface_.knots[0], surface_.degree[0]), SpanTable(surface_.knots[1], surface_.degree[1])} {}

  HPoint<double> homogeneous_point(double u, double v) const {
    const Place at = find(u, v);
    return with_degrees([&](auto P) {
      detail::BasisRow<double> M, N;
      detail::basis_on_span<P()>(at.Uk, at.p, u, at.reciprocals_u, M.data());
      detail::basis_on_span<P()>(at.Vl, at.q, v, at.reciprocals_v, N.data());
      return detail::combine<P(), P()>(M.data(), N.data(), at.points, surface_.columns, at.p, at.q).point();
    });
  }

  std::optional<Point<double>> point(double u, double v) const { return affine_point(homogeneous_point(u, v)); }

  // As the function point_and_normal.
  std::optional<PointAndNormal> point_and_normal(double u, double v) const {
    const Place at = find(u, v);
    const auto plane = with_degrees([&](auto P) {
      std::array<double, 2 * (P() > 0 ? P() + 1 : detail::max_order)> M, N;
      detail::basis_derivatives_on_span<P()>(at.Uk, at.p, u, 1, at.reciprocals_u, M.data());
      detail::basis_derivatives_on_span<P()>(at.Vl, at.q, v, 1, at.reciprocals_v, N.data());
      return detail::tangent_plane<P(), P()>(M.data(), M.data() + at.p + 1, N.data(), N.data() + at.q + 1, at.points,
                                             surface_.columns, at.p, at.q);
    });
    return detail::point_and_normal(plane, surface_, u, v, spans_[0].length(), spans_[1].length());
  }

 private:
  Surface<double> surface_;
  std::array<SpanTable, 2> spans_;
};

}  // namespace blossom
