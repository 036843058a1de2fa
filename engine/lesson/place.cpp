#include "lesson/place.hpp"

#include <algorithm>
#include <array>

#include "algorithms/selector.hpp"
#include "lesson/names.hpp"

namespace blossom {
namespace {

constexpr int highest_step = 1'000'000'000;
constexpr std::size_t most_labels = 8;  // of phases, told in a message

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
  const std::size_t mistakes = at.error_count();
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
  if (!found && at.errors_since(mistakes)) return std::nullopt;
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
      // The start shows what is given; "every" is about what is made.
      if (place.kind == Place::Kind::every && steps.size() > 1 && steps.front() == 0) steps.erase(steps.begin());
      break;
    }
  }
  return steps;
}

std::optional<std::uint32_t> step_of(const Place& place, const TraceGraph& trace) {
  const auto steps = steps_of(place, trace);
  return steps.empty() ? std::nullopt : std::optional(steps.front());
}

namespace {

std::string no_such_level(const Place& place, const TraceGraph& trace) {
  int least = 0, most = -1;
  for (ValueId v = 0; v < trace.value_count(); ++v) {
    const Name& name = trace.value(v).name;
    if (trace.is_input(v) || name.arity != 2) continue;
    least = most < 0 ? name.index[0] : std::min(least, name.index[0]);
    most = std::max(most, name.index[0]);
  }
  return "no value that this run makes is of level " + std::to_string(place.step) +
         (most < 0 ? "; its values have no levels"
                   : "; the levels are " + std::to_string(least) + " to " + std::to_string(most));
}

std::string no_such_phase(const Place& place, const TraceGraph& trace) {
  if (place.kind == Place::Kind::after && step_of({Place::Kind::phase, 0, place.text}, trace))
    return "nothing comes behind " + excerpt(place.text) + " in this run";
  std::vector<std::string> labels, same;  // same: its name with a number
  for (std::uint32_t phase = 0; phase < trace.phases().size(); ++phase) {
    const std::string label = trace.phases()[phase].label();
    const bool is_new = std::ranges::find(labels, label) == labels.end();
    if (is_new && label.starts_with(place.text + "[")) same.push_back(label);
    if (is_new) labels.push_back(label);
  }
  const std::string message = "no phase of this run is called " + excerpt(place.text);
  if (labels.empty()) return message + "; this algorithm runs in one piece";
  if (same.size() == 1) return message + "; there is " + excerpt(same[0]);
  if (!same.empty()) return message + "; there are " + excerpt(same.front()) + " to " + excerpt(same.back());
  std::vector<std::string> known = labels;
  for (std::uint32_t phase = 0; phase < trace.phases().size(); ++phase) known.push_back(path_of(trace, phase));
  if (const auto near = did_you_mean(place.text, known)) return message + meant(near);
  std::string told = "; the phases are";
  for (std::size_t i = 0; i < labels.size() && i < most_labels; ++i) told += (i == 0 ? " " : ", ") + excerpt(labels[i]);
  return message + told + (labels.size() > most_labels ? ", ..." : "");
}

}  // namespace

std::string why_nowhere(const Place& place, const TraceGraph& trace) {
  switch (place.kind) {
    case Place::Kind::level:
      return no_such_level(place, trace);
    case Place::Kind::phase:
    case Place::Kind::after:
      return no_such_phase(place, trace);
    case Place::Kind::step:
      return "must be a whole number from 0 to " + std::to_string(trace.step_count() - 1) + ", not " +
             std::to_string(place.step);
    default:
      break;
  }
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> other_words{{{"begin", "start"},
                                                                                             {"beginning", "start"},
                                                                                             {"first", "start"},
                                                                                             {"last", "end"},
                                                                                             {"finish", "end"},
                                                                                             {"stop", "end"}}};
  static constexpr std::array<std::string_view, 2> words{"start", "end"};
  const std::string message = "no value of this run is called " + excerpt(place.text);
  if (place.kind != Place::Kind::value) return message + meant_values(place.text, trace);
  for (const auto& [word, is] : other_words)
    if (did_you_mean(word, {place.text})) return message + "; did you mean " + excerpt(is) + "?";
  return message + meant_values(place.text, trace, words);
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
