// Events to Dear ImGui and to shortcuts; moving the focus by keys.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "player/action.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

// Keys that Dear ImGui wants to know of; the index is the one in KeysDown.
struct NamedKey {
  std::string_view name;
  ImGuiKey key;
};
constexpr std::array<NamedKey, 22> named_keys = {{
    {"Tab", ImGuiKey_Tab},
    {"Left", ImGuiKey_LeftArrow},
    {"Right", ImGuiKey_RightArrow},
    {"Up", ImGuiKey_UpArrow},
    {"Down", ImGuiKey_DownArrow},
    {"PageUp", ImGuiKey_PageUp},
    {"PageDown", ImGuiKey_PageDown},
    {"Home", ImGuiKey_Home},
    {"End", ImGuiKey_End},
    {"Insert", ImGuiKey_Insert},
    {"Delete", ImGuiKey_Delete},
    {"Backspace", ImGuiKey_Backspace},
    {"Space", ImGuiKey_Space},
    {"Enter", ImGuiKey_Enter},
    {"Escape", ImGuiKey_Escape},
    {"KeypadEnter", ImGuiKey_KeyPadEnter},
    {"A", ImGuiKey_A},
    {"C", ImGuiKey_C},
    {"V", ImGuiKey_V},
    {"X", ImGuiKey_X},
    {"Y", ImGuiKey_Y},
    {"Z", ImGuiKey_Z},
}};

std::string key_text(const Event& event) {
  std::string text;
  if (event.ctrl) text += "Ctrl+";
  if (event.alt) text += "Alt+";
  if (event.shift) text += "Shift+";
  return text + event.text;
}

// Panels with text fields: in them Tab walks from field to field.
bool has_fields(std::string_view panel) {
  return panel == "inputs" || panel == "predict" || panel == "checkpoint" || panel == "sliders" || panel == "make" ||
         panel == "shape" || panel == "place";
}

bool is_arrow(std::string_view key) { return key == "Left" || key == "Right" || key == "Up" || key == "Down"; }

std::string reason_in_studio(const Player& player, std::string_view id) {
  const Studio& studio = *player.studio();
  if (id == "edit.undo") return "Nothing has been changed.";
  if (id == "edit.redo") return "Nothing has been undone.";
  if (studio.workspace().objects.empty()) return "The scene is empty; D draws a curve.";
  if (id == "studio.ride") return "Choose a curve first.";
  if (id == "studio.enter") return "Nothing has the focus; Alt and arrows choose a point.";
  if (id.starts_with("studio.")) return "Choose a thing first: click it, or ] for the next one.";
  return {};
}

// Why an action cannot be done now, as a sentence; empty where that is not simple to say.
std::string reason_against(const Player& player, std::string_view id) {
  const Session* session = player.session();
  if (player.in_studio()) return reason_in_studio(player, id);
  if (session == nullptr) return "Nothing is open.";
  const auto one_of = [&](std::initializer_list<std::string_view> ids) {
    return std::ranges::find(ids, id) != ids.end();
  };
  const Prediction* prediction = session->prediction();
  if (prediction == nullptr && one_of({"file.save_answers", "predict.show_me", "predict.finish"}))
    return "Nothing is being predicted; Ctrl+T begins.";
  if (id == "predict.show_me") return "All questions are answered.";
  if (id == "predict.finish") return "The answers are marked already.";
  if (one_of({"step.forward", "step.over", "step.out", "step.last"})) return "This is the last step.";
  if (one_of({"step.back", "step.first"})) return "This is the first step.";
  if (id == "lesson.next_scene" || id == "lesson.previous_scene")
    return player.scene_count() < 2    ? "There is only one scene."
           : id == "lesson.next_scene" ? "This is the last scene."
                                       : "This is the first scene.";
  if (id == "lesson.language") return "There is only one language here.";
  if (id == "lesson.skip") return "Nothing is asked here that is open.";
  if (id.starts_with("lesson.")) return "This lesson asks nothing.";
  if (id == "file.export_lesson") return "Something is being exported already.";
  if (id == "step.next_mark") return "No beat and no bookmark follows.";
  if (id == "step.previous_mark") return "No beat and no bookmark comes before.";
  if (id == "edit.undo") return "Nothing has been changed.";
  if (id == "edit.redo") return "Nothing has been undone.";
  if (one_of({"edit.nudge_nearer", "edit.nudge_farther"}) && !session->recording().source().spatial())
    return "The picture is flat.";
  if (id.starts_with("edit.")) return "Choose a given point first: click it, or Alt and arrows, then Enter.";
  if (id.starts_with("view.")) return "The picture is flat.";
  if (id == "help.pin") return "Nothing has the focus; Alt and arrows choose a value.";
  if (id == "help.why") return "This step makes no value.";
  return {};
}

