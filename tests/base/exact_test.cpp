#include "base/exact.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "base/scalar.hpp"

using namespace blossom;

namespace {

constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();

Exact number(const std::string& text) {
  const auto parsed = Exact::parse(text);
  INFO("text " << text);
  REQUIRE(parsed.has_value());
  return *parsed;
}

// Numerators and denominators of every size, small ones and those near 2^63 most often, and powers beyond 64 bits.
Exact random_exact(std::mt19937_64& random) {
  const auto integer = [&] {
    const auto bits = static_cast<int>(random() % 64);
    return static_cast<std::int64_t>(random() >> bits) * (random() % 2 == 0 ? 1 : -1);
  };
  std::int64_t d = integer();
  if (d == 0 || d == lowest) d = 1;
  Exact x = Exact::ratio(integer(), d);
  if (random() % 4 == 0) x *= x * x;
  return x;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("numbers are read as exactly what was typed") {
  CHECK(number("7") == Exact(7));
  CHECK(number("-3/2") == Exact::ratio(-3, 2));
  CHECK(number("0.4") == Exact::ratio(2, 5));
  CHECK(number("+1.5e-3") == Exact::ratio(3, 2000));
  CHECK(number("0.1") == Exact::ratio(1, 10));
  CHECK(number("0.1") != Exact(0.1));
  CHECK(number("6/4").to_string() == "3/2");
  CHECK(number("-0") == Exact(0));
  CHECK(number("-0").to_string() == "0");
  CHECK(number(".5") == Exact::ratio(1, 2));
  CHECK(number("5.") == Exact(5));
  CHECK(number("007") == Exact(7));
  CHECK(number("0010/020").to_string() == "1/2");
  CHECK(number("-2000000000000000000000/4000000000000000000000") == Exact::ratio(-1, 2));
  CHECK(number("1E2") == Exact(100));
  CHECK(number("12345678901234567890123").to_string() == "12345678901234567890123");
  CHECK(number("1e-400") * number("1e400") == Exact(1));
  CHECK(number("1e-0000000000001") == Exact::ratio(1, 10));
}

TEST_CASE("what is no number is refused") {
  for (const char* text : {"",
                           "-",
                           "+",
                           ".",
                           "e5",
                           "1e",
                           "1e+",
                           "1/",
                           "/2",
                           "1/0",
                           "1/-2",
                           "--1",
                           "1 ",
                           " 1",
                           "1,5",
                           "0x10",
                           "nan",
                           "inf",
                           "1/2/3",
                           "1.5/2",
                           "1e5/2",
                           "1..2",
                           "1e2.5",
                           "infinity",
                           "1_000",
                           "\xE2\x88\x92"
                           "1",
                           "1e401",
                           "1e-401"}) {
    INFO("text " << text);
    CHECK_FALSE(Exact::parse(text).has_value());
  }
  CHECK_FALSE(Exact::parse(std::string("1\0", 2)).has_value());
  CHECK(Exact::parse(std::string(400, '9')).has_value());
  CHECK_FALSE(Exact::parse(std::string(401, '9')).has_value());
  CHECK_FALSE(Exact::parse("1e" + std::string(300, '9')).has_value());
  CHECK_FALSE(Exact::parse("1e99999999999999999999").has_value());
}

TEST_CASE("results that fit in 64 bits are stored small again, so that equal numbers have one text") {
  const Exact big = Exact(highest) * Exact(highest);
  CHECK(big.to_string() == "85070591730234615847396907784232501249");
  CHECK(big / Exact(highest) == Exact(highest));
  CHECK((big / Exact(highest)).to_string() == std::to_string(highest));
  CHECK(big - big == Exact(0));
  CHECK((big - big).to_string() == "0");
  CHECK(Exact(highest) + Exact(1) - Exact(1) == Exact(highest));
}

TEST_CASE("the lowest 64-bit integer has no positive twin in 64 bits") {
  const Exact low(lowest);
  CHECK(low.to_string() == "-9223372036854775808");
  CHECK((-low).to_string() == "9223372036854775808");
  CHECK(-(-low) == low);
  CHECK(abs(low) == -low);
  CHECK(low + Exact(1) == Exact(lowest + 1));
  CHECK(Exact(lowest + 1) - Exact(1) == low);
  CHECK(low / low == Exact(1));
  CHECK(low < Exact(lowest + 1));
  CHECK(low.to_double() == -0x1p63);
  CHECK(Exact::ratio(lowest, lowest) == Exact(1));
  CHECK(Exact::ratio(1, lowest).to_string() == "-1/9223372036854775808");
  CHECK(Exact::ratio(lowest, -1) == -low);
  CHECK(Exact(-0x1p63) == low);
}

TEST_CASE("random numbers obey the laws of a field, small and big") {
  const auto seed = GENERATE(1u, 2u, 3u);
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 1000; ++i) {
    const Exact a = random_exact(random), b = random_exact(random), c = random_exact(random);
    INFO(a.to_string() << " | " << b.to_string() << " | " << c.to_string());
    REQUIRE(a + b == b + a);
    REQUIRE((a + b) + c == a + (b + c));
    REQUIRE((a * b) * c == a * (b * c));
    REQUIRE(a * (b + c) == a * b + a * c);
    REQUIRE(a - b == -(b - a));
    REQUIRE(a + b - b == a);
    if (b != Exact(0)) REQUIRE(a / b * b == a);
    REQUIRE(((a < b) == (a - b < Exact(0))));
    REQUIRE(((a <=> b) == (-b <=> -a)));
    REQUIRE(sqrt(a * a) == abs(a));
    REQUIRE_FALSE(sqrt(a * a).is_approximate());
    REQUIRE(number(a.to_string()) == a);
    REQUIRE((a * b + c).to_string() == (c + b * a).to_string());
  }
}

TEST_CASE("a number may stand on both sides of an assignment") {
  for (const Exact& start : {Exact::ratio(3, 7), number("1e30"), Exact::approximate(1.5)}) {
    Exact x = start;
    x += x;
    CHECK(x == start * Exact(2));
    x -= x;
    CHECK(x == Exact(0));
    x = start;
    x *= x;
    CHECK(x == start * start);
    x /= x;
    CHECK(x == Exact(1));
    x = start;
    const Exact& same = x;
    x = same;
    CHECK(x == start);
    const Exact moved = std::move(x);
    CHECK(moved == start);
  }
}

TEST_CASE("the nearest double is the one the C library reads from the same decimal text") {
  const auto seed = GENERATE(11u, 12u);
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 5000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    const auto length = 1 + random() % 40;
    for (std::uint64_t k = 0; k < length; ++k) text += static_cast<char>('0' + random() % 10);
    if (random() % 2 == 0) text += "." + std::to_string(random());
    text += "e" + std::to_string(static_cast<int>(random() % 700) - 370);
    const double expected = std::strtod(text.c_str(), nullptr);
    const Exact x = number(text);
    INFO("text " << text);
    REQUIRE((expected == 0 ? x.to_double() == 0 : same_bits(x.to_double(), expected)));
  }
}

