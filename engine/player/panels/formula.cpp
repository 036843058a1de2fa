// Where the step's value comes from: the formula with symbols, then with the numbers filled in, then the result.
#include <algorithm>

#include "algorithms/typeset.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

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

// The same at every step: the panels are not to move while one steps. Four lines, as most steps have.
double wanted(const Ui&, double) { return 134; }

// What this step says.
double tight(const Ui& ui, double width) {
  double content = 0;
  each_line(ui, [&](const std::string& text, double size, Role role) {
    double height = 0;
    ui.flow(text, width - 24, size, role, height);
    content += height + 6;
  });
  return std::clamp(content + 18, 44.0, wanted(ui, width));
}

}  // namespace

const Panel& panel_formula() {
  static const Panel panel{.id = "formula",
                           .title = "Formula",
                           .slot = Slot::side,
                           .order = 20,
                           .draw = draw,
                           .height = wanted,
                           .tight = tight};
  return panel;
}

}  // namespace blossom
