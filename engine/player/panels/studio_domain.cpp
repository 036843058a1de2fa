// The domain of a surface as a square: the point in it is dragged over the surface.
#include "player/panels/mouse.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  const ImVec2 origin = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const double width = ui.units(room.x), height = ui.units(room.y);
  const double size = std::min(width, height);
  if (size < 80) return;
  const auto surface = convert<double>(std::get<Surface<Exact>>(studio.object()->geometry));
  Sheet sheet;
  const DomainSquare square = add_domain_square(sheet, surface, {studio.u(), studio.v()}, (width - size) / 2, 0, size);
  ui.sheet("domain", std::move(sheet), width, height, {.clickable = false});
  const ImVec2 low{origin.x + ui.px(square.left), origin.y + ui.px(square.top)};
  ui.thing("domain square", low, {low.x + ui.px(square.side), low.y + ui.px(square.side)});
  const Mouse mouse{ui, origin, {width, height}};
  const auto in_square = [&](glm::dvec2 at) {
    return at.x > square.left - 10 && at.y > square.top - 10 && at.x < square.left + square.side + 10 &&
           at.y < square.top + square.side + 10;
  };
  if (mouse.over() && in_square(mouse.now())) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (mouse.owns(0) && in_square(mouse.pressed(0))) {
    const glm::dvec2 uv = glm::clamp(square.parameter(mouse.now()), square.first, square.last);
    if (uv.x != studio.u() || uv.y != studio.v()) send_studio(ui, [uv](Studio& s) { s.look_at(uv.x, uv.y); });
  }
  if (ImGui::IsMouseReleased(0)) send_studio(ui, [](Studio& s) { s.end_gesture(); });
}

bool relevant(const Player& player) {
  const SceneObject* object = player.studio()->object();
  return object != nullptr && std::holds_alternative<Surface<Exact>>(object->geometry);
}

}  // namespace

const Panel& panel_studio_domain() {
  static const Panel panel{"domain", "u, v", Slot::tabs, 25, draw, relevant, nullptr, 0, false, true};
  return panel;
}

}  // namespace blossom
