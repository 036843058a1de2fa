#include "algorithms/narrate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "algorithms/typeset.hpp"

namespace blossom {

std::span<const std::string_view> placeholder_words() {
  static constexpr std::array<std::string_view, 8> words{"value", "name",   "formula", "numbers",
                                                         "made",  "result", "chain",   "polar"};
  return words;
}

template <Scalar S>
struct Narrator<S>::Context {
  std::uint32_t step;
  ValueId value;                    // the step's main value, or absent
  std::string scope;                // where unqualified names are looked up first
  const ValueSpec* spec = nullptr;  // of the main value
  std::uint32_t phase = absent;     // the phase the step is in
};

template <Scalar S>
Narrator<S>::Narrator(const Run<S>& run, int digits) : run_(&run), digits_(digits), labels_(run.trace.polar_labels()) {}

template <Scalar S>
std::string Narrator<S>::number(const S& x, bool decimals) const {
  if (std::same_as<S, Exact> && decimals && digits_ == 0) return format_number(to_double(x));
  if (digits_ == 0 || (std::same_as<S, Exact> && !decimals && !is_approximate(x))) return format_number(x);
  std::array<char, 40> rounded;
  std::snprintf(rounded.data(), rounded.size(), "%.*e", digits_ - 1,
                to_double(x));  // rounds; then the shortest text of it
  return format_number(std::strtod(rounded.data(), nullptr));
}

template <Scalar S>
const Algorithm& Narrator<S>::algorithm_at(std::uint32_t step) const {
  const auto& phases = trace().phases();
  std::uint32_t phase = trace().step(step).phase;
  // The step that introduces a phase still belongs to what is around it.
  if (phase != absent && trace().introduced_by(step) == phase) phase = phases[phase].parent;
  for (; phase != absent; phase = phases[phase].parent)
    if (!phases[phase].algorithm.empty())
      if (const Algorithm* found = find_algorithm(phases[phase].algorithm)) return *found;
  return *run_->algorithm;
}

template <Scalar S>
std::string Narrator<S>::kind(std::uint32_t step) const {
  if (trace().introduced_by(step) != absent) return "phase";
  const ValueId v = trace().main_value(step);
  return v == absent || trace().is_input(v) ? "given" : std::string(trace().value(v).rule->name);
}

namespace {

// The table entry that explains a value: of the algorithm around it, or of one further out.
const ValueSpec* spec_of(const Algorithm& inner, const Algorithm& outer, const Name& name) {
  const ValueSpec* spec = inner.spec(name);
  return spec != nullptr ? spec : outer.spec(name);
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

}  // namespace

template <Scalar S>
int Narrator<S>::line(std::uint32_t step) const {
  const Algorithm& algorithm = algorithm_at(step);
  if (const std::uint32_t phase = trace().introduced_by(step); phase != absent) {
    const PhaseSpec* spec = algorithm.phase(trace().phases()[phase].id);
    return spec != nullptr ? spec->line : 0;
  }
  const ValueId v = trace().main_value(step);
  if (v == absent || trace().is_input(v)) return 0;
  const Context context = context_at(step);
  if (context.spec == nullptr) return 0;
  const ValueSpec::Case* special = case_at(context);
  return special != nullptr && special->line > 0 ? special->line : context.spec->line;
}

template <Scalar S>
auto Narrator<S>::context_at(std::uint32_t step) const -> Context {
  // What is given at the start is given together: none of it is the step's own.
  Context context{step, step > 0 ? trace().main_value(step) : absent, "", nullptr, trace().step(step).phase};
  if (context.value == absent) return context;
  context.spec = spec_of(algorithm_at(step), *run_->algorithm, trace().value(context.value).name);
  // Other values of the step are looked up where the phase is, not where an outer name belongs.
  for (const std::uint32_t phase : trace().phase_path(context.phase))
    if (trace().phases()[phase].scoped) context.scope += trace().phases()[phase].label() + ".";
  return context;
}

template <Scalar S>
const ValueSpec::Case* Narrator<S>::case_at(const Context& context) const {
  const RuleInfo* rule = trace().value(context.value).rule;
  for (const ValueSpec::Case& special : context.spec->cases) {
    if (!special.rule.empty() && (rule == nullptr || special.rule != rule->name)) continue;
    if (!special.positive.empty() && index(special.positive, context).value_or(0) <= 0) continue;
    return &special;
  }
  return nullptr;
}

template <Scalar S>
std::string Narrator<S>::phase_title(std::uint32_t phase) const {
  const auto& record = trace().phases()[phase];
  const Algorithm& algorithm = algorithm_at(record.first_step);
  const PhaseSpec* spec = algorithm.phase(record.id);
  Context context{record.first_step, absent, "", nullptr, phase};
  return spec != nullptr ? fill_in(spec->title, context, nullptr) : record.label();
}

template <Scalar S>
std::string Narrator<S>::text_template(std::uint32_t step) const {
  const Algorithm& algorithm = algorithm_at(step);
  if (const std::uint32_t phase = trace().introduced_by(step); phase != absent) {
    const PhaseSpec* spec = algorithm.phase(trace().phases()[phase].id);
    return std::string(spec != nullptr ? spec->narration : "Next: {phase}.");
  }
  const Context context = context_at(step);
  if (context.value == absent) return std::string(algorithm.given_narration);
  if (context.spec == nullptr) return "{name} = {chain}";
  if (trace().is_input(context.value)) return "{name} = {value}: " + std::string(context.spec->meaning) + ".";
  const ValueSpec::Case* special = case_at(context);
  const std::string_view narration =
      special != nullptr && !special->narration.empty() ? special->narration : context.spec->narration;
  return std::string(narration.empty() ? "{name} = {chain}" : narration);
}

template <Scalar S>
std::string Narrator<S>::text(std::uint32_t step) const {
  return fill(text_template(step), step);
}

// Several numbers in parentheses. Where decimals are rounded, what rounding errors left of a zero is shown as 0.
template <Scalar S>
std::string Narrator<S>::list(NumbersView<S> numbers, bool decimals) const {
  decimals = decimals || std::ranges::any_of(numbers, [](const S& x) { return is_approximate(x); });
  double largest = 0;
  for (const S& x : numbers) largest = std::max(largest, std::abs(to_double(x)));
  std::string text = "(";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool noise = digits_ > 0 && std::abs(to_double(numbers[i])) < 1e-14 * largest;
    text += (i > 0 ? ", " : "") + (noise ? "0" : number(numbers[i], decimals));
  }
  return text + ")";
}

template <Scalar S>
bool Narrator<S>::approximate(ValueId v) const {
  return std::same_as<S, Exact> &&
         std::ranges::any_of(trace().numbers(v), [](const S& x) { return is_approximate(x); });
}

template <Scalar S>
std::string Narrator<S>::operand_text(ValueId v) const {
  return operand_text(v, approximate(v));
}

template <Scalar S>
std::string Narrator<S>::value_text(ValueId v) const {
  return value_text(v, approximate(v));
}

template <Scalar S>
std::string Narrator<S>::operand_text(ValueId v, bool decimals) const {
  const ValueKind kind = trace().value(v).kind;
  if (kind != ValueKind::vector && !(kind == ValueKind::point && trace().rational)) return value_text(v, decimals);
  const auto numbers = trace().numbers(v);
  std::vector<S> shown(numbers.begin(), numbers.begin() + trace().dimension);
  if (trace().rational) shown.push_back(numbers[3]);
  return list(shown, decimals);
}

template <Scalar S>
std::string Narrator<S>::value_text(ValueId v, bool decimals) const {
  const auto numbers = trace().numbers(v);
  switch (trace().value(v).kind) {
    case ValueKind::integer:
    case ValueKind::scalar:
      return number(numbers[0], decimals && trace().value(v).kind == ValueKind::scalar);
    case ValueKind::list:
      return list(numbers, decimals);
    case ValueKind::vector:
      return operand_text(v, decimals);
    case ValueKind::point:
      break;
  }
  std::vector<S> shown(numbers.begin(), numbers.begin() + trace().dimension);
  // The point on a rational curve, after the division, is an ordinary one.
  if (!trace().rational || trace().value(v).rule == &rule_info<Project>) return list(shown, decimals);
  const S& w = numbers[3];
  if (w == S(0)) {
    const bool nothing = std::ranges::all_of(shown, [](const S& x) { return x == S(0); });
    return nothing ? std::string("no point, w = 0") : "at infinity, direction " + list(shown, decimals);
  }
  for (S& x : shown) x = x / w;
  return list(shown, decimals) + ", w = " + number(w, decimals);
}

template <Scalar S>
std::string Narrator<S>::made_text(ValueId v) const {
  const bool computed = !trace().is_input(v) && trace().value(v).kind == ValueKind::point && trace().rational &&
                        trace().value(v).rule != &rule_info<Project>;
  return computed ? operand_text(v) + ": " + value_text(v) : value_text(v);
}

template <Scalar S>
std::string Narrator<S>::polar(ValueId v) const {
  if (labels_[v].empty()) return {};
  return to_string(labels_[v], [this](const S& x) { return number(x); });
}

namespace {

// A rule's formula with its operands' texts.
std::string fill_formula(std::string_view formula, const std::vector<std::string>& operands) {
  std::string text;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula[i] != '{') {
      text += formula[i];
      continue;
    }
    const std::size_t end = formula.find('}', i);
    const std::string_view inside = formula.substr(i + 1, end - i - 1);
    if (inside == "*") {
      for (std::size_t o = 0; o < operands.size(); ++o) text += (o > 0 ? ", " : "") + operands[o];
    } else {
      text += operands[static_cast<std::size_t>(inside[0] - '0')];
    }
    i = end;
  }
  return text;
}

}  // namespace

