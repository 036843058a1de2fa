#pragma once
// Exact rational numbers, and the honest way out of them.
//
// Every number a student types ("2/5", 0.1) is a rational, and every algorithm on curves and surfaces that only blends
// points stays rational. What leaves the rationals (a chord length is a square root) goes on in double precision and is
// marked: is_approximate() is contagious, so one asks any result whether it is exact.
//
// Storage: numerator and denominator in 64 bits while they fit (nearly always, in teaching), otherwise a
// Boost.Multiprecision rational on the heap. The header stays free of Boost on purpose: it is read by every file.

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace blossom {

class Exact {
 public:
  Exact() noexcept = default;         // 0
  Exact(int n) noexcept : num_(n) {}  // NOLINT: integers are rationals
  Exact(std::int64_t n) noexcept;     // NOLINT (INT64_MIN is stored big)
  explicit Exact(double value);       // the double's own value (a dyadic rational); precondition: finite
  static Exact ratio(std::int64_t n, std::int64_t d);  // n/d in lowest terms; precondition: d != 0
  static Exact approximate(double value);              // known only in double precision; precondition: finite

  // "7", "-3/2", "0.4", ".5", "5.", "+1.5e-3"; a fraction is of whole numbers. Nothing if the text is no number, or is
  // hostile: more than 400 characters, a decimal exponent beyond +-400, a denominator of zero. Leading and trailing
  // blanks are not accepted.
  static std::optional<Exact> parse(std::string_view text);

  Exact(const Exact&);
  Exact(Exact&&) noexcept;
  Exact& operator=(const Exact&);
  Exact& operator=(Exact&&) noexcept;
  ~Exact();

  bool is_approximate() const noexcept { return kind_ == Kind::approximate; }
  bool is_integer() const noexcept;
  double to_double() const;       // the nearest double, ties to even
  std::string to_string() const;  // "p/q" or "p" in lowest terms; an approximate value: the shortest decimal

  Exact operator-() const;
  Exact& operator+=(const Exact&);
  Exact& operator-=(const Exact&);
  Exact& operator*=(const Exact&);
  Exact& operator/=(const Exact&);  // precondition: the divisor is not zero
  friend Exact operator+(Exact a, const Exact& b) { return a += b; }
  friend Exact operator-(Exact a, const Exact& b) { return a -= b; }
  friend Exact operator*(Exact a, const Exact& b) { return a *= b; }
  friend Exact operator/(Exact a, const Exact& b) { return a /= b; }
  // An approximate value compares by its double.
  friend bool operator==(const Exact&, const Exact&);
  friend std::strong_ordering operator<=>(const Exact&, const Exact&);

 private:
  struct Big;  // holds a boost::multiprecision::cpp_rational
  enum class Kind : std::uint8_t { small, big, approximate };

  Kind kind_ = Kind::small;
  union {
    std::int64_t num_ = 0;
    Big* big_;
    double approximate_;
  };
  std::int64_t den_ = 1;  // > 0, and gcd(num_, den_) == 1, when kind_ is small

  friend struct ExactAccess;
  friend Exact sqrt(const Exact&);
};

// A bound on what exact arithmetic may cost in this thread while the object lives. Numbers can grow longer with every
// operation, so a short input can mean hours; the operation that goes beyond the bound throws ExactTooLarge. `work`
// counts squared 64-bit words of results beyond 64 bits: 100 million are about a second. Of nested ones, the least.
class ExactBudget {
 public:
  explicit ExactBudget(std::uint64_t work);
  ExactBudget(const ExactBudget&) = delete;
  ExactBudget& operator=(const ExactBudget&) = delete;
  ~ExactBudget();

 private:
  std::uint64_t outside_;
};
struct ExactTooLarge {};

Exact abs(const Exact&);
Exact sqrt(const Exact&);  // exact where the root is rational, otherwise approximate; precondition: not negative

}  // namespace blossom
