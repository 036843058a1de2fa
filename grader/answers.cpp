#include "grader/answers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "grader/lesson_grader.hpp"
#include "lesson/file_kind.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_notes = 10;

const std::string* string_at(const Json& object, std::string_view key) {
  const Json* found = object.find(key);
  return found != nullptr && found->kind == Json::Kind::string ? &found->text : nullptr;
}

bool is_number(const Json& json) { return json.kind == Json::Kind::number || json.kind == Json::Kind::string; }

// A vector such as a derivative has the weight 0, which need not be said.
bool leaves_out_weight(const Part& part, std::size_t count) {
  return part.kind == ValueKind::vector && part.form == Form::homogeneous && count + 1 == part.right.size() &&
         part.right.back() == Exact(0);
}

// The array of a part that takes one, whether or not it says that it is a set.
const Json* array_of(const Part& part, const Json& json) {
  if (json.kind == Json::Kind::array) return &json;
  if (!part.as_set || json.kind != Json::Kind::object || json.keys.size() != 1) return nullptr;
  const Json* set = json.find("set");
  return set != nullptr && set->kind == Json::Kind::array ? set : nullptr;
}

std::string expected_shape(const Part& part) {
  if (part.kind == ValueKind::integer) return "must be a whole number such as 3";
  if (part.is_single()) return "must be a number such as 0.4 or \"2/5\"";
  if (part.as_set) return "must be a set of numbers such as {\"set\": [0, \"1/2\", 1]}";
  if (part.kind == ValueKind::list) return "must be an array of numbers such as [0, \"1/2\", 1]";
  const std::string example = part.size() == 2   ? "[1, \"2/5\"]"
                              : part.size() == 3 ? "[1, \"2/5\", 0]"
                                                 : "[1, \"2/5\", 0, 1]";
  return "must be an array of " + std::to_string(part.size()) + " numbers such as " + example +
         (part.form == Form::homogeneous ? ", the weight last" : "");
}

std::string kind_of(const Json& json) {
  switch (json.kind) {
    case Json::Kind::null:
      return "null";
    case Json::Kind::boolean:
      return json.boolean ? "true" : "false";
    case Json::Kind::number:
      return "the number " + (json.text.size() <= 40 ? json.text : json.text.substr(0, 40) + "...");
    case Json::Kind::string:
      return "the text " + excerpt(json.text);
    case Json::Kind::array:
      return "an array of " + std::to_string(json.items.size());
    case Json::Kind::object:
      return "an object";
  }
  return {};
}

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The one asked value that the name has the letters of, ignoring their case; nothing where it is another value's name.
std::optional<std::size_t> in_other_case(const Exercise& exercise, const std::string& name) {
  if (exercise.run.trace.find(name)) return std::nullopt;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < exercise.parts.size(); ++i) {
    if (!std::ranges::equal(exercise.parts[i].name, name, {}, lower, lower)) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

// Why a text is no number, with what is right instead.
std::string no_number(const std::string& text) {
  constexpr std::size_t longest = 400;  // of Exact::parse
  const std::string typed = "contains the text " + excerpt(text) + ", ";
  if (text.size() > longest) return typed + "which is longer than a number may be: 400 characters";
  std::string tidy = text;
  std::erase_if(tidy, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  const bool blank = tidy != text;
  const std::size_t comma = tidy.find(',');
  if (comma != std::string::npos) tidy[comma] = '.';
  if (!parse_typed(tidy)) return typed + "which is no number such as 0.4 or \"2/5\"";
  return typed + "which has a " + (comma != std::string::npos ? "comma for its decimal point" : "blank in it") +
         (comma != std::string::npos && blank ? " and a blank in it" : "") + ": write " + excerpt(tidy);
}

std::string not_asked(const Exercise& exercise, const std::string& name) {
  if (const auto value = exercise.run.trace.find(name); value && exercise.run.trace.is_input(*value))
    return excerpt(name) + " is given and was ignored";
  const auto near = nearest_asked(exercise, name);
  return excerpt(name) + " is not asked and was ignored" + (near ? "; did you mean " + excerpt(*near) + "?" : "");
}

// The digits of all indices of a name, without leading zeros: "12" of "P[1][2]", "P[1,02]" and "p12".
std::string index_digits(std::string_view name) {
  std::string digits;
  bool leading = true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto is_digit = [&](std::size_t at) { return at < name.size() && '0' <= name[at] && name[at] <= '9'; };
    if (!is_digit(i)) {
      leading = true;
    } else if (!leading || name[i] != '0' || !is_digit(i + 1)) {
      digits += name[i];
      leading = false;
    }
  }
  return digits;
}

}  // namespace

