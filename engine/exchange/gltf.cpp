// glTF 2.0, binary (Khronos Group, glTF 2.0 Specification, 2021): surfaces as triangles with normals, curves as strips
// of lines, points as points, each with its name and colour. z is up here and y there: one node turns all of it.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "exchange/exchange_mesh.hpp"

namespace blossom {
namespace {

using namespace exchange;
using nlohmann::ordered_json;

constexpr int points_mode = 0, line_strip_mode = 3, triangles_mode = 4;
constexpr int float_type = 5126, index_type = 5125;
constexpr int array_buffer = 34962, index_buffer = 34963;

class Writer {
 public:
  Writer() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Blossom"}};
    json_["scene"] = 0;
  }

  int vectors(const std::vector<glm::dvec3>& all, bool bounds) {
    const std::size_t at = bytes_.size();
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::dvec3& v : all)
      for (int k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(v[k]);
        low[k] = std::min<double>(low[k], x);
        high[k] = std::max<double>(high[k], x);
        put(&x, 4);
      }
    ordered_json accessor{
        {"bufferView", view(at, array_buffer)}, {"componentType", float_type}, {"count", all.size()}, {"type", "VEC3"}};
    if (bounds) {  // demanded of positions
      accessor["min"] = {low.x, low.y, low.z};
      accessor["max"] = {high.x, high.y, high.z};
    }
    return add("accessors", std::move(accessor));
  }
  int indices(const TriangleMesh& mesh) {
    const std::size_t at = bytes_.size();
    for (const auto& triangle : mesh.triangles) put(triangle.data(), 12);
    return add("accessors", {{"bufferView", view(at, index_buffer)},
                             {"componentType", index_type},
                             {"count", mesh.triangles.size() * 3},
                             {"type", "SCALAR"}});
  }
  int material(int color) {
    if (materials_[static_cast<std::size_t>(color)] < 0) {
      ordered_json factor = ordered_json::array();
      for (const std::uint8_t channel : rgb_of(color)) {  // linear light
        const double v = channel / 255.0;
        factor.push_back(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
      }
      factor.push_back(1);
      materials_[static_cast<std::size_t>(color)] = add(
          "materials",
          {{"name", "colour " + std::to_string(color)},
           {"doubleSided", true},
           {"pbrMetallicRoughness", {{"baseColorFactor", factor}, {"metallicFactor", 0}, {"roughnessFactor", 0.6}}}});
    }
    return materials_[static_cast<std::size_t>(color)];
  }
  void object(const std::string& name, ordered_json primitives) {
    const int mesh = add("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
    // -90 degrees about x
    const double half = std::sqrt(0.5);
    nodes_.push_back(add("nodes", {{"name", name}, {"mesh", mesh}, {"rotation", {-half, 0, 0, half}}}));
  }
  bool empty() const { return nodes_.empty(); }

  std::string finish() {
    json_["scenes"] = {{{"nodes", nodes_}}};
    json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = json_.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string out = "glTF";
    const auto word = [&](std::size_t n) {
      const auto x = static_cast<std::uint32_t>(n);
      out.append(reinterpret_cast<const char*>(&x), 4);
    };
    word(2);
    word(12 + 8 + text.size() + 8 + bytes_.size());
    word(text.size());
    out += "JSON" + text;
    word(bytes_.size());
    out.append("BIN\0", 4);
    return out + bytes_;
  }

 private:
  void put(const void* from, std::size_t size) { bytes_.append(static_cast<const char*>(from), size); }
  int view(std::size_t at, int target) {
    return add("bufferViews",
               {{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes_.size() - at}, {"target", target}});
  }
  int add(const char* list, ordered_json item) {
    json_[list].push_back(std::move(item));
    return static_cast<int>(json_[list].size()) - 1;
  }

  ordered_json json_;
  std::string bytes_;
  std::vector<int> nodes_;
  std::array<int, object_colors> materials_ = [] {
    std::array<int, object_colors> none{};
    none.fill(-1);
    return none;
  }();
};

std::vector<glm::dvec3> places(const std::vector<HPoint<Exact>>& points) {
  std::vector<glm::dvec3> made;
  for (const auto& P : points) made.emplace_back(P.x.to_double(), P.y.to_double(), P.z.to_double());
  return made;
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  const auto objects = chosen(scene, options);
  const double tolerance = length_of(objects, options.tolerance);
  Writer writer;
  for (const SceneObject* object : objects) {
    ordered_json primitives = ordered_json::array();
    const int material = writer.material(object->color);
    if (const auto* surface = std::get_if<Surface<Exact>>(&object->geometry)) {
      TriangleMesh mesh = mesh_of(*object, convert<double>(*surface), tolerance);
      if (mesh.triangles.empty()) continue;
      for (auto& normal : mesh.normals)
        if (normal == glm::dvec3(0)) normal = {0, 0, 1};  // glTF demands a unit vector
      const int positions = writer.vectors(mesh.positions, true), normals = writer.vectors(mesh.normals, false);
      primitives.push_back({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                            {"indices", writer.indices(mesh)},
                            {"material", material},
                            {"mode", triangles_mode}});
    } else if (const auto* curve = std::get_if<Curve<Exact>>(&object->geometry)) {
      for (const Path& path : paths_of(*object, convert<double>(*curve), tolerance))
        primitives.push_back({{"attributes", {{"POSITION", writer.vectors(path.points, true)}}},
                              {"material", material},
                              {"mode", line_strip_mode}});
    } else {
      const auto points = std::visit([](const auto& g) { return places(g.points); }, object->geometry);
      if (points.empty()) continue;
      primitives.push_back({{"attributes", {{"POSITION", writer.vectors(points, true)}}},
                            {"material", material},
                            {"mode", points_mode}});
    }
    if (!primitives.empty()) writer.object(object->name, std::move(primitives));
  }
  if (writer.empty()) return Diagnostics{{"", 0, 0, "", "there is nothing to be written"}};
  return Exported{writer.finish(),
                  {"surfaces are written as triangles and curves as lines, within " +
                   format_short(100 * options.tolerance, 3) + " % of the size of all of it"}};
}

}  // namespace

const ExchangeFormat& format_gltf() {
  static const ExchangeFormat format{"gltf",   "glTF, for pages and slides",
                                     {".glb"}, "Triangles, lines and points with names and colours",
                                     nullptr,  write};
  return format;
}

}  // namespace blossom
