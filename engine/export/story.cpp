#include "export/story.hpp"

#include <algorithm>

#include "export/page_words.hpp"
#include "scene/beat_look.hpp"
#include "scene/camera.hpp"

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
  // `told_in`: the same language by its name, which that of the lesson has as well.
  Teller(const Recording& recording, std::string_view language, std::string_view told_in)
      : recording_(recording), language_(language), told_in_(told_in) {}

  StoryStep tell(std::uint32_t step, const Beat* beat) const {
    StoryStep told;
    told.step = step;
    told.beat = beat;
    told.words = beat != nullptr ? fill(beat->say, step) : recording_.source().text(step);
    told.prose = read_prose(told.words);
    // The algorithms' own words are English.
    told.own_words = beat != nullptr ? language_.empty() || beat->say.has(language_) : told_in_ == "en";
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
        // Of a vector what is beyond its coordinates, unless it has a weight.
        if (recording_.graph().value(*value).kind == ValueKind::vector && asked.numbers.size() == 4) {
          const double weight = asked.numbers[3];
          asked.numbers.resize(static_cast<std::size_t>(source.dimension));
          if (source.rational && weight != 0) asked.numbers.push_back(weight);
        }
      }
    }
    return asked;
  }

  const Recording& recording_;
  std::string_view language_, told_in_;
};

Checked<std::shared_ptr<const Recording>> record_story(const Algorithm& algorithm, const Inputs<Exact>& inputs,
                                                       bool exact) {
  if (exact)
    if (auto recording = Recording::make(algorithm, inputs, true)) return recording;
  return Recording::make(algorithm, inputs, false);
}

void tell_all(StoryScene& scene, const StoryOptions& options, std::string_view language) {
  const Teller teller(*scene.recording, language, scene.language);
  const std::uint32_t last = std::min(options.last, scene.recording->last());
  auto beat = scene.beats.begin();
  for (std::uint32_t step = options.first; step <= last; ++step) {
    while (beat != scene.beats.end() && beat->step < step) ++beat;
    const bool here = beat != scene.beats.end() && beat->step == step;
    scene.steps.push_back(teller.tell(step, here ? &*beat : nullptr));
  }
}

}  // namespace

std::optional<std::size_t> right_option(const StoryStep::Question& question) {
  for (std::size_t i = 0; i < question.checkpoint->choices.size(); ++i)
    if (question.checkpoint->choices[i].right) return i;
  return std::nullopt;
}

std::string_view asked_word(Checkpoint::Kind kind) {
  using Kind = Checkpoint::Kind;
  return kind == Kind::order ? "orderasked" : kind == Kind::line ? "lineasked" : kind == Kind::span ? "index" : "asked";
}

std::optional<Camera> StoryScene::camera(std::uint32_t step, double width, double height) const {
  const BeatCamera* camera = camera_in_force(beats, step);
  return camera != nullptr ? std::optional(camera_of(*camera, scenes(), source(), width, height)) : std::nullopt;
}

bool StoryScene::glides(std::uint32_t step) const {
  return step > 0 && camera_in_force(beats, step) != camera_in_force(beats, step - 1) &&
         camera(step, 320, 240) != camera(step - 1, 320, 240);
}

Camera StoryScene::seen_from(std::uint32_t step, double width, double height) const {
  const auto wanted = camera(step, width, height);
  return wanted ? *wanted : scenes().fitted(width, height);
}

ViewportOptions StoryScene::look(std::uint32_t step, double motion) const {
  ViewportOptions look;
  look.motion = motion;
  look.grid = !source().spatial();
  look.hulls = hulls_in_force(beats, source(), step);
  const auto beat = std::ranges::find(beats, step, &Beat::step);
  if (beat != beats.end()) look.emphasis.lit = beat->highlights;
  return look;
}

View StoryScene::picture(std::uint32_t step, double width, double height, double motion, double glide) const {
  Camera from = seen_from(step, width, height);
  if (glide < 1 && step > 0) from = between(seen_from(step - 1, width, height), from, glide);
  ViewportOptions options = look(step, motion);
  options.camera = from;
  return scenes().viewport(step, width, height, options).view;
}

