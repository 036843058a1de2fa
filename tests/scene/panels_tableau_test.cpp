// The triangular computing scheme: which one a step shows, what stands in it, what is marked, and its LaTeX.
#include "algorithms/typeset.hpp"
#include "scene/panels_sheet.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const TableauOptions scrolled{false, 0, 0};

// The values that the step's scheme should make: by the definition, without the panel's own bookkeeping.
std::set<ValueId> cells_made_in_part(const StepSource& source, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  const auto algorithm_of_value = [&](ValueId v) { return &source.algorithm_at(graph.value(v).step); };
  std::set<ValueId> cells;
  const Algorithm* algorithm = &source.algorithm_at(step);
  // The innermost phase that is an algorithm; its own first step belongs to what is around it.
  std::uint32_t part = absent;
  for (const std::uint32_t phase : graph.phase_path(graph.step(step).phase))
    if (!graph.phases()[phase].algorithm.empty() && graph.phases()[phase].first_step != step) part = phase;
  for (ValueId v = 0; v < graph.value_count(); ++v) {
    if (graph.is_input(v) || algorithm_of_value(v) != algorithm) continue;
    if (part != absent && (graph.value(v).step <= graph.phases()[part].first_step ||
                           graph.value(v).step > graph.phases()[part].last_step))
      continue;
    const std::string_view rule = graph.value(v).rule->name;
    const ValueSpec* spec = algorithm->spec(graph.value(v).name);
    if (algorithm->id == "degree_elevation" ? rule == "elevate" || rule == "elevate_end"
                                            : spec != nullptr && spec->tableau)
      cells.insert(v);
  }
  return cells;
}

bool is_in_table(const StepSource& source, ValueId v) {
  const ValueRecord& record = source.graph->value(v);
  const ValueSpec* spec = source.algorithm_at(record.step).spec(record.name);
  return spec != nullptr && spec->tableau;
}

}  // namespace

TEST_CASE("A step's scheme is that of the part it is in, with the points it starts from") {
  int nested = 0;
  for_each_step<double>([&](const auto& lesson, std::uint32_t step) {
    const TraceGraph& graph = lesson.run.trace;
    const auto made = cells_made_in_part(lesson.source, step);
    Sheet sheet;
    const auto size = add_tableau(sheet, lesson.source, step, {}, 0, 0, scrolled);
    if (made.empty()) return;  // whatever is around it may have one
    std::set<ValueId> expected = made;
    for (const ValueId v : made)
      for (const ValueId o : graph.operands(v))
        if (graph.value(o).kind == ValueKind::point || is_in_table(lesson.source, o)) expected.insert(o);
    std::set<ValueId> shown;
    for (const Spot& spot : sheet.spots) {
      CHECK(spot.link.kind == Link::Kind::value);
      CHECK(spot.name == graph.name(spot.link.id));
      shown.insert(spot.link.id);
    }
    CHECK(shown == expected);
    check_spots(sheet, size.width, size.height);
    const std::uint32_t phase = graph.step(step).phase;
    nested += phase != absent && &lesson.source.algorithm_at(step) != lesson.source.algorithm ? 1 : 0;
  });
  CHECK(nested > 60);
}

TEST_CASE("The basis functions are a triangle of numbers, which begins with the one of degree 0") {
  const auto lesson = prepare<Exact>("basis-functions");  // degree 2, k = 4
  Sheet sheet;
  add_tableau(sheet, lesson->source, lesson->step_count() - 1, {}, 0, 0, scrolled);
  CHECK(sheet.spots.size() == 6);
  const auto& tip = *spot_named(sheet, "N[4][0]");
  for (const char* name : {"N[3][1]", "N[4][1]", "N[2][2]", "N[3][2]", "N[4][2]"}) {
    REQUIRE(spot_named(sheet, name) != nullptr);
    CHECK(tip.x + tip.width < spot_named(sheet, name)->x);
  }
  CHECK(spot_named(sheet, "N[3][1]")->y < tip.y);
  CHECK(spot_named(sheet, "N[4][1]")->y > tip.y);
  CHECK(spot_named(sheet, "N[3][2]")->y == Approx(tip.y));
}

TEST_CASE("The Bernstein polynomials are a triangle that begins with the given one of degree 0") {
  const auto lesson = prepare<Exact>("bernstein");  // degree 3
  Sheet sheet;
  add_tableau(sheet, lesson->source, 0, {}, 0, 0, scrolled);
  CHECK(sheet.spots.size() == 10);
  const auto* tip = spot_named(sheet, "B[0][0]");
  REQUIRE(tip != nullptr);
  for (int r = 1; r <= 3; ++r)
    for (int i = 0; i <= r; ++i) {
      const auto* cell = spot_named(sheet, "B[" + std::to_string(i) + "][" + std::to_string(r) + "]");
      REQUIRE(cell != nullptr);
      CHECK(tip->x + tip->width < cell->x);
      CHECK(cell->y - tip->y ==
            Approx((i - 0.5 * r) * (spot_named(sheet, "B[1][1]")->y - spot_named(sheet, "B[0][1]")->y)));
    }
}

