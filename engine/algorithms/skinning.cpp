#include "kernel/skinning.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const int profiles = static_cast<int>(inputs.curves("profiles").size());
  if (const int q = inputs.integer("degree_v"); q > profiles - 1)
    at("degree_v")
        .error("must be from 1 to " + std::to_string(profiles - 1) + " (profiles - 1), not " + std::to_string(q));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  const auto& name = inputs.choice("parametrization");
  const auto parametrization = name == "uniform"       ? Parametrization::uniform
                               : name == "centripetal" ? Parametrization::centripetal
                                                       : Parametrization::chord;
  return skinning(inputs.curves("profiles"), inputs.integer("degree_v"), parametrization, rec);
};

// v_l = l/K whatever the distances.
std::vector<Numbers<Exact>> always_uniform(const Site& site) {
  if (site.name().symbol != Symbol::of("v") || site.name().arity != 1 ||
      site.inputs().choice("parametrization") == "uniform")
    return {};
  const int K = static_cast<int>(site.inputs().curves("profiles").size()) - 1;
  return {{Exact::ratio(site.name().index[0], K)}};
}

// The distance itself where its share of the whole is meant.
std::vector<Numbers<Exact>> not_divided(const Site& site) {
  if (site.name().symbol != Symbol::of("e") || site.name().arity != 2) return {};
  const auto d = site.operand(0);
  return {Numbers<Exact>(d.begin(), d.end())};
}

// The parameters taken as knots, without averaging.
std::vector<Numbers<Exact>> parameters_as_knots(const Site& site) {
  if (site.name().symbol != Symbol::of("V") || site.name().arity != 1) return {};
  const auto middle = site.trace().operands(site.value());
  const auto v = site.numbers(middle[middle.size() / 2]);
  return {Numbers<Exact>(v.begin(), v.end())};
}

}  // namespace

