#include "player/player.hpp"

#include <algorithm>
#include <cmath>

namespace blossom {

namespace fs = std::filesystem;

namespace {

constexpr double motion_seconds = 0.45, glide_seconds = 0.3, notice_seconds = 5, look_seconds = 0.5, keep_seconds = 1.5;

double eased(double t) { return t * t * (3 - 2 * t); }

}  // namespace

Player::Player(PlayerOptions options, Desk& desk) : options_(std::move(options)), desk_(&desk) {
  Diagnostics wrong;
  settings = sane(load_settings(options_.places, wrong));
  kept_settings_ = settings;
  progress_ = load_progress(options_.places, wrong);
  if (!wrong.empty()) show_problems("What was remembered could not all be read", std::move(wrong));
  lost_ = blossom::lost_work(options_.places);
  autosave_ = autosave_file(options_.places);
}

Player::~Player() {
  // What is unsaved when somebody quits was given up on purpose; when the system ends the player, it is offered again.
  if (session_ && quit_) session_->mark_saved();
  keep();
}

// ---- what is open ---------------------------------------------------------------------------------------------------

bool Player::open(const fs::path& file, std::string_view algorithm) {
  auto document = open_document(file, algorithm);
  if (!document) {
    show_problems(printable(file.filename().string()) + " cannot be opened", std::move(document.diagnostics));
    return false;
  }
  return open(std::move(*document));
}

bool Player::open(Document document) {
  const fs::path file = document.file;
  auto session = Session::open(std::move(document), settings.exact);
  if (!session) {
    show_problems(printable(file.filename().string()) + " cannot be run", std::move(session.diagnostics));
    return false;
  }
  remember_progress();
  session_ = std::move(*session);
  dismiss_problems();
  pin({});
  hovered_ = focused = {};
  why_.reset();
  camera_.reset();
  glide_.reset();
  curve = 0;
  open_phases.clear();
  draft_ = {};
  chosen_question_.reset();
  predicted_place.reset();
  held_.reset();
  motion_ = 1;
  dialog = Dialog::none;
  tab = session_->document().kind == Document::Kind::exercise ? "predict" : "tableau";
  watch_ = file.empty() || !options_.watch ? FileWatch() : FileWatch(file);
  session_->move([&](Timeline& t) { return t.set_speed(settings.speed), false; });
  if (!file.empty()) {
    std::erase(settings.recent, file);
    settings.recent.insert(settings.recent.begin(), file);
    if (settings.recent.size() > 12) settings.recent.resize(12);
    if (const Progress* known = progress(file)) {
      session_->set_bookmarks(known->bookmarks);
      if (known->step > 0 && known->step < known->last && known->last == session_->last()) {
        session_->seek(known->step);
        notice("Going on at step " + std::to_string(known->step) + "; Home is the beginning.");
      }
    }
  }
  if (session_->document().kind == Document::Kind::exercise) session_->start_prediction();
  to_keep_ = true;
  return true;
}

void Player::unless_unsaved(std::function<void(Player&)> then) {
  if (!session_ || !session_->unsaved()) return then(*this);
  after_unsaved_ = std::move(then);
  dialog = Dialog::unsaved;
}

void proceed_after_unsaved(Player& player) {
  const auto then = std::exchange(player.after_unsaved_, nullptr);
  player.dialog = Dialog::none;
  if (player.session_) player.session_->mark_saved();
  if (then) then(player);
}

void Player::cancel_dialog() {
  dialog = Dialog::none;
  after_unsaved_ = nullptr;
}

void Player::close() {
  remember_progress();
  session_.reset();
  held_.reset();
  watch_ = FileWatch();
  dismiss_problems();
  dialog = Dialog::none;
  to_keep_ = true;
}

void Player::recover(std::size_t which) {
  if (which >= lost_.size()) return;
  const Autosave lost = lost_[which];
  auto parsed = JsonDocument::parse(lost.file.filename().string(), lost.content);
  auto document = parsed ? read_document(std::move(*parsed)) : Checked<Document>(parsed.diagnostics);
  if (!document) return show_problems("The recovered edits cannot be opened", std::move(document.diagnostics));
  // The original stays what the edits are edits of, if it can still be read.
  const Inputs<Exact> edited = document->inputs;
  if (auto original = lost.origin.empty() ? Checked<Document>() : open_document(lost.origin);
      original && original->algorithm == document->algorithm)
    document = std::move(original);
  if (!open(std::move(*document))) return;
  session_->seek(lost.step);
  edit(Edited(edited), "recovered edits");
  forget_lost(which);
  notice("The edits are back. Undo shows the file without them.");
}

void Player::forget_lost(std::size_t which) {
  if (which >= lost_.size()) return;
  discard(lost_[which]);
  lost_.erase(lost_.begin() + static_cast<std::ptrdiff_t>(which));
  if (lost_.empty() && dialog == Dialog::recover) dialog = Dialog::none;
}

void Player::show_problems(std::string what, Diagnostics list) { problems_ = {std::move(what), std::move(list)}; }

void Player::notice(std::string text) {
  notice_ = std::move(text);
  notice_left_ = notice_seconds;
}

// ---- what is lit ----------------------------------------------------------------------------------------------------

void Player::hover(const Link& link, std::string_view) { hovered_ = link; }

void Player::pin(const Link& link) {
  if (!link || is_pinned(link)) {
    pin_.reset();
    return;
  }
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
  if (!session_) return;
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
    if (emphasis_.empty()) emphasis_.lit = key.highlights;
    emphasis_key_ = std::move(key);
  }
  return emphasis_;
}

// ---- how it is looked at --------------------------------------------------------------------------------------------

