// The top edge: the menus, what is open, and what one switches most.
#include <imgui_internal.h>

#include "player/action.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// ---- menus ----------------------------------------------------------------------------------------------------------

void items_of(Ui& ui, const ActionGroup& group) {
  for (const Action* here : actions_here(ui.player(), group)) {
    const Action& action = *here;
    const bool enabled = action.enabled == nullptr || action.enabled(ui.player());
    const bool checked = action.checked != nullptr && action.checked(ui.player());
    const std::string title(action.title), key(action.keys.empty() ? std::string_view() : action.keys.front());
    if (ImGui::MenuItem(title.c_str(), key.c_str(), checked, enabled)) {
      ui.act(action.id);
      // The keyboard is the picture's again.
      ImGui::GetCurrentContext()->NavDisableHighlight = true;
      ui.send([](Player& player) {
        if (player.focus == "menu") player.focus.clear();
      });
    }
    ui.thing("menu item " + std::string(action.id));
  }
}

// A button of the bar: flat, and marked while its menu is open.
bool flat_button(const char* label, bool open) {
  ImVec4 color = ImGui::GetStyleColorVec4(open ? ImGuiCol_ButtonHovered : ImGuiCol_Button);
  if (!open) color.w = 0;
  ImGui::PushStyleColor(ImGuiCol_Button, color);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  const bool pressed = ImGui::Button(label);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return pressed;
}

struct Entry {
  std::string label, popup;
  const ActionGroup* group;  // nullptr: all of them, one below the other
};

bool key_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

void contents_of(Ui& ui, const Entry& entry) {
  if (entry.group != nullptr) return items_of(ui, *entry.group);
  for (const ActionGroup* group : ordered_action_groups()) {
    if (actions_here(ui.player(), *group).empty()) continue;
    const std::string title(group->title);
    const bool open = ImGui::BeginMenu(title.c_str());
    ui.thing("menu " + title);
    if (!open) continue;
    items_of(ui, *group);
    ImGui::EndMenu();
  }
}

// Dear ImGui's own menu bar belongs to a window and its keys to that window alone; these menus are popups below
// buttons, so that F10 reaches them from everywhere.
void draw_menus(Ui& ui, const std::vector<Entry>& entries) {
  std::size_t open = entries.size(), wanted = entries.size();
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (ImGui::IsPopupOpen(entries[i].popup.c_str())) open = i;
  std::vector<ImVec2> places;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 0);
    if (flat_button(entries[i].label.c_str(), open == i)) wanted = i;
    ui.thing("menu " + entries[i].popup);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    places.push_back({low.x, high.y + ui.px(2)});
    if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible && open == entries.size() &&
        key_pressed(ImGuiKey_DownArrow))
      wanted = i;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (open < entries.size() && open != i && (moved.x != 0 || moved.y != 0) &&
        ImGui::IsMouseHoveringRect(low, high, false))
      wanted = i;
  }
  if (open < entries.size()) {
    ImGui::SetNextWindowPos(places[open]);
    if (ImGui::BeginPopup(entries[open].popup.c_str())) {
      contents_of(ui, entries[open]);
      const bool inner = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);  // a menu in this menu has the arrows
      if (!inner && entries.size() > 1) {
        if (key_pressed(ImGuiKey_RightArrow)) wanted = (open + 1) % entries.size();
        if (key_pressed(ImGuiKey_LeftArrow)) wanted = (open + entries.size() - 1) % entries.size();
      }
      ImGui::EndPopup();
    }
  }
  if (wanted < entries.size() && wanted != open) ImGui::OpenPopup(entries[wanted].popup.c_str());
}

// ---- what stands at the right ---------------------------------------------------------------------------------------

void underline(Ui& ui) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - ui.px(2.5)}, high, ui.color(Role::current));
}

// One of two: "2/5" or "0.4".
void number_switch(Ui& ui) {
  const bool exact = ui.player().settings.exact;
  for (const bool is_exact : {true, false}) {
    if (!is_exact) ImGui::SameLine(0, 0);
    const bool on = is_exact == exact;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
    const bool pressed = ui.button(is_exact ? "2/5" : "0.4", is_exact ? "menu exact" : "menu decimals", true,
                                   is_exact ? "Numbers as exact fractions   X" : "Numbers as decimals   X");
    if (on) {
      ImGui::PopStyleColor();
      underline(ui);
    } else if (pressed) {
      ui.act("view.exact");
    }
  }
}

struct RightItem {
  float width;
  int worth;  // the lowest goes first when there is no room
  void (*draw)(Ui&);
};

// "DE": which one reads.
std::string language_label(const Player& player) {
  const auto all = player.languages();
  std::string label = std::ranges::find(all, player.language()) != all.end() ? std::string(player.language()) : all[0];
  for (char& c : label) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return label;
}

float button_width(const char* label) { return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x; }