template <Scalar S>
std::string Narrator<S>::formula(ValueId v) const {
  if (trace().is_input(v)) return "given";
  std::vector<std::string> names;
  const std::string_view formula = trace().value(v).rule->formula;
  for (const ValueId o : trace().operands(v)) names.push_back(operand_name(v, o));
  if (trace().value(v).rule == &rule_info<Project>)
    return (trace().dimension == 3 ? "(wx, wy, wz) / w of " : "(wx, wy) / w of ") + names[0];
  // An index of N_(j,q) is a whole number that says nothing by its name.
  const std::size_t subscript = formula.find("_(");
  for (std::size_t i = 0; subscript != std::string_view::npos && i < names.size(); ++i)
    if (const std::size_t slot = formula.find("{" + std::to_string(i) + "}");
        slot != std::string_view::npos && slot > subscript && slot < formula.find(')', subscript))
      names[i] = value_text(trace().operands(v)[i]);
  return fill_formula(formula, names);
}

namespace {

// What two scopes begin with, up to a dot.
std::size_t common_scope(std::string_view a, std::string_view b) {
  std::size_t same = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()) && a[i] == b[i]; ++i)
    if (a[i] == '.') same = i + 1;
  return same;
}

}  // namespace

template <Scalar S>
std::string Narrator<S>::operand_name(ValueId v, ValueId operand) const {
  const Name& record = trace().value(operand).name;
  const std::string scope = trace().scope(operand);
  const std::size_t shared = common_scope(trace().scope(v), scope);
  if (record.symbol == Symbol::of("U") && record.arity == 1 && trace().value(operand).kind == ValueKind::scalar)
    return scope.substr(shared) + "u_" + std::to_string(record.index[0]);
  return trace().name(operand).substr(shared);
}

