// "Why?": where a value comes from, down to what was given.
#include "algorithms/formula_words.hpp"
#include "algorithms/typeset.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

constexpr double indent = 18, text_size = 0.92;
constexpr std::size_t most_lines = 400;

// A value is called as in the formula of `user`, which it is an operand of, so that one finds it there.
std::string reason(const StepSource& source, const WhyLine& line, ValueId user) {
  std::string name = source.own_name(line.value);
  if (user != absent)
    if (std::string called = source.operand_name(user, line.value); called.size() > name.size())
      name = std::move(called);
  std::string text = name + " = ";
  if (line.given) return text + source.value_text(line.value) + ", given";
  if (line.told_above) return text + source.value_text(line.value) + ", see above";
  // What is put into words is no side of an equation: the value comes first.
  const std::string formula = source.formula(line.value), made = source.made_text(line.value);
  return text + (is_sentence(formula) ? made + ": " + formula : formula + " = " + made);
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
    const ValueRecord& record = source.graph->value(*asked);
    ImGui::TextWrapped("%s is made at step %u.", plain_name(record.name, source.algorithm_at(record.step)).c_str(),
                       record.step);
    if (ui.button("Go there", "why go")) {
      ui.send([step = source.graph->value(*asked).step](Player& p) { p.seek(step); });
    }
  } else {
    ImGui::Dummy({0, ui.px(3)});  // superscripts of the first line rise above it
    const auto lines = why(*source.graph, *asked, most_lines);
    std::vector<ValueId> users;  // of the lines around this one, by depth
    for (const WhyLine& line : lines) {
      const auto depth = static_cast<std::size_t>(line.depth);
      users.resize(depth);
      const ValueId user = depth > 0 ? users.back() : absent;
      users.push_back(line.value);
      // What is given is said once.
      if (line.told_above && source.graph->is_input(line.value)) continue;
      const double x = std::min(line.depth * indent, width * 0.4);
      double height = 0;
      Sheet sheet = ui.flow(reason(source, line, user), width - x - 4, text_size,
                            line.given || line.told_above ? Role::text_quiet : Role::text, height, true, line.value);
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
