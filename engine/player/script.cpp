#include "player/script.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "base/exact.hpp"
#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_lines = 10'000, longest_line = 4096;

// ---- what words may be ----------------------------------------------------------------------------------------------

// What is wrong with a word; nothing if it is right.
using Wrong = std::optional<std::string>;

std::string meant(const std::optional<std::string>& near) {
  return near ? "; did you mean " + excerpt(*near) + "?" : std::string();
}

Wrong any(const std::string& word) { return word.empty() ? Wrong("must not be empty") : std::nullopt; }

template <int at_least, int at_most>
Wrong number(const std::string& word) {
  const auto value = Exact::parse(word);
  if (value && Exact(at_least) <= *value && *value <= Exact(at_most)) return std::nullopt;
  return "must be a number from " + std::to_string(at_least) + " to " + std::to_string(at_most) + ", not " +
         excerpt(word);
}

template <int at_least, int at_most>
Wrong whole_number(const std::string& word) {
  const auto value = Exact::parse(word);
  if (value && value->is_integer() && Exact(at_least) <= *value && *value <= Exact(at_most)) return std::nullopt;
  return "must be a whole number from " + std::to_string(at_least) + " to " + std::to_string(at_most) + ", not " +
         excerpt(word);
}

constexpr int far = 1'000'000'000;

// It becomes a file in the folder of the pictures, and nothing elsewhere.
Wrong file_name(const std::string& word) {
  const auto plain = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  if (!word.empty() && word.size() <= 100 && word.front() != '.' && std::ranges::all_of(word, plain))
    return std::nullopt;
  return "must be a file name of at most 100 letters, digits, -, _ and ., without its ending, not " + excerpt(word);
}

Wrong key(const std::string& word) {
  constexpr std::array<std::string_view, 3> modifiers{"Ctrl+", "Alt+", "Shift+"};
  std::string_view rest = word;
  for (bool found = true; found;) {
    found = false;
    for (const std::string_view modifier : modifiers) {
      if (!rest.starts_with(modifier) || rest.size() == modifier.size()) continue;
      rest.remove_prefix(modifier.size());
      found = true;
    }
  }
  if (!rest.empty() && utf8_length(rest, 0) == rest.size()) return std::nullopt;  // a character stands for itself
  const auto& names = script_keys();
  if (std::ranges::find(names, rest) != names.end()) return std::nullopt;
  std::vector<std::string> candidates = names;
  for (const std::string_view modifier : modifiers) candidates.emplace_back(modifier.substr(0, modifier.size() - 1));
  const auto plus = rest.find('+');
  const bool modified = plus != std::string_view::npos;
  return "no key is called " + excerpt(rest) + (modified ? "; before a key there may be Ctrl+, Alt+ and Shift+" : "") +
         meant(did_you_mean(modified ? rest.substr(0, plus) : rest, candidates));
}

Wrong one_of(const std::string& word, const std::vector<std::string>& choices) {
  if (std::ranges::find(choices, word) != choices.end()) return std::nullopt;
  std::string list;
  for (std::size_t i = 0; i < choices.size(); ++i)
    list += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
  return "must be " + list + ", not " + excerpt(word) + meant(did_you_mean(word, choices));
}

Wrong click_option(const std::string& word) { return one_of(word, {"right", "double", "shift", "ctrl"}); }
Wrong drag_option(const std::string& word) { return one_of(word, {"shift", "ctrl", "alt", "right", "middle"}); }
Wrong to(const std::string& word) { return one_of(word, {"to"}); }
Wrong by(const std::string& word) { return one_of(word, {"by"}); }

// ---- verbs ----------------------------------------------------------------------------------------------------------

struct Parameter {
  std::string_view what;  // as people read it
  Wrong (*wrong)(const std::string&) = any;
};

// What a verb takes. One that takes this or that stands here twice, and the second word decides.
struct Verb {
  std::string_view name;
  std::vector<Parameter> words;
  std::vector<Parameter> options = {};   // may be left out from the right
  std::optional<Parameter> any_of = {};  // may follow, each once
  std::string_view output = {};          // the ending of the file that the first word names

