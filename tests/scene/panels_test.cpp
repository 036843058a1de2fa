// Pseudo-code, knot line, basis functions and phase tree: their spots, what is marked and what is lit.
#include <map>
#include <numeric>

#include "kernel/evaluate.hpp"
#include "scene/panels_sheet.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double widths[] = {300, 420, 600};

}  // namespace

TEST_CASE("Every line of the pseudo-code has its spot at every width; the current one alone is bold") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const auto& code = lesson.source.algorithm_at(step).pseudo_code;
    const int current = lesson.source.line(step);
    for (const double width : widths) {
      INFO("width " << width);
      Sheet sheet;
      const double height = add_pseudo_code(sheet, lesson.source, step, {}, 8, 0, width - 16);
      check_spots(sheet, width, height);
      REQUIRE(sheet.spots.size() == code.size());
      std::string letters, expected;  // all of it is there, however it is broken
      for (std::size_t i = 0; i < code.size(); ++i) {
        const Spot& spot = sheet.spots[i];
        CHECK(spot.link == Link{Link::Kind::line, static_cast<std::uint32_t>(i + 1)});
        CHECK(spot.name == "line " + std::to_string(i + 1));
        expected += code[i];
        for (const Label& label : sheet.view.labels) {
          const bool in_line = label.anchor.y > spot.y && label.anchor.y < spot.y + spot.height;
          if (!in_line || label.role != Role::text) continue;
          letters += plain_text(label.text);
          CHECK(label.text[0].bold == (static_cast<int>(i) + 1 == current));
        }
      }
      std::erase(letters, ' ');
      std::erase(expected, ' ');
      CHECK(letters == expected);
      CHECK(count_role(sheet.view, Role::current) == (current > 0 ? 2 : 0));  // the tint and the bar
    }
  });
}

TEST_CASE("A lit line of the pseudo-code is framed") {
  const auto lesson = prepare<double>("de-boor");
  Emphasis emphasis;
  emphasis.line = 4;
  Sheet sheet;
  add_pseudo_code(sheet, lesson->source, 3, emphasis, 0, 0, 500);
  CHECK(count_role(sheet.view, Role::highlight) == 2);
  const Spot& spot = *spot_named(sheet, "line 4");
  const auto frame = std::ranges::find(sheet.view.polylines, Role::highlight, &Polyline::role);
  CHECK(frame->points[0].y > spot.y);
  CHECK(frame->points[2].y < spot.y + spot.height);
}

TEST_CASE("The knot line has a spot for each distinct knot and for u, which do not overlap") {
  int lines = 0;
  for_each_step<Exact>([&](const auto& lesson, std::uint32_t step) {
    for (std::size_t which = 0; which < lesson.source.curves.size(); ++which)
      for (const double width : widths) {
        INFO("curve " << which << ", width " << width);
        const auto& curve = lesson.source.curves[which];
        Sheet sheet;
        const double height = add_knot_line(sheet, lesson.source, step, {}, 0, 0, width, which, true);
        ++lines;
        check_spots(sheet, width, height);
        std::map<double, std::size_t> first;
        for (std::size_t i = curve.knots.size(); i-- > 0;) first[curve.knots[i]] = i;
        const auto axis = knot_axis(lesson.source, which, 0, width);
        REQUIRE(axis);
        for (const auto& [u, i] : first) {
          const Spot* spot = spot_named(sheet, "knot " + std::to_string(i));
          REQUIRE(spot != nullptr);
          CHECK(spot->link == Link{Link::Kind::knot, static_cast<std::uint32_t>(i)});
          CHECK(spot->x <= axis->place(u));
          CHECK(axis->place(u) <= spot->x + spot->width);
          CHECK(axis->parameter(axis->place(u)) == Approx(u).margin(1e-12));
        }
        const bool has_u = lesson.source.parameter.has_value();
        CHECK((spot_named(sheet, "u") != nullptr) == has_u);
        CHECK(sheet.spots.size() == first.size() + (has_u ? 1 : 0));
      }
  });
  CHECK(lines > 300);
}

TEST_CASE("The knots of a Bezier curve are shown only where they are asked for") {
  const auto lesson = prepare<Exact>("de-casteljau");
  Sheet sheet;
  CHECK(add_knot_line(sheet, lesson->source, 0, {}, 0, 0, 500) == 0);
  CHECK(sheet.view.labels.empty());
  CHECK(add_knot_line(sheet, lesson->source, 0, {}, 0, 0, 500, 0, true) > 0);
  CHECK(shows(sheet, "0 ×4"));
  CHECK(shows(sheet, "1 ×4"));
  CHECK(add_knot_line(sheet, lesson->source, 0, {}, 0, 0, 500, 1, true) == 0);  // there is no second curve
}