TEST_CASE("Inside skinning, elevation and knot insertion show their own schemes") {
  const auto lesson = prepare<Exact>("skinning");
  const auto& trace = lesson->run.trace;
  const ValueId elevated = *trace.find("raise[1].E[0][2]");
  const ValueId inserted = *trace.find("raise[1].knot[1].Q[1][2]");
  Sheet elevation, insertion;
  add_tableau(elevation, lesson->source, trace.value(elevated).step, {}, 0, 0, scrolled);
  add_tableau(insertion, lesson->source, trace.value(inserted).step, {}, 0, 0, scrolled);
  CHECK(spot_named(elevation, "raise[1].E[0][2]") != nullptr);
  CHECK(spot_named(elevation, "raise[1].knot[1].Q[1][2]") != nullptr);  // a point it starts from
  CHECK(spot_named(elevation, "raise[2].Q[1]") == nullptr);
  CHECK(insertion.spots.size() == 3);  // P[1][1], P[1][2] and the new one between them
  CHECK(spot_named(insertion, "raise[1].knot[1].Q[1][2]") != nullptr);
  CHECK(spot_named(insertion, "P[1][1]") != nullptr);
}

TEST_CASE("Each value of a scheme stands to the right of what it comes from, and between them") {
  for (const char* id : {"de-casteljau", "de-boor", "knot-insertion", "subdivision"}) {
    const auto lesson = prepare<double>(id);
    const auto& trace = lesson->run.trace;
    Sheet sheet;
    if (add_tableau(sheet, lesson->source, lesson->step_count() - 1, {}, 0, 0, scrolled).height == 0) continue;
    std::map<ValueId, const Spot*> at;
    for (const Spot& spot : sheet.spots) at[spot.link.id] = &spot;
    for (const auto& [v, spot] : at) {
      INFO(id << ": " << spot->name);
      double mean = 0;
      int points = 0;
      if (trace.is_input(v)) continue;
      for (const ValueId o : trace.operands(v)) {
        if (!at.contains(o)) continue;
        CHECK(at[o]->x + at[o]->width < spot->x);
        mean += at[o]->y;
        ++points;
      }
      CHECK(points == 2);
      CHECK(spot->y == Approx(mean / points));
    }
  }
}

TEST_CASE("The current step's arrows have their weights, in fractions or decimals as the run shows numbers") {
  // From above: that of the upper operand, then that of the lower.
  const auto weights = [](const auto& lesson, const char* made) {
    const auto& trace = lesson.run.trace;
    Sheet sheet;
    add_tableau(sheet, lesson.source, trace.value(*trace.find(made)).step, {}, 0, 0, scrolled);
    const Spot& cell = *spot_named(sheet, made);
    std::map<double, std::string> texts;
    for (const Label& label : sheet.view.labels)
      if (label.role == Role::text_current && label.anchor.x < cell.x) texts[label.anchor.y] = plain_text(label.text);
    std::vector<std::string> from_above;
    for (const auto& [y, words] : texts) from_above.push_back(words);
    return from_above;
  };
  // P[1][3] = 7/15 P[0][2] + 8/15 P[0][3]
  CHECK(weights(*prepare<Exact>("de-boor"), "P[1][3]") == std::vector<std::string>{"7/15", "8/15"});
  CHECK(weights(*prepare<double>("de-boor"), "P[1][3]") == std::vector<std::string>{"0.467", "0.533"});
  // E[0][1] = 1/3 P[0] + 2/3 P[1]: the ratio belongs to the first point.
  CHECK(weights(*prepare<Exact>("degree-elevation-bspline"), "E[0][1]") == std::vector<std::string>{"1/3", "2/3"});
  CHECK(weights(*prepare<Exact>("degree-elevation-bspline"), "E[0][2]") == std::vector<std::string>{"2/3", "1/3"});
}

TEST_CASE("The step's value and its operands differ from the others by their borders, not by colour alone") {
  const auto lesson = prepare<Exact>("de-boor");
  const auto& trace = lesson->run.trace;
  for (const bool fit : {false, true}) {
    Sheet sheet;
    add_tableau(sheet, lesson->source, trace.value(*trace.find("P[2][3]")).step, {}, 0, 0, {fit, 800, 600});
    const auto borders = [&](Role role, bool dashed) {
      return std::ranges::count_if(sheet.view.polylines, [&](const Polyline& line) {
        return line.closed && line.role == role && line.dashed == dashed;
      });
    };
    CHECK(borders(Role::current, false) == 1);
    CHECK(borders(Role::operand, true) == 2);
    CHECK(borders(Role::operand, false) == 0);
  }
}

