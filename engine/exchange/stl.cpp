// STL, binary: the triangles of all surfaces (3D Systems, StereoLithography Interface Specification, 1989). 80 bytes of
// heading, the number of triangles, and for each its normal, its corners and two bytes that nobody uses.

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "exchange/exchange_mesh.hpp"

namespace blossom {
namespace {

using namespace exchange;

void put(std::string& out, const glm::dvec3& v) {
  for (int k = 0; k < 3; ++k) {
    const auto x = static_cast<float>(v[k]);
    char bytes[4];
    std::memcpy(bytes, &x, 4);  // little endian, as everything Blossom runs on
    out.append(bytes, 4);
  }
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  const auto objects = chosen(scene, options);
  const double tolerance = length_of(objects, options.tolerance);
  std::string triangles;
  std::uint32_t count = 0;
  std::size_t others = 0;
  for (const SceneObject* object : objects) {
    const auto* surface = std::get_if<Surface<Exact>>(&object->geometry);
    if (surface == nullptr) {
      ++others;
      continue;
    }
    const TriangleMesh mesh = mesh_of(*object, convert<double>(*surface), tolerance);
    for (const auto& [a, b, c] : mesh.triangles) {
      const glm::dvec3 &A = mesh.positions[a], &B = mesh.positions[b], &C = mesh.positions[c];
      put(triangles, glm::normalize(glm::cross(B - A, C - A)));
      put(triangles, A);
      put(triangles, B);
      put(triangles, C);
      triangles.append(2, '\0');
      ++count;
    }
  }
  if (count == 0)
    return Diagnostics{{"", 0, 0, "", "STL holds triangles of surfaces, and there is no surface to be written"}};
  Exported made;
  made.bytes = "triangles of curved surfaces";  // must not begin with "solid": that would be the text form
  made.bytes.resize(80, ' ');
  char bytes[4];
  std::memcpy(bytes, &count, 4);
  made.bytes.append(bytes, 4);
  made.bytes += triangles;
  made.notes.push_back("surfaces are written as " + std::to_string(count) + " triangles, names and colours left out");
  if (others > 0) made.notes.push_back(std::to_string(others) + " curves and points are left out");
  return made;
}

}  // namespace

const ExchangeFormat& format_stl() {
  static const ExchangeFormat format{"stl", "STL, for printing in 3D", {".stl"}, "Triangles of surfaces", nullptr,
                                     write};
  return format;
}

}  // namespace blossom