std::string not_now(const Player& player, const Action& action) {
  std::string title(action.title);
  if (title.ends_with(" ...")) title.resize(title.size() - 4);
  const std::string reason = reason_against(player, action.id);
  if (reason.starts_with("This is the ")) return reason;  // which names what one wanted
  return "Not now: " + title + "." + (reason.empty() ? "" : " " + reason);
}

bool is_punctuation(const std::string& text) {
  return text.size() == 1 && std::ispunct(static_cast<unsigned char>(text[0])) != 0;
}

}  // namespace

void set_key_map(ImGuiIO& io) {
  for (std::size_t i = 0; i < named_keys.size(); ++i) io.KeyMap[named_keys[i].key] = static_cast<int>(i);
}

void Ui::feed(Event event) {
  frames_wanted_ = std::max(frames_wanted_, 3);  // what opens because of it settles in two more
  if (event.kind == Event::Kind::move && !events_.empty() && events_.back().kind == Event::Kind::move)
    events_.back() = std::move(event);
  else
    events_.push_back(std::move(event));
}

void Ui::take_events() {
  ImGuiIO& io = ImGui::GetIO();
  io.MouseWheel = io.MouseWheelH = 0;
  if (held_back_ > 0 && --held_back_ > 0) return;
  bool moved = false;
  while (!events_.empty()) {
    const Event::Kind kind = events_.front().kind;
    // A button goes down or up where a frame has seen the mouse: the end of a quick drag is dragged, too.
    if (moved && (kind == Event::Kind::press || kind == Event::Kind::release)) break;
    moved = kind == Event::Kind::move;
    const Event event = std::move(events_.front());
    events_.pop_front();
    if (take(event)) break;
  }
}

// A press and its release in one frame would be lost to ImGui, so each of them ends the frame's events.
bool Ui::take(const Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Event::Kind::move:
      io.MousePos = {static_cast<float>(event.x), static_cast<float>(event.y)};
      return false;
    case Event::Kind::leave:
      io.MousePos = {-FLT_MAX, -FLT_MAX};
      return false;
    case Event::Kind::press:
    case Event::Kind::release:
      if (event.button >= 0 && event.button < 3) io.MouseDown[event.button] = event.kind == Event::Kind::press;
      ring_ = false;
      text_panel_.clear();
      io.KeyCtrl = event.ctrl;
      io.KeyShift = event.shift;
      io.KeyAlt = event.alt;
      return true;
    case Event::Kind::wheel:
      io.MouseWheelH += static_cast<float>(event.x);
      io.MouseWheel += static_cast<float>(event.y);
      io.KeyCtrl = event.ctrl;
      io.KeyShift = event.shift;
      return false;
    case Event::Kind::key_down:
    case Event::Kind::key_up: {
      const bool down = event.kind == Event::Kind::key_down;
      io.KeyCtrl = event.ctrl;
      io.KeyShift = event.shift;
      io.KeyAlt = event.alt;
      io.KeyMods = (event.ctrl ? ImGuiKeyModFlags_Ctrl : 0) | (event.shift ? ImGuiKeyModFlags_Shift : 0) |
                   (event.alt ? ImGuiKeyModFlags_Alt : 0);
      swallow_text_ = false;
      // What character a key of punctuation gives, the text event says; with Ctrl there is none.
      if (down && (event.ctrl || event.alt || !is_punctuation(event.text)) && shortcut(key_text(event))) {
        swallow_text_ = true;  // "G" that opens a text field is not to stand in it
        return true;
      }
      // Enter presses the button that has the focus, as Space does; in a text field it is only Enter.
      const bool presses = event.text == "Enter" && (!down || !io.WantTextInput);
      // Dear ImGui's Tab knows text fields only. Where there is none to go to, it is the arrow that goes on.
      const bool goes_on =
          event.text == "Tab" && (!down || (player_->dialog != Dialog::none ? !io.WantTextInput : tabs_down()));
      const std::string_view arrow = event.shift ? "Up" : "Down";
      for (std::size_t i = 0; i < named_keys.size(); ++i) {
        const std::string_view name = named_keys[i].name;
        if (goes_on && (down ? name == arrow : name == "Up" || name == "Down" || name == "Tab"))
          io.KeysDown[i] = down;
        else if (!goes_on && (name == event.text || (presses && name == "Space")))
          io.KeysDown[i] = down;
      }
      return true;
    }
    case Event::Kind::text:
      if (std::exchange(swallow_text_, false)) return false;
      if (!io.WantTextInput && belongs_to_field()) return return_to_field(event);
      returning_ = false;
      if (!io.WantTextInput && is_punctuation(event.text) && shortcut(event.text)) return true;
      io.KeyCtrl = io.KeyAlt = false;  // whoever types letters has let go of them
      io.AddInputCharactersUTF8(event.text.c_str());
      return false;
    case Event::Kind::drop:
      send([path = event.text](Player& player) { player.open_asking(path); });
      return true;
    case Event::Kind::close:
      send([](Player& player) { player.unless_unsaved([](Player& p) { p.quit(); }); });
      return true;
  }
  return false;
}

