#include "base/exact.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/scalar.hpp"

namespace blossom {
namespace {

namespace mp = boost::multiprecision;
using Integer = mp::number<mp::cpp_int_backend<>, mp::et_off>;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

constexpr std::int64_t small_max = std::numeric_limits<std::int64_t>::max();

bool fits(Int128 x) { return -Int128{small_max} <= x && x <= Int128{small_max}; }

Integer to_integer(Int128 x) {
  const bool negative = x < 0;
  const UInt128 magnitude = negative ? -static_cast<UInt128>(x) : static_cast<UInt128>(x);
  Integer result = static_cast<std::uint64_t>(magnitude >> 64);
  result <<= 64;
  result += static_cast<std::uint64_t>(magnitude);
  return negative ? Integer(-result) : result;
}

int highest_bit(UInt128 x) {
  const auto high = static_cast<std::uint64_t>(x >> 64);
  return high != 0 ? 127 - std::countl_zero(high) : 63 - std::countl_zero(static_cast<std::uint64_t>(x));
}

int highest_bit(const Integer& x) { return static_cast<int>(mp::msb(x)); }

// n / d (both positive) as the nearest double, ties to even: the quotient is taken to the last bit a double of its size
// can hold (subnormals hold fewer), and the remainder decides the rounding. With UInt128, n and d are below 2^63, so
// that no shift below leaves 128 bits.
template <class N>
double divide_rounded(N n, N d) {
  int exponent = highest_bit(n) - highest_bit(d);  // of the quotient, or one too many
  if (exponent >= 0 ? n < N(d << exponent) : N(n << -exponent) < d) --exponent;
  if (exponent > 1023) return std::numeric_limits<double>::infinity();
  const int last_bit = std::max(exponent - 52, -1074);
  if (last_bit < 0) {
    n <<= -last_bit;
  } else {
    d <<= last_bit;
  }
  const N quotient = n / d;
  const N twice_rest = N(n - quotient * d) << 1;
  auto mantissa = static_cast<std::uint64_t>(quotient);  // below 2^53
  if (twice_rest > d || (twice_rest == d && (mantissa & 1) != 0)) ++mantissa;
  return std::ldexp(static_cast<double>(mantissa), last_bit);
}

double nearest_double(const Rational& x) {
  const Integer n = mp::numerator(x);
  if (n == 0) return 0;
  const double magnitude = divide_rounded<Integer>(mp::abs(n), mp::denominator(x));
  return n < 0 ? -magnitude : magnitude;
}

bool is_digit(char c) { return '0' <= c && c <= '9'; }

// The digits at the front of `text`, removed from it.
std::string_view take_digits(std::string_view& text) {
  const auto length = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
  const std::string_view digits = text.substr(0, length);
  text.remove_prefix(length);
  return digits;
}

// Appends decimal digits to a number: 18 at a time, as many as 64 bits hold.
void append_digits(Integer& number, std::string_view digits) {
  while (!digits.empty()) {
    const std::string_view chunk = digits.substr(0, 18);
    std::uint64_t value = 0, scale = 1;
    for (const char c : chunk) {
      value = 10 * value + static_cast<std::uint64_t>(c - '0');
      scale *= 10;
    }
    number = number * scale + value;
    digits.remove_prefix(chunk.size());
  }
}

std::int64_t small_digits(std::int64_t number, std::string_view digits) {
  for (const char c : digits) number = 10 * number + (c - '0');
  return number;
}

std::int64_t power_of_ten(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

std::optional<std::int64_t> integer_sqrt(std::int64_t n) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  while (Int128{root} * root > n) --root;
  while (Int128{root + 1} * (root + 1) <= n) ++root;
  return root * root == n ? std::optional(root) : std::nullopt;
}

std::optional<Integer> integer_sqrt(const Integer& n) {
  Integer rest;
  const Integer root = mp::sqrt(n, rest);
  return rest == 0 ? std::optional(root) : std::nullopt;
}

}  // namespace

struct Exact::Big {
  Rational value;
};

namespace {

thread_local std::uint64_t work_left = std::numeric_limits<std::uint64_t>::max();

void charge(const Rational& result) {
  const std::uint64_t words = mp::numerator(result).backend().size() + mp::denominator(result).backend().size();
  const std::uint64_t work = words * words;
  if (work > work_left) throw ExactTooLarge{};
  work_left -= work;
}

}  // namespace

ExactBudget::ExactBudget(std::uint64_t work) : outside_(work_left) { work_left = std::min(work, outside_); }
ExactBudget::~ExactBudget() { work_left = outside_; }

// What the functions of this file need of the inside of a number. A number that fits in 64 bits is always stored small,
// so that each value has one representation.
struct ExactAccess {
  static Rational rational(const Exact& x) {
    if (x.kind_ == Exact::Kind::big) return x.big_->value;
    return Rational(Integer(x.num_), Integer(x.den_));
  }

