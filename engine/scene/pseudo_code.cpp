#include <algorithm>

#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

using parts::Box;

constexpr double usual_size = 0.86, smallest_size = 0.55, wrapped_size = 0.72;
constexpr double hanging = 0.61;    // ems; of the pieces of a line behind the first
constexpr double row = 20;          // of a line that is not wrapped
constexpr double wrapped_row = 15;  // from one piece of a wrapped line to the next
constexpr double before_code = 22;  // the line's number stands there

struct CodeLine {
  std::vector<std::string> pieces;
  double indent = 0;
};

// Each line of the code with its indentation, broken so that it fits; the pieces behind the first hang.
std::vector<CodeLine> broken(const Algorithm& algorithm, double width) {
  const double em = parts::width_of(1, Role::text, wrapped_size);
  std::vector<CodeLine> lines;
  for (const std::string_view code : algorithm.pseudo_code) {
    const std::size_t blanks = std::min(code.find_first_not_of(' '), code.size());
    CodeLine line;
    line.indent = std::min(parts::ems(code.substr(0, blanks), false, true) * em, width * 0.3);
    line.pieces = parts::wrapped(code.substr(blanks), (width - line.indent) / em, false, true, hanging);
    lines.push_back(std::move(line));
  }
  return lines;
}

// The bar and tint of the current line, the frame of a lit one, and the spot.
void mark(Sheet& sheet, const Box& box, int number, int current, const Emphasis& emphasis) {
  if (number == current) {
    parts::fill(sheet.view, box, Role::current, 0.18);
    parts::fill(sheet.view, {box.x, box.y, 3, box.height}, Role::current);
  }
  if (number == emphasis.line) {
    parts::fill(sheet.view, box, Role::highlight, 0.14);
    parts::outline(sheet.view, {box.x + 1, box.y + 1, box.width - 2, box.height - 2}, Role::highlight, 0.6);
  }
  sheet.spots.push_back({{Link::Kind::line, static_cast<std::uint32_t>(number)},
                         box.x,
                         box.y,
                         box.width,
                         box.height,
                         "line " + std::to_string(number)});
}

TextRun code_run(std::string words, bool bold) { return {std::move(words), TextRun::Level::base, false, bold, true}; }

void set_pieces(View& view, const CodeLine& line, double x, double baseline, bool bold) {
  double left = x + line.indent;
  for (const std::string& piece : line.pieces) {
    parts::text(view, left, baseline, {code_run(piece, bold)}, Role::text, wrapped_size);
    baseline += wrapped_row;
    left = x + line.indent + parts::width_of(hanging, Role::text, wrapped_size);
  }
}

// Nothing but the line that counts, as wide as there is room.
double add_current_line(Sheet& sheet, const Algorithm& algorithm, int current, const Emphasis& emphasis, double x,
                        double y, double width) {
  if (current == 0) return 0;
  const std::string_view code = algorithm.pseudo_code[static_cast<std::size_t>(current) - 1];
  const std::string line(code.substr(std::min(code.find_first_not_of(' '), code.size())));
  const auto pieces = parts::wrapped(line, width / parts::width_of(1, Role::text, wrapped_size), false, true);
  const double height = static_cast<double>(pieces.size()) * 18 + 4;
  const double margin = std::min(x, 6.0);
  // No bar: there are no other lines to tell it from.
  const Box box{x - margin, y, width + 2 * margin, height};
  parts::fill(sheet.view, box, Role::current, 0.18);
  mark(sheet, box, current, 0, emphasis);
  parts::text(sheet.view, x, y + 14, {code_run(line, true)}, Role::text, wrapped_size).max_width = width;
  return height + 12;
}

}  // namespace

double add_pseudo_code(Sheet& sheet, const StepSource& source, std::uint32_t step, const Emphasis& emphasis, double x,
                       double y, double width, double most_height) {
  View& view = sheet.view;
  const Algorithm& algorithm = source.algorithm_at(step);
  const int current = source.line(step);
  const double margin = std::min(x, 6.0);  // the bar stands a little to the left of the text
  double at = y + parts::heading(view, x, y, std::string(algorithm.title), width);
  double longest = 1;
  for (const auto line : algorithm.pseudo_code) longest = std::max(longest, parts::ems(line, true, true));
  const double size = parts::size_to_fit(longest, Role::text, width - before_code - 4, usual_size);
  const auto number = [&](int i, double baseline, double number_size) {
    parts::text(view, x + 14, baseline, {code_run(std::to_string(i), false)}, Role::text_quiet, number_size,
                Label::Placement::right);
  };

  if (size >= smallest_size) {
    for (std::size_t i = 0; i < algorithm.pseudo_code.size(); ++i, at += row) {
      const int line = static_cast<int>(i) + 1;
      mark(sheet, {x - margin, at, width + 2 * margin, row}, line, current, emphasis);
      number(line, at + 14, size);
      parts::text(view, x + before_code, at + 14, {code_run(std::string(algorithm.pseudo_code[i]), line == current)},
                  Role::text, size);
    }
    return at - y + 12;
  }

  const auto lines = broken(algorithm, width - before_code);
  const auto height_of = [](const CodeLine& line) { return static_cast<double>(line.pieces.size()) * wrapped_row + 5; };
  double whole = 0;
  for (const CodeLine& line : lines) whole += height_of(line);
  if (at - y + whole + 12 > most_height)
    return at - y + add_current_line(sheet, algorithm, current, emphasis, x, at, width);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int line = static_cast<int>(i) + 1;
    const double height = height_of(lines[i]);
    mark(sheet, {x - margin, at, width + 2 * margin, height}, line, current, emphasis);
    number(line, at + 14, wrapped_size);
    set_pieces(view, lines[i], x + before_code, at + 14, line == current);
    at += height;
  }
  return at - y + 12;
}

}  // namespace blossom
