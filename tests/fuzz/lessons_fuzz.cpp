// Any document as a lesson: of an accepted one every beat stands at a step of its run, in order and one at each, says
// something that resolves, and is found again in the same run.

#include "fuzz.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/lesson.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

void check(const Lesson& lesson) {
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  require(run.value.has_value(), "an accepted lesson runs", to_string(run.diagnostics));
  const Narrator<Exact> narrator(*run);
  std::uint32_t next = 0;
  for (const Beat& beat : lesson.beats) {
    require(beat.step >= next && beat.step < run->trace.step_count(), "beats stand at steps, in order", beat.say);
    next = beat.step + 1;
    require(unresolved(beat.say, narrator, beat.step).empty() && !open_brace(beat.say), "placeholders resolve",
            beat.say);
    require(lesson.beat_at(beat.step) == &beat, "a beat is found at its step");
    require(is_harmless(lesson.narration(narrator, beat.step)), "what is said is harmless", beat.say);
    require(step_of(beat.at, run->trace) == beat.step, "its place is where it stands", beat.say);
    const auto place = JsonDocument::parse("place", write_place(beat.at));
    Diagnostics diagnostics;
    require(place && read_place(Cursor(*place, diagnostics)) == beat.at, "a place that is written reads back",
            write_place(beat.at));
  }
  const auto again = resolve_beats(lesson, run->trace);
  require(again.size() == lesson.beats.size(), "all beats are found again");
  for (std::size_t i = 0; i < again.size(); ++i)
    require(again[i].step == lesson.beats[i].step && again[i].highlights == lesson.beats[i].highlights,
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
  if (lesson) check(*lesson);
  return 0;
}
