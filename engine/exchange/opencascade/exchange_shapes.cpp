#include "exchange/opencascade/exchange_shapes.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "base/text_file.hpp"
#include "exchange/exchange_mesh.hpp"
#include "studio/scene_file.hpp"

namespace blossom::exchange {
namespace {

// Different knots with how often each stands there; nothing where one inside stands more than p times: there
// OpenCASCADE's splines do not jump.
struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
};
std::optional<Knots> knots_of(const std::vector<double>& U, int p) {
  std::vector<double> values;
  std::vector<int> times;
  for (const double u : U) {
    if (!values.empty() && values.back() == u) {
      ++times.back();
    } else {
      values.push_back(u);
      times.push_back(1);
    }
  }
  for (std::size_t i = 1; i + 1 < times.size(); ++i)
    if (times[i] > p) return std::nullopt;
  const int n = static_cast<int>(values.size());
  Knots made{TColStd_Array1OfReal(1, n), TColStd_Array1OfInteger(1, n)};
  for (int i = 0; i < n; ++i) {
    made.values(i + 1) = values[static_cast<std::size_t>(i)];
    made.multiplicities(i + 1) = times[static_cast<std::size_t>(i)];
  }
  return made;
}

gp_Pnt point_of(const HPoint<double>& P) { return {P.x / P.w, P.y / P.w, P.z / P.w}; }
bool has_zero_weight(const std::vector<HPoint<double>>& points) {
  return std::ranges::any_of(points, [](const auto& P) { return !(P.w > 0); });
}

Handle(Geom_BSplineCurve) curve_of(const Curve<double>& curve) {
  const auto knots = knots_of(curve.knots, curve.degree);
  if (!knots || has_zero_weight(curve.points)) return nullptr;
  const int n = static_cast<int>(curve.points.size());
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal weights(1, n);
  for (int i = 0; i < n; ++i) {
    poles(i + 1) = point_of(curve.points[static_cast<std::size_t>(i)]);
    weights(i + 1) = curve.points[static_cast<std::size_t>(i)].w;
  }
  return new Geom_BSplineCurve(poles, weights, knots->values, knots->multiplicities, curve.degree);
}

Handle(Geom_BSplineSurface) surface_of(const Surface<double>& surface) {
  const auto in_u = knots_of(surface.knots[0], surface.degree[0]), in_v = knots_of(surface.knots[1], surface.degree[1]);
  if (!in_u || !in_v || has_zero_weight(surface.points)) return nullptr;
  TColgp_Array2OfPnt poles(1, surface.rows, 1, surface.columns);
  TColStd_Array2OfReal weights(1, surface.rows, 1, surface.columns);
  for (int i = 0; i < surface.rows; ++i)
    for (int j = 0; j < surface.columns; ++j) {
      poles(i + 1, j + 1) = point_of(surface.at(i, j));
      weights(i + 1, j + 1) = surface.at(i, j).w;
    }
  return new Geom_BSplineSurface(poles, weights, in_u->values, in_v->values, in_u->multiplicities, in_v->multiplicities,
                                 surface.degree[0], surface.degree[1]);
}

std::vector<Exact> all_knots(const TColStd_Array1OfReal& sequence) {
  std::vector<Exact> U;
  for (int i = sequence.Lower(); i <= sequence.Upper(); ++i) U.emplace_back(sequence(i));
  return U;
}
HPoint<Exact> homogeneous(const gp_Pnt& P, double w) {
  const Exact weight(w);
  return {weight * Exact(P.X()), weight * Exact(P.Y()), weight * Exact(P.Z()), weight};
}

Curve<Exact> read_curve_of(const Handle(Geom_BSplineCurve) & spline) {
  if (spline->IsPeriodic()) spline->SetNotPeriodic();
  Curve<Exact> curve;
  curve.degree = spline->Degree();
  curve.dimension = 3;
  curve.rational = spline->IsRational();
  curve.knots = all_knots(spline->KnotSequence());
  for (int i = 1; i <= spline->NbPoles(); ++i) curve.points.push_back(homogeneous(spline->Pole(i), spline->Weight(i)));
  return curve;
}

Surface<Exact> read_surface_of(const Handle(Geom_BSplineSurface) & spline) {
  if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
  if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  Surface<Exact> surface;
  surface.degree = {spline->UDegree(), spline->VDegree()};
  surface.rows = spline->NbUPoles();
  surface.columns = spline->NbVPoles();
  surface.rational = spline->IsURational() || spline->IsVRational();
  surface.knots = {all_knots(spline->UKnotSequence()), all_knots(spline->VKnotSequence())};
  for (int i = 1; i <= surface.rows; ++i)
    for (int j = 1; j <= surface.columns; ++j)
      surface.points.push_back(homogeneous(spline->Pole(i, j), spline->Weight(i, j)));
  return surface;
}

}  // namespace

