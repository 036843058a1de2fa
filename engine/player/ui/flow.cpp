// Running text set into lines, with the names of values as things that can be pointed at.
#include <algorithm>
#include <utility>

#include "algorithms/typeset.hpp"
#include "player/ui/ui.hpp"
#include "render/rich_text.hpp"

namespace blossom {
namespace {

// A word of running text: letters between blanks, or a value's name with its indices ("P[1][4]", "raise[1].Q[2]").
struct Word {
  std::string text;
  std::optional<ValueId> value;
  bool blank_before = false;
  bool line_before = false;
  const Span* span = nullptr;  // what it is part of: how it looks; a formula is one word
  bool display = false;        // of a formula
  double indent = 0;           // in ems: where lines begin that go on from here
  bool at_indent = false;      // it begins there, too: behind a bullet
  std::string around = {};     // of a letter that may be a word, "a" or "I": what tells
};

bool is_name_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }

// The length of what looks like a value's name at the front of the text: letters, dots and bracketed indices.
std::size_t name_length(std::string_view text) {
  if (text.empty() || std::isalpha(static_cast<unsigned char>(text[0])) == 0) return 0;
  std::size_t i = 0;
  while (i < text.size() && (is_name_letter(text[i]) || text[i] == '[')) {
    if (text[i] == '[') {
      const std::size_t end = text.find(']', i);
      if (end == std::string_view::npos || end == i + 1) break;
      i = end;
    } else if (text[i] == '_' && i + 1 < text.size() && (text[i + 1] == '{' || text[i + 1] == '(')) {
      // u_{k+1}, N_(3,2)
      const std::size_t end = text.find(text[i + 1] == '{' ? '}' : ')', i);
      return end == std::string_view::npos || end > i + 16 ? i + 1 : end + 1;
    }
    ++i;
  }
  while (i > 0 && text[i - 1] == '.') --i;
  return i;
}

// The value of a name as it is written within a phase: looked up there first, then further out.
std::optional<ValueId> value_named(std::string_view name, const TraceGraph& graph, std::string scope) {
  const std::size_t local = name.rfind('.') == std::string_view::npos ? 0 : name.rfind('.') + 1;
  std::string full(name);
  // Only what has indices is surely meant: "a" is also an article. u_3 is the knot U[3].
  if (name.substr(local).starts_with("u_"))
    full = std::string(name.substr(0, local)) + "U[" + std::string(name.substr(local + 2)) + "]";
  else if (name.find('[') == std::string_view::npos)
    return std::nullopt;
  for (;;) {
    if (const auto value = graph.find(scope + full)) return value;
    if (scope.empty()) return std::nullopt;
    scope.pop_back();
    const auto dot = scope.rfind('.');
    scope.erase(dot == std::string::npos ? 0 : dot + 1);
  }
}

// The letter with what stands before it and the word behind it.
std::string around_letter(const std::string& text, std::size_t at) {
  if (std::string_view("AIa").find(text[at]) == std::string_view::npos) return {};
  const std::size_t before = text.substr(0, at).find_last_not_of(" \n\"(");
  const std::size_t end = text.find_first_of(" \n", std::min(at + 2, text.size()));
  return (before == std::string::npos ? "" : text.substr(before, 1) + " ") +
         text.substr(at, end == std::string::npos ? end : end - at);
}

std::vector<Word> words_of(const std::string& text, const TraceGraph& graph, std::uint32_t step,
                           const std::string& scope) {
  std::vector<Word> words;
  bool blank = false, line = false;
  std::size_t i = 0;
  const auto add = [&](std::string piece, std::optional<ValueId> value) {
    words.push_back({std::move(piece), value, blank, line});
    blank = line = false;
  };
  while (i < text.size()) {
    if (text[i] == ' ' || text[i] == '\n') {
      (text[i] == ' ' ? blank : line) = true;
      ++i;
      continue;
    }
    const std::string_view rest = std::string_view(text).substr(i);
    const bool at_word = i == 0 || (!is_name_letter(text[i - 1]) && text[i - 1] != '\'');
    if (const std::size_t length = at_word ? name_length(rest) : 0; length > 0) {
      const std::string name(rest.substr(0, length));
      std::optional<ValueId> value = value_named(name, graph, scope);
      if (value && graph.value(*value).step > step) value.reset();
      add(name, value);
      if (length == 1) words.back().around = around_letter(text, i);
      i += length;
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && text[end] != ' ' && text[end] != '\n' &&
           !(std::isalpha(static_cast<unsigned char>(text[end])) != 0 && !is_name_letter(text[end - 1]) &&
             text[end - 1] != '\''))
      ++end;
    add(text.substr(i, end - i), std::nullopt);
    i = end;
  }
  return words;
}

// Behind the last word of the cluster that begins here. A line breaks at blanks only: what follows without one (a
// bracket, a full stop) comes along, and so does what stands in short parentheses, "(1/2 - 1/5)".
std::size_t end_of_cluster(const std::vector<Word>& words, std::size_t begin) {
  constexpr std::size_t most = 24;
  const auto joined = [&](std::size_t end) {
    do ++end;
    while (end < words.size() && !words[end].blank_before && !words[end].line_before);
    return end;
  };
  const auto open_in = [&](std::size_t from, std::size_t to, std::size_t& letters) {
    std::ptrdiff_t open = 0;
    for (std::size_t i = from; i < to; ++i) {
      open += std::ranges::count(words[i].text, '(') - std::ranges::count(words[i].text, ')');
      letters += words[i].text.size() + (words[i].blank_before ? 1 : 0);
    }
    return open;
  };
  const std::size_t first = joined(begin);
  std::size_t end = first, letters = 0;
  std::ptrdiff_t open = open_in(begin, end, letters);
  while (open > 0 && letters <= most && end < words.size() && !words[end].line_before) {
    const std::size_t next = joined(end);
    open += open_in(end, next, letters);
    end = next;
  }
  return open <= 0 && letters <= most ? end : first;
}

// The same of a text that was read: each word knows how it looks.
std::vector<Word> words_of(const Prose& prose, const TraceGraph& graph, std::uint32_t step, const std::string& scope) {
  std::vector<Word> words;
  for (const Block& block : prose) {
    const bool item = block.kind == Block::Kind::item;
    const double bullet = !item ? 0 : block.number > 9 ? 1.9 : block.number > 0 ? 1.4 : 1.0;
    const double indent = 1.4 * block.level + (block.kind == Block::Kind::formula ? 1.4 : bullet);
    bool line = !words.empty();
    if (item) {
      const std::string mark = block.number > 0 ? std::to_string(block.number) + "." : "•";
      words.push_back({mark, std::nullopt, true, std::exchange(line, false), nullptr, false, 1.4 * block.level});
    }
    const std::size_t first = words.size();
    bool blank = false;
    for (const Span& span : block.spans) {
      std::vector<Word> made;
      if (span.math != nullptr)
        made.push_back({"", std::nullopt, false, false, &span, block.kind == Block::Kind::formula, 0});
      else
        made = words_of(span.text, graph, span.kind == Span::Kind::code ? 0 : step, scope);
      if (!made.empty() && blank) made.front().blank_before = true;
      blank = span.math == nullptr && span.text.ends_with(' ');
      for (Word& word : made) {
        word.span = &span;
        word.indent = indent;
        words.push_back(std::move(word));
      }
    }
    if (first < words.size()) {
      words[first].line_before = line;
      words[first].blank_before = words[first].at_indent = item;
    }
  }
  return words;
}

struct Piece {  // a word, set
  RichText text;
  TextBlock block;  // its measures
  bool lit = false;
};

const std::string at_most = "\u2264";

// "a curve": no name, unlike the a of "a times 2". Which it is the words around it tell.
bool is_article(const Word& word, const Algorithm& algorithm) {
  return !word.around.empty() && std::ranges::none_of(typeset_text(word.around, algorithm), [&](const TextRun& run) {
    return run.italic && run.text == word.text;
  });
}

RichText look_of(const Word& word, const Algorithm& algorithm) {
  const Span* span = word.span;
  if (span != nullptr && span->math != nullptr) {
    TextRun run{plain_math(*span->math), TextRun::Level::base, false, span->bold};
    run.math = span->math;
    run.display = word.display;
    return {run};
  }
  const bool code = span != nullptr && span->kind == Span::Kind::code;
  // The s of "Boor's" is not the multiplicity.
  const bool plain = code || (word.text.starts_with('\'') && !word.blank_before) || is_article(word, algorithm);
  const std::string& text = word.text == "<=" && !code ? at_most : word.text;
  RichText runs = plain ? RichText{{text, TextRun::Level::base, false, false, code}} : typeset_text(text, algorithm);
  for (TextRun& run : runs) {
    run.bold = run.bold || (span != nullptr && span->bold);
    run.italic = run.italic || (span != nullptr && span->italic && run.level == TextRun::Level::base);
  }
  return runs;
}

// The line that is being filled; where a formula is high, all that is on it moves down.
class Lines {
 public:
  Lines(Sheet& sheet, double em) : sheet_(&sheet), em_(em), baseline_(1.05 * em), up_(1.05 * em), down_(0.45 * em) {}

