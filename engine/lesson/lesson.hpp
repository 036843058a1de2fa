#pragma once
// A lesson: an algorithm, inputs for it, and what a teacher says on the way; or several such scenes in a row.
//
//   {"schema": "blossom.lesson/1", "id": "de-casteljau", "title": "...", "algorithm": "de_casteljau",
//    "inputs": {"curve": {...}, "u": "2/5"},
//    "unit"?, "summary"?, "source"?, "minutes"?: 10, "objectives"?: [text, ...], "prerequisites"?: [lesson ids],
//    "exercises"?: [exercise ids], "language"?: "en", "languages"?: ["de", ...], "colors"?: see colors.hpp,
//    "beats": [{"at": place, "say": text, "highlight"?: ["P[0][0..1]"], "hull"?: ["P[0][*]"], "camera"?, "pause"?,
//               "sliders"?, "checkpoint"?}, ...],
//    "predict"?: {"ask"?: ["P[1][*]", "C"], "marking"?: "at-once" | "at-end"}}
//
// With "scenes": [{"id", "title", "algorithm", "inputs", "beats", "predict"?}, ...] instead of algorithm, inputs, beats
// and predict it has several. Texts may be in several languages (local_text.hpp).
//
// A beat stands at one step of the run ("at": see place.hpp) and replaces the algorithm's own narration there; one at
// {"every": selector} stands at several, where no other beat does. "say" is a template (algorithms/narrate.hpp) of what
// prose.hpp reads; "highlight" selects values made up to that step; of the points of each selector in "hull" the convex
// hull is drawn, until another beat says otherwise. The beats are in the order of their steps, at most one at each.
// beat.hpp and checkpoint.hpp describe the rest. A "$comment" is for who reads the file, anywhere.
//
// "predict" says which values a student is asked to predict (selectors; without them what exercises about the algorithm
// usually ask) and when the predictions are marked (without it at once).

#include <string>
#include <vector>

#include "lesson/beat.hpp"
#include "lesson/colors.hpp"
#include "lesson/document.hpp"
#include "lesson/prose.hpp"

namespace blossom {

struct LessonScene {
  std::string scene;  // its id; empty: the only one
  LocalText heading;  // likewise
  const Algorithm* algorithm = nullptr;
  Inputs<Exact> inputs;
  std::vector<Beat> beats;        // by step
  std::vector<std::string> asks;  // selectors of what is predicted; empty: what the algorithm's exercises usually ask
  Marking marking = Marking::at_once;

  // The beat at this step, or nullptr.
  const Beat* beat_at(std::uint32_t step) const;
  // What is said at this step of a run of this lesson: its beat's text filled in, or the algorithm's own narration.
  template <Scalar S>
  std::string narration(const Narrator<S>& narrator, std::uint32_t step, std::string_view language = {}) const {
    const Beat* beat = beat_at(step);
    return beat != nullptr ? narrator.fill(beat->say.in(language), step) : narrator.text(step);
  }
};

// A lesson is its first scene; most have no other.
struct Lesson : LessonScene {
  std::string id;
  LocalText title;
  LocalText unit;      // which part of a course it belongs to
  LocalText summary;   // one sentence
  std::string source;  // where to read on
  int minutes = 0;     // how long it takes; 0: not said
  std::vector<LocalText> objectives;
  std::vector<std::string> prerequisites;  // ids of lessons
  std::vector<std::string> exercises;      // ids
  Languages languages;
  LessonColors colors;
  std::vector<LessonScene> others;

  std::size_t scene_count() const { return 1 + others.size(); }
  const LessonScene& scene_at(std::size_t i) const { return i == 0 ? *this : others[i - 1]; }
  // The scene of this id or number (from 1); nothing if there is none.
  std::optional<std::size_t> find_scene(std::string_view) const;
};

// The beats of a scene in another run of its algorithm: those whose place is there, by step. Of several that come to
// stand at one step the first is kept, one at "every" step only where no other stands; and of highlights what is made
// up to there.
std::vector<Beat> resolve_beats(const LessonScene&, const TraceGraph&);

// Every mistake of the file at once. Runs the scenes (in exact arithmetic) to know their values.
Checked<Lesson> load_lesson(const JsonDocument&);

}  // namespace blossom
