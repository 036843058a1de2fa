#pragma once
// The share of every control point in one point of a surface (The NURBS Book 3.4, 4.4; Shene, "B-spline Surfaces":
// Basic Concepts). At (u, v), with u in the span k and v in the span l, the basis functions are
//
//     B[i][j] = N_{i,p}(u) N_{j,q}(v),     i = k-p..k, j = l-q..l,     all others are zero;
//     rational: R[i][j] = B[i][j] w_ij / W,    W = sum of all B[i][j] w_ij.
//
// They are not negative, their sum is 1 (the partition of unity), and S(u, v) is the sum of B[i][j] P[i][j]. The point
// is summed up in homogeneous coordinates.

#include "kernel/approximation.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

namespace tensor {

// a b
struct Product {
  static constexpr std::string_view name = "tensor_product";
  static constexpr std::string_view formula = "{0} · {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b) {
    return a * b;
  }
};

// b w, with the weight w of a point
struct Weighted {
  static constexpr std::string_view name = "tensor_weighted";
  static constexpr std::string_view formula = "{0} · the weight of {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& b, const HPoint<S>& P) {
    return b * P.w;
  }
};

// The sum of all shares, a point
struct WholeSum {
  static constexpr std::string_view name = "tensor_whole_sum";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// The basis functions `name`[i] of the span, i = span-p..span, and their indices as the values `counter`[i].
template <class R, class Degree, class Parameter, class KnotList>
Cells<typename R::Number, typename R::Id> basis_of_span(R& rec, const NameMaker& name, const NameMaker& counter,
                                                        int span, const Degree& p, const Parameter& u,
                                                        const KnotList& U) {
  Cells<typename R::Number, typename R::Id> N;
  N.reserve(p.value + 1);
  for (int i = span - p.value; i <= span; ++i)
    N.push_back(rec.apply(BasisValue{}, name(i), rec.input(counter(i), i), p, u, U));
  return N;
}

}  // namespace tensor

// Preconditions: a valid surface, u and v in its domain. Error: the weight there is zero.
template <class R>
HPoint<typename R::Number> surface_basis(const Surface<typename R::Number>& surface, const typename R::Number& u_value,
                                         const typename R::Number& v_value, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto p = rec.input("p"_v, surface.degree[0]);
  const auto q = rec.input("q"_v, surface.degree[1]);
  const auto u = rec.input("u"_v, u_value);
  const auto v = rec.input("v"_v, v_value);
  const tensor::GivenSurface<R> given(rec, surface);

  const auto k = rec.apply(FindSpan{}, "k"_v, p, u, given.lists[0]);
  const auto N = tensor::basis_of_span(rec, "N"_v, "i"_v, k.value, p, u, given.lists[0]);
  const auto l = rec.apply(FindSpan{}, "l"_v, q, v, given.lists[1]);
  const auto M = tensor::basis_of_span(rec, "M"_v, "j"_v, l.value, q, v, given.lists[1]);
  const int first_i = k.value - p.value, first_j = l.value - q.value, width = M.size();

  // b(i, j) at (i - first_i) * width + (j - first_j).
  const auto on_every_pair = [&](const auto& make) {
    for (int at = 0; at < N.size() * width; ++at) make(at, first_i + at / width, first_j + at % width);
  };
  Cells<S, Id> B;
  {
    auto phase = rec.phase({"products"});
    on_every_pair([&](int at, int i, int j) {
      B.push_back(rec.apply(tensor::Product{}, "B"_v(i, j), N[at / width], M[at % width]));
    });
    rec.apply(Total{}, "sum"_v, slice(B, 0, B.size()));
  }

  if (surface.rational) {
    auto phase = rec.phase({"weights"});
    Cells<S, Id> weighted, share;
    on_every_pair([&](int at, int i, int j) {
      weighted.push_back(rec.apply(tensor::Weighted{}, "G"_v(i, j), B[at], given.at(i, j)));
    });
    const auto W = rec.apply(Total{}, "W"_v, slice(weighted, 0, weighted.size()));
    if (W.value == S(0)) throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
    on_every_pair([&](int at, int i, int j) { share.push_back(rec.apply(Quotient{}, "R"_v(i, j), weighted[at], W)); });
    rec.apply(Total{}, "one"_v, slice(share, 0, share.size()));
  }

  auto phase = rec.phase({"point"});
  auto sum = rec.apply(Multiple{}, "C"_v(first_i, first_j), B[0], given.at(first_i, first_j));
  on_every_pair([&](int at, int i, int j) {
    if (at > 0) sum = rec.apply(AddMultiple{}, "C"_v(i, j), sum, B[at], given.at(i, j));
  });
  auto point = rec.apply(tensor::WholeSum{}, surface.rational ? "H"_v() : "S"_v(), sum);
  if constexpr (R::recording)
    rec.polar_net(point.id, std::vector<S>(static_cast<std::size_t>(p.value), u_value),
                  std::vector<S>(static_cast<std::size_t>(q.value), v_value));
  if (surface.rational) return rec.apply(Project{}, "S"_v, point).value;
  point.value.w = S(1);  // up to rounding it is
  return point.value;
}

}  // namespace blossom
