#pragma once
// One scene of a story for its page: what is said of each step, its formula, question, pseudo-code and schemes as HTML
// that reads without a script; and, as JSON, what the script needs to show one step at a time:
//   {"id", "size": {"w": [width, height], "n", "k"?, "l"?}, "steps": [{
//      "n": step, "b"?: 1 (a beat), "p"?: seconds or -1 (waits),
//      "w": [elements of the wide picture], "s": [of the small one], "k"?, "l"?: [of the knots, wide and small],
//      "c": pseudo-code, "f": line, "t"?: scheme, "v"?: value, "o"?: [operands], "x"?: [weights of the operands],
//      "g"?: [rows of the table], "h"?: [those made now, by place in "g"], "q"?: {question},
//      "a"?: {"values": [[numbers of a slider, as text], ...], "start": [its place of each slider],
//             "stops": [places in the page's list of stops; null: the step itself; -1: there is none]}}]}
// Elements are numbers in the list that all scenes share (html_canvas.hpp). The "stops" of a step's sliders
// (slider_stops.hpp) go through all places of the last slider first. A stop is {"size", "steps": [the one step]}; its
// words and tables stand in a <template> that nobody but the script reads, its pseudo-code is that of its scene.

#include <map>
#include <string>

#include "export/export.hpp"
#include "export/html_canvas.hpp"
#include "export/page_words.hpp"
#include "export/slider_stops.hpp"
#include "render/font.hpp"

namespace blossom {

struct HtmlScene {
  std::string html, json;
};

struct HtmlPage {
  HtmlLooks looks;
  PageWords words;
  const Fonts& fonts;
  SliderStops& sliders;
  bool checkpoints = true;
  std::vector<std::string> elements{};  // of all pictures
  std::map<std::string, std::size_t> index{};
  std::vector<HtmlScene> stops{};

  std::string numbers_of(std::vector<std::string> of_picture);  // "[3,17,18]"
};

// `told` is called after each step, and twice for each stop; false: stop, and there is no scene.
std::optional<HtmlScene> html_scene(HtmlPage&, const StoryScene&, std::size_t number,
                                    const std::function<bool()>& told);

}  // namespace blossom
