#pragma once
// Gordon surfaces (Gordon 1969; The NURBS Book 10.5): the surface through a network of curves, C_l(u) at v_l and D_k(v)
// at u_k, which cross at X[k][l] = C_l(u_k) = D_k(v_l):
//
//     S = S1 + (S2 - T),   S1 the skin of the curves along u, S2 that of the curves along v, T interpolates the
//     X[k][l].
//
// At v = v_l, S1 is C_l, and S2 and T both are the curve through X[0][l]..X[r][l]: what is left is C_l. For that T must
// interpolate in the manner of both skins: over the knots of S1 along v, and those of S2 along u. Then S2 and T get one
// knot vector along v (with S1), and S1 and S2 - T one along u, by degree elevation and knot insertion of their rows
// and columns, and are added. Sums of points: all weights must be the same.

#include "kernel/skinning.hpp"
#include "kernel/sweep_frame.hpp"

namespace blossom {

// A - B of control points
struct SubtractNet {
  static constexpr std::string_view name = "subtract_net";
  static constexpr std::string_view formula = "{0} - {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B) {
    return {A.x - B.x, A.y - B.y, A.z - B.z, A.w - B.w};
  }
};

// A + B of control points
struct AddNet {
  static constexpr std::string_view name = "add_net";
  static constexpr std::string_view formula = "{0} + {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B) {
    return {A.x + B.x, A.y + B.y, A.z + B.z, A.w + B.w};
  }
};

// The mean of parameters; where one of the given knots is the same but for rounding, that knot, so that merging the
// knots of several surfaces does not keep both.
struct MeanOrKnot {
  static constexpr std::string_view name = "mean_or_knot";
  static constexpr std::string_view formula = "mean of parameters, or the same knot, of {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(std::span<const S> knots, std::span<const S> parameters) {
    const S mean = Mean::apply<S>(parameters);
    const S slack = (knots.back() - knots.front()) / S(1000000000);
    for (const S& knot : knots)
      if (knot - slack <= mean && mean <= knot + slack) return knot;
    return mean;
  }
  template <Scalar S>
  static bool defined(std::span<const S> knots, std::span<const S> parameters) {
    return !knots.empty() && !parameters.empty();
  }
};

