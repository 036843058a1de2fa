#include "studio/remake.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/document.hpp"
#include "kernel/error.hpp"
#include "studio/edit_parts.hpp"

namespace blossom {

using edit::parts::refused;

std::size_t point_count(const Geometry& geometry) {
  return std::visit([](const auto& each) { return each.points.size(); }, geometry);
}

std::size_t point_count(const Workspace& workspace) {
  std::size_t count = 0;
  for (const SceneObject& object : workspace.objects) count += point_count(object.geometry);
  return count;
}

std::size_t point_count(const Inputs<Exact>& inputs) {
  std::size_t count = 0;
  for (const auto& [name, value] : inputs.values)
    std::visit(
        [&](const auto& each) {
          using T = std::decay_t<decltype(each)>;
          if constexpr (requires { each.points; })
            count += each.points.size();
          else if constexpr (std::is_same_v<T, std::vector<Curve<Exact>>>)
            for (const auto& curve : each) count += curve.points.size();
        },
        value);
  return count;
}

std::vector<std::string> sources_of(const Recipe& recipe) {
  std::vector<std::string> names;
  for (const auto& [input, ingredient] : recipe.inputs)
    if (const auto* references = std::get_if<std::vector<Reference>>(&ingredient))
      for (const Reference& reference : *references)
        if (std::ranges::find(names, reference.object) == names.end()) names.push_back(reference.object);
  return names;
}

// ---- inputs ---------------------------------------------------------------------------------------------------------

namespace {

// The place of each control point, for algorithms that want points. One of weight 0 has none.
Checked<std::vector<HPoint<Exact>>> places(const std::vector<HPoint<Exact>>& points, const std::string& path) {
  std::vector<HPoint<Exact>> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const HPoint<Exact>& P = points[i];
    if (P.w == Exact(0))
      return refused(path,
                     "is made of points, but the control point " + std::to_string(i) + " has weight 0 and no place");
    result.emplace_back(P.x / P.w, P.y / P.w, P.z / P.w, Exact(1));
  }
  return result;
}

bool is_finite(const Geometry& geometry) {
  return std::visit(
      [](const auto& each) {
        return std::ranges::all_of(each.points, [](const HPoint<Exact>& P) {
          const double w = P.w.to_double(), scale = w > 0 ? 1 / w : 1;
          const double sum = std::abs(P.x.to_double()) + std::abs(P.y.to_double()) + std::abs(P.z.to_double());
          return std::isfinite(sum + w) && std::isfinite(sum * scale);
        });
      },
      geometry);
}

std::string wanted(InputSpec::Type type) {
  switch (type) {
    case InputSpec::Type::curve:
    case InputSpec::Type::curves:
      return "a curve";
    case InputSpec::Type::surface:
      return "a surface";
    case InputSpec::Type::points:
      return "points in a row";
    case InputSpec::Type::net:
      return "points in rows and columns";
    default:
      return "";
  }
}
std::string described(const Geometry& geometry) {
  constexpr std::array<std::string_view, 4> words{"a curve", "a surface", "points in a row",
                                                  "points in rows and columns"};
  return std::string(words[geometry.index()]);
}

// The thing as what an input of this type is, if it can be that.
Checked<InputValue<Exact>> as_input(InputSpec::Type type, const Geometry& geometry, const std::string& path) {
  using Type = InputSpec::Type;
  if (type == Type::curve || type == Type::curves) {
    if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) return InputValue<Exact>(*curve);
  } else if (type == Type::surface) {
    if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) return InputValue<Exact>(*surface);
  } else if (type == Type::points) {
    if (const auto* row = std::get_if<PointRow<Exact>>(&geometry)) return InputValue<Exact>(*row);
    if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) {
      auto points = places(curve->points, path);
      if (!points) return points.diagnostics;
      return InputValue<Exact>(PointRow<Exact>{std::move(*points), curve->dimension});
    }
  } else if (type == Type::net) {
    if (const auto* net = std::get_if<PointNet<Exact>>(&geometry)) return InputValue<Exact>(*net);
    if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) {
      auto points = places(surface->points, path);
      if (!points) return points.diagnostics;
      return InputValue<Exact>(PointNet<Exact>{surface->rows, surface->columns, std::move(*points)});
    }
  }
  return refused(path, "must be " + wanted(type) + ", not " + described(geometry));
}

