// A handout to print and to write on: the lesson's steps with their words, several on a page of A4.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/json.hpp"
#include "export/cairo_canvas.hpp"
#include "export/export.hpp"
#include "export/handout_text.hpp"
#include "render/painter.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr double gap = 34;            // between rows, and between columns
constexpr double header_height = 36;  // of a step
constexpr double below_picture = 18;
constexpr double pixels_per_unit = 2;  // of the canvas: as fine as hidden lines are cut
constexpr double points_per_unit = 0.5;
constexpr double page_room = paper_bottom - paper_top;

// How steps stand on a page.
struct Grid {
  int columns = 1, rows = 2;
  double text_size = 18, least_picture = 0, most_picture = 0;  // heights

  double cell_width() const { return (paper_room - gap * (columns - 1)) / columns; }
  double slot() const { return std::floor((page_room - gap * (rows - 1)) / rows); }  // of a row on a full page
  bool wide() const { return columns == 1; }
};

Grid grid_of(int per_page) {
  if (per_page == 1) return {1, 1, 20, 480, 900};
  if (per_page == 4) return {2, 2, 16, 260, 400};
  if (per_page == 6) return {2, 3, 15, 170, 260};
  return {1, 2, 18, 320, 470};
}

std::string line_of_code(const StepSource& source, const StoryStep& told) {
  const auto& code = source.algorithm_at(told.step).pseudo_code;
  if (told.line < 1 || static_cast<std::size_t>(told.line) > code.size()) return {};
  const std::string_view line = code[static_cast<std::size_t>(told.line) - 1];
  return std::string(line.substr(std::min(line.find_first_not_of(' '), line.size())));
}

// One step without its picture: what stands below it, measured. In a wide cell the words stand left and what they are
// about right; in a narrow one below each other.
class StepFrame {
 public:
  StepFrame(const Paper& paper, const Grid& grid, const StoryScene& scene, const StoryStep& told, bool asks)
      : paper_(paper), grid_(grid), scene_(&scene), told_(&told) {
    const double width = grid.cell_width();
    words_width_ = grid.wide() ? 0.57 * width : width;
    side_width_ = grid.wide() ? 0.38 * width : width;
    const StepSource& source = scene.source();
    words_ = {rich_text(told.prose, source.algorithm_at(told.step)), grid.text_size, Role::text, words_width_};
    code_ = line_of_code(source, told);
    side_height_ = draw_side(nullptr, 0, 0);
    if (asks && told.question) make_question();
    const double others = (grid.wide() ? 0 : side_height_ + 12) + question_height();
    const double room = page_room - header_height - grid.least_picture - below_picture - others;
    std::tie(words_, rest_) = paper.split(words_, std::max(room, 100.0));
    words_height_ = paper.height(words_);
  }

  double text_height() const {
    const double words = words_height_ + question_height();
    return grid_.wide() ? std::max(words, side_height_) : words + 12 + side_height_;
  }
  const PaperText& rest() const { return rest_; }
  const StoryStep& told() const { return *told_; }
  std::string heading() const { return "Step " + std::to_string(told_->step); }

  View draw(View& page, double x, double y, double picture_height) const {
    const double width = grid_.cell_width();
    const std::string name = heading();
    paper_.add(page, {plain_run(name, true), 19, Role::text_strong}, x, y + 4);
    const double room = width - 12.5 * static_cast<double>(name.size()) - 20;
    paper_.add(page, {plain_run(phase_within(room)), 15, Role::text_quiet, 0}, x + width, y + 8,
               Label::Placement::right);
    y += header_height;
    View picture = scene_->picture(told_->step, width, picture_height);
    picture.x = x;
    picture.y = y;
    Polyline border;
    border.points = {{x, y, 0}, {x + width, y, 0}, {x + width, y + picture_height, 0}, {x, y + picture_height, 0}};
    border.closed = true;
    border.role = Role::rule_line;
    page.polylines.push_back(std::move(border));
    y += picture_height + below_picture;
    paper_.add(page, words_, x, y);
    if (grid_.wide()) {
      if (question_) question_->draw(page, y + words_height_ + 14);
      draw_side(&page, x + width - side_width_, y);
    } else {
      draw_side(&page, x, y + words_height_ + 12);
      if (question_) question_->draw(page, y + words_height_ + 12 + side_height_ + 14);
    }
    return picture;
  }
  // A question stands below the words of its own cell, wherever that comes to be.
  void place_at(double x) {
    if (question_) make_question(x);
  }

