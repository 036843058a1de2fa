#include "export/story.hpp"

#include <algorithm>

#include "scene/beat_look.hpp"

namespace blossom {
namespace {

std::string phase_of(const Recording& recording, std::uint32_t step) {
  std::string path;
  for (const std::uint32_t phase : recording.graph().phase_path(recording.graph().step(step).phase))
    path += (path.empty() ? "" : " › ") + recording.source().phase_title(phase);
  return path;
}

// Tells the steps of one recording in one language.
class Teller {
 public:
  Teller(const Recording& recording, std::string_view language) : recording_(recording), language_(language) {}

  StoryStep tell(std::uint32_t step, const Beat* beat) const {
    StoryStep told;
    told.step = step;
    told.beat = beat;
    told.words = beat != nullptr ? fill(beat->say, step) : recording_.source().text(step);
    told.prose = read_prose(told.words);
    told.phase = phase_of(recording_, step);
    told.line = recording_.source().line(step);
    if (beat != nullptr && beat->checkpoint) told.question = question(*beat->checkpoint, step);
    return told;
  }

 private:
  std::string fill(const LocalText& text, std::uint32_t step) const {
    const std::string& words = text.in(language_);
    return recording_.fill(words, step).value_or(words);
  }
  Prose prose(const LocalText& text, std::uint32_t step) const {
    return text.empty() ? Prose() : read_prose(fill(text, step));
  }

  StoryStep::Question question(const Checkpoint& checkpoint, std::uint32_t step) const {
    StoryStep::Question asked;
    asked.checkpoint = &checkpoint;
    asked.ask = prose(checkpoint.ask, step);
    asked.right = prose(checkpoint.right, step);
    asked.wrong = prose(checkpoint.wrong, step);
    for (const std::size_t item : shown_order(checkpoint)) asked.options.push_back(prose(checkpoint.items[item], step));
    for (const Checkpoint::Choice& choice : checkpoint.choices) {
      asked.options.push_back(prose(choice.text, step));
      asked.feedback.push_back(prose(choice.feedback, step));
    }
    asked.answer = right_letters(checkpoint);
    if (const auto value = checkpoint.value.empty() ? std::nullopt : recording_.graph().find(checkpoint.value)) {
      const StepSource& source = recording_.source();
      asked.answer = source.value_text(*value);
      if (const auto& point = source.points[*value]) {
        asked.numbers = {point->x, point->y};
        if (source.spatial()) asked.numbers.push_back(point->z);
      } else {
        asked.numbers = source.raw(*value);
        if (recording_.graph().value(*value).kind == ValueKind::vector)
          asked.numbers.resize(std::min<std::size_t>(asked.numbers.size(), source.dimension));
      }
    }
    return asked;
  }

  const Recording& recording_;
  std::string_view language_;
};

Checked<std::shared_ptr<const Recording>> record_story(const Algorithm& algorithm, const Inputs<Exact>& inputs,
                                                       bool exact) {
  if (exact)
    if (auto recording = Recording::make(algorithm, inputs, true)) return recording;
  return Recording::make(algorithm, inputs, false);
}

void tell_all(StoryScene& scene, const StoryOptions& options, std::string_view language) {
  const Teller teller(*scene.recording, language);
  const std::uint32_t last = std::min(options.last, scene.recording->last());
  auto beat = scene.beats.begin();
  for (std::uint32_t step = options.first; step <= last; ++step) {
    while (beat != scene.beats.end() && beat->step < step) ++beat;
    const bool here = beat != scene.beats.end() && beat->step == step;
    scene.steps.push_back(teller.tell(step, here ? &*beat : nullptr));
  }
}

}  // namespace

View StoryScene::picture(std::uint32_t step, double width, double height, double motion) const {
  ViewportOptions look;
  look.motion = motion;
  look.grid = !source().spatial();
  if (const BeatCamera* camera = camera_in_force(beats, step))
    look.camera = camera_of(*camera, scenes(), source(), width, height);
  look.hulls = hulls_in_force(beats, source(), step);
  const auto beat = std::ranges::find(beats, step, &Beat::step);
  if (beat != beats.end()) look.emphasis.lit = beat->highlights;
  return scenes().viewport(step, width, height, look).view;
}

Scene StoryScene::page(const StoryStep& told, const std::string& title, double width, double height,
                       double motion) const {
  PageOptions options;
  options.width = width;
  options.height = height;
  options.title = heading.empty() ? title : title + " · " + heading;
  options.picture = [&](double w, double h) { return picture(told.step, w, h, motion); };
  return scenes().page(told.step, told.words, options);
}

std::size_t Story::step_count() const {
  std::size_t count = 0;
  for (const StoryScene& scene : scenes) count += scene.steps.size();
  return count;
}

Checked<Story> make_story(const Lesson& lesson, const StoryOptions& options) {
  Story story;
  const auto& languages = lesson.languages.others;
  const std::string language =
      std::ranges::find(languages, options.language) != languages.end() ? options.language : "";
  story.language = language.empty() ? lesson.languages.own : language;
  story.id = lesson.id;
  story.title = printable(lesson.title.in(language));
  story.unit = printable(lesson.unit.in(language));
  story.colors = lesson.colors;
  story.summary = printable(lesson.summary.in(language));
  story.source = printable(lesson.source);
  story.minutes = lesson.minutes;
  for (const LocalText& objective : lesson.objectives) story.objectives.push_back(objective.in(language));
  story.prerequisites = lesson.prerequisites;
  story.exercises = lesson.exercises;
  for (std::size_t i = 0; i < lesson.scene_count(); ++i) {
    if (options.scene && *options.scene != i) continue;
    const LessonScene& of = lesson.scene_at(i);
    auto recording = record_story(*of.algorithm, of.inputs, options.exact);
    if (!recording) return recording.diagnostics;
    StoryScene scene{of.scene, printable(of.heading.in(language)), *std::move(recording), {}, {}};
    scene.beats = scene.recording->beats(of);
    story.scenes.push_back(std::move(scene));
  }
  for (StoryScene& scene : story.scenes) tell_all(scene, options, language);
  return story;
}

Checked<Story> make_story(const Algorithm& algorithm, const Inputs<Exact>& inputs, const StoryOptions& options) {
  Story story;
  story.id = algorithm.id;
  story.title = algorithm.title;
  story.summary = algorithm.summary;
  story.source = algorithm.source;
  story.language = "en";
  auto recording = record_story(algorithm, inputs, options.exact);
  if (!recording) return recording.diagnostics;
  story.scenes.push_back({"", "", *std::move(recording), {}, {}});
  tell_all(story.scenes.back(), options, "");
  return story;
}

}  // namespace blossom
