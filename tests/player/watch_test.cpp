#include "player/watch.hpp"

#include <sys/stat.h>

#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;
namespace fs = std::filesystem;

namespace {

// How many of so many polls told a change.
int changes(FileWatch& watch, int polls = 4) {
  int count = 0;
  for (int i = 0; i < polls; ++i) count += watch.poll();
  return count;
}

}  // namespace

TEST_CASE("a file that nobody touches does not change") {
  const Scratch scratch;
  FileWatch watch(scratch.write("a.json", "one"));
  CHECK(changes(watch) == 0);
}

TEST_CASE("that a file has gone is told once, and not while an editor replaces it") {
  const Scratch scratch;
  const fs::path file = scratch.write("a.json", "one");
  FileWatch watch(file);
  const auto gone = [&](int polls) {
    int count = 0;
    for (int i = 0; i < polls; ++i) {
      watch.poll();
      count += watch.has_gone() ? 1 : 0;
    }
    return count;
  };
  CHECK(gone(3) == 0);
  fs::remove(file);
  CHECK(gone(1) == 0);
  scratch.write("a.json", "two");
  CHECK(gone(3) == 0);
  fs::remove(file);
  CHECK(gone(5) == 1);
  FileWatch none;
  none.poll();
  none.poll();
  CHECK_FALSE(none.has_gone());
}

TEST_CASE("a change is told once") {
  const Scratch scratch;
  FileWatch watch(scratch.write("a.json", "one"));
  scratch.write("a.json", "longer than before");
  CHECK(changes(watch) == 1);
  CHECK(changes(watch) == 0);
  scratch.write("a.json", "three");
  CHECK(changes(watch) == 1);
}

TEST_CASE("a change to as many other bytes is seen, however soon it comes") {
  const Scratch scratch;
  for (int i = 0; i < 100; ++i) {  // many of them within one tick of the file system's clock
    const std::string name = "a" + std::to_string(i);
    FileWatch watch(scratch.write(name, "one"));
    scratch.write(name, "two");
    CHECK(changes(watch) == 1);
  }
}

TEST_CASE("touching a file, or writing the same into it, is no change") {
  const Scratch scratch;
  const std::string file = scratch.write("a.json", "one");
  FileWatch watch(file);
  fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::hours(1));
  CHECK(changes(watch) == 0);
  scratch.write("a.json", "one");
  CHECK(changes(watch) == 0);
}

TEST_CASE("a file that is replaced by renaming has changed, also when its time and size are as before") {
  const Scratch scratch;
  const std::string file = scratch.write("a.json", "one");
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
  const auto time = fs::last_write_time(file);
  FileWatch watch(file);
  const std::string other = scratch.write("a.json~", "two");
  fs::last_write_time(other, time);
  fs::rename(other, file);
  CHECK(changes(watch) == 1);
}

TEST_CASE("while it is written to, a file is not told to have changed") {
  const Scratch scratch;
  const std::string file = scratch.write("a.json", "{");
  FileWatch watch(file);
  std::ofstream out(file, std::ios::app);
  for (int i = 0; i < 20; ++i) {
    out << "\"key\": 1,\n" << std::flush;
    CHECK_FALSE(watch.poll());
  }
  CHECK(changes(watch) == 1);
}

TEST_CASE("a file that is gone has not changed; when it is there again its bytes count") {
  const Scratch scratch;
  const std::string file = scratch.write("a.json", "one");
  FileWatch watch(file);
  fs::remove(file);
  CHECK(changes(watch) == 0);
  scratch.write("a.json", "one");
  CHECK(changes(watch) == 0);
  fs::remove(file);
  CHECK(changes(watch) == 0);
  scratch.write("a.json", "two");
  CHECK(changes(watch) == 1);
}

TEST_CASE("a file that was not there yet, and what is no file") {
  const Scratch scratch;
  FileWatch none, folder(scratch.path()), later(scratch / "later.json");
  CHECK(changes(none) == 0);
  CHECK(changes(folder) == 0);
  CHECK(changes(later) == 0);
  scratch.write("later.json", "");
  CHECK(changes(later) == 1);
  // A pipe nobody writes to would make the reader wait.
  REQUIRE(mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  FileWatch pipe(scratch / "pipe");
  CHECK(changes(pipe) == 0);
}
