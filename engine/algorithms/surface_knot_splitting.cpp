#include "kernel/surface_knot_splitting.hpp"

#include "algorithms/surface_common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const Exact& apart = inputs.number("apart");
  const bool part = Exact(0) < apart && apart < Exact(1);
  if (!part)
    at("apart").error("must lie between 0 and 1, a part of the way to the next knot, not " + format_brief(apart));
  const auto d = direction_of(inputs);
  if (!check_surface_parameter(inputs, "t", d, at)) return;
  const auto& surface = inputs.surface("surface");
  const auto& knots = surface.knots[index(d)];
  const auto p = static_cast<std::size_t>(surface.degree[index(d)]);
  const Exact& t = inputs.number("t");
  if (t == knots[p] || t == knots[knots.size() - p - 1]) {
    at("t").error("is an end of the domain, which must stay: choose a multiple knot inside");
    return;
  }
  if (const int s = multiplicity(std::span<const Exact>(knots), t); s < 2) {
    at("t").error(s == 0 ? "is no knot: choose a multiple knot of the surface in this direction"
                         : "is a simple knot: only a multiple knot can be split");
    return;
  }
  if (!part) return;
  NoRecorder<Exact> none;
  const Givens<Exact, NoId> U{knots};
  const auto V =
      splitting::spread(none, U, none.list("U"_v, knots), none.input("u"_v, t), none.input("apart"_v, apart));
  for (int i = 0; i + 1 < V.size(); ++i) {
    if (V[i].value == V[i + 1].value || V[i].value.to_double() != V[i + 1].value.to_double()) continue;
    at("apart").error("must be larger, or farther from 1: a double cannot tell the moved knots from their neighbours");
    return;
  }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return surface_knot_splitting(inputs.surface("surface"), direction_of(inputs), inputs.number("t"),
                                inputs.number("apart"), rec);
};

// The whole of the gap where a part of it is meant.
std::vector<Numbers<Exact>> whole_gap(const Site& site) {
  if (!(site.name() == "h"_v())) return {};
  return {{site.operand(1)[0]}};
}

// The larger one of the neighbouring spans.
std::vector<Numbers<Exact>> larger_span(const Site& site) {
  if (!(site.name() == "g"_v())) return {};
  const Exact before = site.operand(0)[0] - site.operand(1)[0], behind = site.operand(2)[0] - site.operand(0)[0];
  return {{std::max(before, behind)}};
}

}  // namespace

const Algorithm& surface_knot_splitting() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_knot_splitting";
    a.family = Family::surface_technique;
    a.title = "Knot splitting on a surface";
    a.summary = "A multiple knot in u or v is pulled apart: a crease becomes smooth, and the surface changes a little.";
    a.source = "Zhao, Shene et al., DesignMentor; The NURBS Book, 2.5 and 3.4, on multiple knots";
    a.inputs = {
        surface_input(),
        direction_input("Whether it is a knot in u or in v."),
        {"t", InputSpec::Type::number, "The multiple knot, inside the domain."},
        {"apart",
         InputSpec::Type::number,
         "How far the outermost copies move: a part, between 0 and 1, of the way to the nearer one of the next knots.",
         0,
         0,
         {},
         "\"1/10\""},
    };
    a.pseudo_code = {
        "Ubar = the knots of this direction, with the copies of t moved apart",
        "Q = P: the control net stays",
        "for each column (u) or row (v) of the net",
        "  A = its point at t before",
        "  B = its point at t over the new knots",
        "  e = the distance of A and B",
        "E = the largest of these",
    };
    a.given_narration =
        "A surface with the knots U = {U} and V = {V}. The knot {t} stands there several times; its copies are to be "
        "moved apart.";
    a.values = surface_values();
    append(a.values, {
                         {"t", {}, "the multiple knot"},
                         {"apart", {}, "how far the copies move, as a part of the way to the next knot"},
                         {"Ubar", {}, "the new knots", 1, "The new knots of this direction are {value}."},
                         {"Q",
                          {"i", "j"},
                          "the control point in row i and column j",
                          2,
                          "All control points stay where they are. Only their knots are others.",
                          ValueSpec::Draw::net},
                         {"A",
                          {"j"},
                          "the point of line j at t before",
                          4,
                          "Before, the point of line {j} at {t} was {value}.",
                          ValueSpec::Draw::point},
                         {"B",
                          {"j"},
                          "the point of line j at t over the new knots",
                          5,
                          "Now it is {value}.",
                          ValueSpec::Draw::point},
                         {"e", {"j"}, "how far the point of line j has moved", 6, "Line {j} has moved by {chain}."},
                         {"E", {}, "the largest of these distances", 7, "The farthest move at {t}: E = {value}."},
                     });
    a.phases = {
        {"split", "Move the copies", 1, "The copies of the knot are moved apart, evenly."},
        {"net", "The net", 2, "What happens to the control points?"},
        {"column", "Column {index}", 3, "How much does the surface change at this knot? Column {index} tells."},
        {"row", "Row {index}", 3, "How much does the surface change at this knot? Row {index} tells."},
        {"old", "The old point", 4, "Its point before, by de Boor's algorithm."},
        {"new", "The new point", 5, "Its point over the new knots."},
    };
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>,  &rule_info<NearestKnot>, &rule_info<PartOfGap>,
               &rule_info<Fraction>, &rule_info<SpreadKnot>,    &rule_info<Gather>,      &rule_info<Same>,
               &rule_info<Distance>, &rule_info<Reparametrize>, &rule_info<SameNumber>,  &rule_info<Largest>,
               &rule_info<FindSpan>, &rule_info<Ratio>,         &rule_info<Blend>};
    a.misconceptions = {
        {"whole-gap", "the copies move the whole way to the next knot",
         "Only a part of the way: h = apart · g. The next knot itself must not be reached.", whole_gap},
        {"larger-span", "the larger neighbouring span is taken",
         "g is the distance to the nearer neighbour, so that the moved knots stay in order.", larger_span}};
    a.asks = {"Ubar", "e[*]", "E"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