template <Scalar S>
std::string Narrator<S>::own_name(ValueId v) const {
  const std::string name = trace().name(v), scope = trace().scope(v);
  std::size_t shared = scope.size();
  // Its own phase at least, where there is one: the operand may be of a phase inside it.
  const std::size_t around = scope.size() < 2 ? std::string::npos : scope.rfind('.', scope.size() - 2);
  const std::size_t phase = around == std::string::npos ? 0 : around + 1;
  if (!trace().is_input(v))
    for (const ValueId o : trace().operands(v))
      if (trace().value(o).name == trace().value(v).name)
        shared = std::min({shared, phase, common_scope(scope, trace().scope(o))});
  return name.substr(shared);
}

template <Scalar S>
std::string Narrator<S>::numbers(ValueId v) const {
  if (trace().is_input(v)) return value_text(v);
  // One line writes its numbers, and the result behind them, in one manner.
  const bool decimals = approximate(v);
  if (trace().value(v).rule == &rule_info<Project> && trace().rational) {
    const auto A = trace().numbers(trace().operands(v)[0]);
    const std::string w = number(A[3], decimals);
    return list(A.first(static_cast<std::size_t>(trace().dimension)), decimals) + " / " +
           (w[0] == '-' || w.find('/') != std::string::npos ? "(" + w + ")" : w);
  }
  std::vector<std::string> values;
  const std::string_view formula = trace().value(v).rule->formula;
  const bool listed = formula.find("{*}") != std::string_view::npos;
  for (const ValueId o : trace().operands(v)) {
    // A number made from points (a distance) is measured between them in space, not between homogeneous coordinates.
    const bool measured = trace().value(v).kind == ValueKind::scalar && trace().value(o).kind == ValueKind::point;
    std::string text = measured ? value_text(o, decimals) : operand_text(o, decimals);
    if (measured) text.erase(text.rfind(')') + 1);  // without the weight
    // Inside a formula (not in a list between commas) a negative number needs its parentheses, and so does a fraction
    // that is itself divided.
    const std::string slot = "{" + std::to_string(values.size()) + "}";
    const bool divided =
        formula.find(slot + " /") != std::string_view::npos || formula.find("/ " + slot) != std::string_view::npos;
    if (!listed && trace().numbers(o).size() == 1 &&
        (text[0] == '-' || (divided && text.find('/') != std::string::npos)))
      text = "(" + text + ")";
    values.push_back(std::move(text));
  }
  return fill_formula(formula, values);
}

