#include <cstdio>
#include <limits>
#include <numbers>

#include "algorithms/run.hpp"
#include "base/json_write.hpp"
#include "studio/scene_file.hpp"
#include "studio/scene_parts.hpp"

namespace blossom {
namespace {

// Exact strings become numbers where that is the same.
void to_numbers(Json& json) {
  if (json.kind == Json::Kind::string)
    if (const auto x = Exact::parse(json.text)) json = json_number(*x);
  for (Json& item : json.items) to_numbers(item);
}

Json boolean(bool value) {
  Json json;
  json.kind = Json::Kind::boolean;
  json.boolean = value;
  return json;
}

using Members = std::vector<std::pair<std::string, Json>>;

Json numbers(const Point<Exact>& P) { return json_array({json_number(P.x), json_number(P.y), json_number(P.z)}); }

Json json_of(const Reference& reference) {
  const Placement usual;
  const auto& [scale, turn, move] = reference.place;
  Members members{{"object", json_string(reference.object)}};
  if (scale != usual.scale)
    members.emplace_back("scale", scale.x == scale.y && scale.y == scale.z ? json_number(scale.x) : numbers(scale));
  if (turn != usual.turn) members.emplace_back("turn", numbers(turn));
  if (move != usual.move) members.emplace_back("move", numbers(move));
  return json_object(std::move(members));
}

Json json_of(const InputSpec* spec, const Ingredient& ingredient) {
  if (const auto* own = std::get_if<InputValue<Exact>>(&ingredient)) return blossom::json_of(*own);
  const auto& references = std::get<std::vector<Reference>>(ingredient);
  const bool list = spec != nullptr && spec->type == InputSpec::Type::curves;
  if (!list && references.size() == 1) return json_of(references[0]);
  std::vector<Json> items;
  for (const Reference& reference : references) items.push_back(json_of(reference));
  return json_array(std::move(items));
}

Json json_of(const Recipe& recipe) {
  Members inputs;
  for (const InputSpec& spec : recipe.algorithm->inputs)  // in the order in which people think of them
    if (const auto found = recipe.inputs.find(spec.name); found != recipe.inputs.end())
      inputs.emplace_back(spec.name, json_of(&spec, found->second));
  Members members{{"algorithm", json_string(recipe.algorithm->id)}, {"inputs", json_object(std::move(inputs))}};
  if (recipe.which > 0) members.emplace_back("result", json_number(std::to_string(recipe.which)));
  return json_object(std::move(members));
}

Json json_of(const Geometry& geometry) {
  return std::visit([](const auto& each) { return blossom::json_of(InputValue<Exact>(each)); }, geometry);
}

// The shortest text of an angle in degrees that reads back as the same radians.
Json degrees(double radians) {
  const long double exact = static_cast<long double>(radians) * 180 / std::numbers::pi_v<long double>;
  std::array<char, 64> text{};
  for (int digits = 4; digits <= std::numeric_limits<long double>::max_digits10; ++digits) {  // with fewer: 3e+01
    std::snprintf(text.data(), text.size(), "%.*Lg", digits, exact);
    if (const auto read = Exact::parse(text.data()); read && radians_of(*read) == radians) break;
  }
  return json_number(std::string(text.data()));
}

Json json_of(const Look& look) {
  return json_object({{"from", json_string(look_from_name(look.from))},
                      {"azimuth", degrees(look.azimuth)},
                      {"elevation", degrees(look.elevation)},
                      {"perspective", boolean(look.perspective)}});
}

Json json_of(const SceneObject& object) {
  Members members{{"name", json_string(object.name)}};
  if (object.recipe) members.emplace_back("made", json_of(*object.recipe));
  if (!object.recipe || !object.problem.empty())
    members.emplace_back(geometry_key(object.geometry), json_of(object.geometry));
  if (object.color != 0) members.emplace_back("color", json_number(std::to_string(object.color)));
  if (object.hidden) members.emplace_back("hidden", boolean(true));
  if (object.shows != usual_shows(object.geometry)) {
    std::vector<Json> shows;
    for (const ShowName& each : show_names())
      if (object.shows[each.show]) shows.push_back(json_string(each.id));
    members.emplace_back("shows", json_array(std::move(shows)));
  }
  if (object.map != SurfaceMap::none) members.emplace_back("map", json_string(surface_map_id(object.map)));
  SceneObject usual;
  usual.geometry = object.geometry;
  look_at_middle(usual);
  if (object.u != usual.u) members.emplace_back("u", json_number(object.u));
  if (object.v != usual.v) members.emplace_back("v", json_number(object.v));
  return json_object(std::move(members));
}

}  // namespace

Json json_of(const InputValue<Exact>& value) {
  constexpr JsonLimits own_text{std::numeric_limits<std::uint32_t>::max(), 32, std::numeric_limits<std::size_t>::max()};
  const auto document = JsonDocument::parse("value", write_input<Exact>(value), own_text);
  Json json = document->root();
  to_numbers(json);
  return json;
}

std::string write_scene(const Workspace& workspace) {
  Members members{{"schema", json_string(scene_schema)}};
  if (!workspace.id.empty()) members.emplace_back("id", json_string(workspace.id));
  if (!workspace.title.empty()) members.emplace_back("title", json_string(workspace.title));
  if (!workspace.summary.empty()) members.emplace_back("summary", json_string(workspace.summary));
  if (workspace.look) members.emplace_back("look", json_of(*workspace.look));
  std::vector<Json> objects;
  for (const SceneObject& object : workspace.objects) objects.push_back(json_of(object));
  members.emplace_back("objects", json_array(std::move(objects)));
  return write_json(json_object(std::move(members))) + "\n";
}

}  // namespace blossom
