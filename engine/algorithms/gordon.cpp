#include "kernel/gordon.hpp"

#include "algorithms/network.hpp"

namespace blossom {
namespace {

// The parameters that are meant: those given, or evenly spaced ones.
std::vector<Exact> parameters(const Inputs<Exact>& inputs, std::string_view name, const Curve<Exact>& curve,
                              std::size_t count) {
  auto t = inputs.numbers(name);
  if (!t.empty()) return t;
  const Exact begin = curve.domain_begin(), width = curve.domain_end() - begin;
  for (std::size_t k = 0; k < count; ++k)
    t.push_back(begin + width * Exact::ratio(static_cast<std::int64_t>(k), static_cast<std::int64_t>(count) - 1));
  return t;
}

// Whether all curves of one way have one domain, and the parameters of the others run through it.
bool check_family(const Inputs<Exact>& inputs, const ReportAt& at, std::string_view curves_name,
                  std::string_view parameters_name, std::size_t crossing) {
  const auto& curves = inputs.curves(curves_name);
  const Exact begin = curves[0].domain_begin(), end = curves[0].domain_end();
  for (std::size_t l = 1; l < curves.size(); ++l)
    if (curves[l].domain_begin() != begin || curves[l].domain_end() != end) {
      at(curves_name)
          .error("must all have one domain, for the others cross them at common parameters: number " +
                 std::to_string(l) + " is over [" + format_brief(curves[l].domain_begin()) + ", " +
                 format_brief(curves[l].domain_end()) + "], not [" + format_brief(begin) + ", " + format_brief(end) +
                 "]");
      return false;
    }
  const auto& t = inputs.numbers(parameters_name);
  if (t.empty()) return true;
  std::string wrong;
  if (t.size() != crossing)
    wrong = "must be " + std::to_string(crossing) + ", one for each curve that crosses, or none: not " +
            std::to_string(t.size());
  else if (t.front() != begin || t.back() != end)
    wrong = "must begin at " + format_brief(begin) + " and end at " + format_brief(end) + ", as the curves do";
  else
    for (std::size_t k = 0; k + 1 < t.size() && wrong.empty(); ++k)
      if (!(t[k].to_double() < t[k + 1].to_double()))
        wrong = "must ascend, but number " + std::to_string(k + 1) + " is not above the one before it";
  if (!wrong.empty()) at(parameters_name).error(wrong);
  return wrong.empty();
}

void check(const Inputs<Exact>& inputs, const ReportAt& at) {
  const auto &u_curves = inputs.curves("u_curves"), &v_curves = inputs.curves("v_curves");
  if (!check_weights(inputs, at)) return;
  const bool u = check_family(inputs, at, "u_curves", "u_parameters", v_curves.size());
  const bool v = check_family(inputs, at, "v_curves", "v_parameters", u_curves.size());
  if (!u || !v) return;
  const auto us = parameters(inputs, "u_parameters", u_curves[0], v_curves.size());
  const auto vs = parameters(inputs, "v_parameters", v_curves[0], u_curves.size());
  int told = 0;
  for (std::size_t l = 0; l < u_curves.size() && told < 4; ++l)
    for (std::size_t k = 0; k < v_curves.size() && told < 4; ++k)
      if (!check_meeting(inputs, at, l, us[k], k, vs[l])) ++told;
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return gordon(inputs.curves("u_curves"), inputs.curves("v_curves"), inputs.numbers("u_parameters"),
                inputs.numbers("v_parameters"), rec);
};

// The tensor surface is added.
std::vector<Numbers<Exact>> tensor_added(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<SubtractNet>) return {};
  const auto A = site.operand(0), B = site.operand(1);
  return {{A[0] + B[0], A[1] + B[1], A[2] + B[2], A[3] - B[3]}};
}

// The skin of the curves along v alone.
std::vector<Numbers<Exact>> tensor_forgotten(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<SubtractNet>) return {};
  const auto A = site.operand(0), B = site.operand(1);
  return {{A[0], A[1], A[2], A[3] - B[3]}};
}

// The parameters themselves as knots.
std::vector<Numbers<Exact>> parameters_as_knots(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<MeanOrKnot>) return {};
  const auto operands = site.trace().operands(site.value());
  const auto t = site.numbers(operands[1 + (operands.size() - 1) / 2]);
  return {Numbers<Exact>(t.begin(), t.end())};
}

}  // namespace

