#include "lesson/prose_scan.hpp"

#include <algorithm>
#include <optional>

#include "base/diagnostics.hpp"
#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_bytes = 20'000, most_words = 500, most_address = 2'000, most_indent = 12;

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }
bool is_word(char c) { return is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80; }
bool is_blank(char c) { return c == ' ' || c == '\n'; }
bool is_one_of(char c, std::string_view some) { return some.find(c) != std::string_view::npos; }
bool is_punctuation(char c) { return '!' <= c && c <= '~' && !is_letter(c) && !is_digit(c); }

// Byte for byte as long as the text: what cannot be shown, and the two marks of formulas, become blanks.
std::string printable_text(std::string_view text) {
  std::string made(text);
  for (std::size_t i = 0; i < made.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view character = text.substr(i, std::max<std::size_t>(length, 1));
    const bool bad = length == 0 || (character != "\n" && is_control(character)) || character == formula_begin ||
                     character == formula_end;
    if (bad) std::fill_n(made.begin() + static_cast<std::ptrdiff_t>(i), character.size(), ' ');
    i += character.size();
  }
  return made;
}

class Scanner {
 public:
  Scanner(std::string text, std::vector<ProseMistake>& mistakes) : text_(std::move(text)), mistakes_(&mistakes) {}

  ScannedProse scan() {
    while (at_ < text_.size()) line();
    return std::move(out_);
  }

 private:
  char now() const { return peek(0); }
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n'; }
  char before() const { return at_ > 0 ? text_[at_ - 1] : '\n'; }
  void mistake(std::size_t at, std::string what) { mistakes_->push_back({at, std::move(what)}); }

  void put(std::string_view markdown) {
    out_.markdown += markdown;
    out_.origin.insert(out_.origin.end(), markdown.size(), static_cast<std::uint32_t>(std::min(at_, text_.size())));
  }
  // The character here, and on.
  void keep() {
    put(text_.substr(at_, 1));
    ++at_;
  }
  void escape() {
    put("\\");
    keep();
  }

  void line() {
    end_ = std::min(text_.find('\n', at_), text_.size());
    closes_ = std::string::npos;
    underscore_searched_ = false;
    std::size_t indent = 0;
    while (at_ < end_ && now() == ' ') ++at_, ++indent;
    put(std::string(std::min(indent, most_indent), ' '));
    block_start(true);
    while (at_ < end_) inline_text();
    if (at_ < text_.size() && now() == '\n') keep();
  }

  std::string_view rest_of_line() const { return std::string_view(text_).substr(at_, end_ - at_); }
  bool only_of(std::string_view characters) const {
    const std::string_view rest = rest_of_line();
    return !rest.empty() && rest.find_first_not_of(characters) == std::string_view::npos;
  }

  // What makes the beginning of a line more than text: of it only the marks of lists are wanted.
  void block_start(bool list_allowed) {
    const std::string_view rest = rest_of_line();
    if (rest.empty()) return;
    const char c = rest[0];
    const std::size_t hashes = std::min(rest.find_first_not_of('#'), rest.size());
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    const bool rule = (only_of("- ") || only_of("* ") || only_of("_ ")) && std::ranges::count(rest, c) >= 3;
    if (rule) {
      mistake(at_, "a line of " + std::string(1, c) +
                       " is none of the Markdown there is here; leave it out, or write \\" + std::string(1, c) +
                       " for the sign");
      escape();
    } else if (only_of("=") || only_of("-")) {
      escape();
    } else if (1 <= hashes && hashes <= 6 && (hashes == rest.size() || rest[hashes] == ' ')) {
      mistake(at_, "there are no headings here; write it in **bold**, or \\# for the sign");
      escape();
    } else if (c == '>') {
      mistake(at_, "there are no quotes here; write \\> for the sign");
      escape();
    } else if ((rest.starts_with("```") && rest.find('`', rest.find_first_not_of('`')) == std::string_view::npos) ||
               rest.starts_with("~~~")) {
      mistake(at_, "there are no blocks of code here; write `code` in the line");
      while (now() == c) escape();
    } else if (c == '*' && rest.starts_with("* ")) {
      mistake(at_, "a list begins with \"- \"; write \\* for the sign");
      escape();
    } else if (c == '+') {
      escape();
    } else if (c == '-' && rest.starts_with("- ")) {
      mark_of_list(1, list_allowed);
    } else if (1 <= digits && digits < rest.size() && is_one_of(rest[digits], ".)")) {
      mark_of_list(digits + 1, list_allowed && digits <= 2 && rest[digits] == '.');
    } else if (c == '|' || c == ':' || c == '-') {
      const bool row = only_of("|:- ") && rest.find('-') != std::string_view::npos && std::ranges::count(rest, '|') > 0;
      if (row) mistake(at_, "there are no tables here");
    }
  }

