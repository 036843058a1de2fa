// The scene that one designs: in one view, or in four.
#include <array>
#include <cmath>

#include "player/action.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_hands.hpp"

namespace blossom {
namespace {

constexpr double margin = 8;         // of what stands in the corners
constexpr double tools_height = 25;  // of the strip above the picture, where no point can be under them
constexpr double between = 3;        // panes
constexpr double least_pane = 90;

struct ToolButton {
  std::string_view action;
  const char* label;
};
constexpr std::array<ToolButton, 5> tools = {{{"studio.choose", "Choose"},
                                              {"studio.draw", "Draw"},
                                              {"studio.insert", "Insert"},
                                              {"studio.erase", "Erase"},
                                              {"studio.gizmo", "Handles"}}};
constexpr std::array<ToolButton, 9> views = {{{"view.grid", "Grid"},
                                              {"edit.snap", "Snap"},
                                              {"studio.perspective", "Perspective"},
                                              {"view.fit", "Fit"},
                                              {"studio.xy", "xy"},
                                              {"studio.xz", "xz"},
                                              {"studio.yz", "yz"},
                                              {"studio.space", "Space"},
                                              {"studio.four", "Four"}}};

// The tools from the left, the views from the right; of those that do not fit the first ones go, which the menus have.
void draw_tools(Ui& ui, ImVec2 at, float room) {
  const float pad = ui.px(6), gap = ui.px(3);
  const auto width_of = [&](const ToolButton& tool) { return ImGui::CalcTextSize(tool.label).x + 2 * pad; };
  const auto row = [&](const auto& list, std::size_t from) {
    for (std::size_t i = from; i < list.size(); ++i) {
      if (i > from) ImGui::SameLine();
      ui.action_button(list[i].action, list[i].label);
      const Action& action = *find_action(list[i].action);
      if (action.checked == nullptr || !action.checked(ui.player())) continue;
      const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
      ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - ui.px(2)}, high, ui.color(Role::current));
    }
  };
  float left = 0, right = 0;
  for (const ToolButton& tool : tools) left += width_of(tool) + gap;
  for (const ToolButton& view : views) right += width_of(view) + gap;
  std::size_t from = 0;
  while (from < views.size() && left + gap + right > room) right -= width_of(views[from++]) + gap;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, ui.px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  ImGui::SetCursorScreenPos(at);
  row(tools, 0);
  if (from < views.size()) {
    ImGui::SetCursorScreenPos({at.x + room - right + gap, at.y});
    row(views, from);
  }
  ImGui::PopStyleVar(2);
}

// Which of the four it is, in its corner.
void draw_pane_name(const Ui& ui, StudioPane pane, ImVec2 origin, ImVec2 room) {
  static constexpr const char* names[] = {"In space", "xy, from above", "xz, from the front", "yz, from the side"};
  // Beside the numbers of the grid, which stand at the left edge.
  const ImVec2 high{origin.x + room.x, origin.y + room.y};
  draw_tag(ui, *ImGui::GetWindowDrawList(), {origin.x + ui.px(26), origin.y + ui.px(5)},
           names[static_cast<std::size_t>(pane)], Role::text_quiet, origin, high);
}

// What the colours of a surface mean, in the lower left corner where there is room for it.
void draw_legend(Ui& ui, const WorkspaceLook& look, ImVec2 origin, ImVec2 room) {
  const Studio& studio = *ui.player().studio();
  const auto mapped = mapped_object(studio.workspace(), look.current);
  if (!mapped || ui.units(room.x) < 1.6 * map_legend_width) return;
  Sheet sheet;
  const double high =
      add_map_legend(sheet, studio.workspace().objects[*mapped],
                     studio.scenes().map_range(studio.workspace(), *mapped, look), 10, 8, map_legend_width) +
      12;
  const double wide = map_legend_width + 20;
  if (ui.units(room.y) < 2 * high) return;
  const ImVec2 low{origin.x + ui.px(6), origin.y + room.y - ui.px(high + 6)};
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + ui.px(wide), low.y + ui.px(high)},
                                            ui.color(Role::panel, 0.92), ui.px(4));
  sheet.view.width = wide;
  sheet.view.height = high;
  ImGui::SetCursorScreenPos(low);
  ui.picture(std::move(sheet.view), wide, high, "view legend");
}

