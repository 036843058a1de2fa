#pragma once
// The window's inside, whatever the window is: events in, frames out. Dear ImGui lays out widgets and text fields;
// sheets and pictures are our own display lists, painted at their place among ImGui's triangles by the one canvas.
//
// Lengths of panels are units: a unit is a pixel times the screen's scale (HiDPI) times the text size one has chosen.

#include <imgui.h>

#include <deque>
#include <map>
#include <memory>

#include "lesson/prose.hpp"
#include "player/player.hpp"
#include "player/ui/event.hpp"
#include "player/ui/frame_parts.hpp"
#include "player/ui/layout.hpp"
#include "render/font.hpp"
#include "render/gl_canvas.hpp"
#include "render/lesson_theme.hpp"
#include "scene/panels.hpp"

namespace blossom {

struct SheetOptions {
  bool clickable = true;  // clicks pin, double clicks go to the step, the right button opens the menu of a value
  double zoom = 1;        // pixels for each unit, of those it would have: the sheet as a whole is that much smaller
};

void set_key_map(ImGuiIO&);  // which index of KeysDown is which key

class Ui {
 public:
  static Checked<std::unique_ptr<Ui>> create(Player&, const GlFunctions&, bool is_es, std::shared_ptr<const Fonts>);
  ~Ui();
  Ui(const Ui&) = delete;

  // ---- for windows ------------------------------------------------------------------------------------------------
  void feed(Event);
  void resize(int width, int height, double pixels_per_unit);  // in pixels
  bool wants_frame() const;                                    // there is something to draw, or events that wait
  // One frame of the window; to the canvas unless nobody is to see it.
  void frame(double seconds, bool drawn = true);
  void redraw() { frames_wanted_ = std::max(frames_wanted_, 2); }
  GlCanvas& canvas() { return *canvas_; }
  const FrameParts& frame_parts() const { return frame_parts_; }  // what the last frame took
  ImGuiMouseCursor cursor() const { return cursor_; }
  bool wants_text() const;
  bool settling() const { return frames_wanted_ > 0 || !events_.empty(); }  // without what merely moves
  double pixels_per_screen_unit() const { return pixels_per_unit_; }        // HiDPI, without the text size
  // Every named thing of the last frame, in pixels: what scripts click, and what a screen reader would find.
  const std::map<std::string, PixelRect>& things() const { return things_; }
  void focus_thing(const std::string& name) { focus_request_ = name; }
  // Draws a page in this context, as a file of the kind that its extension says (.png, .svg).
  Checked<bool> save_picture(const Scene&, const std::filesystem::path&);

  // ---- for panels -------------------------------------------------------------------------------------------------
  const Player& player() const { return *player_; }
  // Done after all panels are drawn.
  void send(std::function<void(Player&)> what) { sent_.push_back(std::move(what)); }
  void act(std::string_view action);  // sends the action of this id
  const Theme& theme() const { return theme_; }
  const Fonts& fonts() const { return *fonts_; }
  float px(double units) const { return static_cast<float>(units * scale_); }
  double units(float pixels) const { return pixels / scale_; }
  double width() const { return width_ / scale_; }  // of the window, in units
  double height() const { return height_ / scale_; }
  ImFont* regular() const { return regular_; }
  ImFont* bold() const { return bold_; }
  ImFont* mono() const { return mono_; }
  ImFont* small() const { return small_; }
  ImU32 color(Role, double opacity = 1) const;  // of lines and fills
  ImU32 ink(Role, double opacity = 1) const;    // of text

