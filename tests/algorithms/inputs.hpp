#pragma once
// Random valid inputs for any algorithm, made from nothing but its table of inputs: an algorithm is tested the day it
// is added. What is drawn goes through JSON text and the reader of lesson files, so every input is one that a file can
// hold.

#include <catch2/catch.hpp>
#include <optional>
#include <random>

#include "algorithms/networks.hpp"
#include "algorithms/run.hpp"
#include "geometry/document.hpp"
#include "kernel/splines.hpp"
#include "sanitized.hpp"

namespace blossom::test {

// Bezier or B-spline, clamped or not, degree 1 to 4, plane or spatial, rational or not, with multiple knots up to p +
// 1, now and then with points that coincide or weights that are zero.
inline Curve<Exact> any_curve(std::mt19937& random, int dimension) {
  const auto one_in = [&](int n) { return random_int(random, 1, n) == 1; };
  const int p = random_int(random, 1, 4);
  const bool rational = one_in(2);
  Curve<Exact> curve;
  if (one_in(3)) {
    curve = random_curve(random, p, 1, 1, true, rational);
    curve.knots = bezier_knots<Exact>(p);
    curve.bezier = true;
  } else {
    curve = random_curve(random, p, random_int(random, 1, 4), one_in(4) ? p + 1 : p, !one_in(3), rational);
  }
  curve.dimension = dimension;
  for (auto& P : curve.points) {
    if (dimension == 2) P.z = Exact(0);
    if (&P != &curve.points.front() && one_in(8)) P = *(&P - 1);
    if (rational && one_in(8)) P = HPoint<Exact>(0, 0, 0, 0);
  }
  return curve;
}

// A parameter where something can go wrong, or any other.
inline Exact any_parameter(std::mt19937& random, const Curve<Exact>& curve) {
  if (random_int(random, 0, 1) == 0) return random_parameter(random, curve.knots, curve.degree);
  return curve.knots[static_cast<std::size_t>(random_int(random, curve.degree, curve.n() + 1))];
}

inline HPoint<Exact> any_place(std::mt19937& random, int dimension) {
  const auto coordinate = [&] { return Exact(random_int(random, -9, 9)); };
  return {coordinate(), coordinate(), dimension == 3 ? coordinate() : Exact(0), Exact(1)};
}

// A parameter of the surface: v in v, any other in one of the two directions.
inline Exact any_parameter(std::mt19937& random, const Surface<Exact>& surface, std::string_view name) {
  const std::size_t d = name == "v" || (name != "u" && random_int(random, 0, 1) == 1) ? 1 : 0;
  Curve<Exact> line;
  line.degree = surface.degree[d];
  line.knots = surface.knots[d];
  line.points.resize(static_cast<std::size_t>(d == 0 ? surface.rows : surface.columns));
  return any_parameter(random, line);
}

inline InputValue<Exact> any_value(std::mt19937& random, const InputSpec& spec, const Curve<Exact>& curve,
                                   int dimension) {
  switch (spec.type) {
    case InputSpec::Type::number:
      if (spec.name == "apart") return random_ratio(random, 0, 1, 8);
      if (spec.name == "tolerance") return random_ratio(random, 0, 9, 4);
      return any_parameter(random, curve);
    case InputSpec::Type::integer:
      return random_int(random, spec.at_least, std::min(spec.at_most, spec.at_least + 2));
    case InputSpec::Type::choice:
      return std::string(
          spec.choices[static_cast<std::size_t>(random_int(random, 0, static_cast<int>(spec.choices.size()) - 1))]);
    case InputSpec::Type::curve:
      return curve;
    case InputSpec::Type::surface:
      return random_surface(random, 2, random_int(random, 1, 3), 2, true, random_int(random, 0, 1) == 1);
    case InputSpec::Type::numbers: {
      std::vector<Exact> numbers;
      for (int i = random_int(random, spec.at_least, std::min(spec.at_most, spec.at_least + 3)); i > 0; --i)
        numbers.push_back(any_parameter(random, curve));
      return numbers;
    }
    case InputSpec::Type::points: {
      PointRow<Exact> row{{}, dimension};
      for (int i = random_int(random, spec.at_least, std::min(spec.at_most, spec.at_least + 4)); i > 0; --i)
        row.points.push_back(any_place(random, dimension));
      return row;
    }
    case InputSpec::Type::net: {
      PointNet<Exact> net{random_int(random, 2, 4), random_int(random, 2, 4), {}};
      for (int i = net.rows * net.columns; i > 0; --i) net.points.push_back(any_place(random, 3));
      return net;
    }
    case InputSpec::Type::curves:
      break;
  }
  std::vector<Curve<Exact>> curves{curve};
  for (int l = random_int(random, 1, 3); l > 0; --l) curves.push_back(any_curve(random, dimension));
  return curves;
}

// Inputs that the algorithm accepts: draws until some are.
inline Inputs<Exact> any_inputs(const Algorithm& algorithm, unsigned seed) {
  std::mt19937 random(seed);
  for (int draw = 0; draw < 1000; ++draw) {
    const int dimension = random_int(random, 2, 3);
    const Curve<Exact> curve = any_curve(random, dimension);
    std::string text = "{";
    std::optional<Surface<Exact>> surface;  // parameters are the surface's where there is one
    std::optional<Network> network;         // curves that cross, where that is asked for
    if (algorithm.input("u_curves") != nullptr) network = any_network(random, algorithm);
    int curves = 0;
    for (const auto& spec : algorithm.inputs) {
      const bool parameter = spec.name == "u" || spec.name == "v" || spec.name == "t";
      const bool another = spec.type == InputSpec::Type::curve && curves++ > 0;
      auto crossing = network ? network_input(spec.name, *network) : std::nullopt;
      auto value = crossing ? *crossing
                   : surface && parameter && spec.type == InputSpec::Type::number
                       ? InputValue<Exact>(any_parameter(random, *surface, spec.name))
                       : any_value(random, spec, another ? any_curve(random, dimension) : curve, dimension);
      if (const auto* drawn = std::get_if<Surface<Exact>>(&value)) surface = *drawn;
      text += (text.size() > 1 ? ", " : "") + json_quote(spec.name) + ": " + write_input(value);
    }
    const auto document = JsonDocument::parse("inputs", text + "}");
    Diagnostics diagnostics;
    if (!document) continue;
    auto inputs = read_inputs(algorithm, Cursor(*document, diagnostics));
    if (inputs && record<Exact>(algorithm, *inputs)) return *inputs;
  }
  throw std::runtime_error("no draw was valid for " + std::string(algorithm.id));
}

inline std::string to_text(const Inputs<Exact>& inputs) {
  std::string text;
  for (const auto& [name, value] : inputs.values) text += name + " = " + write_input(value) + "\n";
  return text;
}

// Sanitizers look for faults that any input shows: there every fifth does.
constexpr unsigned seed_step = sanitized ? 5 : 1;

// `body(algorithm, inputs)` on `count` inputs of each algorithm, with what to look at when it fails.
template <class Body>
void for_each_run(unsigned count, Body&& body) {
  for (const Algorithm* algorithm : algorithms()) {
    for (unsigned seed = 1; seed <= count; seed += seed_step) {
      const auto inputs = any_inputs(*algorithm, seed);
      INFO(algorithm->id << ", seed " << seed << "\n" << to_text(inputs));
      body(*algorithm, inputs);
    }
  }
}

}  // namespace blossom::test
