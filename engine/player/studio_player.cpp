// The studio in the player: scenes opened and saved, what is designed stepped, and the way back.
#include <algorithm>

#include "geometry/document.hpp"
#include "lesson/file_kind.hpp"
#include "player/player.hpp"
#include "studio/scene_file.hpp"

namespace blossom {

namespace fs = std::filesystem;

namespace {

// A title as a name of things: its letters, or "scene".
std::string id_of(const fs::path& file) {
  std::string id;
  for (const char c : file.stem().string()) {
    const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool letter = ('a' <= small && small <= 'z') || ('0' <= small && small <= '9');
    if (letter || (!id.empty() && id.back() != '-')) id += letter ? small : '-';
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id.empty() ? "scene" : id.substr(0, 64);
}

SceneObject object_of(const Workspace& workspace, std::string name, Geometry geometry) {
  SceneObject object;
  object.name = free_name(workspace, name.substr(0, 48));
  object.color = static_cast<int>(workspace.objects.size() % object_colors);
  object.shows = usual_shows(geometry);
  const Range range = domain_of(geometry);
  object.u = Exact((range.first.x + range.last.x) / 2);
  object.v = Exact((range.first.y + range.last.y) / 2);
  object.geometry = std::move(geometry);
  return object;
}

}  // namespace

// ---- opening --------------------------------------------------------------------------------------------------------

void Player::new_scene() {
  unless_unsaved([](Player& player) {
    Workspace empty;
    empty.id = "scene";
    player.open_scene(std::move(empty));
  });
}

void Player::open_scene(Workspace workspace, const fs::path& file) {
  remember_progress();
  session_.reset();
  studio_ = std::make_unique<Studio>(std::move(workspace), file);
  refusals_seen_ = 0;
  scene_kept_ = studio_->version();
  dismiss_problems();
  forget_what_was_about();
  settle();
  dialog = Dialog::none;
  tab = studio_tab_ = studio_->workspace().objects.empty() ? "make" : "shape";
  focus.clear();
  watch_ = FileWatch();
  scene_watch_ = file.empty() || !options_.watch ? FileWatch() : FileWatch(file);
  if (!file.empty()) remember_file(file);
  to_keep_ = true;
}

void Player::open_asking(const fs::path& file) {
  const auto json = JsonDocument::load(file);
  const FileKind kind = json ? file_kind(json->root()) : FileKind::unknown;
  if (in_studio() && (kind == FileKind::curve || kind == FileKind::surface)) {
    dialog = Dialog::none;
    open_into_scene(*json, file);
    return;
  }
  unless_unsaved([file](Player& player) { player.open(file); });
}

// A scene takes the place of what is open; a curve or a surface becomes a thing of the scene, or of a new one.
bool Player::open_into_scene(const JsonDocument& json, const fs::path& file) {
  const std::string name = printable(file.filename().string());
  std::error_code error;
  if (file_kind(json.root()) == FileKind::scene) {
    auto workspace = read_scene(json);
    if (!workspace) {
      show_problems(name + " cannot be opened", std::move(workspace.diagnostics));
      return false;
    }
    open_scene(std::move(*workspace), fs::absolute(file, error).lexically_normal());
    return true;
  }
  Diagnostics wrong;
  const Cursor root(json, wrong);
  std::optional<Geometry> geometry;
  if (file_kind(json.root()) == FileKind::surface) {
    if (auto surface = read_surface(root)) geometry = std::move(*surface);
  } else if (auto read = read_curve(root)) {
    geometry = std::move(*read);
  }
  if (!geometry) {
    show_problems(name + " cannot be opened", std::move(wrong));
    return false;
  }
  if (!in_studio()) open_scene({});
  Workspace workspace = studio_->workspace();
  SceneObject object = object_of(workspace, id_of(file), std::move(*geometry));
  if (!studio_->edit(edit::add(std::move(workspace), std::move(object)), name + " added")) return false;
  studio_->choose(studio_->workspace().objects.size() - 1);
  return true;
}

void Player::recover_scene(std::size_t which, const JsonDocument& json) {
  auto edited = read_scene(json);
  if (!edited) return show_problems("The recovered scene cannot be opened", std::move(edited.diagnostics));
  const fs::path origin = lost_[which].origin;
  auto original = origin.empty() ? Checked<Workspace>() : load_scene(origin);
  const bool has_original = static_cast<bool>(original);
  open_scene(has_original ? std::move(*original) : Workspace{}, has_original ? origin : fs::path());
  studio_->edit(std::move(edited), "recovered edits");
  if (!has_original) studio_->mark_never_saved();
  keep();  // they are in an autosave of our own before the old one goes
  forget_lost(which);
  notice(has_original ? "The scene is back. Undo shows the file without the edits." : "The scene is back.");
}

// ---- stepping -------------------------------------------------------------------------------------------------------

void Player::step_chosen() {
  if (!in_studio() || !studio_->current()) return;
  studio_->finish_drawing();
  if (studio_->object()->recipe && studio_->chosen().size() == 1) {
    step_made(*studio_->current());
    return;
  }
  dialog = Dialog::step_with;
}

bool Player::step_made(std::size_t object) {
  if (!studio_ || object >= studio_->workspace().objects.size()) return false;
  const SceneObject& made = studio_->workspace().objects[object];
  if (!made.recipe) return false;
  return step(*made.recipe, object, made.name + ": " + std::string(made.recipe->algorithm->title));
}

bool Player::step_with(const Algorithm& algorithm) {
  if (!studio_ || !studio_->current()) return false;
  const std::string title = studio_->object()->name + ": " + std::string(algorithm.title);
  return step(recipe_for(algorithm, studio_->workspace(), studio_->chosen()), studio_->workspace().objects.size(),
              title);
}

bool Player::step(const Recipe& recipe, std::size_t before, std::string title) {
  auto inputs = inputs_of(studio_->workspace(), recipe, before);
  if (!inputs) {
    show_problems(title + " cannot be stepped", std::move(inputs.diagnostics));
    return false;
  }
  Document document;
  document.algorithm = recipe.algorithm;
  document.inputs = std::move(*inputs);
  document.called = std::move(title);
  studio_->run(false);
  const std::string tab_before = tab;
  if (!begin(std::move(document))) return false;
  studio_tab_ = tab_before;
  focus.clear();
  notice("Escape leads back to the studio.");
  return true;
}

void Player::back_to_studio() {
  if (!stepping_from_studio()) return;
  unless_session_unsaved([](Player& player) {
    player.session_.reset();
    player.watch_ = FileWatch();
    player.forget_what_was_about();
    player.dismiss_problems();
    player.dialog = Dialog::none;
    player.tab = player.studio_tab_;
    player.focus.clear();
    player.to_keep_ = true;
    player.settle();
  });
}

// ---- saving ---------------------------------------------------------------------------------------------------------

void Player::save_scene() {
  if (!studio_) return;
  if (studio_->file().empty())
    dialog = Dialog::save_scene;
  else
    save_scene(studio_->file(), studio_->workspace().title);
}

void Player::save_scene(const fs::path& file, const std::string& title) {
  if (!studio_) return;
  studio_->finish_drawing();
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error).lexically_normal();
  Workspace workspace = studio_->workspace();
  if (workspace.title != title || workspace.id.empty() || studio_->file() != absolute) {
    workspace.title = title;
    workspace.id = id_of(absolute);
    if (!(workspace == studio_->workspace())) studio_->edit(Worked(workspace), "title");
  }
  const auto saved = write_file(absolute, write_scene(workspace));
  if (!saved) return show_problems("The scene could not be saved", saved.diagnostics);
  studio_->mark_saved(absolute);
  scene_watch_ = options_.watch ? FileWatch(absolute) : FileWatch();
  remember_file(absolute);
  dialog = Dialog::none;
  to_keep_ = true;
  notice("Saved as " + printable(absolute.string()));
  if (after_unsaved_) proceed_after_unsaved(*this);
}

void Player::look_at_scene_on_disk() {
  auto workspace = load_scene(studio_->file());
  const std::string name = printable(studio_->file().filename().string());
  if (!workspace)
    return show_problems(name + " was changed and has mistakes; what is shown is its last good version",
                         std::move(workspace.diagnostics));
  dismiss_problems();
  const std::uint64_t before = studio_->version();
  studio_->reload(std::move(*workspace));
  settle();
  if (studio_->version() != before) notice("The file was changed on disk and is loaded again.");
}

// What was refused is said, and what the keyboard was on may be there no more.
void Player::settle_studio() {
  if (!studio_) return;
  if (studio_->refusals() != refusals_seen_) {
    refusals_seen_ = studio_->refusals();
    if (!studio_->problems().empty()) notice(studio_->problems()[0].message);
  }
  const auto& objects = studio_->workspace().objects;
  for (Link* link : {&hovered_, &focused})
    if (link->kind == Link::Kind::object &&
        (link->id >= objects.size() || link->part > point_count(objects[link->id].geometry)))
      *link = {};
}

}  // namespace blossom
