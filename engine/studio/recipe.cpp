// Which algorithms can be applied to which things, and how.

#include <algorithm>

#include "studio/remake.hpp"

namespace blossom {
namespace {

using Type = InputSpec::Type;

bool is_kind(Type type, const Geometry& geometry) {
  switch (type) {
    case Type::curve:
    case Type::curves:
      return std::holds_alternative<Curve<Exact>>(geometry);
    case Type::surface:
      return std::holds_alternative<Surface<Exact>>(geometry);
    case Type::points:
      return std::holds_alternative<PointRow<Exact>>(geometry);
    case Type::net:
      return std::holds_alternative<PointNet<Exact>>(geometry);
    default:
      return false;
  }
}
// A curve stands for its control points, a surface for its net.
bool can_stand_for(Type type, const Geometry& geometry) {
  return (type == Type::points && std::holds_alternative<Curve<Exact>>(geometry)) ||
         (type == Type::net && std::holds_alternative<Surface<Exact>>(geometry));
}

// Which things go into which input, by the order in which they were chosen: first what is asked for by name, then
// what may stand for it.
class Dealing {
 public:
  Dealing(const Algorithm& algorithm, const Workspace& workspace, const std::vector<std::size_t>& objects)
      : algorithm_(algorithm), workspace_(workspace), objects_(objects), used_(objects.size(), false) {
    deal_singles();
    deal_lists();
    for (const InputSpec& spec : algorithm_.inputs)
      if (given_.count(spec.name) == 0) take(spec, can_stand_for);
  }

  // All inputs that need things have them, and all things are used.
  bool is_complete() const {
    if (!std::ranges::all_of(used_, [](bool used) { return used; })) return false;
    return std::ranges::all_of(algorithm_.inputs, [&](const InputSpec& spec) {
      return !needs_things(spec) || !spec.fallback.empty() || given_.count(spec.name) != 0;
    });
  }
  const std::map<std::string_view, std::vector<std::size_t>>& given() const { return given_; }

 private:
  static bool needs_things(const InputSpec& spec) {
    return spec.type == Type::curve || spec.type == Type::surface || spec.type == Type::curves ||
           spec.type == Type::points || spec.type == Type::net;
  }
  const Geometry& geometry(std::size_t i) const { return workspace_.objects[objects_[i]].geometry; }

  bool take(const InputSpec& spec, bool (*accepts)(Type, const Geometry&)) {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (used_[i] || !accepts(spec.type, geometry(i))) continue;
      used_[i] = true;
      given_[spec.name].push_back(objects_[i]);
      return true;
    }
    return false;
  }

  void deal_singles() {
    for (const InputSpec& spec : algorithm_.inputs)
      if (needs_things(spec) && spec.type != Type::curves) take(spec, is_kind);
  }

  // Each list gets as many as it needs at least, and its share of the rest.
  void deal_lists() {
    std::vector<const InputSpec*> lists;
    std::size_t least = 0, rest = 0;
    for (const InputSpec& spec : algorithm_.inputs)
      if (spec.type == Type::curves) {
        lists.push_back(&spec);
        least += static_cast<std::size_t>(spec.at_least);
      }
    for (std::size_t i = 0; i < objects_.size(); ++i) rest += !used_[i] && is_kind(Type::curve, geometry(i)) ? 1 : 0;
    if (lists.empty() || rest < least) return;
    rest -= least;
    for (std::size_t l = 0; l < lists.size(); ++l) {
      const std::size_t sharing = lists.size() - l, share = (rest + sharing - 1) / sharing;
      rest -= share;
      for (std::size_t i = static_cast<std::size_t>(lists[l]->at_least) + share; i > 0; --i) take(*lists[l], is_kind);
    }
  }

  const Algorithm& algorithm_;
  const Workspace& workspace_;
  const std::vector<std::size_t>& objects_;
  std::vector<bool> used_;
  std::map<std::string_view, std::vector<std::size_t>> given_;
};

// The first thing with a domain, along which numbers lie.
const SceneObject* looked_at(const Workspace& workspace, const std::vector<std::size_t>& objects) {
  for (const std::size_t i : objects)
    if (domain_of(workspace.objects[i].geometry, 0)) return &workspace.objects[i];
  return nullptr;
}

Exact usual_number(const InputSpec& spec, const SceneObject* thing) {
  if (thing == nullptr) return Exact::ratio(1, 2);
  if (spec.name == "u") return thing->u;
  if (spec.name == "v" && domain_of(thing->geometry, 1)) return thing->v;
  const auto [a, b] = *domain_of(thing->geometry, 0);
  return (a + b) / Exact(2);
}

std::vector<Exact> evenly_inside(int count, const SceneObject* thing) {
  const auto domain = thing != nullptr ? domain_of(thing->geometry, 0) : std::nullopt;
  const auto [a, b] = domain.value_or(std::pair(Exact(0), Exact(1)));
  std::vector<Exact> numbers;
  for (int i = 1; i <= count; ++i) numbers.push_back(a + (b - a) * Exact::ratio(i, count + 1));
  return numbers;
}

std::optional<InputValue<Exact>> usual_value(const InputSpec& spec, const SceneObject* thing) {
  switch (spec.type) {
    case Type::number:
      return usual_number(spec, thing);
    case Type::integer:
      return spec.at_least;
    case Type::choice:
      return std::string(spec.choices.front());
    case Type::numbers:
      return evenly_inside(std::max(spec.at_least, 1), thing);
    default:
      return std::nullopt;
  }
}

// Where numbers may lie: middles of the spans, the longest first, then the knots between them.
std::vector<Exact> places_along(const Geometry& geometry, int direction) {
  std::vector<Exact> U;
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry); curve != nullptr && direction == 0) U = curve->knots;
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry))
    U = surface->knots[static_cast<std::size_t>(direction)];
  const auto domain = domain_of(geometry, direction);
  std::vector<std::pair<Exact, Exact>> middles;  // with the spans' lengths
  std::vector<Exact> knots;
  for (std::size_t i = 0; domain && i + 1 < U.size(); ++i) {
    if (U[i] == U[i + 1] || U[i] < domain->first || domain->second < U[i + 1]) continue;
    middles.emplace_back(U[i + 1] - U[i], (U[i] + U[i + 1]) / Exact(2));
    if (domain->first < U[i]) knots.push_back(U[i]);
  }
  std::ranges::stable_sort(middles, [](const auto& a, const auto& b) { return b.first < a.first; });
  std::vector<Exact> places;
  for (auto& [length, middle] : middles) places.push_back(std::move(middle));
  places.insert(places.end(), knots.begin(), knots.end());
  return places;
}

