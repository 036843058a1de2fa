#include "kernel/coons.hpp"

#include "algorithms/network.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const ReportAt& at) {
  const auto &u_curves = inputs.curves("u_curves"), &v_curves = inputs.curves("v_curves");
  if (u_curves.size() != 2) at("u_curves").error("must be two curves, not " + std::to_string(u_curves.size()));
  if (v_curves.size() != 2) at("v_curves").error("must be two curves, not " + std::to_string(v_curves.size()));
  if (u_curves.size() != 2 || v_curves.size() != 2 || !check_weights(inputs, at)) return;
  for (std::size_t l = 0; l < 2; ++l)
    for (std::size_t k = 0; k < 2; ++k)
      check_meeting(inputs, at, l, k == 0 ? u_curves[l].domain_begin() : u_curves[l].domain_end(), k,
                    l == 0 ? v_curves[k].domain_begin() : v_curves[k].domain_end());
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return coons(inputs.curves("u_curves"), inputs.curves("v_curves"), rec);
};

bool is_sum(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<BooleanSum>; }

// The corners are counted twice.
std::vector<Numbers<Exact>> not_subtracted(const Site& site) {
  if (!is_sum(site)) return {};
  const auto L = site.operand(0), M = site.operand(1), N = site.operand(2);
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 3; ++c) made.push_back(L[c] + M[c]);
  made.push_back(L[3] + M[3] - N[3]);
  return {made};
}

// The mean of the two ruled surfaces.
std::vector<Numbers<Exact>> mean(const Site& site) {
  if (!is_sum(site)) return {};
  return {blend(Numbers<Exact>{Exact::ratio(1, 2)}, site.operand(0), site.operand(1))};
}

// i/n where the Greville abscissa is meant.
std::vector<Numbers<Exact>> evenly_spaced(const Site& site) {
  const Symbol symbol = site.name().symbol;
  if ((symbol != Symbol::of("f") && symbol != Symbol::of("g")) || site.name().arity != 1) return {};
  const int last = last_row(site, site.name());
  return {{Exact::ratio(site.name().index[0], std::max(last, 1))}};
}

}  // namespace

const Algorithm& coons() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "coons";
    a.family = Family::construction;
    a.title = "Coons patch";
    a.summary = "The surface between four boundary curves: two ruled surfaces less the bilinear one.";
    a.source = "The NURBS Book, 10.6; Farin, Curves and Surfaces for CAGD, chapter 22";
    a.inputs = {
        {"u_curves", InputSpec::Type::curves,
         "The two boundary curves along u: at the beginning of v, then at its end. All weights must be equal.", 2},
        {"v_curves", InputSpec::Type::curves,
         "The two boundary curves along v: at the beginning of u, then at its end. They meet the others at the "
         "corners.",
         2},
    };
    a.pseudo_code = {
        "make the curves compatible, those along u, those along v",
        "f[i], g[j] = means of p knots, from 0 to 1",
        "L[i][j] = (1 - g[j]) A_0[i] + g[j] A_1[i]",
        "M[i][j] = (1 - f[i]) B_0[j] + f[i] B_1[j]",
        "E_l[i] = (1 - f[i]) A_l[0] + f[i] A_l[n]",
        "N[i][j] = (1 - g[j]) E_0[i] + g[j] E_1[i]",
        "Q[i][j] = L[i][j] + M[i][j] - N[i][j]",
    };
    a.given_narration = "Four curves that meet at four corners. A surface is to fill what is between them.";
    a.values = {
        {"U", {"l", "i"}, "the knot i of curve l along u"},
        {"P", {"l", "i"}, "the control point i of curve l along u", 0, "", ValueSpec::Draw::level},
        {"V", {"k", "j"}, "the knot j of curve k along v"},
        {"R", {"k", "j"}, "the control point j of curve k along v", 0, "", ValueSpec::Draw::level},
        {"a", {"i"}, "the Greville abscissa i along u", 2, "{name} = {result}."},
        {"f",
         {"i"},
         "where the control point i of a straight line along u lies",
         2,
         "A straight line has its control point {i} at the mean of p knots, {a[i]}: f[{i}] = {value} of the way."},
        {"b", {"j"}, "the Greville abscissa j along v", 2, "{name} = {result}."},
        {"g",
         {"j"},
         "where the control point j of a straight line along v lies",
         2,
         "Along v the control point {j} of a line lies at {b[j]}: g[{j}] = {value} of the way."},
        {"L", {"i", "j"}, "ruled between the curves along u", 3, "{name} = {chain}.", ValueSpec::Draw::net},
        {"M", {"i", "j"}, "ruled between the curves along v", 4, "{name} = {chain}.", ValueSpec::Draw::net},
        {"E",
         {"l", "i"},
         "on the line between two corners",
         5,
         "On the line between two corners: {name} = {chain}.",
         ValueSpec::Draw::net},
        {"N", {"i", "j"}, "the bilinear surface of the corners", 6, "{name} = {chain}.", ValueSpec::Draw::net},
        {"Q", {"i", "j"}, "the surface's control point", 7, "{name} = {chain}.", ValueSpec::Draw::net},
    };
    a.phases = {
        {"lines", "Straight lines over these knots", 2,
         "Three surfaces with straight lines in them are added. Where does a line have its control points over our "
         "knots?"},
        {"ruled_v", "Ruled between the curves along u", 3,
         "The first surface: straight from the first curve along u to the second. It has two of the four boundaries."},
        {"ruled_u", "Ruled between the curves along v", 4,
         "The second surface: straight from the first curve along v to the second. It has the other two."},
        {"bilinear", "The bilinear surface of the corners", 5,
         "In the sum of both, the straight lines between the corners are too much. The third surface has just these."},
        {"sum", "Add and subtract", 7, "First plus second minus third: on each boundary two of them cancel."},
    };
    a.rules = {&rule_info<Mean>, &rule_info<BetweenPoints>, &rule_info<BooleanSum>};
    add_families(a, 1);
    a.misconceptions = {
        {"not-subtracted", "the bilinear surface is not subtracted",
         "The sum of the two ruled surfaces has the lines between the corners twice: subtract them once.",
         not_subtracted},
        {"mean-of-both", "the mean of the two ruled surfaces is taken",
         "Their mean contains none of the four boundaries. Add both and subtract the bilinear surface of the corners.",
         mean},
        {"evenly-spaced", "the control points of a line are spaced evenly",
         "Over knots a straight line has its control points at the means of p neighbouring knots, not at i/n.",
         evenly_spaced}};
    a.asks = {"f[*]", "g[*]", "Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
