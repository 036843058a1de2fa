// The inputs that the lesson lets one move at this step.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

constexpr double row_height = 34;    // units
constexpr double least_width = 330;  // of a slider with its words
constexpr double tight_width = 190;  // where there is little height

int columns_for(const Ui& ui, double width) {
  const auto count = static_cast<int>(ui.player().sliders().size());
  return std::clamp(static_cast<int>(width / (ui.height() < 460 ? tight_width : least_width)), 1, std::max(count, 1));
}

// On its steps, which begin at `from`; without steps on hundredths of the way.
Exact on_steps(const Slider& slider, double share) {
  const Exact step = slider.step.value_or((slider.to - slider.from) / Exact(100));
  const double count = ((slider.to - slider.from) / step).to_double();
  const auto whole = static_cast<std::int64_t>(std::lround(std::clamp(share, 0.0, 1.0) * count));
  return std::min(slider.from + Exact(whole) * step, slider.to);
}

double share_of(const Slider& slider, const Exact& x) {
  return std::clamp(((x - slider.from) / (slider.to - slider.from)).to_double(), 0.0, 1.0);
}

std::string words_of(const Player& player, const Exact& x) {
  return player.settings.exact ? number_text(x) : format_short(x.to_double(), 4);
}

struct Track {
  float left, right, y;
  float place(double share) const { return left + static_cast<float>(share) * (right - left); }
};

void draw_track(Ui& ui, const Slider& slider, const Track& track, double share, bool hot) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({track.left, track.y - ui.px(2)}, {track.right, track.y + ui.px(2)}, ui.color(Role::rule_line),
                     ui.px(2));
  list.AddRectFilled({track.left, track.y - ui.px(2)}, {track.place(share), track.y + ui.px(2)},
                     ui.color(Role::current), ui.px(2));
  const double steps = slider.step ? ((slider.to - slider.from) / *slider.step).to_double() : 1e9;
  if (steps * ui.px(7) < track.right - track.left)
    for (int i = 0; i <= static_cast<int>(steps); ++i)
      list.AddLine({track.place(i / steps), track.y - ui.px(4)}, {track.place(i / steps), track.y + ui.px(4)},
                   ui.color(Role::polygon, 0.55), 1);
  const ImVec2 grip{track.place(share), track.y};
  list.AddCircleFilled(grip, ui.px(8), ui.color(Role::current), 24);
  list.AddCircle(grip, ui.px(8), hot ? ui.color(Role::focus) : ImGui::GetColorU32(ImGuiCol_WindowBg), 24, ui.px(2));
}

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

// Left and Right by a step, PageUp and PageDown by ten, Home and End to the ends.
void take_keys(Ui& ui, std::size_t which, const Slider& slider) {
  int by = 0;
  if (pressed(ImGuiKey_LeftArrow)) by = -1;
  if (pressed(ImGuiKey_RightArrow)) by = 1;
  if (pressed(ImGuiKey_PageDown)) by = -10;
  if (pressed(ImGuiKey_PageUp)) by = 10;
  const bool taken = by != 0 || pressed(ImGuiKey_Home) || pressed(ImGuiKey_End);
  if (taken) ImGui::NavMoveRequestCancel();  // the focus stays
  if (by != 0) ui.send([which, by](Player& p) { p.slide_by(which, by); });
  if (pressed(ImGuiKey_Home)) ui.send([which, to = slider.from](Player& p) { p.slide(which, to); });
  if (pressed(ImGuiKey_End)) ui.send([which, to = slider.to](Player& p) { p.slide(which, to); });
}

