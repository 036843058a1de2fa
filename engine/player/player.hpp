#pragma once
// The application, without a window: what is open, what is lit, where the camera is, what is asked of the person. Panels
// read it and send functions that change it; a clock calls advance().

#include <functional>

#include "player/influence.hpp"
#include "player/session.hpp"
#include "player/settings.hpp"
#include "player/shelf.hpp"
#include "player/watch.hpp"
#include "scene/camera.hpp"

namespace blossom {

// What the system does for the player.
class Desk {
 public:
  virtual ~Desk() = default;
  virtual void set_clipboard(const std::string&) = 0;
  virtual std::string clipboard() = 0;
  // The system's own dialog for a file, if it has one; the answer comes later through `chosen`. False: it has none.
  virtual bool choose_file(bool to_save, const std::filesystem::path& suggested,
                           std::function<void(std::filesystem::path)> chosen) = 0;
  // Draws a page in the window's own context.
  virtual Checked<bool> save_picture(const Scene&, const std::filesystem::path&) = 0;
};

// Which window of its own stands over the rest.
enum class Dialog : std::uint8_t {
  none,
  open,         // a file
  save_lesson,  // the edited inputs as a lesson
  save_picture,
  settings,
  shortcuts,
  palette,   // all actions by name
  go_to,     // a step or a value
  recover,   // edits that a crash left behind
  unsaved,   // before edits are lost
};

struct PlayerOptions {
  Places places;
  std::filesystem::path lessons, exercises;  // the shipped ones
  bool watch = true;                         // files on disk
};

class Player {
 public:
  Player(PlayerOptions, Desk&);
  ~Player();
  Player(const Player&) = delete;

  // ---- what is open -----------------------------------------------------------------------------------------------
  Session* session() { return session_.get(); }
  const Session* session() const { return session_.get(); }
  // Opens a file; what is wrong with it becomes the problems, and what was open stays open.
  bool open(const std::filesystem::path&, std::string_view algorithm = {});
  bool open(Document);
  // Asks first (Dialog::unsaved) when edits would be lost; then does it.
  void unless_unsaved(std::function<void(Player&)> then);
  void close();  // to the start page
  void quit() { quit_ = true; }
  bool wants_to_quit() const { return quit_; }
  const Shelf* shelf() const { return shelf_.get(); }
  const std::vector<Autosave>& lost_work() const { return lost_; }
  void recover(std::size_t which);
  void forget_lost(std::size_t which);

  // What is wrong with a file: shown as a list until it is right or put away.
  struct Problems {
    std::string what;  // "bernstein.json cannot be opened"
    Diagnostics list;
  };
  const Problems& problems() const { return problems_; }
  void show_problems(std::string what, Diagnostics);
  void dismiss_problems() { problems_ = {}; }
  // A line that goes away by itself.
  void notice(std::string);
  const std::string& notice() const { return notice_; }

  // ---- what is lit ------------------------------------------------------------------------------------------------
  void hover(const Link&, std::string_view panel);  // of this frame; none when nothing is
  const Link& hovered() const { return hovered_; }
  void pin(const Link&);  // again: takes it off; none: all off
  Link pinned() const;    // in the run as it is now
  bool is_pinned(const Link&) const;
  void ask_why(ValueId);  // opens the panel "why" for it
  std::optional<ValueId> why_asked() const;
  const Emphasis& emphasis() const;  // of all of it, at this step

  // ---- how it is looked at ----------------------------------------------------------------------------------------
  const std::optional<Camera>& camera() const { return camera_; }  // nothing: all of it, fitted
  void set_camera(const std::optional<Camera>&);
  void glide_to(const std::optional<Camera>&);  // there, in a moment (at once with reduced motion)
  void set_view_size(ViewSize size) { view_size_ = size; }  // told by the viewport
  ViewSize view_size() const { return view_size_; }
  Camera shown_camera() const;
  double motion() const { return motion_; }  // how far the step has come, 0 to 1

  // ---- the window -------------------------------------------------------------------------------------------------
  Settings settings;  // changed freely; saved by and by
  Dialog dialog = Dialog::none;
  std::string tab = "tableau";  // of the tabbed panels, by id
  std::string focus;            // the panel that has the keyboard, by id; empty: none in particular
  Link focused;                 // what in it
  std::size_t curve = 0;        // which input curve the panels are about
  std::vector<std::uint32_t> open_phases;  // unfolded in the phase tree
  std::string go_to_text;
  Desk& desk() { return *desk_; }
  void save_lesson(const std::filesystem::path&, const std::string& id, const std::string& title);
  void save_picture(const std::filesystem::path&);
  void save_answers(const std::filesystem::path&);
  const Progress* progress(const std::filesystem::path&) const;

  // ---- time -------------------------------------------------------------------------------------------------------
  // Lets time pass; true if something that is seen changed. Looks at watched files and saves what is to be saved.
  bool advance(double seconds);
  bool animating() const;  // something moves: it wants frames
  void step_changed();     // begins the step's motion; called by what moves
  void keep();             // writes settings, progress and autosave now

  // Moves in the timeline, with all that follows from it.
  template <class Move>
  void move(Move&& how) {
    if (session_ && session_->move(std::forward<Move>(how))) step_changed();
  }
  void seek(std::uint32_t step);
  // An edit, with all that follows from it.
  bool edit(Edited, const std::string& what, const std::string& gesture = {});

 private:
  void remember_progress();
  void after_edit();
  void look_at_disk();
  void take_settings();

  PlayerOptions options_;
  Desk* desk_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Shelf> shelf_;
  std::uint64_t shelf_seen_ = 0;
  ProgressMap progress_;
  std::vector<Autosave> lost_;
  std::filesystem::path autosave_;
  Problems problems_;
  std::string notice_;
  double notice_left_ = 0;
  bool quit_ = false;
  std::function<void(Player&)> after_unsaved_;

  Link hovered_;
  struct Pin {
    Link link;
    std::string name;  // of its value: ids change with every recording
  };
  std::optional<Pin> pin_;
  std::optional<std::string> why_;
  mutable Emphasis emphasis_;
  struct EmphasisKey {
    std::uint64_t version = 0;
    std::uint32_t step = 0;
    Link hovered, pinned;
    std::vector<ValueId> highlights;
    bool operator==(const EmphasisKey&) const = default;
  };
  mutable std::optional<EmphasisKey> emphasis_key_;

  std::optional<Camera> camera_;
  struct Glide {
    Camera from, to;
    bool fitted_after = false;
    double t = 0;
  };
  std::optional<Glide> glide_;
  ViewSize view_size_{800, 500};
  double motion_ = 1;

  FileWatch watch_;
  double since_look_ = 0, since_keep_ = 0;
  bool to_keep_ = false;
  Settings kept_settings_;
  friend void proceed_after_unsaved(Player&);
};

// Of Dialog::unsaved: what was to be done goes on.
void proceed_after_unsaved(Player&);

}  // namespace blossom
