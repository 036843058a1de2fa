#include "player/settings.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/json_write.hpp"
#include "base/scalar.hpp"
#include "base/utf8.hpp"
#include "lesson/document.hpp"
#include "player/kept_file.hpp"

namespace blossom {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view settings_schema = "blossom.settings/1", progress_schema = "blossom.progress/1";
constexpr JsonLimits settings_limits{1u << 20, 8, 10'000}, progress_limits{4u << 20, 8, 200'000};
constexpr int most_steps = std::numeric_limits<int>::max();

// ---- places ---------------------------------------------------------------------------------------------------------

// "All paths set in these environment variables must be absolute. If an implementation encounters a relative path [...]
// it should consider the path invalid and ignore it."
fs::path absolute_from(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path path = value != nullptr ? value : "";
  return path.is_absolute() ? path : fs::path();
}

fs::path xdg_folder(const char* variable, const char* below_home) {
  if (const fs::path given = absolute_from(variable); !given.empty()) return given / "blossom";
  const fs::path home = absolute_from("HOME");
  return home.empty() ? home : home / below_home / "blossom";
}

fs::path settings_file(const Places& places) {
  return places.config.empty() ? fs::path() : places.config / "settings.json";
}
fs::path progress_file(const Places& places) {
  return places.state.empty() ? fs::path() : places.state / "progress.json";
}

// ---- settings -------------------------------------------------------------------------------------------------------

// The one list of what is kept of the settings, with the bounds of each.
template <class S, class Visitor>
void visit(S& settings, Visitor&& visitor) {
  visitor.theme("theme", settings.theme);
  visitor.number("text_scale", settings.text_scale, 0.75, 3.0);
  visitor.flag("exact", settings.exact);
  visitor.flag("reduced_motion", settings.reduced_motion);
  visitor.number("speed", settings.speed, 0.1, 10.0);
  visitor.flag("snap", settings.snap);
  visitor.flag("grid", settings.grid);
  visitor.flag("perspective", settings.perspective);
  visitor.language("language", settings.language);
  visitor.number("side_share", settings.side_share, 0.2, 0.6);
  visitor.number("lower_share", settings.lower_share, 0.2, 0.8);
  visitor.number("width", settings.width, 320, 16384);
  visitor.number("height", settings.height, 240, 16384);
  visitor.files("recent", settings.recent);
}

bool is_known_theme(std::string_view name) {
  return std::ranges::find(theme_list, name, &ThemeName::name) != theme_list.end();
}

// As lessons name them; empty: their own.
bool is_language(std::string_view name) {
  return name.size() <= 3 && std::ranges::all_of(name, [](char c) { return 'a' <= c && c <= 'z'; });
}

struct Bounding {
  static void theme(const char*, std::string& name) {
    if (!is_known_theme(name)) name = theme_list.front().name;
  }
  static void flag(const char*, bool&) {}
  static void language(const char*, std::string& name) {
    if (!is_language(name)) name.clear();
  }
  template <class T>
  static void number(const char*, T& value, T at_least, T at_most) {
    if (!(value >= at_least)) value = at_least;  // and what is not a number
    if (value > at_most) value = at_most;
  }
  static void files(const char*, std::vector<fs::path>& files) {
    std::vector<fs::path> kept;
    for (fs::path& file : files)
      if (!file.empty() && kept.size() < most_recent && std::ranges::find(kept, file) == kept.end())
        kept.push_back(std::move(file));
    files = std::move(kept);
  }
};

// A name that is no UTF-8 cannot stand in a JSON file as it is.
bool is_writable_name(const std::string& name) {
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length = utf8_length(name, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

struct Writing {
  std::string text = "{\n  \"schema\": " + json_quote(settings_schema);

  void add(const char* key, const std::string& value) { text += ",\n  " + json_quote(key) + ": " + value; }
  void theme(const char* key, const std::string& name) { add(key, json_quote(name)); }
  void flag(const char* key, bool value) { add(key, value ? "true" : "false"); }
  void language(const char* key, const std::string& name) {
    if (!name.empty()) add(key, json_quote(name));
  }
  void number(const char* key, double value, double, double) { add(key, format_number(value)); }
  void number(const char* key, int value, int, int) { add(key, std::to_string(value)); }
  void files(const char* key, const std::vector<fs::path>& files) {
    std::string list;
    for (const fs::path& file : files)
      if (is_writable_name(file.string())) list += (list.empty() ? "\n    " : ",\n    ") + json_quote(file.string());
    add(key, list.empty() ? "[]" : "[" + list + "\n  ]");
  }
};

// What is missing keeps its default, silently; what is wrong keeps it, with a diagnostic.
struct Reading {
  const Cursor& root;

  void theme(const char* key, std::string& name) const {
    const auto at = root.optional(key);
    const auto text = at ? at->string() : std::nullopt;
    if (!text) return;
    if (is_known_theme(*text)) {
      name = *text;
      return;
    }
    std::vector<std::string> names;
    for (const ThemeName& known : theme_list) names.emplace_back(known.name);
    const auto near = did_you_mean(*text, names);
    at->error("no theme is called " + excerpt(*text) +
              (near ? "; did you mean " + excerpt(*near) + "?" : "; there are light, dark and contrast"));
  }
  void flag(const char* key, bool& value) const {
    if (const auto at = root.optional(key)) value = at->boolean().value_or(value);
  }
  void language(const char* key, std::string& name) const {
    const auto at = root.optional(key);
    const auto text = at ? at->string() : std::nullopt;
    if (text && is_language(*text))
      name = *text;
    else if (text)
      at->error("must be a language such as \"de\", not " + excerpt(*text));
  }
  void number(const char* key, double& value, double at_least, double at_most) const {
    const auto at = root.optional(key);
    const auto number = at ? at->number() : std::nullopt;
    if (!number) return;
    value = std::clamp(number->to_double(), at_least, at_most);
    if (value != number->to_double())
      at->error("must be from " + format_number(at_least) + " to " + format_number(at_most) + "; taken as " +
                format_number(value));
  }
  void number(const char* key, int& value, int at_least, int at_most) const {
    if (const auto at = root.optional(key)) value = at->integer(at_least, at_most).value_or(value);
  }
  // A path is not a text for people: it may have any characters but the one that ends it for the system.
  void files(const char* key, std::vector<fs::path>& files) const {
    const auto at = root.optional(key);
    if (!at || !at->expect_array()) return;
    for (std::size_t i = 0; i < at->size(); ++i) {
      const Json& json = (*at)[i].json();
      if (json.kind != Json::Kind::string || json.text.empty() || json.text.find('\0') != std::string::npos)
        (*at)[i].error("must be the path of a file");
      else
        files.emplace_back(json.text);
    }
  }
};

// ---- progress -------------------------------------------------------------------------------------------------------

ScenePlace read_place(const Cursor& at) {
  ScenePlace progress;
  const auto steps = [&](const char* key, std::uint32_t& value) {
    if (const auto here = at.optional(key))
      value = static_cast<std::uint32_t>(here->integer(0, most_steps).value_or(static_cast<int>(value)));
  };
  steps("step", progress.step);
  steps("last", progress.last);
  steps("furthest", progress.furthest);
  if (const auto here = at.optional("bookmarks"); here && here->expect_array())
    for (std::size_t i = 0; i < here->size(); ++i)
      if (const auto step = (*here)[i].integer(0, most_steps))
        progress.bookmarks.push_back(static_cast<std::uint32_t>(*step));
  return progress;
}

// What a lesson of several scenes, or with questions, has besides.
void read_lesson_progress(const Cursor& at, Progress& progress) {
  const auto count = [&](const char* key, std::uint32_t& value) {
    if (const auto here = at.optional(key))
      value = static_cast<std::uint32_t>(here->integer(0, most_steps).value_or(static_cast<int>(value)));
  };
  if (const auto here = at.optional("scene")) progress.scene = here->string().value_or("");
  if (const auto here = at.optional("scenes"); here && here->is(Json::Kind::object))
    for (std::size_t i = 0; i < here->size(); ++i)
      if (here->member(i).is(Json::Kind::object)) progress.scenes[here->json().keys[i]] = read_place(here->member(i));
  if (const auto here = at.optional("answers"); here && here->is(Json::Kind::object))
    for (std::size_t i = 0; i < here->size(); ++i)
      progress.answers[here->json().keys[i]] = write_json(here->member(i).json());
  if (const auto here = at.optional("skipped"); here && here->expect_array())
    for (std::size_t i = 0; i < here->size(); ++i)
      if (auto id = (*here)[i].string()) progress.skipped.push_back(*std::move(id));
  count("scene_count", progress.scene_count);
  count("asked", progress.asked);
  count("right", progress.right);
}

Progress read_progress(const Cursor& at) {
  Progress progress;
  static_cast<ScenePlace&>(progress) = read_place(at);
  read_lesson_progress(at, progress);
  if (const auto here = at.optional("best_score"))
    if (const auto score = here->number()) {
      if (*score < 0 || 1 < *score)
        here->error("must be from 0 to 1, not " + score->to_string());
      else
        progress.best_score = score->to_double();
    }
  if (const auto here = at.optional("seen"))
    if (const auto time = here->number()) {
      // A double holds every millisecond of the next 285,000 years.
      constexpr double latest = 9007199254740992.0;
      progress.seen = static_cast<std::int64_t>(std::clamp(time->to_double(), 0.0, latest));
    }
  return progress;
}

std::string place_text(const ScenePlace& place) {
  std::string bookmarks;
  for (const std::uint32_t step : place.bookmarks) bookmarks += (bookmarks.empty() ? "" : ", ") + std::to_string(step);
  std::string text = "\"step\": " + std::to_string(place.step) + ", \"last\": " + std::to_string(place.last) +
                     ", \"furthest\": " + std::to_string(place.furthest);
  if (!bookmarks.empty()) text += ", \"bookmarks\": [" + bookmarks + "]";
  return text;
}

std::string lesson_progress_text(const Progress& progress) {
  std::string text;
  const auto list = [&](const char* key, const auto& items, const char* brackets, auto&& write) {
    if (items.empty()) return;
    std::string all;
    for (const auto& item : items) all += (all.empty() ? "" : ", ") + write(item);
    text += std::string(", \"") + key + "\": " + brackets[0] + all + brackets[1];
  };
  if (!progress.scene.empty()) text += ", \"scene\": " + json_quote(progress.scene);
  list("scenes", progress.scenes, "{}",
       [](const auto& scene) { return json_quote(scene.first) + ": {" + place_text(scene.second) + "}"; });
  if (progress.scene_count > 0) text += ", \"scene_count\": " + std::to_string(progress.scene_count);
  list("answers", progress.answers, "{}",
       [](const auto& answer) { return json_quote(answer.first) + ": " + answer.second; });
  list("skipped", progress.skipped, "[]", [](const std::string& id) { return json_quote(id); });
  if (progress.asked > 0)
    text += ", \"asked\": " + std::to_string(progress.asked) + ", \"right\": " + std::to_string(progress.right);
  return text;
}

std::string entry_text(const std::string& file, const Progress& progress) {
  std::string text = "    " + json_quote(file) + ": {" + place_text(progress) + lesson_progress_text(progress);
  if (progress.best_score >= 0) text += ", \"best_score\": " + format_number(std::min(progress.best_score, 1.0));
  return text + ", \"seen\": " + std::to_string(progress.seen) + "}";
}

// What is in the file and what this player knows, as one. New entries are seen now, and after all that are in the file,
// whatever the clock says.
ProgressMap merged(ProgressMap kept, const ProgressMap& ours) {
  using namespace std::chrono;
  std::int64_t now = duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
  for (const auto& [file, progress] : kept) now = std::max(now, progress.seen + 1);
  for (const auto& [file, progress] : ours) {
    if (!is_writable_name(file)) continue;
    const auto other = kept.find(file);
    if (progress.seen != 0 && other != kept.end() && other->second.seen > progress.seen) continue;
    Progress& entry = kept[file] = progress;
    if (entry.seen == 0) entry.seen = now;
  }
  return kept;
}

void forget_oldest(ProgressMap& map) {
  if (map.size() <= most_progress) return;
  std::vector<std::pair<std::int64_t, std::string>> by_time;
  for (const auto& [file, progress] : map) by_time.emplace_back(progress.seen, file);
  std::ranges::sort(by_time, std::greater());
  for (std::size_t i = most_progress; i < by_time.size(); ++i) map.erase(by_time[i].second);
}

}  // namespace

double Progress::share() const {
  const auto share_of = [](const ScenePlace& place) {
    return place.last > 0 ? std::min(1.0, static_cast<double>(place.furthest) / place.last) : 0.0;
  };
  if (scene_count == 0) return share_of(*this);
  double all = 0;
  for (const auto& [id, place] : scenes) all += share_of(place);
  return std::min(1.0, all / scene_count);
}

Places xdg_places() { return {xdg_folder("XDG_CONFIG_HOME", ".config"), xdg_folder("XDG_STATE_HOME", ".local/state")}; }

Settings sane(Settings settings) {
  visit(settings, Bounding());
  return settings;
}

Settings load_settings(const Places& places, Diagnostics& diagnostics) {
  Settings settings;
  const auto document = read_kept(settings_file(places), settings_limits, diagnostics);
  if (!document) return settings;
  const Cursor root(*document, diagnostics);
  if (!root.is(Json::Kind::object)) {
    root.error("must be an object with the settings");
    return settings;
  }
  expect_schema(root, settings_schema);
  visit(settings, Reading{root});
  return sane(std::move(settings));
}

Checked<bool> save_settings(const Places& places, const Settings& settings) {
  Diagnostics wrong;
  load_settings(places, wrong);
  Writing writing;
  const Settings kept = sane(settings);
  visit(kept, writing);
  return write_kept(settings_file(places), writing.text + "\n}\n", !wrong.empty());
}

ProgressMap load_progress(const Places& places, Diagnostics& diagnostics) {
  ProgressMap map;
  const auto document = read_kept(progress_file(places), progress_limits, diagnostics);
  if (!document) return map;
  const Cursor root(*document, diagnostics);
  if (!root.is(Json::Kind::object)) {
    root.error("must be an object with the places one was at");
    return map;
  }
  expect_schema(root, progress_schema);
  const auto files = root.required("files");
  if (!files) return map;
  if (!files->is(Json::Kind::object)) {
    files->error("must be an object with a key for each file");
    return map;
  }
  for (std::size_t i = 0; i < files->size(); ++i) {
    if (files->member(i).is(Json::Kind::object))
      map[files->json().keys[i]] = read_progress(files->member(i));
    else
      files->member(i).error("must be an object that says where one was");
  }
  forget_oldest(map);
  return map;
}

Checked<bool> save_progress(const Places& places, const ProgressMap& ours) {
  Diagnostics wrong;
  ProgressMap map = merged(load_progress(places, wrong), ours);
  forget_oldest(map);
  std::string text = "{\n  \"schema\": " + json_quote(progress_schema) + ",\n  \"files\": {\n";
  for (const auto& [file, progress] : map)
    text += (file == map.begin()->first ? "" : ",\n") + entry_text(file, progress);
  return write_kept(progress_file(places), text + "\n  }\n}\n", !wrong.empty());
}

}  // namespace blossom
