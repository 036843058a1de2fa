#pragma once
// "vary" of an exercise, read and checked: what is drawn, and what a draw must be. See variant.hpp for the format and
// VARIANTS.md for its meaning.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grader/exercise.hpp"

namespace blossom {

// The values a place can take, by number: from, from + step, ...; or those of a table.
struct Choices {
  std::uint64_t count = 0;
  Exact from = 0;
  Exact step = 1;
  std::vector<Json> table;  // empty: the values above

  Json value(std::uint64_t n) const;
};

// Where a drawn value goes: the way into "inputs" by the positions of members and items.
using JsonPath = std::vector<std::uint32_t>;
struct Slot {
  JsonPath path;
  std::size_t choices = 0;
  std::size_t entry = 0;       // of "inputs"
  std::size_t coordinate = 0;  // of a grid's point
  std::string name;            // "curve.points[1][0]"
};

// A demand on the control points of each curve.
using PlainPoint = std::array<Exact, 3>;
struct Requirement {
  std::string_view words;
  bool only_in_plane;
  bool (*met)(std::span<const PlainPoint>);
};
const std::vector<Requirement>& requirements();

struct Vary {
  std::vector<Choices> choices;
  std::vector<Slot> slots;          // in the order they are drawn
  std::vector<JsonPath> no_knots;   // numbers that must not be a knot of `knots_of`
  JsonPath knots_of;                // a curve
  std::vector<JsonPath> points_of;  // all curves
  std::vector<const Requirement*> require;
  std::optional<Exact> denominator;  // nothing: 100, or the model's largest
  Exact likeness = Exact::ratio(3, 2);
  std::optional<Tolerance> tolerance;     // that draws are judged by; nothing: the asked values' own
  std::vector<std::vector<char>> except;  // by misconception, by part
};

// Every mistake is reported at its place. `inputs` is the exercise's, `exercise` what was read of it so far: its run
// and its parts.
Vary read_vary(const Cursor& vary, const Cursor& inputs, const Exercise& exercise);

// The value at a path; null where a drawn value has no such item.
const Json& at_path(const Json& inputs, const JsonPath& path);
// The same, to change it. Precondition: there is one.
Json& at_path(Json& inputs, const JsonPath& path);

}  // namespace blossom
