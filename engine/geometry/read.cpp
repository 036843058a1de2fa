#include <algorithm>
#include <cmath>

#include "geometry/document.hpp"

namespace blossom {
namespace {

constexpr std::size_t max_points = 65'536;

std::string text(std::size_t number) { return std::to_string(number); }

// Control points P_first..P_last are the only ones with influence at the knot u.
struct Influence {
  std::size_t first;
  std::size_t last;
  Exact u;
};

// For each knot of the domain, the points that have influence there (see document.hpp); U is valid.
std::vector<Influence> influences(std::size_t p, const std::vector<Exact>& U) {
  const std::size_t n = U.size() - p - 2;
  std::vector<Influence> result;
  std::size_t l = 0;
  for (std::size_t f = 0; f < U.size(); f = l + 1) {
    for (l = f; l + 1 < U.size() && U[l + 1] == U[f]; ++l) {
    }
    if (U[f] < U[p] || U[f] > U[n + 1]) continue;
    if (l - f < p) {
      result.push_back({l - p, f - 1, U[f]});
    } else {
      if (f > 0) result.push_back({f - 1, f - 1, U[f]});
      if (f <= n) result.push_back({f, f, U[f]});
    }
  }
  return result;
}

// The numbers of an array; a mistake leaves a zero and a diagnostic.
std::vector<Exact> read_numbers(const Cursor& at) {
  std::vector<Exact> numbers(at.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (auto number = at[i].number()) numbers[i] = *std::move(number);
  }
  return numbers;
}

// `points` is how many control points stand along this direction, and `called` what they are called there. A count
// or a degree that is not known (0, because it was a mistake itself) is not checked against.
std::vector<Exact> read_knots(const Cursor& at, std::size_t p, std::size_t points, const std::string& called) {
  if (!at.expect_array(0, max_points + 2 * max_degree)) return {};
  const std::size_t before = at.error_count();
  if (p != 0 && points > p && at.size() != points + p + 1) {
    at.error("needs " + text(points + p + 1) + " knots (" + text(points) + " " + called + " + degree " + text(p) +
             " + 1), not " + text(at.size()));
  }
  std::vector<Exact> U;  // what is no number is left out, and the others are compared nevertheless
  std::size_t multiplicity = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    auto u = at[i].number();
    if (!u) continue;
    multiplicity = !U.empty() && *u == U.back() ? multiplicity + 1 : 1;
    if (!U.empty() && *u < U.back()) {
      at[i].error("knots must not decrease; " + format_brief(*u) + " comes after " + format_brief(U.back()));
    } else if (!U.empty() && *u > U.back() && u->to_double() == U.back().to_double()) {
      at[i].error("differs from the knot before by less than a double can tell; make them equal or move them apart");
    }
    if (p != 0 && multiplicity == p + 2) {
      at[i].error("a knot may stand at most " + text(p + 1) + " times (degree + 1); " + format_brief(*u) +
                  " stands more often");
    }
    U.push_back(*std::move(u));
  }
  if (at.errors_since(before) || U.empty()) return {};
  if (p != 0 && points > p && U[p] == U[points]) {
    at.error("the domain from u_" + text(p) + " to u_" + text(points) + " is empty: both are " + format_brief(U[p]));
  }
  if (!std::isfinite(U.back().to_double() - U.front().to_double())) at.error("the knots reach too far apart");
  return U;
}

// Reads control points one by one, and holds them to the number of coordinates of the first.
class PointReader {
 public:
  int dimension() const { return dimension_; }

  HPoint<Exact> read(const Cursor& at) {
    HPoint<Exact> P(Exact(0), Exact(0), Exact(0), Exact(1));
    if (!at.expect_array()) return P;
    const std::size_t size = at.size();
    if (size != 2 && size != 3) {
      at.error("a point must have 2 or 3 coordinates, not " + text(size));
      return P;
    }
    if (dimension_ == 0) dimension_ = static_cast<int>(size);
    if (static_cast<int>(size) != dimension_) {
      at.error("must have " + std::to_string(dimension_) + " coordinates, as the first point has, not " + text(size));
    }
    const std::vector<Exact> coordinates = read_numbers(at);
    P.x = coordinates[0];
    P.y = coordinates[1];
    if (size == 3) P.z = coordinates[2];
    return P;
  }

