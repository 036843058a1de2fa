#pragma once
// Linear systems for control points, N P = D: the matrix is banded (a basis function differs from zero on p + 1 spans
// only) and totally positive (de Boor 1978), or symmetric and positive definite (N^T N), so the elimination needs no
// pivoting. It is done once and serves all right-hand sides.

#include <string_view>

#include "kernel/basis.hpp"
#include "kernel/error.hpp"
#include "kernel/rules.hpp"

namespace blossom {

// N_{j,q}(v) over the knots V
struct BasisValue {
  static constexpr std::string_view name = "basis";
  static constexpr std::string_view formula = "N_({0},{1})({2})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int j, int q, const S& v, std::span<const S> V) {
    return basis_function(V, q, j, v);
  }
  template <Scalar S>
  static bool defined(int j, int q, const S& v, std::span<const S> V) {
    return q >= 1 && q <= max_degree && j >= 0 && j + q + 1 < static_cast<int>(V.size()) &&
           FindSpan::defined<S>(q, v, V);
  }
};

// a - m b of numbers
struct ReduceNumber {
  static constexpr std::string_view name = "reduce_number";
  static constexpr std::string_view formula = "{0} - {1} · {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& m, const S& b) {
    return a - m * b;
  }
};

// A - m B of right-hand sides
struct Reduce {
  static constexpr std::string_view name = "reduce";
  static constexpr std::string_view formula = "{0} - {1} · {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& m, const HPoint<S>& B) {
    return {A.x - m * B.x, A.y - m * B.y, A.z - m * B.z, A.w - m * B.w};
  }
};

// A / d
struct Scale {
  static constexpr std::string_view name = "divide";
  static constexpr std::string_view formula = "{0} / {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& d) {
    return {A.x / d, A.y / d, A.z / d, A.w / d};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>&, const S& d) {
    return !(d == S(0));
  }
};

// A banded matrix, eliminated in place: below the diagonal its multipliers, above it the triangle.
template <class R>
struct Band {
  int size = 0;
  std::vector<int> first, last;  // the columns of each row that can differ from zero; neither ever decreases
  int stride = 0;
  Cells<typename R::Number, typename R::Id> entries;  // row l, column j at l * stride + j - first[l]

  Band(int rows, int width)
      : size(rows), first(static_cast<std::size_t>(rows), 0), last(static_cast<std::size_t>(rows), 0), stride(width) {
    entries.resize(rows * width);
  }
  int begin(int l) const { return first[static_cast<std::size_t>(l)]; }
  int end(int l) const { return last[static_cast<std::size_t>(l)]; }
  void set_row(int l, int from, int to) {
    first[static_cast<std::size_t>(l)] = from;
    last[static_cast<std::size_t>(l)] = to;
  }
  auto at(int l, int j) const { return entries[l * stride + j - begin(l)]; }
  template <class V>
  void set(int l, int j, const V& value) {
    entries.set(l * stride + j - begin(l), value);
  }
};

// A[c][j] of row l in the phase row[l], the multipliers m[l][c]. Error: a pivot of zero, said of this input.
template <class R>
void eliminate(R& rec, Band<R>& A, std::string_view input) {
  using S = typename R::Number;
  constexpr const char* singular = "the system of equations has no unique solution: some are too close together";
  for (int c = 0; c + 1 < A.size; ++c) {
    for (int l = c + 1; l < A.size && A.begin(l) <= c; ++l) {
      if (A.at(c, c).value == S(0)) throw KernelError{std::string(input), singular};
      auto phase = rec.phase({"row", l, true});
      const auto m = rec.apply(Quotient{}, "m"_v(l, c), A.at(l, c), A.at(c, c));
      A.set(l, c, m);
      for (int j = c + 1; j <= A.end(c); ++j)
        A.set(l, j, rec.apply(ReduceNumber{}, "A"_v(c, j), A.at(l, j), m, A.at(c, j)));
    }
  }
  if (A.at(A.size - 1, A.size - 1).value == S(0)) throw KernelError{std::string(input), singular};
}

// Forward (D[l][c]), then backward (X[l][j]); `result(l)` names the solution of row l, `made(l, value)` receives it.
// In: D[l] the right-hand sides; out: the solution.
template <class R, class ResultName, class Made>
void solve(R& rec, const Band<R>& A, Cells<HPoint<typename R::Number>, typename R::Id>& D, ResultName&& result,
           Made&& made) {
  using Right = Traced<HPoint<typename R::Number>, typename R::Id>;
  for (int l = 0; l < A.size; ++l) {
    Right right{D[l].value, D[l].id};
    for (int c = A.begin(l); c < l; ++c) right = rec.apply(Reduce{}, "D"_v(l, c), right, A.at(l, c), D[c]);
    D.set(l, right);
  }
  for (int l = A.size - 1; l >= 0; --l) {
    Right right{D[l].value, D[l].id};
    for (int j = A.end(l); j > l; --j) right = rec.apply(Reduce{}, "X"_v(l, j), right, A.at(l, j), D[j]);
    const auto value = rec.apply(Scale{}, result(l), right, A.at(l, l));
    D.set(l, value);
    made(l, value);
  }
}

}  // namespace blossom
