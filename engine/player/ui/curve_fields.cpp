#include "player/ui/curve_fields.hpp"

#include <algorithm>
#include <cmath>

#include "player/grip.hpp"

namespace blossom {
namespace {

std::string in_list(const std::string& path, std::string_view list, std::size_t i) {
  return path + "." + std::string(list) + "[" + std::to_string(i) + "]";
}

// ---- kind and degree ------------------------------------------------------------------------------------------------

void draw_kind(Ui& ui, InputFields& fields, const CurveAddress& address, const Curve<Exact>& curve,
               const std::string& path) {
  const CurveKind kind = kind_of(curve);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Kind");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ui.px(152));
  const bool open = ImGui::BeginCombo("##kind", std::string(curve_kind_name(kind)).c_str());
  if (!open) ui.thing("inputs kind");
  if (open) {
    for (const CurveKind other :
         {CurveKind::bezier, CurveKind::rational_bezier, CurveKind::bspline, CurveKind::nurbs}) {
      const std::string name(curve_kind_name(other));
      if (ImGui::Selectable(name.c_str(), other == kind) && other != kind)
        fields.send(path + ".kind", "kind " + name,
                    [=](const Session& s) { return set_kind(s.algorithm(), s.inputs(), address, other); });
      ui.thing("inputs kind " + name);
    }
    ImGui::EndCombo();
  } else {
    fields.mark(path + ".kind");
  }

  const float degree_width = ImGui::CalcTextSize("Degree").x + ui.px(110);
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < degree_width) ImGui::NewLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Degree");
  ImGui::SameLine();
  const int most = curve.bezier ? max_degree : std::min(max_degree, curve.n());
  if (const auto degree = draw_stepper(ui, "inputs degree", curve.degree, 1, most))
    fields.send(path + ".degree", "degree " + std::to_string(*degree),
                [=](const Session& s) { return set_degree(s.algorithm(), s.inputs(), address, *degree); });
  fields.mark(path + ".degree");
  fields.say();
}

// ---- control points -------------------------------------------------------------------------------------------------

struct Columns {
  std::vector<const char*> titles;  // x, y, (z,) w
  float name = 0, number = 0, button = 0, gap = 0;
  float number_x(std::size_t i) const { return name + gap + static_cast<float>(i) * (number + gap); }
  float button_x(std::size_t i) const { return number_x(titles.size()) + static_cast<float>(i) * (button + gap); }
  float width() const { return button_x(2); }
};

Columns columns_for(const Ui& ui, const Curve<Exact>& curve, float room) {
  Columns columns;
  columns.titles = {"x", "y"};
  if (curve.dimension == 3) columns.titles.push_back("z");
  columns.titles.push_back("weight");
  const auto count = static_cast<float>(columns.titles.size());
  columns.gap = ui.px(4);
  columns.name = ImGui::CalcTextSize(with_subscript("P", curve.points.size() - 1).c_str()).x + ui.px(10);
  columns.button = ImGui::GetFrameHeight();
  const float numbers = room - columns.name - 2 * columns.button - (count + 2) * columns.gap;
  columns.number = std::clamp(std::floor(numbers / count), ui.px(44), ui.px(140));
  return columns;
}

// P_i as a button that lights and pins its value.
void draw_point_name(Ui& ui, const std::string& name, std::size_t i, std::optional<ValueId> value, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  const Link link = value ? Link{Link::Kind::value, *value} : Link{};
  const bool clicked = ImGui::InvisibleButton("name", {width, height});
  ui.thing("inputs " + name);
  const bool hovered = ImGui::IsItemHovered(), pinned = value && ui.player().is_pinned(link);
  const Emphasis& emphasis = ui.player().emphasis();
  const bool lit = value && emphasis.lights(*value);
  const double share = value ? std::abs(emphasis.share(*value)) : 0;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 far{at.x + width, at.y + height};
  if (lit || share > 0 || hovered)
    list.AddRectFilled(at, far, ui.color(Role::highlight, lit ? 0.35 : 0.1 + 0.2 * std::min(share, 1.0)), ui.px(4));
  if (pinned) list.AddRect(at, far, ui.color(Role::highlight), ui.px(4), 0, ui.px(2));
  if (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)
    list.AddRect(at, far, ui.color(Role::focus), ui.px(4), 0, ui.px(2));
  if (lit) ImGui::PushFont(ui.bold());
  list.AddText({at.x + ui.px(4), at.y + ImGui::GetStyle().FramePadding.y}, ui.ink(Role::text),
               with_subscript("P", i).c_str());
  if (lit) ImGui::PopFont();
  if (hovered && value) {
    ui.light(link);
    if (ImGui::IsMouseClicked(1)) ui.open_menu(link);
  }
  if (clicked && value) ui.send([link](Player& player) { player.pin(link); });
}

void draw_point(Ui& ui, InputFields& fields, const CurveAddress& address, const Curve<Exact>& curve,
                const std::string& path, const Columns& columns, std::size_t i) {
  const Session& session = *ui.player().session();
  const PointAddress point{address.input, address.curve, i};
  const std::string name = "P" + std::to_string(i), point_path = in_list(path, "points", i);
  const float left = ImGui::GetCursorPosX();
  const auto column = [&](float x) { ImGui::SameLine(left + x, 0); };
  ImGui::PushID(static_cast<int>(i));
  const auto value = value_of(session.recording().graph(), session.inputs(), point);
  draw_point_name(ui, name, i, value, columns.name);
  fields.mark(point_path);

  bool over = false;
  const Point<Exact> place = affine(curve, i);
  const std::size_t dimension = columns.titles.size() - 1;
  for (std::size_t k = 0; k < dimension; ++k) {
    column(columns.number_x(k));
    NumberField field{point_path + "[" + std::to_string(k) + "]", name + " " + columns.titles[k],
                      place[static_cast<int>(k)], NumberStyle::coordinate, columns.number};
    over |= fields.number(field, [point, k](const Session& s, const Exact& x) {
      const auto curves = curves_of(s.inputs());
      const CurveAddress at{point.input, point.curve};
      if (std::find(curves.begin(), curves.end(), at) == curves.end() ||
          point.point >= curve_at(s.inputs(), at).points.size())
        return move_point(s.algorithm(), s.inputs(), point, {});  // says that there is no such point any more
      Point<Exact> to = affine(curve_at(s.inputs(), at), point.point);
      to[static_cast<int>(k)] = x;
      return move_point(s.algorithm(), s.inputs(), point, to);
    });
  }
  column(columns.number_x(dimension));
  over |= fields.number({in_list(path, "weights", i), name + " weight", curve.points[i].w, NumberStyle::parameter,
                         columns.number, !curve.rational},
                        [point, weight = in_list(path, "weights", i)](const Session& s, const Exact& w) {
                          // A point of weight 0 comes back to where it was.
                          return number_at(s.inputs(), weight) == Exact(0)
                                     ? s.with_number_at(weight, w)
                                     : set_weight(s.algorithm(), s.inputs(), point, w);
                        });
  if (over && value) ui.light({Link::Kind::value, *value});

  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  column(columns.button_x(0));
  if (ImGui::Button("+", {columns.button, 0}))
    fields.send(point_path, "a point behind P_" + std::to_string(i),
                [=, at = place_behind(curve, i)](const Session& s) {
                  return insert_point(s.algorithm(), s.inputs(), point, at);
                });
  ui.thing("inputs add " + name);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Add a point behind %s", with_subscript("P", i).c_str());
  column(columns.button_x(1));
  if (ImGui::Button("\u00d7", {columns.button, 0}))
    fields.send(point_path, "P_" + std::to_string(i) + " deleted",
                [point](const Session& s) { return delete_point(s.algorithm(), s.inputs(), point); });
  ui.thing("inputs delete " + name);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Delete %s", with_subscript("P", i).c_str());
  ImGui::PopStyleVar();
  ImGui::PopID();
  fields.say();
}

// The rows that can be seen, a few around them so that Tab goes on there, and those in which something is typed or
// wrong.
void draw_points(Ui& ui, InputFields& fields, const CurveAddress& address, const Curve<Exact>& curve,
                 const std::string& path, float room) {
  const Columns columns = columns_for(ui, curve, room);
  const float left = ImGui::GetCursorPosX();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(3)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(5), ui.px(3)});
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
  for (std::size_t k = 0; k < columns.titles.size(); ++k) {
    if (k > 0) ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(left + columns.number_x(k) + ImGui::GetStyle().FramePadding.x);
    ImGui::TextUnformatted(columns.titles[k]);
  }
  ImGui::PopStyleColor();

  const float row = ImGui::GetFrameHeightWithSpacing(), top = ImGui::GetCursorScreenPos().y;
  const ImVec2 clip_low = ImGui::GetWindowDrawList()->GetClipRectMin(),
               clip_high = ImGui::GetWindowDrawList()->GetClipRectMax();
  constexpr std::ptrdiff_t margin = 2;
  const auto first = static_cast<std::ptrdiff_t>((clip_low.y - top) / row) - margin;
  const auto last = static_cast<std::ptrdiff_t>((clip_high.y - top) / row) + margin;
  const bool all_seen = !fields.wanted(path);  // nothing is wrong anywhere: no need to look at each row
  std::size_t left_out = 0;
  const auto skip = [&] {
    if (left_out > 0) ImGui::Dummy({1, static_cast<float>(left_out) * row - ImGui::GetStyle().ItemSpacing.y});
    left_out = 0;
  };
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const bool wanted =
        (at >= first && at <= last) ||
        (!all_seen && (fields.wanted(in_list(path, "points", i)) || fields.wanted(in_list(path, "weights", i))));
    if (!wanted) {
      ++left_out;
      continue;
    }
    skip();
    draw_point(ui, fields, address, curve, path, columns, i);
  }
  skip();
  ImGui::PopStyleVar(2);
  for (const char* list : {".points", ".weights"})
    if (const std::string& message = fields.problem(path + list); !message.empty()) fields.say(message);
}

