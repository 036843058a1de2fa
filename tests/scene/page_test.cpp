// The page around the geometry: title, narration, pseudo-code, formula, triangular scheme, knots.
#include <algorithm>
#include <map>
#include <set>

#include "algorithms/typeset.hpp"
#include "lesson/prose.hpp"
#include "scene/panels.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

bool shows(const View& view, const RichText& text) {
  return std::ranges::any_of(view.labels, [&](const Label& label) { return label.text == text; });
}
bool shows(const View& view, const std::string& text) {
  return std::ranges::any_of(view.labels, [&](const Label& label) { return plain_text(label.text) == text; });
}

// The cells of the triangular scheme: what the table puts there, and the points it is made from.
std::set<ValueId> scheme_of(const StepSource& source) {
  const auto& graph = *source.graph;
  const auto in_table = [&](ValueId v) {
    const auto* spec = source.algorithm->spec(graph.value(v).name);
    return spec != nullptr && spec->tableau;
  };
  std::set<ValueId> cells;
  for (ValueId v = 0; v < graph.value_count(); ++v) {
    if (graph.is_input(v) || !in_table(v) || !graph.scope(v).empty()) continue;
    cells.insert(v);
    for (const ValueId o : graph.operands(v))
      if (in_table(o) || (graph.value(v).kind == ValueKind::point && graph.value(o).kind == ValueKind::point))
        cells.insert(o);
  }
  return cells;
}

}  // namespace

TEST_CASE("Each page says its title, its step and its narration") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const Scene scene = lesson.page(step);
    REQUIRE(scene.views.size() >= 3);
    CHECK(scene.title == lesson.lesson.title.own());
    const Prose said = read_prose(lesson.narration(step));
    CHECK(scene.description == blossom::plain_text(said));
    const View& page = scene.views[0];
    CHECK(shows(page, lesson.lesson.title.own()));
    CHECK(shows(page, "step " + std::to_string(step) + " / " + std::to_string(lesson.step_count() - 1)));
    CHECK(shows(page, rich_text(said, lesson.source.algorithm_at(step))));
  });
}

TEST_CASE("Every panel lies within the page, and what it paints within the panel") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    for (const auto& [width, height] : {std::pair{640.0, 480.0}, std::pair{1120.0, 700.0}, std::pair{1920.0, 1080.0}}) {
      INFO(width << " x " << height);
      const Scene scene = lesson.page(step, width, height);
      CHECK(scene.width == width);
      CHECK(scene.height == height);
      for (const View& view : scene.views) {
        const bool inside = view.x >= 0 && view.y >= 0 && view.width > 0 && view.height > 0 &&
                            view.x + view.width <= width && view.y + view.height <= height;
        CHECK(inside);
        if (view.camera.kind != Camera::Kind::page) continue;
        for (const auto& polygon : view.polygons)
          for (const auto& at : polygon.points)
            if (at.x < -0.5 || at.y < -0.5 || at.x > view.width + 0.5 || at.y > view.height + 0.5)
              FAIL_CHECK("a polygon reaches " << at.x << ", " << at.y << " of " << view.width << " x " << view.height);
        for (const auto& label : view.labels)
          if (label.anchor.x < 0 || label.anchor.y < 0 || label.anchor.x > view.width || label.anchor.y > view.height)
            FAIL_CHECK("\"" << plain_text(label.text) << "\" stands at " << label.anchor.x << ", " << label.anchor.y);
      }
    }
  });
}

TEST_CASE("The pseudo-code is all there, its current line marked") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    Sheet sheet;
    const View& view = sheet.view;
    const double height = add_pseudo_code(sheet, lesson.source, step, {}, 0, 0, 400);
    const auto& code = lesson.source.algorithm_at(step).pseudo_code;
    const int line = lesson.source.line(step);
    CHECK(height > 18 * static_cast<double>(code.size()));
    int bold = 0;
    for (const auto& label : view.labels)
      for (const auto& run : label.text)
        if (run.monospace && run.bold) {
          ++bold;
          CHECK(run.text == code[static_cast<std::size_t>(line) - 1]);
        }
    CHECK(bold == (line > 0 ? 1 : 0));
    for (const auto text : code) CHECK(shows(view, std::string(text)));
  });
}

TEST_CASE("A page of the usual size has all of the pseudo-code") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const Scene scene = lesson.page(step);
    for (const auto text : lesson.source.algorithm_at(step).pseudo_code) {
      INFO(text);
      CHECK(shows(scene.views[2], std::string(text)));
    }
  });
}

