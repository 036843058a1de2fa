#include "scene/typeset.hpp"

#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace blossom {
namespace {

using Level = TextRun::Level;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\''; }  // let's

std::optional<std::string_view> letter_of(std::string_view symbol) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> letters{
      {{"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"Ubar", "Ū"}}};
  for (const auto& [name, letter] : letters)
    if (name == symbol) return letter;
  return std::nullopt;
}

void add_name(RichText& out, std::string_view symbol, const std::vector<std::string>& indices, bool levels) {
  const auto letter = letter_of(symbol);
  out.push_back({std::string(letter.value_or(symbol)), Level::base, true});
  if (indices.empty()) return;
  if (levels && indices.size() == 2) {
    out.push_back({indices[1], Level::sub});
    if (indices[0] != "0") out.push_back({"(" + indices[0] + ")", Level::super});
    return;
  }
  std::string sub = indices[0];
  for (std::size_t i = 1; i < indices.size(); ++i) sub += "," + indices[i];
  out.push_back({sub, Level::sub});
}

bool has_levels(const Algorithm& algorithm, std::string_view symbol, std::size_t arity) {
  for (const ValueSpec& spec : algorithm.values)
    if (spec.symbol == symbol && spec.indices.size() == arity) return arity == 2 && spec.indices[0] == "r";
  return arity == 2 && letter_of(symbol).has_value();
}

void add_text(RichText& out, std::string_view text) {
  if (text.empty()) return;
  if (!out.empty() && out.back().level == Level::base && !out.back().italic)
    out.back().text += text;
  else
    out.push_back({std::string(text)});
}

}  // namespace

RichText typeset_name(const Name& name, const Algorithm& algorithm) {
  std::vector<std::string> indices;
  for (int i = 0; i < name.arity; ++i) indices.push_back(std::to_string(name.index[i]));
  RichText out;
  const std::string symbol = name.symbol.text();
  add_name(out, symbol, indices, has_levels(algorithm, symbol, name.arity));
  return out;
}

RichText typeset_text(std::string_view text, const Algorithm& algorithm) {
  RichText out;
  std::size_t plain = 0;  // text from here on is not yet in out
  for (std::size_t i = 0; i < text.size();) {
    if (!is_letter(text[i]) || (i > plain && is_word(text[i - 1]))) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string_view symbol = text.substr(i, end - i);
    std::vector<std::string> indices;
    std::size_t after = end;
    if (after + 1 < text.size() && text[after] == '_') {  // u_k, u_{k+1}
      std::size_t stop = after + 1;
      if (text[stop] == '{') {
        stop = text.find('}', stop);
        if (stop != std::string_view::npos) {
          indices.emplace_back(text.substr(after + 2, stop - after - 2));
          after = stop + 1;
        }
      } else {
        while (stop < text.size() && std::isalnum(static_cast<unsigned char>(text[stop])) != 0) ++stop;
        indices.emplace_back(text.substr(after + 1, stop - after - 1));
        after = stop;
      }
    } else {
      while (after < text.size() && text[after] == '[' && indices.size() < 2) {
        const std::size_t stop = text.find(']', after);
        if (stop == std::string_view::npos || stop - after > 12 || stop == after + 1) break;
        indices.emplace_back(text.substr(after + 1, stop - after - 1));
        after = stop + 1;
      }
    }
    // A word is a name when it has indices, is a Greek letter, or is a single letter of the algorithm's table ("a" is
    // not).
    const bool single = symbol.size() == 1 && algorithm.spec({Symbol::of(symbol), {0, 0}, 0}) != nullptr;
    if (indices.empty() && !letter_of(symbol) && !single) {
      i = end;
      continue;
    }
    add_text(out, text.substr(plain, i - plain));
    if (after + 1 < text.size() && text[after] == '.' && is_letter(text[after + 1]) && !indices.empty()) {
      plain = i = after + 1;  // the scope of a name: the picture shows which one is meant
      continue;
    }
    add_name(out, symbol, indices, has_levels(algorithm, symbol, indices.size()));
    plain = i = after;
  }
  add_text(out, text.substr(plain));
  return out;
}

}  // namespace blossom
