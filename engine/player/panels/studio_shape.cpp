// The current thing in numbers: its kind, degree, control points, weights and knots.
#include <algorithm>
#include <cmath>

#include "player/ui/curve_fields.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

const StudioModel model("shape");

// Some functions of edit:: exist for curves and surfaces alike: a lambda that takes either.
template <class Geometry, class Edit>
StudioEdit changing(std::size_t object, Edit edit) {
  return [=](const Workspace& w) -> Worked {
    if (object >= w.objects.size()) return Diagnostics{};
    return blossom::edit::change(
        w, object, std::function<Checked<Geometry>(Geometry)>([=](Geometry g) { return edit(std::move(g)); }));
  };
}

std::string path_of(std::size_t object, const std::string& rest) {
  return "objects[" + std::to_string(object) + "]." + rest;
}

constexpr std::array<CurveKind, 4> kinds = {CurveKind::bezier, CurveKind::rational_bezier, CurveKind::bspline,
                                            CurveKind::nurbs};
const std::vector<std::string>& kind_titles() {
  static const std::vector<std::string> titles{"B\u00e9zier", "rational B\u00e9zier", "B-spline", "NURBS"};
  return titles;
}
template <class Geometry>
std::size_t kind_index(const Geometry& g) {
  return (g.bezier ? 0u : 2u) + (g.rational ? 1u : 0u);
}

void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine();
}

// Goes on beside the last item if this label and a stepper fit there, as they do not with large text.
void beside_if_fits(const Ui& ui, const char* text) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float stepper = 2 * ImGui::GetFrameHeight() + ui.px(36 + 2 * 3);
  const float needed = style.ItemSpacing.x + ImGui::CalcTextSize(text).x + style.ItemSpacing.x + stepper;
  const float end = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  if (ImGui::GetItemRectMax().x + needed <= end) ImGui::SameLine();
}

// ---- a table of points ----------------------------------------------------------------------------------------------

struct Table {
  float name = 0, number = 0, button = 0, gap = 0;
  int coordinates = 3;
  bool weights = true;
};

Table table_for(const Ui& ui, int dimension, bool weights, std::size_t widest_index, float room, int buttons) {
  Table table;
  table.coordinates = dimension;
  table.weights = weights;
  table.gap = ui.px(4);
  table.name = ImGui::CalcTextSize(with_subscript("P", widest_index).c_str()).x + ui.px(10);
  table.button = ImGui::GetFrameHeight();
  const int numbers = dimension + (weights ? 1 : 0);
  const float rest = room - table.name - static_cast<float>(buttons) * (table.button + table.gap) -
                     static_cast<float>(numbers + 1) * table.gap;
  table.number = std::clamp(std::floor(rest / static_cast<float>(numbers)), ui.px(42), ui.px(120));
  return table;
}

void draw_titles(const Ui& ui, const Table& table) {
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
  const float left = ImGui::GetCursorPosX() + table.name + table.gap;
  const char* const titles[] = {"x", "y", "z"};
  for (int k = 0; k < table.coordinates + (table.weights ? 1 : 0); ++k) {
    if (k > 0) ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(left + static_cast<float>(k) * (table.number + table.gap) + ImGui::GetStyle().FramePadding.x);
    ImGui::TextUnformatted(k < table.coordinates ? titles[k] : "weight");
  }
  ImGui::PopStyleColor();
}

const HPoint<Exact>& homogeneous(const Geometry& geometry, std::size_t i) {
  return std::visit([i](const auto& g) -> const HPoint<Exact>& { return g.points[i]; }, geometry);
}

