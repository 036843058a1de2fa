// Everything the algorithm runs on, to be typed.
#include <algorithm>

#include "player/ui/curve_fields.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// Labels stand in a column, so that the fields do.
float label_width(const Ui& ui, const Algorithm& algorithm) {
  float widest = 0;
  for (const InputSpec& spec : algorithm.inputs) {
    if (spec.type == InputSpec::Type::curve || spec.type == InputSpec::Type::curves) continue;
    widest = std::max(widest, ImGui::CalcTextSize(spec.name.data(), spec.name.data() + spec.name.size()).x);
  }
  return widest + ui.px(10);
}

std::string label_of(const InputSpec& spec) {
  std::string text(spec.name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

void draw_label(const InputSpec& spec, float width) {
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label_of(spec).c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(spec.description).c_str());
  ImGui::SameLine(left + width, 0);
}

// The parameter over the domain of the (first) curve, with a tick at every knot; near a tick it snaps to the knot.
void draw_slider(Ui& ui, InputFields& fields, const std::string& name, const Exact& value, const Curve<Exact>& curve,
                 float width) {
  const Exact &a = curve.domain_begin(), &b = curve.domain_end();
  const double low = a.to_double(), high = b.to_double();
  // The slider knows shares of the domain only, which may be wider than ImGui can reckon with.
  double share = value.to_double() / (high - low) - low / (high - low);
  constexpr double none = 0, all = 1;
  ImGui::SetNextItemWidth(width);
  const bool moved =
      ImGui::SliderScalar(("##slider " + name).c_str(), ImGuiDataType_Double, &share, &none, &all, "",
                          ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
  const double at = low * (1 - share) + high * share;
  ui.thing("inputs " + name + " slider");
  const ImVec2 corner = ImGui::GetItemRectMin(), far = ImGui::GetItemRectMax();
  const float grab = ImGui::GetStyle().GrabMinSize, from = corner.x + 2 + grab / 2,
              length = std::max(far.x - corner.x - 4 - grab, 1.0f);
  for (std::size_t i = static_cast<std::size_t>(curve.degree); i <= curve.points.size(); ++i) {
    const auto x = from + length * static_cast<float>((curve.knots[i].to_double() - low) / (high - low));
    ImGui::GetWindowDrawList()->AddLine({x, far.y - ui.px(5)}, {x, far.y}, ui.ink(Role::text_quiet), ui.px(1));
  }
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ui.light({Link::Kind::parameter, 0});
  if (moved) {
    const double unit = (high - low) / length;  // a pixel
    Exact to = std::clamp(snapped(at, unit), a, b);
    for (std::size_t i = static_cast<std::size_t>(curve.degree); i <= curve.points.size(); ++i)
      if (std::abs(curve.knots[i].to_double() - at) < 3 * unit) to = curve.knots[i];
    fields.send(
        name, name + " = " + number_text(to),
        [name, to](const Session& s) { return set_number(s.algorithm(), s.inputs(), name, to); }, "slider " + name);
  }
  if (ImGui::IsItemDeactivated())
    ui.send([](Player& player) {
      if (player.session() != nullptr) player.session()->end_gesture();
    });
}

void draw_number(Ui& ui, InputFields& fields, const InputSpec& spec, const Exact& value, float room) {
  const std::string name(spec.name);
  const float left = ImGui::GetCursorPosX();
  if (fields.number({name, name, value, NumberStyle::parameter, ui.px(90)}, [name](const Session& s, const Exact& x) {
        return set_number(s.algorithm(), s.inputs(), name, x);
      }))
    ui.light({Link::Kind::parameter, 0});
  const Inputs<Exact>& inputs = ui.player().session()->inputs();
  const auto curves = curves_of(inputs);
  if (curves.empty()) return fields.say();
  const Curve<Exact>& curve = curve_at(inputs, curves.front());
  ImGui::SameLine();
  const std::string domain = "in [" + number_text(curve.domain_begin()) + ", " + number_text(curve.domain_end()) + "]";
  ImGui::TextDisabled("%s", domain.c_str());
  fields.say();
  ImGui::SetCursorPosX(left);
  draw_slider(ui, fields, name, value, curve, std::max(room - left, ui.px(80)));
}

void draw_choice(Ui& ui, InputFields& fields, const InputSpec& spec, const std::string& value, float room) {
  const std::string name(spec.name);
  ImGui::SetNextItemWidth(std::clamp(room - ImGui::GetCursorPosX(), ui.px(80), ui.px(180)));
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), value.c_str());
  if (open) {
    for (const std::string_view choice : spec.choices) {
      const std::string other(choice);
      if (ImGui::Selectable(other.c_str(), other == value) && other != value)
        fields.send(name, name + " " + other,
                    [=](const Session& s) { return set_choice(s.algorithm(), s.inputs(), name, other); });
      ui.thing("inputs " + name + " " + other);
    }
    ImGui::EndCombo();
    return;
  }
  ui.thing("inputs " + name);
  fields.mark(name);
  fields.say();
}

void draw_integer(Ui& ui, InputFields& fields, const InputSpec& spec, int value) {
  const std::string name(spec.name);
  if (const auto to = draw_stepper(ui, "inputs " + name, value, spec.at_least, spec.at_most))
    fields.send(name, name + " = " + std::to_string(*to),
                [name, to = *to](const Session& s) { return set_integer(s.algorithm(), s.inputs(), name, to); });
  fields.mark(name);
  fields.say();
}

