#pragma once
// What files about an algorithm have in common (lessons, exercises): the schema's name and version, an id, the
// algorithm and its inputs. Each reader reports its mistakes at their places and returns nothing when there was one.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "algorithms/run.hpp"

namespace blossom {

// "schema" must be exactly `expected` ("blossom.lesson/1"); another version of it says so.
bool expect_schema(const Cursor& root, std::string_view expected);

// An id stands in answers, reports and file names: 1 to 64 of a-z, 0-9 and -.
std::optional<std::string> read_id(const Cursor&);

// When predictions are marked: each as it is made, or all of them at the end. In files "at-once" and "at-end".
enum class Marking : std::uint8_t { at_once, at_end };
std::optional<Marking> read_marking(const Cursor&);
std::string_view marking_name(Marking);

// A text that is not empty.
std::optional<std::string> read_text(const Cursor&);

// What is said of an algorithm that does not exist: which one may be meant, or which there are.
std::string no_such_algorithm(std::string_view id);

// The member "algorithm" of the root; nullptr with a diagnostic (and "did you mean") if it is none.
const Algorithm* read_algorithm(const Cursor& root);

// Reads "inputs" as this algorithm's and records the exact run. What turns out impossible only on the way (the weight
// at u is 0) is reported at the input that causes it.
std::optional<Run<Exact>> read_run(const Cursor& root, const Algorithm&);

}  // namespace blossom
