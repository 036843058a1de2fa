// Speed, curvature and torsion over u; the partition of unity.
#include "player/panels/mouse.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  const SceneObject* object = studio.object();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const double width = ui.units(room.x), height = ui.units(room.y);
  if (object == nullptr || width < 80 || height < 60) return;
  Sheet sheet;
  double y = 0;
  const bool is_curve = std::holds_alternative<Curve<Exact>>(object->geometry);
  if (is_curve || std::holds_alternative<Surface<Exact>>(object->geometry))
    y += add_partition_bar(sheet, object->geometry, studio.u(), studio.v(), 4, 4, width - 8) + 10;
  if (is_curve) {
    const auto curve = convert<double>(std::get<Curve<Exact>>(object->geometry));
    std::vector<CurvePlot> plots{CurvePlot::speed, CurvePlot::curvature};
    if (curve.dimension == 3) plots.push_back(CurvePlot::torsion);
    add_curve_plots(sheet, curve, studio.u(), plots, 4, y, width - 8, std::max(height - y - 4, 60.0));
  }
  ui.sheet("plots", std::move(sheet), width, height);
}

bool relevant(const Player& player) {
  const SceneObject* object = player.studio()->object();
  return object != nullptr && (std::holds_alternative<Curve<Exact>>(object->geometry) ||
                               std::holds_alternative<Surface<Exact>>(object->geometry));
}

}  // namespace

const Panel& panel_studio_plots() {
  static const Panel panel{"plots", "Plots", Slot::tabs, 40, draw, relevant, nullptr, 0, false, true};
  return panel;
}

}  // namespace blossom