// Its name as a button that selects it, its coordinates and its weight.
void draw_point(Ui& ui, StudioFields& fields, const Studio& studio, const Table& table, std::size_t i,
                const std::string& shown, const std::string& name) {
  const std::size_t object = *studio.current();
  const Geometry& geometry = studio.object()->geometry;
  const PointRef ref{object, i};
  const bool selected = std::ranges::find(studio.selected(), ref) != studio.selected().end();
  const float left = ImGui::GetCursorPosX();
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0, 0.5f});
  const bool pressed = ImGui::Selectable(shown.c_str(), selected, 0, {table.name, ImGui::GetFrameHeight()});
  ImGui::PopStyleVar();
  if (pressed)
    send_studio(ui,
                [ref, also = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl](Studio& s) { s.select({ref}, also); });
  ui.thing("shape " + name);
  const auto place = place_of(geometry, i);
  const auto column = [&](int k) {
    ImGui::SameLine(left + table.name + table.gap + static_cast<float>(k) * (table.number + table.gap), 0);
  };
  static constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
  for (int k = 0; k < table.coordinates; ++k) {
    column(k);
    const std::string axis = axes[static_cast<std::size_t>(k)];
    fields.number({path_of(object, "points[" + std::to_string(i) + "][" + std::to_string(k) + "]"), name + " " + axis,
                   place ? (*place)[k] : Exact(0), NumberStyle::coordinate, table.number, !place},
                  [ref, k](const Workspace& w, const Exact& x) -> Worked {
                    if (ref.object >= w.objects.size()) return Diagnostics{};
                    auto to = place_of(w.objects[ref.object].geometry, ref.point).value_or(Point<Exact>(0, 0, 0));
                    to[k] = x;
                    return edit::set_place(w, ref, to);
                  });
  }
  if (!table.weights) return;
  column(table.coordinates);
  const Exact& w = homogeneous(geometry, i).w;
  fields.number({path_of(object, "weights[" + std::to_string(i) + "]"), name + " weight", w, NumberStyle::parameter,
                 table.number, w == Exact(1)},
                [ref](const Workspace& scene, const Exact& x) { return edit::set_weight(scene, ref, x); });
}

// Only the rows that can be seen, and a few more so that Tab goes on.
template <class Row>
void clipped(std::size_t count, const Row& row) {
  const float height = ImGui::GetFrameHeightWithSpacing(), top = ImGui::GetCursorScreenPos().y;
  const ImVec2 low = ImGui::GetWindowDrawList()->GetClipRectMin(), high = ImGui::GetWindowDrawList()->GetClipRectMax();
  const auto n = static_cast<std::ptrdiff_t>(count);
  const auto first = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>((low.y - top) / height) - 2, 0, n);
  const auto last = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>((high.y - top) / height) + 3, first, n);
  if (first > 0) ImGui::Dummy({1, static_cast<float>(first) * height - ImGui::GetStyle().ItemSpacing.y});
  for (auto i = first; i < last; ++i) {
    ImGui::PushID(static_cast<int>(i));
    row(static_cast<std::size_t>(i));
    ImGui::PopID();
  }
  if (last < n) ImGui::Dummy({1, static_cast<float>(n - last) * height - ImGui::GetStyle().ItemSpacing.y});
}

// The weight of the selected point, from 0 to 20, small ones spread. Its line is there before a point is selected, or
// the table would move away from under the mouse.
void draw_weight_slider(Ui& ui, const Studio& studio) {
  if (studio.selected().size() != 1 || studio.selected().front().object != *studio.current()) {
    ImGui::AlignTextToFramePadding();
    return ImGui::TextDisabled("Weight: choose a point first");
  }
  const PointRef ref = studio.selected().front();
  const double w = homogeneous(studio.object()->geometry, ref.point).w.to_double();
  label("Weight");
  const float width = std::max(ImGui::GetContentRegionAvail().x, ui.px(60));
  if (const auto to = share_slider(ui, "shape weight slider", std::cbrt(w), 0, std::cbrt(20.0), width))
    send_studio(ui, [ref, to = *to](Studio& s) {
      s.edit(edit::set_weight(s.workspace(), ref, snapped(to * to * to, 0.01), true), "weight", "weight slider");
    });
}

// ---- knots ----------------------------------------------------------------------------------------------------------

