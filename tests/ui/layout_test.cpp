// Where panels stand, for windows of every size and every size of text.
#include "player/ui/layout.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <random>

using namespace blossom;

namespace {

// Panels as the window has them, with made-up heights.
struct Furniture {
  std::vector<Panel> panels;
  std::vector<const Panel*> all;
  std::map<const Panel*, double> heights;
  std::map<const Panel*, bool> relevant;

  Layout lay(const LayoutWish& wish) const {
    return lay_out(
        wish, all, [&](const Panel& p) { return relevant.at(&p); },
        [&](const Panel& p, double) { return heights.at(&p); });
  }
  std::vector<const Panel*> of(Slot slot) const {
    std::vector<const Panel*> found;
    for (const Panel* panel : all)
      if (panel->slot == slot && relevant.at(panel)) found.push_back(panel);
    return found;
  }
};

struct Piece {
  std::string_view id;
  Slot slot;
  int order;
  double low, high;  // of its height
  double least;
};
constexpr Piece pieces[] = {
    {"menu", Slot::bar, 0, 24, 44, 0},       {"viewport", Slot::main, 0, 0, 0, 0},
    {"knots", Slot::strip, 1, 70, 130, 60},  {"basis", Slot::strip, 2, 90, 260, 80},
    {"formula", Slot::side, 1, 60, 400, 0},  {"pseudo_code", Slot::side, 2, 60, 600, 0},
    {"tableau", Slot::tabs, 1, 200, 200, 0}, {"inputs", Slot::tabs, 2, 200, 200, 0},
    {"why", Slot::tabs, 3, 200, 200, 0},     {"narration", Slot::foot, 1, 40, 300, 0},
    {"timeline", Slot::foot, 2, 60, 110, 0}, {"start", Slot::page, 0, 0, 0, 0},
    {"dialogs", Slot::float_, 0, 0, 0, 0},
};

Furniture furniture(std::mt19937& random) {
  Furniture made;
  for (const Piece& piece : pieces) {
    Panel panel{piece.id, piece.id, piece.slot, piece.order, nullptr};
    panel.least = piece.least;
    made.panels.push_back(panel);
  }
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (std::size_t i = 0; i < made.panels.size(); ++i) {
    const Panel* panel = &made.panels[i];
    made.all.push_back(panel);
    made.heights[panel] = between(pieces[i].low, pieces[i].high);
    const bool may_be_missing = panel->slot == Slot::strip || panel->slot == Slot::side || panel->id == "why";
    made.relevant[panel] = !may_be_missing || between(0, 1) < 0.8;
  }
  return made;
}

bool overlap(const PixelRect& a, const PixelRect& b) {
  constexpr double slack = 1e-6;
  return a.x < b.right() - slack && b.x < a.right() - slack && a.y < b.bottom() - slack && b.y < a.bottom() - slack;
}

std::string text_of(const PixelRect& r) {
  return std::to_string(r.x) + ", " + std::to_string(r.y) + ", " + std::to_string(r.width) + " x " +
         std::to_string(r.height);
}

void check(const Furniture& room, const LayoutWish& wish) {
  const Layout layout = room.lay(wish);
  std::vector<std::pair<std::string, PixelRect>> rects;
  for (const Placed& placed : layout.placed) rects.emplace_back(placed.panel->id, placed.rect);
  if (layout.tabs.height > 0) rects.emplace_back("tabs", layout.tabs);
  for (const auto& [id, rect] : rects) {
    INFO(id << ": " << text_of(rect));
    CHECK(rect.width >= 0);
    CHECK(rect.height >= 0);
    CHECK(rect.x >= -1e-6);
    CHECK(rect.y >= -1e-6);
    CHECK(rect.right() <= wish.width + 1e-6);
    CHECK(rect.bottom() <= wish.height + 1e-6);
  }
  for (std::size_t i = 0; i < rects.size(); ++i)
    for (std::size_t j = i + 1; j < rects.size(); ++j) {
      INFO(rects[i].first << ": " << text_of(rects[i].second) << "\n"
                          << rects[j].first << ": " << text_of(rects[j].second));
      CHECK_FALSE(overlap(rects[i].second, rects[j].second));
    }
  // Each is in one place; but for the strip, which may go.
  const auto times = [&](const Panel* panel) {
    return std::ranges::count(layout.placed, panel, &Placed::panel) + std::ranges::count(layout.tabbed, panel);
  };
  for (const Panel* panel : room.all) {
    INFO(panel->id);
    const bool here = room.relevant.at(panel) && panel->slot != Slot::float_ &&
                      (wish.page ? panel->slot == Slot::bar || panel->slot == Slot::page : panel->slot != Slot::page);
    if (panel->slot == Slot::strip)
      CHECK(times(panel) <= (here ? 1 : 0));
    else
      CHECK(times(panel) == (here ? 1 : 0));
  }
}

const Placed& placed(const Layout& layout, std::string_view id) {
  const auto found = std::ranges::find_if(layout.placed, [&](const Placed& p) { return p.panel->id == id; });
  INFO(id);
  REQUIRE(found != layout.placed.end());
  return *found;
}

}  // namespace

