#include "player/studio.hpp"

#include <algorithm>

#include "studio/seams.hpp"

namespace blossom {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_of(const Workspace& workspace) {
  std::vector<std::string> names;
  for (const SceneObject& object : workspace.objects) names.push_back(object.name);
  return names;
}

// Where one looks at things is not what one designs.
bool same_design(const Workspace& a, const Workspace& b) {
  if (a.id != b.id || a.title != b.title || a.summary != b.summary || a.look != b.look) return false;
  return std::ranges::equal(a.objects, b.objects, [](const SceneObject& x, const SceneObject& y) {
    return x.name == y.name && x.geometry == y.geometry && x.recipe == y.recipe && x.color == y.color &&
           x.hidden == y.hidden && x.shows == y.shows && x.map == y.map;
  });
}

bool is_spatial(const Geometry& geometry) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) return curve->dimension == 3;
  if (const auto* row = std::get_if<PointRow<Exact>>(&geometry)) return row->dimension == 3;
  return true;
}

StudioPane first_pane(const Workspace& workspace) {
  if (workspace.look) return static_cast<StudioPane>(workspace.look->from);
  const bool spatial = std::ranges::any_of(workspace.objects, [](const auto& o) { return is_spatial(o.geometry); });
  return spatial ? StudioPane::space : StudioPane::xy;
}

}  // namespace

std::string_view tool_name(Tool tool) {
  static constexpr std::string_view names[] = {"choose", "draw", "insert", "erase"};
  return names[static_cast<std::size_t>(tool)];
}

Studio::Studio() : Studio(Workspace{}) {}

Studio::Studio(Workspace workspace, fs::path file)
    : history_(workspace),
      saved_(std::move(workspace)),
      file_(std::move(file)),
      scenes_(std::make_unique<WorkspaceScenes>()) {
  const Workspace& scene = history_.current();
  pane = first_pane(scene);
  if (scene.look) perspective = scene.look->perspective;
  // What one looks at first is what all of it leads to.
  for (std::size_t i = scene.objects.size(); i-- > 0 && chosen_.empty();)
    if (!scene.objects[i].hidden) chosen_ = {i};
}

// ---- the scene ------------------------------------------------------------------------------------------------------

std::string Studio::title() const {
  if (!workspace().title.empty()) return printable(workspace().title);
  return file_.empty() ? "A new scene" : printable(file_.filename().string());
}

bool Studio::unsaved() const {
  if (!unsaved_known_ || unsaved_known_->first != version_)
    unsaved_known_ = {version_, !saved_ || !same_design(workspace(), *saved_)};
  return unsaved_known_->second;
}

void Studio::mark_saved(const fs::path& file) {
  file_ = file;
  saved_ = workspace();
  unsaved_known_.reset();
}

void Studio::reload(Workspace from_disk) {
  saved_ = from_disk;
  unsaved_known_.reset();
  if (from_disk == workspace()) return;
  held_.reset();
  stop();
  const auto names = names_of(workspace());
  history_.end_gesture();
  history_.push(std::move(from_disk), "the file changed on disk");
  take_in(names);
}

bool Studio::edit(Worked edited, const std::string& what, const std::string& gesture) {
  if (!edited) {
    problems_ = std::move(edited.diagnostics);
    ++refusals_;
    return false;
  }
  problems_.clear();
  const auto names = names_of(workspace());
  if (keep_smooth && current()) edited = seams_kept(workspace(), std::move(*edited), *current(), !gesture.empty());
  history_.push(std::move(*edited), what, gesture);
  take_in(names);
  return true;
}

bool Studio::cancel_gesture() {
  const auto names = names_of(workspace());
  if (!history_.cancel_gesture()) return false;
  take_in(names);
  return true;
}

bool Studio::undo() {
  if (!clicked_.empty()) return take_back_click();
  const auto names = names_of(workspace());
  if (!history_.undo()) return false;
  take_in(names);
  return true;
}

bool Studio::redo() {
  const auto names = names_of(workspace());
  if (!clicked_.empty() || !history_.redo()) return false;
  take_in(names);
  return true;
}

