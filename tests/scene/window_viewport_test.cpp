// The viewport as a window shows it: cameras, grids, motion, what is lit, spots, options, and very long runs.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>

#include "scene/camera.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double width = 700, height = 500;
constexpr ViewSize size{width, height};

std::vector<Polyline> lines_of(const View& view, Role role) {
  std::vector<Polyline> found;
  std::ranges::copy_if(view.polylines, std::back_inserter(found), [&](const auto& line) { return line.role == role; });
  return found;
}
std::vector<Marker> markers_of(const View& view, Role role) {
  std::vector<Marker> found;
  std::ranges::copy_if(view.markers, std::back_inserter(found), [&](const auto& m) { return m.role == role; });
  return found;
}
const Label* label_of(const View& view, const std::string& text) {
  const auto found = std::ranges::find_if(view.labels, [&](const Label& l) { return plain_text(l.text) == text; });
  return found == view.labels.end() ? nullptr : &*found;
}
bool is_bold(const Label& label) {
  return std::ranges::all_of(label.text, [](const TextRun& run) { return run.bold; });
}
bool near(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12 * (1 + glm::length(a)); }

template <Scalar S>
ValueId value(const PreparedLesson<S>& lesson, const char* name) {
  return lesson.run.trace.find(name).value();
}
template <Scalar S>
std::uint32_t step_of(const PreparedLesson<S>& lesson, const char* name) {
  return lesson.run.trace.value(value(lesson, name)).step;
}

}  // namespace

TEST_CASE("The plain viewport is the window's with nothing special") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    ViewportOptions options;
    options.grid = !lesson.source.spatial();  // pictures of space have no ground
    CHECK(lesson.scenes.viewport(step, width, height) == lesson.scenes.viewport(step, width, height, options).view);
  });
}

TEST_CASE("Every spot lies on a point of the step and has its full name") {
  for_each_step<double>([](const auto& lesson, std::uint32_t step) {
    const Sheet sheet = lesson.scenes.viewport(step, width, height, ViewportOptions{});
    std::set<ValueId> seen;
    double before = -1e300;
    for (const Spot& spot : sheet.spots) {
      REQUIRE(spot.link.kind == Link::Kind::value);
      const glm::dvec3 at = lesson.source.points.at(spot.link.id).value();
      const auto on_page = to_page(sheet.view.camera, size, at).value();
      bool right = std::abs(spot.x + spot.width / 2 - on_page.x) < 1e-9;
      right = right && std::abs(spot.y + spot.height / 2 - on_page.y) < 1e-9;
      right = right && spot.name == lesson.run.trace.name(spot.link.id);
      if (lesson.source.spatial()) {  // the nearest to the viewer last
        const double z = glm::dot(at, axes_of(sheet.view.camera).toward);
        right = right && z >= before - 1e-9;
        before = z;
      }
      CHECK(right);
      CHECK(seen.insert(spot.link.id).second);
    }
    const ValueId main = lesson.run.trace.main_value(step);
    if (main == absent) return;
    for (const ValueId v : lesson.run.trace.operands(main)) {
      const ValueSpec* spec = lesson.source.spec(v);
      const bool drawn = lesson.source.points[v] && spec != nullptr && spec->draw != ValueSpec::Draw::none;
      if (drawn && sheet.view.meshes.empty()) CHECK(seen.contains(v));
    }
  });
}

TEST_CASE("A point that is out of view has no spot") {
  const auto lesson = prepare<double>("de-boor");
  ViewportOptions options;
  options.camera = lesson->scenes.fitted(width, height);
  options.camera->centre.x += 1e6;
  CHECK(lesson->scenes.viewport(3, width, height, options).spots.empty());
}

TEST_CASE("The grid of a plane follows the camera, its numbers stay at the edges") {
  const auto lesson = prepare<double>("de-boor");
  const Camera fitted = lesson->scenes.fitted(width, height);
  for (const double factor : {1e-6, 0.01, 0.7, 1.0, 3.0, 1e3, 1e6, 1e12}) {
    ViewportOptions options;
    options.camera = panned(zoomed(fitted, size, {123, 45}, factor), size, {333, -4321});
    const View view = lesson->scenes.viewport(2, width, height, options).view;
    INFO("factor " << factor);
    CHECK(view.camera == *options.camera);
    const auto lines = lines_of(view, Role::grid).size() + lines_of(view, Role::axis).size();
    CHECK(lines >= 8);
    CHECK(lines <= 40);
    std::set<std::string> left, below;
    int ticks = 0;
    for (const Label& label : view.labels) {
      if (label.priority != -10) continue;
      const auto at = to_page(view.camera, size, label.anchor).value();
      const bool at_left = at.x<0.02 * width, at_bottom = at.y> 0.98 * height;
      CHECK((at_left || at_bottom));
      // Every number is another one, however far one zooms in.
      const double unit = view.camera.height / height;
      if (unit > 1e-13) CHECK((at_left ? left : below).insert(plain_text(label.text)).second);
      ++ticks;
    }
    CHECK(ticks >= 6);
  }
  ViewportOptions without;
  without.grid = false;
  CHECK(lines_of(lesson->scenes.viewport(2, width, height, without).view, Role::grid).empty());
}

