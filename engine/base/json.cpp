#include "base/json.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Walks over a text and knows the line and column (in characters) it has come to.
class Place {
 public:
  explicit Place(std::string_view text) : text_(text), at_(text.starts_with(byte_order_mark) ? 3 : 0) {}

  std::pair<int, int> advance_to(std::size_t offset) {
    for (; at_ < offset && at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        column_ = 1;
      } else if ((static_cast<unsigned char>(text_[at_]) & 0xC0) != 0x80) {  // the first byte of a character
        ++column_;
      }
    }
    return {line_, column_};
  }

 private:
  std::string_view text_;
  std::size_t at_;
  int line_ = 1;
  int column_ = 1;
};

// Calls found(byte offset) for each key and value, in the order of the file, as long as it returns true. The text is
// valid JSON at least up to the last token asked for, so that a token is told by its first character.
template <class Found>
void for_each_token(std::string_view text, Found&& found) {
  for (std::size_t i = text.starts_with(byte_order_mark) ? 3 : 0; i < text.size();) {
    const char c = text[i];
    if (std::string_view(" \t\r\n,:]}").find(c) != std::string_view::npos) {
      ++i;
      continue;
    }
    if (!found(i)) return;
    ++i;
    if (c == '"') {
      while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
      ++i;
    } else if (c != '{' && c != '[') {
      i = std::min(text.find_first_of(" \t\r\n,:]}", i), text.size());
    }
  }
}

std::size_t offset_of(std::string_view text, std::uint32_t token) {
  std::size_t offset = text.size();
  for_each_token(text, [&](std::size_t i) {
    offset = i;
    return token-- != 0;
  });
  return offset;
}

// A mistake in the syntax, as nlohmann tells it: "[json.exception.parse_error.101] parse error at line 1, column 4:
// syntax error while parsing array - unexpected ']'; expected '[', '{', or a literal". `bytes_read` is how far it has
// read, and `last_read` ends with the text it stumbled over.
class SyntaxError {
 public:
  SyntaxError(std::string_view text, std::size_t bytes_read, std::string_view last_read, std::string_view what)
      : text_(text), said_(what.substr(0, what.find("; last read: "))) {
    if (const std::size_t expected = what.rfind("; expected "); expected != std::string_view::npos) {
      wanted_ = what.substr(expected + 11);
    }
    const std::size_t end = std::min(bytes_read, text.size()), last = std::min(bytes_read - 1, text.size());
    if (says("unexpected end of input")) {
      at_ = text.size();
    } else if (says("unexpected '")) {  // one of [ ] { } , :
      at_ = last;
    } else if (says("invalid literal")) {
      for (at_ = last; at_ > 0 && 'a' <= text[at_ - 1] && text[at_ - 1] <= 'z';) --at_;
    } else if (says("surrogate") || says("'\\u' must be")) {
      at_ = text.rfind("\\u", last);
    } else if (says("ill-formed UTF-8")) {  // the parser may have read on to the byte after it
      while (const std::size_t length = utf8_length(text, at_)) at_ += length;
    } else if (says("invalid string") && !says("missing closing quote")) {
      at_ = last;
    } else {
      at_ = end - std::min(last_read.size(), end);
    }
  }

  std::size_t offset() const { return at_; }

  // What is wrong, and what would be right.
  std::string message() const {
    if (says("number overflow")) return "the number " + word() + " is too large; at most about 1.8e308";
    if (says("invalid number")) return word() + " is not a number; digits must follow each sign, point and exponent";
    if (says("invalid string")) return message_in_string();
    if (says("invalid BOM")) return "an incomplete byte order mark; the file must be saved as UTF-8";
    if (says("unexpected end of input")) return "the document ends too early; expected " + wanted();
    if (says("invalid literal")) {
      const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
      if (here() == '/' && (next == '/' || next == '*')) return "comments are not allowed in JSON";
      if (here() == '/') return "a fraction is written as a string, such as \"2/5\"";
      if (here() == '\'') return "text stands in double quotes, such as \"text\"";
      if (here() == '.' || here() == '+') return "a number starts with a digit or a minus sign, such as 0.5";
    }
    const bool closes = (here() == ']' && wanted_.starts_with("'['")) || (here() == '}' && wanted_ == "string literal");
    const std::size_t before = at_ == 0 ? std::string_view::npos : text_.find_last_not_of(" \t\r\n", at_ - 1);
    const bool after_comma = closes && before != std::string_view::npos && text_[before] == ',';
    return "unexpected " + word() + (after_comma ? " after a comma" : "") + "; expected " + wanted();
  }