const Algorithm& skinning() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "skinning";
    a.family = Family::construction;
    a.title = "Skinning";
    a.summary = "A surface through profile curves, each of which is an isoparametric curve of it.";
    a.source = "Shene, CS3621 notes, \"Skinned Surfaces\"; The NURBS Book, 10.3";
    a.inputs = {
        {"profiles", InputSpec::Type::curves, "The profile curves in order, at least two, of any kinds and degrees.",
         2},
        {"degree_v", InputSpec::Type::integer, "The degree across the profiles, from 1 to profiles - 1.", 1,
         max_degree},
        {"parametrization",
         InputSpec::Type::choice,
         "How the profiles get their parameters v.",
         0,
         0,
         {"chord", "centripetal", "uniform"},
         "\"chord\""},
    };
    a.pseudo_code = {
        "make profiles compatible: one degree, one knot vector",
        "d[l][i] = distance from P[l-1][i] to P[l][i]",
        "e[l][i] = d[l][i] / sum of d[1..K][i]",
        "v_l = v_{l-1} + mean over i of e[l][i]",
        "V = averages of q parameters each",
        "N[l][j] = N_{j,q}(v_l)",
        "eliminate below the diagonal of N",
        "for each i: solve N Q[i] = P[.][i]",
    };
    a.given_narration = "The profile curves, in order, and the degree q = {q} across them.";
    a.values = {
        {"q", {}, "the degree across the profiles"},
        {"U", {"l", "j"}, "the knot j of profile l"},
        {"P", {"l", "i"}, "the control point i of profile l", 0, "", ValueSpec::Draw::level},
        {"U", {}, "the knots of a profile as one vector", 1, "Its knot vector so far: {value}."},
        {"U",
         {"i"},
         "a knot, mapped to [0, 1]; in the phase merge: the knots of profile i",
         1,
         "{name} = {result}.",
         ValueSpec::Draw::none,
         false,
         {{"gather", "", 0, "The knots of profile {i}: {value}."}}},
        {"P",
         {"i"},
         "a control point, over the mapped knots",
         1,
         "The control points stay where they are.",
         ValueSpec::Draw::polygon},
        {"W",
         {"l"},
         "the union of the knots of profiles 0..l",
         1,
         "All knots that profiles 0 to {l} need: {value}.",
         ValueSpec::Draw::none,
         false,
         {{"", "1-l", 0, "Profile 0 needs the knots {value}."}}},
        {"K", {}, "the number of profiles less one"},
        {"l", {"l"}, "the index l"},
        {"c", {"l", "i"}, "the distance between neighbouring control points", 2, "{name} = {chain}."},
        {"d", {"l", "i"}, "the distance (centripetal: its square root)", 2, "{name} = {chain}."},
        {"L", {"i"}, "the whole length of column i", 2, "Column {i} is {value} long in all."},
        {"e", {"l", "i"}, "the share of the l-th distance in column i", 3, "{name} = {chain}."},
        {"e",
         {"l"},
         "the mean share over all columns",
         4,
         "Averaged over all columns, profile {l} is {value} further."},
        {"v", {"l"}, "the parameter of profile l", 4, "Profile {l} gets the parameter v_{l} = {value}."},
        {"V", {"j"}, "the v-knot j", 5, "The knot V[{j}] is the mean of q = {q} parameters: {value}."},
        {"V", {}, "the v-knots", 5, "The knot vector across the profiles: V = {value}."},
        {"j", {"l", "j"}, "the index j"},
        {"N", {"l", "j"}, "the basis function j at v_l", 6, "{name} = {result}."},
        {"m", {"l", "c"}, "what is subtracted of row c from row l", 7, "Row {l} loses {chain} times row {c}."},
        {"A", {"c", "j"}, "an entry of the eliminated matrix", 7, "Entry {j} of the row: {result}."},
        {"D", {"l", "c"}, "the right-hand side after removing row c", 8, "Forward: {chain}."},
        {"X", {"l", "j"}, "the right-hand side after removing what is known", 8, "Backward: {chain}."},
        {"Q",
         {"i", "j"},
         "the surface's control point",
         8,
         "The control point {name} = {chain}.",
         ValueSpec::Draw::net},
    };
    a.phases = {
        {"compatible", "Make the profiles compatible", 1,
         "First all profiles get one degree and one knot vector, without changing shape."},
        {"clamp", "Clamp profile {index}", 1, "Profile {index} is not clamped: its domain's ends are inserted."},
        {"end", "End {index}", 1, "Insert the end of the domain until it has full multiplicity."},
        {"raise", "Raise the degree of profile {index}", 1, "Profile {index} has too low a degree: it is elevated."},
        {"domain", "Map profile {index} to [0, 1]", 1,
         "The domains differ: the knots of profile {index} are mapped to [0, 1]."},
        {"merge", "Merge the knots", 1, "Which knots do all profiles together need?"},
        {"refine", "Refine profile {index}", 1, "Profile {index} lacks some of them: they are inserted."},
        {"knot", "Insert knot {index}", 1, "The next knot that is missing is inserted as often as it is missing."},
        {"parameters", "Parameters of the profiles", 2,
         "At which v does each profile lie? The distances between the profiles decide."},
        {"knots", "Knots across the profiles", 5, "The knots across the profiles are averages of the parameters."},
        {"interpolate", "Interpolate", 7,
         "Column by column, a curve is put through the control points of the profiles."},
        {"row", "Eliminate in row {index}", 7, "Row {index} loses its entry left of the diagonal."},
        {"column", "Column {index}", 8, "Solve for column {index} of the control net."},
    };
    a.rules = {&rule_info<Gather>,   &rule_info<UniteKnots>, &rule_info<Distance>,     &rule_info<Root>,
               &rule_info<Total>,    &rule_info<Quotient>,   &rule_info<Mean>,         &rule_info<Sum>,
               &rule_info<Fraction>, &rule_info<BasisValue>, &rule_info<ReduceNumber>, &rule_info<Reduce>,
               &rule_info<Scale>,    &rule_info<Ratio>,      &rule_info<SameNumber>,   &rule_info<Reparametrize>};
    a.misconceptions = {
        {"always-uniform", "the parameters are uniform",
         "The parameters follow the distances between the profiles: v grows more where the next profile is farther "
         "away.",
         always_uniform},
        {"not-divided", "the distances are not divided by the whole length",
         "Each distance counts by its share of its column's whole length, so that v runs from 0 to 1.", not_divided},
        {"parameters-as-knots", "the parameters themselves are taken as knots",
         "The knots are means of q neighbouring parameters: otherwise the system to be solved can become singular.",
         parameters_as_knots}};
    a.asks = {"v[*]", "V[*]", "Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
