#pragma once
// Selectors: names with wildcards, for lessons and exercises. `P[1][*]`, `alpha[1..2][*]`, `Q[*]`, `k`,
// `raise[*].Q[*]`; an index is a whole number, `*`, or a range `a..b` (both ends included).

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trace/trace.hpp"

namespace blossom {

class Selector {
 public:
  // Nothing when the text is no selector; `error` says what is wrong with it.
  static std::optional<Selector> parse(std::string_view text, std::string& error);

  bool matches(const TraceGraph&, ValueId) const;
  std::vector<ValueId> select(const TraceGraph&) const;  // in the order they are made
  const std::string& text() const { return text_; }

 private:
  struct Index {
    long long from = 0;
    long long to = 0;
  };
  struct Part {
    std::string word;
    std::vector<Index> indices;
  };
  static bool parts_match(const Part&, std::string_view word, const int* index, std::size_t count);
  std::string text_;
  std::vector<Part> parts_;  // scopes, then the name
};

// What a selector that matches nothing may have meant: the nearest names of the trace.
std::optional<std::string> nearest_name(const TraceGraph&, std::string_view text);

}  // namespace blossom