 private:
  bool says(std::string_view phrase) const { return said_.find(phrase) != std::string_view::npos; }
  char here() const { return at_ < text_.size() ? text_[at_] : ' '; }

  std::string message_in_string() const {
    if (says("ill-formed UTF-8")) return "invalid UTF-8; the file must be saved as UTF-8";
    if (says("missing closing quote")) return "a string without an end; close it with \"";
    if (says("surrogate")) return "half a surrogate pair; \\uD800..\\uDBFF must be followed by \\uDC00..\\uDFFF";
    if (says("'\\u' must be")) return "\\u must be followed by 4 hexadecimal digits";
    if (says("backslash")) return "an unknown escape; a backslash itself is written \\\\";
    if (here() == '\n' || here() == '\r') return "a line break inside a string; close the string with \", or write \\n";
    return "a control character inside a string; a tab is written \\t, others \\u00XX";
  }

  // The offending word, in quotation marks.
  std::string word() const {
    constexpr std::string_view delimiters = " \t\r\n,:[]{}\"";
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with('"')) return excerpt(rest.substr(1, rest.find('"', 1) - 1));
    return excerpt(rest.substr(0, std::max<std::size_t>(rest.find_first_of(delimiters), 1)));
  }

  std::string wanted() const {
    if (wanted_ == "string literal") return "a key in double quotes";
    if (wanted_ == "'}'") return "',' or '}'";
    if (wanted_ == "']'") return "',' or ']'";
    if (wanted_ == "':'") return "':'";
    if (wanted_ == "end of input") return "the end of the document";
    return "a value: a number, a \"string\", [...], {...}, true, false or null";
  }

  std::string_view text_;
  std::string_view said_;    // without what was read
  std::string_view wanted_;  // nlohmann's name of it
  std::size_t at_ = 0;       // where the offending text begins
};

// Builds the tree from nlohmann's events. false from an event stops the parser at once.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, Json& root, const JsonLimits& limits)
      : text_(text), root_(root), limits_(limits) {}

  const std::string& problem() const { return problem_; }
  std::size_t problem_offset() const { return problem_offset_; }

  bool null() { return add(Json::Kind::null) != nullptr; }
  bool boolean(bool value) {
    Json* json = add(Json::Kind::boolean);
    if (json) json->boolean = value;
    return json != nullptr;
  }
  // Only "-0" is a signed zero; other integers have one spelling in JSON.
  bool number_integer(std::int64_t value) { return add_number(value == 0 ? "-0" : std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return add_number(std::to_string(value)); }
  bool number_float(double, std::string text) {
    // nlohmann puts the locale's decimal point in.
    const auto foreign = [](char c) { return std::string_view("0123456789+-eE").find(c) == std::string_view::npos; };
    std::replace_if(text.begin(), text.end(), foreign, '.');
    return add_number(std::move(text));
  }
  bool string(std::string& value) {
    Json* json = add(Json::Kind::string);
    if (json) json->text = std::move(value);
    return json != nullptr;
  }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // not in JSON text

  bool start_array(std::size_t) { return open(Json::Kind::array); }
  bool start_object(std::size_t) { return open(Json::Kind::object); }
  bool end_array() {
    open_.pop_back();
    return true;
  }
  bool end_object() {
    const Json& object = *open_.back();
    open_.pop_back();
    return keys_differ(object);
  }
  bool key(std::string& value) {
    open_.back()->keys.push_back(std::move(value));
    open_.back()->key_tokens.push_back(tokens_++);
    return true;
  }

  bool parse_error(std::size_t bytes_read, const std::string& last_read, const nlohmann::json::exception& exception) {
    const SyntaxError error(text_, bytes_read, last_read, exception.what());
    return fail(error.offset(), error.message());
  }

 private:
  bool fail(std::size_t offset, std::string problem) {
    problem_ = std::move(problem);
    problem_offset_ = offset;
    return false;
  }

  Json* add(Json::Kind kind) {
    if (++values_ > limits_.values) {
      fail(offset_of(text_, tokens_), "too many values; at most " + std::to_string(limits_.values));
      return nullptr;
    }
    Json* json = open_.empty() ? &root_ : &open_.back()->items.emplace_back();
    json->kind = kind;
    json->token = tokens_++;
    return json;
  }

  bool add_number(std::string text) {
    Json* json = add(Json::Kind::number);
    if (json) json->text = std::move(text);
    return json != nullptr;
  }

  bool open(Json::Kind kind) {
    if (static_cast<int>(open_.size()) >= limits_.depth) {
      return fail(offset_of(text_, tokens_), "nested too deep; at most " + std::to_string(limits_.depth) + " levels");
    }
    Json* json = add(kind);
    open_.push_back(json);  // stays where it is: its neighbours come only after it is closed
    return json != nullptr;
  }

  bool keys_differ(const Json& object) {
    const std::vector<std::string>& keys = object.keys;
    std::size_t repeated = keys.size();  // the first key that stood before
    if (keys.size() <= 16) {
      for (auto key = keys.end(); key != keys.begin();) {
        --key;
        if (std::find(keys.begin(), key, *key) != key) repeated = static_cast<std::size_t>(key - keys.begin());
      }
    } else {  // the number of comparisons must not grow with the square of what a hostile file holds
      std::vector<std::size_t> order(keys.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
      for (std::size_t i = 1; i < order.size(); ++i) {
        if (keys[order[i - 1]] == keys[order[i]]) repeated = std::min(repeated, order[i]);
      }
    }
    if (repeated == keys.size()) return true;
    return fail(offset_of(text_, object.key_tokens[repeated]),
                "duplicate key " + excerpt(keys[repeated]) + "; each key may stand once in an object");
  }

  std::string_view text_;
  Json& root_;
  const JsonLimits& limits_;
  std::vector<Json*> open_;
  std::uint32_t tokens_ = 0;
  std::size_t values_ = 0;
  std::string problem_;
  std::size_t problem_offset_ = 0;
};

}  // namespace

