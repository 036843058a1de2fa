#pragma once
// A lesson: an algorithm, inputs for it, and what a teacher says on the way.
//
//   {"schema": "blossom.lesson/1", "id": "de-casteljau", "title": "...", "algorithm": "de_casteljau",
//    "inputs": {"curve": {...}, "u": "2/5"},
//    "unit"?: "...", "summary"?: "...", "source"?: "...", "minutes"?: 10,
//    "beats": [{"at": "P[1][0]", "say": "Walk {u} of the way ...", "highlight"?: ["P[0][0..1]"]}, ...],
//    "predict"?: {"ask"?: ["P[1][*]", "C"], "marking"?: "at-once" | "at-end"}}
//
// A beat stands at one step of the run and replaces the algorithm's own narration there. "at" is
//   a selector          the step that makes the first value it matches
//   "start", "end"      the step that shows the inputs; the last step
//   {"step": n}         the step n
//   {"phase": label}    the step that introduces this phase: "parameters", "raise[1]", "raise[1].decompose"
// "say" is a template (see algorithms/narrate.hpp); "highlight" selects values made up to that step. The beats are in
// the order of their steps, at most one at each.
//
// "predict" says which values a student is asked to predict (selectors; without them what exercises about the algorithm
// usually ask) and when the predictions are marked (without it at once).

#include <string>
#include <vector>

#include "algorithms/narrate.hpp"
#include "base/json.hpp"
#include "lesson/document.hpp"
#include "lesson/place.hpp"

namespace blossom {

struct Beat {
  std::uint32_t step = 0;
  std::string say;                  // the template
  std::vector<ValueId> highlights;  // in the order they are made

  // As the file says it, to be looked for again in another run.
  Place at;
  std::vector<std::string> selectors;  // of the highlights
};

struct Lesson {
  std::string id;
  std::string title;
  std::string unit;     // which part of a course it belongs to
  std::string summary;  // one sentence
  std::string source;   // where to read on
  int minutes = 0;      // how long it takes; 0: not said
  const Algorithm* algorithm = nullptr;
  Inputs<Exact> inputs;
  std::vector<Beat> beats;        // by step
  std::vector<std::string> asks;  // selectors of what is predicted; empty: what the algorithm's exercises usually ask
  Marking marking = Marking::at_once;

  // The beat at this step, or nullptr.
  const Beat* beat_at(std::uint32_t step) const;
  // What is said at this step of a run of this lesson: its beat's text filled in, or the algorithm's own narration.
  template <Scalar S>
  std::string narration(const Narrator<S>& narrator, std::uint32_t step) const {
    const Beat* beat = beat_at(step);
    return beat != nullptr ? narrator.fill(beat->say, step) : narrator.text(step);
  }
};

// The lesson's beats in another run of its algorithm: those whose place is there, by step. Of several that come to
// stand at one step the first is kept, and of highlights what is made up to there.
std::vector<Beat> resolve_beats(const Lesson&, const TraceGraph&);

// The placeholders of a beat's text that name nothing at this step of a run.
template <Scalar S>
std::vector<std::string> unresolved(const std::string& say, const Narrator<S>& narrator, std::uint32_t step) {
  std::vector<std::string> unknown;
  narrator.fill(say, step, &unknown);
  return unknown;
}
// Where a brace of the text is left open, if one is.
std::optional<std::size_t> open_brace(std::string_view say);

// Every mistake of the file at once. Runs the lesson (in exact arithmetic) to know its values.
Checked<Lesson> load_lesson(const JsonDocument&);

}  // namespace blossom