 private:
  // The phases from outside in; where they are too long, the inner ones.
  std::string phase_within(double room) const {
    constexpr std::string_view between = " › ";
    std::string phase = told_->phase;
    for (std::size_t at = 0; paper_.shortened(phase, 15, room) != phase;) {
      at = told_->phase.find(between, at);
      if (at == std::string::npos) return paper_.shortened(phase, 15, room);
      at += between.size();
      phase = "… › " + told_->phase.substr(at);
    }
    return phase;
  }
  double question_height() const { return question_ ? question_->height + 14 : 0; }
  void make_question(double x = paper_left) {
    const Algorithm& algorithm = scene_->source().algorithm_at(told_->step);
    for (double size = grid_.text_size; size >= 8; size -= 1) {
      question_ = handout_question(paper_, *told_->question, algorithm, x, words_width_, size);
      if (question_->height < page_room - header_height - grid_.least_picture - side_height_ - 160) return;
    }
  }

  // The line of the code and what the step makes; their height.
  double draw_side(View* page, double x, double y) const {
    const double top = y;
    const double size = std::min(15.0, grid_.text_size - 1);
    if (!code_.empty()) {
      const PaperText number{plain_run("line " + std::to_string(told_->line)), size - 1, Role::text_quiet};
      const PaperText code{plain_run(code_, false, true), size, Role::text, side_width_ - 92};
      const double height = paper_.height(code) + 16;
      if (page != nullptr) {
        Paper::fill(*page, x, y, side_width_, height, Role::panel);
        Paper::fill(*page, x, y, 4, height, Role::current);
        paper_.add(*page, number, x + 16, y + 8);
        paper_.add(*page, code, x + 82, y + 8);
      }
      y += height + 12;
    }
    // Measured for a page on a screen, and here set anew: as large as the words beside it, line below line.
    const double scale = 1.1 * grid_.text_size / 16;
    Sheet sheet;
    add_formula(sheet, scene_->source(), told_->step, 0, 0, side_width_ / scale, 360 / scale);
    for (const Label& label : sheet.view.labels) {
      const PaperText line{label.text, paper_.size_of(label) * scale, label.role, side_width_};
      y += page != nullptr ? paper_.add(*page, line, x, y) : paper_.height(line);
      y += 7;
    }
    return y - top;
  }

  const Paper& paper_;
  Grid grid_;
  const StoryScene* scene_;
  const StoryStep* told_;
  double words_width_ = 0, side_width_ = 0;
  PaperText words_, rest_;  // what has no room here follows behind
  std::string code_;
  double words_height_ = 0, side_height_ = 0;
  std::optional<PaperPart> question_;
};

// What stands below each other: a part, or a row of steps.
struct Item {
  PaperPart part;
  std::vector<StepFrame> frames;
  double text_height = 0, picture = 0;

  double height() const { return frames.empty() ? part.height : header_height + picture + below_picture + text_height; }
};

class Handout {
 public:
  Handout(const Story& story, const LessonExportOptions& options, const Fonts& fonts)
      : story_(story),
        options_(options),
        fonts_(fonts),
        paper_(*options.theme, fonts),
        grid_(grid_of(options.per_page)) {
    bool asks = false;
    for (const StoryScene& scene : story.scenes)
      for (const StoryStep& told : scene.steps) asks = asks || (options.checkpoints && told.question);
    items_.push_back({handout_head(paper_, story, asks), {}});
    for (const StoryScene& scene : story.scenes) add_scene(scene);
    if (!story.exercises.empty()) items_.push_back({handout_exercises(paper_, story), {}});
    size_pictures();
    paginate();
  }

