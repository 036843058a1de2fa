#include "player/ui/layout.hpp"

#include <algorithm>

namespace blossom {
namespace {

constexpr double gap = 6;              // between panels
constexpr double least_side = 300;     // width
constexpr double least_tabs = 170;     // height
constexpr double least_main = 200;     // width
constexpr double lowest_main = 110;    // height
constexpr double least_foot = 56;      // height
constexpr double least_window = 330;   // height
constexpr double roomy_main = 150;     // what the strip below leaves of it
constexpr double roomy_height = 400;   // of the side: enough for several panels above the tabs
constexpr double least_stacked = 120;  // height of all panels above the tabs

using Wanted = std::function<double(const Panel&, double width)>;

double sum_of(const std::vector<const Panel*>& stacked, double width, const Wanted& height) {
  double sum = 0;
  for (const Panel* panel : stacked) sum += height(*panel, width) + gap;
  return sum;
}

// How high the panels above the tabs are, with the gaps below them. Where there is too little for all, the first (the
// code) has all of its lines as long as the later ones (the formula, whose last line is the result) have what they say;
// where even that is too much, it gives way, but not below a third. With too much room, they are no higher than they
// want, unless the border is fixed.
std::vector<std::pair<const Panel*, double>> heights_of(const std::vector<const Panel*>& stacked, double width,
                                                        double room, bool fixed, const Wanted& wanted,
                                                        const Wanted& tight) {
  std::vector<std::pair<const Panel*, double>> heights;
  for (const Panel* panel : stacked) heights.emplace_back(panel, wanted(*panel, width) + gap);
  if (heights.empty()) return heights;
  const double needed = sum_of(stacked, width, wanted);
  double& first = heights.front().second;
  if (needed > room) {
    const double later = needed - first;
    const double said = later > 0 ? sum_of({stacked.begin() + 1, stacked.end()}, width, tight) : 0;
    const double least = heights.size() == 1 ? room : std::min(first, room / 3);
    const double given = std::min(std::max(said, room - first), room - least);
    for (std::size_t i = 1; i < heights.size(); ++i) heights[i].second *= given / later;
    first = room - given;
  } else if (fixed) {
    heights.back().second += room - needed;
  }
  return heights;
}

}  // namespace

Layout lay_out(const LayoutWish& wish, const std::vector<const Panel*>& panels,
               const std::function<bool(const Panel&)>& relevant,
               const std::function<double(const Panel&, double width)>& wanted,
               const std::function<double(const Panel&, double width)>& can_do_with) {
  const auto& tight = can_do_with ? can_do_with : wanted;
  Layout layout;
  const auto of_slot = [&](Slot slot) {
    std::vector<const Panel*> found;
    for (const Panel* panel : panels)
      if (panel->slot == slot && relevant(*panel)) found.push_back(panel);
    std::stable_sort(found.begin(), found.end(), [](const auto* a, const auto* b) { return a->order < b->order; });
    return found;
  };

  double top = 0, bottom = wish.height;
  for (const Panel* panel : of_slot(Slot::bar)) {
    const double height = wanted(*panel, wish.width);
    layout.placed.push_back({panel, {0, top, wish.width, height}});
    top += height;
  }
  if (wish.page) {
    for (const Panel* panel : of_slot(Slot::page)) layout.placed.push_back({panel, {0, top, wish.width, bottom - top}});
    return layout;
  }
  // Where there is hardly any height, the words are a tab, too; the way to move stays.
  auto foot = of_slot(Slot::foot);
  if (wish.height < least_window && foot.size() > 1) {
    layout.tabbed.assign(foot.begin(), foot.end() - 1);
    foot.erase(foot.begin(), foot.end() - 1);
  }
  for (auto panel = foot.rbegin(); panel != foot.rend(); ++panel) {
    // The words below the picture may take a third of what there is; the way to move has what it needs.
    const double most = panel == foot.rbegin() ? bottom - top : std::max((bottom - top) / 3, least_foot);
    const double height = std::clamp(most, 0.0, wanted(**panel, wish.width));
    bottom -= height;
    layout.placed.push_back({*panel, {0, bottom, wish.width, height}});
  }
  bottom -= gap;
  top += gap;

  // The side, unless the window is too narrow for two columns.
  const double room = wish.width - 3 * gap;
  const double side_width = std::clamp(wish.side_share * room, least_side, std::max(least_side, room - least_main));
  const double side_height = std::max(bottom - top, 0.0);
  const bool has_side = room - side_width >= least_main && side_height >= lowest_main;
  const double main_width = has_side ? room - side_width : room + gap;
  double main_bottom = bottom;

  auto stacked = of_slot(Slot::side);
  const auto tabs = of_slot(Slot::tabs);
  layout.tabbed.insert(layout.tabbed.end(), tabs.begin(), tabs.end());
  const auto main = of_slot(Slot::main);
  if (!has_side || side_height < roomy_height) {  // all of them are tabs
    layout.tabbed.insert(layout.tabbed.begin(), stacked.begin(), stacked.end());
    stacked.clear();
  }
  if (has_side) {
    const double x = gap + main_width + gap;
    layout.side = {x, top, side_width, side_height};
    layout.side_x = x - gap;
    double y = top;
    double lower = stacked.empty() ? side_height
                                   : std::clamp(wish.lower_share * side_height, least_tabs,
                                                std::max(least_tabs, side_height - least_stacked));
    // What the panels above miss comes from what the tab does not need.
    const auto active = std::ranges::find(tabs, wish.tab, &Panel::id);
    if (!stacked.empty() && !wish.lower_fixed && active != tabs.end() && (*active)->tight != nullptr) {
      const double missing = sum_of(stacked, side_width, tight) - (side_height - lower);
      const double spare = lower - std::max(least_tabs, tight(**active, side_width));
      lower -= std::clamp(missing, 0.0, std::max(spare, 0.0));
    }
    for (const auto& [panel, height] :
         heights_of(stacked, side_width, side_height - lower, wish.lower_fixed, wanted, tight)) {
      layout.placed.push_back({panel, {x, y, side_width, std::max(height - gap, 0.0)}});
      y += height;
    }
    layout.lower_y = y;
    layout.tabs = {x, y, side_width, bottom - y};
  } else if (side_height < lowest_main + gap + least_tabs) {
    // Not even room for the picture above the tabs: it is one of them.
    layout.tabbed.insert(layout.tabbed.begin(), main.begin(), main.end());
    const auto strip = of_slot(Slot::strip);
    layout.tabbed.insert(layout.tabbed.end(), strip.begin(), strip.end());
    layout.tabs = {gap, top, std::max(wish.width - 2 * gap, 0.0), side_height};
    return layout;
  } else {
    // One column: the picture above, the tabs below it.
    const double tabs_height = std::max(least_tabs, side_height * 0.45);
    main_bottom = bottom - tabs_height - gap;
    layout.tabs = {gap, main_bottom + gap, wish.width - 2 * gap, tabs_height};
  }

  // The strip takes at most 40 % of the picture's height, its last panels going first.
  const auto strip = of_slot(Slot::strip);
  double strip_room = std::min((main_bottom - top) * 0.4, main_bottom - top - roomy_main);
  std::vector<std::pair<const Panel*, double>> kept;
  for (const Panel* panel : strip) {
    const double height = std::min(wanted(*panel, main_width), strip_room);
    if (height < panel->least) {
      layout.tabbed.push_back(panel);
      continue;
    }
    kept.emplace_back(panel, height);
    strip_room -= height;
  }
  // The most important stands lowest.
  for (const auto& [panel, height] : kept) {
    main_bottom -= height;
    layout.placed.push_back({panel, {gap, main_bottom, main_width, height}});
  }
  for (const Panel* panel : main)
    layout.placed.push_back({panel, {gap, top, main_width, main_bottom - top - (kept.empty() ? 0 : gap)}});
  return layout;
}

}  // namespace blossom
