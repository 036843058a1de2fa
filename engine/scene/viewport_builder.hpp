#pragma once
// Builds the geometry of one step. Internal to the scene: StepScenes::viewport is the way in.

#include <algorithm>
#include <tuple>

#include "scene/scene_samples.hpp"
#include "scene/step_scene.hpp"
#include "scene/strokes.hpp"

namespace blossom {

// What the current step does to two points: A and B are divided at M, where the share a of the segment lies before it.
// The shares of the formula are a and 1 - a, too, but for a rational curve, whose weights move M.
struct Division {
  glm::dvec3 A, B, M;
  double a = 0;
  std::string share, other;  // as the formula has them
  bool swapped = false;      // the share is that of the second part
};

class ViewportBuilder {
 public:
  ViewportBuilder(const StepSource& source, const SceneSamples& samples, std::uint32_t step,
                  const ViewportOptions& options, Sheet& sheet)
      : source_(source),
        graph_(*source.graph),
        samples_(samples),
        step_(step),
        options_(options),
        motion_(options.motion < 1 ? std::max(options.motion, 0.0) : 1),
        sheet_(sheet),
        view_(sheet.view),
        last_(step + 1 == graph_.step_count()),
        surface_done_(last_ && !samples.surface().mesh.indices.empty()),
        size_(source.spatial() ? 0.75 : 1),
        main_(graph_.main_value(step)),
        around_(graph_.phase_path(graph_.step(step).phase)) {
    std::tie(first_new_, end_new_) = graph_.values_of(step);
    if (main_ != absent && !graph_.is_input(main_)) {
      const auto from = graph_.operands(main_);
      operands_.assign(from.begin(), from.end());
      std::ranges::sort(operands_);
    }
    // A step that writes down a whole polygon has no single value to look at.
    single_ = main_ != absent && end_new_ - first_new_ <= 3;
    division_ = division_of_step();
  }

  void build() {
    if (options_.grid) add_grid();
    add_hulls();
    add_curves();
    add_lifted();
    find_shown();
    add_rays();
    add_rows();
    if (last_)
      for (const auto& piece : samples_.result) view_.polylines.push_back(line(piece, Role::curve_result, 1, true));
    add_points();
    add_arrows();
    add_shares();
    add_lit_elsewhere();
    add_step();
  }
  void add_spots();

 private:
  bool made_now(ValueId v) const { return v >= first_new_ && v < end_new_ && !graph_.is_input(v); }
  bool read_now(ValueId v) const { return std::ranges::binary_search(operands_, v); }
  bool is_around(const Drawable& d) const {
    return d.phase == absent || std::ranges::find(around_, d.phase) != around_.end();
  }
  bool in_net(const Drawable& d) const {  // of the finished surface
    return d.draw == ValueSpec::Draw::net && !d.given;
  }
  // What a finished surface was fitted to: one looks at how near it comes.
  bool is_data(const Drawable& d) const { return d.given && source_.algorithm->family == Family::fitting; }
  // A level of a triangular scheme in one row (or column) of several that was finished before.
  bool is_over(const Drawable& d) const {
    if (d.draw != ValueSpec::Draw::level) return false;
    std::uint32_t phase = d.phase;  // the scoped one is the row
    while (phase != absent && !graph_.phases()[phase].scoped) phase = graph_.phases()[phase].parent;
    return phase != absent && graph_.phases()[phase].last_step < step_;
  }
  // Where it is at this moment of the step.
  glm::dvec3 place(ValueId v) const {
    if (motion_ < 1 && v == main_ && division_) return division_->A + motion_ * (division_->M - division_->A);
    return *source_.points[v];
  }
  Role role_of(const Drawable& d) const {
    if (d.given) return step_ < d.gone ? Role::control_point : Role::retired;
    return surface_done_ ? Role::control_point : d.role;
  }

  std::optional<Division> division_of_step() const;
  void add_grid();
  void add_hulls();
  void add_curves();
  void add_lifted();
  void add_rays();
  void find_shown();
  void thin_out();
  void add_rows();
  void add_rows_along(bool rows);
  void add_points();
  void add_arrows();
  void add_name(const Drawable&, std::size_t position, bool many_new);
  std::size_t most_labels() const;
  bool hidden(ValueId) const;  // behind the finished surface
  void add_shares();
  void add_lit_elsewhere();
  void add_step();
  void add_division(const Division&);
  void add_ring(const glm::dvec3& at, double size) {
    view_.markers.push_back(marker(at, Role::highlight, size, Marker::Shape::ring));
  }

  const StepSource& source_;
  const TraceGraph& graph_;
  const SceneSamples& samples_;
  std::uint32_t step_;
  const ViewportOptions& options_;
  double motion_;
  Sheet& sheet_;
  View& view_;
  bool last_, surface_done_;
  double size_;  // of markers
  ValueId main_;
  std::vector<std::uint32_t> around_;  // phases
  ValueId first_new_ = 0, end_new_ = 0;
  std::vector<ValueId> operands_;  // ascending
  bool single_ = false;
  std::optional<Division> division_;
  std::vector<const Drawable*> shown_;    // by value
  bool crowded_ = false;                  // a net has very many points
  std::size_t names_ = 0;                 // of points of the finished surface
  int stride_ = 1;                        // of the first indices of a net that was thinned out
  mutable std::vector<glm::dvec3> seen_;  // the surface's mesh in the view: x, y, and z toward the viewer
};

}  // namespace blossom
