#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/document.hpp"
#include "lesson/document.hpp"
#include "studio/remake.hpp"
#include "studio/scene_file.hpp"
#include "studio/scene_parts.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_in_a_row = 65'536;
constexpr std::size_t most_given_to_recipes = 4 * most_scene_points;
const std::vector<std::string> geometry_keys{"curve", "surface", "points", "net"};

// One of some words; nothing, with "did you mean", if it is none.
std::optional<std::size_t> read_word(const Cursor& at, const std::vector<std::string>& words) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  const auto found = std::ranges::find(words, *text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string message = "must be one of";
  for (std::size_t i = 0; i < words.size(); ++i) message += (i > 0 ? ", " : " ") + json_quote(words[i]);
  if (const auto near = did_you_mean(*text, words)) message += "; did you mean " + json_quote(*near) + "?";
  at.error(message);
  return std::nullopt;
}

std::optional<double> read_angle(const Cursor& at) {
  constexpr double most = 36'000;
  const auto degrees = at.number();
  if (!degrees) return std::nullopt;
  if (std::abs(degrees->to_double()) <= most) return radians_of(*degrees);
  at.error("must be degrees from -36000 to 36000, not " + format_brief(*degrees));
  return std::nullopt;
}

Look read_look(const Cursor& at) {
  Look look;
  if (!at.expect_object({"from", "azimuth", "elevation", "perspective"})) return look;
  std::vector<std::string> names;
  for (const Look::From from : {Look::From::space, Look::From::xy, Look::From::xz, Look::From::yz})
    names.emplace_back(look_from_name(from));
  if (const auto from = at.optional("from")) look.from = static_cast<Look::From>(read_word(*from, names).value_or(0));
  if (const auto azimuth = at.optional("azimuth")) look.azimuth = read_angle(*azimuth).value_or(0);
  if (const auto elevation = at.optional("elevation")) look.elevation = read_angle(*elevation).value_or(0);
  if (const auto perspective = at.optional("perspective")) look.perspective = perspective->boolean().value_or(true);
  return look;
}

std::optional<Geometry> read_geometry(const Cursor& at, std::size_t kind) {
  const auto wrapped = [](auto value) { return value ? std::optional<Geometry>(std::move(*value)) : std::nullopt; };
  switch (kind) {
    case 0:
      return wrapped(read_curve(at));
    case 1:
      return wrapped(read_surface(at));
    case 2:
      return wrapped(read_points(at, 1, most_in_a_row));
    default:
      return wrapped(read_net(at));
  }
}

Shows read_shows(const Cursor& at) {
  Shows shows;
  std::vector<std::string> ids;
  for (const ShowName& each : show_names()) ids.emplace_back(each.id);
  if (!at.expect_array(0, ids.size())) return shows;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (const auto which = read_word(at[i], ids)) shows.set(show_names()[*which].show, true);
  return shows;
}

SurfaceMap read_map(const Cursor& at) {
  std::vector<std::string> ids;
  for (int i = 0; i < surface_map_count; ++i) ids.emplace_back(surface_map_id(static_cast<SurfaceMap>(i)));
  return static_cast<SurfaceMap>(read_word(at, ids).value_or(0));
}

std::optional<Point<Exact>> read_three(const Cursor& at) {
  if (!at.expect_array(3, 3)) return std::nullopt;
  const auto x = at[0].number(), y = at[1].number(), z = at[2].number();
  if (!x || !y || !z) return std::nullopt;
  return Point<Exact>(*x, *y, *z);
}

Placement read_placement(const Cursor& at) {
  Placement place;
  if (const auto scale = at.optional("scale")) {
    const std::size_t before = at.error_count();
    if (scale->is(Json::Kind::array)) {
      place.scale = read_three(*scale).value_or(place.scale);
    } else if (const auto all = scale->number()) {
      place.scale = {*all, *all, *all};
    }
    if (!at.errors_since(before) &&
        (place.scale.x == Exact(0) || place.scale.y == Exact(0) || place.scale.z == Exact(0)))
      scale->error("must not be 0, which would leave nothing of it");
  }
  if (const auto turn = at.optional("turn")) place.turn = read_three(*turn).value_or(place.turn);
  if (const auto move = at.optional("move")) place.move = read_three(*move).value_or(place.move);
  return place;
}

bool is_reference(const Cursor& at) { return at.is(Json::Kind::object) && at.json().find("object") != nullptr; }

// Reads objects one after the other, each knowing those before it.
class SceneReader {
 public:
  explicit SceneReader(const Cursor& objects) : objects_(objects) {
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (const Json* name = objects[i].json().find("name"); name != nullptr && name->kind == Json::Kind::string)
        all_names_.insert(name->text);
  }

