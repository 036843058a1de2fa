#include "export/handout_text.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace blossom {
namespace {

// Text below text in one column: measured once, then drawn where it is to stand.
class Column {
 public:
  Column(const Paper& paper, double x, double width) : paper_(&paper), x_(x), width_(width) {}

  void text(RichText words, double size, Role role = Role::text, double indent = 0) {
    PaperText set{std::move(words), size, role, width_ - indent};
    const double height = paper_->height(set);
    items_.push_back(
        {[paper = *paper_, set = std::move(set), x = x_ + indent](View& page, double y) { paper.add(page, set, x, y); },
         height_});
    height_ += height;
  }
  void draw_here(std::function<void(View&, double)> draw, double height) {
    items_.push_back({std::move(draw), height_});
    height_ += height;
  }
  void gap(double height) { height_ += height; }
  double height() const { return height_; }
  void draw(View& page, double y) const {
    for (const auto& item : items_) item.draw(page, y + item.at);
  }

 private:
  struct Item {
    std::function<void(View&, double)> draw;
    double at = 0;
  };
  const Paper* paper_;
  double x_, width_;
  double height_ = 0;
  std::vector<Item> items_;
};

PaperPart part_of(Column column, bool with_next = false) {
  const double height = column.height();
  return {height, [column = std::move(column)](View& page, double y) { column.draw(page, y); }, with_next};
}

std::string joined(const std::vector<StoryLink>& links) {
  std::string all;
  for (const StoryLink& link : links) all += (all.empty() ? "" : "; ") + link.words();
  return all;
}

std::size_t word_count(const RichText& text) {
  std::size_t count = 0;
  for (const TextRun& run : text) count += static_cast<std::size_t>(std::ranges::count(run.text, ' ')) + 1;
  return count;
}

// The text before and behind its first so many words; a formula is one word.
std::pair<RichText, RichText> cut(const RichText& text, std::size_t words) {
  std::pair<RichText, RichText> halves;
  for (const TextRun& run : text) {
    if (words == 0) {
      halves.second.push_back(run);
      continue;
    }
    std::size_t end = 0;
    while (words > 0 && end < run.text.size()) {
      end = std::min(run.text.find(' ', end), run.text.size() - 1) + 1;
      --words;
    }
    if (run.math != nullptr) end = run.text.size();
    TextRun before = run, behind = run;
    before.text = run.text.substr(0, end);
    behind.text = run.text.substr(end);
    halves.first.push_back(std::move(before));
    if (!behind.text.empty()) halves.second.push_back(std::move(behind));
  }
  return halves;
}

}  // namespace

RichText plain_run(std::string text, bool bold, bool monospace) {
  return {{std::move(text), TextRun::Level::base, false, bold, monospace}};
}

double Paper::height(const PaperText& text) const {
  if (text.text.empty()) return 0;
  const TextBlock block = set_text(*fonts_, text.text, text.size, TextAlign::left, text.width);
  return block.bottom - block.top;
}

double Paper::size_of(const Label& label) const { return (*theme_)[label.role].text_size * label.size_scale; }

Label Paper::label(const PaperText& text, double x, double y) const {
  Label label;
  label.anchor = {x, y, 0};
  label.text = text.text;
  label.role = text.role;
  label.size_scale = text.size / (*theme_)[text.role].text_size;
  label.max_width = text.width;
  return label;
}

double Paper::add(View& page, PaperText text, double x, double y, Label::Placement placement) const {
  if (text.text.empty()) return 0;
  const TextBlock block = set_text(*fonts_, text.text, text.size, TextAlign::left, text.width);
  page.labels.push_back(label(text, x, y - block.top));
  page.labels.back().placement = placement;
  return block.bottom - block.top;
}

std::pair<PaperText, PaperText> Paper::split(const PaperText& text, double room) const {
  PaperText none = text;
  none.text.clear();
  if (height(text) <= room) return {text, none};
  std::size_t fits = 0, beyond = word_count(text.text);
  while (beyond - fits > 1) {
    const std::size_t middle = (fits + beyond) / 2;
    PaperText half = text;
    half.text = cut(text.text, middle).first;
    (height(half) <= room ? fits : beyond) = middle;
  }
  // A word that is higher than all the room is not kept back for ever.
  auto [before, behind] = cut(text.text, std::max<std::size_t>(fits, 1));
  PaperText first = text, rest = text;
  first.text = std::move(before);
  rest.text = std::move(behind);
  return {first, rest};
}

