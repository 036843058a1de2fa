#include "lesson/lesson.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "algorithms/selector.hpp"

namespace blossom {

const Beat* LessonScene::beat_at(std::uint32_t step) const {
  const auto found =
      std::lower_bound(beats.begin(), beats.end(), step, [](const Beat& b, std::uint32_t s) { return b.step < s; });
  return found != beats.end() && found->step == step ? &*found : nullptr;
}

std::optional<std::size_t> Lesson::find_scene(std::string_view name) const {
  for (std::size_t i = 0; i < scene_count(); ++i)
    if (name == std::to_string(i + 1) || (!scene_at(i).scene.empty() && scene_at(i).scene == name)) return i;
  return std::nullopt;
}

std::vector<Beat> resolve_beats(const LessonScene& scene, const TraceGraph& trace) {
  std::vector<Beat> beats;
  // Of a scene that was resolved before there is a copy for every step; one of each is enough.
  std::vector<const Beat*> sources;
  for (const Beat& beat : scene.beats) {
    const bool again = beat.at.kind == Place::Kind::every && std::ranges::any_of(sources, [&](const Beat* b) {
                         return b->at == beat.at && b->say == beat.say;
                       });
    if (!again) sources.push_back(&beat);
  }
  // Those at one step first: they are kept.
  std::stable_partition(sources.begin(), sources.end(),
                        [](const Beat* beat) { return beat->at.kind != Place::Kind::every; });
  for (const Beat* beat : sources)
    for (const std::uint32_t step : steps_of(beat->at, trace)) {
      beats.push_back(*beat);
      beats.back().step = step;
      if (beat->at.kind != Place::Kind::every) break;
    }
  std::stable_sort(beats.begin(), beats.end(), [](const Beat& a, const Beat& b) { return a.step < b.step; });
  const auto same_step = [](const Beat& a, const Beat& b) { return a.step == b.step; };
  beats.erase(std::unique(beats.begin(), beats.end(), same_step), beats.end());
  for (Beat& beat : beats) beat.highlights = selected_up_to(beat.selectors, beat.step, trace);
  return beats;
}

namespace {

constexpr std::size_t most_scenes = 20;

void read_predict(const Cursor& at, const TraceGraph* trace, LessonScene& scene) {
  if (!at.expect_object({"ask", "marking"})) return;
  if (const auto marking = at.optional("marking")) scene.marking = read_marking(*marking).value_or(scene.marking);
  const auto ask = at.optional("ask");
  if (!ask || !ask->expect_array(1)) return;
  for (std::size_t i = 0; i < ask->size(); ++i) {
    const Cursor item = (*ask)[i];
    const auto text = item.string();
    if (!text) continue;
    std::string error;
    const auto selector = Selector::parse(*text, error);
    if (!selector) item.error("is no selector: " + error);
    if (!selector || trace == nullptr) continue;
    const auto values = selector->select(*trace);
    if (values.empty()) {
      item.error(why_nowhere({Place::Kind::last, 0, *text}, *trace));
      continue;
    }
    scene.asks.push_back(*text);
    if (std::ranges::all_of(values, [&](ValueId v) { return trace->is_input(v); }))
      item.error(excerpt(*text) + " is given: there is nothing to predict");
  }
}

// What a scene and a lesson of one scene have alike: the keys algorithm, inputs, beats and predict.
void read_run_of_scene(const Cursor& at, const Languages& languages, LessonScene& scene) {
  scene.algorithm = read_algorithm(at);
  std::optional<Run<Exact>> run;
  if (scene.algorithm != nullptr)
    run = read_run(at, *scene.algorithm);
  else
    at.required("inputs");
  std::optional<Narrator<Exact>> narrator;
  if (run) narrator.emplace(*run);
  const Narrator<Exact>* known = narrator ? &*narrator : nullptr;
  const auto inputs = at.optional("inputs");
  if (const auto beats = at.required("beats"))
    scene.beats = read_beats(*beats, languages, known, inputs && run ? &*inputs : nullptr);
  if (const auto predict = at.optional("predict")) read_predict(*predict, run ? &run->trace : nullptr, scene);
  if (!run || at.has_errors()) return;
  scene.beats = resolve_beats(scene, run->trace);
  scene.inputs = std::move(run->inputs);
}

void read_scenes(const Cursor& at, Lesson& lesson) {
  if (!at.expect_array(1, most_scenes)) return;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < at.size(); ++i) {
    LessonScene scene;
    if (!at[i].expect_object({"id", "title", "algorithm", "inputs", "beats", "predict"})) continue;
    if (const auto id = at[i].required("id")) {
      scene.scene = read_id(*id).value_or("");
      if (!scene.scene.empty() && !ids.insert(scene.scene).second)
        id->error(excerpt(scene.scene) + " is the id of an earlier scene already");
    }
    if (const auto title = at[i].required("title"))
      scene.heading = read_local_text(*title, lesson.languages).value_or(LocalText());
    read_run_of_scene(at[i], lesson.languages, scene);
    if (i == 0)
      static_cast<LessonScene&>(lesson) = std::move(scene);
    else
      lesson.others.push_back(std::move(scene));
  }
}

constexpr std::array<std::string_view, 4> of_a_run{"algorithm", "inputs", "beats", "predict"};

void check_beside_scenes(const Cursor& root) {
  std::vector<std::size_t> found;
  std::string names;
  for (std::size_t i = 0; i < root.size(); ++i)
    if (std::ranges::find(of_a_run, root.json().keys[i]) != of_a_run.end()) found.push_back(i);
  for (std::size_t i = 0; i < found.size(); ++i)
    names += (i == 0 ? "" : i + 1 == found.size() ? " and " : ", ") + excerpt(root.json().keys[found[i]]);
  if (!found.empty())
    root.key_error(found[0],
                   names + (found.size() == 1 ? " belongs" : " belong") + " into a scene once there are \"scenes\"");
}

std::vector<std::string> read_ids(const Cursor& at) {
  std::vector<std::string> ids;
  if (!at.expect_array(1)) return ids;
  for (std::size_t i = 0; i < at.size(); ++i) {
    auto id = read_id(at[i]);
    if (!id) continue;
    if (std::ranges::find(ids, *id) != ids.end()) at[i].error(excerpt(*id) + " stands here already");
    ids.push_back(*std::move(id));
  }
  return ids;
}

// No two checkpoints of a lesson have one id, whatever else is wrong with them.
void check_checkpoint_ids(const Cursor& root) {
  std::set<std::string> ids;
  const auto check_scene = [&](const Cursor& scene) {
    const auto beats = scene.optional("beats");
    for (std::size_t i = 0; beats && beats->is(Json::Kind::array) && i < beats->size(); ++i) {
      const auto checkpoint = (*beats)[i].optional("checkpoint");
      const auto id = checkpoint ? checkpoint->optional("id") : std::nullopt;
      if (id && id->is(Json::Kind::string) && !ids.insert(id->json().text).second)
        id->error(excerpt(id->json().text) + " is the id of an earlier checkpoint already; each needs one of its own");
    }
  };
  check_scene(root);
  const auto scenes = root.optional("scenes");
  for (std::size_t i = 0; scenes && scenes->is(Json::Kind::array) && i < scenes->size(); ++i) check_scene((*scenes)[i]);
}

void read_metadata(const Cursor& root, Lesson& lesson) {
  const auto text = [&](std::string_view key, LocalText& into) {
    if (const auto at = root.optional(key)) into = read_local_text(*at, lesson.languages).value_or(LocalText());
  };
  if (const auto at = root.required("id")) lesson.id = read_id(*at).value_or("");
  if (root.required("title")) text("title", lesson.title);
  text("unit", lesson.unit);
  text("summary", lesson.summary);
  if (const auto at = root.optional("source")) lesson.source = read_text(*at).value_or("");
  if (const auto at = root.optional("minutes")) lesson.minutes = at->integer(1, 600).value_or(0);
  if (const auto at = root.optional("objectives"); at && at->expect_array(1, 12))
    for (std::size_t i = 0; i < at->size(); ++i)
      lesson.objectives.push_back(read_local_text((*at)[i], lesson.languages).value_or(LocalText()));
  if (const auto at = root.optional("prerequisites")) {
    lesson.prerequisites = read_ids(*at);
    if (std::ranges::find(lesson.prerequisites, lesson.id) != lesson.prerequisites.end())
      at->error("a lesson cannot be its own prerequisite");
  }
  if (const auto at = root.optional("exercises")) lesson.exercises = read_ids(*at);
  if (const auto at = root.optional("colors")) lesson.colors = read_colors(*at);
}

}  // namespace

Checked<Lesson> load_lesson(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  std::vector<std::string> keys{"$schema",    "schema",        "id",        "title",    "unit",
                                "summary",    "source",        "minutes",   "language", "languages",
                                "objectives", "prerequisites", "exercises", "scenes",   "colors"};
  const bool several = root.is(Json::Kind::object) && root.json().find("scenes") != nullptr;
  keys.insert(keys.end(), of_a_run.begin(), of_a_run.end());
  if (!root.expect_object(keys)) return diagnostics;
  expect_schema(root, "blossom.lesson/1");
  if (const auto at = root.optional("$schema")) at->string();
  if (several) check_beside_scenes(root);
  Lesson lesson;
  lesson.languages = read_languages(root);
  read_metadata(root, lesson);
  if (several)
    read_scenes(*root.optional("scenes"), lesson);
  else
    read_run_of_scene(root, lesson.languages, lesson);
  check_checkpoint_ids(root);
  if (!diagnostics.empty()) return diagnostics;
  return lesson;
}

}  // namespace blossom
