// Points as tables: a row a point, 2 or 3 numbers (of curves a fourth, the weight), separated by comma, semicolon, tab
// or blanks. An empty line ends a row of points; several rows of equally many points are a net. A first line that is no
// numbers is a heading.

#include <algorithm>

#include "exchange/exchange_mesh.hpp"
#include "exchange/exchange_text.hpp"

namespace blossom {
namespace {

using namespace exchange;

constexpr std::size_t most_points = 65'536;

std::vector<std::string_view> cells_of(std::string_view line) {
  // In a table with semicolons or tabs a comma is a decimal point in some countries; here numbers have dots.
  for (const std::string_view separator : {";", "\t", ","})
    if (line.find(separator) != std::string_view::npos) return split(line, separator == "," ? ", " : separator);
  return split(line, " ");
}

struct Block {
  std::vector<HPoint<Exact>> points;
};

Checked<Imported> import(const std::string& name, std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  Diagnostics wrong;
  std::vector<Block> blocks;
  std::size_t columns = 0, count = 0;
  bool open = false, heading = true;
  Lines lines(bytes);
  for (std::string_view line; lines.next(line);) {
    auto cells = cells_of(line);
    for (auto& cell : cells) {
      const auto from = cell.find_first_not_of(" \t\""), to = cell.find_last_not_of(" \t\"");
      cell = from == std::string_view::npos ? std::string_view() : cell.substr(from, to - from + 1);
    }
    if (cells.empty() || std::ranges::all_of(cells, [](auto cell) { return cell.empty(); })) {
      open = false;
      continue;
    }
    if (cells.front().starts_with('#')) continue;
    std::vector<Exact> numbers;
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (auto x = Exact::parse(cells[c])) numbers.push_back(std::move(*x));
    if (std::exchange(heading, false) && numbers.empty()) continue;
    const auto error = [&](std::string message) {
      if (wrong.size() < 100) wrong.push_back({name, lines.number(), 1, "", std::move(message)});
    };
    if (numbers.size() != cells.size()) {
      error("must be numbers such as 2/5, -0.5 or 3, with a dot before decimals");
      continue;
    }
    if (numbers.size() != 2 && numbers.size() != 3) {
      error("must have 2 or 3 numbers, not " + std::to_string(numbers.size()));
      continue;
    }
    if (columns == 0) columns = numbers.size();
    if (numbers.size() != columns) {
      error("must have " + std::to_string(columns) + " numbers, as the first point has");
      continue;
    }
    if (++count > most_points) return Diagnostics{{name, lines.number(), 1, "", "has more than 65,536 points"}};
    if (!std::exchange(open, true)) blocks.emplace_back();
    blocks.back().points.emplace_back(numbers[0], numbers[1], columns == 3 ? numbers[2] : Exact(0), Exact(1));
  }
  if (!wrong.empty()) return wrong;
  Imported made;
  if (blocks.empty()) return made;
  SceneObject object;
  const std::size_t first = blocks.front().points.size();
  const bool net = blocks.size() > 1 && first > 1 &&
                   std::ranges::all_of(blocks, [&](const Block& b) { return b.points.size() == first; });
  if (net) {
    PointNet<Exact> points{static_cast<int>(blocks.size()), static_cast<int>(first), {}};
    for (Block& block : blocks) std::ranges::move(block.points, std::back_inserter(points.points));
    object.name = "net";
    object.geometry = std::move(points);
    made.objects.push_back(std::move(object));
    return made;
  }
  for (std::size_t b = 0; b < blocks.size() && b < most_objects; ++b) {
    object.name = blocks.size() == 1 ? "points" : "points " + std::to_string(b + 1);
    object.geometry = PointRow<Exact>{std::move(blocks[b].points), static_cast<int>(columns)};
    made.objects.push_back(object);
  }
  if (blocks.size() > most_objects) made.notes.push_back("only the first 1000 rows of points are taken");
  return made;
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  Exported made;
  bool weights = false, knots = false, first = true;
  for (const SceneObject* object : chosen(scene, options)) {
    const auto row = [&](const HPoint<Exact>& P, int dimension) {
      const double w = P.w.to_double();
      weights = weights || w != 1;
      const double scale = w == 0 ? 1 : w;
      made.bytes +=
          decimal(P.x.to_double() / scale, options.digits) + "," + decimal(P.y.to_double() / scale, options.digits);
      if (dimension == 3) made.bytes += "," + decimal(P.z.to_double() / scale, options.digits);
      made.bytes += "\n";
    };
    if (!std::exchange(first, false)) made.bytes += "\n";
    if (const auto* curve = std::get_if<Curve<Exact>>(&object->geometry)) {
      knots = true;
      for (const auto& P : curve->points) row(P, curve->dimension);
    } else if (const auto* points = std::get_if<PointRow<Exact>>(&object->geometry)) {
      for (const auto& P : points->points) row(P, points->dimension);
    } else {
      const auto grid = [&](const auto& g) {
        for (int i = 0; i < g.rows; ++i) {
          if (i > 0) made.bytes += "\n";
          for (int j = 0; j < g.columns; ++j) row(g.at(i, j), 3);
        }
      };
      if (const auto* surface = std::get_if<Surface<Exact>>(&object->geometry)) {
        knots = true;
        grid(*surface);
      } else {
        grid(std::get<PointNet<Exact>>(object->geometry));
      }
    }
  }
  if (knots) made.notes.push_back("only control points are written, without degrees and knots");
  if (weights) made.notes.push_back("weights are left out");
  return made;
}

}  // namespace

const ExchangeFormat& format_csv() {
  static const ExchangeFormat format{"csv",
                                     "Points as a table (CSV)",
                                     {".csv", ".tsv", ".xyz"},
                                     "Points in rows and nets; of curves and surfaces the control points",
                                     import,
                                     write};
  return format;
}

}  // namespace blossom
