#pragma once
// The blossom of one piece of a curve, step by step: de Boor's triangle with an argument of its own on each level
// (Ramshaw, "Blossoming: a connect-the-dots approach to splines", 1987; The NURBS Book, 5.2). On the piece over the
// span k, with the arguments t_1, ..., t_p:
//
//     alpha[r][i] = (t_r - u_i) / (u_{i+p-r+1} - u_i),  P[r][i] = (1 - alpha) P[r-1][i-1] + alpha P[r-1][i],
//     r = 1..p, i = k-p+r..k,   b(t_1, ..., t_p) = P[p][k],
//
// followed by the division by the weight for a rational curve. P[r][i] = b(t_1, ..., t_r, u_{i+1}, ..., u_{i+p-r}):
// each level exchanges a knot for an argument. The order of the arguments does not matter, and with all of them equal
// to u it is de Boor's algorithm (kernel/blossom.hpp is the same without steps).

#include "kernel/error.hpp"
#include "kernel/triangle.hpp"

namespace blossom {

// The smallest of several numbers
struct Smallest {
  static constexpr std::string_view name = "smallest";
  static constexpr std::string_view formula = "the smallest of {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(std::span<const S> numbers) {
    return *std::min_element(numbers.begin(), numbers.end());
  }
  template <Scalar S>
  static bool defined(std::span<const S> numbers) {
    return !numbers.empty();
  }
};

// The span of the piece that t belongs to: the first piece before the domain, the last one behind it
struct PieceOf {
  static constexpr std::string_view name = "piece_of";
  static constexpr std::string_view formula = "the index k of the span of {2} that holds {1}, or is nearest to it";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(int p, const S& t, std::span<const S> U) {
    const int n = static_cast<int>(U.size()) - p - 2;
    return find_span(U, p, std::clamp(t, U[static_cast<std::size_t>(p)], U[static_cast<std::size_t>(n) + 1]));
  }
  template <Scalar S>
  static bool defined(int p, const S&, std::span<const S> U) {
    const int n = static_cast<int>(U.size()) - p - 2;
    return p >= 1 && n >= p && U[static_cast<std::size_t>(p)] < U[static_cast<std::size_t>(n) + 1];
  }
};

// Preconditions: a valid curve, as many arguments as its degree, and `span` 0 or the index of a span of the domain that
// is not empty. With 0 it is the piece in which the smallest argument lies. Error: the weight is zero.
template <class R>
HPoint<typename R::Number> polar_form(const Curve<typename R::Number>& curve,
                                      const std::vector<typename R::Number>& arguments, int span, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  Cells<S, Id> t;
  t.reserve(p);
  for (int r = 1; r <= p; ++r) t.push_back(rec.input("t"_v(r), arguments[static_cast<std::size_t>(r) - 1]));
  const auto knots = rec.list("U"_v, curve.knots);
  const auto U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  const auto P = rec.inputs("P"_v, 0, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i < P.size(); ++i) rec.polar_knots(P[i].id, U[i + 1].id, p);

  const auto piece = [&] {
    if (span != 0) return rec.input("k"_v, span);
    const auto smallest = rec.apply(Smallest{}, "t"_v, slice(t, 0, p));
    return rec.apply(PieceOf{}, "k"_v, degree, smallest, knots);
  };
  const int k = piece().value;

  TriangleRow<R> row;
  for (int j = 0; j <= p; ++j) {
    const auto given = P[k - p + j];
    row[static_cast<std::size_t>(j)] = {given.value, given.id};
  }
  for (int r = 1; r <= p; ++r) {
    auto before = row[static_cast<std::size_t>(r) - 1];
    for (int j = r; j <= p; ++j) {
      const int i = k - p + j;
      const auto alpha = rec.apply(Ratio{}, "alpha"_v(r, i), t[r - 1], U[i], U[i + p - r + 1]);
      auto made = rec.apply(Blend{}, "P"_v(r, i), alpha, before, row[static_cast<std::size_t>(j)]);
      before = std::move(row[static_cast<std::size_t>(j)]);
      row[static_cast<std::size_t>(j)] = std::move(made);
    }
  }
  const auto& top = row[static_cast<std::size_t>(p)];
  if (!curve.rational) return rec.apply(Same{}, "b"_v, top).value;
  if (top.value.w == S(0)) throw KernelError{"arguments", "the blossom's weight is 0 there: it lies at infinity"};
  return rec.apply(Project{}, "b"_v, top).value;
}

}  // namespace blossom
