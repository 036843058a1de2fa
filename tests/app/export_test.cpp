// `blossom export` as a user at the terminal meets it: which files it writes, and what it says of mistakes.
#include "app/program.hpp"

#if BLOSSOM_PLAYER

#include <signal.h>

#include <chrono>
#include <set>
#include <thread>

using namespace blossom::test;

namespace {

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> names;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

Ended exported(std::vector<std::string> arguments, const Setting& setting = {}) {
  arguments.insert(arguments.begin(), "export");
  return blossom::test::blossom(arguments, setting);
}

constexpr const char* tiny =
    R"({"schema": "blossom.lesson/1", "id": "tiny", "title": {"en": "A segment", "de": "Eine Strecke"},
  "algorithm": "de_casteljau", "inputs": {"curve": {"degree": 1, "points": [[0, 0], [3, 1]]}, "u": "1/3"},
  "language": "en", "languages": ["de"],
  "beats": [{"at": "start", "say": {"en": "Two points.", "de": "Zwei Punkte."}}]})";

// A working folder with lessons/ of its own.
class Course : public Scratch {
 public:
  explicit Course(int lessons) {
    fs::create_directory(*this / "lessons");
    for (int i = 1; i <= lessons; ++i) {
      std::string text = tiny;
      const std::string number = std::to_string(i);
      text.replace(text.find("\"tiny\""), 6, "\"tiny-" + number + "\"");
      write("lessons/0" + number + "-tiny-" + number + ".json", text);
    }
  }
};

}  // namespace

TEST_CASE("export writes the format that is asked for, or that the file's name says") {
  const Scratch scratch;
  const auto named = exported({"22-de-boor", "--out", scratch / "new/run.json"});
  SHOW(named);
  CHECK(named.status == 0);
  CHECK(named.err.empty());
  CHECK(contains(named.out, scratch / "new/run.json"));
  CHECK(contains(named.out, "kB"));
  CHECK(contains(read_all(scratch / "new/run.json"), "blossom.trace/1"));

  const std::string lesson = scratch.write("my-lesson.json", tiny);
  const auto here = exported({lesson, "--to", "md"}, {.folder = scratch.path()});
  SHOW(here);
  CHECK(here.status == 0);
  CHECK(fs::exists(scratch / "my-lesson.md"));
  CHECK(fs::is_directory(scratch / "my-lesson-files"));

  const auto into = exported({lesson, "--to", "json", "--out", scratch / "new"});
  SHOW(into);
  CHECK(into.status == 0);
  CHECK(files_in(scratch / "new") == std::set<std::string>{"my-lesson.json", "run.json"});
}

TEST_CASE("export writes several formats into one folder") {
  const Scratch scratch;
  const std::string lesson = scratch.write("my-lesson.json", tiny);
  const auto ended = exported({lesson, "--to", "md,svg", "--to", "json", "--out", scratch / "all"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(files_in(scratch / "all") ==
        std::set<std::string>{"my-lesson.md", "my-lesson-files", "my-lesson-svg", "my-lesson.json"});
  CHECK(contains(ended.out, "in all "));
}

TEST_CASE("export --steps limits what is drawn") {
  const Scratch scratch;
  const std::vector<std::pair<std::string, std::set<std::string>>> cases{
      {"3..5", {"de-boor-03.svg", "de-boor-04.svg", "de-boor-05.svg"}},
      {"14..", {"de-boor-14.svg", "de-boor-15.svg"}},
      {"..1", {"de-boor-00.svg", "de-boor-01.svg"}},
      {"7", {"de-boor-07.svg"}},
      {"15..99", {"de-boor-15.svg"}}};
  for (const auto& [steps, files] : cases) {
    const auto ended = exported({"22", "--to", "svg", "--steps", steps, "--out", scratch / steps});
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK(files_in(scratch / steps) == files);
  }
  const auto beyond = exported({"22", "--to", "svg", "--steps", "40..", "--out", scratch / "beyond"});
  SHOW(beyond);
  CHECK(beyond.status == 1);
  CHECK(contains(beyond.err, "from 0 to 15"));
  CHECK_FALSE(fs::exists(scratch / "beyond"));
}

TEST_CASE("export speaks the language that is asked for, and counts in decimals if it is to") {
  const Scratch scratch;
  const std::string lesson = scratch.write("my-lesson.json", tiny);
  CHECK(exported({lesson, "--out", scratch / "de.md", "--language", "de"}).status == 0);
  CHECK(contains(read_all(scratch / "de.md"), "Zwei Punkte."));
  CHECK(exported({lesson, "--out", scratch / "en.md"}).status == 0);
  CHECK(contains(read_all(scratch / "en.md"), "Two points."));
  CHECK(contains(read_all(scratch / "en.md"), "1/3"));
  CHECK(exported({lesson, "--out", scratch / "decimals.md", "--decimals"}).status == 0);
  CHECK(contains(read_all(scratch / "decimals.md"), "0.333333"));
  const auto unknown = exported({lesson, "--out", scratch / "fr.md", "--language", "fr"});
  SHOW(unknown);
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.err, "en, de"));
}

