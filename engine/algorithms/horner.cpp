#include "kernel/horner.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& interval = inputs.numbers("interval");
  if (!(interval[0].to_double() < interval[1].to_double())) {
    at("interval").error("must begin before it ends: [0, 1], say");
    return;
  }
  const Exact& u = inputs.number("u");
  if (u < interval[0] || interval[1] < u)
    at("u").error("must lie in the interval [" + format_brief(interval[0]) + ", " + format_brief(interval[1]) +
                  "], not at " + format_brief(u));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return horner(inputs.points("coefficients"), inputs.number("u"), rec);
};

std::vector<Curve<double>> pictured(const Inputs<double>& inputs) {
  const auto& interval = inputs.numbers("interval");
  return {bezier_of_power(inputs.points("coefficients"), interval[0], interval[1])};
}

bool is_horner(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  return rule == &rule_info<HornerVector> || rule == &rule_info<HornerPoint>;
}

Numbers<Exact> horner_step(const Site& site, NumbersView<Exact> A, const Exact& u, NumbersView<Exact> B) {
  Numbers<Exact> made;
  for (std::size_t x = 0; x < 3; ++x) made.push_back(A[x] + u * B[x]);
  made.push_back(site.trace().numbers(site.value())[3]);
  return made;
}

// a[k] + b[k+1].
std::vector<Numbers<Exact>> factor_forgotten(const Site& site) {
  if (!is_horner(site)) return {};
  return {horner_step(site, site.operand(0), Exact(1), site.operand(2))};
}

// a[k] u + b[k+1].
std::vector<Numbers<Exact>> wrong_factor(const Site& site) {
  if (!is_horner(site)) return {};
  const auto made = horner_step(site, site.operand(2), site.operand(1)[0], site.operand(0));
  return {made};
}

// a[n-k] where a[k] belongs.
std::vector<Numbers<Exact>> other_end(const Site& site) {
  const bool point = site.name() == "C"_v();
  if (!is_horner(site) || !(point || site.name().symbol == Symbol::of("b"))) return {};
  const int n = static_cast<int>(site.inputs().points("coefficients").points.size()) - 1;
  const int k = point ? 0 : site.name().index[0];
  const auto a = site.sibling_numbers("a"_v(n - k));
  if (!a || 2 * k == n) return {};
  return {horner_step(site, *a, site.operand(1)[0], site.operand(2))};
}

// The mean velocity b[1], not the velocity.
std::vector<Numbers<Exact>> chord_for_tangent(const Site& site) {
  if (!(site.name() == "D"_v()) || !is_horner(site)) return {};
  const auto b = site.operand(0);
  return {Numbers<Exact>(b.begin(), b.end())};
}

}  // namespace

const Algorithm& horner() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "horner";
    a.family = Family::evaluation;
    a.title = "Horner's scheme";
    a.summary = "A point of a polynomial parametric curve and its tangent vector, from the coefficients of its powers.";
    a.source = "The NURBS Book, 1.2 (A1.1); Shene, CS3621 notes, \"Parametric Curves\"";
    a.inputs = {
        {"coefficients", InputSpec::Type::points,
         "a_0, a_1, ..., a_n of C(u) = a_0 + a_1 u + ... + a_n u^n: one point, and then vectors.", 2, max_degree + 1},
        {"u", InputSpec::Type::number, "The parameter, in the interval."},
        {"interval", InputSpec::Type::numbers, "From which u to which the curve runs.", 2, 2, {}, "[0, 1]"},
    };
    a.pseudo_code = {
        "b[n] = a[n]",   "for k = n-1 down to 1", "  b[k] = a[k] + u b[k+1]",   "C = a[0] + u b[1]",
        "c[n-1] = b[n]", "for k = n-2 down to 1", "  c[k] = b[k+1] + u c[k+1]", "C' = D = b[1] + u c[1]  (n = 1: b[1])",
    };
    a.given_narration =
        "A curve C(u) = a[0] + a[1] u + ... + a[n] u^n, and the parameter u = {u}. Where is the point C({u}), and "
        "how fast does it move?";
    a.values = {
        {"u", {}, "the parameter"},
        {"a",
         {"k"},
         "the coefficient of u^k (a[0]: the point at u = 0)",
         0,
         "",
         ValueSpec::Draw::point,
         false,
         {},
         "a[0]"},
        {"b",
         {"k"},
         "what Horner's scheme has from a[n] down to a[k]",
         3,
         "Multiply by u and add the next coefficient: {name} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"leading_vector", "", 1, "Begin with the coefficient of the highest power: {name} = {value}."}},
         "a[0]"},
        {"C",
         {},
         "the point on the curve",
         4,
         "The last coefficient to be added is the point a[0]: C({u}) = {chain}.",
         ValueSpec::Draw::point},
        {"c",
         {"k"},
         "what the same scheme has of the derivative, down to b[k+1]",
         7,
         "Multiply by u and add {#b[k+1]}: {name} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"same_vector", "", 5, "The same scheme once more, on the b's. It begins with {name} = {value}."}},
         "C"},
        {"D",
         {},
         "the tangent vector C'(u)",
         8,
         "The tangent vector: C'({u}) = {chain}.",
         ValueSpec::Draw::none,
         false,
         {},
         "C"},
    };
    a.phases = {
        {"point", "The point", 1,
         "Written as a[0] + u (a[1] + u (a[2] + ...)), the polynomial of degree n needs n multiplications by u."},
        {"tangent", "The tangent vector", 5,
         "What the scheme made on its way, b[1] to b[n], are the coefficients of a second polynomial, whose value "
         "is the derivative."},
    };
    a.rules = {&rule_info<LeadingVector>, &rule_info<HornerVector>, &rule_info<HornerPoint>, &rule_info<SameVector>};
    a.misconceptions = {
        {"factor-forgotten", "the multiplication by u is forgotten",
         "Each step multiplies what it has by u before the next coefficient is added: b[k] = a[k] + u b[k+1].",
         factor_forgotten},
        {"wrong-factor", "the coefficient is multiplied by u, not what is there already",
         "It is b[k+1] that is multiplied by u: all higher powers get one factor more. a[k] is only added.",
         wrong_factor},
        {"other-end", "the coefficients are taken from the wrong end",
         "Horner's scheme begins with the highest power and adds a[n-1], a[n-2], ..., last of all a[0].", other_end},
        {"chord-for-tangent", "the mean velocity is given for the velocity",
         "b[1] leads from a[0] to the point, as a chord does. The tangent vector is b[1] + u c[1].",
         chord_for_tangent}};
    a.asks = {"b[*]", "C", "D"};
    a.check = check;
    a.pictured = pictured;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