std::vector<RightItem> right_items(const Ui& ui) {
  const float icon = ImGui::GetFrameHeight() * 1.12f, gap = ImGui::GetStyle().ItemSpacing.x;
  const bool lesson = ui.player().session() != nullptr, open = lesson || ui.player().in_studio();
  std::vector<RightItem> items;
  if (ui.player().stepping_from_studio())
    items.push_back(
        {button_width("Back to the studio"), 10, [](Ui& u) { u.action_button("studio.back", "Back to the studio"); }});
  if (ui.player().in_studio())
    items.push_back({button_width("Step it"), 8, [](Ui& u) { u.action_button("studio.step", "Step it"); }});
  if (open && !ui.player().lost_work().empty())
    items.push_back(
        {button_width("Recover edits ..."), 9, [](Ui& u) { u.action_button("file.recover", "Recover edits ..."); }});
  if (open)
    items.push_back({2 * icon + ui.px(2), 6, [](Ui& u) {
                       u.icon_button("edit.undo", "undo");
                       ImGui::SameLine(0, u.px(2));
                       u.icon_button("edit.redo", "redo");
                     }});
  items.push_back({button_width("2/5") + button_width("0.4"), 4, number_switch});
  if (lesson)
    items.push_back({button_width("Predict"), 5, [](Ui& u) {
                       u.action_button("predict.toggle", "Predict");
                       if (u.player().session()->prediction() != nullptr) underline(u);
                     }});
  if (ui.player().languages().size() > 1)
    items.push_back({button_width(language_label(ui.player()).c_str()), 7,
                     [](Ui& u) { u.action_button("lesson.language", language_label(u.player()).c_str()); }});
  items.push_back({button_width("\u25D0"), 3, [](Ui& u) { u.action_button("view.next_theme", "\u25D0"); }});
  items.push_back({button_width("?"), 7, [](Ui& u) { u.action_button("help.shortcuts", "?"); }});
  for (RightItem& item : items) item.width += gap;
  return items;
}

float sum(const std::vector<RightItem>& items) {
  float width = 0;
  for (const RightItem& item : items) width += item.width;
  return width;
}

// ---- all of it ------------------------------------------------------------------------------------------------------

std::vector<Entry> entries_for(const Player& player, float room) {
  std::vector<Entry> entries;
  float width = 0;
  for (const ActionGroup* group : ordered_action_groups()) {
    if (actions_here(player, *group).empty()) continue;
    const std::string title(group->title);
    entries.push_back({title, title, group});
    width += button_width(title.c_str());
  }
  if (width > room) entries = {{"\u2261 Menu", "all", nullptr}};
  return entries;
}

void draw_title(Ui& ui, float from, float to) {
  const Session* session = ui.player().session();
  const Studio* studio = ui.player().studio();
  if ((session == nullptr && studio == nullptr) || to - from < ui.px(40)) return;
  const std::string whole = session != nullptr ? ui.player().title() : studio->title();
  const bool unsaved = session != nullptr ? ui.player().unsaved() : studio->unsaved();
  const std::string mark = unsaved ? "  \u2022 edited" : "";
  const float mark_width = ImGui::CalcTextSize(mark.c_str()).x;
  ImGui::PushFont(ui.bold());
  const std::string title = shortened(whole, to - from - mark_width);
  const float width = ImGui::CalcTextSize(title.c_str()).x;
  // In the middle of the window if that is free.
  const float middle = (ImGui::GetIO().DisplaySize.x - width - mark_width) / 2;
  const float x = std::max(from, std::min(middle, to - width - mark_width));
  ImGui::SetCursorPosX(x);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  ui.thing("menu title");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", whole.c_str());
  if (mark.empty()) return;
  ImGui::SameLine(0, 0);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_current));
  ImGui::TextUnformatted(mark.c_str());
  ImGui::PopStyleColor();
  ui.thing("menu edited");
}

void draw(Ui& ui) {
  const float right = ImGui::GetWindowContentRegionMax().x;
  const float y = ImGui::GetCursorPosY();
  ImGui::SetCursorPosX(ui.px(4));
  // Buttons of text as high as those with icons.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, ui.px(5)});
  const auto entries = entries_for(ui.player(), right - ui.px(44));
  draw_menus(ui, entries);
  const float menus_end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  // The title wants some room before what the menus have, too.
  const float title_room = ui.player().session() != nullptr || ui.player().in_studio() ? ui.px(110) : 0;
  auto items = right_items(ui);
  while (!items.empty() && menus_end + title_room + sum(items) > right)
    items.erase(std::ranges::min_element(items, {}, &RightItem::worth));
  const float items_at = right - sum(items) + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosY(y);
  draw_title(ui, menus_end + ui.px(16), items_at - ui.px(16));
  float x = items_at;
  for (const RightItem& item : items) {
    ImGui::SetCursorPos({x, y});
    item.draw(ui);
    x += item.width;
  }
  ImGui::PopStyleVar();
}

double wanted(const Ui&, double) { return 44; }

}  // namespace

const Panel& panel_menu() {
  static const Panel panel{
      .id = "menu", .title = "Menu", .slot = Slot::bar, .order = 0, .draw = draw, .height = wanted, .widgets = true};
  return panel;
}

}  // namespace blossom
