// OpenCASCADE: D0 and D2 of Geom_BSplineCurve and Geom_BezierCurve, D0 and D1 of Geom_BSplineSurface, the same of the
// adaptors ("cached"), which keep the polynomial of the span they were in last; InsertKnot and IncreaseDegree, which
// change a curve in place, on a copy made within the time; GeomFill_AppSurf (what BRepOffsetAPI_ThruSections calls).

#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomFill_AppSurf.hxx>
#include <GeomFill_Line.hxx>
#include <GeomFill_SectionGenerator.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <memory>

#include "comparison.hpp"

namespace {

using peers::CurveRow;
using peers::work;

constexpr const char* direct = "OpenCASCADE";
constexpr const char* cached = "OpenCASCADE cached";

gp_Pnt affine(const peers::HPoint<double>& P) { return {P.x / P.w, P.y / P.w, P.z / P.w}; }

// Different knots and how often each occurs.
struct KnotsAndMultiplicities {
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger multiplicities;

  explicit KnotsAndMultiplicities(const std::vector<double>& U) {
    std::vector<double> different;
    std::vector<int> times;
    for (const double u : U) {
      if (different.empty() || different.back() < u) {
        different.push_back(u);
        times.push_back(0);
      }
      ++times.back();
    }
    const int count = static_cast<int>(different.size());
    knots.Resize(1, count, false);
    multiplicities.Resize(1, count, false);
    for (int i = 1; i <= count; ++i) {
      knots(i) = different[static_cast<std::size_t>(i) - 1];
      multiplicities(i) = times[static_cast<std::size_t>(i) - 1];
    }
  }
};

template <class Points>
Handle(Geom_BSplineCurve) bspline(const peers::Curve<double>& curve, const Points& poles) {
  const KnotsAndMultiplicities U(curve.knots);
  if (!curve.rational) return new Geom_BSplineCurve(poles, U.knots, U.multiplicities, curve.degree);
  TColStd_Array1OfReal weights(1, poles.Length());
  for (int i = 1; i <= poles.Length(); ++i) weights(i) = curve.points[static_cast<std::size_t>(i) - 1].w;
  return new Geom_BSplineCurve(poles, weights, U.knots, U.multiplicities, curve.degree);
}

TColgp_Array1OfPnt poles_of(const peers::Curve<double>& curve) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(curve.points.size()));
  for (int i = 1; i <= poles.Length(); ++i) poles(i) = affine(curve.points[static_cast<std::size_t>(i) - 1]);
  return poles;
}

Handle(Geom_BSplineCurve) bspline(const peers::Curve<double>& curve) { return bspline(curve, poles_of(curve)); }

Handle(Geom_BSplineSurface) bspline_surface(const peers::Surface<double>& surface) {
  TColgp_Array2OfPnt poles(1, surface.rows, 1, surface.columns);
  TColStd_Array2OfReal weights(1, surface.rows, 1, surface.columns);
  for (int i = 1; i <= surface.rows; ++i) {
    for (int j = 1; j <= surface.columns; ++j) {
      poles(i, j) = affine(surface.at(i - 1, j - 1));
      weights(i, j) = surface.at(i - 1, j - 1).w;
    }
  }
  const KnotsAndMultiplicities U(surface.knots[0]), V(surface.knots[1]);
  return new Geom_BSplineSurface(poles, weights, U.knots, V.knots, U.multiplicities, V.multiplicities,
                                 surface.degree[0], surface.degree[1]);
}

template <std::size_t N>
void store(const gp_XYZ& P, std::array<double, N>& out, std::size_t at = 0) {
  out[at] = P.X();
  out[at + 1] = P.Y();
  out[at + 2] = P.Z();
}

void append(const gp_Pnt& P, std::vector<double>& all) { all.insert(all.end(), {P.X(), P.Y(), P.Z()}); }

template <class CurveHandle>
void add_points(const CurveRow& row, const char* who, const CurveHandle& curve) {
  peers::add_jobs<3>(row.name, who, [&u = row.u, curve](std::size_t i, auto& out) {
    gp_Pnt P;
    curve->D0(u[i], P);
    store(P.XYZ(), out);
  });
}

template <class CurveHandle>
void add_derivatives(const CurveRow& row, const char* who, const CurveHandle& curve) {
  peers::add_jobs<9>(row.name, who, [&u = row.u, curve](std::size_t i, auto& out) {
    gp_Pnt P;
    gp_Vec first, second;
    curve->D2(u[i], P, first, second);
    store(P.XYZ(), out);
    store(first.XYZ(), out, 3);
    store(second.XYZ(), out, 6);
  });
}

Handle(GeomAdaptor_Curve) adaptor(const Handle(Geom_Curve) & curve) { return new GeomAdaptor_Curve(curve); }

void add_curves() {
  for (const CurveRow& row : work().points) {
    const auto curve = bspline(row.curve);
    add_points(row, direct, curve);
    add_points(row, cached, adaptor(curve));
  }
  const CurveRow& row = work().derivatives;
  const auto nurbs = bspline(row.curve);
  add_derivatives(row, direct, nurbs);
  add_derivatives(row, cached, adaptor(nurbs));
  const Handle(Geom_BezierCurve) bezier = new Geom_BezierCurve(poles_of(work().bezier.curve));
  add_points(work().bezier, direct, bezier);
  add_points(work().bezier, cached, adaptor(bezier));
}

