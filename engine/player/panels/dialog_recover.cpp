// Edits that a crash left behind.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// When it was saved, as a person says it.
std::string age_of(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  if (error) return {};
  const auto minutes =
      std::chrono::duration_cast<std::chrono::minutes>(fs::file_time_type::clock::now() - written).count();
  const auto some = [](auto count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? " ago" : "s ago");
  };
  if (minutes < 2) return "just now";
  if (minutes < 120) return some(minutes, "minute");
  if (minutes < 48 * 60) return some(minutes / 60, "hour");
  return some(minutes / (24 * 60), "day");
}

void draw(Ui& ui) {
  if (!begin_dialog(ui, "Edits that were not saved", 600)) return;
  const auto& lost = ui.player().lost_work();
  quiet_text(ui, "The window closed before these were saved. Recover them to go on where you were.");
  const float below = ImGui::GetFrameHeightWithSpacing() + ui.px(12);
  const float row = 2 * ImGui::GetTextLineHeightWithSpacing() + ui.px(14);
  const float wanted = std::max(1.0f, static_cast<float>(lost.size())) * row;
  ImGui::BeginChild("lost", {0, std::min(wanted, dialog_room(ui, below))}, false, ImGuiWindowFlags_NavFlattened);
  for (std::size_t i = 0; i < lost.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    ImGui::PushID(static_cast<int>(i));
    const float buttons = ImGui::CalcTextSize("RecoverDiscard").x + 4 * ImGui::GetStyle().FramePadding.x +
                          2 * ImGui::GetStyle().ItemSpacing.x;
    const float y = ImGui::GetCursorPosY(), room = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(ui.bold());
    ImGui::TextUnformatted(
        shortened(lost[i].title.empty() ? "A lesson" : printable(lost[i].title), room - buttons).c_str());
    ImGui::PopFont();
    std::string detail = lost[i].step > 0 ? "step " + std::to_string(lost[i].step) : std::string("not saved");
    if (const std::string age = age_of(lost[i].file); !age.empty()) detail += ", " + age;
    if (!lost[i].origin.empty()) detail += ", of " + printable(lost[i].origin.string());
    ImGui::TextDisabled("%s", shortened(detail, room - buttons, false).c_str());
    ImGui::SetCursorPos({room - buttons + ImGui::GetStyle().ItemSpacing.x, y + ui.px(6)});
    if (ui.button("Recover", "recover " + number)) ui.send([i](Player& player) { player.recover(i); });
    if (i == 0) ImGui::SetItemDefaultFocus();
    ImGui::SameLine();
    if (ui.button("Discard", "discard " + number)) ui.send([i](Player& player) { player.forget_lost(i); });
    ImGui::SetCursorPosY(y + row);
    ImGui::PopID();
  }
  ImGui::Dummy({0, 0});
  ImGui::EndChild();
  if (lost.empty()) quiet_text(ui, "There is nothing to recover.");
  if (dialog_buttons(ui, "Later", true, nullptr)) close_dialog(ui);
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::recover; }

}  // namespace

const Panel& panel_dialog_recover() {
  static const Panel panel{"recover", "Lost edits", Slot::float_, 51, draw, is_relevant};
  return panel;
}

}  // namespace blossom
