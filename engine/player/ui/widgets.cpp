// What panels are made of besides Dear ImGui's own widgets.
#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "player/action.hpp"
#include "player/ui/ui.hpp"
#include "render/rich_text.hpp"

namespace blossom {

bool Ui::button(const char* label, const std::string& name, bool enabled, const char* tooltip) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(label);
  ImGui::EndDisabled();
  thing(name);
  if (tooltip != nullptr && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", tooltip);
  return pressed;
}

namespace {

std::string tooltip_of(const Action& action) {
  std::string text(action.title);
  if (!action.keys.empty()) text += "   " + std::string(action.keys.front());
  return text;
}

}  // namespace

bool Ui::action_button(std::string_view id, const char* label) {
  const Action* action = find_action(id);
  IM_ASSERT(action != nullptr);
  const bool enabled = action->enabled == nullptr || action->enabled(*player_);
  const bool on = action->checked != nullptr && action->checked(*player_);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  const bool pressed = button(label, std::string(id), enabled, tooltip_of(*action).c_str());
  if (on) ImGui::PopStyleColor();
  if (pressed) act(id);
  return pressed;
}

namespace {

// Icons in a square from (-1, -1) to (1, 1), y down.
void draw_icon(ImDrawList& list, std::string_view icon, ImVec2 c, float r, ImU32 color) {
  const auto at = [&](double x, double y) {
    return ImVec2{c.x + static_cast<float>(x) * r, c.y + static_cast<float>(y) * r};
  };
  const float line = std::max(1.5f, r * 0.28f);
  // Dear ImGui smooths the edges of what runs clockwise.
  const auto solid = [&](ImVec2 p, ImVec2 q, ImVec2 s) {
    if ((q.x - p.x) * (s.y - p.y) < (q.y - p.y) * (s.x - p.x)) std::swap(q, s);
    list.AddTriangleFilled(p, q, s, color);
  };
  const auto triangle = [&](double x, double w) { solid(at(x, -0.9), at(x, 0.9), at(x + w, 0)); };
  const auto bar = [&](double x, double w) { list.AddRectFilled(at(x, -0.9), at(x + w, 0.9), color); };
  const auto stroke = [&](std::initializer_list<ImVec2> points, bool closed = false) {
    list.AddPolyline(std::data(points), static_cast<int>(points.size()), color, closed ? ImDrawFlags_Closed : 0, line);
  };
  if (icon == "first") bar(-0.95, 0.3), triangle(0.85, -1.4);
  if (icon == "back") triangle(0.6, -1.3);
  if (icon == "play") solid(at(-0.7, -1), at(-0.7, 1), at(1.05, 0));
  if (icon == "pause") bar(-0.7, 0.45), bar(0.25, 0.45);
  if (icon == "forward") triangle(-0.6, 1.3);
  if (icon == "last") triangle(-0.85, 1.4), bar(0.65, 0.3);
  if (icon == "over") {  // an arc above a dot
    list.PathArcTo(at(0, 0.25), r * 0.75f, 3.35f, 6.0f, 16);
    list.PathStroke(color, 0, line);
    solid(at(0.35, -0.05), at(1.05, -0.15), at(0.8, 0.5));
    list.AddCircleFilled(at(0, 0.7), r * 0.26f, color);
  }
  if (icon == "out") {  // up and out
    stroke({at(0, 0.9), at(0, -0.3)});
    solid(at(-0.6, -0.2), at(0.6, -0.2), at(0, -0.95));
    stroke({at(-0.8, 0.9), at(0.8, 0.9)});
  }
  if (icon == "next-beat" || icon == "previous-beat") {
    const double s = icon == "next-beat" ? 1 : -1;
    stroke({at(-0.75 * s, -0.7), at(-0.05 * s, 0), at(-0.75 * s, 0.7)});
    stroke({at(0.05 * s, -0.7), at(0.75 * s, 0), at(0.05 * s, 0.7)});
  }
  if (icon == "loop") {
    list.AddRect(at(-0.9, -0.55), at(0.9, 0.6), color, r * 0.5f, 0, line);
    solid(at(-0.1, -1.05), at(-0.1, 0.0), at(0.5, -0.52));
  }
  if (icon == "bookmark") {
    const ImVec2 flag[] = {at(-0.6, -0.95), at(0.6, -0.95), at(0.6, 0.95), at(0, 0.4), at(-0.6, 0.95)};
    list.AddPolyline(flag, 5, color, ImDrawFlags_Closed, line);
  }
  if (icon == "bookmarked") {
    list.AddRectFilled(at(-0.6, -0.95), at(0.6, 0.4), color);
    solid(at(-0.6, 0.35), at(0, 0.35), at(-0.6, 0.95));
    solid(at(0.6, 0.35), at(0, 0.35), at(0.6, 0.95));
  }
  if (icon == "undo" || icon == "redo") {
    const double s = icon == "undo" ? 1 : -1;
    list.PathArcTo(at(0.1 * s, 0.15), r * 0.68f, s > 0 ? -2.3f : 3.14f + 2.3f, s > 0 ? 1.6f : 3.14f - 1.6f, 18);
    list.PathStroke(color, 0, line);
    solid(at(-0.95 * s, -0.35), at(-0.15 * s, -0.85), at(-0.1 * s, 0.1));
  }
  if (icon == "fit")
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0}) stroke({at(0.85 * x, 0.3 * y), at(0.85 * x, 0.85 * y), at(0.3 * x, 0.85 * y)});
  if (icon == "minus" || icon == "plus") stroke({at(-0.7, 0), at(0.7, 0)});
  if (icon == "plus") stroke({at(0, -0.7), at(0, 0.7)});
  if (icon == "close") stroke({at(-0.7, -0.7), at(0.7, 0.7)}), stroke({at(0.7, -0.7), at(-0.7, 0.7)});
}

}  // namespace

