#include "lesson/lesson.hpp"

#include <algorithm>

#include "algorithms/selector.hpp"

namespace blossom {

const Beat* Lesson::beat_at(std::uint32_t step) const {
  const auto found =
      std::lower_bound(beats.begin(), beats.end(), step, [](const Beat& b, std::uint32_t s) { return b.step < s; });
  return found != beats.end() && found->step == step ? &*found : nullptr;
}

std::vector<Beat> resolve_beats(const Lesson& lesson, const TraceGraph& trace) {
  std::vector<Beat> beats;
  for (const Beat& beat : lesson.beats) {
    const auto step = step_of(beat.at, trace);
    if (!step) continue;
    beats.push_back(beat);
    beats.back().step = *step;
  }
  std::stable_sort(beats.begin(), beats.end(), [](const Beat& a, const Beat& b) { return a.step < b.step; });
  const auto same_step = [](const Beat& a, const Beat& b) { return a.step == b.step; };
  beats.erase(std::unique(beats.begin(), beats.end(), same_step), beats.end());
  for (Beat& beat : beats) beat.highlights = selected_up_to(beat.selectors, beat.step, trace);
  return beats;
}

std::optional<std::size_t> open_brace(std::string_view say) {
  for (std::size_t i = say.find('{'); i != std::string_view::npos; i = say.find('{', i + 1))
    if (const std::size_t end = say.find_first_of("{}", i + 1); end == std::string_view::npos || say[end] == '{')
      return i;
  return std::nullopt;
}

namespace {

// The run that beats are resolved against; neither while the inputs are wrong, and then only their form is checked.
struct Script {
  const Run<Exact>* run = nullptr;
  const Narrator<Exact>* narrator = nullptr;
};

std::optional<std::vector<ValueId>> read_selection(const Cursor& at, const Script& script) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  std::string error;
  const auto selector = Selector::parse(*text, error);
  if (!selector) {
    at.error("is no selector: " + error);
    return std::nullopt;
  }
  if (script.run == nullptr) return std::nullopt;
  auto values = selector->select(script.run->trace);
  if (values.empty()) {
    at.error(why_nowhere({Place::Kind::value, 0, *text}, script.run->trace));
    return std::nullopt;
  }
  return values;
}

std::optional<std::uint32_t> read_step(const Cursor& at, const Script& script, Beat& beat) {
  auto place = read_place(at);
  if (!place) return std::nullopt;
  beat.at = *std::move(place);
  if (script.run == nullptr) return std::nullopt;
  if (const auto step = step_of(beat.at, script.run->trace)) return step;
  (at.is(Json::Kind::object) ? at.member(0) : at).error(why_nowhere(beat.at, script.run->trace));
  return std::nullopt;
}

void check_say(const Cursor& at, const std::string& say, std::optional<std::uint32_t> step, const Script& script) {
  if (const auto open = open_brace(say)) {
    at.error("a { has no } behind it, at " + excerpt(std::string_view(say).substr(*open)));
    return;
  }
  if (!step || script.narrator == nullptr) return;
  for (const std::string& placeholder : unresolved(say, *script.narrator, *step)) {
    const std::string_view name = std::string_view(placeholder).substr(placeholder.starts_with('#') ? 1 : 0);
    std::string message = excerpt("{" + placeholder + "}") + " names nothing at step " + std::to_string(*step);
    if (const auto later = script.run->trace.find(name))
      message += ": it is made at step " + std::to_string(script.run->trace.value(*later).step);
    else if (const auto near = nearest_name(script.run->trace, name))
      message += "; did you mean " + excerpt(*near) + "?";
    at.error(message);
  }
}

void read_highlight(const Cursor& at, std::optional<std::uint32_t> step, const Script& script, Beat& beat) {
  if (!at.expect_array(1)) return;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto values = read_selection(at[i], script);
    if (!values || !step) continue;
    beat.selectors.push_back(at[i].json().text);
    if (const std::uint32_t first = script.run->trace.value(values->front()).step; first > *step)
      at[i].error("nothing of it is made yet at step " + std::to_string(*step) + "; the first comes at step " +
                  std::to_string(first));
  }
  if (step) beat.highlights = selected_up_to(beat.selectors, *step, script.run->trace);
}

