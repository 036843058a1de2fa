// How the current thing is made, and what can be made of what is chosen.
#include <algorithm>
#include <array>

#include "algorithms/typeset.hpp"
#include "player/action.hpp"
#include "player/ui/curve_fields.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

const StudioModel model("make");

std::string words(std::string_view name) {
  std::string text(name);
  std::ranges::replace(text, '_', ' ');
  return text;
}

const char* family_title(Family family) {
  switch (family) {
    case Family::evaluation:
      return "Look at a point";
    case Family::curve_technique:
      return "Curve techniques";
    case Family::fitting:
      return "Interpolate and approximate";
    case Family::surface_technique:
      return "Surface techniques";
    case Family::construction:
      return "Construct a surface";
  }
  return "";
}

// The edit that sets one input of a recipe.
StudioEdit setting(std::size_t object, const std::string& input, const Ingredient& to) {
  return [=](const Workspace& w) -> Worked {
    if (object >= w.objects.size() || !w.objects[object].recipe)
      return Diagnostics{{"", 0, 0, input, "the thing is not made any more"}};
    Recipe recipe = *w.objects[object].recipe;
    recipe.inputs.insert_or_assign(input, to);
    return edit::set_recipe(w, object, recipe);
  };
}

// What an input is: of the recipe, or its fallback.
std::optional<InputValue<Exact>> value_of(const Recipe& recipe, const InputSpec& spec) {
  const auto found = recipe.inputs.find(spec.name);
  if (found != recipe.inputs.end()) {
    if (const auto* value = std::get_if<InputValue<Exact>>(&found->second)) return *value;
    return std::nullopt;
  }
  if (spec.fallback.empty()) return std::nullopt;
  const auto document = JsonDocument::parse("default", std::string(spec.fallback));
  Diagnostics none;
  return read_input(spec, Cursor(*document, none));
}

void draw_sources(Ui& ui, StudioFields& fields, const Studio& studio, const std::string& input,
                  const std::vector<Reference>& references) {
  const std::size_t object = *studio.current();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < object; ++i) names.push_back(studio.workspace().objects[i].name);
  for (std::size_t k = 0; k < references.size(); ++k) {
    const auto at = std::ranges::find(names, references[k].object);
    ImGui::PushID(static_cast<int>(k));
    const std::string name = "make " + input + (references.size() > 1 ? " " + std::to_string(k + 1) : "");
    const auto changed = [&](auto change) {
      std::vector<Reference> next = references;
      change(next);
      fields.send(input, words(input), setting(object, input, next));
    };
    if (const auto to = combo(ui, name, names, static_cast<std::size_t>(at - names.begin()), ui.px(170)))
      changed([&](auto& next) { next[k].object = names[*to]; });
    if (references.size() > 1) {
      ImGui::SameLine(0, ui.px(3));
      if (ui.button("\u2191", name + " up", k > 0)) changed([&](auto& next) { std::swap(next[k], next[k - 1]); });
      ImGui::SameLine(0, ui.px(3));
      if (ui.button("\u00d7", name + " remove"))
        changed([&](auto& next) { next.erase(next.begin() + static_cast<std::ptrdiff_t>(k)); });
      ImGui::SameLine(0, ui.px(3));
      if (ui.button("+", name + " again", true, "The same once more, as an instance that can be placed elsewhere"))
        changed([&](auto& next) { next.insert(next.begin() + static_cast<std::ptrdiff_t>(k) + 1, next[k]); });
    }
    ImGui::PopID();
  }
}

// Points that are given in numbers, such as an axis: a row of fields each, as long as they are few.
constexpr std::size_t few = 6;

void draw_points(Ui& ui, StudioFields& fields, std::size_t object, const std::string& name,
                 const PointRow<Exact>& row) {
  const auto axes = static_cast<float>(row.dimension);
  const float width = std::clamp(ImGui::GetContentRegionAvail().x / axes - ui.px(4), ui.px(44), ui.px(90));
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    const HPoint<Exact>& P = row.points[i];
    const std::array<Exact, 3> xyz{P.x, P.y, P.z};
    for (int k = 0; k < row.dimension; ++k) {
      if (k > 0) ImGui::SameLine(0, ui.px(4));
      static constexpr std::array<const char*, 3> letters = {"x", "y", "z"};
      const auto axis = static_cast<std::size_t>(k);
      fields.number({name + "[" + std::to_string(i) + "][" + std::to_string(k) + "]",
                     name + " " + std::to_string(i) + " " + letters[axis], xyz[axis], NumberStyle::coordinate, width},
                    [=](const Workspace& w, const Exact& x) {
                      PointRow<Exact> next = row;
                      HPoint<Exact>& at = next.points[i];
                      (axis == 0 ? at.x : axis == 1 ? at.y : at.z) = x;
                      return setting(object, name, InputValue<Exact>(next))(w);
                    });
    }
  }
}