 private:
  int dimension_ = 0;
};

void read_weight(const Cursor& at, HPoint<Exact>& P) {
  const auto w = at.number();
  if (!w) return;
  if (*w < Exact(0)) at.error("a weight must not be negative, not " + format_brief(*w));
  if (*w > Exact(0) && w->to_double() == 0) at.error("too small for a weight; it must be 0 or at least 5e-324");
  P = {*w * P.x, *w * P.y, *w * P.z, *w};
  if (!std::isfinite(P.x.to_double() + P.y.to_double() + P.z.to_double())) {
    at.error("the point times this weight is too large; at most about 1.8e308");
  }
}

std::string no_other_point(const std::string& where) { return ": at " + where + " no other point has influence"; }

void read_curve_weights(const Cursor& at, Curve<Exact>& curve, bool knots_are_right) {
  if (!at.expect_array(curve.points.size(), curve.points.size())) return;
  const std::size_t before = at.error_count();
  for (std::size_t i = 0; i < curve.points.size(); ++i) read_weight(at[i], curve.points[i]);
  if (!knots_are_right || at.errors_since(before)) return;

  std::vector<std::size_t> zeros(curve.points.size());  // that end at i, in a row
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    zeros[i] = curve.points[i].w == Exact(0) ? (i > 0 ? zeros[i - 1] : 0) + 1 : 0;
  }
  for (const auto& [first, last, u] : influences(static_cast<std::size_t>(curve.degree), curve.knots)) {
    if (zeros[last] <= last - first) continue;
    const std::string where = no_other_point("u = " + format_brief(u));
    at[first].error(first == last
                        ? "must be positive" + where
                        : "the weights " + text(first) + " to " + text(last) + " must not all be zero" + where);
  }
}

void read_surface_weights(const Cursor& at, Surface<Exact>& surface, bool knots_are_right) {
  const auto rows = static_cast<std::size_t>(surface.rows), columns = static_cast<std::size_t>(surface.columns);
  if (!at.expect_array(rows, rows)) return;
  const std::size_t before = at.error_count();
  for (std::size_t i = 0; i < rows; ++i) {
    if (!at[i].expect_array(columns, columns)) continue;
    for (std::size_t j = 0; j < columns; ++j) read_weight(at[i][j], surface.points[i * columns + j]);
  }
  if (!knots_are_right || at.errors_since(before)) return;

  // positive(i, j): how many weights in the rows before i and the columns before j are positive.
  std::vector<int> sums((rows + 1) * (columns + 1));
  const auto positive = [&](std::size_t i, std::size_t j) -> int& { return sums[i * (columns + 1) + j]; };
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const int here = surface.points[i * columns + j].w > Exact(0) ? 1 : 0;
      positive(i + 1, j + 1) = here + positive(i, j + 1) + positive(i + 1, j) - positive(i, j);
    }
  }
  const auto along_v = influences(static_cast<std::size_t>(surface.degree[1]), surface.knots[1]);
  for (const auto& [i, last_i, u] : influences(static_cast<std::size_t>(surface.degree[0]), surface.knots[0])) {
    for (const auto& [j, last_j, v] : along_v) {
      const int count =
          positive(last_i + 1, last_j + 1) - positive(i, last_j + 1) - positive(last_i + 1, j) + positive(i, j);
      if (count > 0) continue;
      const std::string where = no_other_point("(u, v) = (" + format_brief(u) + ", " + format_brief(v) + ")");
      const bool one = i == last_i && j == last_j;
      at[i][j].error(one ? "must be positive" + where
                         : "the weights [" + text(i) + "][" + text(j) + "] to [" + text(last_i) + "][" + text(last_j) +
                               "] must not all be zero" + where);
    }
  }
}

// Says if the number of control points along one direction does not do for degree p, with or without knots.
void check_count(const Cursor& at, std::size_t p, std::size_t count, const std::string& called, bool bezier) {
  if (p == 0) return;
  const std::string needed = text(p + 1) + " " + called + " (degree " + text(p) + " + 1), not " + text(count);
  if (bezier && count != p + 1) at.error("without knots it is a Bezier one, which needs " + needed);
  if (!bezier && count < p + 1) at.error("needs at least " + needed);
}

// As doubles they are finite: nothing is multiplied with a weight here.
void expect_finite(const Cursor& at, const HPoint<Exact>& P) {
  if (!std::isfinite(P.x.to_double()) || !std::isfinite(P.y.to_double()) || !std::isfinite(P.z.to_double()))
    at.error("is too far away; at most about 1.8e308");
}

}  // namespace

std::optional<PointRow<Exact>> read_points(const Cursor& at, std::size_t at_least, std::size_t at_most) {
  const std::size_t before = at.error_count();
  if (!at.expect_array(at_least, std::min(at_most, max_points))) return std::nullopt;
  PointRow<Exact> row;
  PointReader reader;
  for (std::size_t i = 0; i < at.size(); ++i) {
    row.points.push_back(reader.read(at[i]));
    expect_finite(at[i], row.points.back());
  }
  if (at.errors_since(before)) return std::nullopt;
  row.dimension = std::max(reader.dimension(), 2);
  return row;
}

