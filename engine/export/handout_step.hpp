#pragma once
// A step as it stands on a handout: its picture, the knots, its words, what it computes, and its question.

#include <optional>

#include "export/handout_text.hpp"

namespace blossom {

inline constexpr double handout_gap = 34;  // between rows, and between columns
inline constexpr double paper_height_of_text = paper_bottom - paper_top;

// How steps stand on a page.
struct HandoutGrid {
  int columns = 1, rows = 2;
  double text_size = 18, least_picture = 0, most_picture = 0;  // heights
  double scheme = 0;                                           // of a triangular scheme; 0: none
  bool functions = false;                                      // above the knots

  static HandoutGrid of(int per_page);

  double cell_width() const { return (paper_room - handout_gap * (columns - 1)) / columns; }
  double slot() const;  // of a row on a full page
  bool wide() const { return columns == 1; }
};

// A view with letters for paper: `zoom` units of the page for each of its own.
struct PaperPicture {
  View view;
  double zoom = 1, x = 0, y = 0;  // its corner on the page
};

// What stands below the picture is measured when it is made. In a wide cell the words stand left, with the question and
// the scheme below them, and what they are about right; in a narrow one below each other.
class HandoutStep {
 public:
  HandoutStep(const Paper&, const HandoutGrid&, const StoryScene&, const StoryStep&, bool asks);

  double height_without_picture() const;
  const PaperText& rest() const { return rest_; }  // the words for which there is no room here
  const StoryStep& told() const { return *told_; }
  std::string heading() const;
  // Whether the step behind it tells what it asks for.
  bool asks_for_what_comes() const;

  void draw(View& page, std::vector<PaperPicture>&, double x, double y, double picture_height) const;
  // A question stands below the words of its own cell, wherever that comes to be.
  void place_at(double x);

 private:
  std::string phase_within(double room) const;
  double question_height() const;
  void make_question(double x = paper_left);
  double draw_side(View* page, double x, double y) const;
  std::optional<PaperPicture> scheme() const;
  double scheme_height() const;

  const Paper& paper_;
  HandoutGrid grid_;
  const StoryScene* scene_;
  const StoryStep* told_;
  bool asks_;
  double words_width_ = 0, side_width_ = 0;
  PaperText words_, rest_;
  std::string code_;
  PaperPicture knots_;
  std::optional<PaperPicture> scheme_;
  double words_height_ = 0, side_height_ = 0;
  std::optional<PaperPart> question_;
};

}  // namespace blossom
