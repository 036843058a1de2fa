// The geometry of each step of each shipped lesson: what is alive is there, what the step does is seen, and is right.
#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/document.hpp"
#include "kernel/rules.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr auto is_finite = [](const glm::dvec3& at) {
  return std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z);
};

bool has_marker(const View& view, const glm::dvec3& at, Role role) {
  return std::ranges::any_of(view.markers, [&](const Marker& m) { return m.position == at && m.role == role; });
}
bool has_marker(const View& view, const glm::dvec3& at) {
  return std::ranges::any_of(view.markers, [&](const Marker& m) { return m.position == at; });
}

std::vector<Polyline> lines_of(const View& view, Role role) {
  std::vector<Polyline> found;
  std::ranges::copy_if(view.polylines, std::back_inserter(found),
                       [&](const Polyline& line) { return line.role == role; });
  return found;
}

bool is_drawn(const StepSource& source, ValueId v) {
  const auto* spec = source.spec(v);
  return source.points[v] && spec != nullptr && spec->draw != ValueSpec::Draw::none;
}

// The step is about one point, not about a whole polygon that it writes down.
std::optional<ValueId> single_point(const StepSource& source, std::uint32_t step) {
  const ValueId main = source.graph->main_value(step);
  const auto [first, end] = source.graph->values_of(step);
  if (main == absent || source.graph->is_input(main) || end - first > 3 || !is_drawn(source, main)) return std::nullopt;
  return main;
}

// A level of a triangular scheme that was computed in a row or column which is finished: the next row is looked at.
bool is_over(const StepSource& source, ValueId v, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  if (source.spec(v)->draw != ValueSpec::Draw::level) return false;
  std::uint32_t phase = graph.phase_of(v);
  while (phase != absent && !graph.phases()[phase].scoped) phase = graph.phases()[phase].parent;
  return phase != absent && graph.phases()[phase].last_step < step;
}

struct Division {  // M divides the segment from A to B
  glm::dvec3 A, B, M;
  Exact share;  // of the part from A to M in the whole
};

// From the exact numbers of the trace: M = (1-a) A + a B, or a A + (1-a) B where a degree is raised. With weights the
// sum is of homogeneous points, so the share is a w_B / w_M.
std::optional<Division> division(const PreparedLesson<Exact>& lesson, std::uint32_t step) {
  const auto& trace = lesson.run.trace;
  const ValueId main = trace.main_value(step);
  if (main == absent || trace.is_input(main)) return std::nullopt;
  const bool blend = trace.value(main).rule == &rule_info<Blend>, raise = trace.value(main).rule->polar == Polar::merge;
  const auto from = trace.operands(main);
  if (from.size() != 3 || !(blend || raise)) return std::nullopt;
  const auto &A = lesson.source.points[from[1]], &B = lesson.source.points[from[2]], &M = lesson.source.points[main];
  if (!A || !B || !M || *A == *B) return std::nullopt;
  Exact share = trace.numbers(from[0])[0];
  if (raise) share = Exact(1) - share;
  if (trace.rational) share = share * trace.numbers(from[2])[3] / trace.numbers(main)[3];
  return Division{*A, *B, *M, share};
}

}  // namespace

TEST_CASE("Every place in a viewport is finite") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const View view = lesson.scenes.viewport(step, 700, 500);
    bool all = is_finite(view.camera.centre) && std::isfinite(view.camera.height) && view.camera.height > 0;
    for (const auto& line : view.polylines)
      all = all && std::ranges::all_of(line.points, is_finite) && line.points.size() > 1;
    for (const auto& marker : view.markers) all = all && is_finite(marker.position);
    for (const auto& label : view.labels) all = all && is_finite(label.anchor) && !plain_text(label.text).empty();
    for (const auto& mesh : view.meshes) {
      all = all && std::ranges::all_of(mesh.positions, is_finite) && std::ranges::all_of(mesh.normals, is_finite);
      all = all && mesh.normals.size() == mesh.positions.size() && mesh.indices.size() % 3 == 0;
      all = all && std::ranges::all_of(mesh.indices, [&](std::uint32_t i) { return i < mesh.positions.size(); });
    }
    CHECK(all);
  });
}

TEST_CASE("Every point that is alive is on the picture") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const View view = lesson.scenes.viewport(step, 700, 500);
    if (!view.meshes.empty()) return;  // a finished surface stands alone with its net
    const auto& graph = *lesson.source.graph;
    for (ValueId v = 0; v < graph.value_count() && graph.value(v).step <= step; ++v) {
      if (!graph.alive(v, step) || !is_drawn(lesson.source, v) || is_over(lesson.source, v, step)) continue;
      if (has_marker(view, *lesson.source.points[v])) continue;
      FAIL_CHECK(graph.name(v) << " is not drawn");
    }
  });
}

