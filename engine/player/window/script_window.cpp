// The window off screen: a script's instructions become the events that a person would make, at the places where the
// named things are. Time passes only as the script says, so a script gives the same pictures on every machine.
#include <algorithm>
#include <cmath>

#include "player/state.hpp"
#include "player/ui/ui.hpp"
#include "player/window/window.hpp"
#include "render/headless_context.hpp"

namespace blossom {

namespace fs = std::filesystem;

namespace {

class ScriptDesk final : public Desk {
 public:
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  std::string clipboard() override { return clipboard_; }
  bool choose_file(bool, const fs::path&, std::function<void(fs::path)>) override { return false; }
  Checked<bool> save_picture(const Scene& scene, const fs::path& file) override {
    return ui->save_picture(scene, file);
  }
  Ui* ui = nullptr;

 private:
  std::string clipboard_;
};

constexpr double frame_seconds = 1.0 / 60;

class Driver {
 public:
  Driver(Player& player, Ui& ui, std::string script, fs::path out)
      : player_(player), ui_(ui), script_(std::move(script)), out_(std::move(out)) {
    ui_.resize(1280, 720, 1);
    settle();
  }

  Diagnostics play(const std::vector<Instruction>& instructions) {
    std::string_view before;
    for (const Instruction& instruction : instructions) {
      line_ = instruction.line;
      // Motions are over when the next instruction begins, unless time is counted.
      if (instruction.verb != "wait" && before != "wait") finish_motion();
      follow(instruction.verb, instruction.words);
      settle();
      if (!wrong_.empty()) return wrong_;
      before = instruction.verb;
    }
    return {};
  }

 private:
  void fail(std::string message) { wrong_.push_back({script_, line_, 1, "", std::move(message)}); }

  void frame(double seconds) {
    player_.advance(seconds);
    ui_.frame(seconds, false);
  }
  // Until all events are taken and what they opened has settled.
  void settle() {
    for (int i = 0; i < 200 && (i == 0 || ui_.settling()); ++i) frame(0);
  }
  void finish_motion() {
    if (player_.session() != nullptr && player_.session()->timeline().playing()) return;
    if (player_.in_studio() && player_.studio()->running()) return;
    player_.wait_for_export();
    for (int i = 0; i < 20 && player_.animating(); ++i) frame(0.1);
    if (player_.shelf() != nullptr && player_.session() == nullptr && !player_.shelf()->done()) {
      const_cast<Shelf*>(player_.shelf())->wait();
      frame(frame_seconds);
    }
    ui_.redraw();
    settle();
  }

  void feed(Event event) { ui_.feed(std::move(event)); }
  Event event(Event::Kind kind) const {
    Event made;
    made.kind = kind;
    return made;
  }

  void move_to(double x, double y) {
    Event move = event(Event::Kind::move);
    move.x = x;
    move.y = y;
    feed(move);
    settle();
  }
  void button(Event::Kind kind, int which, const Event& modifiers) {
    Event made = modifiers;
    made.kind = kind;
    made.button = which;
    feed(made);
    settle();
  }

  std::optional<glm::dvec2> place(const std::string& name) {
    const auto found = ui_.things().find(name);
    if (found != ui_.things().end())
      return glm::dvec2{found->second.x + found->second.width / 2, found->second.y + found->second.height / 2};
    std::vector<std::string> names;
    for (const auto& [known, rect] : ui_.things()) names.push_back(known);
    const auto near = did_you_mean(name, names);
    fail("there is no " + excerpt(name) + " on the screen" + (near ? "; did you mean " + excerpt(*near) + "?" : ""));
    return std::nullopt;
  }

  static void read_modifiers(const std::vector<std::string>& words, std::size_t from, Event& modifiers, int& which,
                             bool& twice) {
    for (std::size_t i = from; i < words.size(); ++i) {
      if (words[i] == "right") which = 1;
      if (words[i] == "middle") which = 2;
      if (words[i] == "double") twice = true;
      modifiers.ctrl = modifiers.ctrl || words[i] == "ctrl";
      modifiers.shift = modifiers.shift || words[i] == "shift";
      modifiers.alt = modifiers.alt || words[i] == "alt";
    }
  }

