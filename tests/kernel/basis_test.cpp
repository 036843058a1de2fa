#include "kernel/basis.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;

// N_{i,p}(u) by the recurrence of Cox and de Boor, on the half-open spans, with the span k that u belongs to given.
template <Scalar S>
S cox_de_boor(const std::vector<S>& U, int p, int i, int k, const S& u) {
  if (p == 0) return S(i == k ? 1 : 0);
  const S left = U[i + p] - U[i];
  const S right = U[i + p + 1] - U[i + 1];
  S value(0);
  if (left != S(0)) value += (u - U[i]) / left * cox_de_boor(U, p - 1, i, k, u);
  if (right != S(0)) value += (U[i + p + 1] - u) / right * cox_de_boor(U, p - 1, i + 1, k, u);
  return value;
}

// The derivative of order d by the formula for the first one, applied to itself (The NURBS Book, equation 2.9).
template <Scalar S>
S derivative_of_basis(const std::vector<S>& U, int p, int i, int k, const S& u, int d) {
  if (d == 0) return cox_de_boor(U, p, i, k, u);
  if (p == 0) return S(0);
  const S left = U[i + p] - U[i];
  const S right = U[i + p + 1] - U[i + 1];
  S value(0);
  if (left != S(0)) value += S(p) / left * derivative_of_basis(U, p - 1, i, k, u, d - 1);
  if (right != S(0)) value -= S(p) / right * derivative_of_basis(U, p - 1, i + 1, k, u, d - 1);
  return value;
}

std::vector<Exact> values_at(const std::vector<Exact>& U, int p, const Exact& u) {
  std::vector<Exact> N(static_cast<std::size_t>(p) + 1);
  basis_functions<Exact>(U, p, find_span<Exact>(U, p, u), u, N);
  return N;
}

std::vector<Exact> exact(std::initializer_list<const char*> texts) {
  std::vector<Exact> result;
  for (const char* text : texts) result.push_back(q(text));
  return result;
}

TEST_CASE("basis functions and derivatives of The NURBS Book's example at u = 5/2", "[basis]") {
  const auto U = exact({"0", "0", "0", "1", "2", "3", "4", "4", "5", "5", "5"});
  CHECK(values_at(U, 2, q("5/2")) == exact({"1/8", "3/4", "1/8"}));
  std::vector<Exact> ders(9);
  basis_derivatives<Exact>(U, 2, 4, q("5/2"), 2, ders);
  CHECK(ders == exact({"1/8", "3/4", "1/8", "-1/2", "0", "1/2", "1", "-2", "1"}));
}

TEST_CASE("basis functions of Shene's notes, with a double knot", "[basis]") {
  const auto U = exact({"0", "0", "0", ".3", ".5", ".5", ".6", "1", "1", "1"});
  CHECK(find_span<Exact>(U, 2, q(".4")) == 3);
  CHECK(values_at(U, 2, q(".4")) == exact({"1/10", "13/20", "1/4"}));
  CHECK(find_span<Exact>(U, 2, q(".55")) == 5);
  CHECK(values_at(U, 2, q(".55")) == exact({"1/4", "7/10", "1/20"}));
}

TEST_CASE("single basis functions are Shene's polynomials, also outside of the domain", "[basis]") {
  const auto U = exact({"0", ".25", ".5", ".75", "1"});
  for (int i = 0; i <= 16; ++i) {
    const Exact u = Exact::ratio(i, 16);
    INFO("u = " << u.to_string());
    const Exact zero(0);
    const bool first = i < 4, second = i >= 4 && i < 8, third = i >= 8 && i < 12, fourth = i >= 12;
    CHECK(basis_function<Exact>(U, 1, 0, u) == (first ? 4 * u : second ? 2 * (1 - 2 * u) : zero));
    const Exact N02 = first    ? 8 * u * u
                      : second ? q("-1.5") + 12 * u - 16 * u * u
                      : third  ? q("4.5") - 12 * u + 8 * u * u
                               : zero;
    CHECK(basis_function<Exact>(U, 2, 0, u) == N02);
    // For the third span the notes print -1.5 + 8u - 8u^2, which is 0 at u = 3/4, where the next piece begins with 1/2.
    // N_{1,2} is N_{0,2} moved by 1/4, hence:
    const Exact N12 = second   ? q(".5") - 4 * u + 8 * u * u
                      : third  ? q("-5.5") + 20 * u - 16 * u * u
                      : fourth ? 8 * (1 - u) * (1 - u)
                               : zero;
    CHECK(basis_function<Exact>(U, 2, 1, u) == N12);
  }
  CHECK(basis_function<Exact>(U, 2, 0, Exact(-1)) == Exact(0));
  CHECK(basis_function<Exact>(U, 2, 0, Exact(2)) == Exact(0));
}