  // False: it was stopped.
  bool draw(CairoCanvas& canvas) const {
    std::size_t done = 0;
    for (std::size_t page = 0; page < pages_.size(); ++page) {
      if (!draw_page(canvas, page, done)) return false;
    }
    return true;
  }

 private:
  struct Place {
    std::size_t item = 0;
    double y = 0;
  };

  void add_scene(const StoryScene& scene) {
    if (!scene.heading.empty()) {
      const PaperText heading{plain_run(scene.heading, true), 26, Role::text_strong};
      items_.push_back({{paper_.height(heading),
                         [this, heading](View& page, double y) { paper_.add(page, heading, paper_left, y); }, true},
                        {}});
    }
    items_.push_back({handout_code(paper_, scene.recording->algorithm()), {}});
    const auto columns = static_cast<std::size_t>(grid_.columns);
    for (std::size_t i = 0; i < scene.steps.size(); i += columns) {
      Item row;
      for (std::size_t k = i; k < std::min(i + columns, scene.steps.size()); ++k) {
        row.frames.emplace_back(paper_, grid_, scene, scene.steps[k], options_.checkpoints);
        row.frames.back().place_at(column_x(k - i));
        row.text_height = std::max(row.text_height, row.frames.back().text_height());
      }
      std::vector<PaperPart> rests;
      for (const StepFrame& frame : row.frames) add_rest(frame, rests);
      items_.push_back(std::move(row));
      for (PaperPart& rest : rests) items_.push_back({std::move(rest), {}});
    }
  }

  // Words for which there is no room beside a picture, page after page.
  void add_rest(const StepFrame& frame, std::vector<PaperPart>& rests) const {
    PaperText rest = frame.rest();
    while (!rest.text.empty()) {
      rest.width = paper_room;
      const PaperText heading{plain_run(frame.heading() + ", continued", true), 19, Role::text_strong};
      auto [here, behind] = paper_.split(rest, page_room - header_height);
      rests.push_back({header_height + paper_.height(here), [this, heading, words = here](View& page, double y) {
                         paper_.add(page, heading, paper_left, y + 4);
                         paper_.add(page, words, paper_left, y + header_height);
                       }});
      rest = behind;
    }
  }

  double column_x(std::size_t column) const {
    return paper_left + static_cast<double>(column) * (grid_.cell_width() + gap);
  }

  // Pictures are of one size, so that nothing jumps from step to step: one with which nine of ten rows keep to the
  // grid.
  void size_pictures() {
    std::vector<double> heights;
    for (const Item& item : items_)
      if (!item.frames.empty()) heights.push_back(item.text_height);
    if (heights.empty()) return;
    std::ranges::sort(heights);
    const double usual = grid_.slot() - header_height - below_picture - heights[(heights.size() - 1) * 9 / 10];
    for (Item& item : items_) item.picture = std::clamp(usual, grid_.least_picture, grid_.most_picture);
  }

  // How high the item is at least, with what it does not leave.
  double least_height(std::size_t i) const {
    const Item& item = items_[i];
    if (!item.frames.empty()) return item.height() - item.picture + grid_.least_picture;
    return item.height() + (item.part.with_next && i + 1 < items_.size() ? gap + least_height(i + 1) : 0);
  }

  // As much on each page as there is room for with the smallest pictures.
  void paginate() {
    for (std::size_t i = 0; i < items_.size();) {
      const std::size_t first = i;
      double used = 0;
      int rows = 0;
      for (; i < items_.size(); ++i) {
        const bool row = !items_[i].frames.empty();
        if (i > first && (used + gap + least_height(i) > page_room || (row && rows == grid_.rows))) break;
        used += (i > first ? gap : 0) + (row ? least_height(i) : items_[i].height());
        rows += row ? 1 : 0;
      }
      fill_page(first, i, page_room - used, rows);
    }
  }

