#include "player/ui/studio_hands.hpp"

#include <cmath>

#include "player/action.hpp"

namespace blossom {
namespace {

constexpr double wheel_factor = 1.15;  // a notch
constexpr double click_reach = 7;      // page units around a curve that are it, too

struct MenuOf {
  Link link;
  bool requested = false;
};
MenuOf& menu_of() {
  static MenuOf menu;
  return menu;
}

const Studio& studio_of(const Ui& ui) { return *ui.player().studio(); }

std::optional<PointRef> point_of(const Spot* spot) {
  if (spot == nullptr || spot->link.kind != Link::Kind::object || spot->link.part == 0) return std::nullopt;
  return PointRef{spot->link.id, spot->link.part - 1};
}

// The thing under the mouse where there is no point.
std::optional<std::size_t> thing_at(const Ui& ui, const PaneOnScreen& on, const Spot* spot, glm::dvec2 at) {
  if (spot != nullptr && spot->link.kind == Link::Kind::object) return spot->link.id;
  const auto hit = studio_of(ui).hit_at(on.pane, on.mouse.size, at, click_reach);
  return hit ? std::optional(hit->object) : std::nullopt;
}

StudioGrip grip_on(const Ui& ui, const PaneOnScreen& on, glm::dvec2 at) {
  const Studio& studio = studio_of(ui);
  StudioGrip grip;
  grip.pane = on.pane;
  grip.size = on.mouse.size;
  grip.camera = studio.camera_of(on.pane, on.mouse.size);
  grip.start = at;
  grip.grid = studio.grid_of(on.pane, on.mouse.size);
  return grip;
}

void take(Ui& ui, StudioGrip grip, glm::dvec2 now) {
  ui.send([grip = std::move(grip), now, keys = grip_keys(ui.player())](Player& player) {
    Studio* studio = player.studio();
    if (studio == nullptr) return;
    if (grip.kind == StudioGrip::Kind::points && !studio->is_selected(grip.held)) studio->select({grip.held});
    if (grip.kind == StudioGrip::Kind::parameter) studio->choose(grip.object);
    StudioGrip taken = grip;
    if (grip.kind == StudioGrip::Kind::points || grip.kind == StudioGrip::Kind::handle)
      taken.points = studio->selected();
    taken.objects = studio->chosen();
    studio->take(std::move(taken));
    studio->drag(now, keys);
  });
}

// A drag begins: of what is under the place where the button went down.
void begin_drag(Ui& ui, const PaneOnScreen& on, int button) {
  const Studio& studio = studio_of(ui);
  const glm::dvec2 at = on.mouse.pressed(button);
  StudioGrip grip = grip_on(ui, on, at);
  grip.turns = button == 0 && on.pane == StudioPane::space;
  const Spot* spot = button == 0 && studio.tool() == Tool::choose ? spot_at(on.spots, at) : nullptr;
  if (spot != nullptr && spot->link.kind == Link::Kind::handle) {
    if (const auto centre = studio.centre()) {
      grip.kind = StudioGrip::Kind::handle;
      grip.handle = static_cast<Handle>(spot->link.id);
      grip.centre = *centre;
    }
  } else if (const auto point = point_of(spot)) {
    grip.kind = StudioGrip::Kind::points;
    grip.held = *point;
  } else if (button == 0 && studio.tool() == Tool::choose) {
    const auto hit = studio.hit_at(on.pane, on.mouse.size, at, click_reach);
    if (hit && hit->object == studio.current() && studio.object()->shows[Show::point]) {
      grip.kind = StudioGrip::Kind::parameter;
      grip.object = hit->object;
    } else if (ImGui::GetIO().KeyShift) {
      grip.kind = StudioGrip::Kind::box;
    }
  }
  take(ui, std::move(grip), on.mouse.now());
}

void click_to_draw(Ui& ui, const PaneOnScreen& on, bool twice) {
  if (twice) return ui.send([](Player& player) { player.studio()->finish_drawing(); });
  const Studio& studio = studio_of(ui);
  const double grid = grip_keys(ui.player()).snap ? studio.grid_of(on.pane, on.mouse.size) : 0;
  const auto place = studio.place_at(on.pane, on.mouse.size, on.mouse.now(), grid);
  if (!place) return;
  ui.send([at = *place, pane = on.pane, camera = studio.camera_of(on.pane, on.mouse.size)](Player& player) {
    // Fitted to what is drawn, the view would change below the mouse.
    player.studio()->cameras[static_cast<std::size_t>(pane)] = camera;
    player.studio()->click(at);
  });
}

void click(Ui& ui, const PaneOnScreen& on) {
  const Studio& studio = studio_of(ui);
  const ImGuiIO& io = ImGui::GetIO();
  const Spot* spot = spot_at(on.spots, on.mouse.now());
  const auto point = point_of(spot);
  const bool also = io.KeyShift || io.KeyCtrl;
  switch (studio.tool()) {
    case Tool::draw:
      return click_to_draw(ui, on, io.MouseClickedLastCount[0] >= 2);
    case Tool::insert:
      return ui.send([pane = on.pane, size = on.mouse.size, at = on.mouse.now()](Player& player) {
        const auto refused = player.studio()->refusals();
        if (!player.studio()->insert_at(pane, size, at, 2 * click_reach) && player.studio()->refusals() == refused)
          player.notice("Click on the polygon of the current curve.");
      });
    case Tool::erase:
      if (point)
        ui.send([ref = *point](Player& player) {
          player.studio()->select({ref});
          player.studio()->remove();
        });
      return;
    case Tool::choose:
      break;
  }
  if (spot != nullptr && spot->link.kind == Link::Kind::handle) return;
  if (point) return ui.send([ref = *point, also](Player& player) { player.studio()->select({ref}, also); });
  if (const auto thing = thing_at(ui, on, spot, on.mouse.now()))
    ui.send([which = *thing, also](Player& player) { player.studio()->choose(which, also); });
  else if (!also)
    ui.send([](Player& player) { player.studio()->select({}); });
}

void open_menu(Ui& ui, const PaneOnScreen& on) {
  const Spot* spot = spot_at(on.spots, on.mouse.now());
  Link link;
  if (const auto point = point_of(spot)) {
    link = spot->link;
    ui.send([ref = *point](Player& player) {
      if (!player.studio()->is_selected(ref)) player.studio()->select({ref});
    });
  } else if (const auto thing = thing_at(ui, on, spot, on.mouse.now())) {
    link = {Link::Kind::object, static_cast<std::uint32_t>(*thing), 0};
    ui.send([which = *thing](Player& player) {
      const auto& chosen = player.studio()->chosen();
      if (std::ranges::find(chosen, which) == chosen.end()) player.studio()->choose(which);
    });
  }
  menu_of() = {link, true};
}

std::string text_of(const Point<Exact>& p, bool flat) {
  std::string text = "(" + format_short(p.x.to_double(), 3) + ", " + format_short(p.y.to_double(), 3);
  return text + (flat ? ")" : ", " + format_short(p.z.to_double(), 3) + ")");
}

bool is_flat(const Geometry& geometry) {
  const auto* curve = std::get_if<Curve<Exact>>(&geometry);
  return curve != nullptr && curve->dimension == 2;
}

// What the held thing is now, beside the mouse.
std::string words_of(const Studio& studio) {
  const StudioGrip& grip = *studio.held();
  if (!studio.problems().empty()) return studio.problems()[0].message;
  if (grip.kind == StudioGrip::Kind::points && grip.held.object < studio.workspace().objects.size()) {
    const SceneObject& object = studio.workspace().objects[grip.held.object];
    const auto at = place_of(object.geometry, grip.held.point);
    const std::string name = object.name + " " + point_name(object.geometry, grip.held.point);
    return at ? name + " = " + text_of(*at, is_flat(object.geometry)) : name;
  }
  if (grip.kind == StudioGrip::Kind::parameter) {
    std::string text = "u = " + format_short(studio.u(), 3);
    if (studio.object() != nullptr && std::holds_alternative<Surface<Exact>>(studio.object()->geometry))
      text = "(u, v) = (" + format_short(studio.u(), 3) + ", " + format_short(studio.v(), 3) + ")";
    return text;
  }
  if (grip.kind == StudioGrip::Kind::handle) {
    const Placement made = placement(grip, studio.held_at(), studio.held_keys());
    const int id = static_cast<int>(grip.handle);
    if (id < 4) return "by " + text_of(made.move, false);
    if (grip.handle == Handle::scale) return "× " + format_short(made.scale.x.to_double(), 2);
    const int axis = id - 4;
    return format_short(made.turn[axis].to_double(), 0) + "° about " + "xyz"[axis];
  }
  return {};
}

std::string hint_of(const Studio& studio) {
  if (studio.riding()) return "Riding along " + studio.object()->name + "   ·   Space or Esc: get off";
  if (const StudioGrip* grip = studio.held()) {
    switch (grip->kind) {
      case StudioGrip::Kind::points:
        return "Shift: along an axis   ·   Ctrl: on the grid   ·   Esc: put it back";
      case StudioGrip::Kind::handle:
        return "Ctrl: in steps   ·   Esc: put it back";
      case StudioGrip::Kind::box:
        return "The points in the box   ·   Ctrl: also";
      default:
        return {};
    }
  }
  switch (studio.tool()) {
    case Tool::draw:
      return studio.clicked().empty() ? "Click: the first point of a curve   ·   Esc: put the tool away"
                                      : "Click: the next point   ·   Enter or double click: done   ·   Esc: take back";
    case Tool::insert:
      return studio.object() != nullptr
                 ? "Click on the polygon of " + studio.object()->name + ": a point   ·   Esc: put the tool away"
                 : "Choose a curve first   ·   Esc: put the tool away";
    case Tool::erase:
      return "Click a point: it goes   ·   Esc: put the tool away";
    case Tool::choose:
      break;
  }
  return {};
}

}  // namespace

void handle_pane_mouse(Ui& ui, const PaneOnScreen& on) {
  const Studio& studio = studio_of(ui);
  const Mouse& mouse = on.mouse;
  const ImGuiIO& io = ImGui::GetIO();
  if (studio.holding()) {
    const StudioGrip* grip = studio.held();
    if (!ImGui::IsMouseDown(0) && !ImGui::IsMouseDown(1) && !ImGui::IsMouseDown(2)) {
      if (grip == nullptr || grip->pane == on.pane) ui.send([](Player& player) { player.studio()->let_go(); });
    } else if (grip != nullptr && grip->pane == on.pane) {
      const GripKeys keys = grip_keys(ui.player()), before = studio.held_keys();
      if (mouse.now() != studio.held_at() || keys.along != before.along || keys.snap != before.snap)
        ui.send([now = mouse.now(), keys](Player& player) { player.studio()->drag(now, keys); });
    }
    return;
  }
  for (const int button : {0, 1, 2})
    if (mouse.owns(button) && mouse.dragged(button)) return begin_drag(ui, on, button);
  if (!mouse.over()) return;
  if (io.MouseWheel != 0) {
    const Camera closer =
        zoomed(studio.camera_of(on.pane, mouse.size), mouse.size, mouse.now(), std::pow(wheel_factor, io.MouseWheel));
    ui.send([closer, pane = on.pane](Player& player) {
      player.studio()->cameras[static_cast<std::size_t>(pane)] = closer;
    });
  }
  const Spot* spot = spot_at(on.spots, mouse.now());
  if (spot == nullptr && studio.tool() == Tool::choose)
    if (const auto thing = thing_at(ui, on, nullptr, mouse.now()))
      ui.light({Link::Kind::object, static_cast<std::uint32_t>(*thing), 0});
  if (spot != nullptr && studio.tool() != Tool::draw) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1))
    if (studio.pane != on.pane) ui.send([pane = on.pane](Player& player) { player.studio()->pane = pane; });
  if (ImGui::IsMouseReleased(0) && !mouse.dragged(0) && mouse.inside(mouse.pressed(0))) click(ui, on);
  if (ImGui::IsMouseReleased(1) && !mouse.dragged(1) && mouse.inside(mouse.pressed(1))) open_menu(ui, on);
}