  std::string usage() const {
    std::string text(name);
    for (const Parameter& p : words) text += " " + std::string(p.what);
    for (const Parameter& p : options) text += " [" + std::string(p.what) + "]";
    if (any_of) text += " [" + std::string(any_of->what) + "]";
    return text;
  }
};

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all{
      {"size", {{"WIDTH", whole_number<100, 16384>}, {"HEIGHT", whole_number<100, 16384>}}, {{"SCALE", number<1, 4>}}},
      {"open", {{"FILE"}}},
      {"key", {{"KEY", key}}},
      {"type", {{"TEXT"}}},
      {"focus", {{"NAME"}}},
      {"move", {{"NAME"}}},
      {"click", {{"NAME"}}, {}, Parameter{"right|double|shift|ctrl", click_option}},
      {"drag", {{"NAME"}, {"to", to}, {"NAME"}}, {}, Parameter{"shift|ctrl|alt|right|middle", drag_option}},
      {"drag",
       {{"NAME"}, {"by", by}, {"RIGHT", number<-100'000, 100'000>}, {"DOWN", number<-100'000, 100'000>}},
       {},
       Parameter{"shift|ctrl|alt|right|middle", drag_option}},
      {"wheel", {{"NAME"}, {"NOTCHES", number<-1000, 1000>}}},
      {"drop", {{"FILE"}}},
      {"wait", {{"SECONDS", number<0, 600>}}},
      {"shot", {{"NAME", file_name}}, {}, {}, ".png"},
      {"state", {{"NAME", file_name}}, {}, {}, ".json"},
      {"things", {{"NAME", file_name}}, {}, {}, ".json"},
      {"expect", {{"KEY"}, {"VALUE", [](const std::string&) { return Wrong(); }}}},
      {"expect-near", {{"KEY"}, {"NUMBER", number<-far, far>}, {"TOLERANCE", number<0, far>}}},
      {"expect-thing", {{"NAME"}}},
      {"expect-no-thing", {{"NAME"}}},
      {"close", {}},
  };
  return all;
}

std::vector<std::string> verb_names() {
  std::vector<std::string> names;
  for (const Verb& verb : verbs())
    if (names.empty() || names.back() != verb.name) names.emplace_back(verb.name);
  return names;
}

// ---- reading --------------------------------------------------------------------------------------------------------

struct Word {
  std::string text;
  std::size_t at = 0;  // of the line, in bytes
};

class Parser {
 public:
  explicit Parser(const std::string& name) : name_(name) {}

  void line(std::string_view text) {
    ++number_;
    line_ = text.substr(0, longest_line);
    if (text.size() > longest_line) return error(0, "has more than 4096 bytes");
    const auto words = split();
    if (words && !words->empty()) instruct(*words);
  }
  void error(std::size_t at, std::string message) {
    diagnostics_.push_back(
        {name_, number_, static_cast<int>(utf8_count(line_.substr(0, at))) + 1, "", std::move(message)});
  }
  Checked<std::vector<Instruction>> result() && {
    if (!diagnostics_.empty()) return std::move(diagnostics_);
    if (instructions_.empty()) return Diagnostics{{name_, 0, 0, "", "says nothing to do"}};
    return std::move(instructions_);
  }

 private:
  std::optional<std::vector<Word>> split();
  std::optional<std::string> quoted(std::size_t& at);
  bool is_text();
  void instruct(const std::vector<Word>&);
  const Verb* verb_of(const std::vector<Word>&);
  bool check(const Verb&, const std::vector<Word>&);
  bool check_output(const Verb&, const Word& name);

