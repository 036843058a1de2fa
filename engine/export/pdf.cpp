// A handout to print and to write on: the lesson's steps with their words, several on a page of A4. Behind a question
// whose answer the next step tells, a page ends, with room to write; the answers stand on a page of their own at the
// end.

#include <algorithm>
#include <cmath>

#include "base/json.hpp"
#include "export/cairo_canvas.hpp"
#include "export/export.hpp"
#include "export/handout_step.hpp"
#include "render/painter.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr double gap = handout_gap;
constexpr double page_room = paper_height_of_text;
constexpr double pixels_per_unit = 2;  // of the canvas: as fine as hidden lines are cut
constexpr double points_per_unit = 0.5;
constexpr double least_work = 130;   // room to write that is worth a heading
constexpr double continued_at = 36;  // of words that go on, below their heading

// What stands below each other: a part, or a row of steps.
struct Item {
  PaperPart part;
  std::vector<HandoutStep> steps{};
  double without_pictures = 0, picture = 0;
  bool new_page = false;  // it begins one
  bool to_write = false;  // and what is left of the page before is to write on

  double height() const { return steps.empty() ? part.height : without_pictures + picture; }
};

struct Place {
  std::size_t item = 0;
  double y = 0;
};
struct Page {
  std::vector<Place> places;
  double work = 0;  // where the room to write begins; 0: none
};