TEST_CASE("Panels neither overlap nor leave the window, whatever its size and that of the text") {
  const unsigned seed = std::random_device{}();
  std::mt19937 random(seed);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  for (int i = 0; i < 3000; ++i) {
    const Furniture room = furniture(random);
    // The smallest window is 480 by 360; a unit is as many pixels as the text is large.
    const double text = i % 2 == 0 ? 1 : between(0.75, 3);
    LayoutWish wish{between(480, 4000) / text, between(360, 2400) / text, between(0.2, 0.6), between(0.2, 0.8),
                    i % 10 == 9};
    INFO("seed " << seed << ", window " << i << ": " << wish.width << " x " << wish.height << " units, text " << text
                 << ", side " << wish.side_share << ", lower " << wish.lower_share);
    check(room, wish);
  }
}

TEST_CASE("The picture has room in every usual window") {
  std::mt19937 random(5);
  for (const auto& [width, height] :
       {std::pair(1280, 720), {1366, 768}, {1920, 1080}, {1024, 768}, {2560, 1440}, {3840, 2160}})
    for (const double text : {0.75, 1.0, 1.25, 1.5}) {
      const Furniture room = furniture(random);
      INFO(width << " x " << height << ", text " << text);
      const Layout layout = room.lay({width / text, height / text, 0.4, 0.55, false});
      const PixelRect& picture = placed(layout, "viewport").rect;
      CHECK(picture.width >= 0.3 * width / text);
      CHECK(picture.height >= 0.2 * height / text);
    }
}

TEST_CASE("What is at the side of a large window becomes tabs in a small one") {
  std::mt19937 random(5);
  Furniture room = furniture(random);
  for (auto& [panel, is] : room.relevant) is = true;
  const auto tabs = room.of(Slot::tabs).size(), side = room.of(Slot::side).size();
  const auto strips_among = [&](const Layout& layout) {  // those that have no room below the picture
    return static_cast<std::size_t>(
        std::ranges::count(layout.tabbed, Slot::strip, [](const Panel* panel) { return panel->slot; }));
  };
  CHECK(room.lay({1920, 1080}).tabbed.size() == tabs);
  for (const auto& [width, height] : {std::pair(640, 360), {480, 900}}) {
    const Layout layout = room.lay({static_cast<double>(width), static_cast<double>(height)});
    CHECK(layout.tabbed.size() == tabs + side + strips_among(layout));
  }
  CHECK(room.lay({480, 900}).side.width == 0);
}