  void click(const std::vector<std::string>& words) {
    const auto at = place(words[0]);
    if (!at) return;
    Event modifiers;
    int which = 0;
    bool twice = false;
    read_modifiers(words, 1, modifiers, which, twice);
    move_to(at->x, at->y);
    for (int i = 0; i < (twice ? 2 : 1); ++i) {
      button(Event::Kind::press, which, modifiers);
      button(Event::Kind::release, which, modifiers);
    }
    frame(0.5);  // the next click is no second one of a double click
  }

  void drag(const std::vector<std::string>& words) {
    const auto from = place(words[0]);
    if (!from) return;
    const bool to_thing = words[1] == "to";
    std::optional<glm::dvec2> to;
    if (to_thing)
      to = place(words[2]);
    else
      to = *from + glm::dvec2(number(words[2]), number(words[3])) * ui_.pixels_per_screen_unit();
    if (!to) return;
    Event modifiers;
    int which = 0;
    bool twice = false;
    read_modifiers(words, to_thing ? 3 : 4, modifiers, which, twice);
    move_to(from->x, from->y);
    button(Event::Kind::press, which, modifiers);
    constexpr int pieces = 5;
    for (int i = 1; i <= pieces; ++i) {
      const glm::dvec2 at = *from + (*to - *from) * (static_cast<double>(i) / pieces);
      move_to(at.x, at.y);
    }
    button(Event::Kind::release, which, modifiers);
    frame(0.5);
  }

  void key(const std::string& text) {
    Event down = event(Event::Kind::key_down);
    std::string_view rest = text;
    for (bool more = true; more;) {
      more = false;
      for (const auto& [prefix, flag] : {std::pair<std::string_view, bool Event::*>{"Ctrl+", &Event::ctrl},
                                         {"Alt+", &Event::alt},
                                         {"Shift+", &Event::shift}}) {
        if (rest.size() <= prefix.size() || !rest.starts_with(prefix)) continue;
        down.*flag = true;
        rest.remove_prefix(prefix.size());
        more = true;
      }
    }
    down.text = rest;
    if (down.text.size() == 1) down.text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(down.text[0])));
    Event up = down;
    up.kind = Event::Kind::key_up;
    up.ctrl = up.alt = up.shift = false;  // they are let go with it
    feed(down);
    settle();
    if (rest.size() == 1 && !down.ctrl && !down.alt) type(std::string(rest));
    feed(up);
    settle();
  }
  void type(const std::string& text) {
    Event typed = event(Event::Kind::text);
    for (const char32_t c : decode_utf8(text)) {
      typed.text = encode_utf8(c);
      feed(typed);
      settle();
    }
  }

  static double number(const std::string& text) { return Exact::parse(text)->to_double(); }

  void write(const std::string& name, const std::string& extension, const std::string& content) {
    const auto written = write_file(out_ / (name + extension), content);
    if (!written) wrong_ = written.diagnostics;
  }

  void shot(const std::string& name) {
    ui_.frame(0, true);
    const auto image = ui_.canvas().read();
    if (!image) {
      wrong_ = image.diagnostics;
      return;
    }
    if (const auto written = write_png(out_ / (name + ".png"), *image); !written) wrong_ = written.diagnostics;
  }

  void state(const std::string& name) {
    std::string text = "{";
    for (const std::string& key : state_keys())
      if (const auto value = state_of(player_, key))
        text += (text.size() > 1 ? "," : "") + std::string("\n  ") + json_quote(key) + ": " + json_quote(*value);
    write(name, ".json", text + "\n}\n");
  }

  void things(const std::string& name) {
    std::string text = "{";
    for (const auto& [thing, rect] : ui_.things())
      text += (text.size() > 1 ? "," : "") + std::string("\n  ") + json_quote(thing) + ": [" + format_short(rect.x, 1) +
              ", " + format_short(rect.y, 1) + ", " + format_short(rect.width, 1) + ", " +
              format_short(rect.height, 1) + "]";
    write(name, ".json", text + "\n}\n");
  }

