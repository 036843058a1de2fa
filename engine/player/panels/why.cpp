// "Why?": where a value comes from, down to what was given.
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

constexpr double indent = 18, text_size = 0.92;
constexpr std::size_t most_lines = 400;

std::string reason(const StepSource& source, const WhyLine& line) {
  std::string text = source.graph->name(line.value) + " = ";
  if (line.given) return text + source.value_text(line.value) + ", given";
  if (line.told_above) return text + source.value_text(line.value) + ", see above";
  return text + source.formula(line.value) + " = " + source.made_text(line.value);
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  const StepSource& source = session.recording().source();
  std::optional<ValueId> asked = ui.player().why_asked();
  if (!asked) {
    const ValueId main = source.graph->main_value(session.step());
    if (main != absent && !source.graph->is_input(main)) asked = main;
  }
  if (!asked) {
    ImGui::TextWrapped("Point at a value and press W: here it says where it comes from, down to the control points.");
    return;
  }
  ImGui::BeginChild("chain", {0, 0}, false, ImGuiWindowFlags_NoNavInputs);
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  // A value of a later step is not told before it is there; its formula would give it away.
  if (source.graph->value(*asked).step > session.step()) {
    ImGui::TextWrapped("%s is made at step %u.", source.graph->name(*asked).c_str(), source.graph->value(*asked).step);
    if (ui.button("Go there", "why go")) {
      ui.send([step = source.graph->value(*asked).step](Player& p) { p.seek(step); });
    }
  } else {
    const auto lines = why(*source.graph, *asked, most_lines);
    for (const WhyLine& line : lines) {
      const double x = std::min(line.depth * indent, width * 0.4);
      double height = 0;
      Sheet sheet = ui.flow(reason(source, line), width - x - 4, text_size,
                            line.given || line.told_above ? Role::text_quiet : Role::text, height);
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(x));
      const ImVec2 at = ImGui::GetCursorScreenPos();
      if (line.depth > 0)
        ImGui::GetWindowDrawList()->AddLine({at.x - ui.px(9), at.y}, {at.x - ui.px(9), at.y + ui.px(height)},
                                            ui.color(Role::rule_line), ui.px(1.5));
      ImGui::PushID(static_cast<int>(&line - lines.data()));
      ui.sheet("why", std::move(sheet), width - x, height);
      ImGui::PopID();
    }
    if (lines.size() >= most_lines) ImGui::TextDisabled("... and so on");
  }
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_why() {
  static const Panel panel{"why", "Why?", Slot::tabs, 40, draw};
  return panel;
}

}  // namespace blossom