template <Scalar S>
std::string Narrator<S>::chain(ValueId v, bool with_names) const {
  const std::string value = value_text(v);
  std::string text = with_names && !trace().is_input(v) ? formula(v) : std::string();
  std::string filled = numbers(v);
  std::string tight = filled;  // "1 / 3" says no more than 1/3
  std::erase(tight, ' ');
  const bool copy = !trace().is_input(v) && trace().value(v).rule->formula == "{0}";
  if (!copy && filled != value && tight != value && filled != text) text += (text.empty() ? "" : " = ") + filled;
  if (value != text) text += (text.empty() ? "" : " = ") + (text.empty() || copy ? value : made_text(v));
  return text;
}

template <Scalar S>
std::optional<int> Narrator<S>::index(std::string_view expression, const Context& context) const {
  std::int64_t sum = 0;
  int sign = 1;
  for (std::size_t i = 0; i < expression.size();) {
    if (expression[i] == '+' || expression[i] == '-') {
      sign = expression[i] == '-' ? -1 : 1;
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < expression.size() && is_word(expression[end])) ++end;
    if (end == i) return std::nullopt;
    const std::string_view term = expression.substr(i, end - i);
    std::optional<std::int64_t> value;
    if (std::isdigit(static_cast<unsigned char>(term[0])) != 0) {
      if (term.size() > 6) return std::nullopt;
      value = std::stoi(std::string(term));
    } else if (context.spec != nullptr) {
      for (std::size_t n = 0; n < context.spec->indices.size(); ++n)
        if (context.spec->indices[n] == term) value = trace().value(context.value).name.index[n];
    }
    if (!value)
      if (const auto found = resolve(term, context); found && trace().value(found->value).kind == ValueKind::integer)
        value = static_cast<int>(to_double(trace().numbers(found->value)[0]));
    if (!value) return std::nullopt;
    sum += sign * *value;
    sign = 1;
    i = end;
  }
  return std::abs(sum) <= 1'000'000'000 ? std::optional(static_cast<int>(sum)) : std::nullopt;
}

