#pragma once
// The rules values are made by. A rule is a pure function of its operands, with
//   name      what files call it,
//   formula   with {0}, {1}... for the operands ({*}: all of them, comma-separated),
//   polar     what it does to polar labels (Ramshaw, Blossoming, 1987: a label is the multiset of arguments),
//   apply<S>  the function, through which the kernel itself computes, and
//   defined   where it has preconditions: whether these operands satisfy them. The kernel guarantees them; a student's
//             operands may not.
// A rule only one algorithm needs stands in that algorithm's header.

#include <algorithm>
#include <span>
#include <vector>

#include "kernel/recorder.hpp"
#include "kernel/span.hpp"

namespace blossom {

enum class Polar : std::uint8_t {
  none,      // the value is no blossom value
  blend,     // what the two points share, and the parameter: f(A, a), f(A, b) -> f(A, u)
  merge,     // the union of both labels: degree elevation
  same,      // the label of the operand
  repeat,    // the label of the operand with its last argument once more: the end of an elevated Bezier curve
  repeat_v,  // the same in the v-arguments of a surface's label
};

// (1 - a) A + a B
struct Blend {
  static constexpr std::string_view name = "blend";
  static constexpr std::string_view formula = "(1 - {0}) {1} + {0} {2}";
  static constexpr Polar polar = Polar::blend;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A, const HPoint<S>& B) {
    const S b = S(1) - a;
    return {b * A.x + a * B.x, b * A.y + a * B.y, b * A.z + a * B.z, b * A.w + a * B.w};
  }
};

// (u - a) / (b - a): where u lies between two knots
struct Ratio {
  static constexpr std::string_view name = "ratio";
  static constexpr std::string_view formula = "({0} - {1}) / ({2} - {1})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& a, const S& b) {
    return (u - a) / (b - a);
  }
  template <Scalar S>
  static bool defined(const S&, const S& a, const S& b) {
    return !(a == b);
  }
};

// The span of an evaluation (NB A2.1): k in [p, n] with u_k <= u < u_{k+1}; at the end of the domain the last one.
struct FindSpan {
  static constexpr std::string_view name = "span";
  static constexpr std::string_view formula = "the index k of the span of {2} that holds {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(int p, const S& u, std::span<const S> U) {
    return find_span(U, p, u);
  }
  template <Scalar S>
  static bool defined(int p, const S& u, std::span<const S> U) {
    const int n = static_cast<int>(U.size()) - p - 2;
    return p >= 1 && n >= p && !(u < U[static_cast<std::size_t>(p)]) && !(U[static_cast<std::size_t>(n) + 1] < u);
  }
};

// The span of an insertion: the last k with u_k <= u.
struct LastKnot {
  static constexpr std::string_view name = "last_knot";
  static constexpr std::string_view formula = "the last k with u_k <= {0} in {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(const S& u, std::span<const S> U) {
    return static_cast<int>(std::upper_bound(U.begin(), U.end(), u) - U.begin()) - 1;
  }
};

// How often u is a knot
struct Multiplicity {
  static constexpr std::string_view name = "multiplicity";
  static constexpr std::string_view formula = "how many knots of {1} equal {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(const S& u, std::span<const S> U) {
    return multiplicity(U, u);
  }
};

// The point of a homogeneous point: division by its weight
struct Project {
  static constexpr std::string_view name = "project";
  static constexpr std::string_view formula = "{0} / w";
  static constexpr Polar polar = Polar::same;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return {A.x / A.w, A.y / A.w, A.z / A.w, S(1)};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>& A) {
    return !(A.w == S(0));
  }
};

// The same point under another name
struct Same {
  static constexpr std::string_view name = "same";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::same;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// The same point under another name, with a label that its maker tells (an input or what was solved for has none)
struct Relabel {
  static constexpr std::string_view name = "relabel";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// The same number under another name
struct SameNumber {
  static constexpr std::string_view name = "same_number";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a) {
    return a;
  }
};

// a / b of two whole numbers
struct Fraction {
  static constexpr std::string_view name = "fraction";
  static constexpr std::string_view formula = "{0} / {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int a, int b) {
    return S(a) / S(b);
  }
  template <Scalar S>
  static bool defined(int, int b) {
    return b != 0;
  }
};

// a + b
struct Sum {
  static constexpr std::string_view name = "sum";
  static constexpr std::string_view formula = "{0} + {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b) {
    return a + b;
  }
};

// a / b
struct Quotient {
  static constexpr std::string_view name = "quotient";
  static constexpr std::string_view formula = "{0} / {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b) {
    return a / b;
  }
  template <Scalar S>
  static bool defined(const S&, const S& b) {
    return !(b == S(0));
  }
};

// The sum of several numbers
struct Total {
  static constexpr std::string_view name = "total";
  static constexpr std::string_view formula = "sum of {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(std::span<const S> a) {
    S sum(0);
    for (const S& x : a) sum += x;
    return sum;
  }
};

// The mean of several numbers
struct Mean {
  static constexpr std::string_view name = "mean";
  static constexpr std::string_view formula = "mean of {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(std::span<const S> a) {
    S sum(0);
    for (const S& x : a) sum += x;
    return sum / S(static_cast<int>(a.size()));
  }
  template <Scalar S>
  static bool defined(std::span<const S> a) {
    return !a.empty();
  }
};

// Numbers in a row: a knot vector from its knots
struct Gather {
  static constexpr std::string_view name = "gather";
  static constexpr std::string_view formula = "{*} in a row";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(std::span<const S> a) {
    return {a.begin(), a.end()};
  }
};

}  // namespace blossom
