#include "render/rich_text.hpp"

#include <algorithm>
#include <utility>

namespace blossom {
namespace {

using Level = TextRun::Level;

constexpr double script_size = 0.7, sub_drop = 0.22, super_rise = 0.38, line_distance = 1.4;

struct Piece {  // of one run; without blanks
  std::string text;
  FontStyle style;
  Level level = Level::base;
};

struct Word {
  std::vector<Piece> pieces;
  std::string blanks_before;
  double blank_width = 0;  // in ems
  bool line_before = false;
};

// Sets pieces one after the other and knows where the pen is; a script pair shares one start.
class LineSetter {
 public:
  LineSetter(const Fonts& fonts, double size) : fonts_(&fonts), size_(size) {}

  void add(const Piece& piece) {
    const bool script = piece.level != Level::base;
    const bool stacks = script && previous_ != Level::base && previous_ != piece.level;
    const double size = script ? size_ * script_size : size_;
    const double start = stacks ? script_start_ : pen_;
    const double rise = piece.level == Level::sub ? -sub_drop : piece.level == Level::super ? super_rise : 0;
    double width = fonts_->width(piece.style, piece.text) * size;
    if (!runs_.empty()) runs_.back().text += blanks_;  // so that text copied from a picture has its blanks
    const bool joins = !runs_.empty() && !script && runs_.back().size == size && runs_.back().style == piece.style;
    blanks_.clear();
    if (joins) {
      runs_.back().text += piece.text;
      width = runs_.back().x + fonts_->width(piece.style, runs_.back().text) * size - start;
    } else {
      runs_.push_back({piece.text, start, -rise * size_, size, piece.style});
    }
    top_ = std::min(top_, -rise * size_ - Fonts::ascent * size);
    bottom_ = std::max(bottom_, -rise * size_ + Fonts::descent * size);
    if (!script || previous_ == Level::base) script_start_ = start;
    pen_ = stacks ? std::max(pen_, start + width) : start + width;
    previous_ = script ? piece.level : Level::base;
  }
  void blank(const std::string& blanks, double ems) {
    blanks_ += blanks;
    pen_ += ems * size_;
    previous_ = Level::base;
  }
  double pen() const { return pen_; }
  bool empty() const { return runs_.empty(); }

  // Moves the line into the block, at the given baseline, and starts a new one.
  void flush(TextBlock& block, double baseline, TextAlign align) {
    const double shift = align == TextAlign::left ? 0 : align == TextAlign::centre ? -pen_ / 2 : -pen_;
    for (auto& run : runs_) {
      run.x += shift;
      run.baseline += baseline;
      block.runs.push_back(std::move(run));
    }
    block.left = std::min(block.left, shift);
    block.width = std::max(block.width, pen_);
    block.top = std::min(block.top, baseline + top_);
    block.bottom = std::max(block.bottom, baseline + bottom_);
    *this = LineSetter(*fonts_, size_);
  }

 private:
  const Fonts* fonts_;
  double size_;
  std::vector<GlyphRun> runs_;
  std::string blanks_;  // not yet followed by letters
  double pen_ = 0, script_start_ = 0;
  Level previous_ = Level::base;
  double top_ = 0, bottom_ = 0;
};

std::vector<Word> split_words(const Fonts& fonts, const RichText& text) {
  std::vector<Word> words(1);
  for (const auto& run : text) {
    const FontStyle style{run.bold, run.italic, run.monospace};
    std::size_t start = 0;
    for (std::size_t i = 0; i <= run.text.size(); ++i) {
      const bool ends = i == run.text.size();
      if (!ends && run.text[i] != ' ' && run.text[i] != '\n') continue;
      if (i > start) words.back().pieces.push_back({run.text.substr(start, i - start), style, run.level});
      start = i + 1;
      if (ends) continue;
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
    for (const char32_t c : decode_utf8(piece.text)) letters.push_back({encode_utf8(c), piece.style, piece.level});
  }
  return letters;
}

}  // namespace

TextBlock set_text(const Fonts& fonts, const RichText& text, double size, TextAlign align, double max_width) {
  TextBlock block;
  LineSetter line(fonts, size);
  double baseline = 0;
  const auto next_line = [&] {
    line.flush(block, baseline, align);
    baseline += line_distance * size;
  };
  for (const auto& word : split_words(fonts, text)) {
    if (word.line_before) next_line();
    const double width = width_of(fonts, word, size);
    if (max_width > 0 && !line.empty() && line.pen() + word.blank_width * size + width > max_width) {
      next_line();
    } else if (word.blank_width > 0) {
      line.blank(word.blanks_before, word.blank_width);
    }
    if (max_width <= 0 || width <= max_width) {
      for (const auto& piece : word.pieces) line.add(piece);
      continue;
    }
    for (const auto& letter : letters_of(word)) {
      const double script = letter.level == Level::base ? 1 : script_size;
      if (!line.empty() && line.pen() + fonts.width(letter.style, letter.text) * size * script > max_width) next_line();
      line.add(letter);
    }
  }
  line.flush(block, baseline, align);
  return block;
}

}  // namespace blossom