// A reference like P[r-1][i]: its indices worked out, then looked up from the innermost scope outwards. Where a scope
// has no value U[3] but a list U, it is the list's element 3.
template <Scalar S>
auto Narrator<S>::resolve(std::string_view reference, const Context& context) const -> std::optional<Found> {
  std::string name;
  std::size_t list_name = 0;  // its length, where the reference has one index
  int element = 0;
  for (std::size_t i = 0; i < reference.size();) {
    if (reference[i] != '[') {
      name += reference[i++];
      continue;
    }
    const std::size_t end = reference.find(']', i);
    if (end == std::string_view::npos) return std::nullopt;
    const auto value = index(reference.substr(i + 1, end - i - 1), context);
    if (!value) return std::nullopt;
    list_name = list_name == 0 && end + 1 == reference.size() ? name.size() : 0;
    element = *value;
    name += "[" + std::to_string(*value) + "]";
    i = end + 1;
  }
  const auto made = [&](const std::string& full) {
    const auto v = trace().find(full);
    return v && trace().value(*v).step <= context.step ? v : std::nullopt;
  };
  for (std::string scope = context.scope;;) {
    if (const auto v = made(scope + name)) return Found{*v, -1};
    if (list_name != 0)
      if (const auto v = made(scope + name.substr(0, list_name));
          v && trace().value(*v).kind == ValueKind::list && element >= 0 &&
          element < static_cast<int>(trace().numbers(*v).size()))
        return Found{*v, element};
    if (scope.empty()) return std::nullopt;
    scope.pop_back();
    const auto dot = scope.rfind('.');
    scope.erase(dot == std::string::npos ? 0 : dot + 1);
  }
}

template <Scalar S>
std::optional<std::string> Narrator<S>::placeholder(std::string_view inside, const Context& context) const {
  const ValueId v = context.value;
  if (inside == "phase" && context.phase != absent) return phase_title(context.phase);
  if (inside == "index" && context.phase != absent) return std::to_string(trace().phases()[context.phase].index);
  if (v != absent) {
    if (inside == "value") return value_text(v);
    if (inside == "made") return made_text(v);
    if (inside == "name") return trace().name(v).substr(trace().scope(v).size());
    if (inside == "formula") return formula(v);
    if (inside == "numbers") return numbers(v);
    if (inside.size() == 2 && inside[0] == '@' && std::isdigit(static_cast<unsigned char>(inside[1])) != 0) {
      const auto from = trace().operands(v);
      const auto n = static_cast<std::size_t>(inside[1] - '0');
      return n < from.size() ? std::optional(value_text(from[n])) : std::nullopt;
    }
    if (inside == "chain") return chain(v, true);
    if (inside == "result") return chain(v, false);
    if (inside == "polar" && !labels_[v].empty()) return polar(v);
    if (context.spec != nullptr)
      for (std::size_t n = 0; n < context.spec->indices.size(); ++n)
        if (context.spec->indices[n] == inside) return std::to_string(trace().value(v).name.index[n]);
  }
  const char form = inside.empty() ? ' ' : inside[0];
  if (const auto found = resolve(form == '#' || form == '~' ? inside.substr(1) : inside, context)) {
    const auto [value, element] = *found;
    if (form != '#') {
      if (element >= 0) return format_number(trace().numbers(value)[static_cast<std::size_t>(element)]);
      return form == '~' ? operand_text(value) : value_text(value);
    }
    std::string name = trace().name(value);
    if (name.starts_with(context.scope)) name.erase(0, context.scope.size());
    return element >= 0 ? name + "[" + std::to_string(element) + "]" : name;
  }
  // "{k-p+1}" is a whole number of its own.
  if (const auto sum = index(inside, context); sum && !inside.empty()) return std::to_string(*sum);
  return std::nullopt;
}

template <Scalar S>
std::optional<std::string> Narrator<S>::math_placeholder(std::string_view command, std::string_view inside,
                                                         const Context& context) const {
  if (command == "value") {
    // What is no value (a formula, a phase's title) has no TeX.
    static constexpr std::array words{"phase", "name", "formula", "numbers", "chain", "result", "polar"};
    if (inside.starts_with('#') || std::ranges::find(words, inside) != words.end()) return std::nullopt;
    const auto text = placeholder(inside, context);
    return text ? std::optional(tex_value(*text)) : std::nullopt;
  }
  const bool main = inside == "name" && context.value != absent;
  const auto found = main ? std::optional(Found{context.value, -1}) : resolve(inside, context);
  if (!found) return std::nullopt;
  Name name = trace().value(found->value).name;
  if (found->element >= 0) name = {name.symbol, {found->element, 0}, 1};
  return tex_name(typeset_name(name, algorithm_at(context.step)));
}