TEST_CASE("A point that is not made yet is not on the picture") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const auto& graph = *lesson.source.graph;
    std::vector<glm::dvec3> made;
    for (ValueId v = 0; v < graph.value_count() && graph.value(v).step <= step; ++v)
      if (lesson.source.points[v]) made.push_back(*lesson.source.points[v]);
    for (const auto& marker : lesson.scenes.viewport(step, 700, 500).markers)
      if (marker.role != Role::curve && std::ranges::find(made, marker.position) == made.end())
        FAIL_CHECK("a marker at " << marker.position.x << ", " << marker.position.y << " is no point made so far");
  });
}

TEST_CASE("A step that makes one point shows it as the current one and rings what it reads") {
  std::set<std::string> seen;
  for_each_step<double>([&](const auto& lesson, std::uint32_t step) {
    const View view = lesson.scenes.viewport(step, 700, 500);
    const auto main = single_point(lesson.source, step);
    if (!main || !view.meshes.empty()) return;
    const auto& graph = *lesson.source.graph;
    CHECK(has_marker(view, *lesson.source.points[*main], Role::current));
    CHECK(std::ranges::any_of(view.labels, [&](const Label& label) {
      return label.role == Role::text_current && label.anchor == *lesson.source.points[*main];
    }));
    for (const ValueId o : graph.operands(*main)) {
      if (!is_drawn(lesson.source, o) || graph.value(o).step == step) continue;
      INFO("operand " << graph.name(o));
      CHECK(std::ranges::any_of(view.markers, [&](const Marker& m) {
        return m.position == *lesson.source.points[o] && m.role == Role::operand && m.shape == Marker::Shape::ring;
      }));
    }
    seen.insert(std::string(lesson.lesson.algorithm->id));
  });
  for (const auto* id : {"de_casteljau", "de_boor", "knot_insertion", "degree_elevation", "skinning"}) {
    INFO(id);
    CHECK(seen.contains(id));
  }
}

TEST_CASE("A divided segment meets at the new point in the ratio that the trace says") {
  int divisions = 0, rational = 0;
  for_each_step<Exact>([&](const auto& lesson, std::uint32_t step) {
    const auto expected = division(lesson, step);
    if (!expected) return;
    const View view = lesson.scenes.viewport(step, 700, 500);
    if (!view.meshes.empty()) return;
    const auto near = lines_of(view, Role::ratio_near), far = lines_of(view, Role::ratio_far);
    REQUIRE(near.size() == 1);
    REQUIRE(far.size() == 1);
    const double a = expected->share.to_double();
    if (a < 0 || a > 1) return;  // beyond one of the two: nothing is divided
    // Two lines, end to end: A to M, M to B. Their ends are the very points of the trace.
    CHECK(near[0].points == std::vector{expected->A, expected->M});
    CHECK(far[0].points == std::vector{expected->M, expected->B});
    CHECK_FALSE(near[0].dashed);
    CHECK_FALSE(far[0].dashed);
    const glm::dvec3 whole = expected->B - expected->A;
    const double length = glm::length(whole);
    CHECK(glm::length(glm::cross(expected->M - expected->A, whole)) <= 1e-12 * length * length);
    CHECK(glm::length(expected->M - expected->A) == Approx(a * length).margin(1e-12 * length));
    CHECK(glm::length(expected->B - expected->M) == Approx((1 - a) * length).margin(1e-12 * length));
    ++divisions;
    rational += lesson.run.trace.rational ? 1 : 0;
  });
  CHECK(divisions > 50);
  CHECK(rational > 5);
}

TEST_CASE("The shares written at a divided segment are those of its two parts") {
  const auto lesson = prepare("de-boor");
  const auto made = lesson->run.trace.find("P[1][2]");  // alpha[1][2] = 4/5
  REQUIRE(made);
  const auto step = lesson->run.trace.value(*made).step;
  const View view = lesson->scenes.viewport(step, 700, 500);
  const auto expected = division(*lesson, step);
  REQUIRE(expected);
  const auto share_at = [&](const glm::dvec3& from, const glm::dvec3& to) {
    for (const auto& label : view.labels)
      if (glm::length(label.anchor - (from + to) * 0.5) < 1e-9 && label.priority == 20) return plain_text(label.text);
    return std::string("none");
  };
  CHECK(share_at(expected->A, expected->M) == "4/5");
  CHECK(share_at(expected->M, expected->B) == "1/5");
}

TEST_CASE("A derivative is an arrow from its point, shortened by a factor that its name says") {
  // The quarter circle by weights 1, 1, 2 at u = 0: C' = (0, 2), C'' = (-4, 0), from the point (1, 0).
  const auto lesson = prepare("derivatives");
  const View view = lesson->scenes.viewport(lesson->step_count() - 1, 700, 500);
  std::vector<Polyline> arrows;
  std::ranges::copy_if(view.polylines, std::back_inserter(arrows), &Polyline::arrow);
  REQUIRE(arrows.size() == 2);
  const glm::dvec3 C{1, 0, 0};
  for (const Polyline& arrow : arrows) CHECK(arrow.points.front() == C);
  const double scale = arrows[0].points.back().y / 2;
  CHECK(scale > 0);
  CHECK(glm::length(arrows[0].points.back() - (C + scale * glm::dvec3(0, 2, 0))) < 1e-12);
  CHECK(glm::length(arrows[1].points.back() - (C + scale * glm::dvec3(-4, 0, 0))) < 1e-12);
  for (const Polyline& arrow : arrows)
    CHECK(std::ranges::any_of(view.labels, [&](const Label& label) {
      return label.anchor == arrow.points.back() && plain_text(label.text).starts_with(format_short(scale, 2));
    }));
}