TEST_CASE("What is lit has a strong outline; what it came from is tinted by its share, which is written there") {
  const auto lesson = prepare<Exact>("de-boor");
  const auto& trace = lesson->run.trace;
  const std::uint32_t last = lesson->step_count() - 1;
  Emphasis emphasis;
  emphasis.lit = {*trace.find("P[2][3]")};
  emphasis.shares = {{*trace.find("P[0][1]"), 0.04}, {*trace.find("P[0][2]"), 0.72}, {*trace.find("P[0][3]"), 0.24}};
  Sheet plain, lit;
  add_tableau(plain, lesson->source, last, {}, 0, 0, scrolled);
  add_tableau(lit, lesson->source, last, emphasis, 0, 0, scrolled);
  CHECK(count_role(plain.view, Role::highlight) == 0);
  CHECK(std::ranges::count_if(lit.view.polylines,
                              [](const Polyline& line) { return line.closed && line.role == Role::highlight; }) == 1);
  for (const char* share : {"1/25", "18/25", "6/25"}) CHECK(shows(lit, share));
  const auto tint = [&](const char* name) {
    const Spot& spot = *spot_named(lit, name);
    double opacity = 0;
    for (const Polygon& polygon : lit.view.polygons)
      if (polygon.role == Role::highlight && polygon.points[0].x == spot.x && polygon.points[0].y == spot.y)
        opacity = polygon.opacity;
    return opacity;
  };
  CHECK(tint("P[0][1]") > 0);
  CHECK(tint("P[0][1]") < tint("P[0][3]"));
  CHECK(tint("P[0][3]") < tint("P[0][2]"));
  CHECK(tint("P[0][4]") == 0);
}

TEST_CASE("Of a scheme that is scrolled only the visible part is set, in the same places") {
  const auto lesson = prepare<double>("degree-elevation-bspline");
  const auto& trace = lesson->run.trace;
  const std::uint32_t step = trace.value(*trace.find("E[1][1]")).step;
  Sheet all;
  const auto whole = add_tableau(all, lesson->source, step, {}, 10, 20, scrolled);
  for (const auto& [from, to] : {std::pair{0.0, 100.0}, std::pair{150.0, 260.0}, std::pair{300.0, 1e9}}) {
    INFO(from << " to " << to);
    Sheet part;
    const auto size = add_tableau(part, lesson->source, step, {}, 10, 20, {false, 0, 0, from, to});
    CHECK(size.width == whole.width);
    CHECK(size.height == whole.height);
    CHECK(size.current_y == whole.current_y);
    std::size_t visible = 0;
    for (const Spot& spot : all.spots) {
      if (spot.y + spot.height < from || spot.y > to) continue;
      ++visible;
      const Spot* same = spot_named(part, spot.name);
      REQUIRE(same != nullptr);
      CHECK(same->x == spot.x);
      CHECK(same->y == spot.y);
    }
    CHECK(part.spots.size() == visible);
    CHECK(visible < all.spots.size());
  }
  // Where to scroll to is the cell that the step makes.
  const Spot& current = *spot_named(all, "E[1][1]");
  CHECK(whole.current_x == Approx(current.x + current.width / 2));
  CHECK(whole.current_y == Approx(current.y + current.height / 2));
}

TEST_CASE("The scheme of lesson 5 as LaTeX") {
  const auto lesson = prepare<Exact>("de-boor");
  CHECK(latex_tableau(lesson->source, lesson->step_count() - 1) == R"(\begin{array}{llll}
  P_{1} = \left(0,\ 0\right) & & & \\
  & P_{2}^{(1)} = \left(0,\ 16\right) & & \\
  P_{2} = \left(0,\ 20\right) & & P_{3}^{(2)} = \left(\tfrac{64}{5},\ \tfrac{96}{5}\right) & \\
  & P_{3}^{(1)} = \left(16,\ 20\right) & & P_{4}^{(3)} = \left(\tfrac{431}{25},\ \tfrac{474}{25}\right) \\
  P_{3} = \left(30,\ 20\right) & & P_{4}^{(2)} = \left(\tfrac{101}{5},\ \tfrac{94}{5}\right) & \\
  & P_{4}^{(1)} = \left(30,\ 16\right) & & \\
  P_{4} = \left(30,\ 0\right) & & & \\
\end{array}
)");
  const auto& trace = lesson->run.trace;
  CHECK(latex_value(lesson->source, *trace.find("alpha[1][3]")) == R"(\alpha_{3}^{(1)} = \tfrac{8}{15})");
  CHECK(latex_value(lesson->source, *trace.find("k")) == "k = 4");
}

TEST_CASE("LaTeX of weights, of decimals and of lists") {
  const auto rational = prepare<Exact>("de-boor-nurbs");
  const ValueId v = *rational->run.trace.find("P[1][2]");
  CHECK(latex_value(rational->source, v) ==
        R"(P_{2}^{(1)} = \left(\tfrac{7}{5},\ \tfrac{6}{5}\right),\ w = \tfrac{5}{2})");
  const auto decimal = prepare<double>("de-boor");
  CHECK(latex_value(decimal->source, *decimal->run.trace.find("alpha[1][3]")) == R"(\alpha_{3}^{(1)} = 0.533333)");
  const auto insertion = prepare<Exact>("knot-insertion");
  CHECK(latex_value(insertion->source, *insertion->run.trace.find("Ubar")).starts_with(R"(\bar{U} = \left(0,\ 0,\ )"));
}
