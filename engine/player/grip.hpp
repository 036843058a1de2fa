#pragma once
// What hands do: looking around by dragging, dragging a control point, a knot or u; and the edits of a point that keys
// and menus make. From where a thing was taken and where the mouse is to the camera or the edit that is meant. Every
// edit of a drag starts from the inputs as they were when it began, so that on the way back all is as it was.
//
// Lengths are page units of the view in which the drag is: of the picture, or of the sheet with the knots.

#include <optional>
#include <string>
#include <variant>

#include "player/edit.hpp"
#include "scene/camera.hpp"
#include "scene/panels.hpp"

namespace blossom {

class Session;

struct GripKeys {
  bool along = false;  // Shift. Of points: along an axis; of knots: all equal ones
  bool snap = false;   // Ctrl, or always as the settings say. To the grid; of parameters: to fractions of the domain
};

// Empty space: the picture moves along, or turns.
struct LookGrip {
  Camera from;
  ViewSize size;
  glm::dvec2 start;
  bool turns = false;
  Camera at(glm::dvec2 mouse) const;
};

// A point that can be lit but not dragged.
struct StuckGrip {
  std::string name;  // "P[1][3]"
  std::string why;   // as a sentence
};

// A given control point: in the plane through it that faces the view, or along the axis that the drag runs most along.
// A point of a plane curve that is seen in space stays at its height, and under the mouse.
class PointGrip {
 public:
  // Precondition: the point has a place, which the camera sees.
  PointGrip(const Session&, const PointAddress&, const Camera&, ViewSize, glm::dvec2 mouse, double grid);

  const PointAddress& address() const { return address_; }
  const std::string& name() const { return name_; }
  const Inputs<Exact>& before() const { return before_; }
  void rebase(const Inputs<Exact>& inputs) { before_ = inputs; }
  Point<Exact> place(glm::dvec2 mouse, const GripKeys&) const;
  Edited edited(const Algorithm&, glm::dvec2 mouse, const GripKeys&) const;
  // 0, 1, 2 for x, y, z: the axis that is most along the drag on the page; nothing while there is no drag.
  std::optional<int> axis(glm::dvec2 mouse) const;

 private:
  Inputs<Exact> before_;
  PointAddress address_;
  std::string name_;
  Camera camera_;
  ViewSize size_;
  glm::dvec2 mouse_, on_page_;  // where it was taken; where the point was
  Point<Exact> start_;
  glm::dvec3 from_;  // where it is drawn: that may be above the plane in which it is given
  int dimension_ = 2;
  double grid_ = 0;
};

// A knot: of several equal ones the outermost in the direction of the drag, or all of them.
class KnotGrip {
 public:
  // `first` is the index of the first of the equal knots.
  KnotGrip(const Session&, const CurveAddress&, std::size_t first, const KnotAxis&, double mouse_x);

  const CurveAddress& curve() const { return address_; }
  const Inputs<Exact>& before() const { return before_; }
  void rebase(const Inputs<Exact>& inputs) { before_ = inputs; }
  Exact value(double mouse_x, const GripKeys&) const;
  std::size_t index(double mouse_x, const GripKeys&) const;  // of the knot that is meant
  Edited edited(const Algorithm&, double mouse_x, const GripKeys&) const;

 private:
  Inputs<Exact> before_;
  CurveAddress address_;
  std::size_t first_ = 0, last_ = 0;
  Exact from_, begin_, end_;  // the knot; the domain
  double mouse_x_ = 0, per_unit_ = 1;
};

// The input u, within the domain.
class ParameterGrip {
 public:
  // Taken at its marker; or `jumps`: where the mouse is, there u is to be.
  ParameterGrip(const Session&, const KnotAxis&, double mouse_x, bool jumps);

  const Inputs<Exact>& before() const { return before_; }
  void rebase(const Inputs<Exact>& inputs) { before_ = inputs; }
  Exact value(double mouse_x, const GripKeys&) const;
  Edited edited(const Algorithm&, double mouse_x, const GripKeys&) const;

 private:
  Inputs<Exact> before_;
  Exact from_, begin_, end_;
  double at_ = 0;  // the parameter under mouse_x_
  double mouse_x_ = 0, per_unit_ = 1;
  bool jumps_ = false;
};

using Grip = std::variant<LookGrip, StuckGrip, PointGrip, KnotGrip, ParameterGrip>;

// What dragging this value of the trace is: of its point if it is a given one, otherwise why not.
Grip grip_of_value(const Session&, ValueId, const Camera&, ViewSize, glm::dvec2 mouse);

// The distance of the lines of the grid that is drawn.
double grid_spacing(const Session&, const Camera&, ViewSize);

// Of begin + k/n (end - begin) with n from 1 to 12 the one nearest to a value; k may be any whole number.
Exact nearest_fraction(double value, const Exact& begin, const Exact& end);

// Where a point goes that is added behind this one: halfway to the next, or as far on as half the last leg.
Point<Exact> place_behind(const Curve<Exact>&, std::size_t point);

// The world axis (0, 1, 2) that runs most along a direction of the page, and whether it does so backwards.
struct PageAxis {
  int axis = 0;
  bool backwards = false;
};
PageAxis nearest_axis(const Camera&, int dimension, const glm::dvec3& direction);

}  // namespace blossom