void draw_slider(Ui& ui, std::size_t which, float width) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  const Slider& slider = player.sliders()[which];
  const auto value = number_at(session.inputs(), slider.input);
  if (!value) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(row_height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = at.y + height / 2, text_y = middle - ImGui::GetFontSize() / 2;

  const std::string label = player.slider_words(slider);
  const std::string now = " = " + words_of(player, *value);
  const float label_room = width * 0.42f - ImGui::CalcTextSize(now.c_str()).x;
  const std::string cut = shortened(label, std::max(label_room, ui.px(30)));
  list.AddText({at.x, text_y}, ui.ink(Role::text), cut.c_str());
  const float after = at.x + ImGui::CalcTextSize(cut.c_str()).x;
  ImGui::PushFont(ui.bold());
  list.AddText({after, text_y}, ui.ink(Role::text_strong), now.c_str());
  ImGui::PopFont();

  // The ends of its range beside the track.
  ImGui::PushFont(ui.small());
  const std::string from = words_of(player, slider.from), to = words_of(player, slider.to);
  const float from_width = ImGui::CalcTextSize(from.c_str()).x, to_width = ImGui::CalcTextSize(to.c_str()).x;
  const float small_y = middle - ImGui::GetFontSize() / 2;
  const float track_at = at.x + width * 0.42f + ui.px(14), end = at.x + width;
  list.AddText({track_at, small_y}, ui.ink(Role::text_quiet), from.c_str());
  list.AddText({end - to_width, small_y}, ui.ink(Role::text_quiet), to.c_str());
  ImGui::PopFont();
  const Track track{track_at + from_width + ui.px(14), end - to_width - ui.px(14), middle};

  ImGui::SetCursorScreenPos({track.left - ui.px(10), at.y});
  ImGui::PushID(static_cast<int>(which));
  ImGui::InvisibleButton("slider", {std::max(track.right - track.left + ui.px(20), ui.px(30)), height});
  ImGui::PopID();
  ui.thing("slider " + slider.input);
  const bool focused = ImGui::IsItemFocused() && ImGui::GetIO().NavVisible;
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(0)) {
    const double share = (ImGui::GetIO().MousePos.x - track.left) / std::max(track.right - track.left, 1.0f);
    ui.send([which, x = on_steps(slider, share)](Player& p) { p.slide(which, x); });
  }
  if (ImGui::IsItemDeactivated()) ui.send([](Player& p) { p.end_slide(); });
  if (focused) take_keys(ui, which, slider);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::SetTooltip("%s from %s to %s%s\nArrow keys move it by a step", label.c_str(), from.c_str(), to.c_str(),
                      slider.step ? (", in steps of " + words_of(player, *slider.step)).c_str() : "");
  }
  draw_track(ui, slider, track, share_of(slider, *value), focused || ImGui::IsItemActive());
  ImGui::SetCursorScreenPos({at.x, at.y + height});
}

bool refused(const Player& player) { return player.slide_refused().slider < player.sliders().size(); }

void draw(Ui& ui) {
  const Player& player = ui.player();
  const float room = ImGui::GetContentRegionAvail().x;
  // Tab goes from one to the next, and shows where it came.
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);
  if (ImGui::IsWindowFocused() && pressed(ImGuiKey_Tab)) ImGui::GetCurrentContext()->NavDisableHighlight = false;
  // Back to where the lesson has them.
  const bool edited = player.session()->edited();
  const float reset = edited ? ImGui::CalcTextSize("Reset").x + 2 * ImGui::GetStyle().FramePadding.x + ui.px(12) : 0;
  const int columns = columns_for(ui, ui.units(room - reset));
  const float between = ui.px(28);
  const float width =
      std::floor((room - reset - static_cast<float>(columns - 1) * between) / static_cast<float>(columns));
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  for (std::size_t i = 0; i < player.sliders().size(); ++i) {
    const auto column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
    ImGui::SetCursorScreenPos({origin.x + static_cast<float>(column) * (width + between),
                               origin.y + static_cast<float>(row) * ui.px(row_height)});
    draw_slider(ui, i, width);
  }
  if (edited) {
    const ImVec2 next = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(
        {origin.x + room - reset + ui.px(12), origin.y + (ui.px(row_height) - ImGui::GetFrameHeight()) / 2});
    if (ui.button("Reset", "sliders reset", true, "Back to the lesson's numbers")) ui.act("edit.revert");
    ImGui::SetCursorScreenPos(next);
  }
  ImGui::PopItemFlag();
  if (!refused(player)) return;
  dialog_warning(ui, player.slide_refused().why);
  ui.thing("sliders refused");
}

double wanted(const Ui& ui, double width) {
  const auto count = static_cast<int>(ui.player().sliders().size());
  const int columns = columns_for(ui, width - 24 - (ui.player().session()->edited() ? 70 : 0));
  return 20 + row_height * ((count + columns - 1) / columns) + (refused(ui.player()) ? 22 : 0);
}

bool relevant(const Player& player) { return !player.sliders().empty(); }

}  // namespace

const Panel& panel_sliders() {
  static const Panel panel{"sliders", "Sliders", Slot::foot, 12, draw, relevant, wanted, 0, true};
  return panel;
}

}  // namespace blossom
