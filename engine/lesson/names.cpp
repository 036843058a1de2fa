#include "lesson/names.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "base/diagnostics.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_rows = 6;       // of a family of two indices, each told
constexpr std::size_t most_families = 12;  // of a run, told in a message
constexpr std::size_t most_names = 20'000;

// A name without what stands in its brackets, and the numbers that stood there.
std::string form_of(std::string_view name, std::vector<int>* numbers = nullptr) {
  std::string form;
  for (std::size_t i = 0; i < name.size(); ++i) {
    form += name[i];
    if (name[i] != '[') continue;
    const std::size_t close = std::min(name.find(']', i), name.size());
    if (numbers != nullptr) numbers->push_back(std::stoi(std::string(name.substr(i + 1, close - i - 1))));
    i = close - 1;
  }
  return form;
}

std::string range(int from, int to) {
  return "[" + std::to_string(from) + (from == to ? "" : ".." + std::to_string(to)) + "]";
}

// Of each index from its least to its greatest number.
std::string bounds(const std::string& form, const std::vector<std::vector<int>>& indices) {
  std::string text;
  std::size_t which = 0;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] != '[') {
      text += form[i];
      continue;
    }
    const auto by_index = [&](const auto& a, const auto& b) { return a[which] < b[which]; };
    const auto [least, most] = std::ranges::minmax_element(indices, by_index);
    text += range((*least)[which], (*most)[which]);
    ++which;
    ++i;
  }
  return text;
}

std::string ranges_of(const std::string& form, const std::vector<std::vector<int>>& indices) {
  if (indices.front().size() != 2 || !form.ends_with("[][]")) return bounds(form, indices);
  std::map<int, std::pair<int, int>> rows;
  for (const auto& index : indices) {
    const auto [row, is_new] = rows.try_emplace(index[0], index[1], index[1]);
    if (!is_new) row->second = {std::min(row->second.first, index[1]), std::max(row->second.second, index[1])};
  }
  const auto same = [&](const auto& row) { return row.second == rows.begin()->second; };
  if (rows.size() > most_rows || std::ranges::all_of(rows, same)) return bounds(form, indices);
  std::string told;
  const std::string symbol = form.substr(0, form.size() - 4);
  for (const auto& [row, columns] : rows)
    told += (told.empty() ? "" : ", ") + symbol + range(row, row) + range(columns.first, columns.second);
  return told;
}

std::string without_blanks(std::string_view text) {
  std::string out(text);
  std::erase(out, ' ');
  return out;
}

std::string lower(std::string text) {
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

std::vector<NameFamily> name_families(const TraceGraph& trace) {
  std::vector<NameFamily> families;
  std::vector<std::vector<std::vector<int>>> indices;
  std::map<std::string, std::size_t> known;
  for (ValueId v = 0; v < trace.value_count() && v < most_names; ++v) {
    std::vector<int> numbers;
    std::string form = form_of(trace.name(v), &numbers);
    const auto [at, is_new] = known.try_emplace(form, families.size());
    if (is_new) {
      families.push_back({std::move(form), {}, {}});
      indices.emplace_back();
    }
    families[at->second].values.push_back(v);
    indices[at->second].push_back(std::move(numbers));
  }
  for (std::size_t i = 0; i < families.size(); ++i) families[i].ranges = ranges_of(families[i].form, indices[i]);
  return families;
}

std::string meant_values(std::string_view given, const TraceGraph& trace, std::span<const std::string_view> words) {
  const std::string text = without_blanks(given);
  const auto meant = [](std::string_view name) { return "; did you mean " + excerpt(name) + "?"; };
  if (text != given && (trace.find(text) || std::ranges::find(words, text) != words.end())) return meant(text);
  const auto families = name_families(trace);
  const std::string form = form_of(text);
  for (const NameFamily& family : families)
    if (family.form == form && form.ends_with(']'))
      return "; there " + std::string(family.values.size() == 1 ? "is " : "are ") + family.ranges;
  for (const std::string_view word : words)
    if (lower(text) == word) return meant(word);
  std::vector<std::string> names(words.begin(), words.end());
  for (ValueId v = 0; v < trace.value_count() && v < most_names; ++v) names.push_back(trace.name(v));
  if (const auto near = did_you_mean(text, names)) return meant(*near);
  std::string told;
  for (std::size_t i = 0; i < families.size() && i < most_families; ++i)
    told += (i == 0 ? "; the values of this run are " : ", ") + families[i].ranges;
  return told + (families.size() > most_families ? ", ..." : "");
}

}  // namespace blossom
