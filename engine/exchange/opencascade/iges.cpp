// IGES 5.3 (entities 126 and 128): rational B-spline curves and surfaces, through OpenCASCADE.

#include <IFSelect_ReturnStatus.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <fstream>
#include <sstream>

#include "exchange/opencascade/exchange_shapes.hpp"

namespace blossom {
namespace {

using namespace exchange;

Checked<Imported> import(const std::string& name, std::string_view bytes) {
  return apart(name, [&] {
    return guarded(name, [&]() -> Checked<Imported> {
      const TemporaryFile file(".igs");
      {
        std::ofstream out(file.path(), std::ios::binary);
        out << bytes;
      }
      IGESControl_Reader reader;
      if (reader.ReadFile(file.path().c_str()) != IFSelect_RetDone)
        return Diagnostics{{name, 0, 0, "", "is no IGES file that can be read"}};
      reader.TransferRoots();
      return objects_of(reader.OneShape());
    });
  });
}

Checked<Exported> write(const Workspace& scene, const ExportOptions& options) {
  return guarded("", [&]() -> Checked<Exported> {
    auto shapes = shapes_of(scene, options);
    if (!shapes) return shapes.diagnostics;
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", 0);
    std::ostringstream out;
    if (!writer.AddShape(shapes->compound) || (writer.ComputeModel(), !writer.Write(out)))
      return Diagnostics{{"", 0, 0, "", "OpenCASCADE could not write these curves and surfaces as IGES"}};
    return Exported{out.str(), std::move(shapes->notes)};
  });
}

}  // namespace

const ExchangeFormat& format_iges() {
  static const ExchangeFormat format{
      "iges", "IGES, for older CAD systems", {".igs", ".iges"}, "B-spline curves and surfaces with weights", import,
      write};
  return format;
}

}  // namespace blossom
