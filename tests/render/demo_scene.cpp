#include "render/demo_scene.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace blossom {
namespace {

glm::dvec3 mix(const glm::dvec3& a, const glm::dvec3& b, double t) { return (1 - t) * a + t * b; }

Label around(RichText text, const glm::dvec3& at, Role role, int priority, bool optional = false) {
  Label label;
  label.text = std::move(text);
  label.anchor = at;
  label.role = role;
  label.placement = Label::Placement::around;
  label.priority = priority;
  label.optional = optional;
  return label;
}

// De Casteljau's algorithm on a quartic at u = 0.4, in the middle of level 2.
View plane_view() {
  View view;
  view.x = 12, view.y = 56, view.width = 560, view.height = 420;
  view.camera.kind = Camera::Kind::plane;
  view.camera.centre = {4, 1.9, 0};
  view.camera.height = 7.2;
  for (int i = -1; i <= 9; ++i) view.polylines.push_back({{{i, -1, 0}, {i, 5, 0}}, Role::grid});
  for (int j = -1; j <= 5; ++j) view.polylines.push_back({{{-1, j, 0}, {9, j, 0}}, Role::grid});
  Polyline x_axis{{{-0.6, -0.6, 0}, {8.6, -0.6, 0}}, Role::axis}, y_axis{{{-0.4, -0.8, 0}, {-0.4, 4.6, 0}}, Role::axis};
  x_axis.arrow = y_axis.arrow = true;
  view.polylines.push_back(x_axis);
  view.polylines.push_back(y_axis);

  const double u = 0.4;
  std::vector<std::vector<glm::dvec3>> levels = {{{0, 0, 0}, {1, 3.6, 0}, {4, 4.4, 0}, {7.2, 3.2, 0}, {8, 0.2, 0}}};
  const auto next_level = [](const std::vector<glm::dvec3>& points, double t) {
    std::vector<glm::dvec3> next;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) next.push_back(mix(points[i], points[i + 1], t));
    return next;
  };
  Polyline curve{{}, Role::curve};
  for (int k = 0; k <= 96; ++k) {
    auto points = levels[0];
    while (points.size() > 1) points = next_level(points, k / 96.0);
    curve.points.push_back(points[0]);
  }
  levels.push_back(next_level(levels[0], u));
  levels.push_back(next_level(levels[1], u));
  view.polylines.push_back({levels[0], Role::polygon});
  view.polylines.push_back(curve);
  view.polylines.push_back({levels[1], Role::level_a});
  view.polylines.push_back({{levels[2][0], levels[2][1]}, Role::level_b});
  view.polylines.push_back({{levels[1][1], levels[2][1]}, Role::ratio_near});
  view.polylines.push_back({{levels[2][1], levels[1][2]}, Role::ratio_far});
  view.polylines.push_back({{{5.6, 0.1, 0}, {6.4, 0.9, 0}, {7, 0.2, 0}}, Role::retired});
  const Role roles[] = {Role::control_point, Role::level_a, Role::level_b};
  for (std::size_t r = 0; r < levels.size(); ++r) {
    for (std::size_t i = 0; i + (r == 2 ? 1 : 0) < levels[r].size(); ++i) {
      const bool operand = r == 1 && (i == 1 || i == 2), current = r == 2 && i == 1;
      view.markers.push_back({levels[r][i], roles[r]});
      if (operand) view.markers.push_back({levels[r][i], Role::operand});
      if (current) view.markers.push_back({levels[r][i], Role::current});
      view.labels.push_back(around(point_name("P", std::to_string(i), r == 0 ? "" : "(" + std::to_string(r) + ")"),
                                   levels[r][i],
                                   current   ? Role::text_current
                                   : operand ? Role::operand
                                             : roles[r],
                                   current   ? 10
                                   : operand ? 5
                                             : 0));
    }
  }
  view.markers.push_back({{6.4, 0.9, 0}, Role::retired});
  view.markers.push_back({curve.points[38], Role::result});
  view.labels.push_back(around({{"C(", TextRun::Level::base, true}, {"2/5"}, {")", TextRun::Level::base, true}},
                               curve.points[38], Role::result, 8));
  view.labels.push_back(around(plain("0.6"), mix(levels[1][1], levels[2][1], 0.5), Role::ratio_near, 1, true));
  view.labels.push_back(around(plain("0.4"), mix(levels[2][1], levels[1][2], 0.5), Role::ratio_far, 1, true));
  return view;
}

