// Polar labels: every point of a trace is a value of the blossom at the arguments its label says. Held against the
// blossom evaluated by its definition on the input curve, in exact arithmetic.

#include <catch2/catch.hpp>

#include "algorithms/inputs.hpp"
#include "kernel/blossom.hpp"
#include "kernel/knot_removal.hpp"
#include "kernel/lift.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

using Points = HPoint<Exact>;

// The blossom of the piece on span k as a curve of degree t.size(): f_q(t_1..t_q) = 1/q sum_i f_{q-1}(all but t_i).
Points elevated_blossom(const Curve<Exact>& curve, int k, const std::vector<Exact>& t) {
  if (static_cast<int>(t.size()) == curve.degree) return blossom::blossom<Exact>(curve, k, t);
  Points sum(0, 0, 0, 0);
  for (std::size_t i = 0; i < t.size(); ++i) {
    auto others = t;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    sum += elevated_blossom(curve, k, others);
  }
  return sum / Exact(static_cast<int>(t.size()));
}

bool same_place(const Points& P, NumbersView<Exact> numbers, bool divided) {
  if (divided) return P.w != Exact(0) && P.x / P.w == numbers[0] && P.y / P.w == numbers[1] && P.z / P.w == numbers[2];
  return P.x == numbers[0] && P.y == numbers[1] && P.z == numbers[2] && P.w == numbers[3];
}

// Whether a piece near the arguments has this value there.
bool is_blossom_value(const Curve<Exact>& curve, const std::vector<Exact>& t, NumbersView<Exact> numbers,
                      bool divided) {
  if (static_cast<int>(t.size()) < curve.degree) return false;
  const auto [least, greatest] = std::minmax_element(t.begin(), t.end());
  for (int k = curve.degree; k <= curve.n(); ++k) {
    const Exact& a = curve.knots[static_cast<std::size_t>(k)];
    const Exact& b = curve.knots[static_cast<std::size_t>(k) + 1];
    if (a < b && !(b < *least) && !(*greatest < a) && same_place(elevated_blossom(curve, k, t), numbers, divided))
      return true;
  }
  return false;
}

Curve<Exact> over_unit_domain(Curve<Exact> curve) {
  const Exact a = curve.domain_begin();
  const Exact b = curve.domain_end();
  for (Exact& u : curve.knots) u = (u - a) / (b - a);
  return curve;
}

// The profile that a value of skinning belongs to; -1: to none alone.
int profile_of(const TraceGraph& trace, ValueId v) {
  for (const std::uint32_t phase : trace.phase_path(trace.phase_of(v))) {
    const auto& record = trace.phases()[phase];
    if (record.id == "clamp" || record.id == "raise" || record.id == "domain" || record.id == "refine")
      return record.index;
  }
  return trace.is_input(v) ? trace.value(v).name.index[0] : -1;
}

bool after_mapping(const TraceGraph& trace, ValueId v) {
  for (const auto& phase : trace.phases())
    if (phase.id == "domain" && phase.index == 0) return phase.first_step < trace.value(v).step;
  return false;
}

Curve<Exact> row(const Surface<Exact>& surface, int i) {
  Curve<Exact> curve;
  curve.degree = surface.degree[1];
  curve.knots = surface.knots[1];
  for (int j = 0; j < surface.columns; ++j) curve.points.push_back(surface.at(i, j));
  return curve;
}

}  // namespace

// Whether a point is a value of some blossom: it was given as a control point, or is made from such points by a rule
// that says what becomes of their labels. Data to be fitted, frames and network crossings are none, nor are
// coefficients of powers and points of a line, which stand each for itself in the table.
bool is_labelled(const Algorithm& algorithm, const TraceGraph& trace, const std::vector<PolarLabel<Exact>>& labels,
                 ValueId v) {
  if (trace.value(v).kind != ValueKind::point) return false;
  if (trace.is_input(v)) {
    const ValueSpec* spec = algorithm.spec(trace.value(v).name);
    if (spec != nullptr && spec->draw == ValueSpec::Draw::point) return false;
    return algorithm.family != Family::fitting && algorithm.family != Family::construction && !algorithm.lifts;
  }
  if (trace.value(v).rule->polar == Polar::none) return false;
  return std::ranges::all_of(trace.operands(v), [&](ValueId from) {
    const ValueKind kind = trace.value(from).kind;
    return (kind != ValueKind::point && kind != ValueKind::vector) || !labels[from].empty();
  });
}