// One more of a row, one less; as far as the algorithm takes them.
template <class Row, class More, class Fewer>
void draw_count(Ui& ui, StudioFields& fields, std::size_t object, const InputSpec& spec, std::size_t count,
                const Row& row, const More& more, const Fewer& fewer) {
  const std::string name(spec.name);
  const auto button = [&](const char* label, const char* what, bool can, const auto& change) {
    if (!can) return;
    if (count > 0 || what == std::string_view("less")) ImGui::SameLine(0, ui.px(3));
    if (!ui.button(label, "make " + name + " " + what)) return;
    Row next = row;
    change(next);
    fields.send(name, words(spec.name), setting(object, name, InputValue<Exact>(std::move(next))));
  };
  button("+", "more", count < static_cast<std::size_t>(spec.at_most) && count < few, more);
  button("\u2212", "less", count > static_cast<std::size_t>(spec.at_least), fewer);
}

// Such as the knots of a refinement.
void draw_numbers(Ui& ui, StudioFields& fields, std::size_t object, const std::string& name,
                  const std::vector<Exact>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % 4 != 0) ImGui::SameLine(0, ui.px(3));
    fields.number({name + "[" + std::to_string(i) + "]", name + " " + std::to_string(i), numbers[i],
                   NumberStyle::parameter, ui.px(60)},
                  [=](const Workspace& w, const Exact& x) {
                    auto next = numbers;
                    next[i] = x;
                    return setting(object, name, InputValue<Exact>(next))(w);
                  });
  }
}

void draw_input(Ui& ui, StudioFields& fields, const Studio& studio, const Recipe& recipe, const InputSpec& spec,
                float left) {
  const std::size_t object = *studio.current();
  const std::string name(spec.name);
  const auto found = recipe.inputs.find(spec.name);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words(spec.name).c_str());
  if (ImGui::IsItemHovered()) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ui.px(360));
    ImGui::TextUnformatted(spec.description.data(), spec.description.data() + spec.description.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  ImGui::SameLine(left, 0);
  ImGui::BeginGroup();
  if (found != recipe.inputs.end() && std::holds_alternative<std::vector<Reference>>(found->second)) {
    draw_sources(ui, fields, studio, name, std::get<std::vector<Reference>>(found->second));
  } else if (const auto value = value_of(recipe, spec)) {
    if (const auto* number = std::get_if<Exact>(&*value)) {
      fields.number({name, name, *number, NumberStyle::parameter, ui.px(100)},
                    [object, name](const Workspace& w, const Exact& x) {
                      return setting(object, name, InputValue<Exact>(x))(w);
                    });
    } else if (const auto* whole = std::get_if<int>(&*value)) {
      if (const auto to = draw_stepper(ui, "make " + name, *whole, spec.at_least, spec.at_most))
        fields.send(name, words(name) + " " + std::to_string(*to), setting(object, name, InputValue<Exact>(*to)));
    } else if (const auto* choice = std::get_if<std::string>(&*value)) {
      std::vector<std::string> choices(spec.choices.begin(), spec.choices.end());
      const auto at = static_cast<std::size_t>(std::ranges::find(choices, *choice) - choices.begin());
      if (const auto to = combo(ui, "make " + name, choices, at, ui.px(170)))
        fields.send(name, words(name) + " " + choices[*to], setting(object, name, InputValue<Exact>(choices[*to])));
    } else if (const auto* row = std::get_if<PointRow<Exact>>(&*value); row != nullptr && row->points.size() <= few) {
      draw_points(ui, fields, object, name, *row);
      const auto* made = std::get_if<Curve<Exact>>(&studio.object()->geometry);
      const int dimension = row->points.empty() ? (made != nullptr ? made->dimension : 3) : row->dimension;
      draw_count(
          ui, fields, object, spec, row->points.size(), *row,
          [dimension](PointRow<Exact>& next) {
            next.dimension = dimension;
            next.points.emplace_back(1, 0, 0, 1);
          },
          [](PointRow<Exact>& next) { next.points.pop_back(); });
    } else if (const auto* numbers = std::get_if<std::vector<Exact>>(&*value);
               numbers != nullptr && numbers->size() <= few) {
      draw_numbers(ui, fields, object, name, *numbers);
      draw_count(
          ui, fields, object, spec, numbers->size(), *numbers,
          [at = studio.object()->u](std::vector<Exact>& next) { next.push_back(at); },
          [](std::vector<Exact>& next) { next.pop_back(); });
    } else {
      std::string text = write_input<Exact>(*value);
      std::erase(text, '"');
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("%s", shortened(text, std::max(ImGui::GetContentRegionAvail().x, ui.px(60))).c_str());
    }
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("as given");
  }
  ImGui::EndGroup();
  fields.mark(name);
  fields.say();
}