  double baseline() const { return baseline_; }
  double bottom() const { return baseline_ + down_; }
  void next() {
    baseline_ += std::max(1.5 * em_, down_ + 1.05 * em_);
    up_ = 1.05 * em_, down_ = 0.45 * em_;
    labels_ = sheet_->view.labels.size(), polygons_ = sheet_->view.polygons.size(), spots_ = sheet_->spots.size();
  }
  void make_room(const TextBlock& block) {
    constexpr double clearance = 0.12;
    down_ = std::max(down_, block.bottom + clearance * em_);
    const double by = -block.top + clearance * em_ - up_;
    if (by <= 0) return;
    up_ += by;
    baseline_ += by;
    View& view = sheet_->view;
    for (std::size_t i = labels_; i < view.labels.size(); ++i) view.labels[i].anchor.y += by;
    for (std::size_t i = polygons_; i < view.polygons.size(); ++i)
      for (auto& point : view.polygons[i].points) point.y += by;
    for (std::size_t i = spots_; i < sheet_->spots.size(); ++i) sheet_->spots[i].y += by;
  }

 private:
  Sheet* sheet_;
  double em_, baseline_, up_, down_;
  std::size_t labels_ = 0, polygons_ = 0, spots_ = 0;  // where those of the line begin
};

class FlowSetter {
 public:
  FlowSetter(const Player& player, const Theme& theme, const Fonts& fonts, bool values, std::optional<ValueId> about)
      : player_(player),
        theme_(theme),
        fonts_(fonts),
        graph_(player.session()->recording().graph()),
        values_(values),
        step_(about ? graph_.value(*about).step : player.session()->step()),
        algorithm_(player.session()->recording().source().algorithm_at(step_)) {
    for (const std::uint32_t phase : graph_.phase_path(graph_.step(step_).phase))
      if (graph_.phases()[phase].scoped) scope_ += graph_.phases()[phase].label() + ".";
  }