// ---- knots ----------------------------------------------------------------------------------------------------------

// Equal knots stand on one ground, with their multiplicity; a line ends before a group that does not fit in it.
void draw_knots(Ui& ui, InputFields& fields, const CurveAddress& address, const Curve<Exact>& curve,
                const std::string& path, float room) {
  const std::vector<Exact>& U = curve.knots;
  const bool first_curve = curves_of(ui.player().session()->inputs()).front() == address;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4), ui.px(3)});
  std::size_t longest = 0;
  for (const Exact& u : U) longest = std::max(longest, number_text(u).size());
  const float digit = ImGui::CalcTextSize("0").x,
              width = std::clamp(static_cast<float>(longest) * digit + ui.px(14), ui.px(34), ui.px(72));
  const float gap = ui.px(2), between = ui.px(8), pad = ui.px(4);
  ImGui::PushFont(ui.small());
  const float label = ImGui::GetTextLineHeight();
  ImGui::PopFont();
  const float line = label + ImGui::GetFrameHeight() + 2 * pad;
  const ImVec2 origin = ImGui::GetCursorPos();
  float x = 0, y = 0;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto end_line = [&] {
    ImGui::SetCursorPos({origin.x, origin.y + y + line});
    ImGui::Dummy({0, 0});
    ImGui::SetCursorPos({origin.x, origin.y + y + line});
    fields.say();
    y = ImGui::GetCursorPosY() - origin.y + ui.px(4);
    x = 0;
  };
  for (std::size_t begin = 0; begin < U.size();) {
    std::size_t end = begin;
    while (end < U.size() && U[end] == U[begin]) ++end;
    const Link link{Link::Kind::knot, static_cast<std::uint32_t>(begin)};
    const bool lit = first_curve && ui.player().hovered() == link;
    const auto span = [&](std::size_t count) { return 2 * pad + static_cast<float>(count) * (width + gap) - gap; };
    if (x > 0 && x + span(end - begin) > room) end_line();
    const std::size_t multiplicity = end - begin;
    for (std::size_t i = begin; i < end;) {
      // As many of the group as the line holds.
      std::size_t count = 1;
      while (i + count < end && x + span(count + 1) <= room) ++count;
      ImGui::SetCursorPos({origin.x + x, origin.y + y});
      const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + span(count), low.y + line};
      if (lit) list.AddRectFilled(low, high, ui.color(Role::highlight, 0.25), ui.px(4));
      list.AddRect(low, high, ui.color(Role::rule_line), ui.px(4), 0, ui.px(1));
      if (first_curve && ImGui::IsMouseHoveringRect(low, high) && ImGui::IsWindowHovered()) ui.light(link);
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t index = i + k;
        const float at = x + pad + static_cast<float>(k) * (width + gap);
        std::string name = with_subscript("u", index);
        ImGui::PushFont(ui.small());
        list.AddText({low.x + pad + static_cast<float>(k) * (width + gap), low.y + pad * 0.5f},
                     ui.ink(Role::text_quiet), name.c_str());
        if (multiplicity > 1 && index + 1 == end && k > 0) {
          const std::string times = "\u00d7" + std::to_string(multiplicity);
          list.AddText({high.x - pad - ImGui::CalcTextSize(times.c_str()).x, low.y + pad * 0.5f}, ui.ink(Role::text),
                       times.c_str());
        }
        ImGui::PopFont();
        ImGui::SetCursorPos({origin.x + at, origin.y + y + label + pad});
        fields.number(
            {in_list(path, "knots", index), "knot " + std::to_string(index), U[index], NumberStyle::parameter, width},
            [address, index](const Session& s, const Exact& u) {
              return set_knot(s.algorithm(), s.inputs(), address, index, u);
            });
      }
      i += count;
      x += span(count) + between;
      if (i < end) end_line();
    }
    begin = end;
  }
  end_line();
  ImGui::PopStyleVar();
  if (const std::string& message = fields.problem(path + ".knots"); !message.empty()) fields.say(message);
}

}  // namespace

