#include "render/rich_text.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace blossom {
namespace {

using Level = TextRun::Level;

constexpr double script_size = 0.7, sub_drop = 0.22, super_rise = 0.38, line_distance = 1.4;
constexpr double script_clearance = 0.186;  // between the ink of a sub- and a superscript, as formulas have it
constexpr double line_clearance = 0.12;     // between the lowest and the highest of lines with tall formulas
constexpr double display_room = 0.25;       // above and below a formula on a line of its own

struct Piece {  // of one run; without blanks
  std::string text;
  FontStyle style;
  Level level = Level::base;
  const TextRun* formula = nullptr;  // in place of the text
};

struct Word {
  std::vector<Piece> pieces;
  std::string blanks_before;
  double blank_width = 0;  // in ems
  bool line_before = false;
  bool tab_before = false;  // the lines that go on begin here
};

// Sets pieces one after the other and knows where the pen is; a script pair shares one start.
class LineSetter {
 public:
  LineSetter(const Fonts& fonts, double size) : fonts_(&fonts), size_(size) {}

  void add(const Piece& piece) {
    if (piece.formula != nullptr) return add_formula(*piece.formula);
    const bool script = piece.level != Level::base;
    const bool stacks = script && previous_ != Level::base && previous_ != piece.level;
    const double size = script ? size_ * script_size : size_;
    const double start = stacks ? script_start_ : pen_;
    if (!script) parted_ = 0;
    const double rise = piece.level == Level::sub     ? -sub_drop - parted_
                        : piece.level == Level::super ? super_rise + parted_
                                                      : 0;
    double width = fonts_->width(piece.style, piece.text) * size;
    if (!runs_.empty()) runs_.back().text += blanks_;  // so that text copied from a picture has its blanks
    const bool joins = !runs_.empty() && !script && !std::exchange(sealed_, false) && runs_.back().size == size &&
                       runs_.back().style == piece.style;
    blanks_.clear();
    if (joins) {
      runs_.back().text += piece.text;
      width = runs_.back().x + fonts_->width(piece.style, runs_.back().text) * size - start;
    } else {
      runs_.push_back({piece.text, start, -rise * size_, size, piece.style});
    }
    reach(runs_.back().baseline, size);
    if (stacks) part_scripts();
    if (!script || previous_ == Level::base) script_start_ = start;
    pen_ = stacks ? std::max(pen_, start + width) : start + width;
    previous_ = script ? piece.level : Level::base;
  }
  void add_formula(const TextRun& run) {
    MathBox box = lay_out(*fonts_, *run.math, size_, run.display, run.bold);
    if (!runs_.empty()) runs_.back().text += blanks_;
    blanks_.clear();
    for (GlyphRun& glyphs : box.runs) {
      glyphs.x += pen_;
      runs_.push_back(std::move(glyphs));
    }
    for (TextBar& bar : box.bars) {
      bar.x += pen_;
      bars_.push_back(bar);
    }
    for (TextStroke& stroke : box.strokes) {
      for (auto& point : stroke.points) point.x += pen_;
      strokes_.push_back(std::move(stroke));
    }
    const double room = run.display ? display_room * size_ : 0;
    top_ = std::min(top_, -box.height - room);
    bottom_ = std::max(bottom_, box.depth + room);
    pen_ += box.width;
    previous_ = Level::base;
    has_formula_ = sealed_ = true;
  }
  void start_at(double x) { pen_ = x; }
  void blank(const std::string& blanks, double ems) {
    blanks_ += blanks;
    pen_ += ems * size_;
    previous_ = Level::base;
  }
  double pen() const { return pen_; }
  bool empty() const { return runs_.empty() && strokes_.empty(); }

