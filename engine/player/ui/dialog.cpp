#include "player/ui/dialog.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "base/utf8.hpp"

namespace blossom {

namespace fs = std::filesystem;

// ---- the window -----------------------------------------------------------------------------------------------------

bool begin_dialog(Ui& ui, const char* title, double width) {
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float margin = ui.px(12);
  const float wide = std::min(ui.px(width), screen.x - 2 * margin);
  ImGui::SetNextWindowPos({std::round(screen.x / 2), std::round(screen.y / 2)}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({wide, 0});
  ImGui::SetNextWindowSizeConstraints({wide, 0}, {wide, screen.y - 2 * margin});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(18), ui.px(14)});
  const bool open = ImGui::BeginPopupModal(title, nullptr,
                                           ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                               ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  if (!open) return false;
  // Dimmed at once: the frames of a fade would be drawn for nothing else.
  ImGui::GetCurrentContext()->DimBgRatio = 1;
  if (ImGui::IsWindowAppearing()) ImGui::GetCurrentContext()->NavDisableHighlight = false;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) close_dialog(ui);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ui.thing("dialog", low, {low.x + size.x, low.y + size.y});
  ImGui::PushFont(ui.bold());
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::Dummy({0, ui.px(2)});
  return true;
}

void end_dialog() { ImGui::EndPopup(); }

bool dialog_opens() { return ImGui::IsWindowAppearing(); }

float dialog_room(const Ui& ui, float below) {
  const float used = ImGui::GetCursorPosY() + ImGui::GetScrollY() + ImGui::GetStyle().WindowPadding.y;
  return std::max(ImGui::GetIO().DisplaySize.y - ui.px(24) - used - below - ui.px(16), ui.px(60));
}

void close_dialog(Ui& ui) {
  ui.send([](Player& player) { player.cancel_dialog(); });
}

// ---- its parts ------------------------------------------------------------------------------------------------------

bool dialog_field(Ui& ui, const char* label, const std::string& name, std::string& text, bool first, const char* hint,
                  ImGuiInputTextFlags flags, ImGuiInputTextCallback callback, void* data) {
  if (label[0] != '\0') ImGui::TextUnformatted(label);
  if (first && ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushID(name.c_str());
  const bool entered =
      ImGui::InputTextWithHint("##field", hint, &text, flags | ImGuiInputTextFlags_EnterReturnsTrue, callback, data);
  ImGui::PopID();
  ui.thing(name);
  // Where one types is to be seen also after a click.
  if (ImGui::IsItemActive() && !ImGui::GetIO().NavVisible) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect(low, high, ui.color(Role::focus), ui.px(4), 0, ui.px(1.5));
  }
  return entered;
}

bool dialog_buttons(Ui& ui, const char* main, bool enabled, const char* cancel) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto width_of = [&](const char* label) {
    return std::max(ImGui::CalcTextSize(label).x + 2 * style.FramePadding.x, ui.px(84));
  };
  const float main_width = width_of(main), cancel_width = cancel != nullptr ? width_of(cancel) : 0;
  ImGui::Dummy({0, ui.px(4)});
  const float used = main_width + (cancel != nullptr ? cancel_width + style.ItemSpacing.x : 0);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - used));
  if (cancel != nullptr) {
    if (ImGui::Button(cancel, {cancel_width, 0})) close_dialog(ui);
    ui.thing("dialog cancel");
    ImGui::SameLine();
  }
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  ImGui::PushFont(ui.bold());
  bool pressed = ImGui::Button(main, {main_width, 0});
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::SetItemDefaultFocus();
  ImGui::EndDisabled();
  ui.thing("dialog ok");
  const bool somewhere = ImGui::IsAnyItemActive() || (ImGui::GetIO().NavVisible && ImGui::IsAnyItemFocused());
  if (enabled && !somewhere && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) pressed = true;
  return pressed;
}

bool radio(Ui& ui, const std::string& label, const std::string& name, bool chosen) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(name.c_str());
  const bool pressed = ImGui::RadioButton(label.c_str(), chosen);
  ImGui::PopID();
  const float half = ImGui::GetFrameHeight() / 2;
  ImGui::GetWindowDrawList()->AddCircle({at.x + half, at.y + half}, half - ui.px(0.5), ui.color(Role::polygon), 0,
                                        ui.px(1));
  ui.thing(name);
  return pressed;
}

