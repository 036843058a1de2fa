#include "lesson/lesson.hpp"

#include <algorithm>

#include "algorithms/selector.hpp"
#include "lesson/document.hpp"

namespace blossom {

const Beat* Lesson::beat_at(std::uint32_t step) const {
  const auto found =
      std::lower_bound(beats.begin(), beats.end(), step, [](const Beat& b, std::uint32_t s) { return b.step < s; });
  return found != beats.end() && found->step == step ? &*found : nullptr;
}

namespace {

// The run that beats are resolved against; neither while the inputs are wrong, and then only their form is checked.
struct Script {
  const Run<Exact>* run = nullptr;
  const Narrator<Exact>* narrator = nullptr;
};

std::string meant(const std::optional<std::string>& near) {
  return near ? "; did you mean " + excerpt(*near) + "?" : std::string();
}

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
    at.error("no value of this run is called " + excerpt(*text) + meant(nearest_name(script.run->trace, *text)));
    return std::nullopt;
  }
  return values;
}

// "raise[1].decompose" names the innermost phases of a path: whole labels, from the right.
bool ends_with_labels(const std::string& path, const std::string& labels) {
  return path == labels ||
         (path.size() > labels.size() && path.ends_with(labels) && path[path.size() - labels.size() - 1] == '.');
}

std::optional<std::uint32_t> read_phase(const Cursor& at, const Script& script) {
  const auto label = at.string();
  if (!label || script.run == nullptr) return std::nullopt;
  const TraceGraph& trace = script.run->trace;
  std::vector<std::string> labels;
  for (std::uint32_t phase = 0; phase < trace.phases().size(); ++phase) {
    std::string path;
    for (const std::uint32_t outer : trace.phase_path(phase))
      path += (path.empty() ? "" : ".") + trace.phases()[outer].label();
    if (ends_with_labels(path, *label)) return trace.phases()[phase].first_step;
    labels.push_back(trace.phases()[phase].label());
    labels.push_back(std::move(path));
  }
  at.error("no phase of this run is called " + excerpt(*label) + meant(did_you_mean(*label, labels)) +
           (labels.empty() ? "; this algorithm runs in one piece" : ""));
  return std::nullopt;
}

std::optional<std::uint32_t> read_step(const Cursor& at, const Script& script) {
  if (at.is(Json::Kind::object)) {
    if (!at.expect_object({"step", "phase"})) return std::nullopt;
    const auto step = at.optional("step");
    const auto phase = at.optional("phase");
    if (step.has_value() == phase.has_value()) {
      at.error(R"(must have either "step" or "phase")");
      return std::nullopt;
    }
    if (phase) return read_phase(*phase, script);
    const int last = script.run != nullptr ? static_cast<int>(script.run->trace.step_count()) - 1 : 1'000'000'000;
    const auto number = step->integer(0, last);
    return number && script.run != nullptr ? std::optional<std::uint32_t>(*number) : std::nullopt;
  }
  if (!at.is(Json::Kind::string)) {
    at.error(R"(must be a selector such as "P[1][0]", "start", "end", {"step": 3} or {"phase": "parameters"})");
    return std::nullopt;
  }
  if (at.json().text == "start") return 0;
  if (at.json().text == "end")
    return script.run != nullptr ? std::optional<std::uint32_t>(script.run->trace.step_count() - 1) : std::nullopt;
  const auto values = read_selection(at, script);
  if (!values) return std::nullopt;
  return script.run->trace.value(values->front()).step;
}

void check_say(const Cursor& at, const std::string& say, std::optional<std::uint32_t> step, const Script& script) {
  for (std::size_t i = say.find('{'); i != std::string::npos; i = say.find('{', i + 1)) {
    if (const std::size_t end = say.find_first_of("{}", i + 1); end == std::string::npos || say[end] == '{') {
      at.error("a { has no } behind it, at " + excerpt(std::string_view(say).substr(i)));
      return;
    }
  }
  if (!step || script.narrator == nullptr) return;
  std::vector<std::string> unknown;
  script.narrator->fill(say, *step, &unknown);
  for (const std::string& placeholder : unknown) {
    const std::string_view name = std::string_view(placeholder).substr(placeholder.starts_with('#') ? 1 : 0);
    std::string message = excerpt("{" + placeholder + "}") + " names nothing at step " + std::to_string(*step);
    if (const auto later = script.run->trace.find(name))
      message += ": it is made at step " + std::to_string(script.run->trace.value(*later).step);
    else
      message += meant(nearest_name(script.run->trace, name));
    at.error(message);
  }
}

std::vector<ValueId> read_highlight(const Cursor& at, std::optional<std::uint32_t> step, const Script& script) {
  std::vector<ValueId> highlights;
  if (!at.expect_array(1)) return highlights;
  for (std::size_t i = 0; i < at.size(); ++i) {
    auto values = read_selection(at[i], script);
    if (!values || !step) continue;
    const std::uint32_t first = script.run->trace.value(values->front()).step;
    std::erase_if(*values, [&](ValueId v) { return script.run->trace.value(v).step > *step; });
    if (values->empty())
      at[i].error("nothing of it is made yet at step " + std::to_string(*step) + "; the first comes at step " +
                  std::to_string(first));
    highlights.insert(highlights.end(), values->begin(), values->end());
  }
  std::sort(highlights.begin(), highlights.end());
  highlights.erase(std::unique(highlights.begin(), highlights.end()), highlights.end());
  return highlights;
}

std::vector<Beat> read_beats(const Cursor& at, const Script& script) {
  std::vector<Beat> beats;
  if (!at.expect_array(1)) return beats;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Cursor beat = at[i];
    if (!beat.expect_object({"at", "say", "highlight"})) continue;
    Beat made;
    const auto where = beat.required("at");
    const auto step = where ? read_step(*where, script) : std::nullopt;
    if (const auto say = beat.required("say")) {
      if (auto text = read_text(*say)) {
        check_say(*say, *text, step, script);
        made.say = *std::move(text);
      }
    }
    if (const auto highlight = beat.optional("highlight")) made.highlights = read_highlight(*highlight, step, script);
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

void read_optional_text(const Cursor& root, std::string_view key, std::string& text) {
  if (const auto at = root.optional(key)) text = read_text(*at).value_or("");
}

}  // namespace

Checked<Lesson> load_lesson(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  if (!root.expect_object(
          {"$schema", "schema", "id", "title", "unit", "summary", "source", "minutes", "algorithm", "inputs", "beats"}))
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
  if (!diagnostics.empty()) return diagnostics;
  lesson.inputs = std::move(run->inputs);
  return lesson;
}

}  // namespace blossom
