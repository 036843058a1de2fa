#include "export/handout_step.hpp"

#include <algorithm>
#include <cmath>

#include "export/paper_view.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

constexpr double header_height = 36;
constexpr double below_picture = 18;
constexpr double beside_code = 82;  // of its number
// Of letters on paper, in its units of half a point.
constexpr double least_number = 12.4, least_name = 16.4, least_in_scheme = 11;
// Pictures and panels are made for screens.
constexpr double picture_zoom = 1.15, knots_zoom = 1.35;
constexpr double largest_scheme_zoom = 1.1, least_scheme_zoom = 0.9, small_scheme_zoom = 1.2;

std::string line_of_code(const StepSource& source, const StoryStep& told) {
  const auto& code = source.algorithm_at(told.step).pseudo_code;
  if (told.line < 1 || static_cast<std::size_t>(told.line) > code.size()) return {};
  const std::string_view line = code[static_cast<std::size_t>(told.line) - 1];
  return std::string(line.substr(std::min(line.find_first_not_of(' '), line.size())));
}

}  // namespace

HandoutGrid HandoutGrid::of(int per_page) {
  if (per_page == 1) return {1, 1, 20, 480, 900, 480, true};
  if (per_page == 4) return {2, 2, 16, 240, 400, 0, false};
  if (per_page == 6) return {2, 3, 15, 170, 260, 0, false};
  return {1, 2, 18, 300, 470, 240, false};
}

double HandoutGrid::slot() const { return std::floor((paper_height_of_text - handout_gap * (rows - 1)) / rows); }

HandoutStep::HandoutStep(const Paper& paper, const HandoutGrid& grid, const StoryScene& scene, const StoryStep& told,
                         bool asks)
    : paper_(paper), grid_(grid), scene_(&scene), told_(&told), asks_(asks && told.question) {
  const double width = grid.cell_width();
  words_width_ = grid.wide() ? 0.57 * width : width;
  side_width_ = grid.wide() ? 0.38 * width : width;
  const StepSource& source = scene.source();
  words_ = {rich_text(told.prose, source.algorithm_at(told.step)), grid.text_size, Role::text, words_width_};
  code_ = line_of_code(source, told);
  knots_ = {knots_view(scene, told.step, width / knots_zoom, grid.functions), knots_zoom, 0, 0};
  enlarge_letters(knots_.view, paper.theme(), {least_number / knots_zoom, least_number / knots_zoom});
  scheme_ = scheme();
  side_height_ = draw_side(nullptr, 0, 0);
  if (asks_) make_question();
  const double others =
      (grid.wide() ? 0 : side_height_ + 12) + question_height() + scheme_height() + knots_.view.height * knots_zoom;
  const double room = paper_height_of_text - header_height - grid.least_picture - below_picture - others;
  std::tie(words_, rest_) = paper.split(words_, std::max(room, 100.0));
  words_height_ = paper.height(words_);
  // Rather two steps on a page than one with a scheme.
  if (height_without_picture() + grid.least_picture > grid.slot()) scheme_.reset();
}

double HandoutStep::height_without_picture() const {
  const double words = words_height_ + question_height() + scheme_height();
  return header_height + knots_.view.height * knots_zoom + below_picture +
         (grid_.wide() ? std::max(words, side_height_) : words + 12 + side_height_);
}

std::string HandoutStep::heading() const { return paper_.words()("stepname", std::to_string(told_->step)); }

bool HandoutStep::asks_for_what_comes() const {
  using Kind = Checkpoint::Kind;
  if (!asks_) return false;
  const Kind kind = told_->question->checkpoint->kind;
  return kind == Kind::predict || kind == Kind::span || kind == Kind::line;
}

void HandoutStep::draw(View& page, std::vector<PaperPicture>& pictures, double x, double y,
                       double picture_height) const {
  const double width = grid_.cell_width();
  const std::string name = heading();
  paper_.add(page, {plain_run(name, true), 19, Role::text_strong}, x, y + 4);
  const double room = width - 12.5 * static_cast<double>(name.size()) - 20;
  paper_.add(page, {plain_run(phase_within(room)), 15, Role::text_quiet, 0}, x + width, y + 8, Label::Placement::right);
  y += header_height;
  View picture = scene_->picture(told_->step, width / picture_zoom, picture_height / picture_zoom);
  enlarge_letters(picture, paper_.theme(), {least_number / picture_zoom, least_name / picture_zoom});
  pictures.push_back({std::move(picture), picture_zoom, x, y});
  Polyline border;
  border.points = {{x, y, 0}, {x + width, y, 0}, {x + width, y + picture_height, 0}, {x, y + picture_height, 0}};
  border.closed = true;
  border.role = Role::rule_line;
  page.polylines.push_back(std::move(border));
  y += picture_height;
  if (knots_.view.height > 0) {
    pictures.push_back(knots_);
    pictures.back().x = x;
    pictures.back().y = y + below_picture / 2;
    y += knots_.view.height * knots_zoom;
  }
  y += below_picture;
  paper_.add(page, words_, x, y);
  if (grid_.wide()) {
    if (question_) question_->draw(page, y + words_height_ + 14);
    if (scheme_) {
      pictures.push_back(*scheme_);
      pictures.back().x = x;
      pictures.back().y = y + words_height_ + question_height() + 14;
    }
    draw_side(&page, x + width - side_width_, y);
  } else {
    draw_side(&page, x, y + words_height_ + 12);
    if (question_) question_->draw(page, y + words_height_ + 12 + side_height_ + 14);
  }
}

