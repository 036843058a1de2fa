#include "kernel/polar_form.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  const auto& arguments = inputs.numbers("arguments");
  if (static_cast<int>(arguments.size()) != curve.degree) {
    at("arguments")
        .error("needs as many arguments as the degree of the curve, " + std::to_string(curve.degree) + ", not " +
               std::to_string(arguments.size()));
    return;
  }
  for (const Exact& t : arguments)
    for (std::size_t i = 0; i < curve.knots.size(); ++i) {
      if (t == curve.knots[i] || t.to_double() != curve.knots[i].to_double()) continue;
      at("arguments")
          .error("has an argument that differs from the knot u_" + std::to_string(i) + " = " +
                 format_brief(curve.knots[i]) + " by less than a double can tell; make them equal or move them apart");
      return;
    }
  const int span = inputs.integer("span");
  if (span == 0) return;
  const auto k = static_cast<std::size_t>(span);
  if (span < curve.degree || span > curve.n())
    at("span").error("must be 0 or the index of a span of the domain, " + std::to_string(curve.degree) + " to " +
                     std::to_string(curve.n()) + ", not " + std::to_string(span));
  else if (curve.knots[k] == curve.knots[k + 1])
    at("span").error("names an empty span: u_" + std::to_string(span) + " and u_" + std::to_string(span + 1) +
                     " are both " + format_brief(curve.knots[k]));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return polar_form(inputs.curve("curve"), inputs.numbers("arguments"), inputs.integer("span"), rec);
};

// The argument of the level before once more: de Boor's algorithm keeps its u, a blossom does not.
std::vector<Numbers<Exact>> argument_kept(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Ratio> || site.name().index[0] < 2) return {};
  const auto t = site.sibling_numbers("t"_v(site.name().index[0] - 1));
  const Exact& a = site.operand(1)[0];
  const Exact& b = site.operand(2)[0];
  if (!t || a == b) return {};
  return {{((*t)[0] - a) / (b - a)}};
}

// The mean of what the curve is at each argument, as though the blossom were that.
std::vector<Numbers<Exact>> mean_of_points(const Site& site) {
  if (!(site.name() == "b"_v())) return {};
  const auto& curve = site.inputs().curve("curve");
  const auto& arguments = site.inputs().numbers("arguments");
  Numbers<Exact> sum(4, Exact(0));
  for (const Exact& t : arguments) {
    if (t < curve.domain_begin() || curve.domain_end() < t) return {};
    NoRecorder<Exact> plain;
    const std::vector<Exact> diagonal(arguments.size(), t);
    const int k = find_span(std::span<const Exact>(curve.knots), curve.degree, t);
    HPoint<Exact> C;
    try {
      C = polar_form(curve, diagonal, k, plain);
    } catch (const KernelError&) {
      return {};
    }
    const Exact coordinates[] = {C.x, C.y, C.z};
    for (std::size_t c = 0; c < 3; ++c) sum[c] += coordinates[c] / (C.w * Exact(curve.degree));
  }
  sum[3] = Exact(1);
  return {sum};
}

}  // namespace

const Algorithm& polar_form() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "polar_form";
    a.family = Family::evaluation;
    a.title = "The blossom of a curve";
    a.summary = "De Boor's algorithm with an argument of its own on each level: the polar form of one piece.";
    a.source = "Ramshaw, \"Blossoming\", 1987; The NURBS Book, 5.2";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"arguments", InputSpec::Type::numbers,
         "As many numbers as the degree of the curve; they may lie outside of the domain, too.", 1, max_degree},
        {"span",
         InputSpec::Type::integer,
         "Which piece: the index k of its span; 0 for the piece in which the smallest argument lies.",
         0,
         1'000'000,
         {},
         "0"},
    };
    a.pseudo_code = {
        "find the piece: the span k of the smallest argument",
        "for r = 1 to p",
        "  for i = k-p+r to k",
        "    a = alpha[r][i] = (t_r - u_i) / (u_{i+p-r+1} - u_i)",
        "    P[r][i] = (1-a) P[r-1][i-1] + a P[r-1][i]",
        "b = P[p][k]",
    };
    a.given_narration =
        "A curve of degree p = {p} with the knots U = {U}, and p arguments, one for each level of the triangle.";
    a.values = {
        {"p", {}, "the degree"},
        {"t", {"r"}, "the argument of level r"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"t",
         {},
         "the smallest argument",
         1,
         "The smallest of the arguments is {value}: it says which piece is meant."},
        {"k",
         {},
         "the span of the piece",
         1,
         "It belongs to the span from u_{k} = {U[k]} to u_{k+1} = {U[k+1]}, so k = {k}: this piece has the control "
         "points {k-p} to {k}."},
        {"alpha",
         {"r", "i"},
         "the ratio for P[r][i]",
         4,
         "Level {r} puts in the argument {t[r]}: alpha[{r}][{i}] = {chain}."},
        {"P",
         {"r", "i"},
         "the point i of level r (level 0: the control points)",
         5,
         "{name} divides the segment from {#P[r-1][i-1]} to {#P[r-1][i]} at {alpha[r][i]}: {numbers} = {made}, the "
         "blossom value {polar}.",
         ValueSpec::Draw::level,
         true},
        {"b",
         {},
         "the blossom of the arguments",
         6,
         "All p arguments are in: {polar} = {value}.",
         ValueSpec::Draw::point},
    };
    a.rules = {&rule_info<Smallest>, &rule_info<PieceOf>, &rule_info<Ratio>,
               &rule_info<Blend>,    &rule_info<Same>,    &rule_info<Project>};
    a.misconceptions = {
        swapped_weights("P[r][i] = (1-alpha[r][i]) P[r-1][i-1] + alpha[r][i] P[r-1][i]: where alpha is 0 "
                        "the result is the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        missing_division(),
        neighbour_knot(),
        wrong_pair(),
        {"argument-kept", "the argument of the level before is used again",
         "Each level has its own argument: the ratios of level r are made from t_r.", argument_kept},
        {"mean-of-points", "the curve's points at the arguments are averaged",
         "The blossom is no mean of points of the curve: put the arguments in one after the other, one on each level.",
         mean_of_points}};
    a.asks = {"alpha[*][*]", "P[*][*]", "b"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