// Which of several curves, one more, one less.
void draw_curve_choice(Ui& ui, InputFields& fields, const std::vector<CurveAddress>& curves, std::size_t chosen) {
  const CurveAddress address = curves[chosen];
  const std::string path = path_of_curve(*ui.player().session(), address);
  const auto choose = [&](std::size_t which) { ui.send([which](Player& player) { player.curve = which; }); };
  ImGui::SetNextItemWidth(ui.px(120));
  const bool open = ImGui::BeginCombo("##curve", path.c_str());
  if (open) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const std::string other = path_of_curve(*ui.player().session(), curves[i]);
      if (ImGui::Selectable(other.c_str(), i == chosen)) choose(i);
      ui.thing("inputs " + other);
    }
    ImGui::EndCombo();
  } else {
    ui.thing("inputs curve");
  }
  ImGui::SameLine();
  if (ui.button("Add", "inputs add curve", true, "A copy behind this one, moved on"))
    fields.send(path, "a curve behind " + path,
                [address](const Session& s) { return add_curve(s.algorithm(), s.inputs(), address); });
  ImGui::SameLine();
  if (ui.button("Delete", "inputs delete curve", true, ("Delete " + path).c_str()))
    fields.send(path, path + " deleted",
                [address](const Session& s) { return delete_curve(s.algorithm(), s.inputs(), address); });
  fields.mark(path);
  fields.say();
}

void draw_curves(Ui& ui, InputFields& fields, const InputSpec& spec) {
  const auto curves = curves_of(ui.player().session()->inputs());
  if (curves.empty()) return;
  // The chosen one if it is of this input, otherwise the first that is.
  std::size_t chosen = std::min(ui.player().curve, curves.size() - 1);
  if (curves[chosen].input != spec.name)
    chosen = static_cast<std::size_t>(
        std::ranges::find_if(curves, [&](const CurveAddress& c) { return c.input == spec.name; }) - curves.begin());
  if (chosen >= curves.size()) return;
  ImGui::Dummy({0, ui.px(1)});
  if (spec.type == InputSpec::Type::curves) {
    draw_label(spec, ImGui::CalcTextSize(label_of(spec).c_str()).x + ui.px(10));
    draw_curve_choice(ui, fields, curves, chosen);
  }
  draw_curve_fields(ui, fields, curves[chosen]);
}

// At the right end of the first line if they fit there, otherwise on a line of their own.
void draw_history(Ui& ui, float room, float first_line) {
  const Session& session = *ui.player().session();
  const ImGuiStyle& style = ImGui::GetStyle();
  const float icon = ImGui::GetFrameHeight() * 1.12f;
  float width = 2 * icon + style.ItemSpacing.x;
  if (session.edited()) width += style.ItemSpacing.x + ImGui::CalcTextSize("Revert").x + 2 * style.FramePadding.x;
  const ImVec2 at = ImGui::GetCursorPos();
  const bool fits = first_line + width < room;
  if (fits) ImGui::SetCursorPosX(at.x + room - width);
  const auto button = [&](const char* action, const char* symbol, const char* verb, const std::string& what) {
    ui.icon_button(action, symbol);
    ui.thing(std::string("inputs ") + symbol);
    if (!what.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s: %s", verb, what.c_str());
  };
  if (session.edited()) {
    if (ui.button("Revert", "inputs revert", true, "Take back all edits")) ui.act("edit.revert");
    ImGui::SameLine();
  }
  button("edit.undo", "undo", "Undo", session.history().undo_what());
  ImGui::SameLine();
  button("edit.redo", "redo", "Redo", session.history().redo_what());
  if (fits) ImGui::SetCursorPos(at);
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  ImGui::BeginChild("inputs form", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NavFlattened);
  InputFields fields(ui);
  const float room = ImGui::GetContentRegionAvail().x;
  fields.set_wrap(room);
  const float labels = label_width(ui, session.algorithm());
  draw_history(ui, room, labels + ui.px(186));

  const auto& specs = session.algorithm().inputs;
  const auto curves = curves_of(session.inputs());
  const std::string shown =
      curves.empty() ? "" : path_of_curve(session, curves[std::min(ui.player().curve, curves.size() - 1)]);
  fields.say_rest([&](const std::string& path) {
    if (path == shown || path.starts_with(shown + ".")) return true;
    return std::ranges::any_of(specs, [&](const InputSpec& spec) {
      return spec.name == path && spec.type != InputSpec::Type::curve && spec.type != InputSpec::Type::curves;
    });
  });
  // The short ones first: a table may be long.
  for (const InputSpec& spec : specs) {
    const auto found = session.inputs().values.find(spec.name);
    if (found == session.inputs().values.end()) continue;
    if (spec.type == InputSpec::Type::curve || spec.type == InputSpec::Type::curves) continue;
    ImGui::PushID(spec.name.data(), spec.name.data() + spec.name.size());
    draw_label(spec, labels);
    if (const auto* number = std::get_if<Exact>(&found->second)) draw_number(ui, fields, spec, *number, room);
    if (const auto* whole = std::get_if<int>(&found->second)) draw_integer(ui, fields, spec, *whole);
    if (const auto* choice = std::get_if<std::string>(&found->second)) draw_choice(ui, fields, spec, *choice, room);
    if (const auto* surface = std::get_if<Surface<Exact>>(&found->second))
      ImGui::TextDisabled("%d x %d control points of degrees %d and %d", surface->rows, surface->columns,
                          surface->degree[0], surface->degree[1]);
    ImGui::PopID();
  }
  for (const InputSpec& spec : specs)
    if (spec.type == InputSpec::Type::curve || spec.type == InputSpec::Type::curves) draw_curves(ui, fields, spec);
  ImGui::EndChild();
}

// Some rows of a list that scrolls.
double tight(const Ui&, double) { return 230; }

}  // namespace

const Panel& panel_inputs() {
  static const Panel panel{"inputs", "Inputs", Slot::tabs, 20, draw, nullptr, nullptr, 0, true, false, tight};
  return panel;
}

}  // namespace blossom
