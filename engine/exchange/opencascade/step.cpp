// STEP (ISO 10303-21, AP 214): B-spline curves and surfaces with weights, through OpenCASCADE.

#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <sstream>

#include "exchange/opencascade/exchange_shapes.hpp"

namespace blossom {
namespace {

using namespace exchange;

Checked<Imported> import(const std::string& name, std::string_view bytes) {
  return apart(name, [&] {
    return guarded(name, [&]() -> Checked<Imported> {
      STEPControl_Reader reader;
      std::istringstream stream{std::string(bytes)};
      if (reader.ReadStream("scene.step", stream) != IFSelect_RetDone)
        return Diagnostics{{name, 0, 0, "", "is no STEP file that can be read"}};
      reader.TransferRoots();
      return objects_of(reader.OneShape());
    });
  });
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  return guarded("", [&]() -> Checked<Exported> {
    auto shapes = shapes_of(scene, options);
    if (!shapes) return shapes.diagnostics;
    STEPControl_Writer writer;
    Interface_Static::SetIVal("write.precision.mode", 1);
    const TemporaryFile file(".step");
    if (writer.Transfer(shapes->compound, STEPControl_AsIs) != IFSelect_RetDone ||
        writer.Write(file.path().c_str()) != IFSelect_RetDone)
      return Diagnostics{{"", 0, 0, "", "OpenCASCADE could not write these curves and surfaces as STEP"}};
    auto bytes = file.bytes();
    if (!bytes) return bytes.diagnostics;
    return Exported{std::move(*bytes), std::move(shapes->notes)};
  });
}

}  // namespace

const ExchangeFormat& format_step() {
  static const ExchangeFormat format{
      "step", "STEP, for CAD systems", {".step", ".stp"}, "B-spline curves and surfaces with weights", import, write};
  return format;
}

}  // namespace blossom
