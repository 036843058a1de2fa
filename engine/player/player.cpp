#include "player/player.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lesson/file_kind.hpp"
#include "studio/scene_file.hpp"

namespace blossom {

namespace fs = std::filesystem;

namespace {

constexpr double motion_seconds = 0.45, glide_seconds = 0.3, notice_seconds = 5, look_seconds = 0.5, keep_seconds = 1.5;
constexpr std::size_t most_ringed = 6;  // of what a lesson points out

double eased(double t) { return t * t * (3 - 2 * t); }

// What is opened in the studio wherever one is; a curve alone goes there only if one is in it.
bool is_for_studio(const JsonDocument& json) {
  const FileKind kind = file_kind(json.root());
  return kind == FileKind::scene || kind == FileKind::surface;
}

}  // namespace

Player::Player(PlayerOptions options, Desk& desk) : options_(std::move(options)), desk_(&desk) {
  Diagnostics wrong;
  settings = sane(load_settings(options_.places, wrong));
  kept_settings_ = settings;
  progress_ = load_progress(options_.places, wrong);
  if (!wrong.empty()) show_problems("What was remembered could not all be read", std::move(wrong));
  lost_ = blossom::lost_work(options_.places);
  autosave_ = autosave_file(options_.places);
  scene_autosave_ = autosave_file(options_.places);
}

Player::~Player() {
  // What is unsaved when somebody quits was given up on purpose; when the system ends the player, it is offered again.
  if (quit_) {
    if (session_) session_->mark_saved();
    for (const auto& parked : parked_)
      if (parked) parked->mark_saved();
  }
  if (studio_ && quit_) studio_->mark_saved(studio_->file());
  keep();
}

// ---- what is open ---------------------------------------------------------------------------------------------------

bool Player::open(const fs::path& file, std::string_view algorithm) {
  if (const auto json = JsonDocument::load(file); json && algorithm.empty() && is_for_studio(*json))
    return open_into_scene(*json, file);
  auto document = open_document(file, algorithm);
  if (!document) {
    show_problems(printable(file.filename().string()) + " cannot be opened", std::move(document.diagnostics));
    return false;
  }
  return open(std::move(*document));
}

bool Player::open(Document document) {
  if (!begin(std::move(document))) return false;
  studio_.reset();
  return true;
}

bool Player::begin(Document document) {
  const fs::path file = document.file;
  auto session = Session::open(std::move(document), settings.exact);
  if (!session) {
    show_problems(printable(file.filename().string()) + " cannot be run", std::move(session.diagnostics));
    return false;
  }
  remember_progress();
  notice_.clear();
  session_ = std::move(*session);
  session_->speak(settings.language);
  forget_lesson();
  dismiss_problems();
  forget_what_was_about();
  dialog = Dialog::none;
  tab = session_->document().kind == Document::Kind::exercise ? "predict" : "tableau";
  watch_ = file.empty() || !options_.watch ? FileWatch() : FileWatch(file);
  session_->move([&](Timeline& t) { return t.set_speed(settings.speed), false; });
  if (!file.empty()) {
    remember_file(file);
    go_on_where_one_was(file);
  }
  enter_scene();
  if (session_->document().kind == Document::Kind::exercise)
    if (auto wrong = session_->start_prediction(); !wrong.empty())
      show_problems("This exercise cannot be answered here", std::move(wrong));
  to_keep_ = true;
  return true;
}

// Of another document, or another algorithm.
void Player::forget_what_was_about() {
  pin({});
  hovered_ = focused = {};
  linked_.reset();
  emphasis_key_.reset();
  why_.reset();
  camera_.reset();
  glide_.reset();
  curve = 0;
  open_phases.clear();
  forget_questions();
  held_.reset();
  motion_ = 1;
}

void Player::remember_file(const fs::path& file) {
  std::erase(settings.recent, file);
  settings.recent.insert(settings.recent.begin(), file);
  if (settings.recent.size() > most_recent) settings.recent.resize(most_recent);
}

void Player::unless_unsaved(std::function<void(Player&)> then) {
  unless_session_unsaved([then = std::move(then)](Player& player) { player.unless_scene_unsaved(then); });
}

void Player::unless_session_unsaved(std::function<void(Player&)> then) {
  // What one practised in a lesson is not handed in.
  const bool answers = answers_unsaved() && session_->document().kind == Document::Kind::exercise;
  if (!session_ || (!would_be_missed() && !answers)) return then(*this);
  after_unsaved_ = std::move(then);
  asks_about_scene_ = false;
  dialog = Dialog::unsaved;
}

void Player::unless_scene_unsaved(std::function<void(Player&)> then) {
  if (!studio_ || !studio_->unsaved()) return then(*this);
  after_unsaved_ = std::move(then);
  asks_about_scene_ = true;
  dialog = Dialog::unsaved;
}

void proceed_after_unsaved(Player& player) {
  const auto then = std::exchange(player.after_unsaved_, nullptr);
  player.dialog = Dialog::none;
  if (then) then(player);  // what it opens takes the place of the edits; where it cannot be opened they are still there
}

void Player::cancel_dialog() {
  dialog = Dialog::none;
  after_unsaved_ = nullptr;
}

void Player::close() {
  remember_progress();
  session_.reset();
  parked_.clear();
  cancel_export();
  studio_.reset();
  held_.reset();
  watch_ = scene_watch_ = FileWatch();
  dismiss_problems();
  dialog = Dialog::none;
  to_keep_ = true;
}

void Player::recover(std::size_t which) {
  unless_unsaved([which](Player& player) { player.recover_now(which); });
}

void Player::recover_now(std::size_t which) {
  if (which >= lost_.size()) return;
  const Autosave lost = lost_[which];
  auto parsed = JsonDocument::parse(lost.file.filename().string(), lost.content);
  if (parsed && is_for_studio(*parsed)) return recover_scene(which, *parsed);
  auto document = parsed ? read_document(std::move(*parsed)) : Checked<Document>(parsed.diagnostics);
  if (!document) return show_problems("The recovered edits cannot be opened", std::move(document.diagnostics));
  // The original stays what the edits are edits of, if it can still be read.
  std::vector<Inputs<Exact>> edited{document->inputs};
  for (std::size_t i = 1; document->lesson && i < document->lesson->scene_count(); ++i)
    edited.push_back(document->lesson->scene_at(i).inputs);
  auto original = lost.origin.empty() ? Checked<Document>() : open_document(lost.origin, document->algorithm->id);
  const bool has_original = original && original->algorithm == document->algorithm;
  if (has_original) document = std::move(original);
  if (!open(std::move(*document))) return;
  // The scene that was edited last is the one that is shown.
  for (std::size_t i = std::min(scene_count(), edited.size()); i-- > 0;) {
    if (scene_count() > 1 && edited[i] == session_->document().lesson->scene_at(i).inputs) continue;
    show_scene(i);
    if (!edit(Edited(edited[i]), "recovered edits")) return;
  }
  session_->seek(lost.step);
  if (!has_original) session_->mark_never_saved();
  keep();  // they are in an autosave of our own before the old one goes
  forget_lost(which);
  notice(has_original ? "The edits are back. Undo shows the file without them."
                      : "The edits are back. The file they were made in cannot be opened any more.");
}

void Player::forget_lost(std::size_t which) {
  if (which >= lost_.size()) return;
  discard(lost_[which]);
  lost_.erase(lost_.begin() + static_cast<std::ptrdiff_t>(which));
  if (lost_.empty() && dialog == Dialog::recover) dialog = Dialog::none;
}

void Player::show_problems(std::string what, Diagnostics list) {
  std::ranges::stable_sort(list, {}, [](const Diagnostic& wrong) { return std::tuple(wrong.line, wrong.column); });
  problems_ = {std::move(what), std::move(list)};
  notice_.clear();  // that all was well before
}

void Player::notice(std::string text) {
  notice_ = std::move(text);
  notice_left_ = notice_seconds;
}

// ---- what is lit ----------------------------------------------------------------------------------------------------

void Player::pin(const Link& link) {
  if (!link || is_pinned(link)) {
    pin_.reset();
    return;
  }
  if (link.kind == Link::Kind::value && (!session_ || link.id >= session_->recording().graph().value_count())) return;
  pin_ = Pin{link, link.kind == Link::Kind::value && session_ ? session_->recording().graph().name(link.id) : ""};
}

Link Player::pinned() const {
  if (!pin_ || !session_) return {};
  if (pin_->link.kind != Link::Kind::value) return pin_->link;
  const auto v = session_->recording().graph().find(pin_->name);
  return v ? Link{Link::Kind::value, *v} : Link{};
}

bool Player::is_pinned(const Link& link) const { return pin_ && pinned() == link; }

void Player::ask_why(ValueId v) {
  if (!session_ || v >= session_->recording().graph().value_count()) return;
  why_ = session_->recording().graph().name(v);
  tab = "why";
}

std::optional<ValueId> Player::why_asked() const {
  return why_ && session_ ? session_->recording().graph().find(*why_) : std::nullopt;
}

const Emphasis& Player::emphasis() const {
  if (!session_) {
    static const Emphasis nothing;
    return nothing;
  }
  EmphasisKey key{session_->version(), session_->step(), hovered_ ? hovered_ : focused, pinned(), {}};
  if (const Beat* beat = session_->beat()) key.highlights = beat->highlights;
  if (emphasis_key_ != key) {
    const StepSource& source = session_->recording().source();
    // What a lesson points out stands back when somebody points at something.
    emphasis_ = merged(emphasis_of(source, key.pinned, key.step), emphasis_of(source, key.hovered, key.step));
    if (emphasis_.empty()) {
      emphasis_.lit = key.highlights;
      emphasis_.quiet = emphasis_.lit.size() > most_ringed;
    }
    emphasis_key_ = std::move(key);
  }
  return emphasis_;
}

// ---- how it is looked at --------------------------------------------------------------------------------------------

void Player::set_camera(const std::optional<Camera>& camera) {
  glide_.reset();
  camera_is_lessons_ = false;
  camera_ = camera;
}

Camera Player::shown_camera() const {
  if (camera_ || !session_) return camera_.value_or(Camera{});
  std::optional<Camera> look;
  if (session_->recording().source().spatial()) {
    look = session_->recording().scenes().fitted(view_size_.width, view_size_.height);
    look->perspective = settings.perspective;
  }
  return session_->recording().scenes().fitted(view_size_.width, view_size_.height, look);
}

void Player::glide_to(const std::optional<Camera>& to) {
  const Camera from = shown_camera();
  glide_.reset();
  camera_is_lessons_ = false;
  camera_ = to;
  if (settings.reduced_motion) return;
  glide_ = Glide{from, shown_camera(), !to, 0};
  camera_ = from;
}

// ---- saving ---------------------------------------------------------------------------------------------------------

void Player::save_lesson(const fs::path& file, const std::string& id, const std::string& title) {
  if (!session_) return;
  const auto saved = write_file(file, as_lesson(session_->document(), session_->inputs(), id, title, parked_edits()));
  if (!saved) return show_problems("The lesson could not be saved", saved.diagnostics);
  session_->mark_saved();
  for (const auto& parked : parked_)
    if (parked) parked->mark_saved();
  dialog = Dialog::none;
  notice("Saved as " + printable(file.string()));
  if (after_unsaved_) proceed_after_unsaved(*this);
}

void Player::save_picture(const fs::path& file) {
  if (in_studio()) {
    WorkspaceLook look = studio_->look();
    look.camera = studio_->camera_of(studio_->pane);
    look.handles = false;
    const ViewSize size = studio_->pane_sizes[static_cast<std::size_t>(studio_->pane)];
    const Scene page = studio_->scenes().page(studio_->workspace(), look, size.width, size.height);
    const auto saved = desk_->save_picture(page, file);
    if (!saved) return show_problems("The picture could not be saved", saved.diagnostics);
    dialog = Dialog::none;
    return notice("Saved as " + printable(file.string()));
  }
  if (!session_) return;
  PageOptions options;
  options.title = title();
  const Scene page = session_->recording().scenes().page(session_->step(), session_->words().text, options);
  const auto saved = desk_->save_picture(page, file);
  if (!saved) return show_problems("The picture could not be saved", saved.diagnostics);
  dialog = Dialog::none;
  notice("Saved as " + printable(file.string()));
}

void Player::save_answers(const fs::path& file) {
  if (!session_ || session_->prediction() == nullptr) return;
  const auto saved = write_file(file, session_->prediction()->answers_file());
  if (!saved) return show_problems("The answers could not be saved", saved.diagnostics);
  saved_answers_ = session_->prediction()->answers_file();
  notice("Saved as " + printable(file.string()));
  if (after_unsaved_) proceed_after_unsaved(*this);
}

// ---- time -----------------------------------------------------------------------------------------------------------

void Player::step_changed() {
  motion_ = settings.reduced_motion ? 1 : 0;
  to_keep_ = true;
  stay_left_ = 0;
  follow_lesson();
}

void Player::settle() {
  settle_studio();
  if (in_studio()) return linked_.reset();
  if (!session_) {
    linked_.reset();
    hovered_ = focused = {};
    return;
  }
  const auto now = session_->shared_recording();
  if (linked_ && linked_ != now) {
    for (Link* link : {&hovered_, &focused}) {
      if (link->kind == Link::Kind::phase) *link = {};
      if (link->kind != Link::Kind::value) continue;
      const auto v =
          link->id < linked_->graph().value_count() ? now->graph().find(linked_->graph().name(link->id)) : std::nullopt;
      *link = v ? Link{Link::Kind::value, *v} : Link{};
    }
    std::erase_if(open_phases, [&](std::uint32_t phase) { return phase >= now->graph().phases().size(); });
    curve = std::min(curve, std::max<std::size_t>(now->source().curves.size(), 1) - 1);
  }
  linked_ = now;
  session_->speak(settings.language);
  follow_lesson();
}

void Player::seek_value(ValueId v) {
  if (session_ && v < session_->recording().graph().value_count()) seek(session_->recording().graph().value(v).step);
}

void Player::seek(std::uint32_t step) {
  move([=](Timeline& t) { return t.seek(step); });
}

bool Player::edit(Edited edited, const std::string& what, const std::string& gesture) {
  if (!session_ || !session_->edit(std::move(edited), what, gesture)) return false;
  after_edit();
  return true;
}

void Player::after_edit() {
  motion_ = 1;  // an edited step stands still
  to_keep_ = true;
}

bool Player::animating() const {
  return motion_ < 1 || glide_.has_value() || (session_ && session_->timeline().playing()) ||
         (in_studio() && studio_->running());
}

bool Player::advance(double seconds) {
  bool changed = false;
  if (session_ && session_->timeline().playing()) {
    play_on(seconds);
    changed = true;
  }
  skip_asked_for_ += seconds;
  if (take_export_news()) changed = true;
  if (motion_ < 1) {
    // At a high speed the motion fits into the step.
    const bool playing = session_ && session_->timeline().playing();
    const double length = playing ? std::min(motion_seconds, 0.7 / settings.speed) : motion_seconds;
    motion_ = settings.reduced_motion ? 1 : std::min(1.0, motion_ + seconds / length);
    changed = true;
  }
  if (glide_) {
    glide_->t = std::min(1.0, glide_->t + seconds / glide_seconds);
    camera_ = between(glide_->from, glide_->to, eased(glide_->t));
    if (glide_->t >= 1) {
      if (glide_->fitted_after) camera_.reset();
      glide_.reset();
    }
    changed = true;
  }
  if (in_studio() && studio_->advance(seconds)) changed = true;
  if (notice_left_ > 0) {
    notice_left_ -= seconds;
    if (notice_left_ <= 0) {
      notice_.clear();
      changed = true;
    }
  }
  if (!session_ && !studio_ && !shelf_) shelf_ = std::make_unique<Shelf>(options_.lessons, options_.exercises);
  if (shelf_ && shelf_->version() != shelf_seen_) {
    shelf_seen_ = shelf_->version();
    changed = changed || !session_;
  }
  since_look_ += seconds;
  if (since_look_ >= look_seconds) {
    since_look_ = 0;
    if (session_ && watch_.poll()) {
      look_at_disk();
      changed = true;
    }
    if (studio_ && scene_watch_.poll()) {
      look_at_scene_on_disk();
      changed = true;
    }
    if ((session_ && watch_.has_gone()) || (studio_ && scene_watch_.has_gone())) {
      notice("The file is not there any more. What is shown is its last version.");
      changed = true;
    }
  }
  since_keep_ += seconds;
  if (since_keep_ >= keep_seconds) {
    since_keep_ = 0;
    const bool scene_changed = studio_ && studio_->version() != scene_kept_;
    if (to_keep_ || scene_changed || !(settings == kept_settings_)) keep();
  }
  return changed;
}

void Player::look_at_disk() {
  const fs::path file = session_->document().file;
  auto document = open_document(file, session_->algorithm().id);
  if (!document) {
    show_problems(
        printable(file.filename().string()) + " was changed and has mistakes; what is shown is its last good version",
        std::move(document.diagnostics));
    return;
  }
  // What is held was of the file as it was.
  if (held_) {
    session_->end_gesture();
    held_ = Held{StuckGrip{}, {}, {}, true, true};
  }
  const bool other = document->algorithm != &session_->algorithm();
  if (!reload_scenes(std::move(*document))) return;
  dismiss_problems();
  if (other) forget_what_was_about();
  settle();
  after_edit();
  notice("The file was changed on disk and is loaded again.");
}

void Player::remember_progress() {
  if (!session_ || session_->document().file.empty()) return;
  Progress& known = progress_[session_->document().file.string()];
  known.seen = 0;  // now
  if (scene_count() > 1) {
    known.scene = session_->document().lesson_scene()->scene;
    known.scene_count = static_cast<std::uint32_t>(scene_count());
    static_cast<ScenePlace&>(known) = known.scenes[known.scene];
  }
  known.step = session_->step();
  known.last = session_->last();
  known.furthest = std::max(known.furthest, known.step);
  known.bookmarks = session_->bookmarks();
  if (scene_count() > 1) known.scenes[known.scene] = known;
  known.answers = checkpoints_.answers();
  known.skipped = checkpoints_.skipped();
  known.asked = static_cast<std::uint32_t>(checkpoints_.items().size());
  known.right = static_cast<std::uint32_t>(checkpoints_.right());
  if (const Prediction* prediction = session_->prediction())
    if (const auto grade = prediction->grade()) known.best_score = std::max(known.best_score, grade->score());
}

const Progress* Player::progress(const fs::path& file) const {
  const auto found = progress_.find(file.string());
  return found != progress_.end() ? &found->second : nullptr;
}

void Player::keep() {
  to_keep_ = false;
  remember_progress();
  Diagnostics wrong;
  const auto note = [&](const Checked<bool>& saved) {
    wrong.insert(wrong.end(), saved.diagnostics.begin(), saved.diagnostics.end());
  };
  if (!options_.places.config.empty() && !(settings == kept_settings_)) note(save_settings(options_.places, settings));
  kept_settings_ = settings;
  if (options_.places.state.empty()) return;
  note(save_progress(options_.places, progress_));
  if (session_ && unsaved()) {
    const Document& document = session_->document();
    note(write_autosave(
        options_.places,
        {autosave_, document.file, document.title(),
         as_lesson(document, session_->inputs(), document.id(), document.title(), parked_edits()), session_->step()}));
  } else {
    discard({autosave_, {}, {}, {}, 0});
  }
  if (studio_) scene_kept_ = studio_->version();
  if (studio_ && studio_->unsaved())
    note(write_autosave(options_.places,
                        {scene_autosave_, studio_->file(), studio_->title(), write_scene(studio_->workspace()), 0}));
  else
    discard({scene_autosave_, {}, {}, {}, 0});
  if (!wrong.empty() && notice_.empty()) notice("What should be remembered could not be written: " + wrong[0].message);
}

}  // namespace blossom
