#include "lesson/slider_check.hpp"

#include <charconv>

#include "base/json_write.hpp"

namespace blossom {
namespace {

// What is wrong with these inputs; empty: nothing.
std::string problem_with(const Algorithm& algorithm, const Json& inputs) {
  const auto document = JsonDocument::parse("inputs", write_json(inputs));
  if (!document) return document.diagnostics.front().message;
  Diagnostics diagnostics;
  const Cursor root(*document, diagnostics);
  if (const auto read = read_inputs(algorithm, root)) {
    const auto run = record<Exact>(algorithm, *read);
    if (run) return {};
    diagnostics = run.diagnostics;
  }
  const Diagnostic& first = diagnostics.front();
  return (first.path.empty() ? "" : first.path + ": ") + first.message;
}

// A slider that stands outside of its range at the beginning would jump at the first touch.
void check_own(const Cursor& slider, Json inputs) {
  const std::string& path = slider.optional("input")->json().text;
  const Json* number = find_number(inputs, path);
  const auto own = number != nullptr ? Exact::parse(number->text) : std::nullopt;
  for (const char* end : {"from", "to"}) {
    const Cursor at = *slider.optional(end);
    const auto bound = Exact::parse(at.json().text);
    if (own && bound && (end == std::string_view("from") ? *own < *bound : *bound < *own))
      at.error("leaves out the lesson's own number, " + path + " = " + format_number(*own));
  }
}

void check_scene(const Cursor& at) {
  const Algorithm* algorithm = find_algorithm(at.optional("algorithm")->json().text);
  const Json& inputs = at.optional("inputs")->json();
  const auto beats = at.optional("beats");
  for (std::size_t i = 0; i < beats->size(); ++i) {
    const auto sliders = (*beats)[i].optional("sliders");
    for (std::size_t s = 0; sliders && s < sliders->size(); ++s) {
      check_own((*sliders)[s], inputs);
      for (const char* end : {"from", "to"}) {
        const std::string& path = (*sliders)[s].optional("input")->json().text;
        const Cursor there = *(*sliders)[s].optional(end);
        Json moved = inputs;
        Json* number = find_number(moved, path);
        if (number == nullptr) continue;
        number->kind = there.json().kind;
        number->text = there.json().text;
        if (const std::string problem = problem_with(*algorithm, moved); !problem.empty())
          there.error("with " + path + " = " + there.json().text + " the inputs are not valid: " + problem);
      }
    }
  }
}

}  // namespace

Json* find_number(Json& inputs, std::string_view path) {
  Json* here = &inputs;
  while (!path.empty()) {
    if (path.front() == '[') {
      const std::size_t end = path.find(']');
      std::size_t index = 0;
      const char* const last = path.data() + std::min(end, path.size());
      const auto [stopped, error] = std::from_chars(path.data() + 1, last, index);
      if (end == std::string_view::npos || error != std::errc() || stopped != last || here->kind != Json::Kind::array ||
          index >= here->items.size())
        return nullptr;
      here = &here->items[index];
      path.remove_prefix(end + 1);
      continue;
    }
    if (path.front() == '.') path.remove_prefix(1);
    const std::string_view key = path.substr(0, path.find_first_of(".["));
    const Json* next = key.empty() ? nullptr : here->find(key);
    if (next == nullptr) return nullptr;
    here = &here->items[static_cast<std::size_t>(next - here->items.data())];
    path.remove_prefix(key.size());
  }
  return here->kind == Json::Kind::number || here->kind == Json::Kind::string ? here : nullptr;
}

Diagnostics check_sliders(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  const auto scenes = root.optional("scenes");
  if (!scenes) check_scene(root);
  for (std::size_t i = 0; scenes && i < scenes->size(); ++i) check_scene((*scenes)[i]);
  return diagnostics;
}

}  // namespace blossom