Checked<Shapes> shapes_of(const Workspace& scene, const ExportOptions& options) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  Shapes made;
  std::size_t written = 0, refused = 0, points = 0;
  for (const SceneObject* object : chosen(scene, options)) {
    if (const auto* curve = std::get_if<Curve<Exact>>(&object->geometry)) {
      const auto spline = curve_of(convert<double>(*curve));
      if (!spline.IsNull()) builder.Add(compound, BRepBuilderAPI_MakeEdge(spline).Edge());
      ++(spline.IsNull() ? refused : written);
    } else if (const auto* surface = std::get_if<Surface<Exact>>(&object->geometry)) {
      const auto spline = surface_of(convert<double>(*surface));
      if (!spline.IsNull()) builder.Add(compound, BRepBuilderAPI_MakeFace(spline, 1e-7).Face());
      ++(spline.IsNull() ? refused : written);
    } else {
      ++points;
    }
  }
  if (written == 0) return Diagnostics{{"", 0, 0, "", "there is no curve or surface that can be written"}};
  made.compound = compound;
  made.notes.push_back("names, colours and how things were made are left out");
  if (refused > 0)
    made.notes.push_back(std::to_string(refused) + " curves or surfaces that jump or have a weight of 0 are left out");
  if (points > 0) made.notes.push_back(std::to_string(points) + " rows and nets of points are left out");
  return made;
}

Imported objects_of(const TopoDS_Shape& shape) {
  Imported made;
  std::size_t trimmed = 0, left_out = 0;
  const auto add = [&](const char* name, Geometry geometry) {
    if (made.objects.size() == most_objects) {
      ++left_out;
      return;
    }
    SceneObject object;
    object.name = name;
    object.geometry = std::move(geometry);
    made.objects.push_back(std::move(object));
  };
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current());
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (surface.IsNull()) continue;
    if (!BRep_Tool::NaturalRestriction(face)) ++trimmed;
    auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
    if (spline.IsNull())
      spline = GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(surface, u0, u1, v0, v1));
    add("surface", read_surface_of(Handle(Geom_BSplineSurface)::DownCast(spline->Copy())));
  }
  for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_FACE); edges.More(); edges.Next()) {
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges.Current()), first, last);
    if (curve.IsNull()) continue;
    auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    if (spline.IsNull() || spline->FirstParameter() != first || spline->LastParameter() != last)
      spline = GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
    add("curve", read_curve_of(Handle(Geom_BSplineCurve)::DownCast(spline->Copy())));
  }
  if (trimmed > 0) made.notes.push_back(std::to_string(trimmed) + " faces are taken without the curves that trim them");
  if (left_out > 0) made.notes.push_back(std::to_string(left_out) + " more are not taken");
  return made;
}

namespace {

// A scene's text begins with this, what is wrong does not.
constexpr char taken = 'S';

std::string packed(Checked<Imported> read) {
  if (!read) return read.diagnostics.empty() ? std::string() : read.diagnostics.front().message;
  Workspace scene;
  scene.id = "import";
  scene.title = "import";
  for (SceneObject& object : read->objects) {
    object.name = free_name(scene, object.name);
    look_at_middle(object);
    scene.objects.push_back(std::move(object));
  }
  std::string text(1, taken);
  for (const std::string& note : read->notes) text += note + "\n";
  return text + '\0' + write_scene(scene);
}

Checked<Imported> unpacked(const std::string& name, const std::string& text) {
  const std::size_t end = text.find('\0');
  if (text.empty() || text.front() != taken || end == std::string::npos)
    return Diagnostics{{name, 0, 0, "", text.empty() ? "cannot be read" : text}};
  auto document = JsonDocument::parse(name, text.substr(end + 1));
  if (!document) return document.diagnostics;
  auto scene = read_scene(*document);
  if (!scene) return scene.diagnostics;
  Imported made;
  made.objects = std::move(scene->objects);
  std::string_view notes = std::string_view(text).substr(1, end - 1);
  for (std::size_t line; (line = notes.find('\n')) != std::string_view::npos; notes.remove_prefix(line + 1))
    made.notes.emplace_back(notes.substr(0, line));
  return made;
}

constexpr rlim_t most_seconds = 20;

}  // namespace

Checked<Imported> apart(const std::string& name, const std::function<Checked<Imported>()>& read) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return Diagnostics{{name, 0, 0, "", "the system gives no pipe"}};
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, SIG_DFL);
    const rlimit time{most_seconds, most_seconds}, none{0, 0};
    setrlimit(RLIMIT_CPU, &time);
    setrlimit(RLIMIT_CORE, &none);
    const std::string text = packed(read());
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t written = write(ends[1], text.data() + done, text.size() - done);
      if (written <= 0) break;
      done += static_cast<std::size_t>(written);
    }
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 65'536> buffer{};
  for (ssize_t got; child > 0 && (got = ::read(ends[0], buffer.data(), buffer.size())) != 0;) {
    if (got < 0 && errno != EINTR) break;
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  close(ends[0]);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return Diagnostics{{name, 0, 0, "", "is damaged: OpenCASCADE, which reads such files, breaks down over it"}};
  return unpacked(name, text);
}

void keep_quiet() { Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); }

TemporaryFile::TemporaryFile(std::string_view extension) : name_("scene" + std::string(extension)) {
  std::string pattern = (std::filesystem::temp_directory_path() / "blossom-XXXXXX").string();
  if (mkdtemp(pattern.data()) != nullptr) folder_ = pattern;
}

TemporaryFile::~TemporaryFile() {
  std::error_code error;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, error);
}

Checked<std::string> TemporaryFile::bytes() const { return read_text(path(), std::size_t{1} << 30); }

}  // namespace blossom::exchange
