// One curve, one surface, or points, in Blossom's own JSON: what lessons, exercises and programs hand on.

#include "exchange/exchange_mesh.hpp"
#include "geometry/document.hpp"

namespace blossom {
namespace {

using namespace exchange;

Checked<Imported> import(const std::string& name, std::string_view bytes) {
  const auto document = JsonDocument::parse(name, std::string(bytes));
  if (!document) return document.diagnostics;
  Diagnostics wrong;
  const Cursor root(*document, wrong);
  SceneObject object;
  if (root.is(Json::Kind::array)) {
    const bool net =
        root.size() > 0 && root[0].is(Json::Kind::array) && root[0].size() > 0 && root[0][0].is(Json::Kind::array);
    object.name = net ? "net" : "points";
    if (net) {
      if (auto points = read_net(root)) object.geometry = std::move(*points);
    } else if (auto points = read_points(root, 1, 65'536)) {
      object.geometry = std::move(*points);
    }
  } else {
    const Json* degree = root.json().find("degree");
    const bool surface = degree != nullptr && degree->kind == Json::Kind::array;
    object.name = surface ? "surface" : "curve";
    if (surface) {
      if (auto read = read_surface(root)) object.geometry = std::move(*read);
    } else if (auto read = read_curve(root)) {
      object.geometry = std::move(*read);
    }
  }
  if (!wrong.empty()) return wrong;
  Imported made;
  made.objects.push_back(std::move(object));
  return made;
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  const auto objects = chosen(scene, options);
  if (objects.size() != 1)
    return Diagnostics{{"", 0, 0, "",
                        "such a file holds one curve, surface or points, not " + std::to_string(objects.size()) +
                            ": choose one thing, or save the scene"}};
  Exported made;
  made.bytes = std::visit(
                   [](const auto& g) -> std::string {
                     using T = std::decay_t<decltype(g)>;
                     if constexpr (std::is_same_v<T, Curve<Exact>>) return write_curve(g);
                     if constexpr (std::is_same_v<T, Surface<Exact>>) return write_surface(g);
                     if constexpr (std::is_same_v<T, PointRow<Exact>>) return write_points(g);
                     if constexpr (std::is_same_v<T, PointNet<Exact>>) return write_net(g);
                   },
                   objects.front()->geometry) +
               "\n";
  made.notes.push_back("name, colour and what is shown are left out");
  return made;
}

}  // namespace

const ExchangeFormat& format_json() {
  static const ExchangeFormat format{
      "json", "Geometry (JSON)", {".json"}, "One curve, surface, row or net of points, exactly", import, write};
  return format;
}

}  // namespace blossom