const Algorithm& gordon() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "gordon";
    a.family = Family::construction;
    a.title = "Gordon surface";
    a.summary = "The surface through a network of curves: two skins less the interpolant of the crossings.";
    a.source = "The NURBS Book, 10.5; Gordon, \"Spline-blended surface interpolation through curve networks\", 1969";
    a.inputs = {
        {"u_curves", InputSpec::Type::curves,
         "The curves along u, in the order of v, at least two, over one domain. All weights must be equal.", 2},
        {"v_curves", InputSpec::Type::curves, "The curves along v, in the order of u, at least two, over one domain.",
         2},
        {"u_parameters",
         InputSpec::Type::numbers,
         "Where the curves along v cross those along u, from the beginning of their domain to its end; none: evenly "
         "spaced.",
         0,
         256,
         {},
         "[]"},
        {"v_parameters",
         InputSpec::Type::numbers,
         "Where the curves along u cross those along v; none: evenly spaced.",
         0,
         256,
         {},
         "[]"},
    };
    a.pseudo_code = {
        "make the curves compatible, those along u, those along v",
        "UT, VT = averages of the parameters u_k, v_l",
        "S1 = skin of the curves along u, at v_l",
        "S2 = skin of the curves along v, at u_k",
        "X[k][l] = the points where they cross",
        "T = interpolant of the X[k][l] at u_k, v_l",
        "one knot vector along v for S1, S2 and T",
        "D = S2 - T",
        "one knot vector along u for S1 and D",
        "Q = S1 + D",
    };
    a.given_narration =
        "A network of curves: some along u, some along v, and they cross. A surface is to hold them all.";
    a.values = {
        {"U", {"l", "i"}, "the knot i of curve l along u"},
        {"P", {"l", "i"}, "the control point i of curve l along u", 0, "", ValueSpec::Draw::level},
        {"V", {"k", "j"}, "the knot j of curve k along v"},
        {"R", {"k", "j"}, "the control point j of curve k along v", 0, "", ValueSpec::Draw::level},
        {"k", {"k"}, "the index k; 0: how many spaces there are"},
        {"l", {"l"}, "the index l; 0: how many spaces there are"},
        {"u", {"k"}, "the parameter of curve k along v", 2, "The curve {k} along v crosses at {name} = {value}."},
        {"v", {"l"}, "the parameter of curve l along u", 2, "The curve {l} along u crosses at {name} = {value}."},
        {"V", {}, "the knots of the curves along v", 2, "The curves along v have the knots {value}."},
        {"UT",
         {"i"},
         "a knot along u for interpolation",
         2,
         "A knot along u, the mean of neighbouring parameters: {value}."},
        {"VT",
         {"j"},
         "a knot along v for interpolation",
         2,
         "A knot along v, the mean of neighbouring parameters: {value}."},
        {"UT", {}, "the knots along u for interpolation", 2, "The knots for interpolation along u: {value}."},
        {"VT", {}, "the knots along v for interpolation", 2, "The knots for interpolation along v: {value}."},
        {"p", {}, "the degree of interpolation along u"},
        {"q", {}, "the degree of interpolation along v"},
        {"pu", {}, "the degree of the curves along u"},
        {"UC", {}, "the knots of the curves along u", 5, "The curves along u have the knots {value}."},
        {"j", {"j"}, "the index j"},
        {"N", {"j"}, "the basis function j at this parameter", 5, "{name} = {result}."},
        {"C", {"l", "i"}, "the sum that makes the point", 5, "Summed up for curve {l} so far: {value}."},
        {"X",
         {"k", "l"},
         "the point where the curves cross",
         5,
         "Curve {l} along u and curve {k} along v cross at {name} = {value}.",
         ValueSpec::Draw::net},
        {"B",
         {"l", "i"},
         "the control point i of line l of the nets, as of a curve",
         7,
         "Line {l} of the nets is a curve with these control points.",
         ValueSpec::Draw::net},
        {"D", {"i", "j"}, "the second skin less the interpolant", 8, "{name} = {chain}."},
        {"Q", {"i", "j"}, "the surface's control point", 10, "{name} = {chain}.", ValueSpec::Draw::net},
    };
    a.phases = {
        {"parameters", "Parameters and knots", 2,
         "At which parameters do the curves cross? They give the knots of all interpolation, too."},
        {"skin_u", "Skin the curves along u", 3, "The first surface: a skin through the curves along u."},
        {"skin_v", "Skin the curves along v", 4, "The second surface: a skin through the curves along v."},
        {"crossings", "Where the curves cross", 5, "Both surfaces contain the points where the curves cross."},
        {"at", "Along curve {index}", 5, "The points of all curves along u on the curve {index} along v."},
        {"tensor_u", "Interpolate the crossings along u", 6,
         "The third surface contains the crossings only. First curves along u are put through them."},
        {"tensor_v", "Interpolate the crossings along v", 6, "Then these curves are skinned along v."},
        {"common_v", "One knot vector along v", 7,
         "To be added, the three surfaces need the same degree and knots. Each row of a net is a curve along v."},
        {"subtract", "Second less third", 8, "The interpolant of the crossings is subtracted from the second skin."},
        {"common_u", "One knot vector along u", 9, "Likewise along u: each column is a curve."},
        {"sum", "Add", 10,
         "On each curve along u the difference is zero, on each along v the first skin and the third surface agree."},
    };
    a.rules = {&rule_info<SpanShare>,  &rule_info<MeanOrKnot>,  &rule_info<BasisValue>, &rule_info<WeighPoint>,
               &rule_info<AddWeighed>, &rule_info<SubtractNet>, &rule_info<AddNet>};
    add_families(a, 1);
    a.misconceptions = {
        {"tensor-added", "the interpolant of the crossings is added",
         "Both skins contain the crossings, so their sum has them twice: subtract the interpolant once.", tensor_added},
        {"tensor-forgotten", "the interpolant of the crossings is left out",
         "The sum of the two skins contains none of the curves: what both have in common must be subtracted.",
         tensor_forgotten},
        {"parameters-as-knots", "the parameters themselves are taken as knots",
         "The knots are means of neighbouring parameters: otherwise the system to be solved can become singular.",
         parameters_as_knots}};
    a.asks = {"u[*]", "v[*]", "X[*][*]", "Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
