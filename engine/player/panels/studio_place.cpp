// Moving, turning and scaling by numbers: what is chosen, or the instances that a made thing is made from.
#include <algorithm>

#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

const StudioModel model("place");

// What is typed until it is applied.
struct Pending {
  Placement place;
  bool about_origin = false;
};
Pending& pending() {
  static Pending state;
  return state;
}

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

// A row of three number fields that are only kept here.
void draw_pending(Ui& ui, const char* label, const std::string& name, Point<Exact>& value, float left, float width) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::SameLine(left + static_cast<float>(axis) * (width + ui.px(4)), 0);
    std::array<char, 128> buffer{};
    number_text(value[axis], NumberStyle::coordinate).copy(buffer.data(), buffer.size() - 1);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID((name + axes[static_cast<std::size_t>(axis)]).c_str());
    ImGui::InputText("##field", buffer.data(), buffer.size(), ImGuiInputTextFlags_AutoSelectAll);
    const std::string thing = "place " + name + " " + axes[static_cast<std::size_t>(axis)];
    ui.thing(thing);
    if (ImGui::IsItemDeactivatedAfterEdit())
      if (const auto x = typed_number(buffer.data())) value[axis] = *x;
    ImGui::PopID();
  }
}

bool apply(Studio& studio, const Placement& place, bool about_origin) {
  const Point<Exact> origin{Exact(0), Exact(0), Exact(0)};
  const Point<Exact> centre = about_origin ? origin : studio.centre().value_or(origin);
  const Workspace& scene = studio.workspace();
  return studio.edit(studio.selected().empty() ? edit::place(scene, studio.chosen(), place, centre)
                                               : edit::place(scene, studio.selected(), place, centre),
                     "placed");
}

void draw_chosen(Ui& ui, const Studio& studio, float room) {
  Pending& state = pending();
  const std::size_t points = studio.selected().size();
  ui.heading(points > 0 ? (std::to_string(points) + (points == 1 ? " point" : " points")).c_str()
                        : (studio.chosen().size() > 1 ? (std::to_string(studio.chosen().size()) + " things").c_str()
                                                      : studio.object()->name.c_str()));
  const float left = ImGui::GetCursorPosX() + ImGui::CalcTextSize("Scale by").x + ui.px(10);
  const float width = std::clamp((room - left) / 3 - ui.px(4), ui.px(44), ui.px(90));
  draw_pending(ui, "Move by", "move", state.place.move, left, width);
  draw_pending(ui, "Turn by \u00b0", "turn", state.place.turn, left, width);
  draw_pending(ui, "Scale by", "scale", state.place.scale, left, width);
  ImGui::Checkbox("About the origin, not its middle", &state.about_origin);
  ui.thing("place about-origin");
  if (ui.button("Apply", "place apply", !state.place.is_identity()))
    send_studio(ui, [place = state.place, origin = state.about_origin](Studio& s) { apply(s, place, origin); });
  ImGui::SameLine();
  if (ui.button("Reset", "place reset")) state.place = {};
  ImGui::SameLine();
  const auto quarter = [&](const char* label, int axis) {
    if (ui.button(label, std::string("place quarter ") + axes[static_cast<std::size_t>(axis)], true,
                  "A quarter turn about this axis"))
      send_studio(ui, [axis, origin = state.about_origin](Studio& s) {
        Placement place;
        place.turn[axis] = Exact(90);
        apply(s, place, origin);
      });
    ImGui::SameLine();
  };
  quarter("90\u00b0 x", 0);
  quarter("y", 1);
  quarter("z", 2);
  ImGui::NewLine();
}

// One instance of what the current thing is made from.
void draw_instance(Ui& ui, StudioFields& fields, std::size_t object, const std::string& input, std::size_t which,
                   const Reference& reference, float room) {
  const std::string path = "objects[" + std::to_string(object) + "].made." + input + "[" + std::to_string(which) + "]";
  ImGui::PushID(path.c_str());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((std::to_string(which + 1) + ".  " + reference.object).c_str());
  const float left = ImGui::GetCursorPosX() + ImGui::CalcTextSize("scale").x + ui.px(18);
  const float width = std::clamp((room - left) / 3 - ui.px(4), ui.px(44), ui.px(90));
  const auto row = [&](const char* label, Point<Exact> Placement::*part) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("   %s", label);
    for (int axis = 0; axis < 3; ++axis) {
      ImGui::SameLine(left + static_cast<float>(axis) * (width + ui.px(4)), 0);
      const std::string name = std::to_string(which + 1) + " " + label + " " + axes[static_cast<std::size_t>(axis)];
      fields.number({path + "." + label + "[" + std::to_string(axis) + "]", name, (reference.place.*part)[axis],
                     NumberStyle::coordinate, width},
                    [=](const Workspace& w, const Exact& x) -> Worked {
                      const auto* recipe =
                          object < w.objects.size() && w.objects[object].recipe ? &*w.objects[object].recipe : nullptr;
                      if (recipe == nullptr) return Diagnostics{{"", 0, 0, path, "is not made any more"}};
                      const auto found = recipe->inputs.find(input);
                      const auto* all =
                          found != recipe->inputs.end() ? std::get_if<std::vector<Reference>>(&found->second) : nullptr;
                      if (all == nullptr || which >= all->size())
                        return Diagnostics{{"", 0, 0, path, "is not there any more"}};
                      Placement place = (*all)[which].place;
                      (place.*part)[axis] = x;
                      return edit::place_instance(w, object, input, which, place);
                    });
    }
    fields.say();
  };
  row("move", &Placement::move);
  row("turn", &Placement::turn);
  row("scale", &Placement::scale);
  ImGui::PopID();
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  if (studio.object() == nullptr) return ImGui::TextDisabled("Choose what is to be moved, turned or scaled.");
  ImGui::BeginChild("place form", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  const float room = ImGui::GetContentRegionAvail().x;
  draw_chosen(ui, studio, room);
  if (const auto& recipe = studio.object()->recipe) {
    StudioFields fields(ui, model);
    fields.set_wrap(room);
    for (const auto& [input, ingredient] : recipe->inputs)
      if (const auto* references = std::get_if<std::vector<Reference>>(&ingredient)) {
        ImGui::Dummy({0, ui.px(4)});
        std::string title = input;
        std::ranges::replace(title, '_', ' ');
        ui.heading(("Placed as " + title).c_str());
        for (std::size_t i = 0; i < references->size(); ++i)
          draw_instance(ui, fields, *studio.current(), input, i, (*references)[i], room);
      }
  }
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_studio_place() {
  static const Panel panel{"place", "Place", Slot::tabs, 30, draw, nullptr, nullptr, 0, true, true};
  return panel;
}

}  // namespace blossom