TEST_CASE("In space a ground lies under everything, with three arrows at right angles") {
  const auto lesson = prepare<double>("skinning");
  const View view = lesson->scenes.viewport(0, width, height, ViewportOptions{}).view;
  double lowest = 1e300;
  for (const auto& at : lesson->source.points)
    if (at) lowest = std::min(lowest, at->z);
  const auto grid = lines_of(view, Role::grid);
  CHECK(grid.size() > 6);
  CHECK(grid.size() < 60);
  for (const auto& line : grid)
    for (const auto& at : line.points) REQUIRE(at.z == Approx(lowest));
  const auto axes = lines_of(view, Role::axis);
  REQUIRE(axes.size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(axes[static_cast<std::size_t>(i)].arrow);
    glm::dvec3 along = axes[static_cast<std::size_t>(i)].points[1] - axes[static_cast<std::size_t>(i)].points[0];
    CHECK(along[i] > 0);
    along[i] = 0;
    CHECK(glm::length(along) == 0);
  }
  for (const char* name : {"x", "y", "z"}) CHECK(label_of(view, name) != nullptr);
}

TEST_CASE("The fitted camera has everything in view, from wherever it looks") {
  std::mt19937 random(8);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const char* id : {"skinning", "de-boor", "rational-quarter-circle"}) {
    const auto lesson = prepare<double>(id);
    for (int i = 0; i < 40; ++i) {
      Camera look{Camera::Kind::orbit, {}, 1, number(-3, 3), number(-1.5, 1.5), i % 2 == 0};
      if (i == 0) look.kind = Camera::Kind::plane;
      const Camera camera = lesson->scenes.fitted(width, height, look);
      INFO(id << ", seed 8, look " << i);
      CHECK(camera.kind == look.kind);
      CHECK(camera.azimuth == look.azimuth);
      CHECK(camera.elevation == look.elevation);
      CHECK(camera.perspective == look.perspective);
      double widest = 0;
      for (const auto& p : lesson->source.points) {
        if (!p) continue;
        const auto at = to_page(camera, size, *p);
        REQUIRE(at);
        const double x = std::abs(at->x / width - 0.5) * 2, y = std::abs(at->y / height - 0.5) * 2;
        widest = std::max({widest, x, y});
      }
      CHECK(widest <= 1);
      CHECK(widest > 0.6);  // and does not stand far away
    }
  }
  CHECK(prepare<double>("skinning")->scenes.fitted(width, height) ==
        prepare<double>("skinning")->scenes.viewport(0, width, height).camera);
}

TEST_CASE("In a division the new point travels from the first operand to its place") {
  const auto lesson = prepare("de-boor");
  const std::uint32_t step = step_of(*lesson, "P[1][3]");
  const glm::dvec3 A = *lesson->source.points[value(*lesson, "P[0][2]")];
  const glm::dvec3 B = *lesson->source.points[value(*lesson, "P[0][3]")];
  const glm::dvec3 M = *lesson->source.points[value(*lesson, "P[1][3]")];
  for (const double motion : {-1.0, 0.0, 0.25, 0.5, 0.75, 1.0, 2.0}) {
    INFO("motion " << motion);
    ViewportOptions options;
    options.motion = motion;
    const Sheet sheet = lesson->scenes.viewport(step, width, height, options);
    const glm::dvec3 there = A + std::clamp(motion, 0.0, 1.0) * (M - A);
    const auto current = markers_of(sheet.view, Role::current);
    REQUIRE(current.size() == 1);
    CHECK(near(current[0].position, there));
    const auto first = lines_of(sheet.view, Role::ratio_near), second = lines_of(sheet.view, Role::ratio_far);
    REQUIRE(first.size() == 1);
    REQUIRE(second.size() == 1);
    CHECK(near(first[0].points[0], A));
    CHECK(near(first[0].points[1], there));
    CHECK(near(second[0].points[0], there));
    CHECK(near(second[0].points[1], B));
    CHECK((label_of(sheet.view, "P3(1)") != nullptr) == (motion >= 0.5));
    const auto spot = std::ranges::find_if(sheet.spots, [](const Spot& s) { return s.name == "P[1][3]"; });
    REQUIRE(spot != sheet.spots.end());
    CHECK(spot->x + spot->width / 2 == Approx(to_page(sheet.view.camera, size, there)->x));
  }
}