std::optional<PointNet<Exact>> read_net(const Cursor& at) {
  const std::size_t before = at.error_count();
  if (!at.expect_array(2, max_points / 2)) return std::nullopt;
  PointNet<Exact> net;
  net.rows = static_cast<int>(at.size());
  PointReader reader;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Cursor row = at[i];
    if (!row.expect_array(2, max_points / at.size())) continue;
    if (net.columns == 0) net.columns = static_cast<int>(row.size());
    if (static_cast<int>(row.size()) != net.columns)
      row.error("must have " + std::to_string(net.columns) + " points, as the first row has, not " + text(row.size()));
    for (std::size_t j = 0; j < row.size(); ++j) {
      net.points.push_back(reader.read(row[j]));
      expect_finite(row[j], net.points.back());
    }
  }
  if (at.errors_since(before)) return std::nullopt;
  return net;
}

std::optional<Curve<Exact>> read_curve(const Cursor& at) {
  const std::size_t before = at.error_count();
  if (!at.expect_object({"degree", "knots", "points", "weights"})) return std::nullopt;
  Curve<Exact> curve;

  if (const auto degree = at.required("degree")) curve.degree = degree->integer(1, max_degree).value_or(0);
  const auto p = static_cast<std::size_t>(curve.degree);  // 0: not known

  const auto knots = at.optional("knots");
  curve.bezier = !knots;
  if (const auto points = at.required("points"); points && points->expect_array(0, max_points)) {
    PointReader reader;
    for (std::size_t i = 0; i < points->size(); ++i) curve.points.push_back(reader.read((*points)[i]));
    curve.dimension = reader.dimension();
    check_count(*points, p, curve.points.size(), "points", curve.bezier);
  }

  const std::size_t before_knots = at.error_count();
  if (knots) curve.knots = read_knots(*knots, p, curve.points.size(), "points");
  if (!knots && p != 0) curve.knots = bezier_knots<Exact>(curve.degree);
  const bool knots_are_right =
      p != 0 && !at.errors_since(before_knots) && curve.knots.size() == curve.points.size() + p + 1;

  if (const auto weights = at.optional("weights")) {
    curve.rational = true;
    if (!curve.points.empty()) read_curve_weights(*weights, curve, knots_are_right);
  }
  if (at.errors_since(before)) return std::nullopt;
  return curve;
}

std::optional<Surface<Exact>> read_surface(const Cursor& at) {
  const std::size_t before = at.error_count();
  if (!at.expect_object({"degree", "knots", "points", "weights"})) return std::nullopt;
  Surface<Exact> surface;

  if (const auto degree = at.required("degree"); degree && degree->expect_array(2, 2)) {
    for (std::size_t d = 0; d < 2; ++d) surface.degree[d] = (*degree)[d].integer(1, max_degree).value_or(0);
  }
  const std::array p{static_cast<std::size_t>(surface.degree[0]), static_cast<std::size_t>(surface.degree[1])};

  const auto knots = at.optional("knots");
  surface.bezier = !knots;
  if (const auto rows = at.required("points"); rows && rows->expect_array(1, max_points)) {
    PointReader reader;
    const std::size_t columns = (*rows)[0].is(Json::Kind::array) ? (*rows)[0].size() : 0;
    bool rectangular = true;
    for (std::size_t i = 0; i < rows->size(); ++i) {
      const Cursor row = (*rows)[i];
      if (!row.expect_array(1, max_points / rows->size())) {
        rectangular = false;
        continue;
      }
      if (row.size() != columns) {
        row.error("must have " + text(columns) + " points, as the first row has, not " + text(row.size()));
        rectangular = false;
      }
      for (std::size_t j = 0; j < row.size(); ++j) surface.points.push_back(reader.read(row[j]));
    }
    check_count(*rows, p[0], rows->size(), "rows", surface.bezier);
    if (rectangular) {
      check_count((*rows)[0], p[1], columns, "columns", surface.bezier);
      surface.rows = static_cast<int>(rows->size());
      surface.columns = static_cast<int>(columns);
    }
  }

  const std::array counts{static_cast<std::size_t>(surface.rows), static_cast<std::size_t>(surface.columns)};
  const std::size_t before_knots = at.error_count();
  if (knots && knots->expect_array(2, 2)) {
    surface.knots[0] = read_knots((*knots)[0], p[0], counts[0], "rows");
    surface.knots[1] = read_knots((*knots)[1], p[1], counts[1], "columns");
  }
  bool knots_are_right = !at.errors_since(before_knots);
  for (std::size_t d = 0; d < 2; ++d) {
    if (!knots && p[d] != 0) surface.knots[d] = bezier_knots<Exact>(surface.degree[d]);
    knots_are_right = knots_are_right && p[d] != 0 && surface.knots[d].size() == counts[d] + p[d] + 1;
  }

  if (const auto weights = at.optional("weights")) {
    surface.rational = true;
    if (surface.rows > 0) read_surface_weights(*weights, surface, knots_are_right);
  }
  if (at.errors_since(before)) return std::nullopt;
  return surface;
}

}  // namespace blossom