template <class SurfaceHandle>
void point_and_unit_normal(const SurfaceHandle& surface, double u, double v, gp_Pnt& P, gp_Vec& normal) {
  gp_Vec by_u, by_v;
  surface->D1(u, v, P, by_u, by_v);
  normal = by_u.Crossed(by_v);
  normal.Normalize();
}

template <class SurfaceHandle>
void add_surface(const char* who, const SurfaceHandle& surface) {
  const auto& u = work().u;
  const auto& v = work().v;
  peers::add_jobs<3>(peers::surface_point_row, who, [&u, &v, surface](std::size_t i, auto& out) {
    gp_Pnt P;
    surface->D0(u[i], v[i], P);
    store(P.XYZ(), out);
  });
  peers::add_jobs<6>(peers::surface_normal_row, who, [&u, &v, surface](std::size_t i, auto& out) {
    gp_Pnt P;
    gp_Vec normal;
    point_and_unit_normal(surface, u[i], v[i], P, normal);
    store(P.XYZ(), out);
    store(normal.XYZ(), out, 3);
  });

  // It has no grids: vertex after vertex, as a user has to, into kept memory.
  struct Grid {
    std::vector<gp_Pnt> points;
    std::vector<gp_Vec> normals;
  };
  for (const bool with_normals : {false, true}) {
    const auto grid = std::make_shared<Grid>();
    grid->points.resize(peers::grid_vertices);
    if (with_normals) grid->normals.resize(peers::grid_vertices);
    const auto fill = [surface, grid, with_normals] {
      std::size_t vertex = 0;
      for (const double x : work().grid[0]) {
        for (const double y : work().grid[1]) {
          if (with_normals) {
            point_and_unit_normal(surface, x, y, grid->points[vertex], grid->normals[vertex]);
          } else {
            surface->D0(x, y, grid->points[vertex]);
          }
          ++vertex;
        }
      }
      return static_cast<const Grid*>(grid.get());
    };
    const auto read = [](const Grid* filled) {
      std::vector<double> all;
      for (std::size_t vertex = 0; vertex < filled->points.size(); ++vertex) {
        append(filled->points[vertex], all);
        if (!filled->normals.empty()) append(filled->normals[vertex].XYZ(), all);
      }
      return all;
    };
    peers::add_whole(with_normals ? peers::grid_normal_row : peers::grid_row, who, peers::grid_vertices, fill, read);
  }
}

std::vector<double> read_curve(const Handle(Geom_BSplineCurve) & curve) {
  std::vector<double> all;
  for (int i = 1; i <= curve->NbPoles(); ++i) append(curve->Pole(i), all);
  for (const double u : curve->KnotSequence()) all.push_back(u);
  return all;
}

template <class Change>
void add_change(const char* row, Change change) {
  peers::add_whole(
      row, direct, 1,
      [curve = bspline(work().curve), change] {
        Handle(Geom_BSplineCurve) copy = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
        change(*copy);
        return copy;
      },
      read_curve);
}

void add_skinning() {
  const auto& profiles = work().profiles;
  const int count = static_cast<int>(profiles.size());
  std::vector<Handle(Geom_BSplineCurve)> curves;
  for (const auto& profile : profiles) curves.push_back(bspline(profile));
  const Handle(TColStd_HArray1OfReal) v = new TColStd_HArray1OfReal(1, count);
  for (int l = 0; l < count; ++l) v->SetValue(l + 1, static_cast<double>(l) / (count - 1));
  peers::add_whole(
      peers::skinning_row, direct, 1,
      [curves, count, v] {
        GeomFill_SectionGenerator sections;
        for (const auto& curve : curves) sections.AddCurve(curve);
        sections.Perform(1e-7);
        sections.SetParam(v);
        const Handle(GeomFill_Line) line = new GeomFill_Line(count);
        constexpr double tolerance = 1e-12;
        GeomFill_AppSurf skin(3, 3, tolerance, tolerance, 0, true);
        skin.Perform(line, sections, true);
        return Handle(Geom_BSplineSurface)(
            new Geom_BSplineSurface(skin.SurfPoles(), skin.SurfWeights(), skin.SurfUKnots(), skin.SurfVKnots(),
                                    skin.SurfUMults(), skin.SurfVMults(), skin.UDegree(), skin.VDegree()));
      },
      [v](const Handle(Geom_BSplineSurface) & surface) {
        std::vector<double> all;
        for (const double y : *v) {
          for (const double x : peers::skinning_parameters()) append(surface->Value(x, y), all);
        }
        return all;
      });
}

void add_all() {
  add_curves();
  const auto surface = bspline_surface(work().surface);
  add_surface(direct, surface);
  add_surface(cached, Handle(GeomAdaptor_Surface)(new GeomAdaptor_Surface(surface)));
  add_change(peers::insertion_row, [](Geom_BSplineCurve& curve) { curve.InsertKnot(work().knot); });
  add_change(peers::elevation_row, [](Geom_BSplineCurve& curve) { curve.IncreaseDegree(curve.Degree() + 1); });
  add_skinning();
}

[[maybe_unused]] const bool added = (add_all(), true);

}  // namespace
