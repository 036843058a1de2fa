#pragma once
// A scene of the studio as a value: things one designs, one behind the other. A thing is given (a curve, a surface,
// points), or made from things before it by an algorithm: then it follows them, until it is edited itself. That it can
// only refer to what stands before it leaves no room for circles.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "algorithms/algorithm.hpp"
#include "studio/placement.hpp"

namespace blossom {

using Geometry = std::variant<Curve<Exact>, Surface<Exact>, PointRow<Exact>, PointNet<Exact>>;

// "curve", "surface", "points", "net": also the key in a scene file.
std::string_view geometry_key(const Geometry&);

// ---- how a thing is made --------------------------------------------------------------------------------------------

// A thing before, as it is or as an instance placed elsewhere.
struct Reference {
  std::string object;  // its name
  Placement place;
  bool operator==(const Reference&) const = default;
};
// An input of the algorithm: a value of its own, or one thing (a `curve`, a `surface`, points) or several (`curves`).
using Ingredient = std::variant<InputValue<Exact>, std::vector<Reference>>;

struct Recipe {
  const Algorithm* algorithm = nullptr;
  std::map<std::string, Ingredient, std::less<>> inputs;  // those left out have their fallback
  std::size_t which = 0;                                  // of several results

  bool operator==(const Recipe&) const = default;
};

// ---- how it is shown ------------------------------------------------------------------------------------------------

enum class Show : std::uint8_t {
  points,      // the control points
  indices,     // their names
  polygon,     // the control polygon, or net
  knots,       // the knots on the curve; the knot lines on a surface
  point,       // the point at u, or (u, v)
  hull,        // the convex hull of the control points in force at u
  net,         // the de Casteljau or de Boor net at u; of a surface at (u, v)
  triad,       // tangent, normal and binormal at u; of a surface: tangents and normal
  transport,   // the rotation-minimising frame instead of Frenet's
  circle,      // the circle of curvature, with its centre
  sphere,      // the sphere of curvature (a spatial curve)
  comb,        // the curvature comb
  hodograph,   // the derivative curve, from the origin
  projection,  // the B-spline one dimension up that a rational plane curve is the projection of, and the rays
  isolines,    // of a surface
  principal,   // directions of a surface at (u, v), as long as their radii
  faces,       // of a surface, shaded
};
inline constexpr int show_count = 17;
struct ShowName {
  Show show;
  std::string_view id, title;  // in files and scripts; in panels
  bool of_curves, of_surfaces;
};
const std::vector<ShowName>& show_names();

class Shows {
 public:
  bool operator[](Show show) const { return (bits_ >> static_cast<int>(show) & 1) != 0; }
  void set(Show show, bool on) {
    const std::uint32_t bit = 1u << static_cast<int>(show);
    bits_ = on ? bits_ | bit : bits_ & ~bit;
  }
  bool operator==(const Shows&) const = default;

 private:
  std::uint32_t bits_ = 0;
};
// What a new thing of this kind shows: points and polygon; of a surface faces and isolines, too.
Shows usual_shows(const Geometry&);

// What a surface is coloured by.
enum class SurfaceMap : std::uint8_t { none, gaussian, mean, largest, smallest, isophotes, reflection };
inline constexpr int surface_map_count = 7;
std::string_view surface_map_id(SurfaceMap);     // "gaussian"
std::string_view surface_map_title(SurfaceMap);  // "Gaussian curvature"

// ---- the things -----------------------------------------------------------------------------------------------------

inline constexpr int object_colors = 8;  // of the themes
inline constexpr std::size_t most_objects = 1000;

struct SceneObject {
  std::string name;  // unique; see problem_of_name
  Geometry geometry;
  std::optional<Recipe> recipe;  // how it is made; nothing: it is given
  std::string problem;           // why it could not be made as its sources are now; its geometry is the last that could
  int color = 0;                 // 0..object_colors - 1
  bool hidden = false;
  Shows shows;
  SurfaceMap map = SurfaceMap::none;
  Exact u{0}, v{0};  // where one looks at it; within its domain

  bool operator==(const SceneObject&) const = default;
};

// Where a parameter of a curve, or of a surface in direction 0 (u) or 1 (v), runs; nothing for points, and for v of a
// curve.
std::optional<std::pair<Exact, Exact>> domain_of(const Geometry&, int direction);
// u and v in the middle of their domains, or moved into them; 0 where there is none.
void look_at_middle(SceneObject&);
void keep_in_domain(SceneObject&);

// From where a scene is looked at when it is opened.
struct Look {
  enum class From : std::uint8_t { space, xy, xz, yz };
  From from = From::space;
  double azimuth = 0.9, elevation = 0.45;  // radians
  bool perspective = true;
  bool operator==(const Look&) const = default;
};

struct Workspace {
  std::string id, title, summary;
  std::optional<Look> look;
  std::vector<SceneObject> objects;

  const SceneObject* find(std::string_view name) const;
  std::optional<std::size_t> index_of(std::string_view name) const;
  bool operator==(const Workspace&) const = default;
};

// What is wrong with a name, if something is: it has 1 to 64 characters, no control characters, and no blanks at its
// ends.
std::optional<std::string> problem_of_name(std::string_view name);
// The name, or with a number behind it if it is taken: "curve 2".
std::string free_name(const Workspace&, std::string name);

}  // namespace blossom