  static Exact small(std::int64_t num, std::int64_t den) {
    Exact result;
    result.num_ = num;
    result.den_ = den;
    return result;
  }

  // num/den, which are already in lowest terms with den > 0.
  static Exact reduced(Int128 num, Int128 den) {
    if (fits(num) && fits(den)) return small(static_cast<std::int64_t>(num), static_cast<std::int64_t>(den));
    return big(Rational(to_integer(num), to_integer(den)));
  }

  static Exact from(Rational value) {
    const Integer num = mp::numerator(value), den = mp::denominator(value);
    if (-small_max <= num && num <= small_max && den <= small_max) {
      return small(static_cast<std::int64_t>(num), static_cast<std::int64_t>(den));
    }
    return big(std::move(value));
  }

  static Exact approximate(double value) {  // unlike Exact::approximate, may have overflowed
    Exact result;
    result.kind_ = Exact::Kind::approximate;
    result.approximate_ = value;
    return result;
  }

  static bool both_small(const Exact& a, const Exact& b) {
    return a.kind_ == Exact::Kind::small && b.kind_ == Exact::Kind::small;
  }

  static bool any_approximate(const Exact& a, const Exact& b) { return a.is_approximate() || b.is_approximate(); }

  // a + b or a - b. With g = gcd of the denominators only g can still divide the sum (Knuth, TAOCP 2, 4.5.1), so that
  // 64-bit gcds do. |num| and den are below 2^63: each product below 2^126, the sum below 2^127.
  template <bool minus>
  static Exact sum(const Exact& a, const Exact& b) {
    if (both_small(a, b)) {
      const Int128 b_num = minus ? -Int128{b.num_} : Int128{b.num_};
      if (a.den_ == 1 && b.den_ == 1) return reduced(a.num_ + b_num, 1);
      const std::int64_t g = std::gcd(a.den_, b.den_);
      const Int128 num = Int128{a.num_} * (b.den_ / g) + b_num * (a.den_ / g);
      const std::int64_t g2 = g == 1 ? 1 : std::gcd(static_cast<std::int64_t>(num % g), g);
      return reduced(num / g2, Int128{a.den_ / g} * (b.den_ / g2));
    }
    if (any_approximate(a, b))
      return approximate(minus ? a.to_double() - b.to_double() : a.to_double() + b.to_double());
    return from(minus ? rational(a) - rational(b) : rational(a) + rational(b));
  }

  static Exact product(const Exact& a, const Exact& b) {
    if (both_small(a, b)) {
      const std::int64_t g1 = std::gcd(a.num_, b.den_), g2 = std::gcd(b.num_, a.den_);
      return reduced(Int128{a.num_ / g1} * (b.num_ / g2), Int128{a.den_ / g2} * (b.den_ / g1));
    }
    if (any_approximate(a, b)) return approximate(a.to_double() * b.to_double());
    return from(rational(a) * rational(b));
  }

  static Exact quotient(const Exact& a, const Exact& b) {
    assert(b != Exact(0));
    if (both_small(a, b)) {
      return product(a, b.num_ < 0 ? small(-b.den_, -b.num_) : small(b.den_, b.num_));
    }
    if (any_approximate(a, b)) return approximate(a.to_double() / b.to_double());
    return from(rational(a) / rational(b));
  }

