#include "lesson/prose.hpp"

#include <md4c.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "lesson/prose_scan.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_mistakes = 50;
constexpr int most_list_levels = 3;

// The number at the beginning of a text, which the scanner has written there.
std::size_t number_in(std::string_view text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

bool is_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

class Reader {
 public:
  Reader(const ScannedProse& scanned, std::vector<ProseMistake>& mistakes) : scanned_(&scanned), mistakes_(&mistakes) {}

  Prose read() {
    MD_PARSER parser{};
    parser.flags = MD_FLAG_NOHTML | MD_FLAG_NOINDENTEDCODEBLOCKS;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) {
      return static_cast<Reader*>(self)->enter(type, detail), 0;
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) {
      return static_cast<Reader*>(self)->leave(type), 0;
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) {
      return static_cast<Reader*>(self)->span(type, detail, +1), 0;
    };
    parser.leave_span = [](MD_SPANTYPE type, void* detail, void* self) {
      return static_cast<Reader*>(self)->span(type, detail, -1), 0;
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* self) {
      return static_cast<Reader*>(self)->text(type, {text, size}), 0;
    };
    const std::string& markdown = scanned_->markdown;
    md_parse(markdown.data(), static_cast<MD_SIZE>(markdown.size()), &parser, this);
    close();
    return std::move(prose_);
  }

 private:
  struct List {
    bool numbered;
    int next;
  };

  std::size_t origin(std::string_view text) const {
    const auto offset = static_cast<std::size_t>(text.data() - scanned_->markdown.data());
    return offset < scanned_->origin.size() ? scanned_->origin[offset] : last_origin_;
  }

  // Whether a backslash stands before it in the Markdown.
  bool is_escaped(std::string_view text) const {
    const std::size_t at = static_cast<std::size_t>(text.data() - scanned_->markdown.data());
    std::size_t backslashes = 0;
    while (backslashes < at && scanned_->markdown[at - backslashes - 1] == '\\') ++backslashes;
    return backslashes % 2 == 1;
  }

  void enter(MD_BLOCKTYPE type, void* detail) {
    close();
    if (type == MD_BLOCK_UL) lists_.push_back({false, 0});
    if (type == MD_BLOCK_OL)
      lists_.push_back({true, static_cast<int>(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start)});
    if (type == MD_BLOCK_LI) item_begins_ = true;
  }
  void leave(MD_BLOCKTYPE type) {
    close();
    if (type == MD_BLOCK_UL || type == MD_BLOCK_OL) lists_.pop_back();
    if (type == MD_BLOCK_LI) item_begins_ = false;
  }
  void span(MD_SPANTYPE type, void* detail, int by) {
    if (type == MD_SPAN_EM) italic_ += by;
    if (type == MD_SPAN_STRONG) bold_ += by;
    if (type == MD_SPAN_CODE) code_ = by > 0;
    if (type != MD_SPAN_A) return;
    const MD_ATTRIBUTE& address = static_cast<MD_SPAN_A_DETAIL*>(detail)->href;
    const std::size_t n = number_in({address.text, address.size});
    link_ = by > 0 && n < scanned_->addresses.size() ? scanned_->addresses[n] : "";
  }

  void text(MD_TEXTTYPE type, std::string_view text) {
    if (type == MD_TEXT_BR || type == MD_TEXT_SOFTBR)
      text = " ";
    else
      last_origin_ = origin(text);
    if (code_ || type == MD_TEXT_CODE) return add(Span::Kind::code, text);
    // The scanner escapes every star that is no mark of emphasis.
    for (std::size_t i = text.find('*'); i != std::string_view::npos; i = text.find('*', i + 1)) {
      if (is_escaped(text.substr(i))) continue;
      const bool pair = text.substr(i).starts_with("**");
      // One star, as in *[2] or C*, may be no more than that; before a word it begins emphasis.
      if (!pair && (i + 1 == text.size() || !is_letter(text[i + 1]))) continue;
      mistakes_->push_back({origin(text.substr(i)), pair ? "a ** has no partner; write \\*\\* for the signs"
                                                         : "a * has no partner; write \\* for the sign"});
      i += pair ? 1 : 0;
    }
    while (!text.empty()) {
      const std::size_t begin = std::min(text.find(formula_begin), text.size());
      if (begin > 0) add(Span::Kind::text, text.substr(0, begin));
      if (begin == text.size()) return;
      const std::size_t end = text.find(formula_end, begin);
      if (end == std::string_view::npos) return;
      formula(number_in(text.substr(begin + formula_begin.size(), end - begin)));
      text.remove_prefix(end + formula_end.size());
    }
  }

  void formula(std::size_t n) {
    if (n >= scanned_->formulas.size()) return;
    const auto& [tex, at, display] = scanned_->formulas[n];
    MathMistake mistake;
    auto math = parse_math(tex, mistake);
    if (!math) {
      mistakes_->push_back({at + mistake.at, mistake.what});
      const std::string signs = display ? "$$" : "$";
      return add(Span::Kind::text, signs + tex + signs);
    }
    Span span{Span::Kind::math, tex, bold_ > 0, italic_ > 0, link_, std::make_shared<const Math>(*std::move(math))};
    if (!display) return block().spans.push_back(std::move(span));
    if (item_begins_) block();
    close();
    prose_.push_back({Block::Kind::formula, static_cast<int>(lists_.size()), 0, {std::move(span)}});
  }

  void add(Span::Kind kind, std::string_view text) {
    if (open_ == nowhere && kind == Span::Kind::text)
      text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (text.empty()) return;
    auto& spans = block().spans;
    Span span{kind, std::string(text), bold_ > 0, italic_ > 0, link_, nullptr};
    const bool joins = !spans.empty() && spans.back().kind == kind && spans.back().bold == span.bold &&
                       spans.back().italic == span.italic && spans.back().link == span.link;
    if (joins)
      spans.back().text += span.text;
    else
      spans.push_back(std::move(span));
  }

  // The block that is being written, or a new one.
  Block& block() {
    if (open_ != nowhere) return prose_[open_];
    const int level = static_cast<int>(lists_.size());
    Block made{Block::Kind::paragraph, level, 0, {}};
    if (item_begins_ && level > 0) {
      List& list = lists_.back();
      made = {Block::Kind::item, level - 1, list.numbered ? list.next++ : 0, {}};
      if (level > most_list_levels)
        mistakes_->push_back({last_origin_, "lists go at most " + std::to_string(most_list_levels) + " deep"});
    }
    item_begins_ = false;
    open_ = prose_.size();
    prose_.push_back(std::move(made));
    return prose_.back();
  }
  void close() {
    if (open_ == nowhere) return;
    auto& spans = prose_[open_].spans;
    if (!spans.empty() && spans.back().kind == Span::Kind::text) {
      std::string& text = spans.back().text;
      text.erase(text.find_last_not_of(' ') + 1);
      if (text.empty()) spans.pop_back();
    }
    if (spans.empty() && prose_[open_].kind == Block::Kind::paragraph) prose_.pop_back();
    open_ = nowhere;
  }

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  const ScannedProse* scanned_;
  std::vector<ProseMistake>* mistakes_;
  Prose prose_;
  std::size_t open_ = nowhere;  // the block that is being written
  std::size_t last_origin_ = 0;
  std::vector<List> lists_;
  bool item_begins_ = false, code_ = false;
  int bold_ = 0, italic_ = 0;
  std::string link_;
};

}  // namespace

