// What the mouse holds, and what keys do to a point.
#include <cmath>
#include <glm/geometric.hpp>

#include "algorithms/typeset.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

constexpr const char* gesture = "drag";  // one drag is one state of the history

bool is_open_prediction(const Session& session) {
  return session.prediction() != nullptr && session.prediction()->open().has_value();
}

}  // namespace

// ---- dragging -------------------------------------------------------------------------------------------------------

bool Player::take(Grip grip) {
  if (!session_) return false;
  const bool changes = !std::holds_alternative<LookGrip>(grip) && !std::holds_alternative<StuckGrip>(grip);
  if (changes && is_open_prediction(*session_)) {
    // An edit ends predicting, as the questions were about other numbers: not by a slip of the hand.
    notice("While you predict, what is given stays as it is. Ctrl+T ends predicting.");
    held_ = Held{StuckGrip{}, {}, {}, true, true};
    return false;
  }
  if (const auto* stuck = std::get_if<StuckGrip>(&grip)) notice(stuck->why);
  // The picture is not to move under the mouse because a point moves in it.
  if (std::holds_alternative<PointGrip>(grip)) set_camera(shown_camera());
  if (changes) session_->end_gesture();
  held_ = Held{std::move(grip), {}, {}, false, false};
  return true;
}

void Player::drag(glm::dvec2 mouse, const GripKeys& keys) {
  if (!session_ || !held_ || held_->over) return;
  // What was typed when the hand went down is in the inputs by now.
  if (!std::exchange(held_->begun, true))
    std::visit(
        [&](auto& grip) {
          if constexpr (requires { grip.rebase(session_->inputs()); }) grip.rebase(session_->inputs());
        },
        held_->grip);
  held_->mouse = mouse;
  held_->keys = keys;
  const Algorithm& algorithm = session_->algorithm();
  const auto change = [&](const Edited& edited, const std::string& what) {
    if (edit(edited, what, gesture)) return;
    // What cannot be leaves everything as it was before the drag, and not where the mouse happened to be last.
    const Diagnostics why = session_->rejected();
    session_->cancel_gesture();
    edit(Edited(why), what, gesture);
  };
  if (const auto* look = std::get_if<LookGrip>(&held_->grip))
    set_camera(look->at(mouse));
  else if (const auto* point = std::get_if<PointGrip>(&held_->grip))
    change(point->edited(algorithm, mouse, keys), point->name() + " moved");
  else if (const auto* knot = std::get_if<KnotGrip>(&held_->grip))
    change(knot->edited(algorithm, mouse.x, keys), "knot u_" + std::to_string(knot->index(mouse.x, keys)) + " moved");
  else if (const auto* u = std::get_if<ParameterGrip>(&held_->grip))
    change(u->edited(algorithm, mouse.x, keys), "u moved");
}

void Player::let_go() {
  if (!held_) return;
  const Inputs<Exact>* before = nullptr;
  if (const auto* point = std::get_if<PointGrip>(&held_->grip)) before = &point->before();
  if (const auto* knot = std::get_if<KnotGrip>(&held_->grip)) before = &knot->before();
  if (const auto* u = std::get_if<ParameterGrip>(&held_->grip)) before = &u->before();
  if (session_ && before != nullptr) {
    if (session_->inputs() == *before) session_->cancel_gesture();
    session_->end_gesture();  // what was refused is forgotten as well: the thing is where it was
  }
  held_.reset();
}

bool Player::put_back() {
  if (in_studio()) return studio_->put_back();
  if (!session_ || !held_ || held_->over) return false;
  held_->over = true;
  if (const auto* look = std::get_if<LookGrip>(&held_->grip)) {
    set_camera(look->from);
  } else if (!std::holds_alternative<StuckGrip>(held_->grip)) {
    session_->cancel_gesture();
    session_->forget_rejected();
  }
  return true;
}

// ---- keys -----------------------------------------------------------------------------------------------------------

std::optional<PointAddress> Player::chosen_point() const {
  if (!session_) return std::nullopt;
  for (const Link& link : {focused, pinned()}) {
    if (link.kind != Link::Kind::value) continue;
    if (auto address = address_of(session_->recording().graph(), session_->inputs(), link.id)) return address;
  }
  return std::nullopt;
}

