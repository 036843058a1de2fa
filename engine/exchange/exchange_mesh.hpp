#pragma once
// Scenes as other programs know them: triangles and polylines, in doubles.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "exchange/format.hpp"

namespace blossom::exchange {

struct TriangleMesh {
  std::string name;
  int color = 0;
  std::vector<glm::dvec3> positions, normals;  // as many; a normal is (0, 0, 0) where there is none
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
struct Path {
  std::string name;
  int color = 0;
  std::vector<glm::dvec3> points;
};

// What is to be written: the chosen things, or all that are not hidden.
std::vector<const SceneObject*> chosen(const Workspace&, const ExportOptions&);

// So finely that triangles and chords lie within `tolerance` (a length) of the shape, as far as 512 steps in each
// direction allow; degenerate triangles (at poles) are left out.
TriangleMesh mesh_of(const SceneObject&, const Surface<double>&, double tolerance);
std::vector<Path> paths_of(const SceneObject&, const Curve<double>&, double tolerance);

// The tolerance as a length: that share of the diagonal of the box around the control points.
double length_of(const std::vector<const SceneObject*>&, double share);

// "#0072B2": the colour of a thing, as in the light theme (Okabe and Ito, Color Universal Design, 2008).
std::array<std::uint8_t, 3> rgb_of(int color);

// As many digits as asked for, and no more than a double has.
std::string decimal(double, int digits);

}  // namespace blossom::exchange
