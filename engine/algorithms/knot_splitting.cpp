#include "kernel/knot_splitting.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const Exact& apart = inputs.number("apart");
  const bool part = Exact(0) < apart && apart < Exact(1);
  if (!part)
    at("apart").error("must lie between 0 and 1, a part of the way to the next knot, not " + format_brief(apart));
  if (!check_parameter(inputs, at)) return;
  const auto& curve = inputs.curve("curve");
  const Exact& u = inputs.number("u");
  const int s = multiplicity(std::span<const Exact>(curve.knots), u);
  if (u == curve.domain_begin() || u == curve.domain_end()) {
    at("u").error("is an end of the domain, which must stay: choose a multiple knot inside");
    return;
  }
  if (s < 2) {
    at("u").error(s == 0 ? "is no knot: choose a multiple knot of the curve"
                         : "is a simple knot: only a multiple knot can be split");
    return;
  }
  if (!part) return;
  NoRecorder<Exact> none;
  const Givens<Exact, NoId> U{curve.knots};
  const auto V =
      splitting::spread(none, U, none.list("U"_v, curve.knots), none.input("u"_v, u), none.input("apart"_v, apart));
  for (int i = 0; i + 1 < V.size(); ++i) {
    if (V[i].value == V[i + 1].value || V[i].value.to_double() != V[i + 1].value.to_double()) continue;
    at("apart").error("must be larger, or farther from 1: a double cannot tell the moved knots from their neighbours");
    return;
  }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return knot_splitting(inputs.curve("curve"), inputs.number("u"), inputs.number("apart"), rec);
};

bool is_moved(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<SpreadKnot>; }

// All copies moved the same way, beginning with u itself: u + j h.
std::vector<Numbers<Exact>> one_sided(const Site& site) {
  if (!is_moved(site)) return {};
  const auto s = site.sibling_numbers("s"_v()), k = site.sibling_numbers("k"_v());
  if (!s || !k) return {};
  const Exact j = Exact(site.name().index[0]) - (*k)[0] + (*s)[0] - Exact(1);
  return {{site.operand(0)[0] + j * site.operand(2)[0]}};
}

// s gaps between s copies.
std::vector<Numbers<Exact>> fence_posts(const Site& site) {
  if (site.name().symbol != Symbol::of("t")) return {};
  return {{site.operand(0)[0] / (site.operand(1)[0] + Exact(1))}};
}

}  // namespace

const Algorithm& knot_splitting() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "knot_splitting";
    a.family = Family::curve_technique;
    a.title = "Knot splitting";
    a.summary = "A multiple knot is pulled apart, which makes the curve smoother there and changes it a little.";
    a.source = "Zhao, Shene et al., DesignMentor; The NURBS Book, 2.5 and 3.2, on multiple knots";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve with a multiple knot inside its domain."},
        {"u", InputSpec::Type::number, "The multiple knot."},
        {"apart",
         InputSpec::Type::number,
         "How far the outermost copies move: a part, between 0 and 1, of the way to the nearer one of the next knots.",
         0,
         0,
         {},
         "\"1/10\""},
    };
    a.pseudo_code = {
        "u_{k-s+1} = ... = u_k = u: the copies of u",
        "g = min(u - u_{k-s}, u_{k+1} - u)",
        "h = apart · g",
        "for j = 0 to s-1",
        "  t[j] = (2j - s + 1) / (s - 1)",
        "  V[k-s+1+j] = u + t[j] h",
        "V = U with the moved knots; the points stay",
        "delta = distance of the old and the new point at u",
    };
    a.given_narration =
        "A curve of degree p = {p} with the knots U = {U}. The knot u = {u} stands there several times; its copies are "
        "to be moved apart.";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "the multiple knot"},
        {"apart", {}, "how far the copies move, as a part of the way to the next knot"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"r", "i"}, "the control point i (r = 0)", 0, "", ValueSpec::Draw::level},
        {"k", {}, "the last knot equal to u", 1, "The last copy of {@0} has the index k = {k}."},
        {"s", {}, "the multiplicity of u", 1, "There are s = {s} copies of {@0}."},
        {"g", {}, "the distance to the nearer neighbour", 2, "How far is it to the next knots? {chain}."},
        {"h", {}, "how far the outermost copies move", 3, "The outermost copies move by h = {chain}."},
        {"a", {"j"}, "the numerator 2j - s + 1"},
        {"b", {"j"}, "the denominator s - 1"},
        {"t",
         {"j"},
         "where copy j goes, from -1 to 1",
         5,
         "Copy {j} goes to t[{j}] = {result}, where the first is at -1 "
         "and the last at 1."},
        {"V", {"i"}, "the moved knot i", 6, "{name} = {chain}."},
        {"V", {}, "the new knot vector", 7, "The new knots are V = {value}."},
        {"Q",
         {"i"},
         "the control point i of the new curve",
         7,
         "They stay where they are, and are now those of another curve.",
         ValueSpec::Draw::polygon},
        {"C",
         {"i"},
         "the point at u on the old curve (0) and the new one (1)",
         8,
         "{name} = {chain}.",
         ValueSpec::Draw::point},
        {"delta",
         {},
         "the distance of the old and the new point at u",
         8,
         "At u the curve has moved by delta = {chain}. The farther the copies move, the more it changes."},
    };
    a.phases = {
        {"old", "The old point at u", 8, "How much does the curve change? First its point at u before."},
        {"net", "The same control points", 7, "What happens to the control points?"},
        {"new", "The new point at u", 8, "Now the point at u over the new knots."},
    };
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>, &rule_info<NearestKnot>, &rule_info<PartOfGap>,
               &rule_info<Fraction>, &rule_info<SpreadKnot>,   &rule_info<Gather>,      &rule_info<Same>,
               &rule_info<Project>,  &rule_info<Distance>,     &rule_info<FindSpan>,    &rule_info<Ratio>,
               &rule_info<Blend>,    &rule_info<Reparametrize>};
    a.misconceptions = {
        {"one-sided", "the copies all move to the same side",
         "They are spread evenly around u: the first one moves back as far as the last one moves on.", one_sided},
        {"fence-posts", "the way is divided by the number of copies",
         "Between s copies there are s-1 gaps: t[j] = (2j - s + 1) / (s - 1), from -1 to 1.", fence_posts}};
    a.asks = {"h", "t[*]", "V[*]", "V", "C[*]", "delta"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
