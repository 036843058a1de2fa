#pragma once
// The application, without a window: what is open, what is lit, where the camera is, what is asked of the person.
// Panels read it and send functions that change it; a clock calls advance().

#include <functional>

#include "player/checkpoints.hpp"
#include "player/export_job.hpp"
#include "player/grip.hpp"
#include "player/influence.hpp"
#include "player/session.hpp"
#include "player/settings.hpp"
#include "player/shelf.hpp"
#include "player/studio.hpp"
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
  save_answers,
  settings,
  shortcuts,
  palette,  // all actions by name
  go_to,    // a step or a value
  recover,  // edits that a crash left behind
  unsaved,  // before edits are lost
  save_scene,
  step_with,         // which algorithm is to run on what is chosen in the studio
  import_file,       // another program's file into the scene
  export_file,       // the scene for another program
  export_lesson,     // pictures, films, pages
  save_checkpoints,  // the answers to a lesson's questions
};

struct PlayerOptions {
  Places places;
  std::filesystem::path lessons, exercises;          // the shipped ones
  bool watch = true;                                 // files on disk
  std::filesystem::path program = "/proc/self/exe";  // that exports lessons
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
  // The same as a person does it: what is unsaved is asked about first; a curve or a surface goes into the scene that
  // one works on.
  void open_asking(const std::filesystem::path&);
  // Asks first (Dialog::unsaved) when edits, or answers to an exercise, would be lost; then does it.
  void unless_unsaved(std::function<void(Player&)> then);
  bool asks_about_scene() const { return asks_about_scene_; }  // Dialog::unsaved: otherwise about the session
  void close();                                                // to the start page
  void quit() { quit_ = true; }
  bool wants_to_quit() const { return quit_; }
  const Shelf* shelf() const { return shelf_.get(); }
  const std::vector<Autosave>& lost_work() const { return lost_; }
  void recover(std::size_t which);  // asks first when other edits would be lost
  void forget_lost(std::size_t which);

  // ---- a lesson --------------------------------------------------------------------------------------------------
  std::string title() const;  // in the language one reads
  std::string_view language() const { return settings.language; }
  std::vector<std::string> languages() const;  // of what is open, its own first; one or none: nothing to choose
  void choose_next_language();
  // Its scenes. What is edited in one of them stays while one is in another.
  std::size_t scene_count() const;
  std::size_t scene() const;
  std::string scene_heading(std::size_t) const;
  void show_scene(std::size_t);
  bool unsaved() const;          // in any of them
  bool would_be_missed() const;  // likewise, but for what only sliders moved
  // Playing stopped here because the beat says so.
  bool waits_here() const { return session_ && waiting_ == session_->step() && !session_->timeline().playing(); }
  // The sliders of the beat. An edit that is refused is kept as what is said, and nothing else changes.
  const std::vector<Slider>& sliders() const;
  std::string slider_words(const Slider&) const;  // what it moves: its label, or the input's path
  void slide(std::size_t slider, const Exact& to);
  void slide_by(std::size_t slider, int steps);
  void end_slide();
  struct Refusal {
    std::size_t slider = SIZE_MAX;
    std::string why;
  };
  const Refusal& slide_refused() const { return slide_refused_; }
  // Its questions. While one is open no step behind it is shown without asking.
  Checkpoints& checkpoints() { return checkpoints_; }
  const Checkpoints& checkpoints() const { return checkpoints_; }
  std::optional<std::size_t> checkpoint() const;  // of this step
  bool asks_to_skip() const { return session_ && skip_asked_ == session_->step() && checkpoint().has_value(); }
  bool has_all_been_said() const;  // the last step of the last scene
  void submit_checkpoint();
  bool wants_checkpoint_key(std::string_view key) const;
  void checkpoint_key(std::string_view key);
  // What a text of this step's beat says, filled in, in the language one reads; a text of prose.hpp.
  std::string beat_text(const LocalText&) const;
  void submit_checkpoint_line(int line);
  void skip_checkpoint();
  void stay_at_checkpoint();
  bool checkpoint_asks(Checkpoint::Kind) const;  // and takes an answer now
  bool checkpoint_asks_place() const;            // of which a click in the picture is the answer
  void checkpoint_click(const glm::dvec3& place);
  void save_checkpoints(const std::filesystem::path&);
  void go_to_checkpoint(std::size_t);

  // ---- exporting -------------------------------------------------------------------------------------------------
  // By another process; what is edited is what is exported. `options` are those of `blossom export`.
  void export_lesson(const std::string& format, const std::filesystem::path& out, std::vector<std::string> options);
  const ExportJob* exporting() const { return export_ ? &*export_ : nullptr; }
  void cancel_export();
  void wait_for_export();