class Handout {
 public:
  Handout(const Story& story, const LessonExportOptions& options, const Fonts& fonts)
      : story_(story),
        options_(options),
        fonts_(fonts),
        words_(story.language),
        paper_(*options.theme, fonts, words_),
        grid_(HandoutGrid::of(options.per_page)) {
    bool asks = false;
    for (const StoryScene& scene : story.scenes)
      for (const StoryStep& told : scene.steps) asks = asks || (options.checkpoints && told.question);
    items_.push_back({handout_head(paper_, story, asks)});
    for (const StoryScene& scene : story.scenes) add_scene(scene);
    if (!story.exercises.empty()) items_.push_back({handout_exercises(paper_, story)});
    if (asks) add_answers();
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
  void add_scene(const StoryScene& scene) {
    if (!scene.heading.empty()) {
      const PaperText heading{plain_run(scene.heading, true), 26, Role::text_strong};
      items_.push_back({{paper_.height(heading),
                         [this, heading](View& page, double y) { paper_.add(page, heading, paper_left, y); }, true}});
    }
    items_.push_back({handout_code(paper_, scene.recording->algorithm())});
    const auto columns = static_cast<std::size_t>(grid_.columns);
    bool asked = false;
    for (std::size_t i = 0; i < scene.steps.size();) {
      Item row;
      row.new_page = row.to_write = asked;
      asked = false;
      for (; !asked && row.steps.size() < columns && i < scene.steps.size(); ++i) {
        HandoutStep& step = row.steps.emplace_back(paper_, grid_, scene, scene.steps[i], options_.checkpoints);
        step.place_at(column_x(row.steps.size() - 1));
        row.without_pictures = std::max(row.without_pictures, step.height_without_picture());
        asked = step.asks_for_what_comes();
      }
      std::vector<PaperPart> rests;
      for (const HandoutStep& step : row.steps) add_rest(step, rests);
      items_.push_back(std::move(row));
      for (PaperPart& rest : rests) items_.push_back({std::move(rest)});
    }
  }

  void add_answers() {
    const PaperText heading{plain_run(std::string(words_("answers")), true), 26, Role::text_strong};
    items_.push_back({{paper_.height(heading),
                       [this, heading](View& page, double y) { paper_.add(page, heading, paper_left, y); }, true}});
    items_.back().new_page = true;
    for (const StoryScene& scene : story_.scenes)
      for (const StoryStep& told : scene.steps)
        if (told.question) items_.push_back({handout_answer(paper_, scene, told)});
  }

  // Words for which there is no room beside a picture, page after page.
  void add_rest(const HandoutStep& step, std::vector<PaperPart>& rests) const {
    PaperText rest = step.rest();
    while (!rest.text.empty()) {
      rest.width = paper_room;
      const PaperText heading{plain_run(words_("continued", step.heading()), true), 19, Role::text_strong};
      auto [here, behind] = paper_.split(rest, page_room - continued_at);
      rests.push_back({continued_at + paper_.height(here), [this, heading, words = here](View& page, double y) {
                         paper_.add(page, heading, paper_left, y + 4);
                         paper_.add(page, words, paper_left, y + continued_at);
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
      if (!item.steps.empty()) heights.push_back(item.without_pictures);
    if (heights.empty()) return;
    std::ranges::sort(heights);
    const double usual = grid_.slot() - heights[(heights.size() - 1) * 9 / 10];
    for (Item& item : items_) item.picture = std::clamp(usual, grid_.least_picture, grid_.most_picture);
  }

  // How high the item is at least, with what it does not leave.
  double least_height(std::size_t i) const {
    const Item& item = items_[i];
    if (!item.steps.empty()) return item.without_pictures + grid_.least_picture;
    return item.height() + (item.part.with_next && i + 1 < items_.size() ? gap + least_height(i + 1) : 0);
  }

  // As much on each page as there is room for with the smallest pictures.
  void paginate() {
    for (std::size_t i = 0; i < items_.size();) {
      const std::size_t first = i;
      double used = 0;
      int rows = 0;
      for (; i < items_.size(); ++i) {
        const bool row = !items_[i].steps.empty();
        const bool full = used + gap + least_height(i) > page_room || (row && rows == grid_.rows);
        if (i > first && (full || items_[i].new_page)) break;
        used += (i > first ? gap : 0) + (row ? least_height(i) : items_[i].height());
        rows += row ? 1 : 0;
      }
      fill_page(first, i, page_room - used, rows);
    }
  }

  // What is left of the page makes its pictures larger, up to the usual size; where there are fewer than usual because
  // the next ones have no room, up to the largest. Then rows keep to the grid, if they can.
  void fill_page(std::size_t first, std::size_t end, double left, int rows) {
    const bool to_write = end < items_.size() && items_[end].to_write;
    const double most =
        rows < grid_.rows && !to_write && end < items_.size() ? grid_.most_picture : items_[first].picture;
    const double larger = rows > 0 ? std::clamp(left / rows, 0.0, most - grid_.least_picture) : 0;
    bool on_grid = true;
    for (std::size_t i = first; i < end; ++i) {
      Item& item = items_[i];
      if (!item.steps.empty()) item.picture = grid_.least_picture + larger;
      on_grid = on_grid && !item.steps.empty() && item.height() <= grid_.slot();
    }
    Page& page = pages_.emplace_back();
    double y = paper_top, bottom = y;
    const double spread = rows == grid_.rows && rows > 1 ? std::max(0.0, (left - larger * rows) / (rows - 1)) : 0;
    for (std::size_t i = first; i < end; ++i) {
      page.places.push_back({i, y});
      bottom = y + items_[i].height();
      y += on_grid ? grid_.slot() + gap : items_[i].height() + gap + (items_[i].steps.empty() ? 0 : spread);
    }
    if (to_write && paper_bottom - bottom - gap > least_work) page.work = bottom + gap;
  }

  bool draw_page(CairoCanvas& canvas, std::size_t number, std::size_t& done) const {
    View page;
    page.width = paper_width;
    page.height = paper_height;
    std::vector<PaperPicture> pictures;
    std::vector<std::pair<std::string, double>> bookmarks;
    for (const Place& place : pages_[number].places) {
      const Item& item = items_[place.item];
      if (item.steps.empty()) {
        item.part.draw(page, place.y);
        continue;
      }
      for (std::size_t k = 0; k < item.steps.size(); ++k) {
        const HandoutStep& step = item.steps[k];
        step.draw(page, pictures, column_x(k), place.y, item.picture);
        const std::string& phase = step.told().phase;
        bookmarks.emplace_back(step.heading() + (phase.empty() ? "" : ": " + phase), place.y);
        if (!report_progress(options_, ++done, story_.step_count())) return false;
      }
    }
    if (pages_[number].work > 0) handout_work(paper_, pages_[number].work).draw(page, pages_[number].work);
    draw_footer(page, number);
    const auto pixels = [](double units) { return static_cast<int>(std::lround(units * pixels_per_unit)); };
    canvas.begin({pixels(paper_width), pixels(paper_height), options_.theme->background, story_.title, story_.summary});
    for (const auto& [title, y] : bookmarks) canvas.bookmark(title, y * pixels_per_unit);
    const PixelRect all{0, 0, paper_width * pixels_per_unit, paper_height * pixels_per_unit};
    paint_view(page, *options_.theme, fonts_, canvas, pixels_per_unit, {0, 0}, all);
    for (const PaperPicture& picture : pictures)
      paint_view(picture.view, *options_.theme, fonts_, canvas, pixels_per_unit * picture.zoom,
                 glm::dvec2{picture.x, picture.y} * pixels_per_unit, all);
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
  PageWords words_;
  Paper paper_;
  HandoutGrid grid_;
  std::vector<Item> items_;
  std::vector<Page> pages_;
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
      "pdf", "Handout",           ".pdf", false, "steps with their words, to print: 1, 2, 4 or 6 on a page",
      write, export_use::per_page};
  return format;
}

}  // namespace blossom