  // Moves the line into the block, below what is there, and starts a new one.
  void flush(TextBlock& block, TextAlign align) {
    double baseline = behind_ ? behind_->baseline + line_distance * size_ : 0;
    if (behind_ && (behind_->has_formula || has_formula_))
      baseline = std::max(baseline, block.bottom + line_clearance * size_ - top_);
    const LineBefore here{baseline, has_formula_};
    const double shift = align == TextAlign::left ? 0 : align == TextAlign::centre ? -pen_ / 2 : -pen_;
    TextBlock line;
    line.runs = std::move(runs_);
    line.bars = std::move(bars_);
    line.strokes = std::move(strokes_);
    line = placed(std::move(line), shift, baseline);
    std::ranges::move(line.runs, std::back_inserter(block.runs));
    std::ranges::move(line.bars, std::back_inserter(block.bars));
    std::ranges::move(line.strokes, std::back_inserter(block.strokes));
    block.left = std::min(block.left, shift);
    block.width = std::max(block.width, pen_);
    block.top = std::min(block.top, baseline + top_);
    block.bottom = std::max(block.bottom, baseline + bottom_);
    *this = LineSetter(*fonts_, size_);
    behind_ = here;
  }

 private:
  void reach(double baseline, double size) {
    top_ = std::min(top_, baseline - Fonts::ascent * size);
    bottom_ = std::max(bottom_, baseline + Fonts::descent * size);
  }

  // The last two runs are a subscript and a superscript: half of the room that is missing between them for each.
  void part_scripts() {
    GlyphRun &first = runs_[runs_.size() - 2], &second = runs_.back();
    GlyphRun &above = first.baseline < second.baseline ? first : second, &below = &above == &first ? second : first;
    double upper_end = -1e9, lower_end = 1e9;
    for (const char32_t c : decode_utf8(above.text))
      upper_end = std::max(upper_end, above.baseline - fonts_->ink(above.style, c).bottom * above.size);
    for (const char32_t c : decode_utf8(below.text))
      lower_end = std::min(lower_end, below.baseline - fonts_->ink(below.style, c).top * below.size);
    const double missing = std::max(0.0, script_clearance * size_ - (lower_end - upper_end));
    parted_ += missing / 2 / size_;
    above.baseline -= missing / 2;
    below.baseline += missing / 2;
    reach(above.baseline, above.size);
    reach(below.baseline, below.size);
  }

  const Fonts* fonts_;
  double size_;
  std::vector<GlyphRun> runs_;
  std::string blanks_;  // not yet followed by letters
  double pen_ = 0, script_start_ = 0;
  double parted_ = 0;  // how much farther from the base line scripts stand because they are a pair, in ems
  Level previous_ = Level::base;
  double top_ = 0, bottom_ = 0;
  std::vector<TextBar> bars_;
  std::vector<TextStroke> strokes_;
  bool has_formula_ = false;
  bool sealed_ = false;  // the last run is a formula's, which nothing joins
  struct LineBefore {
    double baseline;
    bool has_formula;
  };
  std::optional<LineBefore> behind_;
};

std::vector<Word> split_words(const Fonts& fonts, const RichText& text) {
  std::vector<Word> words(1);
  for (const auto& run : text) {
    const FontStyle style{run.bold, run.italic, run.monospace};
    if (run.math != nullptr) {
      words.back().pieces.push_back({run.text, style, run.level, &run});
      continue;
    }
    std::size_t start = 0;
    for (std::size_t i = 0; i <= run.text.size(); ++i) {
      const bool ends = i == run.text.size();
      if (!ends && run.text[i] != ' ' && run.text[i] != '\n' && run.text[i] != '\t') continue;
      if (i > start) words.back().pieces.push_back({run.text.substr(start, i - start), style, run.level, nullptr});
      start = i + 1;
      if (ends) continue;
      if (run.text[i] == '\t') {
        if (!words.back().pieces.empty()) words.emplace_back();
        words.back().tab_before = true;
        continue;
      }
      // Blanks after blanks grow one gap, so that columns made of blanks keep their places.
      if (!words.back().pieces.empty() || run.text[i] == '\n') words.emplace_back();
      if (run.text[i] == '\n') {
        words.back().line_before = true;
      } else {
        words.back().blanks_before += ' ';
        words.back().blank_width += fonts.advance(style, U' ');
      }
    }
  }
  return words;
}

double width_of(const Fonts& fonts, const Word& word, double size) {
  LineSetter line(fonts, size);
  for (const auto& piece : word.pieces) line.add(piece);
  return line.pen();
}

// Letter by letter, for words that no line can hold.
std::vector<Piece> letters_of(const Word& word) {
  std::vector<Piece> letters;
  for (const auto& piece : word.pieces) {
    if (piece.formula != nullptr) {
      letters.push_back(piece);
      continue;
    }
    for (const char32_t c : decode_utf8(piece.text))
      letters.push_back({encode_utf8(c), piece.style, piece.level, nullptr});
  }
  return letters;
}

}  // namespace

