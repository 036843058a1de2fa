#pragma once
// What a lesson says and does at one step of its run.

#include "algorithms/narrate.hpp"
#include "lesson/checkpoint.hpp"
#include "lesson/place.hpp"

namespace blossom {

// {"fit"?: [selectors], "azimuth"?: degrees, "elevation"?: degrees, "zoom"?: factor}: what is seen, and from where. In
// the plane only what is fitted, and how near. It stays until a beat says otherwise.
struct BeatCamera {
  std::vector<std::string> fit;  // the points to be seen; empty: all
  std::optional<double> azimuth, elevation;
  double zoom = 1;
  bool operator==(const BeatCamera&) const = default;
};

// {"input": "u" | "curve.points[1][0]" | "curve.weights[2]", "from": x, "to": x, "step"?: x, "label"?: text}: an input
// that the student may move while this beat is shown. The run is recorded anew as it moves.
struct Slider {
  std::string input;  // its path in "inputs"
  Exact from = 0, to = 1;
  std::optional<Exact> step;
  LocalText label;
};

struct Beat {
  std::uint32_t step = 0;
  LocalText say;                    // the template
  std::vector<ValueId> highlights;  // in the order they are made
  std::optional<BeatCamera> camera;
  std::optional<std::vector<std::string>>
      hulls;           // selectors: the convex hull of the points of each is drawn from here on
  bool waits = false;  // playing stops here ("pause": "wait")
  double seconds = 0;  // or stays so much longer ("pause": 2)
  std::vector<Slider> sliders;
  std::optional<Checkpoint> checkpoint;

  // As the file says it, to be looked for again in another run.
  Place at;
  std::vector<std::string> selectors;  // of the highlights
};

// All beats of one run; nothing is known of their values while `narrator` is missing. Every mistake is told.
std::vector<Beat> read_beats(const Cursor&, const Languages&, const Narrator<Exact>*, const Cursor* inputs);
Json write_beat(const Beat&, const Languages&);

// The placeholders of a text that name nothing at this step of a run.
template <Scalar S>
std::vector<std::string> unresolved(std::string_view say, const Narrator<S>& narrator, std::uint32_t step) {
  std::vector<std::string> unknown;
  narrator.fill(say, step, &unknown);
  return unknown;
}
// What is wrong with a template at a step: an open brace, placeholders that name nothing, or form (prose.hpp).
void check_template(const Cursor& at, const LocalText&, const Languages&, const Narrator<Exact>*,
                    std::optional<std::uint32_t> step);

}  // namespace blossom
