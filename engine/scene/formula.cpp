#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

// How many lines a text takes at a width, in characters of about half an em: enough to reserve space. Lines that are
// broken at blanks are about seven eighths full.
int lines_of(std::size_t characters, double width, double size) {
  const double per_line = std::max(8.0, width / (size * 0.6));
  const auto count = static_cast<double>(characters);
  return count <= per_line ? 1 : static_cast<int>(std::ceil(count / (per_line * 0.875)));
}

std::size_t characters(const RichText& runs) {
  std::size_t count = 0;
  for (const TextRun& run : runs) count += run.text.size();
  return count;
}

}  // namespace

double add_formula(Sheet& sheet, const StepSource& source, std::uint32_t step, double x, double y, double width,
                   double height) {
  View& view = sheet.view;
  const ValueId v = source.graph->main_value(step);
  if (v == absent || source.graph->is_input(v)) return 0;
  const Algorithm& algorithm = source.algorithm_at(step);
  const auto shortened = [](std::string words) {
    const std::size_t most = 220;  // a knot vector of hundreds of knots is not for this box
    return words.size() <= most ? words : words.substr(0, most) + " ...";
  };
  const std::string formula = source.formula(v);
  const std::string numbers = source.numbers(v);
  const std::string value = shortened(source.value_text(v));

  const std::string own = source.own_name(v);
  RichText result = own.find('.') == std::string::npos ? typeset_name(source.graph->value(v).name, algorithm)
                                                       : typeset_text(own, algorithm);
  result.push_back({" = " + value});
  const std::size_t letters = characters(result) + 2;
  const double size = lines_of(letters, width, 14 * 1.05) > 2 ? 0.85 : 1.05;
  constexpr double heading = 22;
  const double rows = std::max(static_cast<double>(lines_of(letters, width, 15.7 * size)),
                               std::ceil(parts::width_of(result, Role::text_current, size) / (0.9 * width)));
  if (heading + 21 * size * rows > height) return 0;
  double at = y + parts::heading(view, x, y, "This step");
  parts::text(view, x, at + 15, std::move(result), Role::text_current, size).max_width = width;
  at += 21 * size * lines_of(letters, width, 15.7 * size) + 4;

  // One label, so that its lines cannot run into each other however they wrap.
  std::vector<std::string> lines{"= " + shortened(formula)};
  const std::string made = source.made_text(v);
  if (numbers != formula && numbers != source.value_text(v)) lines.push_back("= " + shortened(numbers));
  // Of a rational curve it is the homogeneous point that equals this; the point itself stands above.
  if (made != source.value_text(v)) lines.push_back("= " + shortened(made.substr(0, made.find(": "))));
  if (const std::string polar = source.polar(v); !polar.empty()) lines.push_back("blossom value " + polar);
  std::string from;
  const double from_at = at;
  for (const std::string& line : lines) {
    const double set = std::ceil(parts::width_of(parts::ems(line), Role::text, 0.9) / (0.9 * width));
    const double needed = 19 * std::max(static_cast<double>(lines_of(line.size(), width, 14 * 0.9)), set);
    if (at + needed > y + height) break;
    from += (from.empty() ? "" : "\n") + line;
    at += needed;
  }
  if (!from.empty())
    parts::text(view, x, from_at + 14, typeset_text(from, algorithm), Role::text, 0.9).max_width = width;
  return at - y + 12;
}

}  // namespace blossom
