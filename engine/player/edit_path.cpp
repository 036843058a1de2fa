// Numbers of the inputs by their paths.
#include <algorithm>
#include <charconv>
#include <cstdint>

#include "base/json_write.hpp"
#include "player/edit_parts.hpp"

namespace blossom {
namespace {

// One step down a path: its first key or index, and what follows. Nothing where there is no such place.
Json* step_down(Json& here, std::string_view& path) {
  if (path.starts_with('[')) {
    const std::size_t end = path.find(']');
    if (end == std::string_view::npos) return nullptr;
    std::size_t index = 0;
    const auto [stopped, error] = std::from_chars(path.data() + 1, path.data() + end, index);
    const bool there = error == std::errc() && stopped == path.data() + end && here.kind == Json::Kind::array &&
                       index < here.items.size();
    path.remove_prefix(end + 1);
    return there ? &here.items[index] : nullptr;
  }
  if (path.starts_with('.')) path.remove_prefix(1);
  const std::string_view key = path.substr(0, path.find_first_of(".["));
  path.remove_prefix(key.size());
  if (here.kind != Json::Kind::object) return nullptr;
  const auto found = std::ranges::find(here.keys, key);
  return found == here.keys.end() ? nullptr : &here.items[static_cast<std::size_t>(found - here.keys.begin())];
}

// The place in the text of one input that the rest of a path leads to, if that is a number.
Json* place_in(Json& input, std::string_view rest) {
  Json* here = &input;
  while (here != nullptr && !rest.empty()) here = step_down(*here, rest);
  const bool number = here != nullptr && (here->kind == Json::Kind::number || here->kind == Json::Kind::string);
  return number ? here : nullptr;
}

struct Opened {
  std::string name;  // of the input
  Json json;
  std::string_view rest;
};

std::optional<Opened> open(const Inputs<Exact>& inputs, std::string_view path) {
  const std::size_t end = std::min(path.find_first_of(".["), path.size());
  const auto found = inputs.values.find(path.substr(0, end));
  if (found == inputs.values.end()) return std::nullopt;
  constexpr JsonLimits own_text{UINT32_MAX, 32, SIZE_MAX};
  const auto document = JsonDocument::parse("", write_input<Exact>(found->second), own_text);
  if (!document) return std::nullopt;
  return Opened{found->first, document->root(), path.substr(end)};
}

}  // namespace

std::optional<Exact> number_at(const Inputs<Exact>& inputs, std::string_view path) {
  auto opened = open(inputs, path);
  const Json* place = opened ? place_in(opened->json, opened->rest) : nullptr;
  return place != nullptr ? Exact::parse(place->text) : std::nullopt;
}

Edited set_number_at(const Algorithm& algorithm, const Inputs<Exact>& inputs, std::string_view path, const Exact& x) {
  return edits::with_number_at(algorithm, inputs, path, x, true);
}

Edited edits::with_number_at(const Algorithm& algorithm, const Inputs<Exact>& inputs, std::string_view path,
                             const Exact& x, bool fit_others) {
  auto opened = open(inputs, path);
  Json* place = opened ? place_in(opened->json, opened->rest) : nullptr;
  const InputSpec* spec = opened ? algorithm.input(opened->name) : nullptr;
  if (place == nullptr || spec == nullptr || !Exact::parse(place->text))
    return edits::refused(std::string(path), "is no number of these inputs");
  *place = json_number(x);
  const auto document = JsonDocument::parse("", write_json(opened->json));
  if (!document) return document.diagnostics;
  Diagnostics wrong;
  auto value = read_input(*spec, Cursor(*document, wrong));
  if (!value) {
    for (Diagnostic& each : wrong) {
      each.file.clear();
      each.line = each.column = 0;
      each.path = opened->name + (each.path.empty() || each.path.starts_with('[') ? "" : ".") + each.path;
    }
    return wrong;
  }
  Inputs<Exact> edited = inputs;
  edited.values.find(opened->name)->second = std::move(*value);
  return fit_others ? checked_and_fitted(algorithm, std::move(edited), opened->name)
                    : checked(algorithm, std::move(edited), opened->name);
}

}  // namespace blossom
