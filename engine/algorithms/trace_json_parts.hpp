#pragma once
// Parts of reading a stored trace: numbers of any length, points, and the result.

#include <charconv>

#include "algorithms/trace_json.hpp"

namespace blossom::stored {

// Exact::parse refuses what is longer than anybody types; the numbers of a trace can be. At most 20,000 digits, in
// parts.
inline std::optional<Exact> parse_long_integer(std::string_view text) {
  constexpr std::size_t part = 300;
  if (text.empty() || text.size() > 20'000) return std::nullopt;
  Exact sum(0);
  for (std::size_t at = 0; at < text.size(); at += part) {
    const auto digits = text.substr(at, part);
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const auto scale = Exact::parse("1e" + std::to_string(digits.size()));
    sum = sum * *scale + *Exact::parse(digits);
  }
  return sum;
}

inline std::optional<Exact> parse_fraction(std::string_view text) {
  if (text.size() <= 400) return Exact::parse(text);
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  const auto above = parse_long_integer(text.substr(0, slash));
  const auto below = slash == std::string_view::npos ? Exact(1) : parse_long_integer(text.substr(slash + 1));
  if (!above || !below || *below == Exact(0)) return std::nullopt;
  return negative ? -(*above / *below) : *above / *below;
}

template <Scalar S>
std::optional<S> read_scalar(const Cursor& at) {
  if constexpr (std::same_as<S, double>) {
    // The text itself: an exact number has no negative zero.
    if (const std::string& text = at.json().text; at.is(Json::Kind::number)) {
      double x = 0;
      const auto read = std::from_chars(text.data(), text.data() + text.size(), x);
      if (read.ec == std::errc() && read.ptr == text.data() + text.size()) return x;
    }
    const auto x = at.number();
    return x ? std::optional(x->to_double()) : std::nullopt;
  } else {
    if (at.is(Json::Kind::string) && at.json().text.size() > 400)
      if (auto x = parse_fraction(at.json().text)) return x;
    return at.number();
  }
}

template <Scalar S>
std::optional<std::vector<S>> read_scalars(const Cursor& at, std::size_t at_least, std::size_t at_most) {
  if (!at.expect_array(at_least, at_most)) return std::nullopt;
  std::vector<S> numbers;
  bool all = true;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (auto x = read_scalar<S>(at[i]))
      numbers.push_back(std::move(*x));
    else
      all = false;
  }
  return all ? std::optional(std::move(numbers)) : std::nullopt;
}

template <Scalar S>
HPoint<S> homogeneous(const std::vector<S>& xyz, const S& w, bool rational) {
  const bool scaled = rational && !(w == S(0));
  const auto coordinate = [&](std::size_t i) { return i < xyz.size() ? (scaled ? xyz[i] * w : xyz[i]) : S(0); };
  return {coordinate(0), coordinate(1), coordinate(2), w};
}

// A made curve or surface may be more than geometry files allow (a weight may come out negative): it is only shown.
template <Scalar S>
class ResultReader {
 public:
  explicit ResultReader(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  std::optional<Outcome<S>> read(const Cursor& at) const {
    if (!at.expect_object({"point", "curve", "surface", "curves", "surfaces"})) return std::nullopt;
    if (at.json().items.size() != 1) {
      at.error("must have one of \"point\", \"curve\", \"surface\", \"curves\" and \"surfaces\"");
      return std::nullopt;
    }
    if (const auto point = at.optional("point")) {
      const auto xyz = read_scalars<S>(*point, dimension_, dimension_);
      if (!xyz) return std::nullopt;
      return homogeneous(*xyz, S(1), false);
    }
    if (const auto curve = at.optional("curve")) return as_outcome(read_curve_result(*curve));
    if (const auto surface = at.optional("surface")) return as_outcome(read_surface_result(*surface));
    if (const auto curves = at.optional("curves"))
      return as_outcome(read_all<Curve<S>>(*curves, [&](const Cursor& one) { return read_curve_result(one); }));
    if (const auto surfaces = at.optional("surfaces"))
      return as_outcome(read_all<Surface<S>>(*surfaces, [&](const Cursor& one) { return read_surface_result(one); }));
    return std::nullopt;
  }

 private:
  template <class T>
  static std::optional<Outcome<S>> as_outcome(std::optional<T> read) {
    return read ? std::optional<Outcome<S>>(std::move(*read)) : std::nullopt;
  }
  template <class T, class ReadOne>
  static std::optional<std::vector<T>> read_all(const Cursor& at, const ReadOne& read_one) {
    if (!at.expect_array(1)) return std::nullopt;
    std::vector<T> all;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (auto one = read_one(at[i])) all.push_back(std::move(*one));
    return all.size() == at.size() ? std::optional(std::move(all)) : std::nullopt;
  }

  std::optional<std::vector<S>> knots(const std::optional<Cursor>& at, std::optional<int> degree,
                                      std::size_t points) const {
    if (!degree) return std::nullopt;
    const std::size_t count = points + static_cast<std::size_t>(*degree) + 1;
    if (at) return read_scalars<S>(*at, count, count);
    return bezier_knots<S>(*degree);
  }
  std::optional<std::vector<HPoint<S>>> points(const Cursor& at, const std::optional<Cursor>& weights,
                                               std::size_t dimension) const {
    if (!at.expect_array(2)) return std::nullopt;
    std::optional<std::vector<S>> w;
    if (weights && !(w = read_scalars<S>(*weights, at.size(), at.size()))) return std::nullopt;
    std::vector<HPoint<S>> read;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (const auto xyz = read_scalars<S>(at[i], dimension, dimension))
        read.push_back(homogeneous(*xyz, w ? (*w)[i] : S(1), w.has_value()));
    return read.size() == at.size() ? std::optional(std::move(read)) : std::nullopt;
  }

  std::optional<Curve<S>> read_curve_result(const Cursor& at) const {
    if (!at.expect_object({"degree", "knots", "points", "weights"})) return std::nullopt;
    const auto degree_at = at.required("degree");
    const auto points_at = at.required("points");
    if (!degree_at || !points_at) return std::nullopt;
    Curve<S> curve;
    const auto degree = degree_at->integer(1, max_degree);
    const auto P = points(*points_at, at.optional("weights"), dimension_);
    const auto U = P ? knots(at.optional("knots"), degree, P->size()) : std::nullopt;
    if (!degree || !P || !U) return std::nullopt;
    curve.degree = *degree;
    curve.points = *P;
    curve.knots = *U;
    curve.dimension = static_cast<int>(dimension_);
    curve.rational = at.optional("weights").has_value();
    curve.bezier = !at.optional("knots").has_value();
    return curve;
  }

  std::optional<Surface<S>> read_surface_result(const Cursor& at) const {
    if (!at.expect_object({"degree", "knots", "points", "weights"})) return std::nullopt;
    const auto degree_at = at.required("degree");
    const auto points_at = at.required("points");
    const auto knots_at = at.optional("knots");
    const auto weights_at = at.optional("weights");
    if (!degree_at || !points_at || !degree_at->expect_array(2, 2) || !points_at->expect_array(2)) return std::nullopt;
    if (knots_at && !knots_at->expect_array(2, 2)) return std::nullopt;
    if (weights_at && !weights_at->expect_array(points_at->size(), points_at->size())) return std::nullopt;
    Surface<S> surface;
    surface.rows = static_cast<int>(points_at->size());
    surface.rational = weights_at.has_value();
    surface.bezier = !knots_at.has_value();
    for (std::size_t i = 0; i < points_at->size(); ++i) {
      const auto row = points((*points_at)[i], weights_at ? std::optional((*weights_at)[i]) : std::nullopt, 3);
      if (!row) return std::nullopt;
      if (i > 0 && row->size() != static_cast<std::size_t>(surface.columns)) {
        (*points_at)[i].error("must have as many points as the row before, " + std::to_string(surface.columns));
        return std::nullopt;
      }
      surface.columns = static_cast<int>(row->size());
      surface.points.insert(surface.points.end(), row->begin(), row->end());
    }
    for (std::size_t d = 0; d < 2; ++d) {
      const auto degree = (*degree_at)[d].integer(1, max_degree);
      const auto U = knots(knots_at ? std::optional((*knots_at)[d]) : std::nullopt, degree,
                           static_cast<std::size_t>(d == 0 ? surface.rows : surface.columns));
      if (!degree || !U) return std::nullopt;
      surface.degree[d] = *degree;
      surface.knots[d] = *U;
    }
    return surface;
  }

  std::size_t dimension_;
};

}  // namespace blossom::stored