std::vector<InputValue<Exact>> other_values(const InputSpec& spec, const SceneObject& thing) {
  std::vector<InputValue<Exact>> values;
  constexpr int tries = 30;
  if (spec.type == Type::numbers) {  // more of them
    for (int i = 1; i < tries && spec.at_least + i <= spec.at_most; ++i)
      values.emplace_back(evenly_inside(spec.at_least + i, &thing));
  } else if (spec.type == Type::integer) {
    for (int i = 0; i < tries && spec.at_least + i <= spec.at_most; ++i) values.emplace_back(spec.at_least + i);
  } else if (spec.type == Type::number) {
    for (const int direction : {spec.name == "v" ? 1 : 0, spec.name == "v" ? 0 : 1})
      for (const Exact& place : places_along(thing.geometry, direction)) values.emplace_back(place);
  }
  return values;
}

bool is_complained_about(std::string_view input, const Diagnostics& said) {
  return std::ranges::any_of(said, [&](const Diagnostic& each) {
    return each.path.starts_with(input) && (each.path.size() == input.size() || each.path[input.size()] == '[');
  });
}

// Other values for what the algorithm complains about, where there are some it does not.
void refit(Recipe& recipe, const Workspace& workspace, const SceneObject& thing) {
  for (const InputSpec& spec : recipe.algorithm->inputs) {
    const auto found = recipe.inputs.find(spec.name);
    if (found == recipe.inputs.end()) continue;
    const auto fits = [&] {
      return !is_complained_about(spec.name, inputs_of(workspace, recipe, workspace.objects.size()).diagnostics);
    };
    if (fits()) continue;
    const Ingredient before = found->second;
    const auto others = other_values(spec, thing);
    const bool some = std::ranges::any_of(others, [&](const InputValue<Exact>& other) {
      found->second = other;
      return fits();
    });
    if (!some) found->second = before;
  }
}

Recipe dealt(const Dealing& dealing, const Algorithm& algorithm, const Workspace& workspace,
             const std::vector<std::size_t>& objects) {
  Recipe recipe;
  recipe.algorithm = &algorithm;
  const SceneObject* thing = looked_at(workspace, objects);
  for (const InputSpec& spec : algorithm.inputs) {
    if (const auto given = dealing.given().find(spec.name); given != dealing.given().end()) {
      std::vector<Reference> references;
      for (const std::size_t i : given->second) references.push_back({workspace.objects[i].name, {}});
      recipe.inputs.emplace(std::string(spec.name), std::move(references));
    } else if (spec.fallback.empty()) {
      if (auto value = usual_value(spec, thing)) recipe.inputs.emplace(std::string(spec.name), std::move(*value));
    }
  }
  if (!objects.empty()) refit(recipe, workspace, thing != nullptr ? *thing : workspace.objects[objects.front()]);
  return recipe;
}

}  // namespace

bool takes(const Algorithm& algorithm, const Workspace& workspace, const std::vector<std::size_t>& objects) {
  if (objects.empty()) return false;
  const Dealing dealing(algorithm, workspace, objects);
  if (!dealing.is_complete()) return false;
  const Recipe recipe = dealt(dealing, algorithm, workspace, objects);
  const auto inputs = inputs_of(workspace, recipe, workspace.objects.size());
  return std::ranges::none_of(dealing.given(),
                              [&](const auto& each) { return is_complained_about(each.first, inputs.diagnostics); });
}

std::vector<const Algorithm*> algorithms_for(const Workspace& workspace, const std::vector<std::size_t>& objects) {
  std::vector<const Algorithm*> result;
  std::ranges::copy_if(algorithms(), std::back_inserter(result),
                       [&](const Algorithm* each) { return takes(*each, workspace, objects); });
  std::ranges::stable_sort(result, [](const Algorithm* a, const Algorithm* b) {
    return std::pair(a->family, a->title) < std::pair(b->family, b->title);
  });
  return result;
}

Recipe recipe_for(const Algorithm& algorithm, const Workspace& workspace, const std::vector<std::size_t>& objects) {
  return dealt(Dealing(algorithm, workspace, objects), algorithm, workspace, objects);
}

}  // namespace blossom