  const std::string& name_;
  int number_ = 0;
  std::string_view line_;
  std::vector<Instruction> instructions_;
  Diagnostics diagnostics_;
  std::map<std::string, int> outputs_;  // and the lines they are made in
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

bool Parser::is_text() {
  for (std::size_t i = 0; i < line_.size();) {
    const std::size_t length = utf8_length(line_, i);
    if (length == 0 || (is_control(line_.substr(i, length)) && line_[i] != '\t')) {
      error(i, length == 0 ? "is no UTF-8" : "a control character does not belong here");
      return false;
    }
    i += length;
  }
  return true;
}

// From the opening quote to behind the closing one.
std::optional<std::string> Parser::quoted(std::size_t& at) {
  const std::size_t begin = at;
  std::string text;
  for (++at; at < line_.size(); ++at) {
    if (line_[at] == '"') {
      ++at;
      return text;
    }
    if (line_[at] == '\\') {
      const char next = at + 1 < line_.size() ? line_[at + 1] : ' ';
      if (next != '"' && next != '\\') {
        error(at, R"(in quotes there is \" for a quote and \\ for a backslash, nothing else)");
        return std::nullopt;
      }
      ++at;
    }
    text += line_[at];
  }
  error(begin, "this quote is not closed");
  return std::nullopt;
}

std::optional<std::vector<Word>> Parser::split() {
  if (!is_text()) return std::nullopt;
  std::vector<Word> words;
  for (std::size_t at = 0; at < line_.size();) {
    if (is_blank(line_[at])) {
      ++at;
      continue;
    }
    if (line_[at] == '#') break;
    const std::size_t begin = at;
    if (line_[at] == '"') {
      auto text = quoted(at);
      if (!text) return std::nullopt;
      if (at < line_.size() && !is_blank(line_[at])) {
        error(at, "a blank must stand between words");
        return std::nullopt;
      }
      words.push_back({std::move(*text), begin});
      continue;
    }
    while (at < line_.size() && !is_blank(line_[at])) ++at;
    const std::string_view word = line_.substr(begin, at - begin);
    if (const std::size_t quote = word.find('"'); quote != std::string_view::npos) {
      error(begin + quote, R"(a quote stands around a whole word: "the \"name\"")");
      return std::nullopt;
    }
    words.push_back({std::string(word), begin});
  }
  return words;
}

// Of two verbs with one name, the one whose second word this is.
const Verb* Parser::verb_of(const std::vector<Word>& words) {
  const Verb* found = nullptr;
  std::vector<std::string> seconds;
  for (const Verb& verb : verbs()) {
    if (verb.name != words[0].text) continue;
    found = &verb;
    if (verb.words.size() < 2) return found;
    if (words.size() > 2 && words[2].text == verb.words[1].what) return found;
    seconds.emplace_back(verb.words[1].what);
  }
  if (found == nullptr) {
    const auto near = did_you_mean(words[0].text, verb_names());
    std::string list;
    for (const std::string& name : verb_names()) list += (list.empty() ? "" : ", ") + name;
    error(words[0].at, "unknown instruction " + excerpt(words[0].text) + (near ? meant(near) : "; there are " + list));
  } else if (seconds.size() > 1) {
    if (words.size() > 2)
      error(words[2].at, *one_of(words[2].text, seconds));
    else
      error(line_.size(), std::string(found->name) + " NAME to|by ...: something is missing");
    return nullptr;
  }
  return found;
}

bool Parser::check(const Verb& verb, const std::vector<Word>& words) {
  const std::size_t before = diagnostics_.size();
  const std::size_t fixed = verb.words.size(), most = fixed + verb.options.size();
  if (words.size() - 1 < fixed) {
    error(line_.size(), verb.usage() + ": " + std::string(verb.words[words.size() - 1].what) + " is missing");
    return false;
  }
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const Word& word = words[i + 1];
    if (i >= most && !verb.any_of) {
      error(word.at,
            verb.usage() + ": " + excerpt(word.text) + " is too much; words with blanks stand in double quotes");
      return false;
    }
    const Parameter& parameter = i < fixed ? verb.words[i] : i < most ? verb.options[i - fixed] : *verb.any_of;
    if (auto wrong = parameter.wrong(word.text)) error(word.at, std::move(*wrong));
    for (std::size_t j = most; j < i; ++j)
      if (words[j + 1].text == word.text) error(word.at, excerpt(word.text) + " is said twice");
  }
  return diagnostics_.size() == before;
}

bool Parser::check_output(const Verb& verb, const Word& name) {
  const auto [other, is_new] = outputs_.emplace(name.text + std::string(verb.output), number_);
  if (!is_new) error(name.at, other->first + " is written in line " + std::to_string(other->second) + " already");
  return is_new;
}

void Parser::instruct(const std::vector<Word>& words) {
  const Verb* verb = verb_of(words);
  if (verb == nullptr || !check(*verb, words)) return;
  if (!verb->output.empty() && !check_output(*verb, words[1])) return;
  Instruction made{number_, words[0].text, {}};
  for (std::size_t i = 1; i < words.size(); ++i) made.words.push_back(words[i].text);
  instructions_.push_back(std::move(made));
}

}  // namespace

const std::vector<std::string>& script_keys() {
  static const std::vector<std::string> names{
      "Left",   "Right",  "Up",        "Down",  "Home",        "End",    "PageUp", "PageDown", "Tab", "Space",
      "Insert", "Delete", "Backspace", "Enter", "KeypadEnter", "Escape", "F1",     "F2",       "F3",  "F4",
      "F5",     "F6",     "F7",        "F8",    "F9",          "F10",    "F11",    "F12"};
  return names;
}

Checked<std::vector<Instruction>> parse_script(const std::string& name, std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Parser parser(name);
  for (std::size_t count = 0; !text.empty(); ++count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (count == most_lines)
      return Diagnostics{{name, static_cast<int>(count) + 1, 0, "", "has more than 10,000 lines; nobody does so much"}};
    parser.line(line);
  }
  return std::move(parser).result();
}

}  // namespace blossom
