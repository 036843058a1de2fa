// A real window, through GLFW. Drawn only when there is something new; otherwise it sleeps.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>

#include "player/ui/ui.hpp"
#include "player/window/file_dialog.hpp"
#include "player/window/window.hpp"

namespace blossom {
namespace {

struct KeyName {
  int key;
  const char* name;
};
constexpr std::array<KeyName, 33> key_names = {{
    {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_RIGHT, "Right"},
    {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_DOWN, "Down"},
    {GLFW_KEY_PAGE_UP, "PageUp"},
    {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"},
    {GLFW_KEY_END, "End"},
    {GLFW_KEY_INSERT, "Insert"},
    {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_SPACE, "Space"},
    {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_ESCAPE, "Escape"},
    {GLFW_KEY_KP_ENTER, "KeypadEnter"},
    {GLFW_KEY_KP_ADD, "+"},
    {GLFW_KEY_KP_SUBTRACT, "-"},
    {GLFW_KEY_F1, "F1"},
    {GLFW_KEY_F2, "F2"},
    {GLFW_KEY_F3, "F3"},
    {GLFW_KEY_F4, "F4"},
    {GLFW_KEY_F5, "F5"},
    {GLFW_KEY_F6, "F6"},
    {GLFW_KEY_F7, "F7"},
    {GLFW_KEY_F8, "F8"},
    {GLFW_KEY_F9, "F9"},
    {GLFW_KEY_F10, "F10"},
    {GLFW_KEY_F11, "F11"},
    {GLFW_KEY_F12, "F12"},
    {GLFW_KEY_KP_0, "0"},
    {GLFW_KEY_KP_DECIMAL, "."},
    {GLFW_KEY_KP_DIVIDE, "/"},
}};

// What is written on the key, in the person's own layout.
std::string name_of_key(int key, int scancode) {
  for (const KeyName& known : key_names)
    if (known.key == key) return known.name;
  const char* letter = glfwGetKeyName(key, scancode);
  if (letter == nullptr) return {};
  std::string name = letter;
  if (name.size() == 1) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

class GlfwDesk final : public Desk {
 public:
  explicit GlfwDesk(GLFWwindow* window) : window_(window) {}
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
  std::string clipboard() override {
    const char* text = glfwGetClipboardString(window_);
    return text != nullptr ? text : "";
  }
  bool choose_file(bool to_save, const std::filesystem::path& suggested,
                   std::function<void(std::filesystem::path)> chosen) override {
    auto dialog = FileDialog::open(to_save, suggested);
    if (!dialog) return false;
    dialog_ = std::move(dialog);
    chosen_ = std::move(chosen);
    return true;
  }
  Checked<bool> save_picture(const Scene& scene, const std::filesystem::path& file) override {
    return ui->save_picture(scene, file);
  }
  // True if the person has answered.
  bool poll() {
    if (!dialog_) return false;
    const auto answer = dialog_->poll();
    if (!answer) return false;
    dialog_.reset();
    if (!answer->empty()) chosen_(*answer);
    return true;
  }

  Ui* ui = nullptr;

 private:
  GLFWwindow* window_;
  std::unique_ptr<FileDialog> dialog_;
  std::function<void(std::filesystem::path)> chosen_;
};

// GLFW keeps what it says of a mistake for whoever asks next.
std::string glfw_says() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

struct Library {
  bool ready = glfwInit() == GLFW_TRUE;
  ~Library() {
    if (ready) glfwTerminate();
  }
};

volatile std::sig_atomic_t asked_to_end = 0;

class Events {
 public:
  Events(GLFWwindow* window, Ui& ui) : window_(window), ui_(&ui) {
    glfwSetWindowUserPointer(window, this);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { self(w).resize(); });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { self(w).resize(); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { self(w).ui_->redraw(); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
      glfwSetWindowShouldClose(w, GLFW_FALSE);  // the player may want to ask first
      Event event;
      event.kind = Event::Kind::close;
      self(w).ui_->feed(event);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { self(w).move(x, y); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
      Event event;
      event.kind = Event::Kind::leave;
      if (entered == GLFW_FALSE) self(w).ui_->feed(event);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
      Event event = with(mods, action == GLFW_PRESS ? Event::Kind::press : Event::Kind::release);
      event.button = button;
      self(w).ui_->feed(event);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
      Event event = with(self(w).mods_, Event::Kind::wheel);
      event.x = x;
      event.y = y;
      self(w).ui_->feed(event);
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
      self(w).mods_ = mods;
      Event event = with(mods, action == GLFW_RELEASE ? Event::Kind::key_up : Event::Kind::key_down);
      event.text = name_of_key(key, scancode);
      // Of a modifier's own key GLFW says what was held before. What is dragged follows it.
      const bool shift = key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT;
      const bool ctrl = key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL;
      if (shift) event.shift = action != GLFW_RELEASE;
      if (ctrl) event.ctrl = action != GLFW_RELEASE;
      if (shift || ctrl || !event.text.empty()) self(w).ui_->feed(event);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int c) {
      Event event;
      event.kind = Event::Kind::text;
      event.text = encode_utf8(c);
      self(w).ui_->feed(event);
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
      Event event;
      event.kind = Event::Kind::drop;
      if (count > 0) event.text = paths[0];
      if (count > 0) self(w).ui_->feed(event);
    });
    resize();
  }

  void resize() {
    int width = 0, height = 0, window_width = 0, window_height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    glfwGetWindowSize(window_, &window_width, &window_height);
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    pixels_per_point_ = window_width > 0 ? static_cast<double>(width) / window_width : 1;
    ui_->resize(width, height, std::max(1.0, static_cast<double>(x)));
  }

  void show_cursor() {
    const ImGuiMouseCursor wanted = ui_->cursor();
    if (wanted == shown_cursor_) return;
    shown_cursor_ = wanted;
    static const std::array<int, ImGuiMouseCursor_COUNT> shapes = {
        GLFW_ARROW_CURSOR, GLFW_IBEAM_CURSOR, GLFW_HAND_CURSOR, GLFW_VRESIZE_CURSOR, GLFW_HRESIZE_CURSOR,
        GLFW_ARROW_CURSOR, GLFW_ARROW_CURSOR, GLFW_HAND_CURSOR, GLFW_ARROW_CURSOR};
    static std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> cursors{};
    if (wanted < 0 || wanted >= ImGuiMouseCursor_COUNT) return;
    const auto i = static_cast<std::size_t>(wanted);
    if (cursors[i] == nullptr) cursors[i] = glfwCreateStandardCursor(shapes[i]);
    glfwSetCursor(window_, cursors[i]);
  }

 private:
  static Events& self(GLFWwindow* w) { return *static_cast<Events*>(glfwGetWindowUserPointer(w)); }
  static Event with(int mods, Event::Kind kind) {
    Event event;
    event.kind = kind;
    event.ctrl = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    event.alt = (mods & GLFW_MOD_ALT) != 0;
    return event;
  }
  void move(double x, double y) {
    Event event;
    event.x = x * pixels_per_point_;
    event.y = y * pixels_per_point_;
    ui_->feed(event);
  }

  GLFWwindow* window_;
  Ui* ui_;
  double pixels_per_point_ = 1;
  int mods_ = 0;
  ImGuiMouseCursor shown_cursor_ = ImGuiMouseCursor_Arrow;
};

using Clock = std::chrono::steady_clock;

}  // namespace

Diagnostics play_in_window(const PlayerOptions& options, const Start& start, FrameTimes* times) {
  const auto started = [&](const char* what) {
    if (times != nullptr) times->started(what);
  };
  started("process, reading the file");
  const auto fault = [](std::string message) { return Diagnostics{{"", 0, 0, "", std::move(message)}}; };
  Library library;
  if (!library.ready)
    return fault("there is no display for a window (" + glfw_says() +
                 "); `blossom step` steps in the terminal, `blossom render` draws to files");
  started("GLFW");
  Diagnostics unread;
  const Settings remembered = sane(load_settings(options.places, unread));
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  GLFWwindow* window = glfwCreateWindow(remembered.width, remembered.height, "Blossom", nullptr, nullptr);
  if (window == nullptr) return fault("no window with OpenGL 3.3 can be made: " + glfw_says());
  glfwSetWindowSizeLimits(window, 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  started("window, OpenGL");
  const auto gl = load_gl_functions([](const char* name) { return glfwGetProcAddress(name); });
  if (!gl) return gl.diagnostics;
  auto fonts = Fonts::load();
  if (!fonts) return fonts.diagnostics;

  GlfwDesk desk(window);
  Player player(options, desk);
  started("fonts, settings");
  auto ui = Ui::create(player, *gl, false, *fonts);
  if (!ui) return ui.diagnostics;
  desk.ui = ui->get();
  Events events(window, **ui);
  started("shaders");
  start(player);
  started("recording");
  // An orderly end keeps what is to be kept.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, [](int) { asked_to_end = 1; });

  auto before = Clock::now();
  std::string title;
  while (!player.wants_to_quit() && asked_to_end == 0) {
    if ((*ui)->wants_frame())
      glfwPollEvents();
    else
      glfwWaitEventsTimeout(0.25);
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - before).count();
    before = now;
    Stopwatch watch;
    if (player.advance(seconds) || desk.poll()) (*ui)->redraw();
    if (!(*ui)->wants_frame()) continue;
    const double advancing = watch.lap();
    (*ui)->frame(seconds);
    Stopwatch clock(CLOCK_MONOTONIC);
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    (*ui)->canvas().present(0, width, height);
    glfwSwapBuffers(window);
    if (times != nullptr) times->presented(advancing, (*ui)->frame_parts(), clock.lap());
    events.show_cursor();
    const std::string wanted = player.session() != nullptr  ? player.session()->document().title() + " - Blossom"
                               : player.studio() != nullptr ? player.studio()->title() + " - Blossom"
                                                            : "Blossom";
    if (wanted != title) glfwSetWindowTitle(window, (title = wanted).c_str());
    if (glfwGetWindowAttrib(window, GLFW_MAXIMIZED) == GLFW_FALSE)
      glfwGetWindowSize(window, &player.settings.width, &player.settings.height);
  }
  return {};
}

}  // namespace blossom