std::string Paper::shortened(const std::string& text, double size, double room) const {
  if (fonts_->width({}, text) * size <= room) return text;
  std::string kept;
  for (const char32_t c : decode_utf8(text)) {
    const std::string longer = kept + encode_utf8(c);
    if (fonts_->width({}, longer + " …") * size > room) break;
    kept = longer;
  }
  return kept + " …";
}

void Paper::fill(View& page, double x, double y, double width, double height, Role role, double opacity) {
  page.polygons.push_back(
      {{{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}}, role, opacity});
}

void Paper::line(View& page, double x, double y, double to_x, Role role, double width) {
  Polyline rule;
  rule.points = {{x, y, 0}, {to_x, y, 0}};
  rule.role = role;
  rule.width_scale = width;
  page.polylines.push_back(std::move(rule));
}

PaperPart handout_head(const Paper& paper, const Story& story, bool asks) {
  const Algorithm& algorithm = story.scenes.front().recording->algorithm();
  const PageWords& words = paper.words();
  const auto word = [&](std::string_view key) { return std::string(words(key)); };
  Column head(paper, paper_left, paper_room);
  if (asks) {
    head.draw_here(
        [paper, label = word("name")](View& page, double y) {
          const double name = paper_left + paper_room - 420;
          paper.add(page, {plain_run(label), 16, Role::text_quiet}, name, y);
          Paper::line(page, name + 54, y + 14, paper_left + paper_room, Role::axis, 0.7);
        },
        0);
  }
  const std::string unit = story.unit.empty() ? word("lesson") : story.unit;
  head.text(plain_run(paper.shortened(unit, 17, paper_room - 460)), 17, Role::text_quiet);
  head.gap(16);
  // On one line if it need not be much smaller for that.
  double title_size = 38;
  while (title_size > 28 && paper.height({plain_run(story.title, true), title_size}) > 1.2 * title_size)
    title_size -= 1;
  if (paper.height({plain_run(story.title, true), title_size}) > 1.2 * title_size) title_size = 34;
  head.text(plain_run(story.title, true), title_size, Role::text_strong);
  head.gap(18);
  if (!story.summary.empty()) head.text(rich_text(read_prose(story.summary), algorithm), 20);
  head.gap(26);

  // What is needed for it, as a table of two columns.
  constexpr double label_width = 215, size = 17;
  bool any = false;
  const auto row = [&](const std::string& name, const RichText& text) {
    if (text.empty()) return;
    if (!any)
      head.draw_here(
          [](View& page, double y) { Paper::line(page, paper_left, y, paper_left + paper_room, Role::rule_line, 1.4); },
          18);
    any = true;
    head.draw_here(
        [paper, name](View& page, double y) {
          paper.add(page, {plain_run(name, true), size, Role::text_quiet}, paper_left, y);
        },
        0);
    head.text(text, size, Role::text, label_width);
    head.gap(12);
  };
  const std::size_t steps = story.step_count();
  const std::string time = story.minutes > 0 ? words("duration", std::to_string(story.minutes)) + ", " : "";
  row(word("time"), plain_run(time + (steps == 1 ? word("onestep") : words("allsteps", std::to_string(steps)))));
  RichText objectives;
  for (const std::string& objective : story.objectives) {
    if (!objectives.empty()) objectives.push_back({"\n"});
    if (story.objectives.size() > 1) objectives.push_back({"•  "});
    for (const TextRun& run : rich_text(read_prose(objective), algorithm)) objectives.push_back(run);
  }
  row(word("objectives"), objectives);
  if (!story.prerequisites.empty()) row(word("before"), plain_run(joined(story.prerequisites)));
  if (!story.source.empty()) row(word("source"), plain_run(story.source));
  head.gap(2);
  head.draw_here(
      [](View& page, double y) { Paper::line(page, paper_left, y, paper_left + paper_room, Role::rule_line, 1.4); }, 0);
  return part_of(std::move(head));
}

PaperPart handout_code(const Paper& paper, const Algorithm& algorithm) {
  constexpr double inset = 20, number_width = 44, size = 15;
  Column code(paper, paper_left + inset, paper_room - 2 * inset);
  code.gap(16);
  code.text(plain_run(std::string(paper.words()("lines")), true), 17, Role::text_strong);
  code.gap(10);
  int number = 0;
  for (const std::string_view line : algorithm.pseudo_code) {
    const std::string name = std::to_string(++number);
    code.draw_here(
        [paper, name](View& page, double y) {
          paper.add(page, {plain_run(name, false, true), size, Role::text_quiet}, paper_left + inset, y);
        },
        0);
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    code.text(plain_run(std::string(line.substr(blanks)), false, true), size, Role::text,
              number_width + 0.6 * size * static_cast<double>(blanks));
    code.gap(6);
  }
  code.gap(10);
  const double height = code.height();
  return {height, [code = std::move(code), height](View& page, double y) {
            Paper::fill(page, paper_left, y, paper_room, height, Role::panel);
            code.draw(page, y);
          }};
}

