#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "algorithms/typeset.hpp"
#include "scene/panels.hpp"
#include "scene/scheme.hpp"

namespace blossom {
namespace {

std::string latex_symbol(const std::string& letter) {
  static const std::map<std::string, std::string> commands{
      {"α", "\\alpha"}, {"β", "\\beta"}, {"γ", "\\gamma"}, {"θ", "\\theta"}, {"Ū", "\\bar{U}"}};
  if (const auto found = commands.find(letter); found != commands.end()) return found->second;
  return letter.size() == 1 ? letter : "\\mathrm{" + letter + "}";
}

std::string latex_name(const RichText& name) {
  std::string text;
  for (const TextRun& run : name) {
    if (run.level == TextRun::Level::base) text += latex_symbol(run.text);
    if (run.level == TextRun::Level::sub) text += "_{" + run.text + "}";
    if (run.level == TextRun::Level::super) text += "^{" + run.text + "}";
  }
  return text;
}

// "-3/5" and "1e-07": a fraction keeps its sign in front, a power of ten is one.
std::string latex_number(std::string_view number) {
  std::string sign;
  if (number.starts_with('-')) {
    sign = "-";
    number.remove_prefix(1);
  }
  if (const auto slash = number.find('/'); slash != std::string_view::npos)
    return sign + "\\tfrac{" + std::string(number.substr(0, slash)) + "}{" + std::string(number.substr(slash + 1)) +
           "}";
  if (const auto e = number.find('e'); e != std::string_view::npos)
    return sign + std::string(number.substr(0, e)) + " \\cdot 10^{" +
           std::to_string(std::stoi(std::string(number.substr(e + 1)))) + "}";
  return sign + std::string(number);
}

// A value's text: numbers, lists in parentheses, "w = 2" and a few words.
std::string latex_text(std::string_view text) {
  const auto in_number = [&](std::size_t i) {
    const char c = text[i];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '/') return true;
    if (c == '-') return true;
    if (c == '+') return i > 0 && text[i - 1] == 'e';
    return c == 'e' && i > 0 && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0;
  };
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    if (in_number(i)) {
      while (end < text.size() && in_number(end)) ++end;
      out += latex_number(text.substr(i, end - i));
    } else if (std::isalpha(static_cast<unsigned char>(text[i])) != 0) {
      while (end < text.size() && (std::isalpha(static_cast<unsigned char>(text[end])) != 0 || text[end] == ' ')) ++end;
      const std::string words(text.substr(i, end - i));
      out += words == "w " ? "w " : "\\text{" + words + "}";
    } else {
      end = i + 1;
      if (text[i] == '(')
        out += "\\left(";
      else if (text[i] == ')')
        out += "\\right)";
      else if (text[i] == ',')
        out += ",\\";
      else
        out += text[i];
    }
    i = end;
  }
  return out;
}

}  // namespace

std::string latex_value(const StepSource& source, ValueId v) {
  const ValueRecord& record = source.graph->value(v);
  return latex_name(typeset_name(record.name, source.algorithm_at(record.step))) + " = " +
         latex_text(source.value_text(v));
}

std::string latex_tableau(const StepSource& source, std::uint32_t step) {
  const Scheme* scheme = scheme_at(source, step);
  if (scheme == nullptr) return {};
  // Each level stands half a line below the one before, as on a blackboard.
  std::map<long, std::map<int, std::string>> lines;
  for (const Scheme::Cell& cell : scheme->cells)
    if (source.graph->value(cell.value).step <= step)
      lines[std::lround(2 * cell.row)][cell.column] = latex_value(source, cell.value);
  std::string text = "\\begin{array}{" + std::string(static_cast<std::size_t>(scheme->column_count()), 'l') + "}\n";
  for (const auto& [row, cells] : lines) {
    std::string line = " ";
    for (int column = 0; column < scheme->column_count(); ++column) {
      if (column > 0) line += " &";
      if (const auto cell = cells.find(column); cell != cells.end()) line += " " + cell->second;
    }
    text += line + " \\\\\n";
  }
  return text + "\\end{array}\n";
}

}  // namespace blossom