  // "-" or "12.", with blanks behind it and something behind those.
  void mark_of_list(std::size_t length, bool allowed) {
    const std::string_view rest = rest_of_line();
    const std::size_t content = rest.find_first_not_of(' ', length);
    const bool is_mark = length < rest.size() && rest[length] == ' ' && content != std::string_view::npos;
    for (std::size_t i = 1; i < length; ++i) keep();
    if (!is_mark || !allowed) return escape();
    keep();
    put(" ");
    at_ += content - length;
    block_start(false);
  }

  void inline_text() {
    switch (now()) {
      case '\\':
        if (is_punctuation(peek(1))) return keep(), keep();
        if (is_letter(peek(1))) command();
        return escape();
      case '`':
        return code();
      case '$':
        return formula();
      case '*':
        return stars();
      case '_':
        return underscore();
      case '[':
        return bracket(at_);
      case ']':
        if (at_ == closes_) {
          put("](" + std::to_string(out_.addresses.size() - 1) + ")");
          at_ = behind_link_;
          closes_ = std::string::npos;
          return;
        }
        return escape();
      case '!':
        if (peek(1) == '[' && link_at(at_ + 1)) {
          mistake(at_, "there are no pictures in what is said");
          ++at_;
          return;
        }
        return escape();
      case '<':
        check_html();
        return escape();
      case '&':
      case '~':
      case '|':
        return escape();
      default:
        keep();
    }
  }

  // TeX outside of a formula.
  void command() {
    std::size_t length = 1;
    while (is_letter(peek(length))) ++length;
    const std::string name = text_.substr(at_, std::min(length, most_words));
    mistake(at_, name + " belongs between dollar signs: $" + name + "$; write \\\\ for a backslash");
  }

  void code() {
    const std::size_t ticks = std::min(text_.find_first_not_of('`', at_), end_) - at_;
    const auto end = end_of_code(std::string_view(text_).substr(0, end_), at_);
    if (!end) {
      mistake(at_, "a ` has no partner in its line; write \\` for the sign");
      for (std::size_t i = 0; i < ticks; ++i) escape();
      return;
    }
    while (at_ < *end) keep();
  }

  void formula() {
    const bool display = peek(1) == '$';
    const std::size_t signs = display ? 2 : 1;
    const auto end = end_of_math(text_, at_);
    if (!end) {
      mistake(at_,
              std::string("a ") + (display ? "$$" : "$") + " has no partner in its paragraph; write \\$ for the sign");
      for (std::size_t i = 0; i < signs; ++i) escape();
      return;
    }
    const std::size_t begin = at_ + signs;
    // As in "it costs $5 and $6".
    if (!display && (is_blank(text_[*end - 2]) || (*end < text_.size() && is_digit(text_[*end]))))
      mistake(at_,
              "a $ with a blank before it or a digit behind it ends no formula; write \\$ for the sign of the dollar");
    put(std::string(formula_begin) + std::to_string(out_.formulas.size()) + std::string(formula_end));
    out_.formulas.push_back({text_.substr(begin, *end - signs - begin), begin, display});
    at_ = *end;
    end_ = std::min(text_.find('\n', at_), text_.size());
  }

  // Emphasis begins at the beginning of words and ends at their end; all other stars are stars.
  void stars() {
    std::size_t count = 1;
    while (peek(count) == '*') ++count;
    const char left = before(), right = peek(count);
    const auto outside = [](char c, std::string_view fences) {
      return is_blank(c) || (is_punctuation(c) && !is_one_of(c, fences));
    };
    const bool opens = outside(left, ")]}") && !is_blank(right) && !is_one_of(right, "]).,;:!?");
    const bool alone = is_one_of(left, "([") && is_one_of(right, ")]");
    const bool closes = outside(right, "([{") && !is_blank(left) && !alone;
    for (std::size_t i = 0; i < count; ++i) {
      if (count > 3 || (!opens && !closes))
        escape();
      else
        keep();
    }
  }

  void underscore() {
    const bool begins = (is_blank(before()) || before() == '(') && (is_word(peek(1)) || peek(1) == '_');
    if (begins && !underscore_searched_) {
      std::size_t close = text_.find('_', at_ + 2);
      while (close < end_ && (is_blank(text_[close - 1]) || (close + 1 < end_ && is_word(text_[close + 1]))))
        close = text_.find('_', close + 1);
      underscore_searched_ = true;
      if (close < end_) mistake(at_, "emphasis is written *so*, bold **so**; write \\_ for the sign");
    }
    escape();
  }