bool is_of_things(InputSpec::Type type) { return !wanted(type).empty(); }

Checked<InputValue<Exact>> looked_up(const Workspace& workspace, std::size_t before, InputSpec::Type type,
                                     const Reference& reference, const std::string& path) {
  const auto index = workspace.index_of(reference.object);
  if (!index) return refused(path, "there is no thing called " + excerpt(reference.object));
  if (*index >= before)
    return refused(path, excerpt(reference.object) + " comes later: a thing can only be made from those before it");
  const Geometry& geometry = workspace.objects[*index].geometry;
  if (reference.place.is_identity()) return as_input(type, geometry, path);
  const Geometry instance =
      std::visit([&](const auto& each) -> Geometry { return placed(each, reference.place); }, geometry);
  if (!is_finite(instance)) return refused(path, "is placed too far away; at most about 1.8e308");
  return as_input(type, instance, path);
}

// How many of them a list may have; nothing: it is no list.
std::optional<std::size_t> size_of(const InputValue<Exact>& value) {
  if (const auto* curves = std::get_if<std::vector<Curve<Exact>>>(&value)) return curves->size();
  if (const auto* numbers = std::get_if<std::vector<Exact>>(&value)) return numbers->size();
  if (const auto* row = std::get_if<PointRow<Exact>>(&value)) return row->points.size();
  return std::nullopt;
}

Diagnostics wrong_size(const InputSpec& spec, const InputValue<Exact>& value) {
  const auto size = size_of(value);
  const auto least = static_cast<std::size_t>(spec.at_least), most = static_cast<std::size_t>(spec.at_most);
  if (!size || (*size >= least && (most == 0 || *size <= most))) return {};
  const std::string things = spec.type == InputSpec::Type::curves   ? " curves"
                             : spec.type == InputSpec::Type::points ? " points"
                                                                    : " numbers";
  return refused(std::string(spec.name),
                 "needs " + (*size < least ? "at least " + std::to_string(least) : "at most " + std::to_string(most)) +
                     things + ", not " + std::to_string(*size));
}

// Whether a value of its own is of the type the input has.
bool fits(const InputSpec& spec, const InputValue<Exact>& value) {
  using Type = InputSpec::Type;
  switch (spec.type) {
    case Type::number:
      return std::holds_alternative<Exact>(value);
    case Type::integer: {
      const int* i = std::get_if<int>(&value);
      return i != nullptr && *i >= spec.at_least && *i <= spec.at_most;
    }
    case Type::choice: {
      const auto* choice = std::get_if<std::string>(&value);
      return choice != nullptr && std::ranges::find(spec.choices, *choice) != spec.choices.end();
    }
    case Type::curve:
      return std::holds_alternative<Curve<Exact>>(value);
    case Type::surface:
      return std::holds_alternative<Surface<Exact>>(value);
    case Type::curves:
      return std::holds_alternative<std::vector<Curve<Exact>>>(value);
    case Type::numbers:
      return std::holds_alternative<std::vector<Exact>>(value);
    case Type::points:
      return std::holds_alternative<PointRow<Exact>>(value);
    case Type::net:
      return std::holds_alternative<PointNet<Exact>>(value);
  }
  return false;
}

Checked<InputValue<Exact>> value_of(const Workspace& workspace, std::size_t before, const InputSpec& spec,
                                    const Ingredient& ingredient) {
  const std::string name(spec.name);
  if (const auto* own = std::get_if<InputValue<Exact>>(&ingredient)) {
    if (fits(spec, *own)) return *own;
    return refused(name, "is not what this input takes: " + std::string(spec.description));
  }
  const auto& references = std::get<std::vector<Reference>>(ingredient);
  if (!is_of_things(spec.type)) return refused(name, "cannot be a thing: " + std::string(spec.description));
  if (spec.type != InputSpec::Type::curves) {
    if (references.size() != 1) return refused(name, "needs one thing, not " + std::to_string(references.size()));
    return looked_up(workspace, before, spec.type, references[0], name);
  }
  std::vector<Curve<Exact>> curves;
  Diagnostics wrong;
  for (std::size_t i = 0; i < references.size(); ++i) {
    auto curve = looked_up(workspace, before, spec.type, references[i], edit::parts::at(name, i));
    if (curve)
      curves.push_back(std::get<Curve<Exact>>(std::move(*curve)));
    else
      wrong.insert(wrong.end(), curve.diagnostics.begin(), curve.diagnostics.end());
  }
  if (!wrong.empty()) return wrong;
  return InputValue<Exact>(std::move(curves));
}