View StoryScene::picture(std::uint32_t step, double width, double height, const Camera& from) const {
  ViewportOptions options = look(step);
  options.camera = from;
  return scenes().viewport(step, width, height, options).view;
}

Scene StoryScene::page(const StoryStep& told, const std::string& title, double width, double height, double motion,
                       double glide) const {
  PageOptions options;
  options.width = width;
  options.height = height;
  options.title = heading.empty() ? title : title + " · " + heading;
  options.picture = [&](double w, double h) { return picture(told.step, w, h, motion, glide); };
  Scene made = scenes().page(told.step, told.words, options);
  // The panels' headings, and the step's number in the corner of the page; all other words are the story's.
  const PageWords words(language);
  for (Label& label : made.views[0].labels)
    if (label.placement == Label::Placement::right) words.put_into(label);
  words.put_into(made.views[2]);
  return made;
}

std::size_t Story::step_count() const {
  std::size_t count = 0;
  for (const StoryScene& scene : scenes) count += scene.steps.size();
  return count;
}

std::size_t Story::foreign_count() const {
  std::ptrdiff_t count = 0;
  for (const StoryScene& scene : scenes) count += std::ranges::count(scene.steps, false, &StoryStep::own_words);
  return static_cast<std::size_t>(count);
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
  const CourseTitles* titles = options.titles;
  story.beside = titles != nullptr && titles->pages();
  for (const std::string& id : lesson.prerequisites)
    story.prerequisites.push_back(titles != nullptr ? titles->lesson(id, language)
                                                    : StoryLink{printable(id), "", "", ""});
  for (const std::string& id : lesson.exercises)
    story.exercises.push_back(titles != nullptr ? titles->exercise(id, language)
                                                : StoryLink{printable(id), "", "", ""});
  for (std::size_t i = 0; i < lesson.scene_count(); ++i) {
    if (options.scene && *options.scene != i) continue;
    const LessonScene& of = lesson.scene_at(i);
    auto recording = record_story(*of.algorithm, of.inputs, options.exact);
    if (!recording) return recording.diagnostics;
    StoryScene scene{of.scene, printable(of.heading.in(language)), *std::move(recording), {}, {}, story.language,
                     of.inputs};
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
  story.scenes.push_back({"", "", *std::move(recording), {}, {}, story.language, inputs});
  tell_all(story.scenes.back(), options, "");
  return story;
}

std::optional<StoryScene> with_inputs(const StoryScene& scene, const StoryStep& told, Inputs<Exact> inputs) {
  const Algorithm& algorithm = scene.recording->algorithm();
  const bool exact = scene.source().exact;
  // In decimals a division by zero may come out as a very large number.
  if (told.beat == nullptr || (!exact && !run_plain<Exact>(algorithm, inputs))) return std::nullopt;
  auto recording = Recording::make(algorithm, inputs, exact);
  if (!recording) return std::nullopt;
  LessonScene lesson;
  lesson.beats = scene.beats;
  StoryScene made{scene.id, scene.heading, *std::move(recording), {}, {}, scene.language, std::move(inputs)};
  made.beats = made.recording->beats(lesson);

  const Place& at = told.beat->at;
  const auto before = steps_of(at, scene.recording->graph()), now = steps_of(at, made.recording->graph());
  // Of a beat at "every" such step: at the first, the second, ...
  const auto which = at.kind == Place::Kind::every ? std::ranges::find(before, told.step) - before.begin() : 0;
  if (which >= std::ssize(now)) return std::nullopt;
  const std::uint32_t step = now[static_cast<std::size_t>(which)];
  const auto beat = std::ranges::find(made.beats, step, &Beat::step);
  const bool same = beat != made.beats.end() && beat->at == at && beat->say == told.beat->say;
  if (!same || !made.recording->fill(beat->say.in(scene.language), step)) return std::nullopt;
  StoryStep& moved =
      made.steps.emplace_back(Teller(*made.recording, scene.language, scene.language).tell(step, &*beat));
  moved.own_words = told.own_words;
  moved.question.reset();
  return made;
}

}  // namespace blossom
