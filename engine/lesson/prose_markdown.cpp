// Prose as Markdown again: what was read reads back as the same, here and by other readers of CommonMark.
#include <algorithm>
#include <cctype>

#include "lesson/prose_text.hpp"

namespace blossom {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

std::string escaped(std::string_view text) {
  std::string out;
  std::size_t index_ends = std::string_view::npos;  // the ] of a name's index, P[1][0], which needs no backslash
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
    const bool letter_after = std::isalpha(static_cast<unsigned char>(after)) != 0;
    bool mark = std::string_view("\\`*$~|[]").find(c) != std::string_view::npos;
    if (c == '[' && (is_word(before) || before == ']')) {
      const std::size_t end = text.find_first_of("[]", i + 1);
      const bool index = end < text.size() && text[end] == ']' && (end + 1 == text.size() || text[end + 1] != '(');
      if (index) index_ends = end;
      mark = !index;
    } else if (c == ']') {
      mark = i != index_ends;
    } else if (c == '_') {
      mark = !(is_word(before) && is_word(after));
    } else if (c == '!') {
      mark = after == '[';
    } else if (c == '<') {
      mark = letter_after || after == '/' || after == '!';
    } else if (c == '&') {
      mark = letter_after || after == '#';
    }
    if (mark) out += '\\';
    out += c;
  }
  return out;
}

// At the beginning of a line some characters begin more than a line.
std::string as_line_start(std::string words) {
  if (words.empty()) return words;
  if (std::string_view("#>+-=:").find(words[0]) != std::string_view::npos) return "\\" + words;
  const std::size_t digits = words.find_first_not_of("0123456789");
  if (digits != std::string::npos && digits > 0 && (words[digits] == '.' || words[digits] == ')'))
    words.insert(digits, 1, '\\');
  return words;
}

std::string code(const std::string& text) {
  std::size_t most = 0, run = 0;
  for (const char c : text) most = std::max(most, run = c == '`' ? run + 1 : 0);
  const std::string ticks(most + 1, '`');
  const bool pad = text.starts_with('`') || text.ends_with('`') ||
                   (text.starts_with(' ') && text.ends_with(' ') && text.find_first_not_of(' ') != std::string::npos);
  return ticks + (pad ? " " : "") + text + (pad ? " " : "") + ticks;
}

// Marks of emphasis touch the words: blanks go outside.
std::string emphasized(const std::string& words, std::string_view marks) {
  const std::size_t begin = words.find_first_not_of(' '), last = words.find_last_not_of(' ');
  if (begin == std::string::npos) return words;
  return words.substr(0, begin) + std::string(marks) + words.substr(begin, last + 1 - begin) + std::string(marks) +
         words.substr(last + 1);
}

std::string plain(const Span& span) {
  if (span.math != nullptr) return "$" + span.text + "$";
  return span.kind == Span::Kind::code ? code(span.text) : escaped(span.text);
}

std::string line_of(const std::vector<Span>& spans) {
  std::string out;
  for (std::size_t i = 0; i < spans.size();) {
    // What is emphasized in one manner stands between one pair of marks.
    const Span& first = spans[i];
    std::string words;
    for (; i < spans.size() && spans[i].bold == first.bold && spans[i].italic == first.italic &&
           spans[i].link == first.link;
         ++i)
      words += plain(spans[i]);
    if (first.bold || first.italic)
      words = emphasized(words, first.bold && first.italic ? "***" : first.bold ? "**" : "*");
    out += first.link.empty() ? words : "[" + words + "](" + first.link + ")";
  }
  return out;
}

}  // namespace

std::string prose_markdown(const Prose& prose) {
  std::string out;
  for (std::size_t i = 0; i < prose.size(); ++i) {
    const Block& block = prose[i];
    const bool in_list = i > 0 && block.kind == Block::Kind::item && prose[i - 1].kind == Block::Kind::item;
    if (i > 0) out += in_list ? "\n" : "\n\n";
    out.append(4 * static_cast<std::size_t>(block.level), ' ');
    if (block.kind == Block::Kind::item) out += block.number > 0 ? std::to_string(block.number) + ". " : "- ";
    if (block.kind == Block::Kind::formula && !block.spans.empty())
      out += "$$" + block.spans[0].text + "$$";
    else
      out += as_line_start(line_of(block.spans));
  }
  if (!out.empty()) out += '\n';
  return out;
}

}  // namespace blossom
