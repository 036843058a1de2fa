#pragma once
// What is to be drawn, independent of how: points, lines, meshes and labels in world or page coordinates, each with a
// role. A theme gives roles their colours, widths and shapes; a canvas (OpenGL, SVG) draws them. A scene is a value:
// copy it, compare it, draw it twice.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "algorithms/text_run.hpp"

namespace blossom {

// What a thing means. Themes map roles to looks; no colour is named anywhere else.
enum class Role : std::uint8_t {
  grid,           // background grid lines
  axis,           // coordinate axes
  curve,          // the curve under study
  curve_result,   // the curve an algorithm has made so far
  polygon,        // control polygon or net, unchanging
  control_point,  // its points
  earlier,        // values of earlier steps: quieter
  level_a,        // alternating levels of a triangular scheme
  level_b,
  level_c,
  operand,       // what the current step reads
  current,       // what the current step makes: the loudest
  ratio_near,    // the part of a divided segment from the first operand to the new point
  ratio_far,     // and from there to the second
  result,        // the final point or curve
  retired,       // what is no longer part of the polygon
  surface,       // a shaded face
  isoline,       // isoparametric curve on a surface
  panel,         // background of a text panel
  rule_line,     // separators, table lines
  text,          // ordinary text
  text_quiet,    // secondary text
  text_strong,   // headings
  text_current,  // text about the current step
  highlight,     // what one points at or has pinned, and what it came from: stands out on everything
  right,         // a right answer
  mistake,       // a wrong one, or input that is not valid
  focus,         // outline of what has the keyboard's focus
  object_0,      // the colours of a scene's things; never told apart by these alone: names stand beside them
  object_1,
  object_2,
  object_3,
  object_4,
  object_5,
  object_6,
  object_7,
};
inline constexpr int role_count = 36;
inline Role object_role(int color) { return static_cast<Role>(static_cast<int>(Role::object_0) + color); }

// What numbers on a surface are shown by. Themes give the colours.
enum class ColorMap : std::uint8_t {
  none,
  diverging,   // 0 one hue, 1/2 neutral, 1 the other
  sequential,  // from dark to light
  bands,       // stripes: 0 dark, 1 light
};

struct Polyline {
  std::vector<glm::dvec3> points;
  Role role = Role::curve;
  double width_scale = 1;  // of the theme's width for the role
  bool dashed = false;
  bool closed = false;
  bool arrow = false;  // a head at the last point
  bool operator==(const Polyline&) const = default;
};

struct Marker {
  enum class Shape : std::uint8_t { disc, ring, square, diamond, triangle, cross };
  glm::dvec3 position{};
  Role role = Role::control_point;
  Shape shape = Shape::disc;
  double size_scale = 1;  // of the theme's marker size for the role
  bool operator==(const Marker&) const = default;
};

struct Polygon {  // a filled flat polygon (panels, tableau cells), convex
  std::vector<glm::dvec3> points;
  Role role = Role::panel;
  double opacity = 1;
  bool operator==(const Polygon&) const = default;
};

struct Mesh {  // triangles, shaded by their normals with the light at the camera, both sides
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;     // one per position, unit
  std::vector<std::uint32_t> indices;  // three per triangle
  Role role = Role::surface;
  double opacity = 1;
  std::vector<float> values{};  // one per position, 0 to 1: the place in the map's colours instead of the role's colour
  ColorMap map = ColorMap::none;
  bool operator==(const Mesh&) const = default;
};

struct Label {
  // How it stands to its anchor. `around` lets the painter choose the free place nearest to the anchor, so that labels
  // do not overlap each other, markers or the edge of the view; a label that finds no room is left out when optional.
  enum class Placement : std::uint8_t { left, centre, right, around };
  glm::dvec3 anchor{};
  RichText text;
  Role role = Role::text;
  double size_scale = 1;  // of the theme's text size
  Placement placement =
      Placement::left;  // left: text starts at the anchor; centre; right: ends there (on the baseline)
  int priority = 0;     // of two labels that want one place, the higher is placed first
  bool optional = false;
  double max_width = 0;  // page units; > 0: wrapped at blanks into lines downwards
  bool operator==(const Label&) const = default;
};

// World to view. Orthographic looks down -z at `centre`; `height` is how much of the world the view shows vertically.
// Orbit looks at `centre` from azimuth (about +z, from +x) and elevation, z up, in parallel or perspective projection.
struct Camera {
  enum class Kind : std::uint8_t {
    page,
    plane,
    orbit
  };  // page: x right, y DOWN, in page units from the view's top left
  Kind kind = Kind::page;
  glm::dvec3 centre{};
  double height = 1;
  double azimuth = 0.9;     // radians
  double elevation = 0.45;  // radians
  bool perspective = false;
  double roll = 0;  // radians, about the direction of looking: the picture turns clockwise
  bool operator==(const Camera&) const = default;
};

struct View {
  double x = 0, y = 0, width = 0, height = 0;  // on the page, in page units (1 unit = 1 pixel at scale 1), y down
  Camera camera;
  bool clip = true;
  std::vector<Mesh> meshes;
  std::vector<Polygon> polygons;
  std::vector<Polyline> polylines;
  std::vector<Marker> markers;
  std::vector<Label> labels;
  bool operator==(const View&) const = default;
};

// A page: views painted in order.
struct Scene {
  double width = 960;
  double height = 640;
  std::string title;        // for screen readers and file metadata
  std::string description;  // the narration of the step, in words
  std::vector<View> views;
  bool operator==(const Scene&) const = default;
};

}  // namespace blossom
