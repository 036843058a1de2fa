#pragma once
// The studio, without a window: the scene one designs with its history, what is chosen, which tool one has, how it is
// looked at, and what moves by itself. Panels read it through the player and send functions that change it.

#include <array>
#include <filesystem>

#include "player/field.hpp"
#include "player/history.hpp"
#include "player/studio_grip.hpp"
#include "scene/workspace_view.hpp"
#include "studio/edit_workspace.hpp"
#include "studio/remake.hpp"

namespace blossom {

// What a click in the view does.
enum class Tool : std::uint8_t {
  choose,  // chooses and drags
  draw,    // adds points to the curve that is being drawn, or begins one
  insert,  // adds a point where the polygon is clicked
  erase,   // takes points away
};
std::string_view tool_name(Tool);  // "choose", ...

class Studio {
 public:
  Studio();  // an empty scene
  explicit Studio(Workspace, std::filesystem::path file = {});

  // ---- the scene --------------------------------------------------------------------------------------------------
  const Workspace& workspace() const { return history_.current(); }
  const History<Workspace>& history() const { return history_; }
  std::uint64_t version() const { return version_; }  // grows with every change
  const std::filesystem::path& file() const { return file_; }
  std::string title() const;  // printable
  // Where one looks at things (u and v) is kept, but nothing to be asked about when it is lost.
  bool unsaved() const;
  void mark_saved(const std::filesystem::path&);
  void mark_never_saved() { saved_.reset(), unsaved_known_.reset(); }
  // The file as it is on disk now: a state above the edits.
  void reload(Workspace);

  // Takes an edit, or says why not in problems(). `gesture` (not empty): with the last push of the same, one state.
  bool edit(Worked, const std::string& what, const std::string& gesture = {});
  const Diagnostics& problems() const { return problems_; }  // of the last edit, if it was refused
  std::uint64_t refusals() const { return refusals_; }       // how many there were
  void forget_problems() { problems_.clear(); }
  FieldTexts fields;  // what is typed into forms about the scene
  void end_gesture() { history_.end_gesture(); }
  bool cancel_gesture();
  bool undo();  // while one draws: the last click
  bool redo();
  bool can_undo() const { return history_.can_undo() || !clicked_.empty(); }

  // ---- what is chosen ---------------------------------------------------------------------------------------------
  // The current thing, if there is any: edits, panels and techniques are about it.
  std::optional<std::size_t> current() const;
  const SceneObject* object() const;                           // the current one, or nullptr
  void choose(std::optional<std::size_t>, bool also = false);  // also: keeps the others; a chosen one leaves them
  void choose_next(int by);                                    // 1 or -1, of those that are not hidden
  const std::vector<std::size_t>& chosen() const { return chosen_; }  // in the order chosen: the current one last
  const std::vector<PointRef>& selected() const { return selected_; }
  bool is_selected(const PointRef&) const;
  void select(std::vector<PointRef>, bool also = false);  // also: those that are selected already leave
  void select_all_points();                               // of the current thing
  // What moving, turning, scaling is about: the middle of the selected points, or of the chosen things.
  std::optional<Point<Exact>> centre() const;

  // ---- actions on what is chosen, each one state of the history ----------------------------------------------------
  bool add_curve(CurveKind, int degree, int dimension, std::vector<Point<Exact>> points);
  bool add_surface(CurveKind, int rows, int columns, int degree_u, int degree_v);
  bool apply(const Algorithm&);  // to what is chosen, with the usual parameters; its result is current
  bool apply(const Recipe&);
  bool remove();     // the selected points, or else the chosen things
  bool duplicate();  // the chosen things
  bool hide();       // the chosen things; again: shows them
  bool show_all();   // that is hidden
  // The selected points, or else the chosen things.
  bool move_by(const Point<Exact>& by, const std::string& gesture = {});
  // The same by a tenth of the grid, along the axis that runs most along a direction of the view.
  bool nudge(const glm::dvec3& right_up_toward);
  // Borders that two curves or surfaces share stay C1 where they are, whichever is edited (see studio/seams.hpp).
  bool keep_smooth = false;
  // Of the current thing or (for_all) of all of its kind.
  bool show(Show, bool on);
  bool for_all = false;

  // ---- drawing a curve by clicks
  // --------------------------------------------------------------------------------------
  Tool tool() const { return tool_; }
  void set_tool(Tool);  // what was being drawn is finished
  CurveKind new_kind = CurveKind::bspline;
  CurveForm new_form = CurveForm::clamped;
  int new_degree = 3;
  // The points clicked so far; a curve comes of two and grows with the others.
  const std::vector<Point<Exact>>& clicked() const { return clicked_; }
  void click(const Point<Exact>&);  // with the tool draw
  bool finish_drawing();            // Enter, or another tool; true: something was being drawn
  bool take_back_click();
  // What Escape means, one after the other: the ride ends, a click is taken back, the tool is put away, the points are
  // left. False: nothing of that.
  bool escape();
  // With the tool insert: a point of the current curve's polygon under the mouse, within `reach` of it.
  bool insert_at(StudioPane, ViewSize, glm::dvec2 at, double reach);