template <Scalar S>
std::string Narrator<S>::fill_math(std::string_view tex, const Context& context,
                                   std::vector<std::string>* errors) const {
  std::string filled;
  for (std::size_t i = 0; i < tex.size();) {
    const std::string_view rest = tex.substr(i);
    const std::string_view command = rest.starts_with("\\value{") ? "value" : rest.starts_with("\\name{") ? "name" : "";
    const std::size_t end = command.empty() ? std::string_view::npos : tex.find('}', i);
    if (end == std::string_view::npos) {
      filled += tex[i++];
      continue;
    }
    const std::size_t begin = i + command.size() + 2;
    const std::string_view inside = tex.substr(begin, end - begin);
    // In braces where it is, or may be, what something takes: x^\value{r} has one exponent.
    if (const auto replaced = math_placeholder(command, inside, context)) {
      const char before = filled.empty() ? ' ' : filled.back();
      const bool bare = !is_word(before) && std::string_view("^_}]").find(before) == std::string_view::npos;
      filled += bare ? *replaced : "{" + *replaced + "}";
    } else {
      filled += tex.substr(i, end - i + 1);
      if (errors != nullptr) errors->emplace_back(inside);
    }
    i = end + 1;
  }
  return filled;
}

template <Scalar S>
std::string Narrator<S>::fill_in(std::string_view text, const Context& context,
                                 std::vector<std::string>* errors) const {
  std::string filled;
  std::size_t code = 0;  // up to here a dollar sign is only one
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() &&
        std::string_view("$`\\{}").find(text[i + 1]) != std::string_view::npos) {
      filled += text.substr(i++, 2);
      continue;
    }
    if (text[i] == '`' && i >= code) code = end_of_code(text, i).value_or(text.find_first_not_of('`', i));
    if (text[i] == '$' && i >= code)
      if (const auto end = end_of_math(text, i)) {
        filled += fill_math(text.substr(i, *end - i), context, errors);
        i = *end - 1;
        continue;
      }
    const std::size_t end = text[i] == '{' ? text.find('}', i) : std::string_view::npos;
    if (end == std::string_view::npos) {
      filled += text[i];
      continue;
    }
    const std::string_view inside = text.substr(i + 1, end - i - 1);
    if (const auto replaced = placeholder(inside, context)) {
      filled += *replaced;
    } else {
      filled += text.substr(i, end - i + 1);
      if (errors != nullptr) errors->emplace_back(inside);
    }
    i = end;
  }
  return filled;
}

template <Scalar S>
std::string Narrator<S>::fill(std::string_view text, std::uint32_t step, std::vector<std::string>* errors) const {
  return fill_in(text, context_at(step), errors);
}

template <Scalar S>
std::string Narrator<S>::tableau(std::uint32_t step) const {
  const Algorithm& algorithm = *run_->algorithm;
  // Rows are the last index, columns the first, as in the triangular scheme on a blackboard.
  std::map<int, std::map<int, std::string>> rows;
  std::map<int, std::size_t> widths;
  for (ValueId v = 0; v < trace().value_count() && trace().value(v).step <= step; ++v) {
    const Name& name = trace().value(v).name;
    const ValueSpec* spec = algorithm.spec(name);
    if (spec == nullptr || !spec->tableau || !trace().scope(v).empty()) continue;
    const int column = name.arity == 2 ? name.index[0] : 0;
    const std::string cell = trace().name(v) + " = " + value_text(v);
    rows[name.index[name.arity - 1]][column] = cell;
    widths[column] = std::max(widths[column], cell.size());
  }
  std::string text;
  for (const auto& [i, cells] : rows) {
    std::string line;
    std::size_t at = 0;
    for (const auto& [column, width] : widths) {
      if (const auto cell = cells.find(column); cell != cells.end()) {
        line.resize(at, ' ');
        line += cell->second;
      }
      at += width + 3;
    }
    text += line + "\n";
  }
  return text;
}

template class Narrator<double>;
template class Narrator<Exact>;

}  // namespace blossom