  void read(Workspace& workspace) {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const Cursor at = objects_[i];
      const std::size_t before = at.error_count();
      SceneObject object;
      sources_known_ = true;
      const bool complete = read_object(at, workspace, object);
      if (at.errors_since(before) || !complete) {
        if (!object.name.empty()) broken_.insert(object.name);
        continue;
      }
      points_ += point_count(object.geometry);
      if (points_ > most_scene_points) {
        at.error("a scene has at most " + std::to_string(most_scene_points) + " control points in all");
        return;
      }
      workspace.objects.push_back(std::move(object));
    }
  }

 private:
  // False if it is not there, be it for a mistake of another one.
  bool read_object(const Cursor& at, const Workspace& workspace, SceneObject& object) {
    if (!at.expect_object(
            {"name", "curve", "surface", "points", "net", "made", "color", "hidden", "shows", "u", "v", "map"}))
      return false;
    if (const auto name = at.required("name")) object.name = read_name(*name, workspace);
    const auto given = read_given(at);
    const auto made = at.optional("made");
    if (given) object.geometry = *given;
    const bool complete = made ? read_made(*made, workspace, object, given.has_value()) : given.has_value();
    read_looks(at, object);
    if (complete) read_places(at, object);
    return complete;
  }

  std::string read_name(const Cursor& at, const Workspace& workspace) {
    const auto name = at.string();
    if (!name) return "";
    if (const auto problem = problem_of_name(*name)) {
      at.error(*problem);
      return "";
    }
    if (workspace.find(*name) != nullptr || broken_.count(*name) != 0)
      at.error(excerpt(*name) + " is the name of an object before this one already");
    return *name;
  }

  std::optional<Geometry> read_given(const Cursor& at) {
    std::optional<Geometry> geometry;
    std::size_t count = 0;
    for (std::size_t kind = 0; kind < geometry_keys.size(); ++kind) {
      const auto member = at.optional(geometry_keys[kind]);
      if (!member) continue;
      if (++count == 2) member->error("an object is only one of \"curve\", \"surface\", \"points\" and \"net\"");
      geometry = read_geometry(*member, kind);
    }
    if (count == 0 && at.json().find("made") == nullptr)
      at.error("must have one of \"curve\", \"surface\", \"points\", \"net\" and \"made\"");
    return geometry;
  }

  void read_looks(const Cursor& at, SceneObject& object) {
    if (const auto color = at.optional("color")) object.color = color->integer(0, object_colors - 1).value_or(0);
    if (const auto hidden = at.optional("hidden")) object.hidden = hidden->boolean().value_or(false);
    if (const auto shows = at.optional("shows")) object.shows = read_shows(*shows);
    if (const auto map = at.optional("map")) object.map = read_map(*map);
  }

  // What depends on what it is.
  void read_places(const Cursor& at, SceneObject& object) {
    if (at.json().find("shows") == nullptr) object.shows = usual_shows(object.geometry);
    if (object.map != SurfaceMap::none && !std::holds_alternative<Surface<Exact>>(object.geometry))
      at.optional("map")->error("is only for surfaces");
    look_at_middle(object);
    read_parameter(at, "u", 0, object.geometry, object.u);
    read_parameter(at, "v", 1, object.geometry, object.v);
  }

  static void read_parameter(const Cursor& object, std::string_view key, int direction, const Geometry& geometry,
                             Exact& parameter) {
    const auto at = object.optional(key);
    const auto number = at ? at->number() : std::nullopt;
    if (!number) return;
    const auto domain = domain_of(geometry, direction);
    if (!domain)
      at->error("there is no " + std::string(key) + " on " + (geometry.index() == 0 ? "a curve" : "points"));
    else if (*number < domain->first || domain->second < *number)
      at->error("must lie in the domain [" + format_brief(domain->first) + ", " + format_brief(domain->second) +
                "], not at " + format_brief(*number));
    else
      parameter = *number;
  }

  // ---- made things --------------------------------------------------------------------------------------------------

  bool read_made(const Cursor& at, const Workspace& workspace, SceneObject& object, bool has_last) {
    if (!at.expect_object({"algorithm", "inputs", "result"})) return false;
    const std::size_t before = at.error_count();
    Recipe recipe;
    recipe.algorithm = read_algorithm(at);
    if (const auto result = at.optional("result"))
      recipe.which = static_cast<std::size_t>(result->integer(0, static_cast<int>(most_in_a_row)).value_or(0));
    const auto inputs = at.required("inputs");
    if (inputs && recipe.algorithm != nullptr) read_inputs(*inputs, workspace, recipe);
    if (!inputs || at.errors_since(before) || !sources_known_) return false;
    object.recipe = recipe;
    return make(at, *inputs, workspace, object, has_last);
  }

  void read_inputs(const Cursor& at, const Workspace& workspace, Recipe& recipe) {
    std::vector<std::string> known;
    for (const InputSpec& spec : recipe.algorithm->inputs) known.emplace_back(spec.name);
    if (!at.expect_object(known)) return;
    for (const InputSpec& spec : recipe.algorithm->inputs)
      if (const auto member = at.optional(spec.name))
        if (auto ingredient = read_ingredient(*member, spec, workspace))
          recipe.inputs.emplace(std::string(spec.name), std::move(*ingredient));
  }

  std::optional<Ingredient> read_ingredient(const Cursor& at, const InputSpec& spec, const Workspace& workspace) {
    if (is_reference(at) && spec.type != InputSpec::Type::curves)
      return std::vector<Reference>{read_reference(at, workspace)};
    bool some = false;
    for (std::size_t i = 0; at.is(Json::Kind::array) && i < at.size(); ++i) some = some || is_reference(at[i]);
    if (some && spec.type == InputSpec::Type::curves) {
      std::vector<Reference> references;
      for (std::size_t i = 0; i < at.size(); ++i) references.push_back(read_reference(at[i], workspace));
      return references;
    }
    if (auto value = read_input(spec, at)) return std::move(*value);
    return std::nullopt;
  }

  Reference read_reference(const Cursor& at, const Workspace& workspace) {
    Reference reference;
    if (!at.expect_object({"object", "scale", "turn", "move"})) return reference;
    reference.place = read_placement(at);
    const auto object = at.required("object");
    const auto name = object ? object->string() : std::nullopt;
    if (!name) return reference;
    reference.object = *name;
    if (workspace.find(*name) != nullptr) return reference;
    if (broken_.count(*name) != 0) {  // its own mistakes are said where they are
      sources_known_ = false;
    } else if (all_names_.count(*name) != 0) {
      object->error(excerpt(*name) + " comes later: an object can only be made from those before it");
    } else {
      std::vector<std::string> before;
      for (const SceneObject& each : workspace.objects) before.push_back(each.name);
      std::string message = "there is no object " + excerpt(*name) + " before this one";
      if (const auto near = did_you_mean(*name, before)) message += "; did you mean " + excerpt(*near) + "?";
      object->error(message);
    }
    return reference;
  }

  bool make(const Cursor& at, const Cursor& inputs_at, const Workspace& workspace, SceneObject& object, bool has_last) {
    Recipe whole = *object.recipe;
    whole.which = 0;
    if (!last_ || !(*last_ == whole)) {  // pieces of one result stand one behind the other
      const auto inputs = inputs_of(workspace, whole, workspace.objects.size());
      given_ += inputs ? point_count(*inputs) : 0;
      if (given_ > most_given_to_recipes) {
        at.error("all things that are made are made from at most " + std::to_string(most_given_to_recipes) +
                 " points together");
        return false;
      }
      pieces_ = inputs ? made_by(*whole.algorithm, *inputs) : Checked<std::vector<Geometry>>(inputs.diagnostics);
      last_ = std::move(whole);
    }
    Diagnostics wrong = pieces_.diagnostics;
    const std::size_t which = object.recipe->which;
    if (pieces_ && which >= pieces_->size())
      wrong.push_back(
          {"", 0, 0, "",
           "there are " + std::to_string(pieces_->size()) + " pieces, none of number " + std::to_string(which)});
    if (wrong.empty()) {
      object.geometry = (*pieces_)[which];
    } else if (has_last) {
      object.problem = problem_of(wrong);
    } else {
      report_at(inputs_at, wrong);
    }
    return wrong.empty() || has_last;
  }

  const Cursor& objects_;
  std::set<std::string> all_names_, broken_;
  bool sources_known_ = true;  // no reference of the object being read is to one that has mistakes itself
  std::size_t points_ = 0, given_ = 0;
  std::optional<Recipe> last_;
  Checked<std::vector<Geometry>> pieces_;
};

}  // namespace

Checked<Workspace> read_scene(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  if (!root.expect_object({"$schema", "schema", "id", "title", "summary", "look", "objects"})) return diagnostics;
  Workspace workspace;
  expect_schema(root, scene_schema);
  if (const auto id = root.optional("id")) workspace.id = read_id(*id).value_or("");
  if (const auto title = root.optional("title")) workspace.title = read_text(*title).value_or("");
  if (const auto summary = root.optional("summary")) workspace.summary = read_text(*summary).value_or("");
  if (const auto look = root.optional("look")) workspace.look = read_look(*look);
  if (const auto objects = root.required("objects"); objects && objects->expect_array(0, most_objects))
    SceneReader(*objects).read(workspace);
  if (root.has_errors()) return diagnostics;
  return workspace;
}

Checked<Workspace> load_scene(const std::filesystem::path& path) {
  const auto document = JsonDocument::load(path);
  if (!document) return document.diagnostics;
  return read_scene(*document);
}

}  // namespace blossom
