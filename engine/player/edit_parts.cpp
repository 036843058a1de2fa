#include "player/edit_parts.hpp"

#include <algorithm>

#include "geometry/document.hpp"

namespace blossom::edits {
namespace {

// A document in which every input stands, the given one with its text and the others as a 0 nobody reads: cursors into
// it have the right paths.
Checked<JsonDocument> stand_in(const Algorithm& algorithm, std::string_view name = {}, const std::string& text = {}) {
  std::string all = "{";
  for (const InputSpec& spec : algorithm.inputs)
    all += (all.size() > 1 ? "," : "") + json_quote(spec.name) + ":" + (spec.name == name ? text : "0");
  return JsonDocument::parse("inputs", all + "}");
}

// Lines and columns are of a text that nobody has seen.
Diagnostics without_places(Diagnostics diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    diagnostic.file.clear();
    diagnostic.line = diagnostic.column = 0;
  }
  return diagnostics;
}

// Which input the algorithm cannot take as it is, if any; why goes to `diagnostics`.
std::optional<std::string> complaint(const Algorithm& algorithm, const Inputs<Exact>& inputs, const Cursor& root) {
  std::optional<std::string> about;
  if (algorithm.check == nullptr) return about;
  algorithm.check(inputs, [&](std::string_view name) {
    if (!about) about = name;
    return root.optional(name).value_or(root);
  });
  return about;
}

std::vector<Exact> places_for(const Exact& u, const Curve<Exact>& curve) {
  const std::vector<Exact>& U = curve.knots;
  std::vector<Exact> places;
  for (const Exact& knot : U)
    if (knot.to_double() == u.to_double()) places.push_back(knot);
  places.push_back(std::clamp(u, curve.domain_begin(), curve.domain_end()));
  std::vector<std::pair<Exact, Exact>> middles;  // of the spans, with their distance
  for (std::size_t i = static_cast<std::size_t>(curve.degree); i < curve.points.size(); ++i) {
    if (U[i] == U[i + 1]) continue;
    const Exact middle = (U[i] + U[i + 1]) / Exact(2);
    middles.emplace_back(abs(middle - u), middle);
  }
  std::stable_sort(middles.begin(), middles.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [distance, middle] : middles) places.push_back(std::move(middle));
  return places;
}

// Another value for the input `name` that the algorithm does not complain about; false if there is none.
bool refit(const Algorithm& algorithm, Inputs<Exact>& inputs, const std::string& name, const Cursor& root) {
  const InputSpec* spec = algorithm.input(name);
  const auto found = inputs.values.find(name);
  if (spec == nullptr || found == inputs.values.end()) return false;
  InputValue<Exact>& value = found->second;
  const InputValue<Exact> before = value;
  const auto fits = [&] { return complaint(algorithm, inputs, root) != name; };
  if (spec->type == InputSpec::Type::number) {
    const auto curves = curves_of(inputs);
    if (curves.empty()) return false;
    for (const Exact& place : places_for(std::get<Exact>(before), curve_at(inputs, curves.front()))) {
      value = place;
      if (fits()) return true;
    }
  } else if (spec->type == InputSpec::Type::integer) {
    for (int i = std::get<int>(before) - 1; i >= spec->at_least; --i) {
      value = i;
      if (fits()) return true;
    }
  }
  value = before;
  return false;
}

// Reads the changed input back from its text into the inputs.
Diagnostics reread(const Algorithm& algorithm, Inputs<Exact>& edited, std::string_view changed) {
  const InputSpec* spec = algorithm.input(changed);
  const auto value = edited.values.find(changed);
  if (spec == nullptr || value == edited.values.end())
    return {wrong(std::string(changed), "is no input of " + std::string(algorithm.id))};
  const auto document = stand_in(algorithm, changed, write_input<Exact>(value->second));
  if (!document) return without_places(document.diagnostics);
  Diagnostics diagnostics;
  auto read = read_input(*spec, *Cursor(*document, diagnostics).optional(changed));
  if (!read) return without_places(std::move(diagnostics));
  value->second = std::move(*read);
  return {};
}

}  // namespace

Edited refused(std::string path, std::string message) {
  return Diagnostics{wrong(std::move(path), std::move(message))};
}

Edited fitting(const Algorithm& algorithm, Inputs<Exact> edited) {
  Diagnostics diagnostics;
  const auto document = stand_in(algorithm);
  if (!complaint(algorithm, edited, Cursor(*document, diagnostics))) return edited;
  return without_places(std::move(diagnostics));
}

void fit_others(const Algorithm& algorithm, Inputs<Exact>& inputs, std::string_view to) {
  Diagnostics unused;
  const auto document = stand_in(algorithm);
  const Cursor root(*document, unused);
  for (std::size_t tries = 0; tries < 2 * algorithm.inputs.size(); ++tries) {
    const auto about = complaint(algorithm, inputs, root);
    if (!about || *about == to || !refit(algorithm, inputs, *about, root)) return;
  }
}

Edited checked(const Algorithm& algorithm, Inputs<Exact> edited, std::string_view changed) {
  if (auto wrong = reread(algorithm, edited, changed); !wrong.empty()) return wrong;
  return fitting(algorithm, std::move(edited));
}

Edited checked_and_fitted(const Algorithm& algorithm, Inputs<Exact> edited, std::string_view changed) {
  if (auto wrong = reread(algorithm, edited, changed); !wrong.empty()) return wrong;
  fit_others(algorithm, edited, changed);
  return fitting(algorithm, std::move(edited));
}

std::string path_of(const Inputs<Exact>& inputs, const CurveAddress& address) {
  const auto found = inputs.values.find(address.input);
  const bool several = found != inputs.values.end() && std::holds_alternative<std::vector<Curve<Exact>>>(found->second);
  return address.input + (several ? "[" + std::to_string(address.curve) + "]" : "");
}

Curve<Exact>* find_curve(Inputs<Exact>& inputs, const CurveAddress& address) {
  const auto found = inputs.values.find(address.input);
  if (found == inputs.values.end()) return nullptr;
  if (auto* one = std::get_if<Curve<Exact>>(&found->second)) return address.curve == 0 ? one : nullptr;
  auto* several = std::get_if<std::vector<Curve<Exact>>>(&found->second);
  return several != nullptr && address.curve < several->size() ? &(*several)[address.curve] : nullptr;
}

}  // namespace blossom::edits
