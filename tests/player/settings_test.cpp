#include "player/settings.hpp"

#include <limits>

#include "player/environment.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Environment;
using blossom::test::Scratch;
namespace fs = std::filesystem;

namespace {

Places places_in(const Scratch& scratch) { return {scratch / "config", scratch / "state"}; }

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path write(const fs::path& file, const std::string& content) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

fs::perms mode_of(const fs::path& path) { return fs::status(path).permissions() & fs::perms::mask; }

Progress at_step(std::uint32_t step) {
  Progress progress;
  progress.step = step;
  return progress;
}

constexpr fs::perms only_the_user = fs::perms::owner_read | fs::perms::owner_write;

}  // namespace

// ---- places ---------------------------------------------------------------------------------------------------------

TEST_CASE("settings and state are where the XDG specification says") {
  const Environment home("HOME", "/home/ada"), config("XDG_CONFIG_HOME", std::nullopt),
      state("XDG_STATE_HOME", std::nullopt);
  CHECK(xdg_places().config == "/home/ada/.config/blossom");
  CHECK(xdg_places().state == "/home/ada/.local/state/blossom");
  const Environment elsewhere("XDG_CONFIG_HOME", "/etc/ada"), there("XDG_STATE_HOME", "/var/ada");
  CHECK(xdg_places().config == "/etc/ada/blossom");
  CHECK(xdg_places().state == "/var/ada/blossom");
}

TEST_CASE("a relative or empty XDG variable counts as none") {
  const Environment home("HOME", "/home/ada"), config("XDG_CONFIG_HOME", "here"), state("XDG_STATE_HOME", "");
  CHECK(xdg_places().config == "/home/ada/.config/blossom");
  CHECK(xdg_places().state == "/home/ada/.local/state/blossom");
}

TEST_CASE("without a home nothing is kept, and that is no mistake") {
  const Environment home("HOME", std::nullopt), config("XDG_CONFIG_HOME", std::nullopt),
      state("XDG_STATE_HOME", std::nullopt);
  const Places places = xdg_places();
  CHECK(places.config.empty());
  CHECK(places.state.empty());
  Diagnostics wrong;
  CHECK(load_settings(places, wrong) == Settings());
  CHECK(load_progress(places, wrong).empty());
  CHECK(wrong.empty());
  for (const auto& saved : {save_settings(places, {}), save_progress(places, {{"/a", {}}}),
                            write_autosave(places, {autosave_file(places), "", "", "", 0})}) {
    REQUIRE(saved);
    CHECK_FALSE(*saved);
  }
  CHECK(autosave_file(places).empty());
  CHECK(lost_work(places).empty());
}

// ---- settings -------------------------------------------------------------------------------------------------------

TEST_CASE("settings that are saved are those that are loaded") {
  const Scratch scratch;
  Settings settings;
  settings.theme = "contrast";
  settings.text_scale = 1.1;  // no dyadic number: the text must give the same double
  settings.exact = false;
  settings.reduced_motion = true;
  settings.speed = 0.1;
  settings.snap = true;
  settings.grid = false;
  settings.perspective = true;
  settings.side_share = 1.0 / 3;
  settings.lower_share = 0.7;
  settings.width = 1920;
  settings.height = 1080;
  settings.recent = {"/tmp/a \"quoted\" name.json", "/tmp/K\xC3\xBCrbis\n.json"};
  REQUIRE(save_settings(places_in(scratch), settings));
  Diagnostics wrong;
  CHECK(load_settings(places_in(scratch), wrong) == settings);
  CHECK(to_string(wrong).empty());
}

TEST_CASE("without a file there are the defaults") {
  const Scratch scratch;
  Diagnostics wrong;
  CHECK(load_settings(places_in(scratch), wrong) == Settings());
  CHECK(wrong.empty());
  CHECK(scratch.count() == 0);
}

TEST_CASE("what is kept is for the user alone") {
  const Scratch scratch;
  const Places places{scratch / "a/b/blossom", scratch / "c"};
  REQUIRE(save_settings(places, {}));
  CHECK(mode_of(places.config / "settings.json") == only_the_user);
  CHECK(mode_of(places.config) == fs::perms::owner_all);
  CHECK(mode_of(scratch / "a") == fs::perms::owner_all);
  REQUIRE(save_progress(places, {{"/a", {}}}));
  CHECK(mode_of(places.state / "progress.json") == only_the_user);
  const Autosave work{autosave_file(places), "", "", "", 0};
  REQUIRE(write_autosave(places, work));
  CHECK(mode_of(work.file) == only_the_user);
}

