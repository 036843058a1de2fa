#include "player/studio_state.hpp"

#include <charconv>
#include <map>

namespace blossom {
namespace {

std::string yes(bool b) { return b ? "yes" : "no"; }

template <class List, class Text>
std::string joined(const List& list, const Text& text_of) {
  std::string text;
  for (const auto& one : list) text += (text.empty() ? "" : ", ") + text_of(one);
  return text.empty() ? "none" : text;
}

std::string kind_text(const Geometry& geometry) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) return std::string(curve_kind_name(kind_of(*curve)));
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry))
    return std::string(curve_kind_name(kind_of(*surface))) + " surface";
  return std::string(geometry_key(geometry));
}

std::string knots_text(const std::vector<Exact>& knots) {
  std::string text;
  for (const Exact& u : knots) text += (text.empty() ? "" : " ") + u.to_string();
  return text;
}

std::string degree_text(const Geometry& geometry) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) return std::to_string(curve->degree);
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry))
    return std::to_string(surface->degree[0]) + " " + std::to_string(surface->degree[1]);
  return "none";
}

std::string shows_text(const SceneObject& object) {
  std::vector<std::string> shown;
  for (const ShowName& name : show_names())
    if (object.shows[name.show]) shown.emplace_back(name.id);
  return joined(shown, [](const std::string& id) { return id; });
}

using Reader = std::string (*)(const Studio&);

const std::map<std::string, Reader, std::less<>>& of_studio() {
  static const std::map<std::string, Reader, std::less<>> readers{
      {"title", [](const Studio& s) { return s.title(); }},
      {"file", [](const Studio& s) { return s.file().empty() ? "none" : s.file().filename().string(); }},
      {"objects",
       [](const Studio& s) { return joined(s.workspace().objects, [](const SceneObject& o) { return o.name; }); }},
      {"hidden",
       [](const Studio& s) {
         std::vector<std::string> hidden;
         for (const SceneObject& object : s.workspace().objects)
           if (object.hidden) hidden.push_back(object.name);
         return joined(hidden, [](const std::string& name) { return name; });
       }},
      {"current", [](const Studio& s) { return s.object() != nullptr ? s.object()->name : "none"; }},
      {"kind", [](const Studio& s) { return s.object() != nullptr ? kind_text(s.object()->geometry) : "none"; }},
      {"degree", [](const Studio& s) { return s.object() != nullptr ? degree_text(s.object()->geometry) : "none"; }},
      {"shows", [](const Studio& s) { return s.object() != nullptr ? shows_text(*s.object()) : "none"; }},
      {"chosen",
       [](const Studio& s) {
         return joined(s.chosen(), [&](std::size_t i) { return s.workspace().objects[i].name; });
       }},
      {"selected",
       [](const Studio& s) {
         return joined(s.selected(), [&](const PointRef& ref) {
           const SceneObject& object = s.workspace().objects[ref.object];
           return object.name + " " + point_name(object.geometry, ref.point);
         });
       }},
      {"tool", [](const Studio& s) { return std::string(tool_name(s.tool())); }},
      {"clicked", [](const Studio& s) { return std::to_string(s.clicked().size()); }},
      {"u", [](const Studio& s) { return format_short(s.u(), 4); }},
      {"v", [](const Studio& s) { return format_short(s.v(), 4); }},
      {"undo", [](const Studio& s) { return s.history().undo_what(); }},
      {"redo", [](const Studio& s) { return s.history().redo_what(); }},
      {"undos", [](const Studio& s) { return std::to_string(s.history().size() - 1); }},
      {"unsaved", [](const Studio& s) { return yes(s.unsaved()); }},
      {"rejected", [](const Studio& s) { return to_string(s.problems()); }},
      {"pane", [](const Studio& s) { return s.four_panes ? "four" : std::string(pane_name(s.pane)); }},
      {"gizmo", [](const Studio& s) { return yes(s.gizmo); }},
      {"running", [](const Studio& s) { return yes(s.running()); }},
      {"riding", [](const Studio& s) { return yes(s.riding()); }},
      {"held", [](const Studio& s) { return yes(s.held() != nullptr); }},
      {"camera",
       [](const Studio& s) {
         const Camera c = s.camera_of(s.pane);
         return format_short(c.centre.x, 4) + " " + format_short(c.centre.y, 4) + " " + format_short(c.centre.z, 4) +
                " " + format_short(c.height, 4) + " " + format_short(c.azimuth, 4) + " " + format_short(c.elevation, 4);
       }},
  };
  return readers;
}