void draw_knots(Ui& ui, StudioFields& fields, const std::vector<Exact>& U, const std::string& path,
                const std::string& name, float room, const std::function<StudioNumberEdit(std::size_t)>& edit_of) {
  std::size_t longest = 0;
  for (const Exact& u : U) longest = std::max(longest, number_text(u).size());
  const float width =
      std::clamp(static_cast<float>(longest) * ImGui::CalcTextSize("0").x + ui.px(14), ui.px(36), ui.px(76));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(2), ui.px(3)});
  const float left = ImGui::GetCursorPosX();
  float x = 0;
  for (std::size_t i = 0; i < U.size(); ++i) {
    const bool begins = i == 0 || U[i] != U[i - 1];
    const float gap = i == 0 ? 0 : begins ? ui.px(10) : ui.px(2);
    if (x > 0 && x + gap + width <= room) {
      ImGui::SameLine(left + x + gap, 0);
      x += gap + width;
    } else {
      x = width;
    }
    fields.number(
        {path + "[" + std::to_string(i) + "]", name + " " + std::to_string(i), U[i], NumberStyle::parameter, width},
        edit_of(i));
  }
  ImGui::PopStyleVar();
  fields.say();
}

// ---- curves and surfaces --------------------------------------------------------------------------------------------

void draw_curve(Ui& ui, StudioFields& fields, const Studio& studio, const Curve<Exact>& curve, float room) {
  const std::size_t object = *studio.current();
  label("Kind");
  if (const auto to = combo(ui, "shape kind", kind_titles(), kind_index(curve), ui.px(132)))
    fields.send(path_of(object, "kind"), "kind " + kind_titles()[*to],
                changing<Curve<Exact>>(
                    object, [kind = kinds[*to]](Curve<Exact> c) { return edit::set_kind(std::move(c), kind); }));
  beside_if_fits(ui, "Degree");
  label("Degree");
  const int most = curve.bezier ? max_degree : std::min(max_degree, curve.n());
  if (const auto degree = draw_stepper(ui, "shape degree", curve.degree, 1, most))
    fields.send(
        path_of(object, "degree"), "degree " + std::to_string(*degree),
        changing<Curve<Exact>>(object, [d = *degree](Curve<Exact> c) { return edit::set_degree(std::move(c), d); }));
  if (!curve.bezier) {
    label("Ends");
    static const std::vector<std::string> forms{"clamped", "open", "closed"};
    if (const auto to = combo(ui, "shape form", forms, static_cast<std::size_t>(form_of(curve)), ui.px(132)))
      fields.send(path_of(object, "form"), forms[*to],
                  changing<Curve<Exact>>(object, [form = static_cast<CurveForm>(*to)](Curve<Exact> c) {
                    return edit::set_form(std::move(c), form);
                  }));
    ImGui::SameLine();
  }
  bool spatial = curve.dimension == 3;
  if (ImGui::Checkbox("In space", &spatial))
    fields.send(path_of(object, "dimension"), spatial ? "in space" : "in the plane",
                changing<Curve<Exact>>(
                    object, [d = spatial ? 3 : 2](Curve<Exact> c) { return edit::set_dimension(std::move(c), d); }));
  ui.thing("shape spatial");
  fields.say();
  draw_weight_slider(ui, studio);
  const Table table = table_for(ui, curve.dimension, true, curve.points.size() - 1, room, 2);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(3)});
  draw_titles(ui, table);
  clipped(curve.points.size(), [&](std::size_t i) {
    const std::string name = "P" + std::to_string(i);
    draw_point(ui, fields, studio, table, i, with_subscript("P", i), name);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
    ImGui::SameLine(0, table.gap);
    if (ImGui::Button("+", {table.button, 0}))
      fields.send(path_of(object, "points"), "a point behind " + name, [=](const Workspace& w) -> Worked {
        const auto* c = object < w.objects.size() ? std::get_if<Curve<Exact>>(&w.objects[object].geometry) : nullptr;
        if (c == nullptr || i >= c->points.size()) return Diagnostics{};
        return edit::insert_point(w, {object, i}, place_behind(*c, i));
      });
    ui.thing("shape add " + name);
    ImGui::SameLine(0, table.gap);
    if (ImGui::Button("\u00d7", {table.button, 0}))
      fields.send(path_of(object, "points"), name + " deleted", [=](const Workspace& w) {
        return edit::delete_points(w, {{object, i}});
      });
    ui.thing("shape delete " + name);
    ImGui::PopStyleVar();
  });
  ImGui::PopStyleVar();
  fields.say();
  if (curve.bezier) return;
  ImGui::Dummy({0, ui.px(2)});
  ui.heading("Knots");
  draw_knots(ui, fields, curve.knots, path_of(object, "knots"), "knot", room, [object](std::size_t i) {
    return [object, i](const Workspace& w, const Exact& u) {
      return changing<Curve<Exact>>(object, [=](Curve<Exact> c) { return edit::set_knot(std::move(c), i, u); })(w);
    };
  });
}