TEST_CASE("The triangular scheme has the values made so far, and a blank for each to come") {
  int schemes = 0;
  for_each_step<double>([&](const auto& lesson, std::uint32_t step) {
    const auto cells = scheme_of(lesson.source);
    if (cells.empty()) return;  // schemes of elevation and inside of phases: panels_tableau_test.cpp
    Sheet sheet;
    const View& view = sheet.view;
    if (add_tableau(sheet, lesson.source, step, {}, 0, 0, {true, 2000, 2000}).height == 0) return;
    ++schemes;
    const auto& graph = *lesson.source.graph;
    std::size_t made = 0;
    for (const ValueId v : cells) {
      const bool is_made = graph.value(v).step <= step;
      made += is_made ? 1 : 0;
      INFO(graph.name(v));
      CHECK(shows(view, typeset_name(graph.value(v).name, *lesson.source.algorithm)) == is_made);
    }
    CHECK(std::ranges::count(view.polygons, Role::rule_line, &Polygon::role) ==
          static_cast<std::ptrdiff_t>(cells.size() - made));
    const ValueId main = graph.main_value(step);
    CHECK(std::ranges::count(view.polygons, Role::current, &Polygon::role) ==
          (cells.contains(main) && !graph.is_input(main) ? 1 : 0));
  });
  CHECK(schemes > 50);
}

TEST_CASE("A scheme that does not fit is left out, not squeezed") {
  const auto lesson = prepare<double>("de-boor");
  Sheet sheet;
  CHECK(add_tableau(sheet, lesson->source, 3, {}, 0, 0, {true, 60, 400}).height == 0);
  CHECK(add_tableau(sheet, lesson->source, 3, {}, 0, 0, {true, 400, 40}).height == 0);
  CHECK(sheet.view.labels.empty());
  CHECK(sheet.view.polygons.empty());
}

TEST_CASE("The knot line marks each knot once, with its multiplicity") {
  int lines = 0;
  for (const auto& entry : shipped_lessons().lessons) {
    const auto lesson = prepare<double>(entry);
    INFO(lesson->name);
    Sheet sheet;
    const View& view = sheet.view;
    const double height = add_knot_line(sheet, lesson->source, 0, {}, 0, 0, 700);
    const auto& curves = lesson->source.curves;
    if (curves.empty() || curves[0].bezier) {
      CHECK(height == 0);
      CHECK(view.markers.empty());
      continue;
    }
    if (curves.size() > 1) continue;  // the line of the first one
    ++lines;
    CHECK(height > 0);
    std::map<double, int> multiplicity;
    for (const double u : curves[0].knots) ++multiplicity[u];
    std::vector<double> places;
    for (const auto& marker : view.markers)
      if (marker.shape == Marker::Shape::triangle) places.push_back(marker.position.x);
    REQUIRE(places.size() == multiplicity.size());
    CHECK(std::ranges::is_sorted(places));
    CHECK(places.front() >= 0);
    CHECK(places.back() <= 700);
    auto place = places.begin();
    const double first = multiplicity.begin()->first, last = multiplicity.rbegin()->first;
    for (const auto& [u, times] : multiplicity) {
      CHECK(shows(view, format_short(u, 3) + (times > 1 ? " ×" + std::to_string(times) : "")));
      CHECK((*place++ - places.front()) / (places.back() - places.front()) ==
            Approx((u - first) / (last - first)).margin(1e-12));
    }
  }
  CHECK(lines >= 4);
}

TEST_CASE("The formula panel gives what the step makes, with names, with numbers and with its blossom value") {
  const auto lesson = prepare("de-boor");
  const auto& trace = lesson->run.trace;
  const ValueId v = *trace.find("P[1][2]");
  Sheet sheet;
  const View& view = sheet.view;
  CHECK(add_formula(sheet, lesson->source, trace.value(v).step, 0, 0, 600, 400) > 0);
  std::string all;
  for (const auto& label : view.labels) all += plain_text(label.text) + "\n";
  INFO(all);
  CHECK(all.find("P2(1) = (0, 16)") != std::string::npos);  // the published value of this example
  CHECK(all.find("(1 - 4/5) (0, 0) + 4/5 (0, 20)") != std::string::npos);
  CHECK(all.find("b(0, 1/4, 2/5)") != std::string::npos);             // between b(0, 0, 1/4) and b(0, 1/4, 1/2)
  CHECK(add_formula(sheet, lesson->source, 0, 0, 0, 600, 400) == 0);  // the step that shows the inputs makes nothing

  // With less room the last of it is left out, and nothing reaches beyond.
  Sheet small_sheet;
  const View& small = small_sheet.view;
  CHECK(add_formula(small_sheet, lesson->source, trace.value(v).step, 0, 0, 600, 75) <= 75 + 12);
  all.clear();
  for (const auto& label : small.labels) all += plain_text(label.text) + "\n";
  CHECK(all.find("P2(1) = (0, 16)") != std::string::npos);
  CHECK(all.find("b(0, 1/4, 2/5)") == std::string::npos);
}
