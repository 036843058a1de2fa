#include "studio/edit_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/document.hpp"

namespace blossom::edit::parts {
namespace {

constexpr std::size_t most_in_a_row = 65'536;
constexpr JsonLimits own_text{std::numeric_limits<std::uint32_t>::max(), 32, std::numeric_limits<std::size_t>::max()};

// Lines and columns are of a text that nobody has seen.
Diagnostics without_places(Diagnostics diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    diagnostic.file.clear();
    diagnostic.line = diagnostic.column = 0;
  }
  return diagnostics;
}

template <class T, class Read>
Checked<T> read_back(const std::string& text, Read&& read) {
  const auto document = JsonDocument::parse("geometry", text, own_text);
  if (!document) return without_places(document.diagnostics);
  Diagnostics diagnostics;
  if (auto value = read(Cursor(*document, diagnostics))) return T(std::move(*value));
  return without_places(std::move(diagnostics));
}

}  // namespace

Diagnostics about_object(const SceneObject& object, Diagnostics diagnostics) {
  for (Diagnostic& each : diagnostics) each.path = object.name + (each.path.empty() ? "" : "." + each.path);
  return diagnostics;
}

Checked<Curve<Exact>> as_read(const Curve<Exact>& curve) {
  return read_back<Curve<Exact>>(write_curve(curve), [](const Cursor& cursor) { return read_curve(cursor); });
}

Checked<Surface<Exact>> as_read(const Surface<Exact>& surface) {
  return read_back<Surface<Exact>>(write_surface(surface), [](const Cursor& cursor) { return read_surface(cursor); });
}

Checked<Geometry> as_read(const Geometry& geometry) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry))
    return read_back<Geometry>(write_curve(*curve), [](const Cursor& cursor) { return read_curve(cursor); });
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry))
    return read_back<Geometry>(write_surface(*surface), [](const Cursor& cursor) { return read_surface(cursor); });
  if (const auto* row = std::get_if<PointRow<Exact>>(&geometry))
    return read_back<Geometry>(write_points(*row),
                               [](const Cursor& cursor) { return read_points(cursor, 1, most_in_a_row); });
  return read_back<Geometry>(write_net(std::get<PointNet<Exact>>(geometry)),
                             [](const Cursor& cursor) { return read_net(cursor); });
}

bool is_readable(const Exact& x) {
  constexpr std::size_t longest = 400;
  return !x.is_approximate() && std::isfinite(x.to_double()) && x.to_string().size() <= longest;
}

bool is_readable(const Point<Exact>& P, const Exact& weight) {
  const double w = weight.to_double();
  return is_readable(P.x) && is_readable(P.y) && is_readable(P.z) &&
         std::isfinite((P.x.to_double() + P.y.to_double() + P.z.to_double()) * w);
}

HPoint<Exact> weighted(const Point<Exact>& P, const Exact& w, int dimension) {
  return {P.x * w, P.y * w, dimension == 3 ? P.z * w : Exact(0), w};
}

// ---- knots ----------------------------------------------------------------------------------------------------------

std::vector<Exact> clamped_uniform_knots(const Exact& a, const Exact& b, int degree, std::size_t count) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<Exact> knots(p + 1, a);
  const std::size_t spans = count - p;
  for (std::size_t i = 1; i < spans; ++i)
    knots.push_back(a + (b - a) * Exact::ratio(static_cast<std::int64_t>(i), static_cast<std::int64_t>(spans)));
  knots.insert(knots.end(), p + 1, b);
  return knots;
}

std::vector<Exact> unclamped_uniform_knots(const Exact& a, const Exact& b, int degree, std::size_t count) {
  const int last = static_cast<int>(count) + degree, spans = static_cast<int>(count) - degree;
  std::vector<Exact> knots;
  for (int i = 0; i <= last; ++i) knots.push_back(a + (b - a) * Exact::ratio(i - degree, spans));
  return knots;
}

std::size_t longest_span(const std::vector<Exact>& U, int degree, std::size_t count, std::size_t first,
                         std::size_t last) {
  const auto begin = static_cast<std::size_t>(degree);
  const auto longest = [&](std::size_t from, std::size_t to) {
    std::size_t best = from;
    for (std::size_t i = from; i < to; ++i)
      if (U[best + 1] - U[best] < U[i + 1] - U[i]) best = i;
    return best;
  };
  const std::size_t from = std::max(first, begin), to = std::min(last, count);
  if (from < to)
    if (const std::size_t best = longest(from, to); U[best] < U[best + 1]) return best;
  return longest(begin, count);
}

std::size_t knot_near(const std::vector<Exact>& U, int degree, std::size_t count, std::size_t point) {
  const auto p = static_cast<std::size_t>(degree);
  Exact place = 0;
  for (std::size_t i = point + 1; i <= point + p; ++i) place += U[i];
  place /= Exact(degree);
  std::size_t best = p + 1;
  for (std::size_t i = p + 1; i < count; ++i)
    if (abs(U[i] - place) < abs(U[best] - place)) best = i;
  return best;
}

void add_knot(std::vector<Exact>& U, int degree, std::size_t count, std::size_t behind) {
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t point = behind == SIZE_MAX ? 0 : behind;
  const std::size_t span = longest_span(U, degree, count, point, point + p + 2);
  insert_at(U, span + 1, Exact((U[span] + U[span + 1]) / Exact(2)));
}

std::optional<Diagnostic> change_knots(std::vector<Exact>& U, std::size_t index, const Exact& value, bool equal_ones,
                                       const std::string& list) {
  const std::string place = at(list, index);
  if (index >= U.size()) return wrong(place, "there is no such knot");
  std::size_t first = index, last = index;
  while (equal_ones && first > 0 && U[first - 1] == U[index]) --first;
  while (equal_ones && last + 1 < U.size() && U[last + 1] == U[index]) ++last;
  const auto named = [&](std::size_t i) { return "u_" + std::to_string(i) + " = " + format_brief(U[i]); };
  if (first > 0 && value < U[first - 1])
    return wrong(place,
                 "knots must not decrease: it must be at least " + named(first - 1) + ", not " + format_brief(value));
  if (last + 1 < U.size() && U[last + 1] < value)
    return wrong(place,
                 "knots must not decrease: it must be at most " + named(last + 1) + ", not " + format_brief(value));
  std::fill(U.begin() + static_cast<std::ptrdiff_t>(first), U.begin() + static_cast<std::ptrdiff_t>(last) + 1, value);
  return std::nullopt;
}

}  // namespace blossom::edit::parts
