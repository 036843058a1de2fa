#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/json.hpp"
#include "base/utf8.hpp"

namespace blossom {
namespace {

// What stands there, for "..., not X".
std::string describe(const Json& json) {
  switch (json.kind) {
    case Json::Kind::null:
      return "null";
    case Json::Kind::boolean:
      return json.boolean ? "true" : "false";
    case Json::Kind::number:
      return json.text.size() <= 40 ? json.text : json.text.substr(0, 40) + "...";
    case Json::Kind::string:
      return excerpt(json.text);
    case Json::Kind::array:
      return "an array";
    case Json::Kind::object:
      return "an object";
  }
  return {};
}

std::string path_to_key(const std::string& path, std::string_view key) {
  const auto is_plain = [](char c) {
    return c == '_' || c == '-' || ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
  };
  bool plain = !key.empty() && key.size() <= 40;
  for (const char c : key) plain = plain && is_plain(c);
  if (!plain) return path + "[" + excerpt(key) + "]";
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string list_of(const std::vector<std::string>& keys) {
  std::string list;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == keys.size() ? " and " : ", ") + excerpt(keys[i]);
  }
  return list;
}

std::string whole_number_in(int at_least, int at_most) {
  constexpr int lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();
  if (at_least == lowest && at_most == highest) return "must be a whole number";
  if (at_most == highest) return "must be a whole number, at least " + std::to_string(at_least);
  if (at_least == lowest) return "must be a whole number, at most " + std::to_string(at_most);
  if (at_least == at_most) return "must be the number " + std::to_string(at_least);
  return "must be a whole number from " + std::to_string(at_least) + " to " + std::to_string(at_most);
}

std::string items(std::size_t count) { return std::to_string(count) + (count == 1 ? " item" : " items"); }

void add(Diagnostics& diagnostics, const JsonDocument& document, std::uint32_t token, std::string path,
         std::string message) {
  if (diagnostics.size() > most_diagnostics) return;
  if (diagnostics.size() == most_diagnostics) message = "more than 10,000 mistakes; the others are not listed";
  const auto [line, column] = document.line_and_column(token);
  diagnostics.push_back({document.name(), line, column, std::move(path), std::move(message)});
}

}  // namespace

Cursor::Cursor(const JsonDocument& document, Diagnostics& diagnostics)
    : document_(&document), diagnostics_(&diagnostics), json_(&document.root()) {}

void Cursor::error(std::string message) const {
  add(*diagnostics_, *document_, json_->token, path_, std::move(message));
}

bool Cursor::expect_object(const std::vector<std::string>& known) const {
  if (!is(Json::Kind::object)) {
    error("must be an object" + (known.empty() ? "" : " with keys among " + list_of(known)) + ", not " +
          describe(*json_));
    return false;
  }
  for (std::size_t i = 0; i < json_->keys.size(); ++i) {
    const std::string& key = json_->keys[i];
    if (key == "$comment" || std::find(known.begin(), known.end(), key) != known.end()) continue;
    const auto near = did_you_mean(key, known);
    key_error(i, "unknown key " + excerpt(key) +
                     (near ? "; did you mean " + excerpt(*near) + "?" : "; the keys here are " + list_of(known)));
  }
  return true;
}

std::optional<Cursor> Cursor::optional(std::string_view key) const {
  const Json* json = json_->find(key);
  if (!json) return std::nullopt;
  return Cursor(document_, diagnostics_, json, path_to_key(path_, key));
}

std::optional<Cursor> Cursor::required(std::string_view key) const {
  auto found = optional(key);
  if (!found) error("missing key " + excerpt(key));
  return found;
}

Cursor Cursor::member(std::size_t index) const {
  assert(is(Json::Kind::object) && index < json_->items.size());
  return Cursor(document_, diagnostics_, &json_->items[index], path_to_key(path_, json_->keys[index]));
}

void Cursor::key_error(std::size_t index, std::string message) const {
  assert(index < json_->keys.size());
  add(*diagnostics_, *document_, json_->key_tokens[index], path_, std::move(message));
}

bool Cursor::expect_array(std::size_t at_least, std::size_t at_most) const {
  if (!is(Json::Kind::array)) {
    error("must be an array, not " + describe(*json_));
    return false;
  }
  if (at_least <= size() && size() <= at_most) return true;
  if (at_least == at_most) {
    error("must have " + items(at_least) + ", not " + std::to_string(size()));
  } else if (size() < at_least) {
    error("must have at least " + items(at_least) + ", not " + std::to_string(size()));
  } else {
    error("must have at most " + items(at_most) + ", not " + std::to_string(size()));
  }
  return false;
}

Cursor Cursor::operator[](std::size_t index) const {
  assert(is(Json::Kind::array) && index < size());
  return Cursor(document_, diagnostics_, &json_->items[index], path_ + "[" + std::to_string(index) + "]");
}

std::optional<Exact> Cursor::number() const {
  if (!is(Json::Kind::number) && !is(Json::Kind::string)) {
    error("must be a number or an exact string such as \"2/5\", not " + describe(*json_));
    return std::nullopt;
  }
  const auto number = Exact::parse(json_->text);
  if (!number && (is(Json::Kind::number) || json_->text.size() > 400)) {
    error("must be a number of at most 400 characters with an exponent from -400 to 400, not " + describe(*json_));
    return std::nullopt;
  }
  if (!number) {
    error("must be a number or an exact string such as \"2/5\", not " + describe(*json_));
    return std::nullopt;
  }
  // Decimals with hundreds of digits are fractions of twice as many, which nobody could read back.
  if (json_->text.size() > 150 && number->to_string().size() > 400) {
    error("has too many digits: as a fraction it must have at most 400, not " + describe(*json_));
    return std::nullopt;
  }
  if (!std::isfinite(number->to_double())) {
    error("too large; at most about 1.8e308, not " + describe(*json_));
    return std::nullopt;
  }
  return number;
}

std::optional<int> Cursor::integer(int at_least, int at_most) const {
  const bool quoted = is(Json::Kind::string);
  if (const auto number = quoted || is(Json::Kind::number) ? Exact::parse(json_->text) : std::nullopt;
      number && number->is_integer() && Exact(at_least) <= *number && *number <= Exact(at_most)) {
    if (!quoted) return static_cast<int>(number->to_double());
    error("is a count, and stands without quotation marks: " + number->to_string());
    return std::nullopt;
  }
  error(whole_number_in(at_least, at_most) + ", not " + describe(*json_));
  return std::nullopt;
}

std::optional<std::string> Cursor::string() const {
  if (!is(Json::Kind::string)) {
    error("must be a string, not " + describe(*json_));
    return std::nullopt;
  }
  const std::string& text = json_->text;
  for (std::size_t i = 0; i < text.size();) {  // the reader has made sure that it is UTF-8
    const std::string_view character = std::string_view(text).substr(i, utf8_length(text, i));
    if (is_control(character) && character != "\n" && character != "\t") {
      error("must not contain control characters: they act on a terminal or on the direction of the text");
      return std::nullopt;
    }
    i += character.size();
  }
  return text;
}

std::optional<bool> Cursor::boolean() const {
  if (is(Json::Kind::boolean)) return json_->boolean;
  error("must be true or false, not " + describe(*json_));
  return std::nullopt;
}

}  // namespace blossom
