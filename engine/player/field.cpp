#include "player/field.hpp"

#include <algorithm>

#include "base/json_write.hpp"

namespace blossom {

// ---- texts ----------------------------------------------------------------------------------------------------------

const FieldTexts::Entry* FieldTexts::current(std::string_view id, const std::string& value) const {
  const auto found = entries_.find(id);
  return found != entries_.end() && found->second.value == value ? &found->second : nullptr;
}

const std::string& FieldTexts::text(std::string_view id, const std::string& value) const {
  const Entry* entry = current(id, value);
  return entry != nullptr ? entry->text : value;
}

const std::string& FieldTexts::error(std::string_view id, const std::string& value) const {
  static const std::string nothing;
  const Entry* entry = current(id, value);
  return entry != nullptr ? entry->error : nothing;
}

void FieldTexts::type(std::string_view id, const std::string& value, std::string text) {
  refuse(id, value, std::move(text), {});
}

void FieldTexts::refuse(std::string_view id, const std::string& value, std::string text, std::string error) {
  entries_.insert_or_assign(std::string(id), Entry{value, std::move(text), std::move(error)});
}

void FieldTexts::drop(std::string_view id) {
  if (const auto found = entries_.find(id); found != entries_.end()) entries_.erase(found);
}

void FieldTexts::accept(std::string_view id) {
  drop(id);
  std::erase_if(entries_, [](const auto& entry) { return entry.second.text == entry.second.value; });
}

bool FieldTexts::holds(std::string_view prefix) const {
  const auto found = entries_.lower_bound(prefix);
  return found != entries_.end() && found->first.starts_with(prefix);
}

bool FieldTexts::says(std::string_view error) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.second.error == error; });
}

// ---- numbers --------------------------------------------------------------------------------------------------------

std::optional<Exact> typed_number(std::string_view text) {
  std::string plain;
  constexpr std::string_view minus = "\u2212";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with(minus)) {
      plain += '-';
      i += minus.size() - 1;
    } else if (text[i] != ' ') {
      plain += text[i];
    }
  }
  return Exact::parse(plain);
}

std::string number_text(const Exact& x, NumberStyle style) {
  std::string fraction = x.to_string();
  const std::size_t slash = fraction.find('/');
  if (slash == std::string::npos) return fraction;
  const bool small = style == NumberStyle::parameter && fraction.size() - slash == 2;  // a denominator of one digit
  const Json decimal = json_number(x);
  if (small || decimal.kind != Json::Kind::number) return fraction;
  const bool readable = style == NumberStyle::coordinate && decimal.text.size() - decimal.text.find('.') <= 5;
  return readable || decimal.text.size() <= fraction.size() ? decimal.text : fraction;
}

std::optional<std::string> nudged(std::string_view text, int by) {
  const auto x = typed_number(text);
  if (!x) return std::nullopt;
  if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
    // As typed: 2/4 and one more is 3/4.
    const auto over = typed_number(text.substr(0, slash)), under = typed_number(text.substr(slash + 1));
    if (!over || !under) return std::nullopt;
    return (*over + Exact(by)).to_string() + "/" + under->to_string();
  }
  const std::size_t point = text.find('.');
  if (text.find_first_of("eE") != std::string_view::npos) return std::nullopt;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto places = static_cast<std::size_t>(
      point == std::string_view::npos ? 0 : std::count_if(text.begin() + point, text.end(), digit));
  Exact unit = 1;
  for (std::size_t i = 0; i < places; ++i) unit /= Exact(10);
  const Exact sum = *x + Exact(by) * unit;
  Exact scaled = abs(sum);  // written out with as many places, so that the next key goes on in the same one
  for (std::size_t i = 0; i < places; ++i) scaled *= Exact(10);
  std::string digits = scaled.to_string();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return (sum < Exact(0) ? "-" : "") + digits;
}

}  // namespace blossom