// True if the key was a shortcut and is not ImGui's any more.
bool Ui::shortcut(const std::string& key) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool plain = key.find('+') == std::string::npos || key.size() == 1;
  const bool dialog = covered(), on_start = player_->session() == nullptr && !player_->in_studio();
  if (key == "Escape") {
    text_panel_.clear();
    if (dialog || io.WantTextInput) {
      if (player_->dialog != Dialog::none && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId))
        send([](Player& player) { player.dialog = Dialog::none; });
      return false;
    }
    context_->NavDisableHighlight = true;
    ring_ = false;
    send([](Player& player) {
      if (player.put_back()) return;  // what the mouse holds
      if (player.asks_to_skip()) return player.stay_at_checkpoint();
      if (player.in_studio() && player.studio()->escape()) return;
      const bool let_go = player.pinned() || player.focused || !player.problems().list.empty();
      if (player.stepping_from_studio() && !let_go) return player.back_to_studio();
      player.pin({});
      player.focused = {};
      player.focus.clear();
      player.dismiss_problems();
    });
    return true;
  }
  if (io.WantTextInput &&
      (plain || key.starts_with("Shift+") || key == "Ctrl+Z" || key == "Ctrl+Y" || key == "Ctrl+A" || key == "Ctrl+C" ||
       key == "Ctrl+V" || key == "Ctrl+X" || key == "Ctrl+Left" || key == "Ctrl+Right" || key == "Ctrl+Backspace" ||
       key == "Ctrl+Delete"))
    return false;
  // What a lesson asks is answered by keys wherever the keyboard is; walking among widgets Enter is theirs.
  if (!dialog && !(key == "Enter" && io.NavVisible && io.NavActive && !keyboard_panel().empty()) &&
      player_->wants_checkpoint_key(key)) {
    send([key](Player& player) { player.checkpoint_key(key); });
    return true;
  }
  if (dialog && (plain || key.starts_with("Shift+") || key == "Ctrl+Tab" || key == "Ctrl+Shift+Tab")) return false;
  if ((key.size() == 1 || key == "Space" || (key.size() == 7 && key.starts_with("Shift+"))) && belongs_to_field())
    return false;
  if (key == "F6" || key == "Shift+F6") {
    move_focus(key == "F6" ? 1 : -1);
    return true;
  }
  if (key == "F10") {
    give_focus("menu");
    return true;
  }
  if (key == "Tab" || key == "Shift+Tab") return tab_key(key != "Tab");
  if (key == "Ctrl+Tab" || key == "Ctrl+Shift+Tab") {
    choose_tab(key == "Ctrl+Tab" ? 1 : -1);
    return true;
  }
  if (on_start && keyboard_panel().empty() && is_arrow(key)) {
    give_focus("start");
    return true;
  }
  // Inside of widgets the arrows walk from one to the next.
  const bool walking = io.NavVisible && io.NavActive && !keyboard_panel().empty();
  const bool walks = key == "Left" || key == "Right" || key == "Up" || key == "Down" || key == "Space" ||
                     key == "Enter" || key == "Tab" || key == "Home" || key == "End" || key == "PageUp" ||
                     key == "PageDown";
  if (walks && (walking || on_start)) return false;
  if (key.starts_with("Alt+") && is_arrow(std::string_view(key).substr(4))) {
    const std::string way = key.substr(4);
    move_in_sheet(way == "Left" ? -1 : (way == "Right" ? 1 : 0), way == "Up" ? -1 : (way == "Down" ? 1 : 0));
    return true;
  }
  const Action* action = action_for_key(*player_, key);
  if (action == nullptr) return false;
  run_action(action->id, true);
  return true;
}

bool Ui::covered() const {
  return player_->dialog != Dialog::none || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
}

// What an action gives the keyboard to has it then.
void Ui::run_action(std::string_view id, bool by_key) {
  send([this, id, by_key](Player& player) {
    const std::string before = std::exchange(player.focus, {});
    const bool done = perform(player, id);
    if (!done && by_key) player.notice(not_now(player, *find_action(id)));
    if (player.focus.empty()) {
      player.focus = before;
      return;
    }
    focus_request_ = player.focus;
    if (!by_key) return;
    ring_ = true;
    context_->NavDisableHighlight = false;
    if (player.focus != "inputs") return;
    field_request_ = player.focus;
    held_back_ = frames_wanted_ = 5;
  });
}