InputValue<Exact> fallback_of(const InputSpec& spec) {
  const auto document = JsonDocument::parse("default", std::string(spec.fallback));
  Diagnostics none_expected;
  return *read_input(spec, Cursor(*document, none_expected));
}

// A document in which every input stands, so that cursors into it have the right paths.
JsonDocument stand_in(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  const auto list = [](std::size_t count, std::string_view item) {
    std::string text = "[";
    for (std::size_t i = 0; i < count; ++i) text.append(i > 0 ? "," : "").append(item);
    return text + "]";
  };
  std::string text = "{";
  for (const InputSpec& spec : algorithm.inputs) {
    const auto found = inputs.values.find(spec.name);
    std::string item = "0";
    if (found != inputs.values.end()) {
      if (const auto size = size_of(found->second)) item = list(*size, "0");
      if (const auto* net = std::get_if<PointNet<Exact>>(&found->second))
        item = list(static_cast<std::size_t>(net->rows), list(static_cast<std::size_t>(net->columns), "0"));
    }
    text += (text.size() > 1 ? "," : "") + json_quote(spec.name) + ":" + item;
  }
  return std::move(*JsonDocument::parse("inputs", text + "}"));
}

}  // namespace

Diagnostics complaints(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  Diagnostics diagnostics;
  if (algorithm.check == nullptr) return diagnostics;
  const JsonDocument document = stand_in(algorithm, inputs);
  const Cursor root(document, diagnostics);
  algorithm.check(inputs, [&](std::string_view name) { return root.optional(name).value_or(root); });
  for (Diagnostic& each : diagnostics) {  // lines and columns are of a text that nobody has seen
    each.file.clear();
    each.line = each.column = 0;
  }
  return diagnostics;
}

Checked<Inputs<Exact>> inputs_of(const Workspace& workspace, const Recipe& recipe, std::size_t before) {
  Diagnostics wrong;
  const auto add = [&](const Diagnostics& more) { wrong.insert(wrong.end(), more.begin(), more.end()); };
  for (const auto& [name, ingredient] : recipe.inputs)
    if (recipe.algorithm->input(name) == nullptr)
      add(refused(name, "is no input of " + std::string(recipe.algorithm->id)));
  Inputs<Exact> inputs;
  for (const InputSpec& spec : recipe.algorithm->inputs) {
    const auto given = recipe.inputs.find(spec.name);
    if (given == recipe.inputs.end() && spec.fallback.empty()) {
      add(refused(std::string(spec.name), "is missing: " + std::string(spec.description)));
      continue;
    }
    auto value = given == recipe.inputs.end() ? Checked<InputValue<Exact>>(fallback_of(spec))
                                              : value_of(workspace, before, spec, given->second);
    if (value) add(wrong_size(spec, *value));
    if (value)
      inputs.values.emplace(std::string(spec.name), std::move(*value));
    else
      add(value.diagnostics);
  }
  if (wrong.empty() && point_count(inputs) > most_recipe_points)
    add(refused("", "is made from more than " + std::to_string(most_recipe_points) + " points"));
  if (wrong.empty()) wrong = complaints(*recipe.algorithm, inputs);
  if (!wrong.empty()) return wrong;
  return inputs;
}

// ---- making ---------------------------------------------------------------------------------------------------------