TEST_CASE("A finished surface that was fitted to points is seen with them") {
  for (const char* id : {"a-surface-through-points", "a-surface-near-points"}) {
    INFO(id);
    const auto lesson = prepare(id);
    const auto& trace = lesson->run.trace;
    const View view = lesson->scenes.viewport(lesson->step_count() - 1, 700, 500);
    REQUIRE(!view.meshes.empty());
    int points = 0;
    for (ValueId v = 0; v < trace.value_count(); ++v) {
      if (!trace.is_input(v) || !lesson->source.points[v]) continue;
      CHECK(has_marker(view, *lesson->source.points[v]));
      ++points;
    }
    CHECK(points >= 12);
  }
}

TEST_CASE("A given control net has lines along both of its directions") {
  const auto lesson = prepare("point-on-a-surface");
  const auto& trace = lesson->run.trace;
  const View view = lesson->scenes.viewport(0, 700, 500);
  const auto P = [&](const char* name) { return *lesson->source.points[*trace.find(name)]; };
  const auto joined = [&](const glm::dvec3& a, const glm::dvec3& b) {
    return std::ranges::any_of(view.polylines, [&](const Polyline& line) {
      for (std::size_t i = 1; i < line.points.size(); ++i)
        if (line.points[i - 1] == a && line.points[i] == b) return true;
      return false;
    });
  };
  CHECK(joined(P("P[0][0]"), P("P[0][1]")));
  CHECK(joined(P("P[0][0]"), P("P[1][0]")));
}

TEST_CASE("A point beyond the segment is reached by a dashed line") {
  // No lesson can ask for it (u outside of [0, 1] is refused), the scene shows it all the same.
  const Algorithm& algorithm = *find_algorithm("de_casteljau");
  const auto document = JsonDocument::parse("curve", R"({"degree": 1, "points": [[0, 0], [4, 2]]})");
  REQUIRE(document);
  Diagnostics diagnostics;
  for (const auto& [u, at, nearest] : {std::tuple{Exact::ratio(3, 2), glm::dvec3(6, 3, 0), glm::dvec3(4, 2, 0)},
                                       std::tuple{Exact::ratio(-1, 2), glm::dvec3(-2, -1, 0), glm::dvec3(0, 0, 0)}}) {
    Inputs<Exact> inputs;
    inputs.values.emplace("curve", *read_curve(Cursor(*document, diagnostics)));
    inputs.values.emplace("u", u);
    const auto run = record<Exact>(algorithm, inputs);
    REQUIRE(run);
    const Narrator<Exact> narrator(*run);
    const StepSource source = make_source(narrator);
    const View view = StepScenes(source).viewport(run->trace.value(*run->trace.find("P[1][0]")).step, 400, 300);
    const auto near = lines_of(view, Role::ratio_near), far = lines_of(view, Role::ratio_far);
    REQUIRE(near.size() == 1);
    REQUIRE(far.size() == 1);
    CHECK(near[0].points == std::vector{glm::dvec3(0, 0, 0), glm::dvec3(4, 2, 0)});
    CHECK(far[0].dashed);
    CHECK(far[0].points == std::vector{nearest, at});
  }
}

TEST_CASE("A step of one lesson always gives the same scene") {
  for (const auto& entry : shipped_lessons().lessons) {
    const auto lesson = prepare<double>(entry), again = prepare<double>(entry);
    INFO(lesson->name);
    for (const std::uint32_t step : {0u, lesson->step_count() / 2, lesson->step_count() - 1}) {
      const Scene first = lesson->page(step);
      for (std::uint32_t other = 0; other < std::min(lesson->step_count(), 5u); ++other) (void)lesson->page(other);
      CHECK(lesson->page(step) == first);
      CHECK(again->page(step) == first);
      CHECK(lesson->scenes.viewport(step, 300, 200) == again->scenes.viewport(step, 300, 200));
    }
  }
}

TEST_CASE("The camera stands still while the steps go on, and has everything in view") {
  for (const auto& entry : shipped_lessons().lessons) {
    const auto lesson = prepare<double>(entry);
    INFO(lesson->name);
    const Camera camera = lesson->scenes.viewport(0, 700, 500).camera;
    for (std::uint32_t step = 1; step < lesson->step_count(); ++step)
      REQUIRE(lesson->scenes.viewport(step, 700, 500).camera == camera);
    if (lesson->source.spatial()) continue;
    const double half_height = camera.height / 2, half_width = half_height * 700 / 500;
    for (const auto& at : lesson->source.points) {
      if (!at) continue;
      CHECK(std::abs(at->x - camera.centre.x) <= half_width);
      CHECK(std::abs(at->y - camera.centre.y) <= half_height);
    }
  }
}