PaperPart handout_question(const Paper& paper, const StoryStep::Question& question, const Algorithm& algorithm,
                           double x, double width, double size) {
  using Kind = Checkpoint::Kind;
  constexpr double inset = 16;
  const double left = x + inset, room = width - 2 * inset;
  Column box(paper, left, room);
  box.gap(12);
  box.text(plain_run(std::string(paper.words()("question")), true), size, Role::text_current);
  box.gap(8);
  box.text(rich_text(question.ask, algorithm), size);
  box.gap(10);
  const Kind kind = question.checkpoint->kind;
  const bool choice = kind == Kind::choice;
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const std::string letter = (choice ? "☐  " : "") + letter_of(i);
    box.draw_here(
        [paper, letter, left, size](View& page, double y) {
          paper.add(page, {plain_run(letter), size}, left, y);
        },
        0);
    box.text(rich_text(question.options[i], algorithm), size, Role::text, choice ? 3.2 * size : 1.6 * size);
    box.gap(7);
  }
  if (!choice) {
    const std::string label = std::string(paper.words()(asked_word(kind))) + ":";
    box.gap(16);
    box.draw_here(
        [paper, label, left, room, size](View& page, double y) {
          paper.add(page, {plain_run(label), size, Role::text_quiet}, left, y);
          const double from = left + size * (0.62 * static_cast<double>(utf8_count(label)) + 0.5);
          Paper::line(page, std::min(from, left + room / 2), y + 0.9 * size, left + room, Role::axis, 0.7);
        },
        size + 6);
  }
  box.gap(10);
  const double height = box.height();
  return {height, [box = std::move(box), x, width, height](View& page, double y) {
            Paper::fill(page, x, y, width, height, Role::panel);
            Paper::fill(page, x, y, 4, height, Role::current);
            box.draw(page, y);
          }};
}

PaperPart handout_work(const Paper& paper, double y) {
  constexpr double size = 14, line = 46;
  return {paper_bottom - y, [paper](View& page, double top) {
            paper.add(page, {plain_run(std::string(paper.words()("work"))), size, Role::text_quiet}, paper_left, top);
            for (double at = top + size + line; at <= paper_bottom; at += line)
              Paper::line(page, paper_left, at, paper_left + paper_room, Role::rule_line, 0.7);
          }};
}

PaperPart handout_answer(const Paper& paper, const StoryScene& scene, const StoryStep& asked) {
  constexpr double label_width = 150, size = 17;
  const StoryStep::Question& question = *asked.question;
  const Algorithm& algorithm = scene.source().algorithm_at(asked.step);
  Column answer(paper, paper_left, paper_room);
  const std::string name = paper.words()("stepname", std::to_string(asked.step));
  answer.draw_here(
      [paper, name](View& page, double y) {
        paper.add(page, {plain_run(name, true), size, Role::text_quiet}, paper_left, y);
      },
      0);
  if (!scene.heading.empty()) answer.text(plain_run(scene.heading), size, Role::text_quiet, label_width);
  answer.text(plain_run(question.answer, true), size, Role::text, label_width);
  const auto add = [&](const Prose& prose) {
    if (prose.empty()) return;
    answer.gap(6);
    answer.text(rich_text(prose, algorithm), size, Role::text, label_width);
  };
  if (const auto at = right_option(question)) add(question.options[*at]);
  add(question.right);
  return part_of(std::move(answer));
}

PaperPart handout_exercises(const Paper& paper, const Story& story) {
  Column list(paper, paper_left, paper_room);
  if (story.exercises.empty()) return part_of(std::move(list));
  list.draw_here(
      [](View& page, double y) { Paper::line(page, paper_left, y, paper_left + paper_room, Role::rule_line, 1.4); },
      20);
  list.text(plain_run(std::string(paper.words()("practise")), true), 22, Role::text_strong);
  list.gap(12);
  for (const StoryLink& exercise : story.exercises) {
    list.text({{"☐  " + exercise.words()}}, 18);
    list.gap(8);
  }
  return part_of(std::move(list));
}

}  // namespace blossom
