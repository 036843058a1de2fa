#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"
#include "scene/scheme.hpp"

namespace blossom {
namespace {

using parts::Box;

// Full size.
constexpr double pitch = 58, cell_height = 44, gap = 74, cell_padding = 9;
constexpr double name_size = 0.95, value_size = 0.86, weight_size = 0.84;
// Fitted into a room.
constexpr double name_height = 1.3;  // in ems: from the foot of a subscript to the top of its superscript
constexpr double highest_row = 38, lowest_row = 15, narrowest_column = 34;

// Where the cells of a scheme are on the sheet.
struct Layout {
  bool full = false;
  bool values = true;
  double row_height = 0, cell_height = 0, left = 0, top = 0;
  std::vector<double> x, width;  // of the cells of each column

  Box box(const Scheme::Cell& cell) const {
    const auto column = static_cast<std::size_t>(cell.column);
    const double middle = top + (cell.row + 0.5) * row_height;
    return {x[column], middle - cell_height / 2, width[column], cell_height};
  }
};

Layout full_layout(const Scheme& scheme, const Scheme::Texts& texts, double x, double y) {
  Layout layout;
  layout.full = true;
  layout.row_height = pitch;
  layout.cell_height = cell_height;
  layout.left = x;
  layout.top = y;
  double at = x + 4;
  for (std::size_t column = 0; column + 1 < scheme.columns.size(); ++column) {
    const double widest = std::max(parts::width_of(texts.name_ems[column], Role::text, name_size),
                                   parts::width_of(texts.value_ems[column], Role::text, value_size));
    // In steps, so that the columns stand still while a point is dragged.
    const double width = std::max(72.0, std::ceil((widest + 2 * cell_padding) / 16) * 16);
    layout.x.push_back(at);
    layout.width.push_back(width);
    at += width + gap;
  }
  return layout;
}

std::optional<Layout> fitted_layout(const Scheme& scheme, const TableauOptions& room, double x, double y) {
  Layout layout;
  const double column_width = room.width / scheme.column_count();
  layout.row_height = std::min(highest_row, (room.height - 30) / scheme.rows);
  if (column_width < narrowest_column || layout.row_height < lowest_row) return std::nullopt;
  layout.values = column_width >= 64 && layout.row_height >= 30;
  layout.cell_height = std::min(layout.row_height * 0.86, layout.values ? 34.0 : 20.0);
  layout.left = x;
  layout.top = y;
  for (int column = 0; column < scheme.column_count(); ++column) {
    layout.x.push_back(x + (column + 0.14) * column_width);
    layout.width.push_back(0.72 * column_width);
  }
  return layout;
}

struct Setter {
  Sheet& sheet;
  const StepSource& source;
  const Scheme& scheme;
  const Layout& layout;
  const Emphasis& emphasis;
  std::uint32_t step;
  ValueId main;                   // the step's value, if it is computed; else absent
  std::vector<ValueId> operands;  // of it

  bool made(const Scheme::Cell& cell) const { return source.graph->value(cell.value).step <= step; }
  bool is_operand(ValueId v) const { return std::ranges::find(operands, v) != operands.end(); }

