#include "player/session.hpp"

#include <atomic>
#include <chrono>

namespace blossom {
namespace {

// While something is dragged, a run in fractions that takes longer than this is made in decimals; the fractions follow
// when it is let go.
constexpr double patient_seconds = 0.008;
// A run that would take about a quarter of a second and more in fractions, because it is long or because they are, is
// opened in decimals.
constexpr std::uint32_t most_exact_steps = 20'000;
constexpr std::uint64_t patient_work = 50'000'000;

std::string phase_path_text(const TraceGraph& graph, std::uint32_t phase) {
  std::string path;
  for (const std::uint32_t outer : graph.phase_path(phase)) path += "/" + graph.phases()[outer].label();
  return path;
}

}  // namespace

Session::Session(Document document, bool exact)
    : document_(std::move(document)), history_(document_.inputs), saved_(document_.inputs), exact_(exact) {}

Checked<std::unique_ptr<Session>> Session::open(Document document, bool exact) {
  std::unique_ptr<Session> session(new Session(std::move(document), exact));
  if (auto wrong = session->record(session->inputs(), false); !wrong.empty()) return wrong;
  return session;
}

Diagnostics Session::record(const Inputs<Exact>& inputs, bool in_gesture) {
  if (exact_ && !recording_) {
    auto made = Recording::make(algorithm(), inputs, false);
    if (made && (*made)->last() >= most_exact_steps) {
      exact_failed_ = true;
      take(std::move(*made));
      return {};
    }
  }
  const bool hurry = in_gesture && exact_seconds_ > patient_seconds;
  if (exact_ && !exact_failed_ && !hurry) {
    const auto begin = std::chrono::steady_clock::now();
    auto made = [&] {
      const ExactBudget patience(patient_work);
      return Recording::make(algorithm(), inputs, true);
    }();
    exact_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (made) {
      take(std::move(*made));
      return {};
    }
    exact_failed_ = true;
  }
  // What is too large for fractions may well be shown in decimals.
  auto made = Recording::make(algorithm(), inputs, false);
  if (!made) return made.diagnostics;
  take(std::move(*made));
  return {};
}

void Session::take(std::shared_ptr<const Recording> recording) {
  auto timeline = std::make_unique<Timeline>(recording->graph());
  if (timeline_) {
    timeline->set_speed(timeline_->speed());
    if (const auto loop = timeline_->loop(); loop && loop->first <= timeline->last())
      timeline->set_loop(loop->first, loop->second);
  }
  const bool playing = timeline_ && timeline_->playing();
  recording_ = std::move(recording);
  timeline_ = std::move(timeline);
  static std::atomic<std::uint64_t> versions{0};
  version_ = ++versions;
  // In decimals a run can have other steps than in fractions: knots that are equal there may differ here.
  if (prediction_ && !prediction_->rebind(recording_->graph())) stop_prediction();
  timeline_->seek(place_again());
  if (playing && !timeline_->at_end()) timeline_->play();
  beats_ = document_.lesson ? recording_->beats(*document_.lesson_scene()) : std::vector<Beat>();
  set_bookmarks(std::move(bookmarks_));
}

void Session::remember_place() {
  const TraceGraph& graph = recording_->graph();
  const ValueId main = graph.main_value(step());
  const std::uint32_t phase = graph.introduced_by(step());
  place_ = {step() > 0 && main != absent ? graph.name(main) : "", phase != absent ? phase_path_text(graph, phase) : "",
            step()};
}

std::uint32_t Session::place_again() const {
  const TraceGraph& graph = recording_->graph();
  if (!place_.value.empty())
    if (const auto v = graph.find(place_.value)) return graph.value(*v).step;
  if (!place_.phase.empty())
    for (std::uint32_t phase = 0; phase < graph.phases().size(); ++phase)
      if (phase_path_text(graph, phase) == place_.phase) return graph.phases()[phase].first_step;
  return std::min(place_.step, graph.step_count() - 1);
}

bool Session::seek(const std::string& value) {
  const auto v = recording_->graph().find(value);
  return v && seek(recording_->graph().value(*v).step);
}

const Beat* Session::beat() const {
  const auto found =
      std::lower_bound(beats_.begin(), beats_.end(), step(), [](const Beat& b, std::uint32_t s) { return b.step < s; });
  return found != beats_.end() && found->step == step() ? &*found : nullptr;
}

Session::Words Session::words() const {
  const Beat* here = beat();
  const std::string own = recording_->source().text(step());
  const auto said = here != nullptr ? recording_->fill(here->say.in(language_), step()) : std::nullopt;
  if (!said) return {own, ""};
  const bool meant = !edited() || (!here->sliders.empty() && only_slid());
  return meant ? Words{*said, ""} : Words{own, *said};
}

bool Session::only_slid() const {
  if (!document_.lesson) return false;
  // From the lesson's numbers to these, for a weight of 0 leaves no way back.
  Inputs<Exact> slid = document_.inputs;
  for (const Beat& beat : document_.lesson_scene()->beats)
    for (const Slider& slider : beat.sliders) {
      const auto now = number_at(inputs(), slider.input);
      if (!now || number_at(slid, slider.input) == now) continue;
      auto next = set_number_at(algorithm(), slid, slider.input, *now);
      if (!next) return false;
      slid = std::move(*next);
    }
  return slid == inputs();
}

void Session::set_bookmarks(std::vector<std::uint32_t> steps) {
  std::erase_if(steps, [&](std::uint32_t s) { return s > last(); });
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  bookmarks_ = std::move(steps);
  std::vector<std::uint32_t> marks = bookmarks_;
  for (const Beat& beat : beats_) marks.push_back(beat.step);
  if (!document_.lesson)  // the beginnings of its parts are the stations of what has no beats
    for (const PhaseRecord& phase : recording_->graph().phases()) marks.push_back(phase.first_step);
  timeline_->set_marks(std::move(marks));
}

void Session::toggle_bookmark() {
  auto steps = bookmarks_;
  if (std::erase(steps, step()) == 0) steps.push_back(step());
  set_bookmarks(std::move(steps));
}

bool Session::edit(Edited edited, const std::string& what, const std::string& gesture) {
  if (!edited) {
    rejected_ = std::move(edited.diagnostics);
    return false;
  }
  rejected_.clear();
  if (*edited == inputs()) return true;
  if (auto wrong = record(*edited, !gesture.empty()); !wrong.empty()) {
    rejected_ = std::move(wrong);
    return false;
  }
  history_.push(std::move(*edited), what, gesture);
  stop_prediction();  // its questions were about other numbers
  return true;
}

namespace {

// The coordinates of the point whose weight is at this path ("curve.weights[1]"), by their paths.
std::vector<std::pair<std::string, Exact>> place_at(const Inputs<Exact>& inputs, std::string path) {
  constexpr std::string_view weights = ".weights[";
  std::vector<std::pair<std::string, Exact>> place;
  const std::size_t at = path.rfind(weights);
  if (at == std::string::npos) return place;
  path.replace(at, weights.size(), ".points[");
  for (const char* axis : {"[0]", "[1]", "[2]"})
    if (auto x = number_at(inputs, path + axis)) place.emplace_back(path + axis, std::move(*x));
  return place;
}

bool has_no_weight(const Inputs<Exact>& inputs, std::string_view path) { return number_at(inputs, path) == Exact(0); }

}  // namespace

Edited Session::with_number_at(std::string_view path, const Exact& x) const {
  Edited edited = set_number_at(algorithm(), inputs(), path, x);
  const auto place = place_at(inputs(), std::string(path));
  if (!edited || x == Exact(0) || place.empty() || !has_no_weight(inputs(), path)) return edited;
  for (std::size_t state = history_.at(); state-- > 0;) {
    const auto before = place_at(history_.state(state), std::string(path));
    if (before.size() != place.size() || has_no_weight(history_.state(state), path)) continue;
    for (const auto& [coordinate, number] : before)
      if (edited) edited = set_number_at(algorithm(), *edited, coordinate, number);
    break;
  }
  return edited;
}

void Session::end_gesture() {
  history_.end_gesture();
  rejected_.clear();
  if (exact_ && !exact_failed_ && !recording_->source().exact) record(inputs(), false);
}

void Session::cancel_gesture() {
  if (history_.cancel_gesture()) show_history();
}

bool Session::show_history() {
  rejected_.clear();
  fields_.clear();
  stop_prediction();
  record(inputs(), false);  // it could be recorded before
  return true;
}

bool Session::undo() { return history_.undo() && show_history(); }
bool Session::redo() { return history_.redo() && show_history(); }
bool Session::revert() {
  fields_.clear();
  return edit(Edited(document_.inputs), "all edits taken back");
}

void Session::set_exact(bool exact) {
  exact_ = exact;
  exact_failed_ = false;
  if (recording_->source().exact != exact) record(inputs(), false);
}

Diagnostics Session::reload(Document document) {
  if (auto made = Recording::make(*document.algorithm, document.inputs, false); !made) return made.diagnostics;
  if (document.algorithm != document_.algorithm) history_ = History<Inputs<Exact>>(document.inputs);
  document_ = std::move(document);
  if (!(document_.inputs == inputs())) history_.push(document_.inputs, "the file was changed on disk");
  saved_ = inputs();
  rejected_.clear();
  fields_.clear();
  const auto before = std::move(prediction_);
  auto wrong = record(inputs(), false);
  // The answers that were given stay where the same is asked still.
  if (before && wrong.empty() && start_prediction().empty()) {
    prediction_->carry_over(*before);
    seek(place_again());
  }
  return wrong;
}

Diagnostics Session::start_prediction() {
  std::shared_ptr<const Grader> grader = edited() ? nullptr : document_.grader;
  if (!grader) {
    auto made = practice_exercise(algorithm(), inputs(), document_.asks, document_.id(), document_.title());
    if (!made) return made.diagnostics;
    grader = std::move(*made);
  }
  prediction_ = std::make_unique<Prediction>(std::move(grader), document_.marking, recording_->graph());
  seek(0);
  return {};
}

}  // namespace blossom