const Json* Json::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

Checked<JsonDocument> JsonDocument::parse(std::string name, std::string text, const JsonLimits& limits) {
  const auto refuse = [&](std::size_t offset, std::string message) {
    const auto [line, column] = Place(text).advance_to(offset);
    return Diagnostics{{std::move(name), line, column, "", std::move(message)}};
  };
  // What is handed in by mistake is told by its first bytes, before it is found to be large or to have a NUL byte.
  for (const auto& [begins, what] :
       {std::pair("PK\x03\x04", "a zip archive or an office document (Word, ...)"), std::pair("%PDF", "a PDF document"),
        std::pair("\xD0\xCF\x11\xE0", "an old office document")})
    if (text.starts_with(begins))
      return Diagnostics{{std::move(name), 0, 0, "", std::string("is ") + what + ", not JSON, which is plain text"}};
  const std::size_t most = std::min<std::size_t>(limits.bytes, std::numeric_limits<std::uint32_t>::max());
  if (text.size() > most) {
    return Diagnostics{{std::move(name), 0, 0, "", "too large; at most " + std::to_string(most) + " bytes"}};
  }
  // nlohmann takes a NUL for the end of the text and would not look at what follows.
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) {
    return refuse(nul, "a NUL byte; JSON is text, saved as UTF-8");
  }

  JsonDocument document;
  TreeBuilder builder(text, document.root_, limits);
  if (!nlohmann::json::sax_parse(text.data(), text.data() + text.size(), &builder)) {
    const bool blank =
        text.find_first_not_of(" \t\r\n", text.starts_with(byte_order_mark) ? 3 : 0) == std::string::npos;
    return refuse(builder.problem_offset(), blank ? "the document is empty; expected a value" : builder.problem());
  }
  document.name_ = std::move(name);
  document.text_ = std::move(text);
  return document;
}

std::pair<int, int> JsonDocument::line_and_column(std::uint32_t token) const {
  if (!places_) {
    std::vector<std::pair<int, int>> places;
    Place place(text_);
    for_each_token(text_, [&](std::size_t offset) {
      places.push_back(place.advance_to(offset));
      return true;
    });
    places_ = std::make_shared<const std::vector<std::pair<int, int>>>(std::move(places));
  }
  return token < places_->size() ? (*places_)[token] : std::pair(0, 0);
}

}  // namespace blossom