void Player::set_camera(const std::optional<Camera>& camera) {
  glide_.reset();
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
  camera_ = to;
  if (settings.reduced_motion) return;
  glide_ = Glide{from, shown_camera(), !to, 0};
  camera_ = from;
}

// ---- predicting -----------------------------------------------------------------------------------------------------

void Player::stay_before_question() {
  if (!session_ || session_->prediction() == nullptr || !session_->prediction()->veiled(session_->step())) return;
  const Prediction& prediction = *session_->prediction();
  // One waits at the last step that gives nothing away.
  const std::size_t first = prediction.marking() == Marking::at_end ? 0 : *prediction.open();
  const Question& question = prediction.questions()[first];
  const std::uint32_t before = question.step > 0 ? question.step - 1 : 0;
  session_->move([=](Timeline& t) { return t.pause(), t.seek(before); });
  motion_ = 1;
  tab = "predict";
  notice(prediction.marking() == Marking::at_end ? "The steps are shown when all is answered."
                                                 : "First say what " + question.name + " will be, or let it be shown.");
}

std::optional<std::size_t> Player::asked() const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr) return std::nullopt;
  if (chosen_question_ && *chosen_question_ < prediction->questions().size()) return chosen_question_;
  return prediction->open();
}

void Player::choose_question(std::size_t question) {
  chosen_question_ = question;
  draft_ = {};
}

void Player::set_draft(std::size_t number, std::string text) {
  const auto question = asked();
  if (!question) return;
  if (draft_.question != *question) draft_ = {*question, {}, {}, false};
  if (draft_.numbers.size() <= number) draft_.numbers.resize(number + 1);
  draft_.numbers[number] = std::move(text);
  draft_.problem.clear();
}

bool Player::hides(std::string_view value) const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr) return false;
  for (const Question& question : prediction->questions())
    if (question.name == value) return prediction->veiled(question.step);
  return false;
}

void Player::submit_draft() {
  const auto question = asked();
  if (!question) return;
  if (draft_.question != *question) draft_ = {*question, {}, {}, false};
  Prediction& prediction = *session_->prediction();
  if (auto problem = prediction.answer(*question, draft_.numbers)) {
    draft_.problem = std::move(*problem);
    draft_.wants_keyboard = true;
    return;
  }
  chosen_question_.reset();
  draft_ = {};
  draft_.wants_keyboard = true;
  to_keep_ = true;
  const std::uint32_t step = prediction.questions()[*question].step;
  if (!prediction.veiled(step) && session_->step() < step) seek(step);
}

// ---- saving ---------------------------------------------------------------------------------------------------------

void Player::save_lesson(const fs::path& file, const std::string& id, const std::string& title) {
  if (!session_) return;
  const auto saved = write_file(file, as_lesson(session_->document(), session_->inputs(), id, title));
  if (!saved) return show_problems("The lesson could not be saved", saved.diagnostics);
  session_->mark_saved();
  dialog = Dialog::none;
  notice("Saved as " + printable(file.string()));
  if (after_unsaved_) proceed_after_unsaved(*this);
}

void Player::save_picture(const fs::path& file) {
  if (!session_) return;
  PageOptions options;
  options.title = session_->document().title();
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
  notice("Saved as " + printable(file.string()));
}

// ---- time -----------------------------------------------------------------------------------------------------------

void Player::step_changed() {
  motion_ = settings.reduced_motion ? 1 : 0;
  to_keep_ = true;
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
  return motion_ < 1 || glide_.has_value() || (session_ && session_->timeline().playing());
}

bool Player::advance(double seconds) {
  bool changed = false;
  if (session_ && session_->timeline().playing()) {
    move([&](Timeline& t) {
      t.set_speed(settings.speed);
      return t.advance(seconds);
    });
    changed = true;
  }
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
  if (notice_left_ > 0) {
    notice_left_ -= seconds;
    if (notice_left_ <= 0) {
      notice_.clear();
      changed = true;
    }
  }
  if (!session_ && !shelf_) shelf_ = std::make_unique<Shelf>(options_.lessons, options_.exercises);
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
  }
  since_keep_ += seconds;
  if (since_keep_ >= keep_seconds) {
    since_keep_ = 0;
    if (to_keep_ || !(settings == kept_settings_)) keep();
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
  if (auto wrong = session_->reload(std::move(*document)); !wrong.empty()) {
    show_problems(printable(file.filename().string()) + " was changed and cannot be run", std::move(wrong));
    return;
  }
  dismiss_problems();
  after_edit();
  notice("The file was changed on disk and is loaded again.");
}

void Player::remember_progress() {
  if (!session_ || session_->document().file.empty()) return;
  Progress& known = progress_[session_->document().file.string()];
  known.seen = 0;  // now
  known.step = session_->step();
  known.last = session_->last();
  known.furthest = std::max(known.furthest, known.step);
  known.bookmarks = session_->bookmarks();
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
  if (options_.places.config.empty()) return;
  Diagnostics wrong;
  const auto note = [&](const Checked<bool>& saved) {
    wrong.insert(wrong.end(), saved.diagnostics.begin(), saved.diagnostics.end());
  };
  if (!(settings == kept_settings_)) note(save_settings(options_.places, settings));
  kept_settings_ = settings;
  note(save_progress(options_.places, progress_));
  if (session_ && session_->unsaved()) {
    const Document& document = session_->document();
    note(write_autosave(options_.places,
                        {autosave_, document.file, document.title(),
                         as_lesson(document, session_->inputs(), document.id(), document.title()), session_->step()}));
  } else {
    discard({autosave_, {}, {}, {}, 0});
  }
  if (!wrong.empty() && notice_.empty()) notice("What should be remembered could not be written: " + wrong[0].message);
}

}  // namespace blossom
