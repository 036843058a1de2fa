#include "kernel/span.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;

// The definition, by looking at every span.
template <Scalar S>
int span_by_definition(const std::vector<S>& U, int p, const S& u) {
  const int n = static_cast<int>(U.size()) - p - 2;
  int last_nonempty = -1;
  for (int k = p; k <= n; ++k) {
    if (!(U[k] < U[k + 1])) continue;
    last_nonempty = k;
    if (U[k] <= u && u < U[k + 1]) return k;
  }
  return last_nonempty;
}

TEMPLATE_TEST_CASE("find_span gives the spans of The NURBS Book's example", "[span]", double, Exact) {
  const std::vector<TestType> U{0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5};
  const auto span_at = [&](const char* u) { return find_span<TestType>(U, 2, from_exact<TestType>(q(u))); };
  CHECK(span_at("0") == 2);
  CHECK(span_at("1") == 3);
  CHECK(span_at("1.5") == 3);
  CHECK(span_at("5/2") == 4);
  CHECK(span_at("4") == 7);
  CHECK(span_at("4.9") == 7);
  CHECK(span_at("5") == 7);
}

TEST_CASE("find_span of an unclamped curve stays inside of the domain", "[span]") {
  const std::vector<double> U{0, 1, 2, 3, 4, 5, 6};  // p = 2: n = 3, domain [2, 4]
  CHECK(find_span<double>(U, 2, 2.0) == 2);
  CHECK(find_span<double>(U, 2, 2.5) == 2);
  CHECK(find_span<double>(U, 2, 3.0) == 3);
  CHECK(find_span<double>(U, 2, 4.0) == 3);
}

TEST_CASE("find_span at the domain's end passes over all empty spans, also unclamped ones", "[span]") {
  const std::vector<double> U{0, 0, 1, 2, 2, 2, 3};  // p = 2: n = 3, domain [1, 2], u_3 = u_4
  CHECK(find_span<double>(U, 2, 1.0) == 2);
  CHECK(find_span<double>(U, 2, 2.0) == 2);
}

TEST_CASE("find_span agrees with its definition on random knots of any multiplicity", "[span]") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 6);
    const auto U = random_knots(random, p, random_int(random, 1, 12), p + 1, seed % 2 == 0);
    const auto V = rounded(U);
    for (std::size_t i = static_cast<std::size_t>(p); i + static_cast<std::size_t>(p) < U.size(); ++i) {
      CHECK(find_span<Exact>(U, p, U[i]) == span_by_definition(U, p, U[i]));
      CHECK(find_span<double>(V, p, V[i]) == span_by_definition(V, p, V[i]));
    }
    for (int times = 0; times < 10; ++times) {
      const Exact u = random_parameter(random, U, p);
      CHECK(find_span<Exact>(U, p, u) == span_by_definition(U, p, u));
      CHECK(find_span<double>(V, p, u.to_double()) == span_by_definition(V, p, u.to_double()));
    }
  }
}

TEMPLATE_TEST_CASE("multiplicity counts a knot's occurrences, the ends of the knot vector included", "[span]", double,
                   Exact) {
  const std::vector<TestType> U{0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5};
  const auto times = [&](int u) { return multiplicity<TestType>(U, TestType(u)); };
  CHECK(times(0) == 3);
  CHECK(times(1) == 1);
  CHECK(times(4) == 2);
  CHECK(times(5) == 3);
  CHECK(times(-1) == 0);
  CHECK(times(6) == 0);
  CHECK(multiplicity<TestType>(U, from_exact<TestType>(q("3.5"))) == 0);
}

}  // namespace
}  // namespace blossom