namespace network {

template <class R>
using Numbers = Cells<typename R::Number, typename R::Id>;
template <class R>
using List = Traced<std::vector<typename R::Number>, typename R::Id>;

// The parameters at which a curve of this domain is crossed: as given, or evenly spaced.
template <class R>
Numbers<R> parameters(R& rec, const MadeCurve<R>& curve, const std::vector<typename R::Number>& given, int count,
                      NameMaker name, NameMaker index) {
  const auto begin = curve.U[0], end = curve.U[curve.U.size() - 1];
  Numbers<R> t;
  t.push_back(rec.apply(SameNumber{}, name(0), begin));
  if (given.empty()) {
    const auto spaces = rec.input(index(0), count - 1);
    for (int k = 1; k < count - 1; ++k)
      t.push_back(rec.apply(SpanShare{}, name(k), rec.input(index(k), k), spaces, begin, end));
  } else {
    for (int k = 1; k < count - 1; ++k) t.push_back(rec.input(name(k), given[static_cast<std::size_t>(k)]));
  }
  t.push_back(rec.apply(SameNumber{}, name(count - 1), end));
  return t;
}

// Knots for interpolation at t with degree q, by averaging; knots near those of `curve` are those.
template <class R>
Numbers<R> knots(R& rec, const MadeCurve<R>& curve, const Numbers<R>& t, int q, NameMaker own, NameMaker name) {
  const int K = t.size() - 1;
  const auto known = rec.apply(Gather{}, own(), slice(curve.U, 0, curve.U.size()));
  Numbers<R> V;
  for (int i = 0; i <= q; ++i) V.push_back(t[0]);
  for (int j = 1; j <= K - q; ++j) V.push_back(rec.apply(MeanOrKnot{}, name(j + q), known, slice(t, j, q)));
  for (int i = 0; i <= q; ++i) V.push_back(t[K]);
  return V;
}

// Row i of a net, or its column, as a curve.
template <class R>
MadeCurve<R> line(const construct::Net<R>& net, int index, bool row, int degree, const Numbers<R>& U) {
  MadeCurve<R> curve;
  curve.degree = degree;
  curve.dimension = 3;
  curve.U = U;
  const int count = row ? net.columns : net.rows;
  for (int i = 0; i < count; ++i) curve.P.push_back(row ? net.at(index, i) : net.at(i, index));
  return curve;
}

// The points where the curves cross, X[k][l] = C_l(u_k), each curve a sum of basis functions times control points.
template <class R, class Degree, class KnotList>
std::vector<MadeCurve<R>> crossings(R& rec, const std::vector<MadeCurve<R>>& curves, const Numbers<R>& u,
                                    const Degree& p, const KnotList& U) {
  using S = typename R::Number;
  std::vector<MadeCurve<R>> X(static_cast<std::size_t>(u.size()));  // those of one u_k as the points of a "curve"
  for (int k = 0; k < u.size(); ++k) {
    auto phase = rec.phase({"at", k, true});
    const int last = row_span(std::span<const S>(U.value), p.value, u[k].value);
    Numbers<R> N;
    for (int j = last - p.value; j <= last; ++j)
      N.push_back(rec.apply(BasisValue{}, "N"_v(j), rec.input("j"_v(j), j), p, u[k], U));
    for (std::size_t l = 0; l < curves.size(); ++l) {
      Traced<HPoint<S>, typename R::Id> sum{};
      for (int j = 0; j <= p.value; ++j) {
        const int i = last - p.value + j;
        const auto name = j == p.value ? outer("X"_v(k, static_cast<int>(l))) : "C"_v(static_cast<int>(l), i);
        const auto P = curves[l].P[i];
        sum = j == 0 ? rec.apply(WeighPoint{}, name, N[j], P) : rec.apply(AddWeighed{}, name, sum, N[j], P);
      }
      X[static_cast<std::size_t>(k)].P.push_back(sum);
    }
  }
  return X;
}

// Gives all curves one degree and one knot vector, in the phase `id`. Their points get names of their own there, and
// the polar labels of curves.
template <class R>
void make_common(R& rec, std::string_view id, std::vector<MadeCurve<R>>& curves) {
  using S = typename R::Number;
  auto phase = rec.phase({id, -1, true});
  const auto like_the_first = [&](const MadeCurve<R>& curve) {
    return curve.degree == curves[0].degree && std::ranges::equal(curve.U.values(), curves[0].U.values());
  };
  if (std::ranges::all_of(curves, like_the_first)) return;
  if constexpr (R::recording) {
    for (std::size_t c = 0; c < curves.size(); ++c) {
      auto step = rec.one_step();
      auto& [p, U, P, dimension, rational] = curves[c];
      for (int i = 0; i < P.size(); ++i) {
        const auto point = rec.apply(Reparametrize{}, "B"_v(static_cast<int>(c), i), P[i]);
        rec.polar_net(point.id, U.values().subspan(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(p)),
                      std::span<const S>());
        P.set(i, point);
      }
    }
  }
  make_compatible(rec, curves);
}

// Some curves' control points as a net: one curve a row.
template <class R>
construct::Net<R> net_of(const std::vector<MadeCurve<R>>& curves, std::size_t first, int rows) {
  construct::Net<R> net(rows, curves[first].P.size());
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < net.columns; ++j) net.set(i, j, curves[first + static_cast<std::size_t>(i)].P[j]);
  return net;
}

}  // namespace network

