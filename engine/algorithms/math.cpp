#include "algorithms/math.hpp"

#include <algorithm>
#include <iterator>

#include "algorithms/math_symbols.hpp"
#include "base/diagnostics.hpp"
#include "base/utf8.hpp"

namespace blossom {
namespace {

using Kind = Math::Kind;
using Class = Math::Class;

constexpr std::size_t most_bytes = 2000;
constexpr int most_levels = 24;

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }
bool is_digit(char c) { return '0' <= c && c <= '9'; }

Math symbol(std::string text, Class of, bool upright = false) {
  Math made;
  made.kind = Kind::symbol;
  made.of = of;
  made.upright = upright;
  made.text = std::move(text);
  return made;
}

Math made_of(Kind kind, std::vector<Math> parts) {
  Math made;
  made.kind = kind;
  made.parts = std::move(parts);
  return made;
}

// A group of one thing is that thing.
Math collapsed(Math row) {
  if (row.parts.size() != 1) return row;
  Math only = std::move(row.parts[0]);
  return only;
}

Class class_of(char c) {
  switch (c) {
    case '+':
    case '-':
      return Class::operation;
    case '=':
    case '<':
    case '>':
    case ':':
      return Class::relation;
    case '(':
    case '[':
      return Class::open;
    case ')':
    case ']':
    case '!':
      return Class::close;
    case ',':
    case ';':
      return Class::punctuation;
    default:
      return Class::variable;
  }
}

// Recursive descent; every level of it is counted, so that it ends at most_levels whatever the text is.
class Parser {
 public:
  explicit Parser(std::string_view tex) : tex_(tex) {}

  std::optional<Math> formula(MathMistake& mistake) {
    std::optional<Math> made;
    if (tex_.size() > most_bytes)
      fail(most_bytes, "a formula has at most " + std::to_string(most_bytes) + " bytes");
    else
      made = row("");
    if (made && made->parts.empty()) fail(0, "the formula is empty");
    if (failed_) mistake = mistake_;
    return failed_ ? std::nullopt : std::move(made);
  }

 private:
  struct Level {  // of nesting
    explicit Level(Parser& parser) : parser_(&parser) { ++parser_->level_; }
    ~Level() { --parser_->level_; }
    Level(const Level&) = delete;
    Parser* parser_;
  };

  std::nullopt_t fail(std::size_t at, std::string what) {
    if (!failed_) mistake_ = {at, std::move(what)};
    failed_ = true;
    return std::nullopt;
  }
  bool ends() const { return at_ >= tex_.size(); }
  void skip_blanks() {
    while (!ends() && (tex_[at_] == ' ' || tex_[at_] == '\n' || tex_[at_] == '\t' || tex_[at_] == '\r')) ++at_;
  }
  bool comes(std::string_view text) const { return tex_.substr(at_).starts_with(text); }
  // A command of letters ends where they end.
  bool comes_command(std::string_view command) const {
    return comes(command) && (at_ + command.size() >= tex_.size() || !is_letter(tex_[at_ + command.size()]));
  }

  // Up to `end`: "}", "]", "\right", or "" for the end of the formula, which is left standing.
  std::optional<Math> row(std::string_view end) {
    const Level level(*this);
    const std::size_t start = at_;
    if (level_ > most_levels) return fail(at_, "formulas go at most " + std::to_string(most_levels) + " levels deep");
    Math made;
    for (;;) {
      skip_blanks();
      if (ends()) {
        if (end.empty()) return made;
        if (end == "\\right") return fail(start, "\\left has no \\right behind it");
        return fail(start == 0 ? 0 : start - 1, end == "}" ? "a { has no } behind it" : "a [ has no ] behind it");
      }
      if (!end.empty() && (end == "\\right" ? comes_command(end) : comes(end))) return made;
      auto part = item();
      if (!part) return std::nullopt;
      made.parts.push_back(*std::move(part));
    }
  }

  // A thing with its scripts.
  std::optional<Math> item() {
    const char c = tex_[at_];
    if (c == '^' || c == '_')
      return fail(
          at_, std::string(1, c) + " needs something before it; write {} for nothing: {}" + std::string(1, c) + "{2}");
    auto base = is_digit(c) ? number() : atom();
    if (!base || c == '\'') return base;
    return scripts(*std::move(base));
  }

  std::optional<Math> scripts(Math base) {
    Math below, above;
    bool has_below = false, has_above = false;
    for (;;) {
      const std::size_t before = at_;
      skip_blanks();
      if (!ends() && tex_[at_] == '\'') {
        if (has_above) return fail(at_, "' stands before a superscript: x'^{2}");
        while (!ends() && tex_[at_] == '\'') above.parts.push_back(symbol("′", Class::variable, true)), ++at_;
        has_above = true;
        skip_blanks();
        if (!ends() && tex_[at_] == '^') {
          ++at_;
          auto more = argument();
          if (!more) return std::nullopt;
          if (more->kind == Kind::row)
            std::ranges::move(more->parts, std::back_inserter(above.parts));
          else
            above.parts.push_back(*std::move(more));
        }
        continue;
      }
      if (ends() || (tex_[at_] != '^' && tex_[at_] != '_')) {
        if (!has_below && !has_above) at_ = before;
        break;
      }
      const bool raised = tex_[at_] == '^';
      if (raised ? has_above : has_below)
        return fail(at_, raised ? "two superscripts at one thing; write x^{ab} or {x^{a}}^{b}"
                                : "two subscripts at one thing; write x_{ab} or {x_{a}}_{b}");
      ++at_;
      auto script = argument();
      if (!script) return std::nullopt;
      (raised ? above : below) = *std::move(script);
      (raised ? has_above : has_below) = true;
    }
    if (!has_below && !has_above) return base;
    return made_of(Kind::scripts, {std::move(base), std::move(below), collapsed(std::move(above))});
  }