// After an edit that renumbers: what had the keyboard, or was pinned, is now this point.
void Player::choose_point(const PointAddress& address) {
  const auto v = value_of(session_->recording().graph(), session_->inputs(), address);
  const Link link = v ? Link{Link::Kind::value, *v} : Link{};
  const bool had_focus = static_cast<bool>(focused);
  if (had_focus) focused = link;
  if (pinned() || !had_focus) {
    pin({});
    pin(link);
  }
}

void Player::nudge(const glm::dvec3& direction) {
  const auto address = chosen_point();
  if (!address) return;
  const Camera camera = shown_camera();
  const Curve<Exact>& net = curve_at(session_->inputs(), {address->input, address->curve});
  const PageAxis along = nearest_axis(camera, net.dimension, direction);
  const double step = grid_spacing(*session_, camera, view_size_) / 10;
  const Exact by = snapped(along.backwards ? -step : step, step);
  Point<Exact> to = affine(net, address->point);
  Exact* const coordinates[] = {&to.x, &to.y, &to.z};
  *coordinates[along.axis] += by;
  const ValueId v = value_of(session_->recording().graph(), session_->inputs(), *address).value_or(absent);
  const std::string name = v != absent ? session_->recording().graph().name(v) : "the point";
  set_camera(camera);
  if (!edit(move_point(session_->algorithm(), session_->inputs(), *address, to), name + " moved"))
    notice(session_->rejected().empty() ? unicode_text(typeset_text(name, session_->algorithm())) + " cannot be moved"
                                        : session_->rejected()[0].message);
}

void Player::add_point_behind(const PointAddress& address) {
  if (!session_) return;
  const Point<Exact> place = place_behind(curve_at(session_->inputs(), {address.input, address.curve}), address.point);
  if (!edit(insert_point(session_->algorithm(), session_->inputs(), address, place), "a point added"))
    return notice("No point can be added here: " + session_->rejected()[0].message);
  choose_point({address.input, address.curve, address.point + 1});
}

void Player::remove_point(const PointAddress& address) {
  if (!session_) return;
  if (!edit(delete_point(session_->algorithm(), session_->inputs(), address), "a point deleted"))
    return notice("The point cannot be deleted: " + session_->rejected()[0].message);
  const std::size_t left = curve_at(session_->inputs(), {address.input, address.curve}).points.size();
  choose_point({address.input, address.curve, std::min(address.point, left - 1)});
}

// ---- predicting by a click ------------------------------------------------------------------------------------------

bool Player::asks_place() const {
  const auto question = asked();
  if (!question) return false;
  const Prediction& prediction = *session_->prediction();
  const AskedValue& asks = prediction.questions()[*question];
  // In space a click is a line of sight, and no place.
  if (session_->recording().source().spatial()) return false;
  return asks.step > session_->step() && asks.kind == ValueKind::point && asks.form == Form::affine &&
         !prediction.finished();
}

void Player::predict_click(const glm::dvec3& place) {
  if (!asks_place()) return;
  predicted_place = place;
  const double unit = shown_camera().height / view_size_.height;
  const auto numbers = prefilled(session_->prediction()->questions()[*asked()], place, unit);
  for (std::size_t i = 0; i < numbers.size(); ++i) set_draft(i, numbers[i]);
}

std::optional<glm::dvec3> Player::said_place(std::size_t question) const {
  const Prediction* prediction = session_ ? session_->prediction() : nullptr;
  if (prediction == nullptr || question >= prediction->questions().size()) return std::nullopt;
  const AskedValue& asks = prediction->questions()[question];
  if (asks.kind != ValueKind::point || asks.form != Form::affine) return std::nullopt;
  const auto& attempt = prediction->attempt(question);
  if (attempt && attempt->shown) return std::nullopt;
  const bool drafted = draft_.question == question;
  if (!drafted && !attempt) return std::nullopt;
  const std::vector<std::string>& numbers = drafted ? draft_.numbers : attempt->numbers;
  if (numbers.size() < asks.size || asks.size > 3) return std::nullopt;
  glm::dvec3 place{0, 0, 0};
  for (std::size_t i = 0; i < asks.size; ++i) {
    const auto number = Exact::parse(numbers[i]);
    if (!number || !std::isfinite(number->to_double())) return std::nullopt;
    place[static_cast<int>(i)] = number->to_double();
  }
  return place;
}

}  // namespace blossom
