// Another process that exports: what it says, how it ends, how it is stopped. A shell stands in for it.
#include "player/export_job.hpp"

#include <catch2/catch.hpp>

#include "player/doing.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

ExportJob shell(const std::string& script, const fs::path& scratch = {}) {
  return {"/bin/sh", {"-c", script}, "page.html", scratch};
}

}  // namespace

TEST_CASE("The progress of an export is what it says on lines of its own") {
  ExportJob job = shell("echo progress 3 60; echo progress 12 60; echo page.html, 312 kB");
  job.wait();
  CHECK(job.done() == 12);
  CHECK(job.of() == 60);
  CHECK(job.wrong().empty());
  CHECK(job.notes() == std::vector<std::string>{"page.html, 312 kB"});
  CHECK_FALSE(job.running());
  CHECK_FALSE(job.poll());
}

TEST_CASE("What goes wrong is told with its place, and none of it is lost") {
  ExportJob job = shell("echo 'a:b.json:3:14: is no number' >&2; echo 'ffmpeg is missing' >&2; exit 3");
  job.wait();
  REQUIRE(job.wrong().size() == 2);
  CHECK(job.wrong()[0].file == "a:b.json");
  CHECK(job.wrong()[0].line == 3);
  CHECK(job.wrong()[0].column == 14);
  CHECK(job.wrong()[0].message == "is no number");
  CHECK(job.wrong()[1].message == "ffmpeg is missing");
  ExportJob silent = shell("exit 1");
  silent.wait();
  CHECK(silent.wrong().size() == 1);
  ExportJob missing("/no/such/program", {}, "x", {});
  CHECK_FALSE(missing.running());
  CHECK(missing.wrong().size() == 1);
}

TEST_CASE("An export is stopped at once, with what it has started, and its scratch file goes") {
  const Scratch scratch;
  const fs::path lesson = scratch.write("lesson.json", "{}");
  {
    ExportJob job = shell("trap '' TERM; echo progress 1 2; sleep 60 & wait; sleep 60", lesson);
    while (job.of() == 0) job.poll();
    job.stop();
    CHECK_FALSE(job.running());
    CHECK(job.stopped());
    CHECK(fs::exists(lesson));
  }
  CHECK_FALSE(fs::exists(lesson));
}

TEST_CASE("What is edited is what is exported, by another program, while the window goes on") {
  World world;
  PlayerOptions options = options_in(world.scratch);
  const fs::path program = world.scratch.write(
      "program", "#!/bin/sh\n[ \"$1\" = export ] || exit 2\ncp \"$2\" \"$6\"\necho \"$@\"\necho progress 1 1\n");
  fs::permissions(program, fs::perms::owner_all);
  options.program = program;
  Player player(options, world.desk);
  open(player, de_boor);
  REQUIRE(set_u(player, Exact::ratio(3, 7)));
  const fs::path out = world.scratch / "page.html";
  player.export_lesson("html", out, {"--theme", "dark"});
  REQUIRE(player.exporting() != nullptr);
  player.wait_for_export();
  INFO(to_string(player.problems().list));
  CHECK(player.exporting() == nullptr);
  CHECK(player.notice().starts_with("Exported: export "));
  CHECK(player.notice().find("--to html --out " + out.string() + " --progress lines --theme dark") !=
        std::string::npos);
  const auto written = open_document(out);
  REQUIRE(written);
  CHECK(written->inputs.number("u") == Exact::ratio(3, 7));
}

TEST_CASE("An export that fails is a problem, one that is cancelled is none") {
  World world;
  PlayerOptions options = options_in(world.scratch);
  const fs::path program =
      world.scratch.write("program", "#!/bin/sh\n[ \"$4\" = mp4 ] && sleep 60\necho no >&2\nexit 3\n");
  fs::permissions(program, fs::perms::owner_all);
  options.program = program;
  Player player(options, world.desk);
  open(player, de_boor);
  player.export_lesson("html", world.scratch / "page.html", {});
  player.wait_for_export();
  REQUIRE(player.problems().list.size() == 1);
  CHECK(player.problems().list[0].message == "no");
  player.dismiss_problems();
  player.export_lesson("mp4", world.scratch / "film.mp4", {});
  player.cancel_export();
  CHECK(player.exporting() == nullptr);
  CHECK(player.problems().list.empty());
  CHECK(player.notice() == "The export was stopped; nothing was written.");
}