  template <class Text>
  std::vector<Word> words(const Text& text) const {
    return words_of(text, graph_, values_ ? player_.session()->step() : 0, scope_);
  }

  Sheet set(const std::vector<Word>& words, double width, double size, Role role, double& height) const {
    Sheet sheet;
    const double em = theme_[role].text_size * size, blank = fonts_.width({}, " ") * em;
    Lines lines(sheet, em);
    double x = words.empty() ? 0 : words[0].indent * em;
    for (std::size_t begin = 0, end = 0; begin < words.size(); begin = end) {
      end = end_of_cluster(words, begin);
      const double start = words[begin].indent * em;
      const auto next_line = [&] {
        lines.next();
        x = start;
      };
      std::vector<Piece> pieces;
      double cluster = 0;
      for (std::size_t i = begin; i < end; ++i) {
        pieces.push_back(piece(words[i], em));
        cluster += pieces.back().block.width + (i > begin && words[i].blank_before ? blank : 0);
      }
      if (words[begin].line_before)
        next_line();
      else if (words[begin].blank_before && x > start)
        x += blank;
      if (words[begin].at_indent) x = std::max(x, start);
      if (x > start && x + cluster > width) next_line();
      for (std::size_t i = begin; i < end; ++i) {
        if (i > begin && words[i].blank_before) x += blank;
        const double wide = pieces[i - begin].block.width;
        if (x > start && x + wide > width) next_line();  // wider than a line by itself
        lines.make_room(pieces[i - begin].block);
        put(sheet, words[i], std::move(pieces[i - begin]), x, lines.baseline(), em, size, role);
        x += wide;
      }
    }
    height = lines.bottom();
    return sheet;
  }

