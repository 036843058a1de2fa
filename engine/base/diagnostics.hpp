#pragma once
// What is wrong with an input, where, and what would be right. All mistakes are collected; none is printed here.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace blossom {

struct Diagnostic {
  std::string file;     // empty: not from a file
  int line = 0;         // 1-based; 0: unknown
  int column = 0;       // 1-based, in characters (UTF-8 code points); 0: unknown
  std::string path;     // "inputs.curve.points[2][1]"; empty: the whole document
  std::string message;  // what is wrong, and what would be right
};

using Diagnostics = std::vector<Diagnostic>;

// The text on one line, harmless to a terminal: control characters (is_control of utf8.hpp) and invalid UTF-8 are
// written as \xNN, byte by byte.
std::string printable(std::string_view text);

// "file:line:column: path: message", leaving out the parts that are unknown; each part printable, for it may come from
// a hostile file: one diagnostic is one line.
std::string to_string(const Diagnostic&);
std::string to_string(const Diagnostics&);  // one per line, by file, line and column

// A value, or the reasons why there is none.
template <class T>
struct Checked {
  std::optional<T> value;
  Diagnostics diagnostics;

  Checked() = default;
  Checked(T v) : value(std::move(v)) {}                  // NOLINT
  Checked(Diagnostics d) : diagnostics(std::move(d)) {}  // NOLINT
  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

// The text in quotation marks, for messages: at most 40 characters of it, printable, then "...".
std::string excerpt(std::string_view text);

// The candidate nearest to `word` in edit distance, if near enough to be a typing mistake.
std::optional<std::string> did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace blossom