// Things may have come, gone, or changed places: what was chosen is found again by its name, or where it was renamed,
// by its place.
void Studio::take_in(const std::vector<std::string>& names) {
  ++version_;
  const auto& objects = workspace().objects;
  const auto now = [&](std::size_t before) -> std::optional<std::size_t> {
    if (before >= names.size()) return std::nullopt;
    if (before < objects.size() && objects[before].name == names[before]) return before;
    if (const auto found = workspace().index_of(names[before])) return found;
    const bool renamed =
        names.size() == objects.size() && std::ranges::find(names, objects[before].name) == names.end();
    return renamed ? std::optional(before) : std::nullopt;
  };
  std::vector<std::size_t> chosen;
  for (const std::size_t i : chosen_)
    if (const auto at = now(i)) chosen.push_back(*at);
  chosen_ = std::move(chosen);
  std::vector<PointRef> selected;
  for (const PointRef& ref : selected_)
    if (const auto at = now(ref.object); at && ref.point < point_count(objects[*at].geometry))
      selected.push_back({*at, ref.point});
  selected_ = std::move(selected);
  if (!current()) stop();
}

// ---- what is chosen -------------------------------------------------------------------------------------------------

std::optional<std::size_t> Studio::current() const {
  return chosen_.empty() ? std::nullopt : std::optional(chosen_.back());
}

const SceneObject* Studio::object() const {
  const auto i = current();
  return i ? &workspace().objects[*i] : nullptr;
}

void Studio::choose(std::optional<std::size_t> which, bool also) {
  const auto before = current();
  if (!also) {
    // Points stay selected while one stays with their thing.
    std::erase_if(selected_, [&](const PointRef& ref) { return ref.object != which; });
    chosen_.clear();
  }
  if (which && *which < workspace().objects.size()) {
    const auto found = std::ranges::find(chosen_, *which);
    if (found != chosen_.end())
      chosen_.erase(found);
    else
      chosen_.push_back(*which);
  }
  if (current() != before) {
    stop();
    history_.end_gesture();
  }
}

void Studio::choose_next(int by) {
  const auto count = static_cast<int>(workspace().objects.size());
  const auto here = current();
  int at = here ? static_cast<int>(*here) : (by > 0 ? -1 : count);
  for (int tried = 0; tried < count; ++tried) {
    at = ((at + by) % count + count) % count;
    if (!workspace().objects[static_cast<std::size_t>(at)].hidden) return choose(static_cast<std::size_t>(at));
  }
}

bool Studio::is_selected(const PointRef& ref) const { return std::ranges::find(selected_, ref) != selected_.end(); }

void Studio::select(std::vector<PointRef> points, bool also) {
  std::erase_if(points, [&](const PointRef& ref) {
    return ref.object >= workspace().objects.size() ||
           ref.point >= point_count(workspace().objects[ref.object].geometry);
  });
  history_.end_gesture();
  if (!also) selected_.clear();
  for (const PointRef& ref : points) {
    if (std::erase(selected_, ref) > 0) continue;
    selected_.push_back(ref);
  }
  if (selected_.empty()) return;
  const std::size_t of = selected_.back().object;
  if (std::ranges::find(chosen_, of) == chosen_.end()) {
    if (!also) chosen_.clear();
    chosen_.push_back(of);
    stop();
  }
}

void Studio::select_all_points() {
  const auto i = current();
  if (!i) return;
  std::vector<PointRef> all;
  for (std::size_t point = 0; point < point_count(object()->geometry); ++point) all.push_back({*i, point});
  select(std::move(all));
}

std::optional<Point<Exact>> Studio::centre() const {
  Point<Exact> sum{Exact(0), Exact(0), Exact(0)};
  int count = 0;
  const auto add = [&](const PointRef& ref) {
    if (const auto at = place_of(workspace().objects[ref.object].geometry, ref.point)) sum += *at, ++count;
  };
  for (const PointRef& ref : selected_) add(ref);
  if (selected_.empty())
    for (const std::size_t i : chosen_)
      for (std::size_t point = 0; point < point_count(workspace().objects[i].geometry); ++point) add({i, point});
  if (count == 0) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) sum[axis] /= Exact(count);
  return sum;
}

}  // namespace blossom