namespace {

// About 20 milliseconds of exact arithmetic.
constexpr std::uint64_t exact_work = 2'000'000;

bool is_approximate(const std::vector<Exact>& numbers) {
  return std::ranges::any_of(numbers, [](const Exact& x) { return x.is_approximate(); });
}
bool is_approximate(const std::vector<HPoint<Exact>>& points) {
  return std::ranges::any_of(points, [](const HPoint<Exact>& P) {
    return P.x.is_approximate() || P.y.is_approximate() || P.z.is_approximate() || P.w.is_approximate();
  });
}
bool is_approximate(const Curve<Exact>& curve) { return is_approximate(curve.points) || is_approximate(curve.knots); }
bool is_approximate(const std::vector<Curve<Exact>>& curves) {
  return std::ranges::any_of(curves, [](const auto& curve) { return is_approximate(curve); });
}
bool is_approximate(const Surface<Exact>& surface) {
  return is_approximate(surface.points) || is_approximate(surface.knots[0]) || is_approximate(surface.knots[1]);
}
bool is_approximate(const PointRow<Exact>& row) { return is_approximate(row.points); }
bool is_approximate(const PointNet<Exact>& net) { return is_approximate(net.points); }
bool is_approximate(int) { return false; }
bool is_approximate(const std::string&) { return false; }
bool is_approximate(const Inputs<Exact>& inputs) {
  return std::ranges::any_of(inputs.values, [](const auto& each) {
    return std::visit([](const auto& value) { return is_approximate(value); }, each.second);
  });
}

// What is known in doubles, as exact numbers that are marked.
Exact marked(const Exact& x) { return x; }
Exact marked(double x) { return Exact::approximate(x); }
template <Scalar S>
std::vector<Exact> marked(const std::vector<S>& numbers) {
  std::vector<Exact> result;
  result.reserve(numbers.size());
  for (const S& x : numbers) result.push_back(marked(x));
  return result;
}
template <Scalar S>
std::vector<HPoint<Exact>> marked(const std::vector<HPoint<S>>& points) {
  std::vector<HPoint<Exact>> result;
  result.reserve(points.size());
  for (const HPoint<S>& P : points) result.emplace_back(marked(P.x), marked(P.y), marked(P.z), marked(P.w));
  return result;
}
template <Scalar S>
Curve<Exact> marked(const Curve<S>& c) {
  return {c.degree, marked(c.knots), marked(c.points), c.dimension, c.rational, c.bezier};
}
template <Scalar S>
Surface<Exact> marked(const Surface<S>& s) {
  return {s.degree, {marked(s.knots[0]), marked(s.knots[1])}, s.rows, s.columns, marked(s.points), s.rational,
          s.bezier};
}

// A point lies in the plane if everything it is made from does.
int dimension_of(const Inputs<Exact>& inputs) {
  int dimension = 2;
  for (const auto& [name, value] : inputs.values) {
    if (const auto* curve = std::get_if<Curve<Exact>>(&value)) dimension = std::max(dimension, curve->dimension);
    if (const auto* row = std::get_if<PointRow<Exact>>(&value)) dimension = std::max(dimension, row->dimension);
    if (std::holds_alternative<Surface<Exact>>(value) || std::holds_alternative<PointNet<Exact>>(value)) dimension = 3;
    if (const auto* curves = std::get_if<std::vector<Curve<Exact>>>(&value))
      for (const auto& curve : *curves) dimension = std::max(dimension, curve.dimension);
  }
  return dimension;
}

template <Scalar S>
Checked<std::vector<Geometry>> as_geometry(const Outcome<S>& outcome, const Inputs<Exact>& inputs) {
  std::vector<Geometry> pieces;
  if (const auto* P = std::get_if<HPoint<S>>(&outcome)) {
    if (P->w == S(0)) return refused("", "the point lies at infinity: its weight is 0");
    PointRow<Exact> row{{HPoint<Exact>(marked(S(P->x / P->w)), marked(S(P->y / P->w)), marked(S(P->z / P->w)), 1)},
                        dimension_of(inputs)};
    pieces.emplace_back(std::move(row));
  } else if (const auto* curve = std::get_if<Curve<S>>(&outcome)) {
    pieces.emplace_back(marked(*curve));
  } else if (const auto* surface = std::get_if<Surface<S>>(&outcome)) {
    pieces.emplace_back(marked(*surface));
  } else if (const auto* curves = std::get_if<std::vector<Curve<S>>>(&outcome)) {
    for (const auto& each : *curves) pieces.emplace_back(marked(each));
  } else {
    for (const auto& each : std::get<std::vector<Surface<S>>>(outcome)) pieces.emplace_back(marked(each));
  }
  if (pieces.empty()) return refused("", "nothing comes of it");
  return pieces;
}

// Nothing if the fractions grow too long, or beyond what doubles hold.
std::optional<Checked<std::vector<Geometry>>> made_exactly(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  const ExactBudget budget(exact_work);
  try {
    auto pieces = as_geometry<Exact>(algorithm.in_exact.plain(inputs), inputs);
    if (pieces && !std::ranges::all_of(*pieces, is_finite)) return std::nullopt;
    return pieces;
  } catch (const KernelError& error) {
    return Diagnostics{{"", 0, 0, error.input, error.message}};
  } catch (const ExactTooLarge&) {
    return std::nullopt;
  }
}

}  // namespace