std::vector<Beat> read_beats(const Cursor& at, const Script& script) {
  std::vector<Beat> beats;
  if (!at.expect_array(1)) return beats;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Cursor beat = at[i];
    if (!beat.expect_object({"at", "say", "highlight"})) continue;
    Beat made;
    const auto where = beat.required("at");
    const auto step = where ? read_step(*where, script, made) : std::nullopt;
    if (const auto say = beat.required("say")) {
      if (auto text = read_text(*say)) {
        check_say(*say, *text, step, script);
        made.say = *std::move(text);
      }
    }
    if (const auto highlight = beat.optional("highlight")) read_highlight(*highlight, step, script, made);
    if (!step) continue;
    made.step = *step;
    if (!beats.empty() && made.step == beats.back().step)
      where->error("stands at step " + std::to_string(made.step) + " as the beat before does; one beat for each step");
    else if (!beats.empty() && made.step < beats.back().step)
      where->error("stands at step " + std::to_string(made.step) + ", but the beat before at step " +
                   std::to_string(beats.back().step) + ": beats go in the order of the steps");
    beats.push_back(std::move(made));
  }
  return beats;
}

void read_predict(const Cursor& at, const Script& script, Lesson& lesson) {
  if (!at.expect_object({"ask", "marking"})) return;
  if (const auto marking = at.optional("marking")) lesson.marking = read_marking(*marking).value_or(lesson.marking);
  const auto ask = at.optional("ask");
  if (!ask || !ask->expect_array(1)) return;
  for (std::size_t i = 0; i < ask->size(); ++i) {
    const Cursor item = (*ask)[i];
    const auto values = read_selection(item, script);
    if (!values) continue;
    lesson.asks.push_back(item.json().text);
    const TraceGraph& trace = script.run->trace;
    if (std::ranges::all_of(*values, [&](ValueId v) { return trace.is_input(v); }))
      item.error(excerpt(item.json().text) + " is given: there is nothing to predict");
  }
}

void read_optional_text(const Cursor& root, std::string_view key, std::string& text) {
  if (const auto at = root.optional(key)) text = read_text(*at).value_or("");
}

}  // namespace

Checked<Lesson> load_lesson(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  if (!root.expect_object({"$schema", "schema", "id", "title", "unit", "summary", "source", "minutes", "algorithm",
                           "inputs", "beats", "predict"}))
    return diagnostics;
  expect_schema(root, "blossom.lesson/1");
  Lesson lesson;
  if (const auto at = root.required("id")) lesson.id = read_id(*at).value_or("");
  if (const auto at = root.required("title")) lesson.title = read_text(*at).value_or("");
  read_optional_text(root, "unit", lesson.unit);
  read_optional_text(root, "summary", lesson.summary);
  read_optional_text(root, "source", lesson.source);
  if (const auto at = root.optional("minutes")) lesson.minutes = at->integer(1, 600).value_or(0);

  lesson.algorithm = read_algorithm(root);
  std::optional<Run<Exact>> run;
  if (lesson.algorithm != nullptr)
    run = read_run(root, *lesson.algorithm);
  else
    root.required("inputs");

  std::optional<Narrator<Exact>> narrator;
  if (run) narrator.emplace(*run);
  const Script script{run ? &*run : nullptr, narrator ? &*narrator : nullptr};
  if (const auto at = root.required("beats")) lesson.beats = read_beats(*at, script);
  if (const auto at = root.optional("predict")) read_predict(*at, script, lesson);
  if (!diagnostics.empty()) return diagnostics;
  lesson.inputs = std::move(run->inputs);
  return lesson;
}

}  // namespace blossom
