#pragma once
// What all pictures of one run have in common, made once: sampled curves and surface, how much room it all takes, and
// which values are drawn, when and how.

#include <memory>

#include "scene/display_list.hpp"
#include "scene/fit.hpp"
#include "scene/source.hpp"

namespace blossom {

// A value that is drawn while it is alive.
struct Drawable {
  ValueId value = 0;
  std::uint32_t born = 0, gone = absent;  // steps
  std::uint32_t phase = absent;           // of a scoped value: the phase; otherwise none
  ValueSpec::Draw draw = ValueSpec::Draw::none;
  bool given = false;
  bool ray = false;  // a line from the origin leads to it
  Role role = Role::earlier;
};

// A vector where it stands, shortened by a factor of which all of its kind have the same.
struct StandingArrow {
  ValueId value = 0;
  glm::dvec3 foot, along;
  double scale = 1;
  std::uint32_t born = 0;  // step
};

struct SurfaceSamples {
  Mesh mesh;  // empty where the surface has a pole
  std::vector<std::vector<glm::dvec3>> isolines;
  void add(SurfaceSamples);
};
SurfaceSamples sample_surface(const Surface<double>&);

struct SceneSamples {
  std::vector<std::vector<glm::dvec3>> curves;          // connected pieces of the input curves
  std::vector<std::vector<glm::dvec3>> lifted;          // of the curves in space above them
  std::vector<glm::dvec3> knots;                        // points of the input curves at their inner knots
  std::vector<std::vector<glm::dvec3>> result;          // of resulting curves
  std::vector<std::vector<glm::dvec3>> given_isolines;  // of the input surfaces
  std::vector<Drawable> drawables;                      // ascending
  std::vector<StandingArrow> arrows;                    // ascending
  Bounds bounds;                                        // of all points and curves

  explicit SceneSamples(const StepSource&);

  const SurfaceSamples& surface() const;  // sampled when first asked for
  Camera fitted(double width, double height, const std::optional<Camera>& look) const;

 private:
  template <class Body>
  void for_each_place(const Body&) const;
  void add_curve(const Curve<double>&, int steps, std::vector<std::vector<glm::dvec3>>& pieces);
  void find_drawables();
  void find_places();
  void find_arrows();
  Camera fitted_anew(double width, double height, const Camera& look) const;

  const StepSource* source_;
  std::vector<glm::dvec3> places_;  // of values, that a camera shows
  mutable std::unique_ptr<SurfaceSamples> surface_;
  struct Fit {
    double width = 0, height = 0;
    Camera look, camera;
  };
  mutable std::optional<Fit> fit_;  // the last one
};

}  // namespace blossom