TEST_CASE("Another new point grows at its place") {
  const auto lesson = prepare("knot-insertion");
  const std::uint32_t last = lesson->step_count() - 1;  // writes the new control points down
  ViewportOptions options;
  const auto whole = lesson->scenes.viewport(last, width, height, options).view;
  options.motion = 0.25;
  const auto early = lesson->scenes.viewport(last, width, height, options).view;
  REQUIRE(early.markers.size() == whole.markers.size());
  int smaller = 0;
  for (std::size_t i = 0; i < early.markers.size(); ++i) {
    CHECK(early.markers[i].position == whole.markers[i].position);
    if (early.markers[i].size_scale == whole.markers[i].size_scale) continue;
    CHECK(early.markers[i].size_scale == Approx(0.25 * whole.markers[i].size_scale));
    ++smaller;
  }
  const auto [first, end] = lesson->run.trace.values_of(last);
  CHECK(smaller == static_cast<int>(end - first));
}

TEST_CASE("What is lit has a ring and a bold name that is never left out") {
  const auto lesson = prepare("de-boor");
  const ValueId lit = value(*lesson, "P[1][3]");
  const std::uint32_t last = lesson->step_count() - 1;
  for (const bool labels : {true, false}) {
    ViewportOptions options;
    options.labels = labels;
    CHECK(markers_of(lesson->scenes.viewport(last, width, height, options).view, Role::highlight).empty());
    options.emphasis.lit = {lit};
    const View view = lesson->scenes.viewport(last, width, height, options).view;
    const auto rings = markers_of(view, Role::highlight);
    REQUIRE(rings.size() == 1);
    CHECK(rings[0].position == *lesson->source.points[lit]);
    CHECK(rings[0].shape == Marker::Shape::ring);
    const Label* label = label_of(view, "P3(1)");
    REQUIRE(label != nullptr);
    CHECK(is_bold(*label));
    CHECK_FALSE(label->optional);
    if (!labels)
      for (const Label& other : view.labels) CHECK((&other == label || other.priority == -10));
  }
}

TEST_CASE("What is lit and not of this step has its ring where it was, and none before it is made") {
  const auto lesson = prepare("knot-insertion");
  const auto& trace = lesson->run.trace;
  const std::uint32_t last = lesson->step_count() - 1;
  int retired = 0;
  for (ValueId v = 0; v < trace.value_count(); ++v) {
    if (!lesson->source.points[v]) continue;
    ViewportOptions options;
    options.emphasis.lit = {v};
    const auto rings = markers_of(lesson->scenes.viewport(last, width, height, options).view, Role::highlight);
    REQUIRE(rings.size() == 1);
    CHECK(rings[0].position == *lesson->source.points[v]);
    retired += trace.alive(v, last) ? 0 : 1;
    if (const auto born = trace.value(v).step; born > 0)
      CHECK(markers_of(lesson->scenes.viewport(born - 1, width, height, options).view, Role::highlight).empty());
  }
  CHECK(retired > 0);
}

TEST_CASE("What weighs more has the larger ring, and a few have their shares written") {
  const auto lesson = prepare("de-boor");
  ViewportOptions options;
  options.emphasis.lit = {value(*lesson, "P[1][3]")};
  const std::vector<std::pair<const char*, double>> shares = {
      {"P[0][0]", 0.0001}, {"P[0][1]", -0.25}, {"P[0][2]", 1.0 / 3}, {"P[0][3]", 0.9}};
  for (const auto& [name, share] : shares) options.emphasis.shares.emplace_back(value(*lesson, name), share);
  std::ranges::sort(options.emphasis.shares);
  const View view = lesson->scenes.viewport(lesson->step_count() - 1, width, height, options).view;
  const auto ring = [&](const char* name) {
    for (const Marker& m : markers_of(view, Role::highlight))
      if (m.position == *lesson->source.points[value(*lesson, name)]) return m.size_scale;
    return 0.0;
  };
  CHECK(ring("P[0][0]") == 0);  // next to nothing
  CHECK(ring("P[0][1]") > 0);
  CHECK(ring("P[0][1]") < ring("P[0][2]"));
  CHECK(ring("P[0][2]") < ring("P[0][3]"));
  for (const char* text : {"-1/4", "1/3", "9/10"}) {
    INFO(text);
    REQUIRE(label_of(view, text) != nullptr);
    CHECK(label_of(view, text)->role == Role::text_quiet);
  }
}