TEST_CASE("export draws an algorithm without a lesson") {
  const Scratch scratch;
  const auto ended = exported({"--algorithm", "de_casteljau", "--inputs", "-", "--out", scratch / "run.json"},
                              {.input = R"({"curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}, "u": "1/3"})"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(read_all(scratch / "run.json"), "8/9"));
}

TEST_CASE("export --all writes each lesson of the course into a file of its own") {
  const Course course(4);
  const auto ended =
      exported({"--all", "--to", "md,json", "--out", "site", "--language", "de"}, {.folder = course.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
  std::set<std::string> expected;
  for (const std::string name : {"01-tiny-1", "02-tiny-2", "03-tiny-3", "04-tiny-4"}) {
    expected.insert({name + ".md", name + ".json", name + "-files"});
    CHECK(contains(read_all(course / ("site/" + name + ".md")), "Zwei Punkte."));
  }
  CHECK(files_in(course / "site") == expected);
  CHECK(contains(ended.out, "8 of 12 steps are not told in de"));  // without a beat
  // In the order of the course, whichever was done first.
  CHECK(ended.out.find("01-tiny-1.json") < ended.out.find("02-tiny-2.json"));
}

TEST_CASE("export --all writes a list of the pages") {
  const Course course(2);
  course.write("lessons/03-last.json",
               R"({"schema": "blossom.lesson/1", "id": "last", "title": "The last", "unit": "An end",
  "prerequisites": ["tiny-1"], "algorithm": "de_casteljau", "minutes": 7,
  "inputs": {"curve": {"degree": 1, "points": [[0, 0], [3, 1]]}, "u": "1/3"}, "beats": [{"at": "start", "say": "Two points."}]})");
  const auto ended = exported({"--all", "--to", "html", "--out", "site"}, {.folder = course.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(files_in(course / "site") ==
        std::set<std::string>{"01-tiny-1.html", "02-tiny-2.html", "03-last.html", "index.html"});
  const std::string list = read_all(course / "site/index.html");
  CHECK(contains(list, "<a href=\"02-tiny-2.html\">02 A segment</a>"));
  CHECK(contains(list, "<h2>An end</h2>"));
  CHECK(contains(list, "about 7 minutes"));
  for (const std::string file : {"index", "03-last"})
    CHECK(contains(read_all(course / ("site/" + file + ".html")), "<a href=\"01-tiny-1.html\">01 A segment</a>"));
  CHECK(contains(ended.out, "index.html"));
}

TEST_CASE("export --all says which lessons are not in a language, and refuses one that none is in") {
  const Course course(1);
  course.write("lessons/02-english.json",
               R"({"schema": "blossom.lesson/1", "id": "english", "title": "English", "algorithm": "de_casteljau",
  "inputs": {"curve": {"degree": 1, "points": [[0, 0], [3, 1]]}, "u": "1/3"}, "beats": [{"at": "start", "say": "Two points."}]})");
  const auto some = exported({"--all", "--to", "md", "--out", "site", "--language", "de"}, {.folder = course.path()});
  SHOW(some);
  CHECK(some.status == 0);
  CHECK(contains(some.out, "1 of 2 lessons are not in de"));
  const auto none = exported({"--all", "--to", "md", "--out", "none", "--language", "xx"}, {.folder = course.path()});
  SHOW(none);
  CHECK(none.status == 2);
  CHECK(contains(none.err, "de, en"));
  CHECK_FALSE(fs::exists(course / "none"));
}

TEST_CASE("A mistake in a lesson is told before any of the course is written") {
  const Course course(2);
  course.write("lessons/03-broken.json", R"({"schema": "blossom.lesson/1", "id": "broken", "title": 3})");
  const auto ended = exported({"--all", "--to", "json", "--out", "site"}, {.folder = course.path()});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, "03-broken.json"));
  CHECK_FALSE(fs::exists(course / "site"));
}

