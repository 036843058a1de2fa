// What is drawn of the current thing, or of all of its kind; where on it one is.
#include <algorithm>
#include <numeric>

#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

const StudioModel model("show");

void draw_parameter(Ui& ui, StudioFields& fields, const Studio& studio, int direction, float room) {
  const SceneObject& object = *studio.object();
  const std::size_t i = *studio.current();
  const char* name = direction == 0 ? "u" : "v";
  const float left = ImGui::GetCursorPosX(), label = ImGui::CalcTextSize("u ").x + ui.px(4);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(left + label, 0);
  fields.number({"objects[" + std::to_string(i) + "]." + name, name, direction == 0 ? object.u : object.v,
                 NumberStyle::parameter, ui.px(86)},
                [i, direction](const Workspace& w, const Exact& x) -> Worked {
                  if (i >= w.objects.size()) return Diagnostics{};
                  return edit::look_at(w, i, direction == 0 ? x : w.objects[i].u, direction == 0 ? w.objects[i].v : x);
                });
  ImGui::SameLine();
  const auto domain = domain_of(object.geometry, direction);
  if (!domain) return fields.say();
  const double at = direction == 0 ? studio.u() : studio.v();
  if (const auto to =
          share_slider(ui, std::string("show ") + name + " slider", at, domain->first.to_double(),
                       domain->second.to_double(), std::max(room - (ImGui::GetCursorPosX() - left), ui.px(60))))
    send_studio(ui, [direction, to = *to](Studio& s) {
      if (s.current()) s.look_at(direction == 0 ? to : s.u(), direction == 0 ? s.v() : to);
    });
  fields.say();
}

void draw_running(Ui& ui, const Studio& studio) {
  if (ui.button(studio.running() ? "Stop" : "Run u along", "show run", true, "Space"))
    send_studio(ui, [](Studio& s) { s.run(!s.running()); });
  if (std::holds_alternative<Curve<Exact>>(studio.object()->geometry)) {
    ImGui::SameLine();
    if (ui.button(studio.riding() ? "Get off" : "Ride along it", "show ride", true,
                  "The camera runs along the curve, as on a roller coaster   R"))
      send_studio(ui, [](Studio& s) { s.ride(!s.riding()); });
  }
  const float needed = ImGui::CalcTextSize("speed").x + ui.px(80) + 2 * ImGui::GetStyle().ItemSpacing.x;
  const float end = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  if (ImGui::GetItemRectMax().x + needed <= end)
    ImGui::SameLine();
  else
    ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("speed");
  ImGui::SameLine();
  if (const auto to = share_slider(ui, "show speed", studio.speed, 0.1, 4, ui.px(80)))
    send_studio(ui, [to = *to](Studio& s) { s.speed = to; });
}

// As many columns as fit, each as wide as what stands in it.
std::vector<float> columns_for(const Ui& ui, const std::vector<ShowName>& names, float room) {
  const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x, gap = ui.px(14);
  for (std::size_t count = 3; count > 1; --count) {
    std::vector<float> widths(count, 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const float width = box + ImGui::CalcTextSize(std::string(names[i].title).c_str()).x;
      widths[i % count] = std::max(widths[i % count], width + gap);
    }
    if (std::accumulate(widths.begin(), widths.end(), -gap) <= room) return widths;
  }
  return {room};
}

void draw_shows(Ui& ui, const Studio& studio, bool of_curve, float room) {
  const SceneObject& object = *studio.object();
  std::vector<ShowName> names;
  for (const ShowName& each : show_names())
    if (of_curve ? each.of_curves : each.of_surfaces) names.push_back(each);
  const std::vector<float> columns = columns_for(ui, names, room);
  const float left = ImGui::GetCursorPosX();
  float x = left;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const ShowName& each = names[i];
    const std::size_t column = i % columns.size();
    x = column == 0 ? left : x + columns[column - 1];
    if (column > 0) ImGui::SameLine(x, 0);
    bool on = object.shows[each.show];
    if (ImGui::Checkbox(std::string(each.title).c_str(), &on))
      send_studio(ui, [show = each.show, on](Studio& s) { s.show(show, on); });
    ui.thing("show " + std::string(each.id));
  }
}

void draw_map(Ui& ui, const Studio& studio) {
  std::vector<std::string> titles;
  for (int m = 0; m < surface_map_count; ++m) titles.emplace_back(surface_map_title(static_cast<SurfaceMap>(m)));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Coloured by");
  ImGui::SameLine();
  if (const auto to = combo(ui, "show map", titles, static_cast<std::size_t>(studio.object()->map), ui.px(190)))
    send_studio(ui, [map = static_cast<SurfaceMap>(*to)](Studio& s) {
      if (s.current()) s.edit(edit::set_map(s.workspace(), *s.current(), map), "map");
    });
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  if (studio.object() == nullptr) return ImGui::TextDisabled("Choose a thing to say what is shown of it.");
  const SceneObject& object = *studio.object();
  const bool curve = std::holds_alternative<Curve<Exact>>(object.geometry);
  const bool surface = std::holds_alternative<Surface<Exact>>(object.geometry);
  ImGui::BeginChild("show form", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  StudioFields fields(ui, model);
  const float room = ImGui::GetContentRegionAvail().x;
  fields.set_wrap(room);
  if (curve || surface) {
    draw_parameter(ui, fields, studio, 0, room);
    if (surface) draw_parameter(ui, fields, studio, 1, room);
    draw_running(ui, studio);
    ImGui::Dummy({0, ui.px(2)});
  }
  draw_shows(ui, studio, !surface, room);
  if (surface) draw_map(ui, studio);
  if (curve && object.shows[Show::comb]) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Length of the comb");
    ImGui::SameLine();
    if (const auto to = share_slider(ui, "show comb scale", std::log10(studio.comb_scale), -2, 2, ui.px(140)))
      send_studio(ui, [to = *to](Studio& s) { s.comb_scale = std::pow(10.0, to); });
  }
  ImGui::Dummy({0, ui.px(2)});
  bool all = studio.for_all;
  if (ImGui::Checkbox(curve ? "For all curves" : surface ? "For all surfaces" : "For all points", &all))
    send_studio(ui, [all](Studio& s) { s.for_all = all; });
  ui.thing("show for-all");
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_studio_show() {
  static const Panel panel{"show", "Show", Slot::tabs, 20, draw, nullptr, nullptr, 0, true, true};
  return panel;
}

}  // namespace blossom