TEST_CASE("Many shares are rings without numbers") {
  const auto lesson = prepare<double>("skinning");
  ViewportOptions options;
  const auto& trace = lesson->run.trace;
  for (ValueId v = 0; v < trace.value_count() && options.emphasis.shares.size() < 13; ++v)
    if (trace.is_input(v) && lesson->source.points[v]) options.emphasis.shares.emplace_back(v, 0.123);
  REQUIRE(options.emphasis.shares.size() == 13);
  const View many = lesson->scenes.viewport(1, width, height, options).view;
  CHECK(markers_of(many, Role::highlight).size() == 13);
  CHECK(label_of(many, "0.123") == nullptr);
  options.emphasis.shares.pop_back();
  CHECK(label_of(lesson->scenes.viewport(1, width, height, options).view, "0.123") != nullptr);
}

TEST_CASE("A finished surface has a quiet net and isoparametric curves, or neither") {
  const auto lesson = prepare<double>("skinning");
  const std::uint32_t last = lesson->step_count() - 1;
  ViewportOptions options;
  options.grid = false;
  const View with = lesson->scenes.viewport(last, width, height, options).view;
  CHECK(with.meshes.size() == 1);
  CHECK(lines_of(with, Role::isoline).size() >= 6);
  CHECK(lines_of(with, Role::polygon).size() >= 6);
  CHECK(lines_of(with, Role::result).empty());
  for (const auto& line : lines_of(with, Role::polygon)) CHECK(line.width_scale < 1);
  options.surface_net = false;
  const View without = lesson->scenes.viewport(last, width, height, options).view;
  CHECK(without.meshes.size() == 1);
  CHECK(lines_of(without, Role::isoline).empty());
  CHECK(lines_of(without, Role::polygon).empty());
  CHECK_FALSE(lines_of(without, Role::curve).empty());
  options.curves = false;
  CHECK(lines_of(lesson->scenes.viewport(last, width, height, options).view, Role::curve).empty());
}

TEST_CASE("A run with thousands of points shows what the step is about and a bounded rest") {
  // Profiles that share no inner knot: each gets the knots of all the others.
  std::mt19937 random(9);
  const auto draw = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  std::vector<Curve<Exact>> profiles;
  for (int l = 0; l < 12; ++l) {
    Curve<Exact> curve;
    curve.degree = 3;
    curve.dimension = 3;
    int at = 0;
    curve.knots.assign(3, Exact(0));
    for (int i = 0; i < 18; ++i, at += draw(50, 150)) curve.knots.push_back(Exact::ratio(at, 100));
    curve.knots.insert(curve.knots.end(), 3, curve.knots.back());
    for (int i = 0; i < 20; ++i) curve.points.emplace_back(Exact(i), Exact(draw(-3, 3)), Exact(5 * l), Exact(1));
    profiles.push_back(std::move(curve));
  }
  Inputs<Exact> inputs;
  inputs.values.emplace("profiles", profiles);
  inputs.values.emplace("degree_v", 3);
  inputs.values.emplace("parametrization", std::string("uniform"));
  const auto run = record<double>(*find_algorithm("skinning"), inputs);
  REQUIRE(run);
  const Narrator<double> narrator(*run);
  const StepSource source = make_source(narrator);
  const StepScenes scenes(source);
  const auto& trace = run->trace;
  REQUIRE(trace.value_count() > 20000);

  std::size_t most_alive = 0, most_drawn = 0;
  for (std::uint32_t k = 0; k <= 20; ++k) {
    const auto step = static_cast<std::uint32_t>(std::uint64_t{trace.step_count() - 1} * k / 20);
    std::size_t alive = 0;
    for (ValueId v = 0; v < trace.value_count(); ++v) alive += source.points[v] && trace.alive(v, step) ? 1 : 0;
    most_alive = std::max(most_alive, alive);
    const View view = scenes.viewport(step, width, height, ViewportOptions{}).view;
    most_drawn = std::max(most_drawn, view.markers.size());
    const ValueId main = trace.main_value(step);
    if (main == absent || trace.is_input(main) || !source.points[main]) continue;
    INFO(trace.name(main));
    CHECK(std::ranges::any_of(
        view.markers, [&](const Marker& m) { return m.role == Role::current && m.position == *source.points[main]; }));
    if (!view.meshes.empty()) {
      CHECK(view.meshes[0].positions.size() <= 121 * 121);
      continue;
    }
    for (const ValueId o : trace.operands(main))
      if (source.points[o])
        CHECK(std::ranges::any_of(view.markers, [&](const Marker& m) { return m.position == *source.points[o]; }));
  }
  CHECK(most_alive > 4000);
  CHECK(most_drawn < 2200);
}