TEST_CASE("settings out of their bounds are brought back to them") {
  Settings settings;
  settings.theme = "puce";
  settings.text_scale = 9;
  settings.speed = 0;
  settings.side_share = -1;
  settings.lower_share = std::numeric_limits<double>::quiet_NaN();
  settings.width = 1;
  settings.height = 1'000'000;
  settings.recent = {"/a", "/b", "/a", ""};
  for (int i = 0; i < 20; ++i) settings.recent.emplace_back("/more" + std::to_string(i));
  const Settings bounded = sane(settings);
  CHECK(bounded.theme == "light");
  CHECK(bounded.text_scale == 3);
  CHECK(bounded.speed == 0.1);
  CHECK(bounded.side_share == 0.2);
  CHECK(bounded.lower_share == 0.2);
  CHECK(bounded.width == 320);
  CHECK(bounded.height == 16384);
  REQUIRE(bounded.recent.size() == most_recent);
  CHECK(bounded.recent[0] == "/a");
  CHECK(bounded.recent[1] == "/b");
  CHECK(bounded.recent[2] == "/more0");
  CHECK(sane(bounded) == bounded);
  CHECK(sane(Settings()) == Settings());
}

TEST_CASE("each wrong setting is named, and the others count") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const fs::path file = write(places.config / "settings.json", R"({"schema": "blossom.settings/1",
"theme": "dork", "text_scale": 5, "exact": "no", "speed": "3/2",
"width": 2.5, "height": 900, "recent": ["/a", 7, "/b"]})");
  Diagnostics wrong;
  const Settings settings = load_settings(places, wrong);
  const std::string at = file.string();
  CHECK(to_string(wrong) == at + R"(:2:10: theme: no theme is called "dork"; did you mean "dark"?
)" + at + R"(:2:32: text_scale: must be from 0.75 to 3; taken as 3
)" + at + R"(:2:44: exact: must be true or false, not "no"
)" + at + R"(:3:10: width: must be a whole number from 320 to 16384, not 2.5
)" + at + R"(:3:47: recent[1]: must be the path of a file
)");
  Settings expected;
  expected.text_scale = 3;
  expected.speed = 1.5;
  expected.height = 900;
  expected.recent = {"/a", "/b"};
  CHECK(settings == expected);
}

TEST_CASE("settings of a later version with more keys are read without a word") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  write(places.config / "settings.json",
        R"({"schema": "blossom.settings/1", "theme": "dark", "sound": {"volume": 11}})");
  Diagnostics wrong;
  CHECK(load_settings(places, wrong).theme == "dark");
  CHECK(to_string(wrong).empty());
}

TEST_CASE("a damaged file is kept beside the one that replaces it") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const std::string damage = GENERATE("{\"schema\": \"blossom.settings/1\", \"theme\": \"da", "", "[]",
                                      "{\"schema\": \"blossom.settings/2\", \"theme\": \"dark\"}",
                                      "{\"schema\": \"blossom.settings/1\", \"speed\": \"fast\"}");
  const fs::path file = write(places.config / "settings.json", damage);
  Diagnostics wrong;
  load_settings(places, wrong);
  CHECK(wrong.size() == 1);
  CHECK(bytes_of(file) == damage);  // reading changes nothing

  Settings settings;
  settings.theme = "contrast";
  REQUIRE(save_settings(places, settings));
  CHECK(bytes_of(file.string() + ".bad") == damage);
  CHECK(mode_of(file) == only_the_user);
  Diagnostics none;
  CHECK(load_settings(places, none) == settings);
  CHECK(none.empty());

  settings.theme = "dark";
  REQUIRE(save_settings(places, settings));
  CHECK(bytes_of(file.string() + ".bad") == damage);  // what is sound does not go there
}

TEST_CASE("a file that cannot be put aside is not written over") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const fs::path file = write(places.config / "settings.json", "damaged");
  write(places.config / "settings.json.bad" / "full", "");
  const auto saved = save_settings(places, {});
  REQUIRE_FALSE(saved);
  CHECK(to_string(saved.diagnostics).find("cannot be renamed") != std::string::npos);
  CHECK(bytes_of(file) == "damaged");
}

TEST_CASE("where no folder can be made, saving says why") {
  const Scratch scratch;
  scratch.write("config", "a file where the folder should be");
  const auto saved = save_settings(places_in(scratch), {});
  REQUIRE_FALSE(saved);
  CHECK(saved.diagnostics.size() == 1);
}

Progress seen(ScenePlace place, double best_score, std::int64_t when) {
  Progress progress;
  static_cast<ScenePlace&>(progress) = std::move(place);
  progress.best_score = best_score;
  progress.seen = when;
  return progress;
}

// ---- progress -------------------------------------------------------------------------------------------------------

