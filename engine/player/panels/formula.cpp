// Where the step's value comes from: the formula with symbols, then with the numbers filled in, then the result.
#include <algorithm>
#include <cmath>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"
#include "scene/typeset.hpp"

namespace blossom {
namespace {

// Calls say(text, size, role) for each line; false: the step makes nothing.
template <class Say>
bool each_line(const Ui& ui, const Say& say) {
  const Session& session = *ui.player().session();
  const StepSource& source = session.recording().source();
  const ValueId v = source.graph->main_value(session.step());
  if (v == absent || source.graph->is_input(v)) return false;
  const std::string name = source.own_name(v), formula = source.formula(v), numbers = source.numbers(v);
  const std::string value = source.value_text(v), made = source.made_text(v);
  say(name + " = " + formula, 1.1, Role::text);
  if (numbers != formula && numbers != value) say("= " + numbers, 1, Role::text);
  // Of a rational curve it is the homogeneous point that the formula gives.
  say("= " + made, made != value ? 1 : 1.15, Role::text_current);
  if (const std::string polar = source.polar(v); !polar.empty()) say("blossom value " + polar, 0.9, Role::text_quiet);
  return true;
}

void draw(Ui& ui) {
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  const bool any = each_line(ui, [&](const std::string& text, double size, Role role) {
    double height = 0;
    Sheet sheet = ui.flow(text, width, size, role, height);
    ui.sheet("formula", std::move(sheet), width, height);
  });
  if (!any)
    ImGui::TextDisabled("%s", ui.player().session()->step() == 0 ? "What is given." : "A new part begins here.");
}

// In coarse steps, so that the panels do not move at each step of the run.
double wanted(const Ui& ui, double width) {
  if (ui.player().session()->step() == 0) return 40;
  double height = 16;
  each_line(ui, [&](const std::string& text, double size, Role role) {
    double part = 0;
    ui.flow(text, width - 22, size, role, part);
    height += part + 6;
  });
  return std::clamp(std::ceil(height / 40) * 40, 120.0, 280.0);
}

}  // namespace

const Panel& panel_formula() {
  static const Panel panel{"formula", "Formula", Slot::side, 20, draw, nullptr, wanted};
  return panel;
}

}  // namespace blossom