TEST_CASE("What the panels above the tabs do not need is the tabs', unless one has put the border somewhere") {
  std::mt19937 random(5);
  Furniture room = furniture(random);
  for (auto& [panel, is] : room.relevant) is = true;
  for (auto& [panel, height] : room.heights) {
    if (panel->id == "formula") height = 90;
    if (panel->id == "pseudo_code") height = 160;
  }
  LayoutWish wish{1920, 1080, 0.4, 0.4};
  const Layout free = room.lay(wish);
  CHECK(placed(free, "formula").rect.height == Approx(90));
  CHECK(placed(free, "pseudo_code").rect.height == Approx(160));
  CHECK(free.tabs.height > 0.6 * free.side.height);
  CHECK(free.tabs.bottom() == Approx(free.side.bottom()));
  wish.lower_fixed = true;
  CHECK(room.lay(wish).tabs.height == Approx(0.4 * free.side.height));
}

TEST_CASE("Where there is little room above the tabs, the first panel gives way, and keeps a third") {
  std::mt19937 random(5);
  Furniture room = furniture(random);
  for (auto& [panel, is] : room.relevant) is = true;
  const auto heights = [&](double first, double second) {  // by order: the formula, then the code
    for (auto& [panel, height] : room.heights) {
      if (panel->id == "formula") height = first;
      if (panel->id == "pseudo_code") height = second;
    }
    const Layout layout = room.lay({1920, 1080, 0.4, 0.7, false, false});
    CHECK(layout.tabs.height == Approx(0.7 * layout.side.height));
    return std::pair(placed(layout, "formula").rect.height, placed(layout, "pseudo_code").rect.height);
  };
  const auto [code, result] = heights(600, 100);
  CHECK(result == Approx(100));
  CHECK(code < 600);
  const auto [a, b] = heights(600, 600);
  CHECK(a + 6 == Approx((a + b + 12) / 3));
}

TEST_CASE("The tab that needs little gives the panels above it what they miss") {
  Panel code{.id = "code", .title = "", .slot = Slot::side, .order = 10, .draw = nullptr};
  Panel formula{.id = "formula", .title = "", .slot = Slot::side, .order = 20, .draw = nullptr};
  Panel tab{.id = "questions", .title = "", .slot = Slot::tabs, .order = 10, .draw = nullptr};
  Panel picture{.id = "viewport", .title = "", .slot = Slot::main, .order = 0, .draw = nullptr};
  tab.tight = [](const Ui&, double) { return 190.0; };
  const auto wanted = [&](const Panel& panel, double) { return &panel == &code ? 160.0 : 134.0; };
  const auto tight = [&](const Panel& panel, double) {
    return &panel == &code ? 160.0 : &panel == &tab ? 190.0 : 80.0;
  };
  LayoutWish wish{.width = 1280, .height = 500, .lower_share = 0.62};
  wish.tab = "questions";
  const Layout layout = lay_out(
      wish, {&code, &formula, &tab, &picture}, [](const Panel&) { return true; }, wanted, tight);
  CHECK(placed(layout, "code").rect.height == Approx(160));
  CHECK(placed(layout, "formula").rect.height == Approx(80));
  CHECK(layout.tabs.height >= 190);
}

TEST_CASE("In a low window the picture is a tab, too") {
  std::mt19937 random(5);
  const Furniture room = furniture(random);
  const Layout layout = room.lay({1280 / 3.0, 720 / 3.0});
  REQUIRE_FALSE(layout.tabbed.empty());
  CHECK(layout.tabbed.front()->id == "viewport");
  CHECK(layout.tabs.height > 40);
}

TEST_CASE("The start page has the whole window below the menu") {
  std::mt19937 random(5);
  const Furniture room = furniture(random);
  const Layout layout = room.lay({1280, 720, 0.4, 0.55, true});
  REQUIRE(layout.placed.size() == 2);
  const PixelRect& menu = placed(layout, "menu").rect;
  const PixelRect& page = placed(layout, "start").rect;
  CHECK(page.y == Approx(menu.bottom()));
  CHECK(page.bottom() == Approx(720));
  CHECK(page.width == Approx(1280));
}
