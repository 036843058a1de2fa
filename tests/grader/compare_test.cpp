#include "grader/compare.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace blossom;

namespace {

Exact number(const std::string& text) {
  const auto x = Exact::parse(text);
  REQUIRE(x);
  return *x;
}

// The verdict by the fast path and by the slow one, which must agree.
bool counts(const Tolerance& tolerance, const std::string& right, const std::string& typed) {
  const Exact v = number(right);
  const bool fast = fit(window(tolerance, v), typed) == Fit::inside;
  INFO(right << " typed as " << typed);
  CHECK(fast == within(tolerance, v, number(typed)));
  return fast;
}

Tolerance decimals(int n) { return {Tolerance::Kind::decimals, n, 0}; }
Tolerance significant(int n) { return {Tolerance::Kind::significant, n, 0}; }
Tolerance absolute(const std::string& x) { return {Tolerance::Kind::absolute, 0, number(x)}; }
Tolerance relative(const std::string& x) { return {Tolerance::Kind::relative, 0, number(x)}; }

}  // namespace

TEST_CASE("exact: only the number itself, however it is written") {
  CHECK(counts({}, "2/5", "0.4"));
  CHECK(counts({}, "2/5", "4e-1"));
  CHECK(counts({}, "2/5", "+6/15"));
  CHECK(counts({}, "1/10", "0.1"));
  CHECK_FALSE(counts({}, "1/3", "0.3333333333333333"));
  CHECK_FALSE(counts({}, "1/10", "0.1000000000000000055511151231257827"));  // the double nearest to 1/10
  CHECK_FALSE(counts({}, "9007199254740993", "9007199254740992"));          // the same double
}

TEST_CASE("decimals: at most half a unit of the last decimal, the half included") {
  CHECK(counts(decimals(2), "1/3", "0.33"));
  CHECK(counts(decimals(2), "1/3", "0.333333"));
  CHECK_FALSE(counts(decimals(2), "1/3", "0.34"));
  CHECK_FALSE(counts(decimals(2), "2/3", "0.66"));  // cut off, not rounded
  // 0.125 to two decimals: both neighbours are as near.
  CHECK(counts(decimals(2), "1/8", "0.12"));
  CHECK(counts(decimals(2), "1/8", "0.13"));
  CHECK_FALSE(counts(decimals(2), "1/8", "0.11999999999999999999"));
  CHECK_FALSE(counts(decimals(2), "1/8", "0.13000000000000000001"));
  CHECK(counts(decimals(2), "-1/8", "-0.12"));
  CHECK(counts(decimals(0), "5/2", "2"));
  CHECK(counts(decimals(0), "5/2", "3"));
}

TEST_CASE("significant digits count from the first digit that is not zero") {
  CHECK(counts(significant(3), "1234567", "1230000"));
  CHECK_FALSE(counts(significant(3), "1234567", "1240000"));
  CHECK(counts(significant(3), "0.00012345", "0.000123"));
  CHECK_FALSE(counts(significant(3), "0.00012345", "0.000124"));
  CHECK(counts(significant(3), "9.996", "10"));
  CHECK(counts(significant(1), "-1000", "-1500"));  // the boundary
  CHECK_FALSE(counts(significant(1), "-1000", "-1501"));
  CHECK(counts(significant(2), "0", "0"));
  CHECK_FALSE(counts(significant(2), "0", "1e-300"));
}

TEST_CASE("absolute and relative tolerances include their boundaries") {
  CHECK(counts(absolute("0.1"), "0.3", "0.4"));  // in double, 0.4 - 0.3 is more than 0.1
  CHECK(counts(absolute("0.1"), "0.3", "0.2"));
  CHECK_FALSE(counts(absolute("0.1"), "0.3", "0.40000000000000000000001"));
  CHECK(counts(relative("1/100"), "200", "202"));
  CHECK_FALSE(counts(relative("1/100"), "200", "202.0000001"));
  CHECK(counts(relative("0.01"), "-200", "-198"));
  CHECK_FALSE(counts(relative("0.5"), "0", "0.0001"));
}

TEST_CASE("the fast and the slow way agree everywhere near a boundary") {
  const unsigned seed = 20260401;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> small(-9999, 9999), below(1, 99), digit(0, 6), nudge(-2, 2);
  for (int n = 0; n < 3000; ++n) {
    const Exact v = Exact::ratio(small(random), below(random));
    const Tolerance tolerance = n % 2 == 0 ? decimals(digit(random)) : relative("0.001");
    const Exact boundary = v + (n % 4 < 2 ? slack(tolerance, v) : -slack(tolerance, v));
    const Exact typed = boundary + Exact(nudge(random)) * Exact::ratio(1, 1'000'000'000'000'000);
    counts(tolerance, v.to_string(), typed.to_string());
  }
}

TEST_CASE("what is no number is told from what is another number") {
  const Window w = window({}, Exact(1));
  for (const char* text : {"",    " ",   " 1", "1 ", "NaN",   "nan",   "inf",         "-inf",  "Infinity",
                           "0x1", "1/0", "1/", "/2", "1//2",  "--1",   "1e999999999", "1e401", "1.2.3",
                           "1,5", "one", "1e", "-",  "1/2/3", "0.5/2", "1e400"}) {
    INFO(text);
    CHECK(fit(w, text) == Fit::no_number);
  }
  CHECK(fit(w, std::string(10000, '1')) == Fit::no_number);
  CHECK(fit(w, "1." + std::string(300, '0')) == Fit::inside);
  CHECK(fit(w, std::string(200, '1')) == Fit::outside);
}

TEST_CASE("a typed decimal is known to half a unit of its last digit") {
  CHECK(rounding_of("0.33") == 0.005);
  CHECK(rounding_of("1.5e3") == 50);
  CHECK(rounding_of("1.25e-2") == 0.00005);
  CHECK(rounding_of("3") == 0);
  CHECK(rounding_of("1/3") == 0);
}