void HandoutStep::place_at(double x) {
  if (question_) make_question(x);
}

// The phases from outside in; where they are too long, the inner ones.
std::string HandoutStep::phase_within(double room) const {
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

double HandoutStep::question_height() const { return question_ ? question_->height + 14 : 0; }

void HandoutStep::make_question(double x) {
  const Algorithm& algorithm = scene_->source().algorithm_at(told_->step);
  for (double size = grid_.text_size; size >= 8; size -= 1) {
    question_ = handout_question(paper_, *told_->question, algorithm, x, words_width_, size);
    if (question_->height < paper_height_of_text - header_height - grid_.least_picture - side_height_ - 160) return;
  }
}

// As a window has it, where there is room for it; or as on a page for a screen, whose cells are smaller, while its
// letters can be read.
std::optional<PaperPicture> HandoutStep::scheme() const {
  if (grid_.scheme == 0) return std::nullopt;
  const auto placed = [&](Sheet& sheet, double width, double height, double zoom) {
    sheet.view.width = width;
    sheet.view.height = height;
    enlarge_letters(sheet.view, paper_.theme(), {least_in_scheme / zoom, least_in_scheme / zoom});
    return PaperPicture{std::move(sheet.view), zoom, 0, 0};
  };
  Sheet large, small;
  const TableauSize size = add_tableau(large, scene_->source(), told_->step, {}, 0, 0, {false});
  if (size.height == 0) return std::nullopt;
  const double zoom = std::min({largest_scheme_zoom, words_width_ / size.width, grid_.scheme / size.height});
  if (zoom >= least_scheme_zoom) return placed(large, size.width, size.height, zoom);
  const TableauOptions fitting{true, words_width_ / small_scheme_zoom, grid_.scheme / small_scheme_zoom};
  const TableauSize fitted = add_tableau(small, scene_->source(), told_->step, {}, 0, 0, fitting);
  const auto unreadable = [&](const Label& label) {
    return paper_.size_of(label) * small_scheme_zoom < 0.85 * least_in_scheme;
  };
  if (fitted.height == 0 || std::ranges::any_of(small.view.labels, unreadable)) return std::nullopt;
  paper_.words().put_into(small.view);
  return placed(small, fitting.width, fitted.height, small_scheme_zoom);
}

double HandoutStep::scheme_height() const { return scheme_ ? scheme_->view.height * scheme_->zoom + 14 : 0; }

// The line of the code and what the step makes; their height.
double HandoutStep::draw_side(View* page, double x, double y) const {
  const double top = y;
  const double size = std::min(15.0, grid_.text_size - 1);
  if (!code_.empty()) {
    const PaperText number{plain_run(paper_.words()("line", std::to_string(told_->line))), size - 1, Role::text_quiet};
    const PaperText code{plain_run(code_, false, true), size, Role::text, side_width_ - beside_code - 10};
    const double height = paper_.height(code) + 16;
    if (page != nullptr) {
      Paper::fill(*page, x, y, side_width_, height, Role::panel);
      Paper::fill(*page, x, y, 4, height, Role::current);
      paper_.add(*page, number, x + 16, y + 8);
      paper_.add(*page, code, x + beside_code, y + 8);
    }
    y += height + 12;
  }
  // Measured for a page on a screen, and here set anew: as large as the words beside it, line below line.
  const double scale = 1.1 * grid_.text_size / 16;
  Sheet sheet;
  add_formula(sheet, scene_->source(), told_->step, 0, 0, side_width_ / scale, 360 / scale);
  paper_.words().put_into(sheet.view);
  for (const Label& label : sheet.view.labels) {
    const PaperText line{label.text, std::max(paper_.size_of(label) * scale, least_number), label.role, side_width_};
    y += page != nullptr ? paper_.add(*page, line, x, y) : paper_.height(line);
    y += 7;
  }
  return y - top;
}

}  // namespace blossom