 private:
  Piece piece(const Word& word, double em) const {
    Piece made{look_of(word, algorithm_), {}, word.value && player_.emphasis().lights(*word.value)};
    if (made.lit)
      for (TextRun& run : made.text) run.bold = true;
    made.block = set_text(fonts_, made.text, em, TextAlign::left);
    return made;
  }

  void put(Sheet& sheet, const Word& word, Piece piece, double x, double baseline, double em, double size,
           Role role) const {
    if (const auto& value = word.value) {
      const double top = baseline - em * 1.0, bottom = baseline + em * 0.42, right = x + piece.block.width + 2;
      if (piece.lit || player_.emphasis().share(*value) != 0)
        sheet.view.polygons.push_back({{{x - 2, top, 0}, {right, top, 0}, {right, bottom, 0}, {x - 2, bottom, 0}},
                                       Role::highlight,
                                       piece.lit ? 0.22 : 0.1});
      if (values_)
        sheet.spots.push_back(
            {{Link::Kind::value, *value}, x - 2, top, piece.block.width + 4, bottom - top, graph_.name(*value)});
    }
    Label label;
    label.anchor = {x, baseline, 0};
    label.text = std::move(piece.text);
    label.role = piece.lit ? Role::highlight : role;
    label.size_scale = size;
    sheet.view.labels.push_back(std::move(label));
  }

  const Player& player_;
  const Theme& theme_;
  const Fonts& fonts_;
  const TraceGraph& graph_;
  bool values_;
  std::uint32_t step_;
  const Algorithm& algorithm_;
  std::string scope_;
};

}  // namespace

Sheet Ui::flow(const std::string& text, double width, double size, Role role, double& height, bool values,
               std::optional<ValueId> about) const {
  const FlowSetter setter(*player_, theme_, *fonts_, values, about);
  return setter.set(setter.words(text), width, size, role, height);
}

Sheet Ui::flow(const Prose& prose, double width, double size, Role role, double& height, bool values,
               std::optional<ValueId> about) const {
  const FlowSetter setter(*player_, theme_, *fonts_, values, about);
  return setter.set(setter.words(prose), width, size, role, height);
}

Sheet Ui::flow(const RichText& text, double width, double size, Role role, double& height) const {
  const double em = theme_[role].text_size * size;
  const TextBlock block = set_text(*fonts_, text, em, TextAlign::left, width);
  Label label;
  label.anchor = {0, std::max(1.05 * em, 0.12 * em - block.top), 0};
  height = label.anchor.y + std::max(0.45 * em, block.bottom + 0.12 * em);
  label.text = text;
  label.role = role;
  label.size_scale = size;
  label.max_width = width;
  Sheet sheet;
  sheet.view.labels.push_back(std::move(label));
  return sheet;
}

}  // namespace blossom
