#include "kernel/knot_insertion.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (!check_parameter(inputs, at)) return;
  const auto& curve = inputs.curve("curve");
  const Exact& u = inputs.number("u");
  const int p = curve.degree;
  const int s = multiplicity(std::span<const Exact>(curve.knots), u);
  const int times = inputs.integer("times");
  if (s >= p)
    at("u").error("is a knot of multiplicity " + std::to_string(s) +
                  " already: nothing can be inserted beyond the degree " + std::to_string(p));
  else if (s + times > p)
    at("times").error("must be at most " + std::to_string(p - s) + " here: u has multiplicity " + std::to_string(s) +
                      " and the degree is " + std::to_string(p));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return knot_insertion(inputs.curve("curve"), inputs.number("u"), inputs.integer("times"), rec);
};

// The new knot at another place of the vector: one too early, one too late, or at the very end.
std::vector<Numbers<Exact>> misplaced_knot(const Site& site) {
  if (!(site.name() == "Ubar"_v())) return {};
  const Exact& u = site.operand(0)[0];
  const auto U = site.operand(2);
  const auto times = static_cast<std::size_t>(site.inputs().integer("times"));
  const auto place = std::upper_bound(U.begin(), U.end(), u) - U.begin();
  std::vector<Numbers<Exact>> candidates;
  for (const std::ptrdiff_t at : {place - 1, place + 1, static_cast<std::ptrdiff_t>(U.size())}) {
    if (at < 0 || at > static_cast<std::ptrdiff_t>(U.size())) continue;
    Numbers<Exact> knots(U.begin(), U.end());
    knots.insert(knots.begin() + at, times, u);
    candidates.push_back(std::move(knots));
  }
  return candidates;
}

}  // namespace

const Algorithm& knot_insertion() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "knot_insertion";
    a.family = Family::curve_technique;
    a.title = "Knot insertion";
    a.summary = "The same curve with one more knot, inserted once or several times (Boehm's algorithm).";
    a.source = "Shene, CS3621 notes, \"Knot Insertion\"; The NURBS Book, 5.2, A5.1";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"u", InputSpec::Type::number, "The new knot, in the domain."},
        {"times",
         InputSpec::Type::integer,
         "How often it is inserted; its multiplicity may grow up to the degree.",
         1,
         max_degree,
         {},
         "1"},
    };
    a.pseudo_code = {
        "find k with u_k <= u < u_{k+1}",
        "s = multiplicity of u",
        "for r = 1 to h",
        "  for i = k-p+r to k-s",
        "    a = alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i)",
        "    Q[r][i] = (1-a) Q[r-1][i-1] + a Q[r-1][i]",
        "Ubar = U with u put in h times",
        "Q = P_0..P_{k-p}, edges of the triangle, P_{k-s}..P_n",
    };
    a.given_narration = "A curve with the knots U = {U}. The new knot is u = {u}, to be inserted h = {h} times.";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "the new knot"},
        {"h", {}, "how often it is inserted"},
        {"U", {}, "the knot vector", 0, "Its knots are U = {value}."},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon, true},
        {"k", {}, "the span of u", 1, "In the knots {@1} the span that holds {@0} begins at index k = {k}."},
        {"s",
         {},
         "the multiplicity of u before",
         2,
         "{@0} is a knot already, of multiplicity s = {s}.",
         ValueSpec::Draw::none,
         false,
         {{"", "1-s", 0, "{@0} is no knot yet: s = 0."}}},
        {"alpha", {"r", "i"}, "the ratio for Q[r][i]", 5, "alpha[{r}][{i}] = {chain}."},
        {"Q",
         {"r", "i"},
         "the point i after the r-th insertion",
         6,
         "Insertion {r}: {name} divides its segment at alpha = {alpha[r][i]}: {numbers} = {made}.",
         ValueSpec::Draw::level,
         true},
        {"Ubar", {}, "the new knot vector", 7, "The new knot vector: Ubar = {value}."},
        {"Q",
         {"i"},
         "the new control point Q_i",
         8,
         "The new control polygon cuts corners off the old one; the curve is the same.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"collect", "The new control net", 8, "All that is left is to write down the new control points in order."}};
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>, &rule_info<Ratio>,
               &rule_info<Blend>,    &rule_info<Same>,         &rule_info<InsertKnot>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        missing_division(),
        unweighted_points(),
        unweighted_coordinates(),
        neighbour_knot(),
        wrong_pair(),
        wrong_span(),
        {"misplaced-knot", "the new knot stands at the wrong place of the knot vector",
         "Knots are in order: the new one goes behind the last knot that is not greater than it.", misplaced_knot}};
    a.asks = {"k", "alpha[1][*]", "Q[1][*]", "Ubar", "Q[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