TextBlock placed(TextBlock block, double dx, double dy, double scale) {
  for (GlyphRun& run : block.runs) {
    run.x = (run.x + dx) * scale;
    run.baseline = (run.baseline + dy) * scale;
    run.size = std::clamp(run.size * scale, 1.0, Fonts::max_pixels);
  }
  for (TextBar& bar : block.bars)
    bar = {(bar.x + dx) * scale, (bar.y + dy) * scale, bar.width * scale, bar.height * scale};
  for (TextStroke& stroke : block.strokes) {
    stroke.width *= scale;
    for (auto& point : stroke.points) point = {(point.x + dx) * scale, (point.y + dy) * scale};
  }
  block.left = (block.left + dx) * scale;
  block.width *= scale;
  block.top = (block.top + dy) * scale;
  block.bottom = (block.bottom + dy) * scale;
  return block;
}

void paint_text(Canvas& canvas, const TextBlock& block, const TextPaint& look) {
  const auto corner = [](double x, double y) { return PixelPoint{static_cast<float>(x), static_cast<float>(y), 0}; };
  const auto strokes = [&](Color color, double wider) {
    for (const TextStroke& stroke : block.strokes) {
      std::vector<PixelPoint> points;
      for (const auto& [x, y] : stroke.points) points.push_back(corner(x, y));
      canvas.polyline(points, false, {color, static_cast<float>(stroke.width + 2 * wider), 0, 0});
    }
  };
  const auto bars = [&](Color color, double wider) {
    for (const TextBar& bar : block.bars) {
      const double left = bar.x - wider, right = bar.x + bar.width + wider;
      const double top = bar.y - wider, bottom = bar.y + bar.height + wider;
      const PixelPoint corners[] = {corner(left, top), corner(right, top), corner(right, bottom), corner(left, bottom)};
      canvas.polygon(corners, color);
    }
  };
  if (look.halo_width > 0) {
    strokes(look.halo, look.halo_width);
    bars(look.halo, look.halo_width);
  }
  if (!block.runs.empty()) canvas.text(block.runs, look);
  strokes(look.color, 0);
  bars(look.color, 0);
}

TextBlock set_text(const Fonts& fonts, const RichText& text, double size, TextAlign align, double max_width) {
  TextBlock block;
  LineSetter line(fonts, size);
  double tab = 0;  // where lines that go on begin
  const auto next_line = [&] {
    line.flush(block, align);
    line.start_at(tab);
  };
  for (const auto& word : split_words(fonts, text)) {
    if (word.line_before) {
      tab = 0;
      next_line();
    }
    const double width = width_of(fonts, word, size);
    if (max_width > 0 && !line.empty() && line.pen() + word.blank_width * size + width > max_width) {
      next_line();
    } else if (word.blank_width > 0) {
      line.blank(word.blanks_before, word.blank_width);
    }
    if (word.tab_before) tab = line.pen();
    if (max_width <= 0 || tab + width <= max_width) {
      for (const auto& piece : word.pieces) line.add(piece);
      continue;
    }
    for (const auto& letter : letters_of(word)) {
      const double script = letter.level == Level::base ? 1 : script_size;
      const double room = letter.formula != nullptr
                              ? lay_out(fonts, *letter.formula->math, size, letter.formula->display).width
                              : fonts.width(letter.style, letter.text) * size * script;
      if (!line.empty() && line.pen() + room > max_width) next_line();
      line.add(letter);
    }
  }
  line.flush(block, align);
  return block;
}

}  // namespace blossom