  // ---- the studio -------------------------------------------------------------------------------------------------
  // The scene one designs, if there is one; it stays behind what is stepped from it.
  Studio* studio() { return studio_.get(); }
  const Studio* studio() const { return studio_.get(); }
  bool in_studio() const { return studio_ && !session_; }
  bool stepping_from_studio() const { return studio_ && session_; }
  void new_scene();
  void open_scene(Workspace, const std::filesystem::path& file = {});
  // Everything designed can be stepped: how the current thing was made, or else an algorithm that is asked for (see
  // Dialog::step_with), on what is chosen.
  void step_chosen();
  bool step_made(std::size_t object);
  bool step_with(const Algorithm&);
  void back_to_studio();  // asks first when edits of what was stepped would be lost
  void save_scene();      // to its file, or asks which (Dialog::save_scene)
  void save_scene(const std::filesystem::path&, const std::string& title);
  // Another program's file: its things become things of the scene. A notice says what could not be taken, or written.
  bool import_file(const std::filesystem::path&);
  bool export_file(const std::filesystem::path&, bool only_chosen);

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
  void hover(const Link& link) { hovered_ = link; }  // of this frame; none when nothing is
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
  void set_view_size(ViewSize);                 // told by the viewport
  ViewSize view_size() const { return view_size_; }
  Camera shown_camera() const;
  double motion() const { return motion_; }  // how far the step has come, 0 to 1

  // ---- what the mouse holds ---------------------------------------------------------------------------------------
  // Takes something, unless it may not be moved now (a notice says why). Places are page units of the view it is in.
  bool take(Grip);
  void drag(glm::dvec2 mouse, const GripKeys&);
  void let_go();
  // Puts it back where it was; true if something was held. The mouse then holds nothing until its button is released.
  bool put_back();
  const Grip* held() const { return held_ && !held_->over ? &held_->grip : nullptr; }
  bool holding() const { return held_.has_value(); }  // also what was put back
  glm::dvec2 held_at() const { return held_ ? held_->mouse : glm::dvec2{}; }
  GripKeys held_keys() const { return held_ ? held_->keys : GripKeys{}; }
  // The given point that has the keyboard or is pinned, and what keys do to it. In 3D a direction of the view is the
  // axis that runs most along it; a step is a tenth of the grid's.
  std::optional<PointAddress> chosen_point() const;
  void nudge(const glm::dvec3& right_up_toward);
  void add_point_behind(const PointAddress&);
  void remove_point(const PointAddress&);

  // ---- predicting -------------------------------------------------------------------------------------------------
  // The answer being typed to a question. Another question begins an empty one.
  struct Draft {
    std::size_t question = SIZE_MAX;
    std::vector<std::string> numbers;
    std::string problem;          // why it was not taken
    bool wants_keyboard = false;  // one goes on typing
  };
  const Draft& draft() const { return draft_; }
  void start_predicting();                   // what hinders becomes the problems
  std::optional<std::size_t> asked() const;  // the question one is asked: chosen, or the first open one
  void choose_question(std::size_t);         // its answer, if there is one, becomes the draft; when all is marked, the
                                             // chosen one again: none
  void choose_next_question(int by);         // by 1 or -1
  void set_draft(std::size_t number, std::string text);  // "(16, 20)" is for this number and the next
  void set_draft(std::vector<std::string> numbers);
  void keyboard_given() { draft_.wants_keyboard = false; }
  // A click on the picture is an answer while a point is asked that one does not see yet.
  bool asks_place() const;
  void predict_click(const glm::dvec3& place);
  std::optional<glm::dvec3> predicted_place;  // the last one
  // What was said of a question in numbers, typed or clicked, if that is a place.
  std::optional<glm::dvec3> said_place(std::size_t question) const;
  // Whether the value of this name is a question that nothing on the screen may answer yet.
  bool hides(std::string_view value) const;
  // Whether a value is one that is asked, or made after one that is, so that no copy of it may be had yet.
  bool veils(ValueId) const;
  bool answers_unsaved() const;
  void submit_draft();                           // the answer is given; where it is marked at once one sees the step
  void show_me();                                // the answer to the question one is asked, likewise
  std::optional<std::size_t> last_said() const;  // the question that was answered or shown last
  void take_back_answer();
  void put_back_answer();
  // Before answers are lost, or open questions are given up, one is asked.
  enum class Doubt : std::uint8_t { none, stop, finish };
  Doubt doubt() const { return session_ && session_->prediction() != nullptr ? doubt_ : Doubt::none; }
  void stop_predicting();
  void finish_predicting();
  void resolve_doubt(bool do_it);

  // ---- the window -------------------------------------------------------------------------------------------------
  Settings settings;  // changed freely; saved by and by
  Dialog dialog = Dialog::none;
  std::string tab = "tableau";             // of the tabbed panels, by id
  std::string focus;                       // the panel that has the keyboard, by id; empty: none in particular
  Link focused;                            // what in it
  std::size_t curve = 0;                   // which input curve the panels are about
  std::vector<std::uint32_t> open_phases;  // unfolded in the phase tree
  std::string go_to_text;
  void cancel_dialog();  // what it was to lead to is not done
  Desk& desk() { return *desk_; }
  void save_lesson(const std::filesystem::path&, const std::string& id, const std::string& title);
  void save_picture(const std::filesystem::path&);
  void save_answers(const std::filesystem::path&);
  const Progress* progress(const std::filesystem::path&) const;

