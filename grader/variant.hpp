#pragma once
// Each student's own numbers. An exercise may say which of its inputs vary and how:
//
//   "vary": {
//     "inputs": [
//       {"at": "curve.points[1..2]", "grid": {"from": [-6, -6], "to": [6, 6], "step": 1}},
//       {"at": "u", "fractions": {"denominators": [3, 4, 5], "from": 0, "to": 1}, "not": "a knot"},
//       {"at": "curve.weights[1]", "integers": [2, 5]},
//       {"at": "curve.knots", "choose": [[0, 0, 0, 1, 2, 2, 2], [0, 0, 0, 1, 3, 3, 3]]}
//     ],
//     "require"?: ["points distinct", "points convex", "no three points collinear", "x increasing"],
//     "denominator"?: n, "likeness"?: x, "tolerance"?: {"decimals": 4},
//     "except"?: [{"misconception": id, "value": selector}, ...]
//   }
//
// "at" is a path into "inputs"; [a..b] and [*] mean several places, each of which is drawn for itself. A grid is for
// points, integers and fractions (in lowest terms, of these denominators) for numbers, choose for anything.
//
// A variant is a plain exercise without "vary": the same file with other inputs. It is a function of the exercise, the
// student's ID and a secret, the same on every platform and for ever. VARIANTS.md beside this file says how it is
// drawn, bit for bit, and when a draw is acceptable, so that anybody can draw it again; tests hold golden values.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/json.hpp"

namespace blossom {

// A uniform stream of numbers from a secret. No state but its place.
//   key   = HMAC-SHA-256(secret, "blossom.variant/1\n" exercise id "\n" student id)
//   block = HMAC-SHA-256(key, number of the block as 8 bytes, most significant first), as four 64-bit numbers likewise
//   a number below n = the next of them that is below the largest multiple of n that 64 bits hold, modulo n
class VariantStream {
 public:
  VariantStream(std::string_view secret, std::string_view exercise_id, std::string_view student_id);
  std::uint64_t below(std::uint64_t n);  // uniform in [0, n); precondition: n > 0

 private:
  std::uint64_t next();
  std::string key_;
  std::uint64_t block_ = 0;
  std::uint64_t words_[4] = {};
  int used_ = 4;
};

bool varies(const JsonDocument& exercise);

// Makes the variants of one exercise: what all of them have in common is worked out once.
class VariantMaker {
 public:
  explicit VariantMaker(const JsonDocument& exercise);  // precondition: read_exercise accepts it, and it varies

  // The variant's document, ready for read_exercise. A diagnostic when no acceptable draw was found within the limit of
  // draws. Thread-safe.
  Checked<JsonDocument> make(std::string_view student_id, std::string_view secret) const;

  // Whether acceptable variants can be drawn: see check_variants.
  Diagnostics check() const;

  struct Prepared;  // see variant_trial.hpp

 private:
  std::shared_ptr<const Prepared> prepared_;
};

// The same for one student; the document itself where nothing varies.
Checked<JsonDocument> make_variant(const JsonDocument& exercise, std::string_view student_id, std::string_view secret);

// For lint: whether acceptable variants can be drawn, and which demand the ranges cannot meet and why ("swapped-weights
// gives the right value of P[1][0] in each of 64 draws: ..."), at the place in the file. Draws do not depend on a
// secret. Precondition: read_exercise accepts the exercise.
Diagnostics check_variants(const JsonDocument& exercise);

// The secret of a course: the bytes of a file, without a last line break; at least 16 of them, at most 4096.
Checked<std::string> load_secret(const std::filesystem::path&);

}  // namespace blossom