  // What is left of the page makes its pictures larger, up to the usual size. Then rows keep to the grid, if they can.
  void fill_page(std::size_t first, std::size_t end, double left, int rows) {
    const double larger = rows > 0 ? std::min(items_[first].picture - grid_.least_picture, left / rows) : 0;
    bool on_grid = true;
    for (std::size_t i = first; i < end; ++i) {
      Item& item = items_[i];
      if (!item.frames.empty()) item.picture = grid_.least_picture + larger;
      on_grid = on_grid && !item.frames.empty() && item.height() <= grid_.slot();
    }
    pages_.emplace_back();
    double y = paper_top;
    const double spread = rows == grid_.rows && rows > 1 ? std::max(0.0, (left - larger * rows) / (rows - 1)) : 0;
    for (std::size_t i = first; i < end; ++i) {
      pages_.back().push_back({i, y});
      y += on_grid ? grid_.slot() + gap : items_[i].height() + gap + (items_[i].frames.empty() ? 0 : spread);
    }
  }

  bool draw_page(CairoCanvas& canvas, std::size_t number, std::size_t& done) const {
    View page;
    page.width = paper_width;
    page.height = paper_height;
    std::vector<View> pictures;
    std::vector<std::pair<std::string, double>> bookmarks;
    for (const Place& place : pages_[number]) {
      const Item& item = items_[place.item];
      if (item.frames.empty()) {
        item.part.draw(page, place.y);
        continue;
      }
      for (std::size_t k = 0; k < item.frames.size(); ++k) {
        const StepFrame& frame = item.frames[k];
        pictures.push_back(frame.draw(page, column_x(k), place.y, item.picture));
        const std::string& phase = frame.told().phase;
        bookmarks.emplace_back(frame.heading() + (phase.empty() ? "" : ": " + phase), place.y);
        if (!report_progress(options_, ++done, story_.step_count())) return false;
      }
    }
    draw_footer(page, number);
    pictures.insert(pictures.begin(), std::move(page));
    const auto pixels = [](double units) { return static_cast<int>(std::lround(units * pixels_per_unit)); };
    canvas.begin({pixels(paper_width), pixels(paper_height), options_.theme->background, story_.title, story_.summary});
    for (const auto& [title, y] : bookmarks) canvas.bookmark(title, y * pixels_per_unit);
    const PixelRect all{0, 0, paper_width * pixels_per_unit, paper_height * pixels_per_unit};
    for (const View& view : pictures) paint_view(view, *options_.theme, fonts_, canvas, pixels_per_unit, {0, 0}, all);
    canvas.finish();
    return true;
  }

  void draw_footer(View& page, std::size_t number) const {
    const double y = paper_bottom + 26;
    Paper::line(page, paper_left, y, paper_left + paper_room, Role::rule_line);
    paper_.add(page, {plain_run(paper_.shortened(story_.title, 14, paper_room - 160)), 14, Role::text_quiet},
               paper_left, y + 10);
    const std::string of = std::to_string(number + 1) + " / " + std::to_string(pages_.size());
    paper_.add(page, {plain_run(of), 14, Role::text_quiet, 0}, paper_left + paper_room, y + 10,
               Label::Placement::right);
  }

  const Story& story_;
  const LessonExportOptions& options_;
  const Fonts& fonts_;
  Paper paper_;
  Grid grid_;
  std::vector<Item> items_;
  std::vector<std::vector<Place>> pages_;
};

Checked<LessonExported> write(const Story& story, const fs::path& out, const LessonExportOptions& options) {
  const auto fonts = Fonts::load();
  if (!fonts) return fonts.diagnostics;
  auto canvas = CairoCanvas::create(*fonts, points_per_unit / pixels_per_unit);
  if (!canvas) return canvas.diagnostics;
  if (!Handout(story, options, **fonts).draw(**canvas)) return stopped();
  const auto bytes = std::move(**canvas).take();
  if (!bytes) return bytes.diagnostics;
  if (const auto saved = write_file(out, *bytes); !saved) return saved.diagnostics;
  return LessonExported{{out}, {}};
}

}  // namespace

const LessonFormat& lesson_pdf() {
  static const LessonFormat format{
      "pdf", "Handout", ".pdf", false, "steps with their words, to print: 1, 2, 4 or 6 on a page", write};
  return format;
}

}  // namespace blossom