TEST_CASE("A lit knot is highlighted where it stands") {
  const auto lesson = prepare<Exact>("de-boor");
  Emphasis emphasis;
  emphasis.lit = {*lesson->run.trace.find("U[5]")};
  Sheet sheet;
  add_knot_line(sheet, lesson->source, 0, emphasis, 0, 0, 500);
  const auto axis = knot_axis(lesson->source, 0, 0, 500);
  const auto ring = std::ranges::find(sheet.view.markers, Role::highlight, &Marker::role);
  REQUIRE(ring != sheet.view.markers.end());
  CHECK(ring->position.x == Approx(axis->place(0.5)));
  CHECK(count_role(sheet.view, Role::highlight) == 1);
}

TEST_CASE("The basis functions not zero at u are named with their values, which pile up to 1") {
  int bars = 0;
  for (const auto& entry : shipped_lessons().lessons) {
    const auto lesson = prepare<double>(entry);
    if (!lesson->source.parameter || lesson->source.curves.size() != 1) continue;
    const auto& curve = lesson->source.curves[0];
    for (const double width : widths) {
      INFO(lesson->name << ", width " << width);
      Sheet sheet;
      CHECK(add_basis(sheet, lesson->source, 0, {}, 0, 0, width, 200) == 200);
      check_spots(sheet, width, 200);
      ++bars;
      // The share of P_i in the curve's point, by moving P_i alone: another way than the panel's.
      const auto at = [&](const Curve<double>& c) { return homogeneous_point(c, *lesson->source.parameter); };
      double sum = 0;
      int nonzero = 0;
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        auto moved = curve;
        moved.points[i].x += moved.points[i].w;
        const double share = (at(moved).x - at(curve).x) / at(curve).w;
        if (std::abs(share) < 0.0005) continue;
        ++nonzero;
        sum += share;
        const std::string letter = curve.rational ? "R" : curve.bezier ? "B" : "N";
        const std::string name = letter + std::to_string(i) + "," + std::to_string(curve.degree);
        CHECK(shows(sheet, name));  // at its peak
        CHECK(shows(sheet, name + " " + format_short(share, 3)));
        CHECK(spot_named(sheet, "basis " + std::to_string(i)) != nullptr);
        if (share > 0.03) CHECK(spot_named(sheet, "basis " + std::to_string(i) + " at u") != nullptr);
      }
      CHECK(sum == Approx(1));
      CHECK(shows(sheet, "sum = 1"));
      // A dot at u on each of them.
      const auto axis = knot_axis(lesson->source, 0, 0, width - basis_bar_room);
      CHECK(std::ranges::count_if(sheet.view.markers, [&](const Marker& dot) {
              return std::abs(dot.position.x - axis->place(*lesson->source.parameter)) < 1e-9;
            }) == nonzero);
    }
  }
  CHECK(bars >= 15);
}

TEST_CASE("Each basis function is a curve over its own knots, above the axis of the knot line") {
  for (const char* id : {"de-boor", "de-boor-unclamped", "de-boor-nurbs"}) {
    const auto lesson = prepare<double>(id);
    INFO(id);
    const auto& curve = lesson->source.curves[0];
    Sheet sheet;
    add_basis(sheet, lesson->source, 0, {}, 0, 0, 600, 200);
    const auto axis = knot_axis(lesson->source, 0, 0, 600 - basis_bar_room);
    std::multiset<std::pair<long, long>> expected, drawn;
    const auto key = [](double a, double b) { return std::pair{std::lround(a * 1000), std::lround(b * 1000)}; };
    const auto p = static_cast<std::size_t>(curve.degree);
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      expected.insert(key(axis->place(curve.knots[i]), axis->place(curve.knots[i + p + 1])));
    for (const Polyline& line : sheet.view.polylines)
      if (line.points.size() > 4 && !line.closed) drawn.insert(key(line.points.front().x, line.points.back().x));
    CHECK(drawn == expected);
  }
}