void add_rubber_line(View& view, const Ui& ui, StudioPane pane, const Mouse& mouse) {
  const Studio& studio = studio_of(ui);
  if (studio.tool() != Tool::draw || studio.holding()) return;
  const auto& clicked = studio.clicked();
  if (clicked.size() == 1)
    view.markers.push_back({in_world(clicked.front()), Role::highlight, Marker::Shape::disc, 1.2});
  if (!mouse.over()) return;
  const double grid = grip_keys(ui.player()).snap ? studio.grid_of(pane, mouse.size) : 0;
  const auto place = studio.place_at(pane, mouse.size, mouse.now(), grid);
  if (!place) return;
  view.markers.push_back({in_world(*place), Role::highlight, Marker::Shape::ring, 1.1});
  if (clicked.empty()) return;
  Polyline line;
  line.points = {in_world(clicked.back()), in_world(*place)};
  line.role = Role::highlight;
  line.dashed = true;
  view.polylines.push_back(std::move(line));
}

void draw_pane_words(Ui& ui, const PaneOnScreen& on) {
  const Studio& studio = studio_of(ui);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const StudioGrip* grip = studio.held();
  const bool here = grip != nullptr ? grip->pane == on.pane : studio.pane == on.pane || !studio.four_panes;
  if (!here) return;
  const ImVec2 origin = on.mouse.origin;
  if (const std::string hint = hint_of(studio); !hint.empty()) {
    const ImVec2 corner{origin.x + ui.px(2), origin.y + ui.px(on.mouse.size.height - 2)};
    draw_tag(ui, list, corner, hint, Role::text_quiet, {corner.x, on.low.y}, {on.high.x, corner.y});
  }
  if (grip == nullptr) return;
  const auto at = [&](glm::dvec2 p) { return ImVec2{origin.x + ui.px(p.x), origin.y + ui.px(p.y)}; };
  if (grip->kind == StudioGrip::Kind::box) {
    const ImVec2 a = at(grip->start), b = at(studio.held_at());
    const ImVec2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
    list.AddRectFilled(low, high, ui.color(Role::highlight, 0.12));
    list.AddRect(low, high, ui.color(Role::highlight), 0, 0, ui.px(1));
  }
  const std::string words = words_of(studio);
  if (words.empty()) return;
  const bool refused = !studio.problems().empty();
  draw_tag(ui, list, at(studio.held_at() + glm::dvec2{16, 16}), words, refused ? Role::mistake : Role::text, on.low,
           on.high);
}

