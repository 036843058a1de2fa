#pragma once
// What interpolation and approximation by surfaces share.

#include "algorithms/common.hpp"
#include "kernel/surface_fitting.hpp"

namespace blossom::tensor {

template <Scalar S>
Parametrization parametrization_of(const Inputs<S>& inputs) {
  const auto& name = inputs.choice("parametrization");
  return name == "uniform"       ? Parametrization::uniform
         : name == "centripetal" ? Parametrization::centripetal
                                 : Parametrization::chord;
}

// A degree as wished, or the highest that so many points have.
template <Scalar S>
int degree_for(const Inputs<S>& inputs, std::string_view name, int points) {
  return std::min(inputs.integer(name), points - 1);
}

inline std::vector<InputSpec> fitting_inputs() {
  return {
      {"points", InputSpec::Type::net, "The points, in rows; all rows of equally many, at least 2 by 2."},
      {"degree_u",
       InputSpec::Type::integer,
       "The degree in u, across the rows; if it needs more rows, the highest they have.",
       1,
       max_degree,
       {},
       "3"},
      {"degree_v",
       InputSpec::Type::integer,
       "The degree in v, along the rows; if it needs more columns, the highest they have.",
       1,
       max_degree,
       {},
       "3"},
      {"parametrization",
       InputSpec::Type::choice,
       "How the rows and columns get their parameters.",
       0,
       0,
       {"chord", "centripetal", "uniform"},
       "\"chord\""},
  };
}

// The values of both directions, at these lines of the pseudo-code: parameters, knots, matrix.
inline std::vector<ValueSpec> fitting_values(int parameters, int knots, int matrix) {
  return {
      {"p", {}, "the degree in u"},
      {"q", {}, "the degree in v"},
      {"K", {}, "the number of rows (columns) less one"},
      {"l", {"l"}, "the index of a row (column)"},
      {"c", {"k", "i"}, "the distance between neighbouring points", parameters, "{name} = {chain}."},
      {"d", {"k", "i"}, "the distance (centripetal: its square root)", parameters, "{name} = {chain}."},
      {"L", {"i"}, "the whole length of line i", parameters, "Line {i} is {value} long in all."},
      {"e", {"k", "i"}, "the share of the k-th distance in line i", parameters, "{name} = {chain}."},
      {"e",
       {"k"},
       "the mean share over all lines",
       parameters,
       "Averaged over all lines, the next is {value} further."},
      {"u", {"k"}, "the parameter of row k", parameters, "Row {k} gets the parameter u[{k}] = {value}."},
      {"v", {"l"}, "the parameter of column l", parameters, "Column {l} gets the parameter v[{l}] = {value}."},
      {"U", {"j"}, "the knot j of this direction", knots, "Knot number {j}: {chain}."},
      {"U", {}, "the knots in u", knots, "The knots in u: U = {value}."},
      {"V", {}, "the knots in v", knots, "The knots in v: V = {value}."},
      {"j", {"k", "j"}, "the index j"},
      {"N", {"k", "j"}, "the basis function j at the parameter k", matrix, "{name} = {result}."},
      {"m",
       {"l", "c"},
       "what is subtracted of row c of the matrix from row l",
       matrix,
       "Row {l} loses {chain} times row {c}."},
      {"A", {"c", "j"}, "an entry of the eliminated matrix", matrix, "Entry {j} of the row: {result}."},
  };
}

inline std::vector<PhaseSpec> fitting_phases(int parameters, int knots, int matrix, int solve_rows) {
  return {
      {"along_u", "The u-direction", parameters, "First the direction u, from row to row."},
      {"along_v", "The v-direction", parameters, "Now the direction v, from column to column."},
      {"parameters", "Parameters", parameters,
       "Every line of points that runs this way has parameters of its own; the mean of all of them is taken."},
      {"knots", "Knots", knots, "The knots follow from the parameters."},
      {"eliminate", "Elimination", matrix, "The system is eliminated once, for all lines."},
      {"row", "Eliminate in row {index}", matrix, "Row {index} loses its entry left of the diagonal."},
      {"line", "Row {index}", solve_rows, "Solve for the curve of row {index}."},
  };
}

// u_k = k/n whatever the distances.
inline Misconception always_uniform() {
  return {"always-uniform", "the parameters are uniform",
          "The parameters follow the distances between the points: they grow more where the next row is farther away.",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            const bool u = site.name().symbol == Symbol::of("u");
            if ((!u && site.name().symbol != Symbol::of("v")) || site.name().arity != 1 ||
                site.inputs().choice("parametrization") == "uniform")
              return {};
            const auto& points = site.inputs().net("points");
            return {{Exact::ratio(site.name().index[0], (u ? points.rows : points.columns) - 1)}};
          }};
}

// The distance itself where its share of the whole is meant.
inline Misconception not_divided() {
  return {"not-divided", "the distances are not divided by the whole length",
          "Each distance counts by its share of its line's whole length, so that the parameters run from 0 to 1.",
          [](const Site& site) -> std::vector<Numbers<Exact>> {
            if (site.name().symbol != Symbol::of("e") || site.trace().value(site.value()).rule != &rule_info<Quotient>)
              return {};
            const auto d = site.operand(0);
            return {Numbers<Exact>(d.begin(), d.end())};
          }};
}

}  // namespace blossom::tensor