  struct LinkPlace {
    std::size_t closes, behind;  // of the ] and behind the address
    std::string address;
  };
  // [words](address) in one line. Right behind a word, brackets are those of a name: P[1](u) is no link.
  std::optional<LinkPlace> link_at(std::size_t open) const {
    if (closes_ != std::string::npos) return std::nullopt;  // no links in links
    if (open > 0 && (is_word(text_[open - 1]) || is_one_of(text_[open - 1], "_]"))) return std::nullopt;
    int depth = 0;
    std::size_t close = open;
    for (; close < std::min(end_, open + most_words); ++close) {
      if (text_[close] == '\\')
        ++close;
      else if (text_[close] == '[')
        ++depth;
      else if (text_[close] == ']' && --depth == 0)
        break;
    }
    if (close + 1 >= end_ || depth != 0 || text_[close] != ']' || text_[close + 1] != '(') return std::nullopt;
    const std::size_t begin = close + 2, end = text_.find(')', begin);
    if (close == open + 1 || end >= end_ || end - begin > most_address) return std::nullopt;
    return LinkPlace{close, end + 1, text_.substr(begin, end - begin)};
  }

  // [words](https:... that does not end in its line.
  bool is_open_link(std::size_t open) const {
    const std::string_view rest = std::string_view(text_).substr(open, std::min(end_ - open, most_words));
    const std::size_t close = rest.find("](");
    if (closes_ != std::string::npos || close == std::string_view::npos) return false;
    const std::string_view address = std::string_view(text_).substr(open + close + 2, end_ - open - close - 2);
    return (address.starts_with("http") || address.starts_with("mailto:")) &&
           address.find(')') == std::string_view::npos;
  }

  void bracket(std::size_t open) {
    const auto link = link_at(open);
    if (!link) {
      if (is_open_link(open)) mistake(open, "the address of a link has no ) behind it in its line");
      return escape();
    }
    const bool safe = is_safe_address(link->address);
    if (!safe)
      mistake(link->closes + 2,
              "an address begins with https:, http: or mailto:, or is a file beside the lesson, without "
              "blanks; not " +
                  excerpt(link->address));
    out_.addresses.push_back(safe ? link->address : "");
    closes_ = link->closes;
    behind_link_ = link->behind;
    keep();
  }

  // <b>, </b>, <a href="...">, <!-- -->; but a<b is a comparison.
  void check_html() {
    const bool ends_tag = peek(1) == '/' && is_letter(peek(2));
    const bool begins_tag = is_letter(peek(1)) && !is_word(before()) && !is_one_of(before(), ")]");
    if (!ends_tag && !begins_tag && peek(1) != '!') return;
    const std::size_t close = text_.find('>', at_);
    if (close < std::min(end_, at_ + most_words)) mistake(at_, "there is no HTML here; write \\< for the sign");
  }

  std::string text_;
  std::vector<ProseMistake>* mistakes_;
  ScannedProse out_;
  std::size_t at_ = 0, end_ = 0;                              // of the line
  std::size_t closes_ = std::string::npos, behind_link_ = 0;  // of the link that is open
  bool underscore_searched_ = false;
};

}  // namespace

bool is_safe_address(std::string_view address) {
  if (address.empty()) return false;
  for (const char c : address)
    if (c <= ' ' || c == '\x7F' || is_one_of(c, "\"'<>\\`{}|^")) return false;
  for (const std::string_view scheme : {"https:", "http:", "mailto:"})
    if (address.starts_with(scheme)) return address.size() > scheme.size();
  if (address[0] == '/' || address.find(':') != std::string_view::npos) return false;
  // Beside it or below it.
  for (std::size_t at = 0; at <= address.size();) {
    const std::size_t end = std::min(address.find('/', at), address.size());
    if (address.substr(at, end - at) == "..") return false;
    at = end + 1;
  }
  return true;
}

ScannedProse scan_prose(std::string_view text, std::vector<ProseMistake>& mistakes) {
  if (text.size() > most_bytes) {
    mistakes.push_back({most_bytes, "what is said has at most " + std::to_string(most_bytes) + " bytes"});
    std::size_t end = most_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    text = text.substr(0, end);
  }
  return Scanner(printable_text(text), mistakes).scan();
}

}  // namespace blossom
