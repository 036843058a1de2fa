// Edits of surfaces; rows and columns are changed by the same rules as the points of a curve.

#include <algorithm>

#include "kernel/degree_elevation.hpp"
#include "studio/edit_curve.hpp"
#include "studio/edit_parts.hpp"

namespace blossom {
namespace edit {

using namespace parts;

namespace {

int count_along(const Surface<Exact>& surface, int direction) {
  return direction == 0 ? surface.rows : surface.columns;
}

// A row of the net (direction 0: those of one i) as points, and the net of such rows.
using Row = std::vector<HPoint<Exact>>;
std::vector<Row> rows_of(const Surface<Exact>& surface, int direction) {
  std::vector<Row> rows(static_cast<std::size_t>(count_along(surface, direction)));
  for (int i = 0; i < surface.rows; ++i)
    for (int j = 0; j < surface.columns; ++j)
      rows[static_cast<std::size_t>(direction == 0 ? i : j)].push_back(surface.at(i, j));
  return rows;
}
void set_rows(Surface<Exact>& surface, int direction, const std::vector<Row>& rows) {
  const int along = static_cast<int>(rows.size()), across = static_cast<int>(rows.front().size());
  surface.rows = direction == 0 ? along : across;
  surface.columns = direction == 0 ? across : along;
  surface.points.assign(static_cast<std::size_t>(along) * across, {});
  for (int a = 0; a < along; ++a)
    for (int b = 0; b < across; ++b)
      (direction == 0 ? surface.at(a, b) : surface.at(b, a)) =
          rows[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
}

std::string in_net(std::string_view list, int i, int j) {
  return std::string(list) + "[" + std::to_string(i) + "][" + std::to_string(j) + "]";
}
std::string in_direction(std::string_view list, int direction) {
  return std::string(list) + "[" + std::to_string(direction) + "]";
}
std::string rows_word(int direction) { return direction == 0 ? "rows" : "columns"; }

std::optional<Diagnostics> no_such_point(const Surface<Exact>& surface, int i, int j, std::string_view list) {
  if (i >= 0 && i < surface.rows && j >= 0 && j < surface.columns) return std::nullopt;
  return refused(in_net(list, i, j), "there is no such control point");
}

}  // namespace

EditedSurface move_point(Surface<Exact> surface, int i, int j, const Point<Exact>& to) {
  if (auto none = no_such_point(surface, i, j, "points")) return *none;
  HPoint<Exact>& P = surface.at(i, j);
  if (P.w == Exact(0))
    return refused(in_net("weights", i, j), "is 0, so that the point has no place; give it a positive weight first");
  P = weighted(to, P.w, 3);
  if (is_readable(to, P.w)) return surface;
  return as_read(surface);
}

EditedSurface set_weight(Surface<Exact> surface, int i, int j, const Exact& weight) {
  if (auto none = no_such_point(surface, i, j, "weights")) return *none;
  HPoint<Exact>& P = surface.at(i, j);
  P = weighted(affine(P), weight, 3);
  surface.rational = surface.rational || weight != Exact(1);
  return as_read(surface);
}

namespace {

EditedSurface change_knots_of(Surface<Exact> surface, int direction, std::size_t index, const Exact& value,
                              bool equal_ones) {
  auto& U = surface.knots[static_cast<std::size_t>(direction)];
  if (auto wrong = change_knots(U, index, value, equal_ones, in_direction("knots", direction)))
    return Diagnostics{*std::move(wrong)};
  return as_read(surface);
}

}  // namespace

EditedSurface set_knot(Surface<Exact> surface, int direction, std::size_t index, const Exact& value) {
  return change_knots_of(std::move(surface), direction, index, value, false);
}
EditedSurface set_equal_knots(Surface<Exact> surface, int direction, std::size_t index, const Exact& value) {
  return change_knots_of(std::move(surface), direction, index, value, true);
}
EditedSurface set_knots(Surface<Exact> surface, int direction, std::vector<Exact> knots) {
  surface.knots[static_cast<std::size_t>(direction)] = std::move(knots);
  surface.bezier = false;
  return as_read(surface);
}

EditedSurface set_degree(Surface<Exact> surface, int direction, int degree) {
  const auto d = static_cast<std::size_t>(direction);
  const int count = count_along(surface, direction);
  const int most = surface.bezier ? max_degree : std::min(max_degree, count - 1);
  if (degree < 1 || degree > most)
    return refused(in_direction("degree", direction),
                   "must be from 1 to " + std::to_string(most) +
                       (most < max_degree ? " (" + std::to_string(count) + " " + rows_word(direction) + ")" : "") +
                       ", not " + std::to_string(degree));
  if (degree == surface.degree[d]) return surface;
  auto& U = surface.knots[d];
  if (!surface.bezier) {
    const auto p = static_cast<std::size_t>(surface.degree[d]), n = static_cast<std::size_t>(count);
    const bool clamped = U[0] == U[p] && U[n] == U.back();
    const Exact a = U[p], b = U[n];
    U = clamped ? clamped_uniform_knots(a, b, degree, n) : unclamped_uniform_knots(a, b, degree, n);
    surface.degree[d] = degree;
    return as_read(surface);
  }
  std::vector<Row> rows = rows_of(surface, direction);
  if (degree < surface.degree[d]) {
    rows.resize(static_cast<std::size_t>(degree) + 1);
  } else {
    // Across the rows run Bezier curves, each of which is raised.
    std::vector<Row> raised(static_cast<std::size_t>(degree) + 1);
    for (std::size_t b = 0; b < rows.front().size(); ++b) {
      Curve<Exact> curve{surface.degree[d], U, {}, 3, surface.rational, true};
      for (const Row& row : rows) curve.points.push_back(row[b]);
      NoRecorder<Exact> nobody;
      const Curve<Exact> result = degree_elevation(curve, degree - surface.degree[d], nobody);
      for (std::size_t a = 0; a < raised.size(); ++a) raised[a].push_back(result.points[a]);
    }
    rows = std::move(raised);
  }
  set_rows(surface, direction, rows);
  surface.degree[d] = degree;
  U = bezier_knots<Exact>(degree);
  return as_read(surface);
}

EditedSurface set_kind(Surface<Exact> surface, CurveKind kind) {
  const bool bezier = kind == CurveKind::bezier || kind == CurveKind::rational_bezier;
  const bool rational = kind == CurveKind::rational_bezier || kind == CurveKind::nurbs;
  if (bezier && !surface.bezier) {
    for (int d = 0; d < 2; ++d) {
      const int count = count_along(surface, d);
      if (count - 1 > max_degree)
        return refused("points", "a Bézier surface has at most " + std::to_string(max_degree + 1) + " " + rows_word(d) +
                                     " (degree " + std::to_string(max_degree) + "), not " + std::to_string(count));
      surface.degree[static_cast<std::size_t>(d)] = count - 1;
      surface.knots[static_cast<std::size_t>(d)] = bezier_knots<Exact>(count - 1);
    }
  }
  surface.bezier = bezier;
  if (surface.rational && !rational)
    for (HPoint<Exact>& P : surface.points) P = weighted(affine(P), Exact(1), 3);
  surface.rational = rational;
  return as_read(surface);
}

namespace {

// Halfway between two points, or where the other is when one has weight 0; with the mean of their weights.
HPoint<Exact> between(const HPoint<Exact>& A, const HPoint<Exact>& B) {
  const Exact half = Exact::ratio(1, 2);
  if (A.w == Exact(0) || B.w == Exact(0))
    return {(A.x + B.x) * half, (A.y + B.y) * half, (A.z + B.z) * half, (A.w + B.w) * half};
  const Point<Exact> P = affine(A), Q = affine(B);
  return weighted({(P.x + Q.x) * half, (P.y + Q.y) * half, (P.z + Q.z) * half}, (A.w + B.w) * half, 3);
}

// As far behind A as A is behind the one before.
HPoint<Exact> beyond(const HPoint<Exact>& before, const HPoint<Exact>& A) {
  if (A.w == Exact(0) || before.w == Exact(0)) return A;
  const Point<Exact> P = affine(before), Q = affine(A);
  return weighted({Q.x + Q.x - P.x, Q.y + Q.y - P.y, Q.z + Q.z - P.z}, A.w, 3);
}

}  // namespace

EditedSurface insert_row(Surface<Exact> surface, int direction, int behind) {
  const auto d = static_cast<std::size_t>(direction);
  const int count = count_along(surface, direction);
  const std::string list = direction == 0 ? "points" : "points[0]";
  if (behind < -1 || behind >= count)
    return refused(list, "has " + std::to_string(count) + " " + rows_word(direction) + ", none of index " +
                             std::to_string(behind));
  if (surface.bezier && surface.degree[d] == max_degree)
    return refused(list, "a Bézier surface has at most " + std::to_string(max_degree + 1) + " " + rows_word(direction) +
                             "; make it a B-spline surface first");
  std::vector<Row> rows = rows_of(surface, direction);
  const auto last = rows.size() - 1, i = static_cast<std::size_t>(std::max(behind, 0));
  Row row;
  for (std::size_t b = 0; b < rows[0].size(); ++b)
    row.push_back(behind < 0  ? beyond(rows[1][b], rows[0][b])
                  : i == last ? beyond(rows[last - 1][b], rows[last][b])
                              : between(rows[i][b], rows[i + 1][b]));
  if (surface.bezier) {
    surface.knots[d] = bezier_knots<Exact>(++surface.degree[d]);
  } else {
    add_knot(surface.knots[d], surface.degree[d], rows.size(), behind < 0 ? SIZE_MAX : i);
  }
  insert_at(rows, static_cast<std::size_t>(behind + 1), std::move(row));
  set_rows(surface, direction, rows);
  return as_read(surface);
}

EditedSurface delete_row(Surface<Exact> surface, int direction, int row) {
  const auto d = static_cast<std::size_t>(direction);
  const int count = count_along(surface, direction), p = surface.degree[d];
  const std::string place =
      direction == 0 ? "points[" + std::to_string(row) + "]" : "points[0][" + std::to_string(row) + "]";
  if (row < 0 || row >= count)
    return refused(place, "there is no such " + std::string(direction == 0 ? "row" : "column"));
  if (surface.bezier && p == 1) return refused(place, "a surface has at least 2 " + rows_word(direction));
  if (!surface.bezier && count == p + 1)
    return refused(place, "a surface of degree " + std::to_string(p) + " has at least " + std::to_string(p + 1) + " " +
                              rows_word(direction) + "; lower the degree first");
  std::vector<Row> rows = rows_of(surface, direction);
  const auto i = static_cast<std::size_t>(row);
  if (surface.bezier)
    surface.knots[d] = bezier_knots<Exact>(--surface.degree[d]);
  else
    erase_at(surface.knots[d], knot_near(surface.knots[d], p, rows.size(), i));
  erase_at(rows, i);
  set_rows(surface, direction, rows);
  return as_read(surface);
}

}  // namespace edit

Surface<Exact> planar_surface(int rows, int columns, int degree_u, int degree_v, const Exact& size) {
  Surface<Exact> surface;
  surface.rows = rows;
  surface.columns = columns;
  surface.degree = {degree_u, degree_v};
  surface.knots = {edit::parts::clamped_uniform_knots(0, 1, degree_u, static_cast<std::size_t>(rows)),
                   edit::parts::clamped_uniform_knots(0, 1, degree_v, static_cast<std::size_t>(columns))};
  const Exact half = Exact::ratio(1, 2);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      surface.points.emplace_back(size * (Exact::ratio(i, rows - 1) - half),
                                  size * (Exact::ratio(j, columns - 1) - half), Exact(0), Exact(1));
  return surface;
}

}  // namespace blossom