Prose read_prose(std::string_view text, std::vector<ProseMistake>* mistakes) {
  std::vector<ProseMistake> found;
  const ScannedProse scanned = scan_prose(text, found);
  Prose prose = Reader(scanned, found).read();
  if (mistakes != nullptr) {
    std::ranges::stable_sort(found, {}, &ProseMistake::at);
    if (found.size() > most_mistakes) found.resize(most_mistakes);
    std::ranges::move(found, std::back_inserter(*mistakes));
  }
  return prose;
}

std::optional<std::size_t> open_brace(std::string_view say) {
  std::size_t code = 0;  // up to here a dollar sign is only one
  for (std::size_t i = 0; i < say.size(); ++i) {
    if (say[i] == '\\') {
      if (i + 1 < say.size() && std::string_view("$`\\{}").find(say[i + 1]) != std::string_view::npos) ++i;
    } else if (say[i] == '`' && i >= code) {
      code = end_of_code(say, i).value_or(say.find_first_not_of('`', i));
    } else if (say[i] == '$' && i >= code) {
      if (const auto end = end_of_math(say, i)) i = *end - 1;
    } else if (say[i] == '{') {
      const std::size_t end = say.find_first_of("{}", i + 1);
      if (end == std::string_view::npos || say[end] == '{') return i;
      i = end;
    }
  }
  return std::nullopt;
}

}  // namespace blossom
