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

std::optional<Place> read_numbered(const Cursor& at) {
  if (!at.expect_object({"step", "phase"})) return std::nullopt;
  const auto step = at.optional("step");
  const auto phase = at.optional("phase");
  if (step.has_value() == phase.has_value()) {
    at.error(R"(must have either "step" or "phase")");
    return std::nullopt;
  }
  if (phase) {
    auto label = phase->string();
    if (!label) return std::nullopt;
    return Place{Place::Kind::phase, 0, *std::move(label)};
  }
  const auto number = step->integer(0, highest_step);
  if (!number) return std::nullopt;
  return Place{Place::Kind::step, static_cast<std::uint32_t>(*number), {}};
}

}  // namespace

std::optional<Place> read_place(const Cursor& at) {
  if (at.is(Json::Kind::object)) return read_numbered(at);
  if (!at.is(Json::Kind::string)) {
    at.error(R"(must be a selector such as "P[1][0]", "start", "end", {"step": 3} or {"phase": "parameters"})");
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
  switch (place.kind) {
    case Place::Kind::start:
      return "\"start\"";
    case Place::Kind::end:
      return "\"end\"";
    case Place::Kind::step:
      return "{\"step\": " + std::to_string(place.step) + "}";
    case Place::Kind::phase:
      return "{\"phase\": " + json_quote(place.text) + "}";
    case Place::Kind::value:
      return json_quote(place.text);
  }
  return {};
}

std::optional<std::uint32_t> step_of(const Place& place, const TraceGraph& trace) {
  switch (place.kind) {
    case Place::Kind::start:
      return 0;
    case Place::Kind::end:
      return trace.step_count() - 1;
    case Place::Kind::step:
      return place.step < trace.step_count() ? std::optional(place.step) : std::nullopt;
    case Place::Kind::phase:
      for (std::uint32_t phase = 0; phase < trace.phases().size(); ++phase)
        if (ends_with_labels(path_of(trace, phase), place.text)) return trace.phases()[phase].first_step;
      return std::nullopt;
    case Place::Kind::value: {
      std::string error;
      const auto selector = Selector::parse(place.text, error);
      for (ValueId v = 0; selector && v < trace.value_count(); ++v)
        if (selector->matches(trace, v)) return trace.value(v).step;
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::string why_nowhere(const Place& place, const TraceGraph& trace) {
  if (place.kind == Place::Kind::phase) {
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