  // What a command or a script takes: a group in braces, or one thing.
  std::optional<Math> argument() {
    const Level level(*this);
    if (level_ > most_levels) return fail(at_, "formulas go at most " + std::to_string(most_levels) + " levels deep");
    skip_blanks();
    if (ends()) return fail(at_, "something is missing at the end of the formula");
    const char c = tex_[at_];
    if (c == '^' || c == '_' || c == '}') return fail(at_, "something is missing before " + std::string(1, c));
    if (is_digit(c)) return symbol(std::string(1, tex_[at_++]), Class::number);
    return atom();
  }

  std::optional<Math> number() {
    const std::size_t start = at_;
    while (!ends() && (is_digit(tex_[at_]) || (tex_[at_] == '.' && at_ + 1 < tex_.size() && is_digit(tex_[at_ + 1]))))
      ++at_;
    return symbol(std::string(tex_.substr(start, at_ - start)), Class::number);
  }

  std::optional<Math> atom() {
    const char c = tex_[at_];
    if (is_letter(c)) return ++at_, symbol(std::string(1, c), Class::variable);
    if (c == '{') return group();
    if (c == '\\') return command();
    if (c == '}') return fail(at_, "a } has no { before it; a brace that is to be seen is \\}");
    if (c == '-') return ++at_, symbol("−", Class::operation);
    if (c == '\'') return ++at_, symbol("′", Class::variable, true);
    if (std::string_view("+=<>()[]|,;:.!/").find(c) != std::string_view::npos)
      return ++at_, symbol(std::string(1, c), class_of(c), class_of(c) == Class::variable);
    return unknown();
  }

  std::nullopt_t unknown() {
    const std::size_t length = std::max<std::size_t>(utf8_length(tex_, at_), 1);
    const std::string character(tex_.substr(at_, length));
    for (const MathSymbol& known : math_symbols())
      if (known.text == character) return fail(at_, character + " is written \\" + std::string(known.command));
    if (character == "−") return fail(at_, "a minus is written -");
    if (character == "*") return fail(at_, "* is written \\cdot or \\times");
    if (character == "\"") return fail(at_, "words in a formula are written \\text{...}");
    return fail(at_, excerpt(character) + " means nothing in a formula; words are written \\text{...}");
  }

  std::optional<Math> group() {
    ++at_;
    auto made = row("}");
    if (!made) return std::nullopt;
    ++at_;
    return collapsed(*std::move(made));
  }

  std::optional<Math> command() {
    const std::size_t start = at_++;
    std::size_t end = at_;
    while (end < tex_.size() && is_letter(tex_[end])) ++end;
    if (end == at_ && end < tex_.size()) end += std::max<std::size_t>(utf8_length(tex_, end), 1);
    const std::string name(tex_.substr(at_, end - at_));
    at_ = end;
    for (const MathSymbol& known : math_symbols())
      if (known.command == name) return symbol(std::string(known.text), known.of, known.upright);
    for (const MathAccent& accent : math_accents())
      if (accent.command == name) {
        auto made = with_arguments(Kind::accent, 1);
        if (made) made->text = accent.mark;
        return made;
      }
    if (name == "frac") return with_arguments(Kind::fraction, 2);
    if (name == "binom") return with_arguments(Kind::binomial, 2);
    if (name == "sqrt") return root();
    if (name == "text") return words(start);
    if (name == "mathbf" || name == "mathrm") return letters(start, name == "mathbf");
    if (name == "left") return fenced(start);
    if (name == "right") return fail(start, "\\right has no \\left before it");
    return unknown_command(start, name);
  }

  std::nullopt_t unknown_command(std::size_t start, const std::string& name) {
    if (name.empty()) return fail(start, "a formula does not end with a backslash");
    if (!is_letter(name[0])) return fail(start, "a backslash before " + excerpt(name) + " means nothing in a formula");
    std::vector<std::string> known{"frac", "binom", "sqrt", "text", "mathbf", "mathrm", "left", "right"};
    for (const MathSymbol& s : math_symbols()) known.emplace_back(s.command);
    for (const MathAccent& a : math_accents()) known.emplace_back(a.command);
    std::string what = "there is no command \\" + name + " in formulas here";
    if (name == "leq" || name == "geq" || name == "neq")
      what += "; write \\" + name.substr(0, 2);
    else if (name == "dfrac" || name == "tfrac")
      what += "; write \\frac";
    else if (name == "dots")
      what += "; write \\ldots";
    else if (name == "value" || name == "name")
      what = "\\" + name + "{...} needs a value's name in its braces, in what a lesson says at a step";
    else if (const auto near = did_you_mean(name, known))
      what += "; did you mean \\" + *near + "?";
    return fail(start, what);
  }