TEST_CASE("the nearest double at the edges: halfway, subnormal, overflow") {
  for (const char* text :
       {"9007199254740993", "9007199254740995", "9007199254740992.5", "9223372036854775807", "9223372036854774784.5",
        "4.9406564584124654e-324", "2.4703282292062327e-324", "2.4703282292062328e-324", "2.2250738585072011e-308",
        "2.2250738585072014e-308", "1.7976931348623157e308", "1.7976931348623159e308", "1e309", "0.1", "1e23"}) {
    INFO("text " << text);
    CHECK(same_bits(number(text).to_double(), std::strtod(text, nullptr)));
  }
  // Numerator and denominator above 2^53: rounding each to a double first would round twice.
  CHECK(Exact::ratio(9007199254740993, 9007199254740995).to_double() ==
        static_cast<double>(9007199254740993.0L / 9007199254740995.0L));
}

TEST_CASE("every finite double is a rational, and comes back") {
  std::mt19937_64 random(21);
  for (int i = 0; i < 5000; ++i) {
    const std::uint64_t bits = random();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) continue;
    REQUIRE(Exact(x).to_double() == x);
    REQUIRE(from_exact<double>(*Exact::parse(format_number(x))) == x);
  }
  CHECK(Exact(0.5).to_string() == "1/2");
  CHECK(Exact(-0.0).to_string() == "0");
  CHECK(Exact(5e-324).to_double() == 5e-324);
}

