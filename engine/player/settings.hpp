#pragma once
// What the player remembers: settings, where one was in each lesson, recent files; as JSON files under the XDG folders
// (XDG Base Directory Specification 0.8). A file that is damaged or from a newer version is a diagnostic, its readable
// parts count, and it is kept as FILE.bad before it is written over. Writing is atomic.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "scene/theme_list.hpp"

namespace blossom {

struct Places {
  std::filesystem::path config;  // $XDG_CONFIG_HOME/blossom, ~/.config/blossom: settings.json
  std::filesystem::path state;   // $XDG_STATE_HOME/blossom, ~/.local/state/blossom: progress.json, autosave/
};
// From the environment; a relative XDG variable is ignored, as the specification says. Without HOME: empty paths, and
// nothing is kept.
Places xdg_places();

inline constexpr std::size_t most_recent = 12;

struct Settings {
  std::string theme{theme_list.front().name};  // one of theme_list
  double text_scale = 1;                       // 0.75 to 3
  bool exact = true;                           // fractions; otherwise decimals
  bool reduced_motion = false;
  double speed = 1;  // steps a second, 0.1 to 10
  bool snap = false;
  bool grid = true;
  bool perspective = false;
  std::string language;                       // of lessons that have it: "de"; empty: their own
  double side_share = 0.4;                    // of the window's width, the panels at the right: 0.2 to 0.6
  double lower_share = 0.43;                  // of their height, the tabbed ones: 0.2 to 0.8
  int width = 1280, height = 720;             // of the window: 320 by 240 to 16384 by 16384
  std::vector<std::filesystem::path> recent;  // newest first, each once, most_recent at most
  bool operator==(const Settings&) const = default;
};

// Values outside their bounds are brought back to them.
Settings sane(Settings);
// Keys that are not known are passed over: an older version reads what a newer one wrote. Without a file: the defaults.
Settings load_settings(const Places&, Diagnostics&);
// True: kept; false: there is no place to keep it. Folders that are missing are made, for the user alone.
Checked<bool> save_settings(const Places&, const Settings&);

// Where one was in one run.
struct ScenePlace {
  std::uint32_t step = 0, last = 0;  // where one was, of how many
  std::uint32_t furthest = 0;
  std::vector<std::uint32_t> bookmarks;
  bool operator==(const ScenePlace&) const = default;
};

// Where one was, by the file's path (absolute). Of a lesson of several scenes `scene` is the one where one was, and the
// place in it; the places in the others, and in it, are in `scenes`, by their ids.
struct Progress : ScenePlace {
  std::string scene;
  std::map<std::string, ScenePlace> scenes;
  std::uint32_t scene_count = 0;               // of the lesson; 0: it has only one
  std::map<std::string, std::string> answers;  // to checkpoints, by id, as an answers file has them
  std::vector<std::string> skipped;            // checkpoints
  std::uint32_t asked = 0, right = 0;          // checkpoints of the lesson, and those answered right
  double best_score = -1;                      // of predictions, 0 to 1; below 0: none yet
  std::int64_t seen = 0;  // when it was saved, in ms since 1970; 0: it is new, and saving it says when
  bool operator==(const Progress&) const = default;

  double share() const;  // how much was seen, 0 to 1
};
using ProgressMap = std::map<std::string, Progress>;
ProgressMap load_progress(const Places&, Diagnostics&);
// Another player may have saved meanwhile: of what both know the later seen is kept, and what only the file knows
// stays. The most_progress seen last are kept.
inline constexpr std::size_t most_progress = 500;
Checked<bool> save_progress(const Places&, const ProgressMap&);

// Unsaved edits survive a crash: one file for each open document of a running player, autosave/<pid>-<n>.json, removed
// when it ends well. In it are the document as the file of a lesson, and where it came from.
struct Autosave {
  std::filesystem::path file;    // of the autosave itself
  std::filesystem::path origin;  // what was open; may be empty
  std::string title;
  std::string content;  // the document
  std::uint32_t step = 0;
};
inline constexpr std::size_t most_autosave_bytes = 16u << 20;  // of the whole file
// A name for this process to write to, another one at each call; empty without a place.
std::filesystem::path autosave_file(const Places&);
Checked<bool> write_autosave(const Places&, const Autosave&);  // `file` names it
// Those whose process is gone, newest first, 20 at most. What cannot be read is passed over, and stays where it is.
std::vector<Autosave> lost_work(const Places&);
void discard(const Autosave&);  // removes its file

}  // namespace blossom