  // ---- time -------------------------------------------------------------------------------------------------------
  // Lets time pass; true if something that is seen changed. Looks at watched files and saves what is to be saved.
  bool advance(double seconds);
  bool animating() const;  // something moves: it wants frames
  // After anything was done: what is pointed at is looked up again where the run was recorded anew.
  void settle();
  void step_changed();  // begins the step's motion; called by what moves
  void keep();          // writes settings, progress and autosave now

  // Moves in the timeline, with all that follows from it. While one predicts, not beyond an open question.
  template <class Move>
  void move(Move&& how) {
    move_as(std::forward<Move>(how), true);
  }
  void scrub(std::uint32_t step);  // by the mouse, which skips no question
  void seek(std::uint32_t step);
  void seek_value(ValueId);  // the step that makes it
  // An edit, with all that follows from it.
  bool edit(Edited, const std::string& what, const std::string& gesture = {});

 private:
  template <class Move>
  void move_as(Move&& how, bool may_skip) {
    if (!session_) return;
    const std::uint32_t before = session_->step();
    const bool moved = session_->move(std::forward<Move>(how));
    const bool kept = moved && stay_at_open_checkpoint(before, may_skip);
    if (moved && !(kept && session_->step() == before)) step_changed();
    stay_before_question();
  }
  bool stay_at_open_checkpoint(std::uint32_t before, bool may_skip);
  void follow_lesson();
  bool play_on(double seconds);
  void enter_scene();
  void go_on_where_one_was(const std::filesystem::path& file);
  ScenePlace place_in_scene(const Progress&) const;
  std::map<std::size_t, Inputs<Exact>> parked_edits() const;  // of the other scenes
  void forget_lesson();
  bool take_export_news();
  bool reload_scenes(Document);
  bool begin(Document);  // a session of it, over the studio if there is one
  bool step(const Recipe&, std::size_t before, std::string title);
  bool open_into_scene(const JsonDocument&, const std::filesystem::path&);
  void unless_session_unsaved(std::function<void(Player&)> then);
  void unless_scene_unsaved(std::function<void(Player&)> then);
  void remember_file(const std::filesystem::path&);
  void recover_scene(std::size_t which, const JsonDocument&);
  void look_at_scene_on_disk();
  void settle_studio();
  void remember_progress();
  void stay_before_question();
  void after_edit();
  void choose_point(const PointAddress&);
  void look_at_disk();
  void take_settings();

  PlayerOptions options_;
  Desk* desk_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Studio> studio_;
  std::string studio_tab_;  // while one steps
  std::uint64_t refusals_seen_ = 0, scene_kept_ = 0;
  bool asks_about_scene_ = false;
  std::unique_ptr<Shelf> shelf_;
  std::uint64_t shelf_seen_ = 0;
  ProgressMap progress_;
  std::vector<Autosave> lost_;
  std::filesystem::path autosave_, scene_autosave_;
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

  void recover_now(std::size_t which);
  void forget_what_was_about();
  std::shared_ptr<const Recording> linked_;  // whose ids hovered_ and focused are

  struct Held {
    Grip grip;
    glm::dvec2 mouse{};
    GripKeys keys;
    bool over = false;   // it was put back
    bool begun = false;  // it was moved
  };
  std::optional<Held> held_;

  void forget_questions();
  void go_on_after(std::size_t question);
  void resolve_stop();
  // The sessions of the scenes one was in before; the current one's place is empty.
  std::vector<std::unique_ptr<Session>> parked_;
  Checkpoints checkpoints_;
  std::string saved_checkpoints_;
  std::optional<std::uint32_t> skip_asked_, waiting_;
  double skip_asked_for_ = 0, stay_left_ = 0;
  Refusal slide_refused_;
  std::optional<std::uint32_t> camera_beat_;  // whose camera was glided to
  bool camera_is_lessons_ = false;            // nobody has moved it since
  std::optional<std::pair<std::uint64_t, std::uint32_t>> followed_;
  std::string tab_before_question_;
  std::optional<ExportJob> export_;

  Draft draft_;
  std::optional<std::size_t> chosen_question_, last_said_;
  Doubt doubt_ = Doubt::none;
  std::string saved_answers_;  // as they were saved last

  FileWatch watch_, scene_watch_;
  double since_look_ = 0, since_keep_ = 0;
  bool to_keep_ = false;
  Settings kept_settings_;
  friend void proceed_after_unsaved(Player&);
};

// Of Dialog::unsaved: what was to be done goes on.
void proceed_after_unsaved(Player&);

}  // namespace blossom