std::optional<std::string> nearest_asked(const Exercise& exercise, const std::string& name) {
  if (exercise.run.trace.find(name)) return std::nullopt;
  std::vector<std::string> names;
  for (const Part& part : exercise.parts)
    if (index_digits(part.name) == index_digits(name)) names.push_back(part.name);
  return did_you_mean(name, names);
}

Answers match_answers(const Exercise& exercise, const Checked<JsonDocument>& document) {
  if (document) return match_answers(exercise, document->root());
  Answers answers;
  answers.reason = "cannot be read";
  if (!document.diagnostics.empty()) {
    Diagnostic first = document.diagnostics.front();
    first.file.clear();  // the author knows it, and it is a path of another machine
    answers.reason = to_string(first);
  }
  return answers;
}

Answers match_answers(const Exercise& exercise, const Json& root) {
  Answers answers;
  const auto invalid = [&](std::string reason) {
    answers.reason = std::move(reason);
    return answers;
  };
  const FileKind kind = file_kind(root);
  if (kind != FileKind::answers && kind != FileKind::unknown)
    return invalid("is " + with_article(kind) + ", not an answers file");
  if (root.kind != Json::Kind::object)
    return invalid("must be an object {\"schema\", \"exercise\", \"answers\"}, not " + kind_of(root));
  const std::string* schema = string_at(root, "schema");
  if (schema == nullptr || *schema != "blossom.answers/1")
    return invalid("\"schema\" must be \"blossom.answers/1\"" +
                   (schema != nullptr ? ", not " + excerpt(*schema) : std::string()));
  const std::string* id = string_at(root, "exercise");
  if (id == nullptr || *id != exercise.id)
    return invalid("\"exercise\" must be " + excerpt(exercise.id) +
                   (id != nullptr ? ", not " + excerpt(*id) : std::string()));
  const Json* given = root.find("answers");
  if (given == nullptr) {
    const auto near = did_you_mean("answers", root.keys);
    return invalid("\"answers\" is missing" + (near ? "; did you mean it by " + excerpt(*near) + "?" : std::string()));
  }
  if (given->kind != Json::Kind::object)
    return invalid("\"answers\" must be an object of names and values such as {\"k\": 4}");

  answers.part.assign(exercise.parts.size(), nullptr);
  std::size_t ignored = 0;
  const auto ignore = [&](auto&& note) {
    if (++ignored <= most_notes) answers.notes.push_back(note());
  };
  for (const std::string& key : root.keys)
    if (key != "schema" && key != "exercise" && key != "answers" && key != "student" && key != "$schema" &&
        key != "$comment")
      ignore([&] { return "unknown key " + excerpt(key) + " was ignored"; });
  for (std::size_t i = 0; i < given->keys.size(); ++i) {
    if (const auto part = exercise.part(given->keys[i]))
      answers.part[*part] = &given->items[i];
    else if (const auto meant = in_other_case(exercise, given->keys[i]);
             meant && given->find(exercise.parts[*meant].name) == nullptr)
      answers.misnamed.emplace_back(*meant, given->keys[i]);
    else {
      answers.ignored.push_back(&given->keys[i]);
      ignore([&] { return not_asked(exercise, given->keys[i]); });
    }
  }
  if (ignored > most_notes) answers.notes.push_back(std::to_string(ignored - most_notes) + " more were ignored");
  return answers;
}

