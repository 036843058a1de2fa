#pragma once
// Paper of a handout: A4 upright, in page units of half a point, so that a picture's letters are as large as those of
// small print. Texts are measured with the fonts they are set in.

#include <functional>

#include "export/page_words.hpp"
#include "export/story.hpp"
#include "render/rich_text.hpp"
#include "render/theme.hpp"

namespace blossom {

inline constexpr double paper_width = 1190.55, paper_height = 1683.78;
inline constexpr double paper_left = 104, paper_top = 92, paper_bottom = 1588;
inline constexpr double paper_room = paper_width - 2 * paper_left;

struct PaperText {
  RichText text;
  double size = 18;  // of the em; 18 is 9 points
  Role role = Role::text;
  double width = paper_room;
};

// A part of the flow of a handout: so high, and drawn with its upper edge at y.
struct PaperPart {
  double height = 0;
  std::function<void(View& page, double y)> draw;
  bool with_next = false;  // it does not stand at the foot of a page without what follows
};

class Paper {
 public:
  Paper(const Theme& theme, const Fonts& fonts, const PageWords& words)
      : theme_(&theme), fonts_(&fonts), words_(&words) {}

  const Theme& theme() const { return *theme_; }
  const PageWords& words() const { return *words_; }

  double height(const PaperText&) const;
  double size_of(const Label&) const;  // as it was meant for another page
  // Set below y, from x on (or ending there, or around it); its height.
  double add(View&, PaperText, double x, double y, Label::Placement = Label::Placement::left) const;
  // As much of the text as has room, whole words, and the rest of it, which may be empty.
  std::pair<PaperText, PaperText> split(const PaperText&, double room) const;
  // The longest beginning of one line that has room, with dots where something is missing.
  std::string shortened(const std::string&, double size, double room) const;

  static void fill(View&, double x, double y, double width, double height, Role, double opacity = 1);
  static void line(View&, double x, double y, double to_x, Role, double width = 1);

 private:
  Label label(const PaperText&, double x, double y) const;
  const Theme* theme_;
  const Fonts* fonts_;
  const PageWords* words_;
};

RichText plain_run(std::string text, bool bold = false, bool monospace = false);

// What stands before the first step: title, unit, what it is about, and what is needed for it.
PaperPart handout_head(const Paper&, const Story&, bool asks);
// The pseudo-code of a scene, with the numbers that the steps name.
PaperPart handout_code(const Paper&, const Algorithm&);
// Lines to write on, from y to the foot of the page.
PaperPart handout_work(const Paper&, double y);
// A question with room for its answer.
PaperPart handout_question(const Paper&, const StoryStep::Question&, const Algorithm&, double x, double width,
                           double size);
// What is right, and why.
PaperPart handout_answer(const Paper&, const StoryScene&, const StoryStep& asked);
PaperPart handout_exercises(const Paper&, const Story&);

}  // namespace blossom
