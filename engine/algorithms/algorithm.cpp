#include "algorithms/algorithm.hpp"

namespace blossom {

template <Scalar S>
Inputs<S> convert(const Inputs<Exact>& inputs) {
  Inputs<S> converted;
  for (const auto& [name, value] : inputs.values) {
    converted.values.emplace(name,
                             std::visit(
                                 [](const auto& x) -> InputValue<S> {
                                   using T = std::decay_t<decltype(x)>;
                                   if constexpr (std::is_same_v<T, Exact>) {
                                     return from_exact<S>(x);
                                   } else if constexpr (std::is_same_v<T, std::vector<Curve<Exact>>>) {
                                     std::vector<Curve<S>> curves;
                                     for (const auto& c : x) curves.push_back(blossom::convert<S>(c));
                                     return curves;
                                   } else if constexpr (std::is_same_v<T, std::vector<Exact>>) {
                                     std::vector<S> numbers;
                                     for (const auto& number : x) numbers.push_back(from_exact<S>(number));
                                     return numbers;
                                   } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::string>) {
                                     return x;
                                   } else {
                                     return blossom::convert<S>(x);
                                   }
                                 },
                                 value));
  }
  return converted;
}

template Inputs<double> convert(const Inputs<Exact>&);
template Inputs<Exact> convert(const Inputs<Exact>&);

std::optional<ValueId> Site::sibling(Name name) const {
  std::string text = trace().scope(value()) + name.symbol.text();
  for (int i = 0; i < name.arity; ++i) text += "[" + std::to_string(name.index[i]) + "]";
  return trace().find(text);
}

std::optional<NumbersView<Exact>> Site::sibling_numbers(Name name) const {
  const auto v = sibling(name);
  return v ? std::optional(numbers(*v)) : std::nullopt;
}

const ValueSpec* Algorithm::spec(const Name& name) const {
  for (const auto& s : values)
    if (Symbol::of(s.symbol) == name.symbol && s.indices.size() == name.arity) return &s;
  return nullptr;
}

const PhaseSpec* Algorithm::phase(std::string_view phase_id) const {
  for (const auto& p : phases)
    if (p.id == phase_id) return &p;
  return nullptr;
}

const InputSpec* Algorithm::input(std::string_view name) const {
  for (const auto& i : inputs)
    if (i.name == name) return &i;
  return nullptr;
}

const Algorithm* find_algorithm(std::string_view id) {
  for (const Algorithm* a : algorithms())
    if (a->id == id) return a;
  return nullptr;
}

std::vector<std::string> algorithm_ids() {
  std::vector<std::string> ids;
  for (const Algorithm* a : algorithms()) ids.emplace_back(a->id);
  return ids;
}

const RuleInfo* find_rule(std::string_view name) {
  for (const Algorithm* a : algorithms())
    for (const RuleInfo* rule : a->rules)
      if (rule->name == name) return rule;
  return nullptr;
}

}  // namespace blossom