  void arrow(const Box& from, const Box& to, bool current, const std::string& weight, bool lit) const {
    const glm::dvec3 start{from.right(), from.y + from.height / 2, 0};
    const glm::dvec3 end{to.x, to.y + to.height / 2, 0};
    const Role role = current ? Role::current : lit ? Role::highlight : layout.full ? Role::earlier : Role::rule_line;
    const double width = current ? 0.5 : lit ? 0.6 : 1;
    // The number stands on the line, which leaves room for it.
    const double size = layout.full ? weight_size : 0.62;
    const double text_width = parts::width_of(parts::ems(weight), Role::text_current, size);
    const double room = end.x - start.x;
    if (weight.empty() || text_width + 4 > room) {
      parts::stroke(sheet.view, {start, end}, role, width);
      sheet.view.polylines.back().arrow = layout.full;
      return;
    }
    const glm::dvec3 along = end - start;
    const double half_height = layout.full ? 8 : 6;
    const double cut = std::min((text_width / 2 + 3) / std::abs(along.x),
                                std::abs(along.y) > 1e-9 ? half_height / std::abs(along.y) : 1.0);
    const glm::dvec3 middle = start + 0.5 * along;
    if (cut < 0.45) {
      parts::stroke(sheet.view, {start, start + (0.5 - cut) * along}, role, width);
      parts::stroke(sheet.view, {start + (0.5 + cut) * along, end}, role, width);
      sheet.view.polylines.back().arrow = layout.full;
    }
    parts::text(sheet.view, middle.x, middle.y + 0.36 * 14 * size, {{weight}}, Role::text_current, size,
                Label::Placement::centre);
  }

  void arrows(const Scheme::Cell& cell, const Box& box) const {
    const auto from = source.graph->operands(cell.value);
    const bool current = cell.value == main;
    const auto numbers = current ? parts::weights_of(source, cell.value) : std::vector<std::string>(from.size());
    const bool counts = emphasis.lights(cell.value) || emphasis.share(cell.value) != 0;
    for (std::size_t i = 0; i < from.size(); ++i)
      if (const Scheme::Cell* operand = scheme.find(from[i]))
        arrow(layout.box(*operand), box, current, numbers[i],
              counts && (emphasis.share(from[i]) != 0 || emphasis.lights(from[i])));
  }

  void emphasize(const Box& box, ValueId v) const {
    const double share = emphasis.share(v);
    const bool lit = emphasis.lights(v);
    if (share != 0 && !lit) {
      parts::fill(sheet.view, box, Role::highlight, 0.06 + 0.34 * std::min(std::abs(share), 1.0));
      const std::string text = parts::share_text(source, share);
      const double size = layout.full ? 0.74 : 0.6;
      if (layout.full || layout.values)
        parts::text(sheet.view, box.right() - 3, box.y + 14 * size, {{text}}, Role::highlight, size,
                    Label::Placement::right);
    }
    if (lit) {
      parts::fill(sheet.view, box, Role::highlight, 0.12);
      parts::outline(sheet.view, {box.x - 2, box.y - 2, box.width + 4, box.height + 4}, Role::highlight);
    }
  }

  void frame(const Box& box, ValueId v) const {
    const Box around{box.x - 1, box.y - 1, box.width + 2, box.height + 2};
    if (v == main) {
      parts::fill(sheet.view, around, Role::current, 0.25);
      parts::outline(sheet.view, around, Role::current, 0.5);
    } else if (is_operand(v)) {
      parts::fill(sheet.view, around, Role::operand, 0.22);
      parts::outline(sheet.view, around, Role::operand, 0.6, true);
    } else if (layout.full) {
      parts::outline(sheet.view, box, Role::rule_line);
    }
  }

