#pragma once
// What the edits share: how what was changed is checked, and which knot goes with a point.

#include "base/diagnostics.hpp"
#include "studio/workspace.hpp"

namespace blossom::edit::parts {

inline Diagnostic wrong(std::string path, std::string message) {
  return {"", 0, 0, std::move(path), std::move(message)};
}
inline Diagnostics refused(std::string path, std::string message) {
  return {wrong(std::move(path), std::move(message))};
}
// "points[3]"
inline std::string at(std::string_view list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

// Diagnostics of a thing's geometry, with its name before their paths.
Diagnostics about_object(const SceneObject&, Diagnostics);

// What the reader of files makes of it: exact and valid, or what is wrong.
Checked<Curve<Exact>> as_read(const Curve<Exact>&);
Checked<Surface<Exact>> as_read(const Surface<Exact>&);
Checked<Geometry> as_read(const Geometry&);

// Whether files can hold a number as a coordinate: moving a point to such a place changes nothing else, so that a long
// curve need not be read again many times in a second.
bool is_readable(const Exact&);
bool is_readable(const Point<Exact>&, const Exact& weight);

HPoint<Exact> weighted(const Point<Exact>&, const Exact& weight, int dimension);

// ---- knots along one direction, with `count` control points
// -----------------------------------------------------------

std::vector<Exact> clamped_uniform_knots(const Exact& a, const Exact& b, int degree, std::size_t count);
std::vector<Exact> unclamped_uniform_knots(const Exact& a, const Exact& b, int degree, std::size_t count);

// The longest span of the domain in u_first..u_last; of the whole domain if there is none. Its end is at index + 1.
std::size_t longest_span(const std::vector<Exact>& U, int degree, std::size_t count, std::size_t first,
                         std::size_t last);
// The inner knot nearest to where the point has most influence: the mean of its p knots (Greville).
std::size_t knot_near(const std::vector<Exact>& U, int degree, std::size_t count, std::size_t point);
// A knot more for a point behind `behind` (SIZE_MAX: before the first): the middle of the longest span near it.
void add_knot(std::vector<Exact>& U, int degree, std::size_t count, std::size_t behind);

// The knot of this index, or all that equal it, become `value`, if they stay in order; `list` is what the path begins
// with.
std::optional<Diagnostic> change_knots(std::vector<Exact>& U, std::size_t index, const Exact& value, bool equal_ones,
                                       const std::string& list);

template <class T>
void insert_at(std::vector<T>& list, std::size_t index, T item) {
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(index), std::move(item));
}
template <class T>
void erase_at(std::vector<T>& list, std::size_t index) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace blossom::edit::parts
