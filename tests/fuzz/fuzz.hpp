#pragma once
// What the fuzz targets share. A target says what must hold of every input, not only that nothing crashes: require()
// ends the program where it does not, and libFuzzer keeps the input.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/json_write.hpp"
#include "base/utf8.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace blossom::fuzz {

inline void require(bool holds, std::string_view what, std::string_view detail = {}) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %.*s\n%.*s\n", static_cast<int>(what.size()), what.data(),
               static_cast<int>(detail.size()), detail.data());
  std::abort();
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

inline bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

// Text for people: UTF-8, and nothing in it that a terminal obeys but line breaks and tabs.
inline bool is_harmless(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    const std::string_view character = text.substr(i, length);
    if (is_control(character) && character != "\n" && character != "\t") return false;
    i += length;
  }
  return true;
}

// Each mistake says something, harmlessly, on one line, at a place that is in the text. Columns count characters.
inline void check_diagnostics(const Diagnostics& diagnostics, std::string_view text) {
  require(!diagnostics.empty(), "what is refused has a reason");
  for (const Diagnostic& d : diagnostics) {
    const std::string said = to_string(d);
    require(!d.message.empty(), "a diagnostic says something", said);
    require(is_harmless(said) && said.find('\n') == std::string::npos, "a diagnostic is one harmless line", said);
    require(d.line >= 0 && d.column >= 0 && (d.line > 0 || d.column == 0), "a place is a line, and a column in it",
            said);
    if (d.line == 0) continue;
    std::size_t begin = 0;
    for (int line = 1; line < d.line; ++line) {
      begin = text.find('\n', begin);
      require(begin != std::string_view::npos, "the line is in the file", said);
      ++begin;
    }
    const auto line = text.substr(begin, text.find('\n', begin) - begin);
    require(static_cast<std::size_t>(d.column) <= utf8_count(line) + 1, "the column is in the line", said);
  }
}

// What is there is there without mistakes, and what is not has some.
template <class T>
void check_outcome(const Checked<T>& checked, std::string_view text) {
  if (checked)
    require(checked.diagnostics.empty(), "what is accepted has no mistakes", to_string(checked.diagnostics));
  else
    check_diagnostics(checked.diagnostics, text);
}

inline bool same(const Json& a, const Json& b) {
  if (a.kind != b.kind || a.boolean != b.boolean || a.text != b.text || a.keys != b.keys) return false;
  if (a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)  // no deeper than the limit of the reader
    if (!same(a.items[i], b.items[i])) return false;
  return true;
}

}  // namespace blossom::fuzz