void draw_studio_menu(Ui& ui) {
  MenuOf& menu = menu_of();
  if (std::exchange(menu.requested, false)) ImGui::OpenPopup("studio menu");
  // The panel itself has no margin.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(8)});
  const bool open = ImGui::BeginPopup("studio menu");
  ImGui::PopStyleVar();
  if (!open) return;
  const Studio& studio = studio_of(ui);
  const auto item = [&](const char* label, const char* action) {
    const Action* found = find_action(action);
    const bool enabled = found->enabled == nullptr || found->enabled(ui.player());
    const std::string key(found->keys.empty() ? std::string_view() : found->keys.front());
    if (ImGui::MenuItem(label, key.c_str(), false, enabled)) ui.act(action);
    ui.thing("menu item " + std::string(action));
  };
  const bool thing = menu.link.kind == Link::Kind::object && menu.link.id < studio.workspace().objects.size();
  if (thing) {
    const SceneObject& object = studio.workspace().objects[menu.link.id];
    const bool point = menu.link.part > 0;
    std::string title = object.name;
    if (point && studio.selected().size() > 1)
      title = std::to_string(studio.selected().size()) + " points";
    else if (point)
      title += " " + point_name(object.geometry, menu.link.part - 1);
    ImGui::TextDisabled("%s", title.c_str());
    if (point) {
      item("Delete", "studio.delete");
      item("Select all points", "studio.all_points");
    } else {
      item(object.recipe ? "How was this made? Step it" : "Step with an algorithm ...", "studio.step");
      if (object.recipe) item("Step with another algorithm ...", "studio.step_with");
      ImGui::Separator();
      item("Duplicate", "studio.duplicate");
      item(object.hidden ? "Show" : "Hide", "studio.hide");
      item("Select all points", "studio.all_points");
      item("Delete", "studio.delete");
    }
    ImGui::Separator();
  }
  item("Draw a curve", "studio.draw");
  item("Handles to move, turn and scale", "studio.gizmo");
  item("Show all that is hidden", "studio.show_all");
  item("Fit all into the view", "view.fit");
  ImGui::EndPopup();
}

}  // namespace blossom