  // A view of this size in units at ImGui's cursor, as an item of that size. Its top left in pixels.
  ImVec2 picture(View, double width, double height, std::string_view name, double zoom = 1);
  // A sheet likewise, with its spots alive: hovering lights, clicking pins. What the mouse is over, or nullptr.
  const Spot* sheet(std::string_view panel, Sheet, double width, double height, const SheetOptions& = {});
  // As if the mouse were over it.
  void light(const Link& link) { hovered_ = link; }
  // The menu of a value: what can be done with it. Called by whoever right-clicks.
  void open_menu(const Link&);
  // Names ImGui's last item (or a rectangle in pixels) for scripts.
  void thing(const std::string& name);
  void thing(const std::string& name, const ImVec2& low, const ImVec2& high);
  // Buttons. The name is what scripts call it; the shortcut stands in the tooltip.
  bool button(const char* label, const std::string& name, bool enabled = true, const char* tooltip = nullptr);
  bool action_button(std::string_view action, const char* label);
  // An icon drawn as a shape, so that it is sharp at every size. "first", "back", "play", "pause", "forward", "over",
  // "out", "last", "next-beat", "previous-beat", "loop", "bookmark", "undo", "redo", "fit", "menu", "close".
  bool icon_button(std::string_view action, std::string_view icon, bool pressed = false);
  void heading(const char* text);
  // Text with names in it set as in books (see typeset_text), wrapped at a width; `values` makes the names of values
  // spots, looked up in the phase of the value that the text is `about`, or else of the step. The sheet's height in
  // units is stored at `height`.
  Sheet flow(const std::string& text, double width, double size, Role role, double& height, bool values = true,
             std::optional<ValueId> about = {}) const;
  // The same of what a lesson says, with its bold words, lists and formulas (see read_prose).
  Sheet flow(const Prose&, double width, double size, Role role, double& height, bool values = true,
             std::optional<ValueId> about = {}) const;
  Sheet flow(const RichText&, double width, double size, Role role, double& height) const;  // as it is set already
  // Asked by a panel before each of its text fields: whether this one is to have the keyboard. Once for a request.
  bool gives_keyboard_to_field_of(std::string_view panel);
  // Whether the step is another one than when this panel asked last: then it scrolls along.
  bool step_is_new_to(const std::string& panel);
  bool keyboard_in(std::string_view panel) const { return player_->focus == panel; }

 private:
  struct Key;
  Ui(Player&, std::unique_ptr<GlCanvas>, std::shared_ptr<const Fonts>);
  void take_events();
  bool take(const Event&);  // true: the frame must be drawn before the next event
  bool shortcut(const std::string& key);
  void make_fonts();
  void make_style();
  void draw_panels();
  void draw_window(const Panel&, const PixelRect&);
  void draw_tabs(const Layout&);
  void draw_tab_bar(const Layout&, const Panel& active);
  void draw_splitters(const Layout&);
  void draw_menu();
  bool keyboard_arrives(const std::string& panel);  // before its window begins
  void welcome_keyboard(const Panel&);              // in its window, once it has arrived
  void draw_focus_ring(const std::string& panel);
  bool covered() const;  // a dialog or a menu stands over the panels
  bool belongs_to_field() const;
  bool return_to_field(const Event&);
  bool tab_key(bool back);
  bool tabs_down() const;  // Tab goes on as the arrow down does
  void choose_tab(int by);
  void run_action(std::string_view id, bool by_key);
  std::string keyboard_panel() const;  // of those on the screen; empty: none
  void move_focus(int by);
  void give_focus(const std::string& panel);
  void move_in_sheet(int dx, int dy);
  void paint();

  Player* player_;
  std::unique_ptr<GlCanvas> canvas_;
  std::shared_ptr<const Fonts> fonts_;
  ImGuiContext* context_ = nullptr;
  Theme theme_;  // with the colours of the lesson that is open
  const Theme* plain_theme_ = nullptr;
  LessonColors colors_;
  ImFont *regular_ = nullptr, *bold_ = nullptr, *mono_ = nullptr, *small_ = nullptr;
  double fonts_scale_ = 0;
  int width_ = 1280, height_ = 720;
  double pixels_per_unit_ = 1, scale_ = 1;
  int frames_wanted_ = 3;
  const Session* seen_session_ = nullptr;
  std::deque<Event> events_;
  std::vector<std::function<void(Player&)>> sent_;
  std::map<std::string, PixelRect> things_;
  std::string focus_request_;
  bool swallow_text_ = false;
  bool picture_saved_ = false;  // in this frame, through the window's canvas
  bool ring_ = false;           // the keyboard was moved by keys: what has it is marked
  bool field_ready_ = false;
  std::string field_request_;      // the panel whose first text field is to have the keyboard
  std::string text_panel_;         // where one types, or has just typed
  ImGuiID text_field_ = 0;         // its field there
  bool returning_ = false;         // what was typed behind it waits for it
  int held_back_ = 0;              // frames until a field that was asked for takes what is typed
  std::vector<std::string> tabs_;  // of the last frame
  FrameParts frame_parts_;
  ImGuiMouseCursor cursor_ = ImGuiMouseCursor_Arrow;

  // Pictures of this frame: ImGui's draw lists refer to them by number.
  struct Placement {
    View view;
    glm::dvec2 origin;
    double zoom = 1;
  };
  std::vector<Placement> pictures_;
  std::map<std::string, std::vector<Spot>> sheet_spots_;  // of the last frame, in pixels, for the keyboard
  std::vector<Spot> kept_spots_;
  Link hovered_;  // of this frame
  std::map<std::string, std::pair<std::uint64_t, std::uint32_t>> seen_steps_;
  Link menu_link_;
  bool menu_requested_ = false;
};

}  // namespace blossom