  void words(const Scheme::Cell& cell, const Box& box) const {
    const double middle_x = box.x + box.width / 2, middle_y = box.y + box.height / 2;
    const Role role = cell.value == main ? Role::text_current : Role::text;
    if (layout.full) {
      const auto& texts = scheme.texts(source);
      const auto i = static_cast<std::size_t>(&cell - scheme.cells.data());
      parts::text(sheet.view, middle_x, middle_y - 4, texts.names[i], role, name_size, Label::Placement::centre);
      parts::text(sheet.view, middle_x, middle_y + 15, {{texts.values[i]}}, role, value_size, Label::Placement::centre);
      return;
    }
    const ValueRecord& record = source.graph->value(cell.value);
    RichText name = typeset_name(record.name, source.algorithm_at(record.step));
    // In low rows the scripts of one name keep clear of the next one's.
    const double highest = layout.row_height / parts::width_of(name_height, role, 1);
    const double size = parts::size_to_fit(parts::ems(name), role, box.width, std::min(0.9, highest));
    parts::text(sheet.view, middle_x, layout.values ? middle_y - 2 : middle_y + 5, std::move(name), role, size,
                Label::Placement::centre);
    if (!layout.values) return;
    std::string numbers;
    if (const auto& p = source.points[cell.value]) {
      numbers = "(" + format_short(p->x, 2) + ", " + format_short(p->y, 2);
      if (source.spatial()) numbers += ", " + format_short(p->z, 2);
      numbers += ")";
    } else if (record.kind == ValueKind::scalar) {
      numbers = source.value_text(cell.value);
      if (numbers.size() > 9) numbers = format_short(source.scalars[cell.value], 3);
    } else {
      return;
    }
    const double small = std::min(0.72, (box.width + 2) / (static_cast<double>(numbers.size()) * 14 * 0.55));
    parts::text(sheet.view, middle_x, middle_y + 13, {{numbers}}, Role::text_quiet, small, Label::Placement::centre);
  }

  void set(const Scheme::Cell& cell) const {
    const Box box = layout.box(cell);
    sheet.spots.push_back(
        {{Link::Kind::value, cell.value}, box.x, box.y, box.width, box.height, source.graph->name(cell.value)});
    if (!made(cell)) {  // a line to be written on
      parts::fill(sheet.view, {box.x + box.width / 4, box.y + box.height / 2 - 1, box.width / 2, 2}, Role::rule_line);
      return;
    }
    if (cell.column > 0) arrows(cell, box);
    frame(box, cell.value);
    emphasize(box, cell.value);
    words(cell, box);
  }
};

}  // namespace

TableauSize add_tableau(Sheet& sheet, const StepSource& source, std::uint32_t step, const Emphasis& emphasis, double x,
                        double y, const TableauOptions& options) {
  const Scheme* scheme = scheme_at(source, step);
  if (scheme == nullptr) return {};
  const double head = options.fit ? 22 : 0;
  const auto layout = options.fit ? fitted_layout(*scheme, options, x, y + head)
                                  : std::optional(full_layout(*scheme, scheme->texts(source), x, y + 4));
  if (!layout) return {};
  if (options.fit) parts::heading(sheet.view, x, y, "Triangular scheme");

  const ValueId value = source.graph->main_value(step);
  const ValueId main = value != absent && source.graph->is_input(value) ? absent : value;
  Setter setter{sheet, source, *scheme, *layout, emphasis, step, main, {}};
  if (main != absent) {
    const auto from = source.graph->operands(main);
    setter.operands.assign(from.begin(), from.end());
  }
  const double from_row = (options.visible_from - layout->top) / layout->row_height - 1;
  const double to_row = (options.visible_to - layout->top) / layout->row_height + 1;
  for (int column = 0; column < scheme->column_count(); ++column) {
    const auto begin =
        scheme->cells.begin() + static_cast<std::ptrdiff_t>(scheme->columns[static_cast<std::size_t>(column)]);
    const auto end =
        scheme->cells.begin() + static_cast<std::ptrdiff_t>(scheme->columns[static_cast<std::size_t>(column) + 1]);
    for (auto cell =
             std::lower_bound(begin, end, from_row, [](const Scheme::Cell&c, double row) { return c.row < row; });
         cell != end && cell->row <= to_row; ++cell) {
      const Box box = layout->box(*cell);
      if (box.bottom() >= options.visible_from && box.y <= options.visible_to) setter.set(*cell);
    }
  }
  const Box current = layout->box(scheme->current(*source.graph, step));
  const double height = scheme->rows * layout->row_height;
  return {options.fit ? options.width : layout->x.back() + layout->width.back() + 4 - x,
          options.fit ? head + height + 12 : height + 8, current.x + current.width / 2, current.y + current.height / 2};
}

}  // namespace blossom