TEST_CASE("a single basis function takes the right limit at knots, and the left one at the last", "[basis]") {
  const auto U = exact({"0", "0", "0", "1", "1", "1", "2", "2", "2"});  // p = 2, the curve jumps at 1
  CHECK(basis_function<Exact>(U, 2, 2, Exact(1)) == Exact(0));
  CHECK(basis_function<Exact>(U, 2, 3, Exact(1)) == Exact(1));
  CHECK(basis_function<Exact>(U, 2, 5, Exact(2)) == Exact(1));
  CHECK(basis_function<Exact>(U, 2, 0, Exact(0)) == Exact(1));
}

TEST_CASE("all nonvanishing basis functions follow the Cox-de Boor recurrence, exactly, and sum to 1", "[basis]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const auto U = random_knots(random, p, random_int(random, 1, 5), p + 1, seed % 2 == 0);
    for (int times = 0; times < 4; ++times) {
      const Exact u = times == 0 ? U[static_cast<std::size_t>(p)] : random_parameter(random, U, p);
      const int k = find_span<Exact>(U, p, u);
      const auto N = values_at(U, p, u);
      Exact sum(0);
      for (int r = 0; r <= p; ++r) {
        CHECK(N[r] == cox_de_boor(U, p, k - p + r, k, u));
        CHECK(N[r] >= Exact(0));
        sum += N[r];
        const Exact& end = U[U.size() - static_cast<std::size_t>(p) - 1];
        if (u != end || U.back() == end) CHECK(N[r] == basis_function<Exact>(U, p, k - p + r, u));
      }
      CHECK(sum == Exact(1));

      const auto V = rounded(U);
      std::vector<double> M(static_cast<std::size_t>(p) + 1);
      basis_functions<double>(V, p, k, u.to_double(), M);
      for (int r = 0; r <= p; ++r) CHECK(M[r] == Approx(N[r].to_double()).margin(1e-14));
    }
  }
}

TEST_CASE("derivatives of every order follow the recurrence, and vanish above the degree", "[basis]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4);
    const int d = p + 2;
    const auto U = random_knots(random, p, 4, p + 1, seed % 2 == 0);
    const Exact u = random_parameter(random, U, p);
    const int k = find_span<Exact>(U, p, u);
    std::vector<Exact> ders(static_cast<std::size_t>((d + 1) * (p + 1)), Exact(99));
    basis_derivatives<Exact>(U, p, k, u, d, ders);
    std::vector<double> double_ders(ders.size());
    basis_derivatives<double>(rounded(U), p, k, u.to_double(), d, double_ders);
    for (int j = 0; j <= d; ++j) {
      for (int r = 0; r <= p; ++r) {
        INFO("order " << j << ", function " << r);
        const Exact& value = ders[static_cast<std::size_t>(j * (p + 1) + r)];
        CHECK(value == derivative_of_basis(U, p, k - p + r, k, u, j));
        CHECK(double_ders[j * (p + 1) + r] == Approx(value.to_double()).epsilon(1e-11).margin(1e-9));
      }
    }
  }
}

TEST_CASE("the highest degree: positive, summing to 1 in both scalars", "[basis]") {
  for (int p = 1; p <= max_degree; ++p) {
    INFO("degree " << p);
    std::mt19937 random(static_cast<unsigned>(p));
    const auto U = random_knots(random, p, 3, p, p % 2 == 0);
    const Exact u = random_parameter(random, U, p);
    Exact sum(0);
    for (const Exact& value : values_at(U, p, u)) sum += value;
    CHECK(sum == Exact(1));

    const auto V = rounded(U);
    std::vector<double> N(static_cast<std::size_t>(p) + 1);
    basis_functions<double>(V, p, find_span<double>(V, p, u.to_double()), u.to_double(), N);
    double double_sum = 0;
    for (double value : N) {
      CHECK(value >= 0);
      double_sum += value;
    }
    CHECK(double_sum == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("Greville abscissae reproduce u as a spline", "[basis]") {
  CHECK(greville_abscissae(exact({"0", "0", "0", "0", "1", "2", "2", "2", "2"}), 3) ==
        exact({"0", "1/3", "1", "5/3", "2"}));
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const auto U = random_knots(random, p, 4, p, seed % 2 == 0);
    const auto xi = greville_abscissae(U, p);
    REQUIRE(xi.size() + static_cast<std::size_t>(p) + 1 == U.size());
    const Exact u = random_parameter(random, U, p);
    const int k = find_span<Exact>(U, p, u);
    const auto N = values_at(U, p, u);
    Exact sum(0);
    for (int r = 0; r <= p; ++r) sum += N[r] * xi[k - p + r];
    CHECK(sum == u);
  }
}

}  // namespace
}  // namespace blossom