  std::optional<Math> with_arguments(Kind kind, int count) {
    Math made = made_of(kind, {});
    for (int i = 0; i < count; ++i) {
      auto part = argument();
      if (!part) return std::nullopt;
      made.parts.push_back(*std::move(part));
    }
    return made;
  }

  std::optional<Math> root() {
    skip_blanks();
    std::optional<Math> degree;
    if (!ends() && tex_[at_] == '[') {
      ++at_;
      degree = row("]");
      if (!degree) return std::nullopt;
      ++at_;
    }
    auto made = with_arguments(Kind::root, 1);
    if (made && degree) made->parts.push_back(collapsed(*std::move(degree)));
    return made;
  }

  // What stands between the braces behind a command, as it is.
  std::optional<std::string> verbatim(std::size_t start) {
    skip_blanks();
    if (ends() || tex_[at_] != '{')
      return fail(at_, "a { is missing behind " + std::string(tex_.substr(start, at_ - start)));
    const std::size_t end = tex_.find_first_of("{}\\", at_ + 1);
    if (end == std::string_view::npos) return fail(at_, "a { has no } behind it");
    if (tex_[end] != '}')
      return fail(end, std::string(1, tex_[end]) + " cannot stand in words; close them with } before it");
    std::string text(tex_.substr(at_ + 1, end - at_ - 1));
    for (std::size_t i = 0; i < text.size(); i += std::max<std::size_t>(utf8_length(text, i), 1))
      if (utf8_length(text, i) == 0 || static_cast<unsigned char>(text[i]) < ' ' || text[i] == '\x7F')
        return fail(at_ + 1 + i, "words hold letters and blanks, no control characters");
    at_ = end + 1;
    return text;
  }

  std::optional<Math> words(std::size_t start) {
    auto text = verbatim(start);
    if (!text) return std::nullopt;
    if (text->empty()) return fail(start, "\\text{} holds no words");
    return symbol(*std::move(text), Class::word, true);
  }

  std::optional<Math> letters(std::size_t start, bool bold) {
    auto text = verbatim(start);
    if (!text) return std::nullopt;
    if (text->empty() || !std::ranges::all_of(*text, [](char c) { return is_letter(c) || is_digit(c); }))
      return fail(start, std::string(bold ? "\\mathbf" : "\\mathrm") + "{...} takes letters and digits");
    Math made = symbol(*std::move(text), Class::variable, true);
    made.bold = bold;
    return made;
  }

  // ( ) [ ] | \{ \} or a dot for none.
  std::optional<char> fence(std::string_view before) {
    skip_blanks();
    if (comes("\\{") || comes("\\}")) return at_ += 2, tex_[at_ - 1];
    if (!ends() && std::string_view("()[]|.").find(tex_[at_]) != std::string_view::npos) {
      const char c = tex_[at_++];
      return c == '.' ? ' ' : c;
    }
    return fail(at_, "behind " + std::string(before) + " stands one of ( ) [ ] | \\{ \\} or . for none");
  }

  std::optional<Math> fenced(std::size_t start) {
    const auto left = fence("\\left");
    if (!left) return std::nullopt;
    auto inside = row("\\right");
    if (!inside) {
      if (mistake_.what.starts_with("\\left")) mistake_.at = start;
      return std::nullopt;
    }
    at_ += std::string_view("\\right").size();
    const auto right = fence("\\right");
    if (!right) return std::nullopt;
    Math made = made_of(Kind::fenced, {collapsed(*std::move(inside))});
    made.text = {*left, *right};
    return made;
  }

  std::string_view tex_;
  std::size_t at_ = 0;
  int level_ = 0;
  bool failed_ = false;
  MathMistake mistake_;
};

}  // namespace

std::optional<Math> parse_math(std::string_view tex, MathMistake& mistake) { return Parser(tex).formula(mistake); }

std::optional<std::size_t> end_of_math(std::string_view text, std::size_t at) {
  const std::size_t signs = text.substr(at).starts_with("$$") ? 2 : 1;
  for (std::size_t i = at + signs; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '\n' && text.find_first_not_of(" \t\r", i + 1) != std::string_view::npos &&
             text[text.find_first_not_of(" \t\r", i + 1)] == '\n')
      return std::nullopt;
    else if (text[i] == '$' && (signs == 1 || text.substr(i).starts_with("$$")))
      return i + signs;
  }
  return std::nullopt;
}

std::optional<std::size_t> end_of_code(std::string_view text, std::size_t at) {
  const std::size_t behind = std::min(text.find_first_not_of('`', at), text.size());
  const std::size_t ticks = behind - at;
  for (std::size_t i = text.find('`', behind); i != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_not_of('`', i), text.size());
    if (end - i == ticks) return end;
    i = text.find('`', end);
  }
  return std::nullopt;
}

}  // namespace blossom
