#include "lesson/place.hpp"

#include <algorithm>

#include "algorithms/selector.hpp"

namespace blossom {
namespace {

constexpr int highest_step = 1'000'000'000;

std::string meant(const std::optional<std::string>& near) {
  return near ? "; did you mean " + excerpt(*near) + "?" : std::string();
}

// "raise[1].decompose" names the innermost phases of a path: whole labels, from the right.
bool ends_with_labels(const std::string& path, const std::string& labels) {
  return path == labels ||
         (path.size() > labels.size() && path.ends_with(labels) && path[path.size() - labels.size() - 1] == '.');
}

std::string path_of(const TraceGraph& trace, std::uint32_t phase) {
  std::string path;
  for (const std::uint32_t outer : trace.phase_path(phase))
    path += (path.empty() ? "" : ".") + trace.phases()[outer].label();
  return path;
}

std::optional<Place> read_object(const Cursor& at) {
  static const std::vector<std::pair<std::string, Place::Kind>> kinds{
      {"last", Place::Kind::last},   {"every", Place::Kind::every}, {"level", Place::Kind::level},
      {"phase", Place::Kind::phase}, {"after", Place::Kind::after}, {"step", Place::Kind::step}};
  std::vector<std::string> keys;
  for (const auto& [key, kind] : kinds) keys.push_back(key);
  if (!at.expect_object(keys)) return std::nullopt;
  std::optional<Cursor> found;
  Place place;
  for (const auto& [key, kind] : kinds) {
    const auto here = at.optional(key);
    if (!here) continue;
    if (found) {
      here->error("must be the only key of its place");
      return std::nullopt;
    }
    found = here;
    place.kind = kind;
  }
  if (!found) {
    at.error(R"(must have one of "last", "every", "level", "phase", "after" and "step")");
    return std::nullopt;
  }
  if (place.kind == Place::Kind::step || place.kind == Place::Kind::level) {
    const auto number = found->integer(0, highest_step);
    if (!number) return std::nullopt;
    place.step = static_cast<std::uint32_t>(*number);
    return place;
  }
  auto text = found->string();
  if (!text) return std::nullopt;
  std::string error;
  if ((place.kind == Place::Kind::last || place.kind == Place::Kind::every) && !Selector::parse(*text, error)) {
    found->error("is no selector: " + error);
    return std::nullopt;
  }
  place.text = *std::move(text);
  return place;
}

}  // namespace

std::optional<Place> read_place(const Cursor& at) {
  if (at.is(Json::Kind::object)) return read_object(at);
  if (!at.is(Json::Kind::string)) {
    at.error(
        R"(must be a selector such as "P[1][0]", "start", "end", or an object such as {"phase": "parameters"} or {"step": 3})");
    return std::nullopt;
  }
  const std::string& text = at.json().text;
  if (text == "start") return Place{Place::Kind::start, 0, {}};
  if (text == "end") return Place{Place::Kind::end, 0, {}};
  std::string error;
  if (!Selector::parse(text, error)) {
    at.error("is no selector: " + error);
    return std::nullopt;
  }
  return Place{Place::Kind::value, 0, text};
}

std::string write_place(const Place& place) {
  const auto object = [](const char* key, const std::string& value) {
    return "{\"" + std::string(key) + "\": " + value + "}";
  };
  switch (place.kind) {
    case Place::Kind::start:
      return "\"start\"";
    case Place::Kind::end:
      return "\"end\"";
    case Place::Kind::step:
      return object("step", std::to_string(place.step));
    case Place::Kind::level:
      return object("level", std::to_string(place.step));
    case Place::Kind::phase:
      return object("phase", json_quote(place.text));
    case Place::Kind::after:
      return object("after", json_quote(place.text));
    case Place::Kind::last:
      return object("last", json_quote(place.text));
    case Place::Kind::every:
      return object("every", json_quote(place.text));
    case Place::Kind::value:
      return json_quote(place.text);
  }
  return {};
}

std::vector<std::uint32_t> steps_of(const Place& place, const TraceGraph& trace) {
  std::vector<std::uint32_t> steps;
  const auto add_phase = [&](bool after) {
    for (std::uint32_t phase = 0; steps.empty() && phase < trace.phases().size(); ++phase)
      if (ends_with_labels(path_of(trace, phase), place.text))
        steps.push_back(after ? trace.phases()[phase].last_step + 1 : trace.phases()[phase].first_step);
    if (!steps.empty() && steps.back() >= trace.step_count()) steps.clear();
  };
  switch (place.kind) {
    case Place::Kind::start:
      return {0};
    case Place::Kind::end:
      return {trace.step_count() - 1};
    case Place::Kind::step:
      if (place.step < trace.step_count()) steps.push_back(place.step);
      break;
    case Place::Kind::phase:
    case Place::Kind::after:
      add_phase(place.kind == Place::Kind::after);
      break;
    case Place::Kind::level:
      for (ValueId v = 0; steps.empty() && v < trace.value_count(); ++v)
        if (const Name& name = trace.value(v).name;
            !trace.is_input(v) && name.arity == 2 && name.index[0] == static_cast<int>(place.step))
          steps.push_back(trace.value(v).step);
      break;
    case Place::Kind::value:
    case Place::Kind::last:
    case Place::Kind::every: {
      std::string error;
      const auto selector = Selector::parse(place.text, error);
      for (ValueId v = 0; selector && v < trace.value_count(); ++v) {
        if (!selector->matches(trace, v)) continue;
        const std::uint32_t step = trace.value(v).step;
        if (steps.empty() || steps.back() != step) steps.push_back(step);
        if (place.kind == Place::Kind::value) break;
      }
      if (place.kind == Place::Kind::last && steps.size() > 1) steps = {steps.back()};
      break;
    }
  }
  return steps;
}

std::optional<std::uint32_t> step_of(const Place& place, const TraceGraph& trace) {
  const auto steps = steps_of(place, trace);
  return steps.empty() ? std::nullopt : std::optional(steps.front());
}

std::string why_nowhere(const Place& place, const TraceGraph& trace) {
  if (place.kind == Place::Kind::level) return "no value of this run is of level " + std::to_string(place.step);
  if (place.kind == Place::Kind::phase || place.kind == Place::Kind::after) {
    const auto known = step_of({Place::Kind::phase, 0, place.text}, trace);
    if (place.kind == Place::Kind::after && known)
      return "nothing comes behind " + excerpt(place.text) + " in this run";
    std::vector<std::string> labels;
    for (std::uint32_t phase = 0; phase < trace.phases().size(); ++phase) {
      labels.push_back(trace.phases()[phase].label());
      labels.push_back(path_of(trace, phase));
    }
    return "no phase of this run is called " + excerpt(place.text) + meant(did_you_mean(place.text, labels)) +
           (labels.empty() ? "; this algorithm runs in one piece" : "");
  }
  if (place.kind == Place::Kind::step)
    return "must be a whole number from 0 to " + std::to_string(trace.step_count() - 1) + ", not " +
           std::to_string(place.step);
  return "no value of this run is called " + excerpt(place.text) + meant(nearest_name(trace, place.text));
}

std::vector<ValueId> selected_up_to(const std::vector<std::string>& selectors, std::uint32_t step,
                                    const TraceGraph& trace) {
  std::vector<ValueId> selected;
  for (const std::string& text : selectors) {
    std::string error;
    const auto selector = Selector::parse(text, error);
    for (ValueId v = 0; selector && v < trace.value_count() && trace.value(v).step <= step; ++v)
      if (selector->matches(trace, v)) selected.push_back(v);
  }
  std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  return selected;
}

}  // namespace blossom