  // ---- how it is looked at ----------------------------------------------------------------------------------------
  bool four_panes = false;
  StudioPane pane = StudioPane::space;                    // the single one, or the one with the keyboard
  std::array<std::optional<Camera>, pane_count> cameras;  // nothing: fitted
  std::array<ViewSize, pane_count> pane_sizes{ViewSize{800, 500}, {800, 500}, {800, 500}, {800, 500}};
  bool perspective = true;
  bool gizmo = false;  // the handles stand at the centre
  double comb_scale = 1;
  double map_range = 0;  // see WorkspaceLook
  const WorkspaceScenes& scenes() const { return *scenes_; }
  WorkspaceLook look() const;  // of what is chosen and shown, without a camera
  Camera camera_of(StudioPane, ViewSize) const;
  Camera camera_of(StudioPane p) const { return camera_of(p, pane_sizes[static_cast<std::size_t>(p)]); }
  double grid_of(StudioPane, ViewSize) const;
  void fit();                // what is seen, all of it
  void zoom(double factor);  // the pane with the keyboard
  void show_pane(StudioPane);
  void set_perspective(bool);
  // Where a click in a pane lies: in the pane's plane (in space the horizontal one, or what faces the view if that is
  // seen from the edge) through the point clicked last, the current thing's last one, or the origin. On the grid if
  // `grid` is not 0.
  std::optional<Point<Exact>> place_at(StudioPane, ViewSize, glm::dvec2 at, double grid) const;
  // What a click there means where there is no control point: the thing, and where on it (see parameter_at).
  struct Hit {
    std::size_t object = 0;
    glm::dvec2 uv{0, 0};
  };
  std::optional<Hit> hit_at(StudioPane, ViewSize, glm::dvec2 at, double reach) const;

  // ---- what the mouse holds ---------------------------------------------------------------------------------------
  void take(StudioGrip);
  void drag(glm::dvec2 mouse, const GripKeys&);
  void let_go();
  bool put_back();  // true if something was held; the mouse then holds nothing until its button is released
  const StudioGrip* held() const { return held_ && !held_->over ? &held_->grip : nullptr; }
  bool holding() const { return held_.has_value(); }  // also what was put back
  glm::dvec2 held_at() const { return held_ ? held_->mouse : glm::dvec2{}; }
  GripKeys held_keys() const { return held_ ? held_->keys : GripKeys{}; }

  // ---- what moves -------------------------------------------------------------------------------------------------
  bool running() const { return running_; }  // u goes along the current thing
  bool riding() const { return riding_; }    // and the camera with it
  void run(bool on);
  void ride(bool on);
  double speed = 1;              // domains in 6 seconds
  bool advance(double seconds);  // true if something moved
  double u() const;              // of the current thing, in the domain
  double v() const;
  // One gesture; stops what runs.
  bool look_at(double u, double v);
  // The same of the current thing, with numbers as they were typed.
  bool look_at(const Exact& u, const Exact& v);

 private:
  struct Held {
    StudioGrip grip;
    glm::dvec2 mouse{};
    GripKeys keys;
    bool over = false;   // it was put back
    bool moved = false;  // an edit was made
  };
  void take_in(const std::vector<std::string>& names_before);  // after the scene has changed
  bool redraw_clicked();
  void stop();
  History<Workspace> history_{Workspace{}};
  std::optional<Workspace> saved_;
  mutable std::optional<std::pair<std::uint64_t, bool>> unsaved_known_;
  std::filesystem::path file_;
  std::uint64_t version_ = 0, refusals_ = 0;
  Diagnostics problems_;
  std::vector<std::size_t> chosen_;
  std::vector<PointRef> selected_;
  Tool tool_ = Tool::choose;
  std::vector<Point<Exact>> clicked_;
  std::string drawn_;  // the name of the curve that grows with the clicks
  bool running_ = false, riding_ = false;
  std::optional<double> moving_u_;  // while it runs
  std::optional<Held> held_;
  std::unique_ptr<WorkspaceScenes> scenes_;
};

// From where to where a thing can be looked at: u and v of the lower and the upper corner. Of points: nothing to go
// along, 0 to 0.
struct Range {
  glm::dvec2 first{0, 0}, last{0, 0};
};
Range domain_of(const Geometry&);

// A curve through which one draws: through these control points, of the degree or the highest that so few allow.
Checked<Curve<Exact>> drawn_curve(CurveKind, CurveForm, int degree, int dimension,
                                  const std::vector<Point<Exact>>& points);

}  // namespace blossom
