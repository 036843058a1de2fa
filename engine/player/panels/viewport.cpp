// The picture: looked at by dragging and turning the wheel, edited by dragging control points.
#include <cmath>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ViewSize size{ui.units(room.x), ui.units(room.y)};
  ui.send([size](Player& p) { p.set_view_size(size); });
  ViewportOptions options;
  options.camera = player.shown_camera();
  options.emphasis = player.emphasis();
  options.motion = player.motion();
  options.grid = player.settings.grid;
  ui.sheet("viewport", session.recording().scenes().viewport(session.step(), size.width, size.height, options),
           size.width, size.height);
}

}  // namespace

const Panel& panel_viewport() {
  static const Panel panel{"viewport", "Picture", Slot::main, 0, draw};
  return panel;
}

}  // namespace blossom
