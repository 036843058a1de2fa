#include "kernel/refinement.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

// Each new knot alone: in the domain, and told apart from every other knot by a double.
bool check_each(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  const auto& knots = inputs.numbers("new_knots");
  const std::string domain = "[" + format_brief(curve.domain_begin()) + ", " + format_brief(curve.domain_end()) + "]";
  bool right = true;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const auto wrong = [&](const std::string& message) {
      const Cursor list = at("new_knots");
      (list.is(Json::Kind::array) && i < list.size() ? list[i] : list).error(message);
      right = false;
    };
    const Exact& u = knots[i];
    if (u < curve.domain_begin() || curve.domain_end() < u) {
      wrong("must lie in the domain " + domain + ", not at " + format_brief(u));
      continue;
    }
    const auto too_close = [&](const Exact& other) { return u != other && u.to_double() == other.to_double(); };
    if (std::ranges::any_of(curve.knots, too_close) ||
        std::any_of(knots.begin(), knots.begin() + static_cast<std::ptrdiff_t>(i), too_close))
      wrong("differs from another knot by less than a double can tell; make them equal or move them apart");
  }
  return right;
}

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (!check_each(inputs, at)) return;
  const auto& curve = inputs.curve("curve");
  const auto& knots = inputs.numbers("new_knots");
  for (const auto& group : refine::groups(std::span<const Exact>(knots))) {
    const Exact& u = knots[static_cast<std::size_t>(group.front())];
    const int s = multiplicity(std::span<const Exact>(curve.knots), u);
    const int times = static_cast<int>(group.size());
    if (s + times <= curve.degree) continue;
    const int room = std::max(0, curve.degree - s);
    at("new_knots")
        .error("has " + format_brief(u) + " " + std::to_string(times) + (times == 1 ? " time" : " times") +
               ", but it can be inserted at most " + std::to_string(room) + (room == 1 ? " time" : " times") +
               ": its multiplicity is " + std::to_string(s) + " and the degree is " + std::to_string(curve.degree));
  }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return refinement(inputs.curve("curve"), inputs.numbers("new_knots"), rec);
};

// Each ratio from the knots that were there before anything was inserted.
std::vector<Numbers<Exact>> old_knots(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Ratio> || site.name().arity != 2) return {};
  const auto [r, i] = site.name().index;
  const int p = site.inputs().curve("curve").degree;
  const auto at = [&](int index) {
    const auto v = site.trace().find("U[" + std::to_string(index) + "]");
    return v ? std::optional(site.trace().numbers(*v)[0]) : std::nullopt;
  };
  const auto left = at(i), right = at(i + p - r + 1);
  if (!left || !right || *left == *right) return {};
  return {{(site.operand(0)[0] - *left) / (*right - *left)}};
}

// The new knots behind the old ones instead of in their places.
std::vector<Numbers<Exact>> unsorted_knots(const Site& site) {
  if (!(site.name() == "Ubar"_v()) || site.trace().value(site.value()).rule != &rule_info<Gather>) return {};
  Numbers<Exact> knots = site.inputs().curve("curve").knots;
  const auto& added = site.inputs().numbers("new_knots");
  knots.insert(knots.end(), added.begin(), added.end());
  return {knots};
}

}  // namespace

const Algorithm& refinement() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "refinement";
    a.family = Family::curve_technique;
    a.title = "Knot refinement";
    a.summary = "The same curve with many more knots at once, and a control polygon nearer to it.";
    a.source = "The NURBS Book, 5.3 (A5.4); Cohen, Lyche & Riesenfeld, Discrete B-splines, 1980";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"new_knots", InputSpec::Type::numbers,
         "The new knots, in any order; one that is given twice is inserted twice.", 1, 256},
    };
    a.pseudo_code = {
        "for each different new knot u, given h times",
        "  insert u h times: see knot insertion",
        "Ubar = all knots in order",
        "Q = the control points that are left",
    };
    a.given_narration =
        "A curve with the knots U = {U}. New knots are to be inserted; the curve stays the same, its polygon does not.";
    a.values = {
        {"X", {"i"}, "the new knot i, as given"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"Ubar", {}, "the new knot vector", 3, "All knots, old and new, in order: Ubar = {value}."},
        {"Q",
         {"i"},
         "the new control point Q_i",
         4,
         "The new control polygon has a point more for each new knot, and lies nearer to the curve.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"knot", "Insert new knot {index}", 1,
         "The next of the new knots in order is inserted, as often as it is given."},
        {"collect", "The refined curve", 3, "All new knots are in. What is left is to write down the curve."},
    };
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>, &rule_info<Ratio>,  &rule_info<Blend>,
               &rule_info<Same>,     &rule_info<InsertKnot>,   &rule_info<Gather>, &rule_info<SameNumber>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        {"old-knots", "the ratio is taken from the knots before refinement",
         "Each insertion changes the knot vector: the next one takes its ratios from the new knots.", old_knots},
        {"unsorted-knots", "the new knots stand behind the old ones",
         "A knot vector is in order: each new knot belongs between its neighbours.", unsorted_knots}};
    a.asks = {"knot[*].alpha[*][*]", "knot[*].Q[*][*]", "Ubar", "Q[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