TEST_CASE("of a lesson the scenes and the answers are remembered, too, and what is damaged of them is passed over") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  Progress progress = seen({3, 7, 5, {1, 4}}, -1, 0);
  progress.scene = "second";
  progress.scenes = {{"first", {9, 9, 9, {}}}, {"second", progress}};
  progress.scene_count = 4;
  progress.answers = {{"why", "\"b\""}, {"where", "[\"1/3\", 2]"}};
  progress.skipped = {"order"};
  progress.asked = 5;
  progress.right = 1;
  CHECK(progress.share() == Approx((1.0 + 5.0 / 7) / 4));
  REQUIRE(save_progress(places, {{"/a", progress}}));
  Diagnostics wrong;
  ProgressMap loaded = load_progress(places, wrong);
  CHECK(to_string(wrong).empty());
  loaded["/a"].seen = 0;
  CHECK(loaded == ProgressMap{{"/a", progress}});

  write(places.state / "progress.json", R"({"schema": "blossom.progress/1", "files": {"/a":
    {"step": 1, "scenes": {"x": 5, "y": {"step": 2}}, "answers": [], "skipped": [7, "z"], "right": -1}}})");
  const ProgressMap damaged = load_progress(places, wrong);
  CHECK_FALSE(wrong.empty());
  CHECK(damaged.at("/a").scenes == std::map<std::string, ScenePlace>{{"y", {2, 0, 0, {}}}});
  CHECK(damaged.at("/a").skipped == std::vector<std::string>{"z"});
  CHECK(damaged.at("/a").right == 0);
}

TEST_CASE("a language is remembered as lessons name it, or not at all") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  Settings settings;
  settings.language = "de";
  REQUIRE(save_settings(places, settings));
  Diagnostics wrong;
  CHECK(load_settings(places, wrong).language == "de");
  CHECK(wrong.empty());
  settings.language = "Deutsch";
  CHECK(sane(settings).language.empty());
  write(places.config / "settings.json", R"({"schema": "blossom.settings/1", "language": "EN_us"})");
  CHECK(load_settings(places, wrong).language.empty());
  CHECK(wrong.size() == 1);
}

TEST_CASE("progress that is saved is what is loaded, with the time it was saved at") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const ProgressMap saved{{"/lessons/a.json", seen({3, 7, 5, {1, 4}}, 0.75, 0)},
                          {"/lessons/\"b\".json", seen({0, 12, 0, {}}, -1, 0)}};
  REQUIRE(save_progress(places, saved));
  Diagnostics wrong;
  ProgressMap loaded = load_progress(places, wrong);
  CHECK(to_string(wrong).empty());
  for (auto& [file, progress] : loaded) {
    CHECK(progress.seen > 0);
    progress.seen = 0;
  }
  CHECK(loaded == saved);
}

TEST_CASE("two players that run at once keep both what they know") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  Diagnostics wrong;
  REQUIRE(save_progress(places, {{"/a", at_step(1)}, {"/b", at_step(1)}}));
  ProgressMap first = load_progress(places, wrong), second = load_progress(places, wrong);
  first["/a"] = at_step(5);
  REQUIRE(save_progress(places, first));
  second["/b"] = at_step(6);
  second["/c"] = at_step(7);
  REQUIRE(save_progress(places, second));
  const ProgressMap both = load_progress(places, wrong);
  CHECK(both.at("/a").step == 5);
  CHECK(both.at("/b").step == 6);
  CHECK(both.at("/c").step == 7);
  CHECK(wrong.empty());
}

TEST_CASE("of very many files those seen last are remembered") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  ProgressMap map;
  for (int i = 0; i < 700; ++i) map["/" + std::to_string(i)].seen = 1 + (i * 263) % 700;  // 263 and 700 have no divisor
  map["/new"].step = 4;
  REQUIRE(save_progress(places, map));
  Diagnostics wrong;
  const ProgressMap kept = load_progress(places, wrong);
  CHECK(kept.size() == most_progress);
  CHECK(kept.at("/new").step == 4);
  for (const auto& [file, progress] : kept) CHECK(progress.seen > 201);
}

TEST_CASE("what is wrong in the progress is named, the rest counts, and the file is put aside") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const std::string text = R"({"schema": "blossom.progress/1", "files": {
"/a": {"step": 2, "last": 9, "furthest": -1, "bookmarks": [1, "x", 3], "best_score": 2, "seen": 5},
"/b": 7,
"/c": {"step": 4}}})";
  const fs::path file = write(places.state / "progress.json", text);
  Diagnostics wrong;
  const ProgressMap map = load_progress(places, wrong);
  CHECK(wrong.size() == 4);
  CHECK(map == ProgressMap{{"/a", seen({2, 9, 0, {1, 3}}, -1, 5)}, {"/c", seen({4, 0, 0, {}}, -1, 0)}});
  REQUIRE(save_progress(places, {{"/d", at_step(1)}}));
  CHECK(bytes_of(file.string() + ".bad") == text);
  Diagnostics none;
  CHECK(load_progress(places, none).size() == 3);
  CHECK(none.empty());
}
