// Any document as a lesson: of an accepted one every beat stands at a step of its run, in order and one at each, says
// something that resolves and can be read in every language, and is found again in the same run.

#include <algorithm>

#include "base/json_write.hpp"
#include "fuzz.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/lesson.hpp"
#include "lesson/slider_check.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

void check_words(const LocalText& text, const Narrator<Exact>& narrator, std::uint32_t step) {
  for (const auto& [language, words] : text.texts()) {
    require(unresolved(words, narrator, step).empty() && !open_brace(words), "placeholders resolve", words);
    std::vector<ProseMistake> mistakes;
    const Prose prose = read_prose(narrator.fill(words, step), &mistakes);
    require(mistakes.empty(), "what is said can be read", words);
    require(is_harmless(plain_text(prose)), "what is said is harmless", words);
  }
}

void check(const Beat& beat, const Languages& languages, const Run<Exact>& run, const Narrator<Exact>& narrator) {
  check_words(beat.say, narrator, beat.step);
  const auto steps = steps_of(beat.at, run.trace);
  require(std::ranges::find(steps, beat.step) != steps.end(), "its place is where it stands", beat.say);
  require(beat.at.kind == Place::Kind::every || steps.front() == beat.step, "one place is one step", beat.say);
  const auto place = JsonDocument::parse("place", write_place(beat.at));
  Diagnostics diagnostics;
  require(place && read_place(Cursor(*place, diagnostics)) == beat.at, "a place that is written reads back",
          write_place(beat.at));
  const std::string written = write_json(write_beat(beat, languages));
  require(JsonDocument::parse("beat", written).value.has_value(), "a beat is written as JSON", written);
  if (!beat.checkpoint) return;
  check_words(beat.checkpoint->ask, narrator, beat.step);
  if (!beat.checkpoint->value.empty())
    require(run.trace.find(beat.checkpoint->value).has_value(), "what is asked is there", beat.checkpoint->value);
}

void check(const LessonScene& scene, const Languages& languages) {
  const auto run = record<Exact>(*scene.algorithm, scene.inputs);
  require(run.value.has_value(), "an accepted lesson runs", to_string(run.diagnostics));
  const Narrator<Exact> narrator(*run);
  std::uint32_t next = 0;
  for (const Beat& beat : scene.beats) {
    require(beat.step >= next && beat.step < run->trace.step_count(), "beats stand at steps, in order", beat.say);
    next = beat.step + 1;
    require(scene.beat_at(beat.step) == &beat, "a beat is found at its step");
    check(beat, languages, *run, narrator);
  }
  const auto again = resolve_beats(scene, run->trace);
  require(again.size() == scene.beats.size(), "all beats are found again");
  for (std::size_t i = 0; i < again.size(); ++i)
    require(again[i].step == scene.beats[i].step && again[i].highlights == scene.beats[i].highlights,
            "beats are found where they stood", again[i].say);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("f", text);
  if (!document) return 0;
  require(!file_kind_name(file_kind(document->root())).empty(), "each kind of file has a name");
  const auto lesson = load_lesson(*document);
  check_outcome(lesson, text);
  if (!lesson) return 0;
  for (std::size_t i = 0; i < lesson->scene_count(); ++i) check(lesson->scene_at(i), lesson->languages);
  check_sliders(*document);
  return 0;
}
