// What is asked of who predicts, what is being typed, and what follows from an answer.
#include <algorithm>
#include <utility>

#include "player/player.hpp"

namespace blossom {

void Player::forget_questions() {
  draft_ = {};
  chosen_question_.reset();
  last_said_.reset();
  predicted_place.reset();
  doubt_ = Doubt::none;
  saved_answers_.clear();
}

void Player::start_predicting() {
  if (!session_) return;
  if (auto wrong = session_->start_prediction(); !wrong.empty())
    return show_problems("There is nothing to predict here", std::move(wrong));
  forget_questions();
  draft_.wants_keyboard = true;
  tab = focus = "predict";
}

void Player::stay_before_question() {
  if (!session_ || session_->prediction() == nullptr || !session_->prediction()->veiled(session_->step())) return;
  const Prediction& prediction = *session_->prediction();
  // One waits at the last step that gives nothing away.
  const std::size_t first = prediction.marking() == Marking::at_end ? 0 : *prediction.open();
  const AskedValue& question = prediction.questions()[first];
  const std::uint32_t before = question.step > 0 ? question.step - 1 : 0;
  session_->move([=](Timeline& t) { return t.pause(), t.seek(before); });
  motion_ = 1;
  tab = "predict";
  notice(prediction.marking() == Marking::at_end ? "The steps are shown when all is answered."
                                                 : "First say what " + question.name + " will be, or let it be shown.");
}

// ---- the question ---------------------------------------------------------------------------------------------------

std::optional<std::size_t> Player::asked() const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr) return std::nullopt;
  if (chosen_question_ && *chosen_question_ < prediction->questions().size()) return chosen_question_;
  // Once all is marked nothing is asked any more, be it that something was never answered.
  return prediction->finished() ? std::nullopt : prediction->open();
}

void Player::choose_question(std::size_t question) {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr || question >= prediction->questions().size()) return;
  doubt_ = Doubt::none;
  draft_ = {};
  if (prediction->finished() && chosen_question_ == question) return chosen_question_.reset();
  chosen_question_ = question;
  draft_.wants_keyboard = !prediction->finished() && !prediction->mark(question);
}

void Player::choose_next_question(int by) {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr || prediction->questions().empty()) return;
  const auto count = static_cast<int>(prediction->questions().size());
  const auto here = asked();
  const int from = here ? static_cast<int>(*here) : (by > 0 ? -1 : count);
  tab = "predict";
  const int to = std::clamp(from + by, 0, count - 1);
  if (to != from) choose_question(static_cast<std::size_t>(to));
}

bool Player::hides(std::string_view value) const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr) return false;
  for (const AskedValue& question : prediction->questions())
    if (question.name == value) return prediction->veiled(question.step);
  return false;
}

bool Player::veils(ValueId value) const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr) return false;
  const TraceGraph& graph = session_->recording().graph();
  return !graph.is_input(value) && prediction->veiled(graph.value(value).step);
}

// ---- the answer -----------------------------------------------------------------------------------------------------

void Player::set_draft(std::size_t number, std::string text) {
  const auto question = asked();
  if (!question) return;
  const Prediction& prediction = *session_->prediction();
  if (draft_.question != *question) {
    draft_ = {*question, {}, {}, false};
    if (const auto& attempt = prediction.attempt(*question)) draft_.numbers = attempt->numbers;
  }
  // A point that is copied from elsewhere comes in one piece.
  auto pieces = split_numbers(text);
  if (pieces.size() < 2 || number + pieces.size() > prediction.questions()[*question].size) pieces = {std::move(text)};
  if (draft_.numbers.size() < number + pieces.size()) draft_.numbers.resize(number + pieces.size());
  std::ranges::move(pieces, draft_.numbers.begin() + static_cast<std::ptrdiff_t>(number));
  draft_.problem.clear();
}

void Player::set_draft(std::vector<std::string> numbers) {
  if (const auto question = asked()) draft_ = {*question, std::move(numbers), {}, false};
}

void Player::submit_draft() {
  const auto question = asked();
  if (!question) return;
  Prediction& prediction = *session_->prediction();
  if (draft_.question != *question) {
    draft_ = {*question, {}, {}, false};
    if (const auto& attempt = prediction.attempt(*question)) draft_.numbers = attempt->numbers;
  }
  if (auto problem = prediction.answer(*question, draft_.numbers)) {
    draft_.problem = std::move(*problem);
    draft_.wants_keyboard = true;
    return;
  }
  go_on_after(*question);
}

void Player::show_me() {
  const auto question = asked();
  if (!question || session_->prediction()->mark(*question)) return;
  session_->prediction()->show_me(*question);
  tab = "predict";
  go_on_after(*question);
}

void Player::go_on_after(std::size_t question) {
  const Prediction& prediction = *session_->prediction();
  last_said_ = question;
  chosen_question_.reset();
  draft_ = {};
  draft_.wants_keyboard = !prediction.finished();
  to_keep_ = true;
  const std::uint32_t step = prediction.questions()[question].step;
  if (!prediction.veiled(step) && session_->step() < step) seek(step);
}

std::optional<std::size_t> Player::last_said() const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr || !last_said_ || *last_said_ >= prediction->questions().size()) return std::nullopt;
  return prediction->attempt(*last_said_) ? last_said_ : std::nullopt;
}

void Player::take_back_answer() {
  Prediction& prediction = *session_->prediction();
  if (!prediction.can_undo()) return;
  const std::string what = prediction.undo_what();
  const std::size_t question = prediction.undo_question();
  prediction.undo();
  draft_ = {};
  chosen_question_ = question;
  doubt_ = Doubt::none;
  stay_before_question();
  tab = "predict";
  notice("Taken back, and counted: " + what + ".");
}

void Player::put_back_answer() {
  Prediction& prediction = *session_->prediction();
  if (!prediction.redo()) return;
  draft_ = {};
  chosen_question_.reset();
  doubt_ = Doubt::none;
  last_said_ = prediction.undo_question();
  tab = "predict";
  notice("Put back: " + prediction.undo_what() + ".");
}

// ---- the end --------------------------------------------------------------------------------------------------------

bool Player::answers_unsaved() const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  return prediction != nullptr && prediction->answered() > 0 && saved_answers_ != prediction->answers_file();
}

void Player::stop_predicting() {
  if (!session_ || session_->prediction() == nullptr) return;
  if (!answers_unsaved()) return resolve_stop();
  doubt_ = Doubt::stop;
  draft_.wants_keyboard = true;
  tab = focus = "predict";
}

void Player::finish_predicting() {
  if (!session_ || session_->prediction() == nullptr || session_->prediction()->finished()) return;
  doubt_ = Doubt::finish;
  draft_.wants_keyboard = true;
  tab = focus = "predict";
}

void Player::resolve_doubt(bool do_it) {
  const Doubt doubt = std::exchange(doubt_, Doubt::none);
  if (!session_ || session_->prediction() == nullptr || doubt == Doubt::none) return;
  if (!do_it) {
    draft_.wants_keyboard = !session_->prediction()->finished();
    return;
  }
  if (doubt == Doubt::stop) return resolve_stop();
  session_->prediction()->finish();
  draft_ = {};
  chosen_question_.reset();
  to_keep_ = true;
}

void Player::resolve_stop() {
  remember_progress();  // what it was worth
  session_->stop_prediction();
  forget_questions();
}

}  // namespace blossom
