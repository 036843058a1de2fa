#include <algorithm>
#include <map>

#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

using parts::Box;

constexpr double indent = 14, row = 20, next_line = 15;
constexpr double title_size = 0.9, range_size = 0.76;
constexpr std::size_t most_siblings = 12;  // of which all are shown
constexpr std::size_t around = 3;          // shown before and behind the current one of more

struct Tree {
  Sheet& sheet;
  const StepSource& source;
  std::uint32_t step;
  std::vector<std::uint32_t> path;  // the phases around the step, from the outermost
  const std::vector<std::uint32_t>& open;
  double x, width;
  double at;

  const std::vector<PhaseRecord>& phases() const { return source.graph->phases(); }
  bool on_path(std::uint32_t phase) const { return std::ranges::find(path, phase) != path.end(); }
  bool in_open(std::uint32_t phase) const { return std::ranges::find(open, phase) != open.end(); }

  std::vector<std::uint32_t> children(std::uint32_t parent) const {
    std::vector<std::uint32_t> found;
    // A phase stands behind the one around it, and what is inside a phase directly behind that.
    for (std::uint32_t phase = parent == absent ? 0 : parent + 1; phase < phases().size(); ++phase) {
      if (phases()[phase].parent == parent) found.push_back(phase);
      if (parent != absent && phases()[phase].first_step > phases()[parent].last_step) break;
    }
    return found;
  }

  void quiet(int depth, const std::string& words) {
    parts::text(sheet.view, x + depth * indent + indent, at + 14, {{words}}, Role::text_quiet, title_size);
    at += row;
  }

  void entry(std::uint32_t phase, const std::string& name, int depth, bool unfolded, bool has_children) {
    View& view = sheet.view;
    const PhaseRecord& record = phases()[phase];
    const bool innermost = !path.empty() && path.back() == phase;
    const std::string range = record.first_step == record.last_step
                                  ? std::to_string(record.first_step)
                                  : std::to_string(record.first_step) + "–" + std::to_string(record.last_step);
    const double range_width = parts::width_of(parts::ems(range), Role::text_quiet, range_size);
    const double left = x + depth * indent;
    const double room = x + width - left - indent - range_width - 8;
    const double em = parts::width_of(1, Role::text, title_size);
    const auto lines = parts::wrapped(source.phase_title(phase), std::max(room / em, 4.0), on_path(phase));
    const double margin = std::min(x, 6.0);
    const Box box{x - margin, at, width + 2 * margin, row + next_line * static_cast<double>(lines.size() - 1)};
    if (innermost) {
      parts::fill(view, box, Role::current, 0.18);
      parts::fill(view, {box.x, box.y, 3, box.height}, Role::current);
    }
    sheet.spots.push_back({{Link::Kind::phase, phase}, box.x, box.y, box.width, box.height, "phase " + name});
    if (has_children) parts::text(view, left, at + 14, {{unfolded ? "▾" : "▸"}}, Role::text_quiet, title_size);
    double baseline = at + 14;
    for (const std::string& line : lines) {
      parts::text(view, left + indent, baseline, {{line, TextRun::Level::base, false, on_path(phase)}},
                  record.last_step < step && !on_path(phase) ? Role::text_quiet : Role::text, title_size);
      baseline += next_line;
    }
    parts::text(view, x + width - 2, at + 14, {{range}}, Role::text_quiet, range_size, Label::Placement::right);
    at += box.height;
  }

  // Of many siblings only those around the current one, unless their parent was unfolded on purpose. `scope` is what
  // stands in front of their names.
  void list(std::uint32_t parent, int depth, const std::string& scope) {
    const auto all = children(parent);
    std::size_t from = 0, to = all.size();
    if (all.size() > most_siblings && (parent == absent || !in_open(parent))) {
      // The one the step is in, or the next one.
      auto here = std::ranges::find_if(all, [&](std::uint32_t phase) { return phases()[phase].last_step >= step; });
      const auto middle = std::min(static_cast<std::size_t>(here - all.begin()), all.size() - 1);
      from = middle > around ? middle - around : 0;
      to = std::min(all.size(), middle + around + 1);
      if (from == 1) from = 0;  // "1 before" takes as much room as the one
      if (to + 1 == all.size()) to = all.size();
    }
    // The rows of an elimination are gone through again for each column: the second of a label is "row[2] 2".
    std::map<std::string, int> labels;
    if (from > 0) quiet(depth, "… " + std::to_string(from) + " before");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::uint32_t phase = all[i];
      const std::string label = phases()[phase].label();
      const int count = ++labels[label];
      const bool shown = (i >= from && i < to) || in_open(phase);
      if (!shown) continue;
      const bool has_children = phase + 1 < phases().size() && phases()[phase + 1].parent == phase;
      const bool unfolded = has_children && (on_path(phase) || in_open(phase));
      const std::string name = scope + label + (count > 1 ? " " + std::to_string(count) : "");
      entry(phase, name, depth, unfolded, has_children);
      if (unfolded) list(phase, depth + 1, name + ".");
    }
    if (to < all.size()) quiet(depth, "… " + std::to_string(all.size() - to) + " more");
  }
};

}  // namespace

double add_phase_tree(Sheet& sheet, const StepSource& source, std::uint32_t step,
                      const std::vector<std::uint32_t>& open, double x, double y, double width) {
  const TraceGraph& graph = *source.graph;
  if (graph.phases().empty()) return 0;
  Tree tree{sheet, source, step, graph.phase_path(graph.step(step).phase), open, x, width, y};
  tree.list(absent, 0, {});
  return tree.at - y;
}

}  // namespace blossom