void dialog_warning(Ui& ui, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::mistake));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(("\u25B2 " + text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void quiet_text(Ui& ui, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool choice(Ui& ui, const std::string& label, const std::string& detail, const std::string& name, bool chosen,
            bool enabled, bool scroll_to) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, pad = ui.px(6);
  ImGui::PushID(name.c_str());
  const bool pressed =
      ImGui::Selectable("##choice", chosen, enabled ? 0 : ImGuiSelectableFlags_Disabled, {0, ImGui::GetFrameHeight()});
  ImGui::PopID();
  if (ImGui::IsItemVisible()) ui.thing(name);
  if (scroll_to) ImGui::SetScrollHereY();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // Not by its tint alone.
  if (chosen)
    list.AddRectFilled(at, {at.x + ui.px(3), at.y + ImGui::GetFrameHeight()}, ui.color(Role::current), ui.px(1));
  const float y = at.y + (ImGui::GetFrameHeight() - ImGui::GetFontSize()) / 2;
  const std::string right = shortened(detail, room * 0.5f, true);
  const float right_width = right.empty() ? 0 : ImGui::CalcTextSize(right.c_str()).x + pad;
  const std::string left = shortened(label, room - right_width - 3 * pad);
  list.AddText({at.x + 1.5f * pad, y}, ui.ink(enabled ? Role::text : Role::text_quiet), left.c_str());
  if (!right.empty()) list.AddText({at.x + room - right_width, y}, ui.ink(Role::text_quiet), right.c_str());
  return pressed;
}

// ---- text -----------------------------------------------------------------------------------------------------------

std::string shortened(const std::string& text, float pixels, bool front) {
  if (ImGui::CalcTextSize(text.c_str()).x <= pixels) return text;
  const std::string dots = "\u2026";
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); i += std::max<std::size_t>(utf8_length(text, i), 1)) starts.push_back(i);
  const auto cut = [&](std::size_t kept) {
    if (kept == 0) return dots;
    return front ? dots + text.substr(starts[starts.size() - kept])
                 : text.substr(0, kept < starts.size() ? starts[kept] : text.size()) + dots;
  };
  std::size_t low = 0, high = starts.size();
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    (ImGui::CalcTextSize(cut(middle).c_str()).x <= pixels ? low : high) = middle;
  }
  return cut(low);
}

std::vector<std::string> wrapped(const std::string& text, float pixels, std::size_t most_lines) {
  std::vector<std::string> lines;
  const char* from = text.c_str();
  const char* end = from + text.size();
  while (from < end && lines.size() < most_lines) {
    if (lines.size() + 1 == most_lines) {
      lines.push_back(shortened(std::string(from, end), pixels));
      break;
    }
    const char* to =
        ImGui::GetFont()->CalcWordWrapPositionA(ImGui::GetFontSize() / ImGui::GetFont()->FontSize, from, end, pixels);
    if (to == from) to += std::max<std::size_t>(utf8_length(text, static_cast<std::size_t>(from - text.c_str())), 1);
    lines.emplace_back(from, to);
    from = to;
    while (from < end && (*from == ' ' || *from == '\n')) ++from;
  }
  return lines;
}

bool contains(std::string_view text, std::string_view part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

// ---- files ----------------------------------------------------------------------------------------------------------

fs::path typed_path(const fs::path& folder, const std::string& text) {
  const char* home = std::getenv("HOME");
  if (home != nullptr && (text == "~" || text.starts_with("~/")))
    return fs::path(home) / text.substr(std::min<std::size_t>(text.size(), 2));
  return (folder / text).lexically_normal();
}

fs::path folder_to_save(const Player& player) {
  std::error_code error;
  if (player.session() != nullptr || player.studio() != nullptr) {
    const fs::path folder =
        (player.session() != nullptr ? player.session()->document().file : player.studio()->file()).parent_path();
    if (!folder.empty() && ::access(folder.c_str(), W_OK) == 0) return folder;
  }
  return fs::current_path(error);
}

fs::path Target::path() const { return typed_path(folder, text); }

bool Target::exists() const {
  std::error_code error;
  return !text.empty() && fs::exists(path(), error);
}

std::string Target::wrong(const std::vector<std::string>& extensions) const {
  std::error_code error;
  if (text.empty()) return "Give the file a name.";
  const fs::path file = path();
  if (fs::is_directory(file, error)) return "This is a folder; add the name of a file.";
  if (std::ranges::find(extensions, file.extension().string()) == extensions.end()) {
    std::string list;
    for (const std::string& extension : extensions) list += (list.empty() ? "" : " or ") + extension;
    return "The name must end in " + list + ".";
  }
  if (!fs::is_directory(file.parent_path(), error))
    return "There is no folder " + printable(file.parent_path().string()) + ".";
  return {};
}

bool Target::confirm() {
  if (!exists() || asks()) return true;
  armed = text;
  return false;
}

std::optional<fs::path> ask_to_save(Ui& ui, Target& file, const std::string& wrong, bool entered) {
  const bool asks = wrong.empty() && file.asks();
  if (!wrong.empty())
    dialog_warning(ui, wrong);
  else if (asks)
    dialog_warning(ui, "There is a file of this name already. Press Replace to write over it.");
  else
    ImGui::TextUnformatted("");
  const bool pressed = dialog_buttons(ui, asks ? "Replace" : "Save", wrong.empty());
  return (pressed || entered) && wrong.empty() && file.confirm() ? std::optional(file.path()) : std::nullopt;
}

}  // namespace blossom
