#include "algorithms/selector.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include "base/diagnostics.hpp"

namespace blossom {
namespace {

constexpr long long everything = std::numeric_limits<long long>::max();

bool parse_int(std::string_view text, long long& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size() && out >= 0;
}

}  // namespace

std::optional<Selector> Selector::parse(std::string_view text, std::string& error) {
  Selector selector;
  selector.text_ = text;
  if (text.empty() || text.size() > 200) {
    error = "a selector is a value's name such as P[1][*], of at most 200 characters";
    return std::nullopt;
  }
  // Parts end at dots outside brackets.
  std::size_t at = 0;
  while (at <= text.size()) {
    Part part;
    while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_'))
      part.word += text[at++];
    if (part.word.empty()) {
      error = "expected a name at character " + std::to_string(at + 1);
      return std::nullopt;
    }
    while (at < text.size() && text[at] == '[') {
      const std::size_t end = text.find(']', at);
      if (end == std::string_view::npos) {
        error = "the bracket at character " + std::to_string(at + 1) + " is not closed";
        return std::nullopt;
      }
      const std::string_view inside = text.substr(at + 1, end - at - 1);
      Index index;
      const std::size_t dots = inside.find("..");
      bool good = false;
      if (inside == "*") {
        index = {0, everything};
        good = true;
      } else if (dots != std::string_view::npos) {
        good = parse_int(inside.substr(0, dots), index.from) && parse_int(inside.substr(dots + 2), index.to) &&
               index.from <= index.to;
      } else {
        good = parse_int(inside, index.from);
        index.to = index.from;
      }
      if (!good) {
        error = "an index is a whole number, * or a range such as 1..3, not " + excerpt(inside);
        return std::nullopt;
      }
      part.indices.push_back(index);
      at = end + 1;
    }
    selector.parts_.push_back(std::move(part));
    if (at == text.size()) return selector;
    if (text[at] != '.') {
      error = "unexpected character " + std::to_string(at + 1);
      return std::nullopt;
    }
    ++at;
  }
  return selector;
}

bool Selector::parts_match(const Part& part, std::string_view word, const int* index, std::size_t count) {
  if (part.word != word || part.indices.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i)
    if (index[i] < part.indices[i].from || index[i] > part.indices[i].to) return false;
  return true;
}

bool Selector::matches(const TraceGraph& trace, ValueId v) const {
  const ValueRecord& record = trace.value(v);
  const Part& last = parts_.back();
  if (last.indices.size() != record.name.arity || Symbol::of(last.word) != record.name.symbol || last.word.size() > 8)
    return false;
  if (!parts_match(last, last.word, record.name.index, record.name.arity)) return false;
  auto scopes = trace.phase_path(trace.phase_of(v));
  std::erase_if(scopes, [&](std::uint32_t phase) { return !trace.phases()[phase].scoped; });
  if (record.name.outer != 0 && !scopes.empty()) scopes.pop_back();
  if (scopes.size() + 1 != parts_.size()) return false;
  for (std::size_t i = 0; i < scopes.size(); ++i) {
    const PhaseRecord& phase = trace.phases()[scopes[i]];
    if (!parts_match(parts_[i], phase.id, &phase.index, phase.index < 0 ? 0 : 1)) return false;
  }
  return true;
}

std::vector<ValueId> Selector::select(const TraceGraph& trace) const {
  std::vector<ValueId> found;
  for (ValueId v = 0; v < trace.value_count(); ++v)
    if (matches(trace, v)) found.push_back(v);
  return found;
}

std::optional<std::string> nearest_name(const TraceGraph& trace, std::string_view text) {
  std::vector<std::string> names;
  for (ValueId v = 0; v < trace.value_count() && names.size() < 20000; ++v) names.push_back(trace.name(v));
  return did_you_mean(text, names);
}

}  // namespace blossom
