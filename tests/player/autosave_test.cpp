#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "player/settings.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;
namespace fs = std::filesystem;

namespace {

Places places_in(const Scratch& scratch) { return {scratch / "config", scratch / "state"}; }

// Another process writes this and ends without removing it. Its file.
fs::path crash_with(const Places& places, const std::string& title, const std::string& content = "{}") {
  int names[2];
  REQUIRE(pipe(names) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const std::string file = autosave_file(places).string();
    const bool written = write(names[1], file.data(), file.size()) == static_cast<ssize_t>(file.size());
    _exit(written && write_autosave(places, {file, "/origin of " + title, title, content, 7}) ? 0 : 1);
  }
  close(names[1]);
  char name[4096];
  const ssize_t length = read(names[0], name, sizeof name);
  close(names[0]);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE((length > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0));
  return std::string(name, static_cast<std::size_t>(length));
}

void set_age(const fs::path& file, int minutes) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::minutes(minutes));
}

std::vector<std::string> titles(const std::vector<Autosave>& works) {
  std::vector<std::string> found;
  for (const Autosave& work : works) found.push_back(work.title);
  return found;
}

// The id of a process that is gone.
pid_t dead_pid() {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(0);
  REQUIRE(waitpid(child, nullptr, 0) == child);
  return child;
}

std::string autosave_text(const std::string& title, const std::string& started) {
  return R"({"schema": "blossom.autosave/1", "started": ")" + started + R"(", "origin": "", "title": ")" + title +
         R"(", "step": 0, "content": "{}"})";
}

}  // namespace

TEST_CASE("what a crash left behind is found as it was") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const std::string content = "{\"title\": \"K\xC3\xBCrbis \\\"x\\\"\",\r\n\t\"id\": \"\\u0007\"}\n";
  const fs::path file = crash_with(places, "de Boor", content);
  const auto lost = lost_work(places);
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].file == file);
  CHECK(lost[0].origin == "/origin of de Boor");
  CHECK(lost[0].title == "de Boor");
  CHECK(lost[0].content == content);
  CHECK(lost[0].step == 7);
  discard(lost[0]);
  CHECK_FALSE(fs::exists(file));
  CHECK(lost_work(places).empty());
}

TEST_CASE("the work of a running player is not lost") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  Autosave mine{autosave_file(places), "", "mine", "{}", 0};
  REQUIRE(write_autosave(places, mine));
  mine.content = "{} ";
  REQUIRE(write_autosave(places, mine));  // again and again
  CHECK(lost_work(places).empty());
  CHECK(fs::exists(mine.file));
}

TEST_CASE("each call names another file, and none that an earlier process of this number left") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const fs::path first = autosave_file(places);
  CHECK(first.parent_path() == places.state / "autosave");
  const std::string name = first.filename().string(), own = std::to_string(getpid()) + "-";
  REQUIRE(name.starts_with(own));
  const int next = std::stoi(name.substr(own.size())) + 1;
  fs::create_directories(places.state / "autosave");
  scratch.write("state/autosave/" + own + std::to_string(next) + ".json", "of an earlier process");
  CHECK(autosave_file(places).filename() == own + std::to_string(next + 1) + ".json");
}

TEST_CASE("a process that has the number of the lost one today is not taken for it") {
  if (!fs::exists("/proc/self/stat")) return;  // the system does not say when a process began
  const Scratch scratch;
  const Places places = places_in(scratch);
  fs::create_directories(places.state / "autosave");
  const std::string file = "state/autosave/" + std::to_string(getpid()) + "-9999.json";
  scratch.write(file, autosave_text("of an earlier boot", "00000000-0000-0000-0000-000000000000 12"));
  CHECK(titles(lost_work(places)) == std::vector<std::string>{"of an earlier boot"});
  // Where it was not said, the number must do.
  scratch.write(file, autosave_text("unknown", ""));
  CHECK(lost_work(places).empty());
}

TEST_CASE("lost work is offered newest first, and not without end") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  set_age(crash_with(places, "old"), 30);
  set_age(crash_with(places, "new"), 10);
  set_age(crash_with(places, "older"), 50);
  CHECK(titles(lost_work(places)) == std::vector<std::string>{"new", "old", "older"});
  const std::string pid = std::to_string(dead_pid());
  for (int i = 0; i < 30; ++i)
    scratch.write("state/autosave/" + pid + "-" + std::to_string(i) + ".json", autosave_text("more", ""));
  const auto lost = lost_work(places);
  CHECK(lost.size() == 20);
  CHECK(lost.back().title == "more");
}

TEST_CASE("what is no autosave is passed over and stays") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  fs::create_directories(places.state / "autosave" / "7-7.json");
  const std::string pid = std::to_string(dead_pid()), folder = "state/autosave/";
  scratch.write(folder + pid + "-0.json", "{\"schema\": \"blossom.auto");                        // cut off
  scratch.write(folder + pid + "-1.json", R"({"schema": "blossom.autosave/1", "title": "x"})");  // half of it
  scratch.write(folder + pid + "-2.json", std::string(most_autosave_bytes + 1, ' '));            // too large
  for (const char* name : {"-1-0.json", "0-0.json", "1x-0.json", "99999999999-0.json", "12.json", "-.json", "12-.json"})
    scratch.write(folder + name, autosave_text("of no process", ""));
  scratch.write(folder + pid + "-3.json.bad", autosave_text("put aside", ""));
  scratch.write("elsewhere.json", autosave_text("behind a link", ""));
  fs::create_symlink(scratch / "elsewhere.json", scratch / (folder + pid + "-4.json"));
  const auto count = [&] { return std::distance(fs::directory_iterator(scratch / folder), fs::directory_iterator()); };
  const auto before = count();
  CHECK(titles(lost_work(places)).empty());
  CHECK(count() == before);
}

TEST_CASE("an autosave never goes through a link") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  fs::create_directories(places.state / "autosave");
  const fs::path other = scratch.write("precious", "precious"), file = autosave_file(places);
  fs::create_symlink(other, file);
  REQUIRE(write_autosave(places, {file, "", "", "{}", 0}));
  CHECK_FALSE(fs::is_symlink(file));
  CHECK(fs::file_size(other) == 8);
}

TEST_CASE("what is too large to be read again is not written") {
  const Scratch scratch;
  const Places places = places_in(scratch);
  const Autosave work{autosave_file(places), "", "", std::string(most_autosave_bytes / 2 + 1, '"'), 0};
  const auto saved = write_autosave(places, work);  // every quote takes two bytes
  REQUIRE_FALSE(saved);
  CHECK(to_string(saved.diagnostics).find("more than 16 MB") != std::string::npos);
  CHECK_FALSE(fs::exists(work.file));
}