// Preconditions: at least two curves each way, of equal weights, each way over one domain; parameters none or one for
// each curve the other way, ascending from the beginning of the domain to its end; the curves meet there.
template <class R>
Surface<typename R::Number> gordon(const std::vector<Curve<typename R::Number>>& u_curves,
                                   const std::vector<Curve<typename R::Number>>& v_curves,
                                   const std::vector<typename R::Number>& u_parameters,
                                   const std::vector<typename R::Number>& v_parameters, R& rec) {
  const int s = static_cast<int>(u_curves.size()) - 1, r = static_cast<int>(v_curves.size()) - 1;
  std::vector<MadeCurve<R>> C, D;
  for (int l = 0; l <= s; ++l) C.push_back(construct::given(rec, u_curves[static_cast<std::size_t>(l)], l));
  for (int k = 0; k <= r; ++k)
    D.push_back(construct::given(rec, v_curves[static_cast<std::size_t>(k)], k, "V"_v, "R"_v));
  bool rational = false;
  for (const auto* family : {&C, &D})
    for (const auto& curve : *family) rational = rational || curve.rational;
  {
    auto phase = rec.phase({"along_u", -1, true});
    make_compatible(rec, C);
  }
  {
    auto phase = rec.phase({"along_v", -1, true});
    make_compatible(rec, D);
  }

  network::Numbers<R> u, v, U2, V1;
  network::List<R> list_u{}, list_v{};
  const int p2 = std::min(3, r), q1 = std::min(3, s);
  {
    auto phase = rec.phase({"parameters"});
    u = network::parameters(rec, C[0], u_parameters, r + 1, "u"_v, "k"_v);
    v = network::parameters(rec, D[0], v_parameters, s + 1, "v"_v, "l"_v);
    U2 = network::knots(rec, C[0], u, p2, "U"_v, "UT"_v);
    V1 = network::knots(rec, D[0], v, q1, "V"_v, "VT"_v);
    list_u = rec.apply(Gather{}, "UT"_v, slice(U2, 0, U2.size()));
    list_v = rec.apply(Gather{}, "VT"_v, slice(V1, 0, V1.size()));
  }
  const auto degree_u = rec.input("p"_v, p2), degree_v = rec.input("q"_v, q1);

  const auto skin = [&](std::string_view id, const auto& curves, const auto& t, const auto& degree, const auto& list) {
    auto phase = rec.phase({id, -1, true, "skinning"});
    return skin::across(rec, curves, t, degree, list);
  };
  const auto S1 = skin("skin_u", C, v, degree_v, list_v);  // rows along u, columns along v
  const auto S2 = skin("skin_v", D, u, degree_u, list_u);  // the other way round
  std::vector<MadeCurve<R>> X;
  {
    auto phase = rec.phase({"crossings"});
    const auto p = rec.input("pu"_v, C[0].degree);
    const auto U = rec.apply(Gather{}, "UC"_v, slice(C[0].U, 0, C[0].U.size()));
    X = network::crossings(rec, C, u, p, U);
  }
  const auto X_u = skin("tensor_u", X, u, degree_u, list_u);  // row l: the curve through X[0][l]..X[r][l]
  std::vector<MadeCurve<R>> through;
  for (int l = 0; l <= s; ++l) through.push_back(network::line(X_u, l, true, p2, U2));
  const auto T = skin("tensor_v", through, v, degree_v, list_v);

  // One knot vector along v, then one along u.
  const std::size_t n = static_cast<std::size_t>(S1.rows), columns = static_cast<std::size_t>(r) + 1;
  std::vector<MadeCurve<R>> rows;
  for (int i = 0; i < S1.rows; ++i) rows.push_back(network::line(S1, i, true, q1, V1));
  for (int k = 0; k <= r; ++k) rows.push_back(network::line(S2, k, false, D[0].degree, D[0].U));
  for (int k = 0; k <= r; ++k) rows.push_back(network::line(T, k, true, q1, V1));
  network::make_common(rec, "common_v", rows);
  const auto first = network::net_of<R>(rows, 0, S1.rows);
  auto difference = network::net_of<R>(rows, n, r + 1);
  {
    auto phase = rec.phase({"subtract"});
    const auto tensor = network::net_of<R>(rows, n + columns, r + 1);
    for (int i = 0; i < difference.rows; ++i)
      for (int j = 0; j < difference.columns; ++j)
        difference.set(i, j, rec.apply(SubtractNet{}, "D"_v(i, j), difference.at(i, j), tensor.at(i, j)));
  }
  const int m = first.columns;
  std::vector<MadeCurve<R>> lines;
  for (int j = 0; j < m; ++j) lines.push_back(network::line(first, j, false, C[0].degree, C[0].U));
  for (int j = 0; j < m; ++j) lines.push_back(network::line(difference, j, false, p2, U2));
  network::make_common(rec, "common_u", lines);
  auto phase = rec.phase({"sum"});
  construct::Net<R> Q(lines[0].P.size(), m);
  for (int i = 0; i < Q.rows; ++i)
    for (int j = 0; j < m; ++j)
      Q.set(i, j,
            rec.apply(AddNet{}, "Q"_v(i, j), lines[static_cast<std::size_t>(j)].P[i],
                      lines[static_cast<std::size_t>(m + j)].P[i]));
  return construct::surface(rec, std::move(Q), lines[0].degree, lines[0].U.values(), rows[0].degree, rows[0].U.values(),
                            rational);
}

}  // namespace blossom