TEST_CASE("roots are exact where they are rational, and marked where they are not") {
  CHECK(sqrt(Exact::ratio(9, 4)) == Exact::ratio(3, 2));
  CHECK(sqrt(Exact(0)) == Exact(0));
  CHECK(sqrt(number("1e60")) == number("1e30"));
  CHECK_FALSE(sqrt(number("1e60")).is_approximate());
  CHECK(sqrt(Exact(5)).is_approximate());
  CHECK(sqrt(Exact(5)).to_double() == std::sqrt(5.0));
  CHECK(sqrt(Exact(highest)).is_approximate());
  const Exact huge = number("2e390"), tiny = number("2e-390");
  CHECK(sqrt(huge).to_double() == Approx(std::sqrt(2) * 1e195));
  CHECK(sqrt(tiny).to_double() == Approx(std::sqrt(2) * 1e-195));
}

TEST_CASE("approximate is contagious, and computes as doubles do") {
  const Exact root = sqrt(Exact(2)), third = Exact::ratio(1, 3);
  for (const Exact& x : {root + third, third - root, root * third, third / root, -root, abs(-root), sqrt(root)}) {
    CHECK(x.is_approximate());
  }
  CHECK((third - root).to_double() == third.to_double() - root.to_double());
  CHECK((Exact(0) * root).is_approximate());
  CHECK_FALSE((third + third).is_approximate());
  CHECK(Exact::approximate(0.5) == Exact::ratio(1, 2));
  CHECK(Exact::approximate(0.1).to_string() == "0.1");
  CHECK(root < Exact::ratio(3, 2));
  CHECK(Exact::approximate(4).is_integer());
  CHECK_FALSE(root.is_integer());
  CHECK((Exact::approximate(1e308) * Exact(10) > Exact(1)));
}

TEST_CASE("numbers are printed with as many digits as they need") {
  CHECK(format_number(0.1) == "0.1");
  CHECK(format_number(1e-7) == "1e-07");
  CHECK(format_number(-3.0) == "-3");
  CHECK(format_number(-0.0) == "0");
  CHECK(format_number(Exact::ratio(-2, 4)) == "-1/2");
  CHECK(format_short(2.0 / 3, 3) == "0.667");
  CHECK(format_short(2.5, 3) == "2.5");
  CHECK(format_short(100, 2) == "100");
  CHECK(format_short(-0.0001, 2) == "0");
  CHECK(format_short(-1.50, 2) == "-1.5");
  CHECK(format_short(7, 0) == "7");
  CHECK(format_short(1e300, 2) == "1e+300");
  CHECK(parse_number<double>("1/3") == 1.0 / 3);
  CHECK_FALSE(parse_number<double>("x").has_value());
}

TEST_CASE("of nested bounds on exact work the tightest counts, and the outer one is back afterwards") {
  Exact x = Exact::ratio(1, 3);
  const auto grow = [](Exact y) {
    for (int i = 0; i < 12; ++i) y = y * y;
  };
  CHECK_NOTHROW(grow(x));
  const ExactBudget tight(10);
  {
    const ExactBudget wide(1'000'000'000);
    CHECK_THROWS_AS(grow(x), ExactTooLarge);
  }
  CHECK_THROWS_AS(grow(x), ExactTooLarge);
}