TEST_CASE("every point of a blossom carries a polar label, and nothing but points does", "[polar]") {
  for_each_run(30, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto run = record<Exact>(algorithm, inputs);
    const auto labels = run->trace.polar_labels();
    for (ValueId v = 0; v < run->trace.value_count(); ++v) {
      INFO(run->trace.name(v));
      if (is_labelled(algorithm, run->trace, labels, v)) CHECK(!labels[v].empty());
      if (run->trace.value(v).kind != ValueKind::point) CHECK(labels[v].empty());
    }
  });
}

TEST_CASE("every label is where the blossom of the input curve, or of what is made of it, has that value", "[polar]") {
  for_each_run(40, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    if (algorithm.id == "degree_reduction") return;  // on the way its pieces belong to neither curve
    if (algorithm.id == "polar_form") return;        // its arguments may lie anywhere: polar_form_test.cpp
    if (!std::ranges::any_of(algorithm.inputs, [](const InputSpec& spec) {
          return spec.name == "curve" && spec.type == InputSpec::Type::curve;
        }))
      return;
    const auto run = record<Exact>(algorithm, inputs);
    const auto labels = run->trace.polar_labels();
    const auto curve = algorithm.lifts ? lifted(inputs.curve("curve")) : inputs.curve("curve");
    std::vector<Curve<Exact>> made;
    if (const auto* one = std::get_if<Curve<Exact>>(&run->outcome)) made.push_back(*one);
    const auto is_value = [&](ValueId v, bool divided) {
      const auto has = [&](const Curve<Exact>& c) {
        return is_blossom_value(c, labels[v].u, run->trace.numbers(v), divided);
      };
      return has(curve) || std::ranges::any_of(made, has);
    };
    for (ValueId v = 0; v < run->trace.value_count(); ++v) {
      if (labels[v].empty()) continue;
      INFO(run->trace.name(v) << " = " << to_string(labels[v]));
      CHECK(labels[v].v.empty());
      const bool divided = run->trace.value(v).rule == &rule_info<Project>;
      CHECK(is_value(v, divided));
    }
  });
}

TEST_CASE("in skinning the labels are those of the profiles, and of the surface", "[polar]") {
  const Algorithm& algorithm = *find_algorithm("skinning");
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const auto inputs = any_inputs(algorithm, seed);
    INFO("seed " << seed << "\n" << to_text(inputs));
    const auto run = record<Exact>(algorithm, inputs);
    const auto& trace = run->trace;
    const auto labels = trace.polar_labels();
    const auto& surface = std::get<Surface<Exact>>(run->outcome);
    for (ValueId v = 0; v < trace.value_count(); ++v) {
      if (labels[v].empty()) continue;
      INFO(trace.name(v) << " = " << to_string(labels[v]));
      if (const int l = profile_of(trace, v); l >= 0) {
        const auto& profile = inputs.curves("profiles")[static_cast<std::size_t>(l)];
        CHECK(is_blossom_value(after_mapping(trace, v) ? over_unit_domain(profile) : profile, labels[v].u,
                               trace.numbers(v), false));
        continue;
      }
      // The tensor blossom of the surface: along each row of the net, then across the rows.
      Curve<Exact> across;
      across.degree = surface.degree[0];
      across.knots = surface.knots[0];
      const int along = find_span<Exact>(surface.knots[1], surface.degree[1], labels[v].v.front());
      for (int i = 0; i < surface.rows; ++i)
        across.points.push_back(elevated_blossom(row(surface, i), along, labels[v].v));
      double scale = 1;
      for (const auto& P : surface.points)
        scale = std::max({scale, std::abs(P.x.to_double()), std::abs(P.y.to_double()), std::abs(P.z.to_double())});
      const auto numbers = trace.numbers(v);
      bool found = false;
      for (int k = across.degree; k <= across.n(); ++k) {
        if (!(across.knots[static_cast<std::size_t>(k)] < across.knots[static_cast<std::size_t>(k) + 1])) continue;
        const auto P = elevated_blossom(across, k, labels[v].u);
        bool same = true;
        for (int c = 0; c < 4; ++c) {
          const Exact difference = abs(P[c] - numbers[static_cast<std::size_t>(c)]);
          same = same &&
                 (difference == Exact(0) || (difference.is_approximate() && difference.to_double() < 1e-9 * scale));
        }
        found = found || same;
      }
      CHECK(found);
    }
  }
}
