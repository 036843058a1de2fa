// What a lesson adds to a run: its scenes, the languages it is in, what its beats ask for, and its questions.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "algorithms/typeset.hpp"
#include "player/player.hpp"
#include "scene/beat_look.hpp"

namespace blossom {
namespace {

constexpr double patience = 0.4;  // seconds: a key that repeats by itself skips no question

// The beat of `beats` in (before, after] at which playing stops or stays, and why.
const Beat* next_stop(const std::vector<Beat>& beats, std::uint32_t before, std::uint32_t after) {
  for (const Beat& beat : beats)
    if (before < beat.step && beat.step <= after && (beat.waits || beat.seconds > 0)) return &beat;
  return nullptr;
}

}  // namespace

// ---- languages ------------------------------------------------------------------------------------------------------

std::string Player::title() const { return session_ ? session_->document().title(settings.language) : std::string(); }

std::vector<std::string> Player::languages() const {
  if (!session_ || !session_->document().lesson) return {};
  const Languages& languages = session_->document().lesson->languages;
  std::vector<std::string> all{languages.own};
  all.insert(all.end(), languages.others.begin(), languages.others.end());
  return all;
}

void Player::choose_next_language() {
  const auto all = languages();
  if (all.size() < 2) return;
  const auto now = std::ranges::find(all, settings.language);
  settings.language = now == all.end() ? all[1] : all[static_cast<std::size_t>(now - all.begin() + 1) % all.size()];
  session_->speak(settings.language);
  to_keep_ = true;
}

// ---- scenes ---------------------------------------------------------------------------------------------------------

std::size_t Player::scene_count() const {
  return session_ && session_->document().lesson ? session_->document().lesson->scene_count() : 1;
}

std::size_t Player::scene() const { return session_ ? session_->document().scene : 0; }

std::string Player::scene_heading(std::size_t which) const {
  if (!session_ || !session_->document().lesson || which >= scene_count()) return {};
  return printable(session_->document().lesson->scene_at(which).heading.in(settings.language));
}

bool Player::unsaved() const {
  return (session_ && session_->unsaved()) ||
         std::ranges::any_of(parked_, [](const auto& parked) { return parked && parked->unsaved(); });
}

bool Player::would_be_missed() const {
  return (session_ && session_->would_be_missed()) ||
         std::ranges::any_of(parked_, [](const auto& parked) { return parked && parked->would_be_missed(); });
}

// What is known of the scene one is in.
ScenePlace Player::place_in_scene(const Progress& known) const {
  if (scene_count() == 1) return known;
  const auto found = known.scenes.find(session_->document().lesson_scene()->scene);
  return found != known.scenes.end() ? found->second : ScenePlace();
}

namespace {

// True: one goes on in the middle.
bool go_to_place(Session& session, const ScenePlace& place) {
  session.set_bookmarks(place.bookmarks);
  return place.step > 0 && place.step < place.last && place.last == session.last() && session.seek(place.step);
}

}  // namespace

void Player::go_on_where_one_was(const std::filesystem::path& file) {
  const Progress* known = progress(file);
  if (known == nullptr) return;
  const Progress was = *known;
  checkpoints_.restore(was.answers, was.skipped, settings.language);
  bool in_the_middle = go_to_place(*session_, place_in_scene(was));
  if (const auto& lesson = session_->document().lesson; lesson && lesson->scene_count() > 1) {
    const auto which = was.scene.empty() ? std::nullopt : lesson->find_scene(was.scene);
    if (which && *which != scene()) {
      show_scene(*which);
      in_the_middle = session_->step() > 0;
    }
  }
  if (session_->document().kind == Document::Kind::exercise) return;
  if (in_the_middle)
    notice("Going on at step " + std::to_string(session_->step()) + "; Home is the beginning.");
  else if (scene() > 0)
    notice("Going on with scene " + std::to_string(scene() + 1) + "; Ctrl+PageUp is the one before.");
}

std::map<std::size_t, Inputs<Exact>> Player::parked_edits() const {
  std::map<std::size_t, Inputs<Exact>> edits;
  for (std::size_t i = 0; i < parked_.size(); ++i)
    if (parked_[i] && parked_[i]->edited()) edits.emplace(i, parked_[i]->inputs());
  return edits;
}

void Player::show_scene(std::size_t which) {
  if (which >= scene_count() || which == scene()) return;
  const bool is_new = !parked_[which];
  if (is_new) {
    Document document = session_->document();
    document.show_scene(which);
    auto opened = Session::open(std::move(document), settings.exact);
    if (!opened) return show_problems("This scene cannot be run", std::move(opened.diagnostics));
    parked_[which] = std::move(*opened);
  }
  remember_progress();
  session_->move([](Timeline& t) { return t.pause(), false; });
  const std::size_t before = scene();
  parked_[before] = std::move(session_);
  session_ = std::move(parked_[which]);
  session_->set_exact(settings.exact);
  session_->speak(settings.language);
  session_->move([&](Timeline& t) { return t.set_speed(settings.speed), false; });
  if (const Progress* known = progress(session_->document().file); known != nullptr && is_new)
    go_to_place(*session_, place_in_scene(*known));
  forget_what_was_about();
  enter_scene();
  to_keep_ = true;
}

void Player::enter_scene() {
  followed_.reset();
  camera_beat_.reset();
  camera_is_lessons_ = false;
  skip_asked_.reset();
  waiting_.reset();
  slide_refused_ = {};
  follow_lesson();
}

// Of another document.
void Player::forget_lesson() {
  parked_.clear();
  parked_.resize(scene_count());
  saved_checkpoints_.clear();
  tab_before_question_.clear();
  checkpoints_ = session_ && session_->document().lesson
                     ? Checkpoints(std::make_shared<const Lesson>(*session_->document().lesson))
                     : Checkpoints();
}

// The file as it is now: every scene that was shown goes on where it was, if it is still there.
bool Player::reload_scenes(Document document) {
  const auto known = [&](const Session& session) -> std::optional<std::size_t> {
    const LessonScene* scene = session.document().lesson_scene();
    if (scene == nullptr || !document.lesson || scene->scene.empty()) return std::nullopt;
    return document.lesson->find_scene(scene->scene);
  };
  const std::size_t here = session_->document().scene;
  if (document.lesson) {
    const std::size_t count = document.lesson->scene_count();
    document.show_scene(known(*session_).value_or(std::min(here, count - 1)));
    std::vector<std::unique_ptr<Session>> parked(count);
    for (auto& session : parked_) {
      const auto place = session ? known(*session) : std::nullopt;
      if (!place || *place == document.scene || parked[*place]) continue;
      Document of_scene = document;
      of_scene.show_scene(*place);
      if (session->reload(std::move(of_scene)).empty()) parked[*place] = std::move(session);
    }
    parked_ = std::move(parked);
  } else {
    parked_.clear();
    parked_.resize(1);
  }
  const std::filesystem::path file = document.file;
  if (auto wrong = session_->reload(std::move(document)); !wrong.empty()) {
    show_problems(printable(file.filename().string()) + " was changed and cannot be run", std::move(wrong));
    return false;
  }
  const auto answers = checkpoints_.answers();
  const auto skipped = checkpoints_.skipped();
  checkpoints_ = Checkpoints();
  if (session_->document().lesson) {
    checkpoints_ = Checkpoints(std::make_shared<const Lesson>(*session_->document().lesson));
    checkpoints_.restore(answers, skipped, settings.language);
  }
  return true;
}

// ---- what beats ask for ---------------------------------------------------------------------------------------------

// After a step, an edit or another scene: the camera and the question of the beat one is at.
void Player::follow_lesson() {
  if (!session_) return followed_.reset();
  const std::pair now{session_->version(), session_->step()};
  if (followed_ == now) return;
  const bool other_step = !followed_ || followed_->second != now.second;
  followed_ = now;
  if (skip_asked_ && *skip_asked_ != now.second) skip_asked_.reset();
  if (other_step) slide_refused_ = {};

  std::optional<std::uint32_t> beat;
  const BeatCamera* wanted = camera_in_force(session_->beats(), now.second);
  for (const Beat& each : session_->beats())
    if (each.camera && &*each.camera == wanted) beat = each.step;
  if (beat != camera_beat_) {
    camera_beat_ = beat;
    std::optional<Camera> to;
    if (wanted != nullptr) {
      const Recording& recording = session_->recording();
      to = camera_of(*wanted, recording.scenes(), recording.source(), view_size_.width, view_size_.height);
      if (recording.source().spatial()) to->perspective = settings.perspective;
    }
    glide_to(to);
    camera_is_lessons_ = true;
  }

  const auto question = checkpoint();
  if (question) {
    std::size_t size = 1;
    const Recording& recording = session_->recording();
    const std::string& value = checkpoints_.item(*question).checkpoint.value;
    if (const auto v = value.empty() ? std::nullopt : recording.graph().find(value)) {
      const ValueKind kind = recording.graph().value(*v).kind;
      if (kind == ValueKind::point || kind == ValueKind::vector)
        size = static_cast<std::size_t>(recording.source().dimension);
      else if (kind != ValueKind::scalar && kind != ValueKind::integer)
        size = 0;
    }
    checkpoints_.look_at(*question, size);
  }
  if (!other_step) return;
  const bool asks = (question && checkpoints_.item(*question).open()) ||
                    (has_all_been_said() && !checkpoints_.items().empty() && session_->prediction() == nullptr);
  if (asks && tab != "checkpoint") {
    tab_before_question_ = std::exchange(tab, "checkpoint");
  } else if (!asks && tab == "checkpoint" && !tab_before_question_.empty() && !question) {
    tab = std::exchange(tab_before_question_, {});
  }
}

void Player::set_view_size(ViewSize size) {
  view_size_ = size;
  if (!camera_is_lessons_ || !session_) return;
  const BeatCamera* wanted = camera_in_force(session_->beats(), session_->step());
  if (wanted == nullptr || glide_) return;
  const Recording& recording = session_->recording();
  camera_ = camera_of(*wanted, recording.scenes(), recording.source(), size.width, size.height);
  if (recording.source().spatial()) camera_->perspective = settings.perspective;
}

// Playing goes on, but no further than to a beat that wants to stay. True if anything is seen of it.
bool Player::play_on(double seconds) {
  if (stay_left_ > 0) {
    stay_left_ -= seconds;
    return false;
  }
  const std::uint32_t before = session_->step();
  double stay = 0;
  move_as(
      [&](Timeline& t) {
        t.set_speed(settings.speed);
        if (!t.advance(seconds)) return false;
        const Beat* stop = next_stop(session_->beats(), before, t.position());
        if (stop == nullptr) return true;
        if (t.position() != stop->step) t.seek(stop->step);
        if (stop->waits) {
          t.pause();
          waiting_ = stop->step;
        } else {
          stay = stop->seconds;
        }
        return true;
      },
      false);
  if (session_->step() != before) stay_left_ = stay;
  return true;
}

// ---- sliders --------------------------------------------------------------------------------------------------------

const std::vector<Slider>& Player::sliders() const {
  static const std::vector<Slider> none;
  const Beat* beat = session_ ? session_->beat() : nullptr;
  return beat != nullptr ? beat->sliders : none;
}

std::string Player::slider_words(const Slider& slider) const {
  if (slider.label.empty() || !session_) return slider.input;
  const Algorithm& algorithm = session_->recording().source().algorithm_at(session_->step());
  return unicode_text(typeset_text(printable(slider.label.in(settings.language)), algorithm));
}

void Player::slide(std::size_t which, const Exact& wanted) {
  if (which >= sliders().size()) return;
  const Slider slider = sliders()[which];
  if (session_->prediction() != nullptr && session_->prediction()->open())
    return notice("While you predict, what is given stays as it is. Ctrl+T ends predicting.");
  const Exact to = std::clamp(wanted, slider.from, slider.to);
  if (number_at(session_->inputs(), slider.input) == to) {
    slide_refused_ = {};
    return;
  }
  if (!camera_) camera_ = shown_camera();  // the picture stays while something in it moves
  const auto edited = session_->with_number_at(slider.input, to);
  if (edit(edited, slider_words(slider) + " moved", "slide " + slider.input))
    slide_refused_ = {};
  else
    slide_refused_ = {
        which, session_->rejected().empty() ? "It cannot be moved there." : session_->rejected().front().message};
  follow_lesson();
}

void Player::slide_by(std::size_t which, int steps) {
  if (which >= sliders().size()) return;
  const Slider& slider = sliders()[which];
  const auto now = number_at(session_->inputs(), slider.input);
  const Exact step = slider.step.value_or((slider.to - slider.from) / Exact(100));
  if (now) slide(which, *now + Exact(steps) * step);
}

void Player::end_slide() {
  if (session_) session_->end_gesture();
}

// ---- questions ------------------------------------------------------------------------------------------------------

std::optional<std::size_t> Player::checkpoint() const {
  if (!session_ || session_->prediction() != nullptr) return std::nullopt;
  const Beat* beat = session_->beat();
  return beat != nullptr && beat->checkpoint ? checkpoints_.find(beat->checkpoint->id) : std::nullopt;
}

bool Player::has_all_been_said() const {
  return session_ && session_->step() == session_->last() && scene() + 1 == scene_count();
}

// No further than to the first open question behind where one was; from there on one is asked first, and who insists
// skips it. True: one is not where one would have been.
bool Player::stay_at_open_checkpoint(std::uint32_t before, bool may_skip) {
  if (!session_->document().lesson || session_->prediction() != nullptr || session_->edited()) return false;
  for (const Beat& beat : session_->beats()) {
    if (beat.step < before || beat.step >= session_->step() || !beat.checkpoint) continue;
    const auto item = checkpoints_.find(beat.checkpoint->id);
    if (!item || !checkpoints_.item(*item).open()) continue;
    if (beat.step == before) {
      if (may_skip && skip_asked_ == before && skip_asked_for_ >= patience) {
        checkpoints_.skip(*item);
        skip_asked_.reset();
        to_keep_ = true;
        continue;
      }
      if (skip_asked_ != before) skip_asked_for_ = 0;
      skip_asked_ = before;
    }
    session_->move([&](Timeline& t) { return t.pause(), t.seek(beat.step); });
    tab = "checkpoint";
    return true;
  }
  return false;
}

void Player::scrub(std::uint32_t step) {
  move_as([=](Timeline& t) { return t.pause(), t.seek(step); }, false);
}

void Player::submit_checkpoint() {
  if (!checkpoint() || !checkpoints_.submit(settings.language)) return;
  skip_asked_.reset();
  to_keep_ = true;
}

bool Player::wants_checkpoint_key(std::string_view key) const {
  return checkpoint() && !session_->edited() && checkpoints_.wants_key(key);
}

void Player::checkpoint_key(std::string_view key) {
  if (!wants_checkpoint_key(key)) return;
  checkpoints_.key(key, settings.language);
  tab = "checkpoint";
  if (checkpoints_.reply().wants_keyboard) focus = "checkpoint";
  to_keep_ = true;
}

std::string Player::beat_text(const LocalText& text) const {
  if (!session_) return {};
  const std::string& words = text.in(settings.language);
  return session_->recording().fill(words, session_->step()).value_or(words);
}

bool Player::checkpoint_asks(Checkpoint::Kind kind) const {
  const auto item = checkpoint();
  return item && !session_->edited() && checkpoints_.takes() && checkpoints_.item(*item).checkpoint.kind == kind;
}

void Player::submit_checkpoint_line(int line) {
  if (!checkpoint() || !checkpoints_.submit_line(line, settings.language)) return;
  skip_asked_.reset();
  to_keep_ = true;
}

void Player::skip_checkpoint() {
  const auto item = checkpoint();
  if (!item) return;
  checkpoints_.skip(*item);
  skip_asked_.reset();
  to_keep_ = true;
  move([](Timeline& t) { return t.pause(), t.forward(); });
}

void Player::stay_at_checkpoint() { skip_asked_.reset(); }

void Player::go_to_checkpoint(std::size_t which) {
  if (which >= checkpoints_.items().size()) return;
  const Checkpoints::Item& item = checkpoints_.item(which);
  if (item.scene != scene()) show_scene(item.scene);
  if (!session_ || item.scene != scene()) return;
  for (const Beat& beat : session_->beats())
    if (beat.checkpoint && beat.checkpoint->id == item.checkpoint.id) seek(beat.step);
}

bool Player::checkpoint_asks_place() const {
  if (!checkpoint_asks(Checkpoint::Kind::predict)) return false;
  const StepSource& source = session_->recording().source();
  const auto v = source.graph->find(checkpoints_.item(*checkpoint()).checkpoint.value);
  // In space a click is a line of sight, and no place.
  return v && !source.spatial() && source.graph->value(*v).kind == ValueKind::point;
}

namespace {

// The coordinates of a value as one types them.
std::vector<std::string> coordinates(const StepSource& source, ValueId v, std::size_t size) {
  auto numbers = split_numbers(source.value_text(v));
  const bool typed = numbers.size() == size && std::ranges::all_of(numbers, [](const std::string& text) {
                       return typed_number(text).has_value();
                     });
  if (source.exact && typed) return numbers;
  numbers.clear();
  for (std::size_t i = 0; i < size; ++i)
    numbers.push_back(number_text(snapped((*source.points[v])[static_cast<int>(i)], 1e-9), NumberStyle::coordinate));
  return numbers;
}

}  // namespace

void Player::checkpoint_click(const glm::dvec3& place) {
  if (!checkpoint_asks_place()) return;
  const StepSource& source = session_->recording().source();
  const ValueId asked = *source.graph->find(checkpoints_.item(*checkpoint()).checkpoint.value);
  const double unit = shown_camera().height / view_size_.height;
  const std::size_t size = std::min<std::size_t>(checkpoints_.reply().size, 3);
  std::vector<std::string> numbers, meant;
  for (std::size_t i = 0; i < size; ++i)
    numbers.push_back(number_text(snapped(place[static_cast<int>(i)], unit), NumberStyle::coordinate));
  // Nobody hits a place to the last decimal: near enough is right.
  const auto& right = source.points[asked];
  if (right && glm::distance(*right, place) <= click_tolerance(session_->inputs()))
    meant = coordinates(source, asked, size);
  checkpoints_.click(std::move(numbers), std::move(meant));
}

void Player::save_checkpoints(const std::filesystem::path& file) {
  if (checkpoints_.items().empty()) return;
  const auto saved = write_file(file, checkpoints_.answers_file());
  if (!saved) return show_problems("The answers could not be saved", saved.diagnostics);
  saved_checkpoints_ = checkpoints_.answers_file();
  notice("Saved as " + printable(file.string()));
}

}  // namespace blossom