Checked<std::vector<Geometry>> made_by(const Algorithm& algorithm, const Inputs<Exact>& inputs, bool quick) {
  if (!quick && !is_approximate(inputs))
    if (auto pieces = made_exactly(algorithm, inputs)) return *std::move(pieces);
  const auto outcome = run_plain<double>(algorithm, inputs);
  if (!outcome) return outcome.diagnostics;
  return as_geometry<double>(*outcome, inputs);
}

Checked<std::vector<Geometry>> made_by(const Workspace& workspace, const Recipe& recipe, std::size_t before,
                                       bool quick) {
  const auto inputs = inputs_of(workspace, recipe, before);
  if (!inputs) return inputs.diagnostics;
  return made_by(*recipe.algorithm, *inputs, quick);
}

std::string problem_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& each : diagnostics) text += (text.empty() ? "" : "\n") + to_string(each);
  return text;
}

namespace {

// Pieces of one result stand one behind the other: it is made once for all of them.
class Maker {
 public:
  Maker(Workspace& workspace, bool quick) : workspace_(workspace), quick_(quick) {}

  void make(std::size_t index) {
    SceneObject& object = workspace_.objects[index];
    Recipe recipe = *object.recipe;
    const std::size_t which = std::exchange(recipe.which, 0);
    if (!last_ || !(*last_ == recipe)) {
      pieces_ = made_by(workspace_, recipe, index, quick_);
      last_ = std::move(recipe);
    }
    object.problem = !pieces_                   ? problem_of(pieces_.diagnostics)
                     : which >= pieces_->size() ? "there are " + std::to_string(pieces_->size()) +
                                                      " pieces, none of number " + std::to_string(which)
                                                : "";
    if (object.problem.empty()) {
      object.geometry = (*pieces_)[which];
      keep_in_domain(object);
    } else if (auto last = edit::parts::as_read(object.geometry)) {
      object.geometry = std::move(*last);
    }
  }

 private:
  Workspace& workspace_;
  bool quick_;
  std::optional<Recipe> last_;
  Checked<std::vector<Geometry>> pieces_;
};

}  // namespace

void remake(Workspace& workspace, bool quick) {
  Maker maker(workspace, quick);
  for (std::size_t i = 0; i < workspace.objects.size(); ++i)
    if (workspace.objects[i].recipe) maker.make(i);
}

void remake_after(Workspace& workspace, const std::vector<std::size_t>& changed, bool quick) {
  Maker maker(workspace, quick);
  std::vector<std::string_view> names;
  for (const std::size_t i : changed) names.push_back(workspace.objects[i].name);
  const std::size_t first = changed.empty() ? workspace.objects.size() : *std::ranges::min_element(changed) + 1;
  for (std::size_t i = first; i < workspace.objects.size(); ++i) {
    const SceneObject& object = workspace.objects[i];
    if (!object.recipe) continue;
    const auto sources = sources_of(*object.recipe);
    if (std::ranges::none_of(sources, [&](const auto& name) { return std::ranges::find(names, name) != names.end(); }))
      continue;
    maker.make(i);
    names.push_back(object.name);
  }
}

}  // namespace blossom
