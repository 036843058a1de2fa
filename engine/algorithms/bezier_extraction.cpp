#include "kernel/bezier_extraction.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return bezier_extraction(inputs.curve("curve"), rec);
};

// Inserted p times more, whatever its multiplicity was, or once less than needed.
std::vector<Numbers<Exact>> wrong_times(const Site& site) {
  if (!(site.name() == "Ubar"_v())) return {};
  const Exact& u = site.operand(0)[0];
  const auto U = site.operand(2);
  const int p = site.inputs().curve("curve").degree;
  std::vector<Numbers<Exact>> candidates;
  for (const int times : {p, p - 1}) {
    Numbers<Exact> knots(U.begin(), U.end());
    knots.insert(std::upper_bound(knots.begin(), knots.end(), u), static_cast<std::size_t>(times), u);
    candidates.push_back(std::move(knots));
  }
  return candidates;
}

// The first point of a segment is the point behind the last one of the segment before.
std::vector<Numbers<Exact>> separate_ends(const Site& site) {
  if (!(site.name().symbol == Symbol::of("B")) || site.name().arity != 2) return {};
  Name next = site.name();
  ++next.index[1];
  if (site.name().index[0] == 0) return {};
  const auto numbers = site.sibling_numbers(next);
  if (!numbers) return {};
  return {Numbers<Exact>(numbers->begin(), numbers->end())};
}

}  // namespace

const Algorithm& bezier_extraction() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "bezier_extraction";
    a.family = Family::curve_technique;
    a.title = "Bézier extraction";
    a.summary = "A B-spline curve as the Bézier curves it is made of, one for each knot span.";
    a.source = "The NURBS Book, 5.3, A5.6; Shene, CS3621 notes, \"Inserting a Knot Multiple Times\"";
    a.inputs = {{"curve", InputSpec::Type::curve, "A curve of any kind; an unclamped one is clamped first."}};
    a.pseudo_code = {
        "clamp the curve, if it is not",
        "for each different knot u inside the domain",
        "  s = multiplicity of u",
        "  insert u p-s times: see knot insertion",
        "for each nonempty span [u_a, u_{a+1}], the j-th",
        "  B[j] = P_{a-p} .. P_a",
    };
    a.given_narration =
        "A curve of degree p = {p} with the knots U = {U}. Between two knots it is a Bézier curve: which one?";
    a.values = {
        {"p", {}, "the degree"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"W", {}, "the knots of the clamped curve", 1, "Clamped, the curve has the knots {value}."},
        {"B",
         {"j", "i"},
         "the control point i of segment j",
         6,
         "Segment {j}: its p + 1 = {p+1} Bézier points follow one another in the refined polygon.",
         ValueSpec::Draw::level},
    };
    a.phases = {
        {"clamp", "Clamp the curve", 1, "The curve is not clamped: first its ends become knots of full multiplicity."},
        {"end", "End {index}", 1, "Insert the end of the domain until it has full multiplicity."},
        {"knot", "Raise inner knot {index}", 4, "The next inner knot is inserted until it has multiplicity p."},
        {"segments", "The segments", 5,
         "Every knot has full multiplicity now, so the curve passes through a control point at each. The points "
         "between two such points are a Bézier polygon."},
    };
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>, &rule_info<Ratio>,  &rule_info<Blend>,
               &rule_info<Same>,     &rule_info<InsertKnot>,   &rule_info<Gather>, &rule_info<SameNumber>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        {"wrong-times", "a knot is inserted too often or too seldom",
         "A knot of multiplicity s is inserted p-s times: it stands there p times afterwards, and no more.",
         wrong_times},
        {"separate-ends", "neighbouring segments do not share their end point",
         "The last point of a segment is the first point of the next one.", separate_ends}};
    a.asks = {"knot[*].alpha[*][*]", "knot[*].Q[*][*]", "B[*][*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