 private:
  static Exact big(Rational value) {
    charge(value);
    Exact result;
    result.big_ = new Exact::Big{std::move(value)};
    result.kind_ = Exact::Kind::big;
    return result;
  }
};

Exact::Exact(std::int64_t n) noexcept : num_(n) {
  if (n < -small_max) *this = ExactAccess::from(Rational(n));
}

Exact::Exact(double value) {
  assert(std::isfinite(value));
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const Integer power = Integer(1) << std::abs(exponent);
  *this = ExactAccess::from(exponent < 0 ? Rational(Integer(mantissa), power) : Rational(Integer(mantissa) * power));
}

Exact Exact::ratio(std::int64_t n, std::int64_t d) {
  assert(d != 0);
  return Exact(n) / Exact(d);
}

Exact Exact::approximate(double value) {
  assert(std::isfinite(value));
  return ExactAccess::approximate(value);
}

std::optional<Exact> Exact::parse(std::string_view text) {
  constexpr std::size_t max_length = 400;
  constexpr int max_exponent = 400;
  if (text.size() > max_length) return std::nullopt;

  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const std::string_view whole = take_digits(text);

  if (text.starts_with('/')) {
    text.remove_prefix(1);
    const std::string_view below = take_digits(text);
    if (whole.empty() || below.empty() || !text.empty()) return std::nullopt;
    if (whole.size() <= 18 && below.size() <= 18) {
      const std::int64_t num = small_digits(0, whole), den = small_digits(0, below);
      if (den == 0) return std::nullopt;
      return ratio(negative ? -num : num, den);
    }
    Integer num = 0, den = 0;
    append_digits(num, whole);
    append_digits(den, below);
    if (den == 0) return std::nullopt;
    return ExactAccess::from(Rational(negative ? Integer(-num) : num, den));
  }

  std::string_view decimals;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    decimals = take_digits(text);
  }
  if (whole.empty() && decimals.empty()) return std::nullopt;

  int exponent = 0;
  if (text.starts_with('e') || text.starts_with('E')) {
    text.remove_prefix(1);
    const bool below_one = text.starts_with('-');
    if (below_one || text.starts_with('+')) text.remove_prefix(1);
    const std::string_view digits = take_digits(text);
    if (digits.empty()) return std::nullopt;
    for (const char c : digits) exponent = std::min(10 * exponent + (c - '0'), max_exponent + 1);
    if (exponent > max_exponent) return std::nullopt;
    if (below_one) exponent = -exponent;
  }
  if (!text.empty()) return std::nullopt;

  exponent -= static_cast<int>(decimals.size());
  if (whole.size() + decimals.size() <= 18 && -18 <= exponent && exponent <= 0) {
    const std::int64_t digits = small_digits(small_digits(0, whole), decimals);
    return ratio(negative ? -digits : digits, power_of_ten(-exponent));
  }
  Integer digits = 0;
  append_digits(digits, whole);
  append_digits(digits, decimals);
  if (negative) digits = -digits;
  const Integer power = mp::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  return ExactAccess::from(exponent < 0 ? Rational(digits, power) : Rational(digits * power));
}

Exact::Exact(const Exact& other) : kind_(other.kind_), den_(other.den_) {
  switch (kind_) {
    case Kind::small:
      num_ = other.num_;
      break;
    case Kind::big:
      big_ = new Big(*other.big_);
      break;
    case Kind::approximate:
      approximate_ = other.approximate_;
      break;
  }
}

Exact::Exact(Exact&& other) noexcept { *this = std::move(other); }

Exact& Exact::operator=(const Exact& other) {
  if (this != &other) *this = Exact(other);
  return *this;
}

// What was moved from is 0.
Exact& Exact::operator=(Exact&& other) noexcept {
  if (this == &other) return *this;
  if (kind_ == Kind::big) delete big_;
  kind_ = other.kind_;
  den_ = other.den_;
  switch (kind_) {
    case Kind::small:
      num_ = other.num_;
      break;
    case Kind::big:
      big_ = other.big_;
      break;
    case Kind::approximate:
      approximate_ = other.approximate_;
      break;
  }
  other.kind_ = Kind::small;
  other.num_ = 0;
  other.den_ = 1;
  return *this;
}

Exact::~Exact() {
  if (kind_ == Kind::big) delete big_;
}

bool Exact::is_integer() const noexcept {
  switch (kind_) {
    case Kind::small:
      return den_ == 1;
    case Kind::big:
      return mp::denominator(big_->value) == 1;
    case Kind::approximate:
      return std::isfinite(approximate_) && std::trunc(approximate_) == approximate_;
  }
  return false;
}

