#pragma once
// One scene of a story for its page: what is said of each step, its formula, question, pseudo-code and schemes as HTML
// that reads without a script; and, as JSON, what the script needs to show one step at a time:
//   {"id", "size": {"w": [width, height], "n", "k"?, "l"?}, "steps": [{
//      "n": step, "b"?: 1 (a beat), "p"?: seconds or -1 (waits),
//      "w": [elements of the wide picture], "s": [of the small one], "k"?, "l"?: [of the knots, wide and small],
//      "c": pseudo-code, "f": line, "t"?: scheme, "v"?: value, "o"?: [operands], "x"?: [weights of the operands],
//      "g"?: [values of the table], "q"?: {question}}]}
// Elements are numbers in the list that all scenes share (html_canvas.hpp).

#include <map>
#include <string>

#include "export/export.hpp"
#include "export/html_canvas.hpp"
#include "export/html_words.hpp"
#include "render/font.hpp"

namespace blossom {

struct HtmlPage {
  HtmlLooks looks;
  HtmlWords words;
  const Fonts& fonts;
  bool checkpoints = true;
  std::vector<std::string> elements;  // of all pictures
  std::map<std::string, std::size_t> index;

  std::string numbers_of(std::vector<std::string> of_picture);  // "[3,17,18]"
};

struct HtmlScene {
  std::string html, json;
};

// `told` is called after each step; false: stop, and there is no scene.
std::optional<HtmlScene> html_scene(HtmlPage&, const StoryScene&, std::size_t number,
                                    const std::function<bool()>& told);

}  // namespace blossom
