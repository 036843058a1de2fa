#include "base/json_write.hpp"

#include <algorithm>

namespace blossom {
namespace {

constexpr std::size_t line_length = 100;
constexpr std::size_t most_digits = 15;  // of a number that other programs, too, read without loss

// Its decimal, if it has a short one.
std::optional<std::string> decimal(const Exact& x) {
  if (x.is_approximate()) return x.to_string();
  Exact scaled = abs(x);
  std::size_t decimals = 0;
  for (; !scaled.is_integer() && decimals < most_digits; ++decimals) scaled *= Exact(10);
  if (!scaled.is_integer()) return std::nullopt;
  std::string digits = scaled.to_string();
  if (digits.size() > most_digits) return std::nullopt;
  if (decimals > 0) {
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, ".");
  }
  return (x < Exact(0) ? "-" : "") + digits;
}

bool is_container(const Json& json) { return json.kind == Json::Kind::array || json.kind == Json::Kind::object; }

bool holds_objects(const Json& json) {
  return std::any_of(json.items.begin(), json.items.end(),
                     [](const Json& item) { return item.kind == Json::Kind::object; });
}

// Whether it must not stand on one line, however short it is.
bool must_break(const Json& json) {
  return holds_objects(json) || std::any_of(json.items.begin(), json.items.end(), must_break);
}

class Writer {
 public:
  std::string text;

  void write(const Json& json, std::size_t indent) {
    if (!is_container(json)) return write_scalar(json);
    if (!must_break(json)) {
      const std::size_t before = text.size();
      write_on_one_line(json);
      if (column() <= line_length || json.items.empty()) return;
      text.resize(before);
      if (json.kind == Json::Kind::array) return fill(json, indent);
    }
    text += open(json);
    for (std::size_t i = 0; i < json.items.size(); ++i) {
      text += i > 0 ? "," : "";
      new_line(indent + 2);
      write_key(json, i);
      write(json.items[i], indent + 2);
    }
    new_line(indent);
    text += close(json);
  }

 private:
  static char open(const Json& json) { return json.kind == Json::Kind::array ? '[' : '{'; }
  static char close(const Json& json) { return json.kind == Json::Kind::array ? ']' : '}'; }

  std::size_t column() const { return text.size() - (text.rfind('\n') + 1); }  // npos + 1 is 0

  void new_line(std::size_t indent) {
    text += '\n';
    text.append(indent, ' ');
  }

  void write_key(const Json& json, std::size_t i) {
    if (json.kind == Json::Kind::object) text += json_quote(json.keys[i]) + ": ";
  }

  void write_scalar(const Json& json) {
    switch (json.kind) {
      case Json::Kind::boolean:
        text += json.boolean ? "true" : "false";
        break;
      case Json::Kind::number:
        text += json.text;
        break;
      case Json::Kind::string:
        text += json_quote(json.text);
        break;
      default:
        text += "null";
    }
  }

  void write_on_one_line(const Json& json) {
    if (!is_container(json)) return write_scalar(json);
    text += open(json);
    for (std::size_t i = 0; i < json.items.size(); ++i) {
      text += i > 0 ? ", " : "";
      write_key(json, i);
      write_on_one_line(json.items[i]);
    }
    text += close(json);
  }

  // As many items on each line as it takes.
  void fill(const Json& array, std::size_t indent) {
    text += '[';
    for (std::size_t i = 0; i < array.items.size(); ++i) {
      text += i > 0 ? "," : "";
      const std::size_t before = text.size();
      const bool first = i == 0;
      if (first)
        new_line(indent + 2);
      else
        text += ' ';
      write_on_one_line(array.items[i]);
      if (first || column() < line_length) continue;
      text.resize(before);
      new_line(indent + 2);
      write_on_one_line(array.items[i]);
    }
    new_line(indent);
    text += ']';
  }
};

}  // namespace

Json json_string(std::string_view text) {
  Json json;
  json.kind = Json::Kind::string;
  json.text = text;
  return json;
}

Json json_number(std::string text) {
  Json json;
  json.kind = Json::Kind::number;
  json.text = std::move(text);
  return json;
}

Json json_number(const Exact& x) {
  auto text = decimal(x);
  return text ? json_number(*std::move(text)) : json_string(x.to_string());
}

Json json_array(std::vector<Json> items) {
  Json json;
  json.kind = Json::Kind::array;
  json.items = std::move(items);
  return json;
}

Json json_object(std::vector<std::pair<std::string, Json>> members) {
  Json json;
  json.kind = Json::Kind::object;
  for (auto& [key, value] : members) {
    json.keys.push_back(std::move(key));
    json.items.push_back(std::move(value));
  }
  return json;
}

std::string write_json(const Json& json, int indent) {
  Writer writer;
  writer.write(json, static_cast<std::size_t>(indent));
  return std::move(writer.text);
}

}  // namespace blossom
