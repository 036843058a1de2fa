#include "player/ui/studio_fields.hpp"

#include <algorithm>

namespace blossom {

bool StudioFields::number(const NumberField& field, StudioNumberEdit edit) {
  return number_field(field, [&]() -> TakeNumber {
    return [edit](Player& player, const Exact& x, const std::string& what, const std::string& gesture) {
      Studio& studio = *player.studio();
      return studio.edit(edit(studio.workspace(), x), what, gesture);
    };
  });
}

void StudioFields::send(const std::string& path, const std::string& what, StudioEdit edit, const std::string& gesture) {
  send_edit(
      path, what,
      [edit = std::move(edit)](Player& player, const std::string& said, const std::string& held) {
        Studio& studio = *player.studio();
        return studio.edit(edit(studio.workspace()), said, held);
      },
      gesture);
}

FieldTexts* StudioModel::texts(Player& player) const {
  return player.studio() != nullptr ? &player.studio()->fields : nullptr;
}
const FieldTexts& StudioModel::texts(const Player& player) const { return player.studio()->fields; }
const Diagnostics& StudioModel::rejected(const Player& player) const { return player.studio()->problems(); }
void StudioModel::forget_rejected(Player& player) const { player.studio()->forget_problems(); }

void send_studio(Ui& ui, std::function<void(Studio&)> what) {
  ui.send([what = std::move(what)](Player& player) {
    if (player.studio() != nullptr) what(*player.studio());
  });
}

void color_chip(const Ui& ui, int color, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), top = at.y + (height - side) / 2;
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side}, ui.color(object_role(color)),
                                            ui.px(3));
  ImGui::Dummy({side, height});
}

std::optional<double> share_slider(Ui& ui, const std::string& name, double value, double low, double high,
                                   float width) {
  // The slider knows shares only, as the range may be wider than ImGui can reckon with.
  double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0;
  constexpr double none = 0, all = 1;
  ImGui::SetNextItemWidth(width);
  const bool moved =
      ImGui::SliderScalar(("##" + name).c_str(), ImGuiDataType_Double, &share, &none, &all, "",
                          ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
  ui.thing(name);
  if (ImGui::IsItemDeactivated()) send_studio(ui, [](Studio& studio) { studio.end_gesture(); });
  return moved ? std::optional(low * (1 - share) + high * share) : std::nullopt;
}

std::optional<std::size_t> combo(Ui& ui, const std::string& name, const std::vector<std::string>& names,
                                 std::size_t current, float width) {
  std::optional<std::size_t> taken;
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo(("##" + name).c_str(), current < names.size() ? names[current].c_str() : "")) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (ImGui::Selectable((names[i] + "##" + std::to_string(i)).c_str(), i == current) && i != current) taken = i;
      ui.thing(name + " " + names[i]);
    }
    ImGui::EndCombo();
  } else {
    ui.thing(name);
  }
  return taken;
}

}  // namespace blossom