TEST_CASE("export says every wrong option at once, and what would be right") {
  const Scratch scratch;
  const auto many = exported({"22", "--to", "htlm,gif", "--steps", "9..3", "--size", "12", "--scale", "9", "--theme",
                              "sepia", "--fps", "0", "--seconds", "x", "--per-page", "3", "--out", scratch / "out"});
  SHOW(many);
  CHECK(many.status == 2);
  CHECK(many.out.empty());
  for (const std::string words :
       {"\"htlm\"", "3..9", "480x360", "0.25 to 8", "sepia", "1 to 60", "0.1 to 600", "1, 2, 4 or 6"})
    CHECK(contains(many.err, words));
  CHECK_FALSE(fs::exists(scratch / "out"));

  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"22", "--out", scratch / "a.docx"}, ".docx"},
      {{"22", "--out", scratch / "a"}, "--to"},
      {{"22"}, "--to"},
      {{"22", "--to", "json", "--out", scratch / "a.mp4"}, ".json"},
      {{"22", "--to", "png", "--out", scratch / "a.png"}, "folder"},
      {{"22", "--all", "--to", "json"}, "--all"},
      {{"--all", "--to", "json", "--scene", "1"}, "--scene"},
      {{"--to", "json"}, "LESSON"},
      {{"22", "--to", "json", "--out", "/dev/null"}, "device"},
      {{"22", "--to", "json", "--steps", "1.5"}, "--steps"},
      {{"22", "--to", "json", "--progress", "loud"}, "--progress"},
      {{"22", "--to", "html", "--fps", "10"}, "html has no use for it"},
      {{"22", "--to", "html", "--per-page", "4"}, "--per-page: is for handouts (pdf)"},
      {{"22", "--to", "pdf,html", "--size", "800x600"}, "--size"},
      {{"22", "--to", "svg", "--scale", "2"}, "--scale"},
      {{"22", "--to", "json", "--out", "-"}, "terminal"},
      {{"22", "--to", "png", "--out", scratch / "x.html"}, "a file's name"},
      {{"22", "--to", "pdf,html", "--out", scratch / "x.html"}, "a file's name"},
      {{"22", "--to", "json", "--scene", "5"}, "--scene"}};
  for (const auto& [arguments, words] : cases) {
    const auto ended = exported(arguments, {.folder = scratch.path()});
    SHOW(ended);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, words));
    CHECK(ended.out.empty());
  }
  CHECK(scratch.count() == 0);
}

TEST_CASE("export of what cannot be written is the machine's fault, and of no lesson the input's") {
  const Scratch scratch;
  const std::string file = scratch.write("file", "mine");
  const auto below_file = exported({"22", "--out", file + "/a.json"});
  SHOW(below_file);
  CHECK(below_file.status == 3);
  CHECK(contains(below_file.err, file));
  const auto over_folder = exported({"22", "--to", "svg", "--out", file});
  SHOW(over_folder);
  CHECK(over_folder.status == 2);
  CHECK(read_all(file) == "mine");
  const auto none = exported({"no-such-lesson", "--out", scratch / "out.json"});
  SHOW(none);
  CHECK(none.status == 1);
  CHECK(files_in(scratch.path()) == std::set<std::string>{"file"});
}

TEST_CASE("An export without ffmpeg says so and ends with status 3") {
  const Scratch scratch;
  const std::string before = std::getenv("PATH");
  setenv("PATH", "", 1);
  const auto ended = exported({"22", "--out", scratch / "film.mp4"});
  setenv("PATH", before.c_str(), 1);
  SHOW(ended);
  CHECK(ended.status == 3);
  CHECK(contains(ended.err, "apt-get install ffmpeg"));
  CHECK(contains(ended.err, "--to html"));
  CHECK(scratch.count() == 0);
}

TEST_CASE("export --progress lines counts for a program that waits") {
  const Scratch scratch;
  const auto ended = exported({"22", "--to", "svg", "--steps", "..3", "--progress", "lines", "--out", scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.out.starts_with("progress 1 4\nprogress 2 4\nprogress 3 4\nprogress 4 4\n"));
}

TEST_CASE("An export that is interrupted ends by the signal and leaves nothing") {
  const Scratch scratch;
  for (const std::string out : {"film.mp4", "pages"}) {
    const std::string format = out == "pages" ? "png" : "mp4";
    std::vector<std::string> texts{(fs::path(BLOSSOM_BIN_DIR) / "blossom").string(),
                                   "export",
                                   "67",
                                   "--to",
                                   format,
                                   "--out",
                                   scratch / out,
                                   "--size",
                                   "1600x900"};
    if (format == "mp4" && exported({"22", "--to", "mp4", "--steps", "0", "--out", scratch / "try.mp4"}).status == 3) {
      WARN("not tested: ffmpeg is not installed");
      continue;
    }
    fs::remove(scratch / "try.mp4");
    std::vector<char*> argv;
    for (std::string& text : texts) argv.push_back(text.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    REQUIRE(posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) == 0);
    // As soon as it has begun: its hidden folder is there.
    for (int i = 0; i < 1000 && scratch.count() == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(scratch.count() == 1);
    kill(child, SIGINT);
    int how = 0;
    REQUIRE(waitpid(child, &how, 0) == child);
    CHECK(WIFSIGNALED(how));
    CHECK(WTERMSIG(how) == SIGINT);
    CHECK(files_in(scratch.path()).empty());
  }
}

TEST_CASE("The manual of export names every format and shows examples") {
  const auto help = exported({"--help"});
  for (const std::string words : {"gif", "json", "md", "mp4", "png", "svg", "webm", "Examples", "--all", "Exit status"})
    CHECK(contains(help.out, words));
}

#endif