  void expect(const std::string& key, const std::string& wanted) {
    const auto is = state_of(player_, key);
    if (!is)
      fail("there is no " + excerpt(key) + " here");
    else if (*is != wanted)
      fail("expected " + key + " to be " + json_quote(wanted) + ", not " + json_quote(*is));
  }
  void expect_near(const std::string& key, double wanted, double tolerance) {
    const auto is = state_of(player_, key);
    const auto value = is ? Exact::parse(*is) : std::nullopt;
    if (!value)
      fail("expected " + key + " to be a number, not " + (is ? json_quote(*is) : "nothing"));
    else if (!(std::abs(value->to_double() - wanted) <= tolerance))
      fail("expected " + key + " to be within " + format_number(tolerance) + " of " + format_number(wanted) + ", not " +
           *is);
  }

  // A file that the script itself has written or is to write: "OUT/points.csv" stands in its own folder.
  std::string in_out(const std::string& text) const {
    return text.starts_with("OUT/") ? (fs::absolute(out_) / text.substr(4)).string() : text;
  }

  void follow(const std::string& verb, const std::vector<std::string>& words) {
    if (verb == "size") {
      const double scale = words.size() > 2 ? number(words[2]) : 1;
      const double largest = std::max(number(words[0]), number(words[1])) * scale;
      if (largest > std::min(ui_.canvas().max_size(), 8192)) return fail("a window of so many pixels cannot be drawn");
      ui_.resize(static_cast<int>(number(words[0]) * scale), static_cast<int>(number(words[1]) * scale), scale);
    } else if (verb == "open" || verb == "drop") {
      Event drop = event(Event::Kind::drop);
      drop.text = in_out(words[0]);
      feed(drop);
    } else if (verb == "key") {
      key(words[0]);
    } else if (verb == "type") {
      type(in_out(words[0]));
    } else if (verb == "focus") {
      ui_.focus_thing(words[0]);
      ui_.redraw();
    } else if (verb == "move") {
      if (const auto at = place(words[0])) move_to(at->x, at->y);
    } else if (verb == "click") {
      click(words);
    } else if (verb == "drag") {
      drag(words);
    } else if (verb == "wheel") {
      if (const auto at = place(words[0])) {
        move_to(at->x, at->y);
        Event wheel = event(Event::Kind::wheel);
        wheel.y = number(words[1]);
        feed(wheel);
      }
    } else if (verb == "wait") {
      const double seconds = number(words[0]);
      const int frames = std::max(1, static_cast<int>(std::lround(seconds / frame_seconds)));
      for (int i = 0; i < frames; ++i) frame(seconds / frames);
    } else if (verb == "shot") {
      shot(words[0]);
    } else if (verb == "state") {
      state(words[0]);
    } else if (verb == "things") {
      things(words[0]);
    } else if (verb == "expect") {
      expect(words[0], words[1]);
    } else if (verb == "expect-near") {
      expect_near(words[0], number(words[1]), number(words[2]));
    } else if (verb == "expect-thing") {
      place(words[0]);
    } else if (verb == "expect-no-thing") {
      if (ui_.things().contains(words[0])) fail(excerpt(words[0]) + " is on the screen");
    } else if (verb == "close") {
      feed(event(Event::Kind::close));
    }
  }

  Player& player_;
  Ui& ui_;
  std::string script_;
  fs::path out_;
  int line_ = 0;
  Diagnostics wrong_;
};

}  // namespace

Diagnostics play_script(const PlayerOptions& options, const Start& start, const std::string& script_name,
                        const std::vector<Instruction>& instructions, const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  auto context = make_headless_context("osmesa");
  if (!context) return context.diagnostics;
  if (!(*context)->make_current()) return {{"", 0, 0, "", "the OpenGL context does not become current"}};
  const auto gl = load_gl_functions([&](const char* name) { return (*context)->address_of(name); });
  if (!gl) return gl.diagnostics;
  auto fonts = Fonts::load();
  if (!fonts) return fonts.diagnostics;
  ScriptDesk desk;
  Player player(options, desk);
  auto ui = Ui::create(player, *gl, (*context)->is_es(), *fonts);
  if (!ui) return ui.diagnostics;
  desk.ui = ui->get();
  start(player);
  return Driver(player, **ui, script_name, out).play(instructions);
}

}  // namespace blossom