void draw_recipe(Ui& ui, StudioFields& fields, const Studio& studio, const Recipe& recipe) {
  ui.heading(("Made by " + std::string(recipe.algorithm->title)).c_str());
  float left = 0;
  for (const InputSpec& spec : recipe.algorithm->inputs)
    left = std::max(left, ImGui::CalcTextSize(words(spec.name).c_str()).x);
  left += ImGui::GetCursorPosX() + ui.px(12);
  for (const InputSpec& spec : recipe.algorithm->inputs) draw_input(ui, fields, studio, recipe, spec, left);
  if (!studio.object()->problem.empty()) fields.say(studio.object()->problem);
  ui.action_button("studio.step", "How was this made?");
  ImGui::SameLine();
  if (ui.button("Detach", "make detach", true, "From now on it is given, and does not follow what it was made from"))
    send_studio(ui, [](Studio& s) {
      if (s.current()) s.edit(edit::detach(s.workspace(), *s.current()), "detach");
    });
}

// The algorithms that take what is chosen, by family.
void draw_offers(Ui& ui, const Studio& studio) {
  const auto offered = algorithms_for(studio.workspace(), studio.chosen());
  if (offered.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled(
        "Choose a curve, a surface or points to see what can be made of it; Ctrl+click chooses "
        "several, such as the two curves of a ruled surface.");
    ImGui::PopTextWrapPos();
    return;
  }
  std::optional<Family> family;
  for (const Algorithm* algorithm : offered) {
    if (family != algorithm->family) {
      family = algorithm->family;
      ImGui::Dummy({0, ui.px(2)});
      ui.heading(family_title(*family));
    }
    const std::string id(algorithm->id);
    ImGui::PushID(id.c_str());
    if (ui.button("Apply", "make apply " + id, true, "Its result becomes a thing of the scene"))
      send_studio(ui, [algorithm](Studio& s) { s.apply(*algorithm); });
    ImGui::SameLine(0, ui.px(3));
    if (ui.button("Step", "make step " + id, true, "Step through it, with what is chosen as its inputs"))
      ui.send([algorithm](Player& player) { player.step_with(*algorithm); });
    ImGui::SameLine();
    ImGui::TextUnformatted(algorithm->title.data(), algorithm->title.data() + algorithm->title.size());
    if (ImGui::IsItemHovered()) {
      ImGui::BeginTooltip();
      ImGui::PushTextWrapPos(ui.px(380));
      ImGui::TextUnformatted(algorithm->summary.data(), algorithm->summary.data() + algorithm->summary.size());
      ImGui::PopTextWrapPos();
      ImGui::EndTooltip();
    }
    ImGui::PopID();
  }
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  ImGui::BeginChild("make form", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  StudioFields fields(ui, model);
  fields.set_wrap(ImGui::GetContentRegionAvail().x);
  if (studio.object() != nullptr && studio.object()->recipe) draw_recipe(ui, fields, studio, *studio.object()->recipe);
  draw_offers(ui, studio);
  for (const Diagnostic& problem : studio.problems()) fields.say(printable(problem.message));
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_studio_make() {
  static const Panel panel{"make", "Make", Slot::tabs, 0, draw, nullptr, nullptr, 0, true, true};
  return panel;
}

}  // namespace blossom