// A wavy bicubic-like patch with its net.
View orbit_view() {
  View view;
  view.x = 584, view.y = 56, view.width = 364, view.height = 420;
  view.camera.kind = Camera::Kind::orbit;
  view.camera.centre = {0, 0, 0.1};
  view.camera.height = 6.4;
  view.camera.azimuth = 0.75;
  view.camera.elevation = 0.5;
  view.camera.perspective = true;
  const auto surface = [](double x, double y) { return 0.75 * std::sin(1.6 * x) * std::cos(1.3 * y) + 0.25 * x * y; };
  const int n = 40;
  Mesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double x = -1.5 + 3.0 * i / n, y = -1.5 + 3.0 * j / n, h = 1e-4;
      const glm::dvec3 dx{2 * h, 0, surface(x + h, y) - surface(x - h, y)};
      const glm::dvec3 dy{0, 2 * h, surface(x, y + h) - surface(x, y - h)};
      mesh.positions.push_back({x, y, surface(x, y)});
      mesh.normals.push_back(glm::normalize(glm::cross(dx, dy)));
      if (i == n || j == n) continue;
      const auto at = [](int a, int b) { return static_cast<std::uint32_t>(a * (n + 1) + b); };
      for (const auto k : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        mesh.indices.push_back(k);
      }
    }
  }
  view.meshes.push_back(mesh);
  for (int k = 0; k <= 6; ++k) {
    Polyline along_x{{}, Role::isoline}, along_y{{}, Role::isoline};
    for (int i = 0; i <= n; ++i) {
      const double s = -1.5 + 3.0 * i / n, t = -1.5 + 0.5 * k;
      along_x.points.push_back({s, t, surface(s, t)});
      along_y.points.push_back({t, s, surface(t, s)});
    }
    view.polylines.push_back(along_x);
    view.polylines.push_back(along_y);
  }
  glm::dvec3 net[4][4];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double x = -1.5 + i, y = -1.5 + j;
      net[i][j] = {x, y, 1.35 * surface(x, y) + 0.3};
      const bool picked = i == 2 && j == 1;
      view.markers.push_back({net[i][j], picked ? Role::current : Role::control_point});
      view.labels.push_back(around(point_name("P", std::to_string(i) + "," + std::to_string(j)), net[i][j],
                                   picked ? Role::text_current : Role::control_point, picked ? 5 : 0, !picked));
    }
  }
  for (int i = 0; i < 4; ++i) {
    view.polylines.push_back({{net[i][0], net[i][1], net[i][2], net[i][3]}, Role::polygon});
    view.polylines.push_back({{net[0][i], net[1][i], net[2][i], net[3][i]}, Role::polygon});
  }
  const glm::dvec3 origin{0.9, -1.9, -1.4};
  for (const glm::dvec3& axis : {glm::dvec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    Polyline arrow{{origin, origin + 0.8 * axis}, Role::axis};
    arrow.arrow = true;
    view.polylines.push_back(arrow);
  }
  return view;
}

View text_view() {
  View view;
  view.width = 960, view.height = 640;
  const auto text = [&](double x, double y, RichText content, Role role, double max_width = 0) {
    Label label;
    label.anchor = {x, y, 0};
    label.text = std::move(content);
    label.role = role;
    label.max_width = max_width;
    view.labels.push_back(label);
  };
  view.polygons.push_back({{{12, 488, 0}, {948, 488, 0}, {948, 628, 0}, {12, 628, 0}}, Role::panel});
  view.polylines.push_back({{{12, 46, 0}, {948, 46, 0}}, Role::rule_line});
  text(16, 32, plain("De Casteljau's algorithm: u = 2/5"), Role::text_strong);
  text(600, 32, plain("step 7 of 10"), Role::text_quiet);
  text(28, 516, plain("Level 2: between two neighbours of level 1"), Role::text_current);
  RichText narration = point_name("P", "1", "(2)");
  for (const auto& run : RichText{{" = (1 − "}, {"u", TextRun::Level::base, true}, {") "}}) narration.push_back(run);
  for (const auto& run : point_name("P", "1", "(1)")) narration.push_back(run);
  for (const auto& run : RichText{{" + "}, {"u ", TextRun::Level::base, true}}) narration.push_back(run);
  for (const auto& run : point_name("P", "2", "(1)")) narration.push_back(run);
  narration.push_back(
      {" = 3/5 (11/5, 98/25) + 2/5 (132/25, 98/25) = (429/125, 98/25). The new point divides the segment in the ratio "
       "2 : 3, as every point of this level divides its own. Where the two parts meet, the polygon of the next level "
       "begins."});
  text(28, 544, narration, Role::text, 620);
  text(690, 516, {{"P[r][i] = (1-u)*P[r-1][i]", TextRun::Level::base, false, false, true}}, Role::text);
  text(690, 536, {{"        + u*P[r-1][i+1]", TextRun::Level::base, false, true, true}}, Role::text_current);
  return view;
}

}  // namespace

RichText plain(std::string text) { return {TextRun{std::move(text)}}; }

RichText point_name(std::string letter, std::string sub, std::string super) {
  RichText text{{std::move(letter), TextRun::Level::base, true}, {std::move(sub), TextRun::Level::sub}};
  if (!super.empty()) text.push_back({std::move(super), TextRun::Level::super});
  return text;
}

Scene demo_scene() {
  Scene scene;
  scene.title = "De Casteljau's algorithm & a patch";
  scene.description = "Step 7 of 10: a point of level 2 is made from two of level 1 <0.6 : 0.4>";
  scene.views = {text_view(), plane_view(), orbit_view()};
  return scene;
}

Scene plane_scene() {
  Scene scene;
  scene.views = {plane_view()};
  return scene;
}

}  // namespace blossom