TEST_CASE("A lit control point lights its basis function") {
  const auto lesson = prepare<double>("de-boor");
  Emphasis emphasis;
  emphasis.lit = {*lesson->run.trace.find("P[0][2]")};
  Sheet sheet;
  add_basis(sheet, lesson->source, 0, emphasis, 0, 0, 600, 200);
  const auto lit = std::ranges::find(sheet.view.polylines, Role::highlight, &Polyline::role);
  REQUIRE(lit != sheet.view.polylines.end());
  const auto axis = knot_axis(lesson->source, 0, 0, 600 - basis_bar_room);
  CHECK(lit->points.front().x == Approx(axis->place(0)));  // N_{2,3} lives on [u_2, u_6]
  CHECK(lit->points.back().x == Approx(axis->place(0.75)));
}

TEST_CASE("The phase tree opens what is around the step, and what it is asked to") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const TraceGraph& graph = lesson.run.trace;
    Sheet sheet;
    const double height = add_phase_tree(sheet, lesson.source, step, {}, 0, 0, 360);
    if (graph.phases().empty()) {
      CHECK(height == 0);
      return;
    }
    check_spots(sheet, 360, height);
    // Of more than twelve siblings only some are listed, the one around the step among them.
    std::set<std::uint32_t> shown, possible, expected;
    for (const Spot& spot : sheet.spots) shown.insert(spot.link.id);
    const auto path = graph.phase_path(graph.step(step).phase);
    for (std::uint32_t phase = 0; phase < graph.phases().size(); ++phase) {
      const std::uint32_t parent = graph.phases()[phase].parent;
      if (parent != absent && std::ranges::find(path, parent) == path.end()) continue;
      possible.insert(phase);
      const bool is_around = std::ranges::find(path, phase) != path.end();
      if (is_around || std::ranges::count(graph.phases(), parent, &PhaseRecord::parent) <= 12) expected.insert(phase);
    }
    CHECK(std::ranges::includes(shown, expected));
    CHECK(std::ranges::includes(possible, shown));
    CHECK(count_role(sheet.view, Role::current) == (path.empty() ? 0 : 2));
  });
  const auto lesson = prepare<double>("skinning");
  const auto& phases = lesson->run.trace.phases();
  Sheet closed, open;
  add_phase_tree(closed, lesson->source, 0, {}, 0, 0, 360);
  add_phase_tree(open, lesson->source, 0, {0}, 0, 0, 360);
  const auto children = std::ranges::count(phases, 0u, &PhaseRecord::parent);
  CHECK(children > 0);
  CHECK(open.spots.size() == closed.spots.size() + static_cast<std::size_t>(children));
  CHECK(shows(open, std::to_string(phases[0].first_step) + "–" + std::to_string(phases[0].last_step)));
}

TEST_CASE("Of many phases in a row only those around the step are listed, unless they are asked for") {
  Inputs<Exact> inputs;
  Curve<Exact> curve;
  curve.degree = 2;
  for (int i = 0; i < 30; ++i) curve.points.push_back({Exact(i), Exact(i * i % 7), Exact(0), Exact(1)});
  for (int i = 0; i < 33; ++i) curve.knots.push_back(Exact(std::clamp(i - 2, 0, 28)));
  inputs.values["curve"] = curve;
  inputs.values["times"] = 1;
  const auto run = record<double>(*find_algorithm("degree_elevation"), inputs);
  REQUIRE(run);
  const Narrator<double> narrator(*run, 6);
  const StepSource source = make_source(narrator);
  const auto& phases = run->trace.phases();
  const auto siblings = static_cast<std::size_t>(std::ranges::count(phases, 0u, &PhaseRecord::parent));
  REQUIRE(siblings == 27);  // one knot to insert for each but the last of 28 segments
  const auto middle = static_cast<std::uint32_t>(14);
  Sheet sheet;
  const double height = add_phase_tree(sheet, source, phases[middle].last_step, {}, 0, 0, 360);
  check_spots(sheet, 360, height);
  CHECK(sheet.spots.size() < 12);
  CHECK(std::ranges::any_of(sheet.spots, [&](const Spot& spot) { return spot.link.id == middle; }));
  CHECK(shows(sheet, "… 10 before"));
  CHECK(shows(sheet, "… 10 more"));
  Sheet unfolded;
  add_phase_tree(unfolded, source, phases[middle].last_step, {0}, 0, 0, 360);
  for (std::uint32_t phase = 1; phase <= siblings; ++phase)
    CHECK(std::ranges::any_of(unfolded.spots, [&](const Spot& spot) { return spot.link.id == phase; }));
}