Typed read_typed(const Part& part, const Json& json) {
  Typed typed;
  if (part.question != nullptr && !part.question->is_value()) {
    typed.problem = mark_letters(*part.question, json).problem;
    return typed;
  }
  const auto take = [&](const Json& number) {
    auto value = is_number(number) ? parse_typed(number.text) : std::nullopt;
    if (!value) {
      typed.problem = number.kind == Json::Kind::string ? no_number(number.text)
                      : number.kind == Json::Kind::number
                          ? "contains " + kind_of(number) + ", which is too long or too extreme to compute with"
                          : "contains " + kind_of(number) + " where a number must be";
      return false;
    }
    typed.texts.push_back(number.text);
    typed.numbers.push_back(std::move(*value));
    return true;
  };
  if (part.is_single()) {
    if (is_number(json))
      take(json);
    else
      typed.problem = expected_shape(part) + ", not " + kind_of(json);
    return typed;
  }
  const Json* array = array_of(part, json);
  const bool weightless = array != nullptr && leaves_out_weight(part, array->items.size());
  if (array == nullptr || (part.size() != 0 && array->items.size() != part.size() && !weightless)) {
    typed.problem = expected_shape(part) + ", not " + kind_of(json);
    return typed;
  }
  for (const Json& item : array->items)
    if (!take(item)) return typed;
  if (weightless) {
    typed.texts.emplace_back("0");
    typed.numbers.emplace_back(0);
  }
  if (part.as_set) {
    std::vector<std::size_t> order(typed.numbers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return typed.numbers[a] < typed.numbers[b]; });
    Typed sorted;
    for (const std::size_t i : order) {
      sorted.texts.push_back(typed.texts[i]);
      sorted.numbers.push_back(std::move(typed.numbers[i]));
    }
    return sorted;
  }
  return typed;
}

std::string near_miss(const Part& part, NumbersView<Exact> traced, const Typed& typed) {
  const Tolerance& asked = part.tolerance;
  const auto right = part.as_typed(traced);
  if (asked.kind == Tolerance::Kind::exact || part.as_set || right.size() != typed.numbers.size()) return {};
  bool outside = false;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const double off = std::abs((typed.numbers[i] - right[i]).to_double());
    if (!(off <= 20 * slack(asked, right[i]).to_double())) return {};
    outside = outside || !within(asked, right[i], typed.numbers[i]);
  }
  if (!outside) return {};
  const auto digits = [&](const std::string& kind) {
    return std::to_string(asked.digits) + " " + kind + (asked.digits == 1 ? " is asked" : "s are asked");
  };
  switch (asked.kind) {
    case Tolerance::Kind::exact:
      break;
    case Tolerance::Kind::decimals:
      return digits("decimal");
    case Tolerance::Kind::significant:
      return digits("significant digit");
    case Tolerance::Kind::absolute:
      return "it may be off by at most " + format_number(asked.amount.to_double());
    case Tolerance::Kind::relative:
      return "it may be off by at most " + format_number(100 * asked.amount.to_double()) + " %";
  }
  return {};
}

Match match(const Part& part, const Json& json) {
  if (part.question != nullptr && !part.question->is_value())
    return mark_letters(*part.question, json).verdict == Verdict::correct ? Match::right : Match::different;
  const auto fits = [](const Window& window, const Json& number) {
    return is_number(number) && fit(window, number.text) == Fit::inside;
  };
  if (part.is_single()) return fits(part.windows[0], json) ? Match::right : Match::different;
  const Json* array = array_of(part, json);
  if (array == nullptr) return Match::different;
  if (array->items.size() != part.windows.size() && !leaves_out_weight(part, array->items.size()))
    return Match::different;
  if (part.as_set) {
    const Typed typed = read_typed(part, json);
    if (!typed.problem.empty()) return Match::different;
    for (std::size_t i = 0; i < part.windows.size(); ++i)
      if (fit(part.windows[i], typed.texts[i]) != Fit::inside) return Match::different;
    return Match::right;
  }
  for (std::size_t i = 0; i < array->items.size(); ++i)
    if (!fits(part.windows[i], array->items[i])) return Match::different;
  return Match::right;
}

}  // namespace blossom