double Exact::to_double() const {
  constexpr std::int64_t exact_in_double = std::int64_t{1} << 53;
  switch (kind_) {
    case Kind::small:
      if (-exact_in_double <= num_ && num_ <= exact_in_double && den_ <= exact_in_double) {
        return static_cast<double>(num_) / static_cast<double>(den_);  // IEEE division rounds correctly
      }
      return num_ < 0 ? -divide_rounded<UInt128>(static_cast<UInt128>(-num_), static_cast<UInt128>(den_))
                      : divide_rounded<UInt128>(static_cast<UInt128>(num_), static_cast<UInt128>(den_));
    case Kind::big:
      return nearest_double(big_->value);
    case Kind::approximate:
      return approximate_;
  }
  return 0;
}

std::string Exact::to_string() const {
  switch (kind_) {
    case Kind::small:
      return den_ == 1 ? std::to_string(num_) : std::to_string(num_) + "/" + std::to_string(den_);
    case Kind::big:
      return big_->value.str();
    case Kind::approximate:
      return format_number(approximate_);
  }
  return {};
}

Exact Exact::operator-() const {
  switch (kind_) {
    case Kind::small:
      return ExactAccess::small(-num_, den_);
    case Kind::big:
      return ExactAccess::from(-big_->value);
    case Kind::approximate:
      return ExactAccess::approximate(-approximate_);
  }
  return {};
}

Exact& Exact::operator+=(const Exact& b) { return *this = ExactAccess::sum<false>(*this, b); }
Exact& Exact::operator-=(const Exact& b) { return *this = ExactAccess::sum<true>(*this, b); }
Exact& Exact::operator*=(const Exact& b) { return *this = ExactAccess::product(*this, b); }
Exact& Exact::operator/=(const Exact& b) { return *this = ExactAccess::quotient(*this, b); }

bool operator==(const Exact& a, const Exact& b) {
  if (ExactAccess::both_small(a, b)) return a.num_ == b.num_ && a.den_ == b.den_;
  return (a <=> b) == 0;
}

std::strong_ordering operator<=>(const Exact& a, const Exact& b) {
  if (ExactAccess::both_small(a, b)) return Int128{a.num_} * b.den_ <=> Int128{b.num_} * a.den_;
  if (ExactAccess::any_approximate(a, b)) {
    const double x = a.to_double(), y = b.to_double();
    if (x < y) return std::strong_ordering::less;
    if (x > y) return std::strong_ordering::greater;
    if (x == y) return std::strong_ordering::equal;
    return std::strong_order(x, y);  // only an overflow can have made one of them no number
  }
  const int order = ExactAccess::rational(a).compare(ExactAccess::rational(b));
  return order <=> 0;
}

Exact abs(const Exact& x) { return x < Exact(0) ? -x : x; }

Exact sqrt(const Exact& x) {
  // One that overflowed may be no number any more, and has no order: its root is none, either.
  if (x.kind_ == Exact::Kind::approximate) return ExactAccess::approximate(std::sqrt(x.approximate_));
  assert(x >= Exact(0));
  if (x.kind_ == Exact::Kind::small) {
    const auto num = integer_sqrt(x.num_), den = integer_sqrt(x.den_);
    if (num && den) return ExactAccess::small(*num, *den);
    return ExactAccess::approximate(std::sqrt(x.to_double()));
  }
  const Integer n = mp::numerator(x.big_->value), d = mp::denominator(x.big_->value);
  const auto num = integer_sqrt(n), den = integer_sqrt(d);
  if (num && den) return ExactAccess::from(Rational(*num, *den));
  // A square may be beyond what a double holds where its root is not: scale by an even power of two first.
  const int half_exponent = (highest_bit(n) - highest_bit(d)) / 2;
  const Integer power = Integer(1) << (2 * std::abs(half_exponent));
  const double scaled =
      half_exponent < 0 ? nearest_double(Rational(n * power, d)) : nearest_double(Rational(n, d * power));
  return ExactAccess::approximate(std::ldexp(std::sqrt(scaled), half_exponent));
}

}  // namespace blossom