void draw_pane(Ui& ui, StudioPane pane, ImVec2 origin, ImVec2 room) {
  const Player& player = ui.player();
  const Studio& studio = *player.studio();
  const ViewSize size{ui.units(room.x), ui.units(room.y)};
  if (size.width < 1 || size.height < 1) return;
  const auto index = static_cast<std::size_t>(pane);
  if (studio.pane_sizes[index].width != size.width || studio.pane_sizes[index].height != size.height)
    ui.send([index, size](Player& p) { p.studio()->pane_sizes[index] = size; });
  WorkspaceLook look = studio.look();
  look.camera = studio.camera_of(pane, size);
  look.grid = look.axes = player.settings.grid;
  for (const Link& link : {player.hovered(), player.focused})
    if (link.kind == Link::Kind::object && link.part > 0) look.hovered = PointRef{link.id, link.part - 1};
  Sheet sheet = studio.scenes().view(studio.workspace(), size.width, size.height, look);
  PaneOnScreen on{pane, Mouse{ui, origin, size}, {}, {}, {}};
  on.low = {origin.x + ui.px(margin), origin.y + ui.px(margin)};
  on.high = {origin.x + room.x - ui.px(margin), origin.y + room.y - ui.px(margin)};
  add_rubber_line(sheet.view, ui, pane, on.mouse);
  if (studio.four_panes)
    for (Spot& spot : sheet.spots) spot.name = std::string(pane_name(pane)) + " " + spot.name;
  on.spots = sheet.spots;
  ImGui::SetCursorScreenPos(origin);
  ui.sheet("view", std::move(sheet), size.width, size.height, {.clickable = false});
  ui.thing("view " + std::string(pane_name(pane)), origin, {origin.x + room.x, origin.y + room.y});
  if (pane == StudioPane::space) draw_legend(ui, look, origin, room);
  handle_pane_mouse(ui, on);
  draw_pane_words(ui, on);
}

void draw_four(Ui& ui, ImVec2 origin, ImVec2 room) {
  constexpr std::array<StudioPane, 4> order{StudioPane::xy, StudioPane::space, StudioPane::xz, StudioPane::yz};
  const Studio& studio = *ui.player().studio();
  const float gap = std::round(ui.px(between));
  const ImVec2 each{std::floor((room.x - gap) / 2), std::floor((room.y - gap) / 2)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const ImVec2 at{origin.x + static_cast<float>(i % 2) * (each.x + gap),
                    origin.y + static_cast<float>(i / 2) * (each.y + gap)};
    draw_pane(ui, order[i], at, each);
    draw_pane_name(ui, order[i], at, each);
    if (order[i] == studio.pane)
      list.AddRect(at, {at.x + each.x, at.y + each.y}, ui.color(Role::current), 0, 0, ui.px(1.5));
  }
  const ImU32 line = ui.color(Role::rule_line);
  list.AddRectFilled({origin.x + each.x, origin.y}, {origin.x + each.x + gap, origin.y + room.y}, line);
  list.AddRectFilled({origin.x, origin.y + each.y}, {origin.x + room.x, origin.y + each.y + gap}, line);
}

// What one can begin with.
void draw_welcome(Ui& ui, ImVec2 origin, ImVec2 room) {
  const Studio& studio = *ui.player().studio();
  if (!studio.workspace().objects.empty() || studio.tool() != Tool::choose || room.x < ui.px(300)) return;
  const char* lines[] = {"The scene is empty.",
                         "Draw a curve by clicks, or choose + New at the right for another kind.",
                         "Files can be dropped here."};
  const float height = ImGui::GetTextLineHeightWithSpacing();
  float y = origin.y + room.y * 0.3f;
  for (const char* line : lines) {
    const float width = ImGui::CalcTextSize(line).x;
    ImGui::GetWindowDrawList()->AddText({origin.x + (room.x - width) / 2, y},
                                        ui.ink(line == lines[0] ? Role::text : Role::text_quiet), line);
    y += height;
  }
  const char* label = "Draw a curve";
  const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetCursorScreenPos({origin.x + (room.x - width) / 2, y + ui.px(8)});
  ui.action_button("studio.draw", label);
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  ImVec2 room = ImGui::GetContentRegionAvail(), origin = ImGui::GetCursorScreenPos();
  // In a small picture there is no room for them; keys and menus have them all.
  if (ui.units(room.x) >= 240 && ui.units(room.y) >= 180) {
    ImGui::PushFont(ui.small());
    draw_tools(ui, {origin.x + ui.px(4), origin.y + ui.px(3)}, room.x - ui.px(8));
    ImGui::PopFont();
    const float strip = std::round(ui.px(tools_height));
    origin.y += strip;
    room.y -= strip;
    ImGui::GetWindowDrawList()->AddLine({origin.x, origin.y - 1}, {origin.x + room.x, origin.y - 1},
                                        ui.color(Role::rule_line));
  }
  const bool four = studio.four_panes && ui.units(room.x) >= 2 * least_pane && ui.units(room.y) >= 2 * least_pane;
  if (four)
    draw_four(ui, origin, room);
  else
    draw_pane(ui, studio.pane, origin, room);
  draw_welcome(ui, origin, room);
  draw_studio_menu(ui);
}

}  // namespace

const Panel& panel_studio_view() {
  static const Panel panel{
      .id = "view", .title = "Scene", .slot = Slot::main, .order = 0, .draw = draw, .studio = true};
  return panel;
}

}  // namespace blossom