std::string path_of_curve(const Session& session, const CurveAddress& address) {
  const auto found = session.inputs().values.find(address.input);
  const bool several = std::holds_alternative<std::vector<Curve<Exact>>>(found->second);
  return address.input + (several ? "[" + std::to_string(address.curve) + "]" : "");
}

std::optional<int> draw_stepper(Ui& ui, const std::string& name, int value, int least, int most) {
  std::optional<int> stepped;
  ImGui::PushID(name.c_str());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(3), ImGui::GetStyle().ItemSpacing.y});
  const float side = ImGui::GetFrameHeight();
  const auto button = [&](const char* label, int by) {
    ImGui::BeginDisabled(value + by < least || value + by > most);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
    if (ImGui::Button(label, {side, 0})) stepped = value + by;
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    ui.thing(name + (by < 0 ? " less" : " more"));
  };
  ImGui::BeginGroup();
  button("\u2212", -1);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ui.px(36));
  int typed = value;
  if (ImGui::InputInt("##value", &typed, 0, 0,
                      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
    stepped = typed;
  ui.thing(name);
  ImGui::SameLine();
  button("+", 1);
  ImGui::EndGroup();
  ImGui::PopStyleVar();
  ImGui::PopID();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("from %d to %d", least, most);
  return stepped && *stepped != value ? stepped : std::nullopt;
}

void draw_curve_fields(Ui& ui, InputFields& fields, const CurveAddress& address) {
  const Session& session = *ui.player().session();
  const Curve<Exact>& curve = curve_at(session.inputs(), address);
  const std::string path = path_of_curve(session, address);
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::PushID(path.c_str());
  draw_kind(ui, fields, address, curve, path);
  draw_points(ui, fields, address, curve, path, room);
  if (!curve.bezier) {
    ImGui::Dummy({0, ui.px(2)});
    ui.heading("Knots");
    draw_knots(ui, fields, address, curve, path, room);
  }
  ImGui::PopID();
}

}  // namespace blossom