bool Ui::gives_keyboard_to_field_of(std::string_view panel) {
  if (field_request_ != panel || !field_ready_) return false;
  field_request_.clear();
  return true;
}

// ---- text behind a field --------------------------------------------------------------------------------------------

// What is typed right behind Enter is meant for the field, too, not for shortcuts.
bool Ui::belongs_to_field() const {
  return !text_panel_.empty() && text_panel_ == player_->focus && context_->NavId == text_field_ && !covered();
}

// The field is made active again, then it gets the text. One that has gone away gets nothing, and nobody else does.
bool Ui::return_to_field(const Event& event) {
  if (std::exchange(returning_, !returning_)) return false;
  context_->NavNextActivateId = text_field_;
  context_->NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
  events_.push_front(event);
  held_back_ = 4;
  frames_wanted_ = std::max(frames_wanted_, held_back_);
  return true;
}

// ---- from panel to panel --------------------------------------------------------------------------------------------

std::string Ui::keyboard_panel() const { return things_.contains("panel " + player_->focus) ? player_->focus : ""; }

// True: the keyboard has gone to the next panel. In panels with fields it walks these, on the start page all there is.
bool Ui::tab_key(bool back) {
  const std::string panel = keyboard_panel();
  if (has_fields(panel) || tabs_down()) return false;
  move_focus(back ? -1 : 1);
  return true;
}

bool Ui::tabs_down() const { return keyboard_panel() == "start" || (covered() && player_->dialog == Dialog::none); }

void Ui::choose_tab(int by) {
  if (tabs_.empty()) return;
  const auto here = std::ranges::find(tabs_, player_->tab);
  const auto count = static_cast<int>(tabs_.size());
  const int from = here == tabs_.end() ? 0 : static_cast<int>(here - tabs_.begin());
  const std::string& next = tabs_[static_cast<std::size_t>((from + by + count) % count)];
  give_focus(next);
  send([next](Player& player) { player.tab = next; });
}

// The keyboard goes to the next panel on the screen, in the order in which one reads.
void Ui::move_focus(int by) {
  std::vector<std::pair<std::string, PixelRect>> order;
  for (const auto& [name, rect] : things_)
    if (name.starts_with("panel ")) order.emplace_back(name.substr(6), rect);
  if (order.empty()) return;
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second.y, a.second.x) < std::pair(b.second.y, b.second.x);
  });
  const auto here = std::find_if(order.begin(), order.end(), [&](const auto& p) { return p.first == player_->focus; });
  const auto count = static_cast<int>(order.size());
  const int from = here == order.end() ? (by > 0 ? -1 : 0) : static_cast<int>(here - order.begin());
  give_focus(order[static_cast<std::size_t>(((from + by) % count + count) % count)].first);
}

void Ui::give_focus(const std::string& panel) {
  ring_ = true;
  text_panel_.clear();
  context_->NavDisableHighlight = false;
  context_->NavDisableMouseHover = true;
  send([this, panel](Player& player) {
    focus_request_ = panel;
    player.focus = panel;
    player.focused = {};
  });
}

// In the panel with the keyboard, from one spot to the nearest in that direction.
void Ui::move_in_sheet(int dx, int dy) {
  auto panel = player_->focus;
  if (!sheet_spots_.contains(panel)) panel = sheet_spots_.contains("tableau") ? "tableau" : "viewport";
  const auto& spots = sheet_spots_[panel];
  if (spots.empty()) return;
  const auto here = std::find_if(spots.begin(), spots.end(), [&](const Spot& s) { return s.link == player_->focused; });
  const Spot* best = &spots.front();
  if (here != spots.end()) {
    best = nullptr;
    double least = 1e300;
    const double x = here->x + here->width / 2, y = here->y + here->height / 2;
    for (const Spot& spot : spots) {
      const double ax = spot.x + spot.width / 2 - x, ay = spot.y + spot.height / 2 - y;
      const double along = ax * dx + ay * dy, across = std::abs(ax * dy) + std::abs(ay * dx);
      if (along <= 1 || spot.link == here->link) continue;
      if (const double cost = along + 2.5 * across; cost < least) {
        least = cost;
        best = &spot;
      }
    }
  }
  if (best == nullptr) return;
  ring_ = true;
  context_->NavDisableHighlight = false;
  send([this, panel, link = best->link](Player& player) {
    if (player.focus != panel) focus_request_ = panel;
    player.focus = panel;
    player.focused = link;
  });
}

}  // namespace blossom