bool Ui::icon_button(std::string_view id, std::string_view icon, bool pressed_in) {
  const Action* action = find_action(id);
  IM_ASSERT(action != nullptr);
  const bool enabled = action->enabled == nullptr || action->enabled(*player_);
  const float side = ImGui::GetFrameHeight() * 1.12f;
  if (pressed_in) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  ImGui::PushID(id.data(), id.data() + id.size());
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button("##icon", {side, side});
  ImGui::EndDisabled();
  ImGui::PopID();
  if (pressed_in) ImGui::PopStyleColor();
  thing(std::string(id));
  const ImVec2 low = ImGui::GetItemRectMin();
  draw_icon(*ImGui::GetWindowDrawList(), icon, {std::round(low.x + side / 2), std::round(low.y + side / 2)},
            side * 0.27f, enabled ? ink(Role::text) : color(Role::earlier));
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", tooltip_of(*action).c_str());
  if (pressed) act(id);
  return pressed;
}

bool Ui::step_is_new_to(const std::string& panel) {
  const std::pair now{player_->session()->version(), player_->session()->step()};
  return std::exchange(seen_steps_[panel], now) != now;
}

void Ui::heading(const char* text) {
  ImGui::PushFont(bold_);
  ImGui::PushStyleColor(ImGuiCol_Text, ink(Role::text_quiet));
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

// ---- the menu of a value --------------------------------------------------------------------------------------------

void Ui::draw_menu() {
  if (std::exchange(menu_requested_, false)) ImGui::OpenPopup("value menu");
  if (!ImGui::BeginPopup("value menu")) return;
  const Session* session = player_->session();
  const bool is_value = session != nullptr && menu_link_.kind == Link::Kind::value &&
                        menu_link_.id < session->recording().graph().value_count();
  const auto item = [&](const char* label, auto&& what) {
    if (ImGui::MenuItem(label)) send(what);
    thing("menu " + std::string(label));
  };
  if (is_value) {
    const StepSource& source = session->recording().source();
    const ValueId v = menu_link_.id;
    const ValueRecord& record = source.graph->value(v);
    ImGui::TextDisabled("%s", plain_name(record.name, source.algorithm_at(record.step)).c_str());
    item("Why?", [v](Player& player) { player.ask_why(v); });
    item("Go to its step", [v](Player& player) { player.seek_value(v); });
    if (!player_->veils(v)) {
      item("Copy value", [text = source.value_text(v)](Player& player) {
        player.desk().set_clipboard(text);
        player.notice("Copied: " + text);
      });
      item("Copy as LaTeX", [text = latex_value(source, v)](Player& player) {
        player.desk().set_clipboard(text);
        player.notice("Copied: " + text);
      });
    }
    if (const auto point = address_of(*source.graph, session->inputs(), v)) {
      item("Add a point behind", [at = *point](Player& player) { player.add_point_behind(at); });
      item("Delete this point", [at = *point](Player& player) { player.remove_point(at); });
    }
    ImGui::Separator();
  }
  const bool pinned = player_->is_pinned(menu_link_);
  item(pinned ? "Unpin" : "Pin", [link = menu_link_](Player& player) { player.pin(link); });
  ImGui::EndPopup();
}

}  // namespace blossom