void draw_surface(Ui& ui, StudioFields& fields, const Studio& studio, const Surface<Exact>& surface, float room) {
  const std::size_t object = *studio.current();
  label("Kind");
  if (const auto to = combo(ui, "shape kind", kind_titles(), kind_index(surface), ui.px(132)))
    fields.send(path_of(object, "kind"), "kind " + kind_titles()[*to],
                changing<Surface<Exact>>(
                    object, [kind = kinds[*to]](Surface<Exact> s) { return edit::set_kind(std::move(s), kind); }));
  static int row = 0;  // whose points the table has
  row = std::clamp(row, 0, surface.rows - 1);
  if (studio.selected().size() == 1 && studio.selected().front().object == object)
    row = static_cast<int>(studio.selected().front().point) / surface.columns;
  for (const int direction : {0, 1}) {
    const std::string which = direction == 0 ? "u" : "v";
    label(("Degree in " + which).c_str());
    const int count = direction == 0 ? surface.rows : surface.columns;
    const int most = surface.bezier ? max_degree : std::min(max_degree, count - 1);
    if (const auto degree =
            draw_stepper(ui, "shape degree " + which, surface.degree[static_cast<std::size_t>(direction)], 1, most))
      fields.send(path_of(object, "degree"), "degree " + std::to_string(*degree) + " in " + which,
                  changing<Surface<Exact>>(object, [=, d = *degree](Surface<Exact> s) {
                    return edit::set_degree(std::move(s), direction, d);
                  }));
    const char* line = direction == 0 ? "rows" : "columns";
    beside_if_fits(ui, line);
    label(line);
    if (const auto to = draw_stepper(ui, std::string("shape ") + line, count, 2, 100)) {
      const int wanted = std::clamp(*to, 2, 100);
      const bool more = wanted > count;
      fields.send(path_of(object, line), std::string(line) + " " + std::to_string(wanted),
                  changing<Surface<Exact>>(object, [=](Surface<Exact> s) {
                    Checked<Surface<Exact>> next(std::move(s));
                    for (int step = 0; next && step < std::abs(wanted - count); ++step) {
                      const int lines = direction == 0 ? next->rows : next->columns;
                      const int at = direction == 0 ? row : lines / 2 - 1;
                      // Several are spread, or they would share one span of the knots.
                      next = more ? edit::insert_row(std::move(*next), direction, (at + 2 * step) % (lines - 1))
                                  : edit::delete_row(std::move(*next), direction, std::clamp(at, 0, lines - 1));
                    }
                    return next;
                  }));
    }
  }
  fields.say();
  draw_weight_slider(ui, studio);
  label("Points of row");
  if (const auto to = draw_stepper(ui, "shape row", row, 0, surface.rows - 1)) {
    row = *to;
    send_studio(ui, [](Studio& s) { s.select({}); });
  }
  const Table table = table_for(ui, 3, true, static_cast<std::size_t>(surface.columns) - 1, room, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(3)});
  draw_titles(ui, table);
  clipped(static_cast<std::size_t>(surface.columns), [&](std::size_t j) {
    const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.columns) + j;
    const std::string name = "P[" + std::to_string(row) + "][" + std::to_string(j) + "]";
    draw_point(ui, fields, studio, table, i, with_subscript("P", j), name);
  });
  ImGui::PopStyleVar();
  fields.say();
  if (surface.bezier) return;
  for (const int direction : {0, 1}) {
    const std::string which = direction == 0 ? "u" : "v";
    ImGui::Dummy({0, ui.px(2)});
    ui.heading(("Knots in " + which).c_str());
    draw_knots(ui, fields, surface.knots[static_cast<std::size_t>(direction)],
               path_of(object, "knots[" + std::to_string(direction) + "]"), "knot " + which, room, [=](std::size_t i) {
                 return [=](const Workspace& w, const Exact& u) {
                   return changing<Surface<Exact>>(
                       object, [=](Surface<Exact> s) { return edit::set_knot(std::move(s), direction, i, u); })(w);
                 };
               });
  }
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  if (studio.object() == nullptr) return ImGui::TextDisabled("Choose a thing to see it in numbers.");
  ImGui::BeginChild("shape form", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NavFlattened);
  StudioFields fields(ui, model);
  const float room = ImGui::GetContentRegionAvail().x;
  fields.set_wrap(room);
  const std::size_t object = *studio.current();
  label("Colour");
  for (int color = 0; color < object_colors; ++color) {
    ImGui::PushID(color);
    if (color > 0) ImGui::SameLine(0, ui.px(4));
    const float side = ImGui::GetFrameHeight() * 0.8f;
    if (ImGui::InvisibleButton("color", {side, ImGui::GetFrameHeight()}))
      fields.send(path_of(object, "color"), "colour",
                  [=](const Workspace& w) { return edit::set_color(w, object, color); });
    ui.thing("shape color " + std::to_string(color));
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float top = (low.y + high.y - side) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x, top}, {high.x, top + side}, ui.color(object_role(color)), ui.px(3));
    if (studio.object()->color == color)
      list.AddRect({low.x - ui.px(2), top - ui.px(2)}, {high.x + ui.px(2), top + side + ui.px(2)}, ui.ink(Role::text),
                   ui.px(4), 0, ui.px(2));
    ImGui::PopID();
  }
  const Geometry& geometry = studio.object()->geometry;
  if (studio.object()->recipe) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
    ImGui::TextDisabled("Made by an algorithm: it is given from the first edit here on.");
    ImGui::PopTextWrapPos();
  }
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) draw_curve(ui, fields, studio, *curve, room);
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) draw_surface(ui, fields, studio, *surface, room);
  if (const auto* row = std::get_if<PointRow<Exact>>(&geometry)) {
    const Table table = table_for(ui, row->dimension, false, row->points.size(), room, 0);
    draw_titles(ui, table);
    clipped(row->points.size(), [&](std::size_t i) {
      draw_point(ui, fields, studio, table, i, with_subscript("D", i), "D" + std::to_string(i));
    });
    fields.say();
  }
  if (const auto* net = std::get_if<PointNet<Exact>>(&geometry)) {
    const Table table = table_for(ui, 3, false, net->points.size(), room, 0);
    draw_titles(ui, table);
    clipped(net->points.size(), [&](std::size_t i) {
      const std::size_t columns = static_cast<std::size_t>(net->columns);
      draw_point(ui, fields, studio, table, i, with_subscript("D", i),
                 "D[" + std::to_string(i / columns) + "][" + std::to_string(i % columns) + "]");
    });
    fields.say();
  }
  fields.say_rest([](const std::string& path) { return path.starts_with("objects["); });
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_studio_shape() {
  static const Panel panel{"shape", "Shape", Slot::tabs, 10, draw, nullptr, nullptr, 0, true, true};
  return panel;
}

}  // namespace blossom