// "NAME points": the word behind a name that may have blanks in it.
std::optional<std::string> of_object(const Studio& studio, const std::string& rest) {
  const auto& workspace = studio.workspace();
  if (const SceneObject* object = workspace.find(rest)) return kind_text(object->geometry);
  const std::size_t blank = rest.rfind(' ');
  if (blank == std::string::npos) return std::nullopt;
  const SceneObject* object = workspace.find(rest.substr(0, blank));
  const std::string what = rest.substr(blank + 1);
  if (object == nullptr) return std::nullopt;
  if (what == "points") return std::to_string(point_count(object->geometry));
  if (what == "made") return object->recipe ? std::string(object->recipe->algorithm->id) : "given";
  if (what == "problem") return object->problem.empty() ? "none" : object->problem;
  if (what == "hidden") return yes(object->hidden);
  if (what == "shows") return shows_text(*object);
  if (what == "color") return std::to_string(object->color);
  if (what == "degree") return degree_text(object->geometry);
  const auto* curve = std::get_if<Curve<Exact>>(&object->geometry);
  if (what == "knots" && curve != nullptr) return knots_text(curve->knots);
  if (what == "form" && curve != nullptr) return std::string(curve_form_name(form_of(*curve)));
  return std::nullopt;
}

struct PointAt {
  const SceneObject* object;
  std::size_t point;
};

std::optional<PointAt> point_at(const Studio& studio, const std::string& rest) {
  const std::size_t blank = rest.rfind(' ');
  if (blank == std::string::npos) return std::nullopt;
  const SceneObject* object = studio.workspace().find(rest.substr(0, blank));
  std::size_t point = 0;
  const auto [end, error] = std::from_chars(rest.data() + blank + 1, rest.data() + rest.size(), point);
  if (object == nullptr || error != std::errc() || end != rest.data() + rest.size() ||
      point >= point_count(object->geometry))
    return std::nullopt;
  return PointAt{object, point};
}

std::optional<std::string> of_point(const Studio& studio, const std::string& rest) {
  const auto found = point_at(studio, rest);
  if (!found) return std::nullopt;
  const auto at = place_of(found->object->geometry, found->point);
  if (!at) return "nowhere";
  return format_short(at->x.to_double(), 4) + " " + format_short(at->y.to_double(), 4) + " " +
         format_short(at->z.to_double(), 4);
}

std::optional<std::string> of_weight(const Studio& studio, const std::string& rest) {
  const auto found = point_at(studio, rest);
  if (!found) return std::nullopt;
  if (const auto* curve = std::get_if<Curve<Exact>>(&found->object->geometry))
    return curve->points[found->point].w.to_string();
  if (const auto* surface = std::get_if<Surface<Exact>>(&found->object->geometry))
    return surface->points[found->point].w.to_string();
  return "1";
}

}  // namespace

std::optional<std::string> studio_state_of(const Studio& studio, const std::string& key) {
  if (const auto found = of_studio().find(key); found != of_studio().end()) return found->second(studio);
  if (key.starts_with("object ")) return of_object(studio, key.substr(7));
  if (key.starts_with("point ")) return of_point(studio, key.substr(6));
  if (key.starts_with("weight ")) return of_weight(studio, key.substr(7));
  return std::nullopt;
}

std::vector<std::string> studio_state_keys() {
  std::vector<std::string> keys;
  for (const auto& [key, reader] : of_studio()) keys.push_back(key);
  return keys;
}

std::string thing_text(const Studio& studio, const Link& link) {
  const auto& objects = studio.workspace().objects;
  if (link.id >= objects.size()) return "none";
  const SceneObject& object = objects[link.id];
  return link.part == 0 ? object.name : object.name + " " + point_name(object.geometry, link.part - 1);
}

}  // namespace blossom
