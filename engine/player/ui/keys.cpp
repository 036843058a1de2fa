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
      for (std::size_t i = 0; i < named_keys.size(); ++i)
        if (named_keys[i].name == event.text || (presses && named_keys[i].name == "Space")) io.KeysDown[i] = down;
      return true;
    }
    case Event::Kind::text:
      if (std::exchange(swallow_text_, false)) return false;
      if (!io.WantTextInput && is_punctuation(event.text) && shortcut(event.text)) return true;
      io.KeyCtrl = io.KeyAlt = false;  // whoever types letters has let go of them
      io.AddInputCharactersUTF8(event.text.c_str());
      return false;
    case Event::Kind::drop:
      send([path = event.text](Player& player) { player.unless_unsaved([path](Player& p) { p.open(path); }); });
      return false;
    case Event::Kind::close:
      send([](Player& player) { player.unless_unsaved([](Player& p) { p.quit(); }); });
      return false;
  }
  return false;
}

// True if the key was a shortcut and is not ImGui's any more.
bool Ui::shortcut(const std::string& key) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool plain = key.find('+') == std::string::npos || key.size() == 1;
  const bool dialog = player_->dialog != Dialog::none || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
  if (key == "Escape") {
    if (dialog || io.WantTextInput) {
      if (player_->dialog != Dialog::none && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId))
        send([](Player& player) { player.dialog = Dialog::none; });
      return false;
    }
    context_->NavDisableHighlight = true;
    send([](Player& player) {
      if (player.put_back()) return;  // what the mouse holds
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
  if (dialog && (plain || key.starts_with("Shift+"))) return false;
  if (key == "F6" || key == "Shift+F6") {
    move_focus(key == "F6" ? 1 : -1);
    return true;
  }
  if (key == "F10") {
    give_focus("menu");
    return true;
  }
  // Inside of widgets the arrows walk from one to the next.
  const bool walking = io.NavVisible && io.NavActive;
  const bool walks = key == "Left" || key == "Right" || key == "Up" || key == "Down" || key == "Space" ||
                     key == "Enter" || key == "Tab" || key == "Home" || key == "End" || key == "PageUp" ||
                     key == "PageDown";
  if (walks && (walking || player_->session() == nullptr)) return false;
  if (key.starts_with("Alt+") &&
      (key.ends_with("Left") || key.ends_with("Right") || key.ends_with("Up") || key.ends_with("Down"))) {
    const std::string way = key.substr(4);
    move_in_sheet(way == "Left" ? -1 : (way == "Right" ? 1 : 0), way == "Up" ? -1 : (way == "Down" ? 1 : 0));
    return true;
  }
  const Action* action = action_for_key(key);
  if (action == nullptr) return false;
  send([action](Player& player) { perform(player, action->id); });
  return true;
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
  focus_request_ = panel;
  context_->NavDisableHighlight = false;
  context_->NavDisableMouseHover = true;
  send([panel](Player& player) {
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
  context_->NavDisableHighlight = false;
  send([panel, link = best->link](Player& player) {
    player.focus = panel;
    player.focused = link;
  });
}

}  // namespace blossom
