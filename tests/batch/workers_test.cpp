// Worker processes: answers in the order of items, and a worker that dies takes one item with it.

#include "grader/batch/workers.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <new>
#include <random>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "grader/batch/sandbox.hpp"

namespace blossom {
namespace {

struct Taken {
  std::string item, answer;
  bool lost = false;
  Lost why{};
};

// What a pool makes of the items.
std::vector<Taken> run(Workers& workers, const std::vector<std::string>& items) {
  std::vector<Taken> taken;
  std::size_t next = 0;
  workers.run(
      [&](std::string& item) {
        if (next == items.size()) return false;
        item = items[next++];
        return true;
      },
      [&](std::string_view item, std::string_view answer, const Lost* lost) {
        taken.push_back({std::string(item), std::string(answer), lost != nullptr, lost != nullptr ? *lost : Lost{}});
      });
  return taken;
}

std::vector<std::string> numbers(int count) {
  std::vector<std::string> items;
  for (int i = 0; i < count; ++i) items.push_back(std::to_string(i));
  return items;
}

// Answers with the item twice; dies of "die", never ends on "hang", throws on "throw".
void twice(std::string_view item, std::string& answer) {
  if (item == "die") abort();
  if (item == "exit") _exit(7);
  if (item == "hang")
    for (volatile bool forever = true; forever;) continue;
  if (item == "throw") throw std::runtime_error("no such thing");
  if (item == "memory") throw std::bad_alloc();
  answer.append(item).append(item);
}

WorkerOptions options(unsigned processes, std::size_t frame_items = 256) {
  WorkerOptions made;
  made.processes = processes;
  made.frame_items = frame_items;
  return made;
}

}  // namespace

TEST_CASE("workers answer every item, in the order of items, on any number of processes and in frames of any size") {
  const auto items = numbers(2000);
  for (const unsigned processes : {1u, 2u, 5u})
    for (const std::size_t frame : {std::size_t{1}, std::size_t{7}, std::size_t{256}}) {
      INFO(processes << " processes, frames of " << frame);
      Workers workers(twice, options(processes, frame));
      for (int time = 0; time < 2; ++time) {  // a pool can be used again
        const auto taken = run(workers, items);
        REQUIRE(taken.size() == items.size());
        for (std::size_t i = 0; i < items.size(); ++i) {
          REQUIRE(taken[i].item == items[i]);
          REQUIRE_FALSE(taken[i].lost);
          REQUIRE(taken[i].answer == items[i] + items[i]);
        }
      }
      CHECK(run(workers, {}).empty());
    }
}

TEST_CASE("items and answers may be empty, and far larger than a frame or a socket") {
  std::vector<std::string> items;
  for (const std::size_t size : {0u, 1u, 100'000u, 0u, 5'000'000u, 3u, 1'000'000u, 0u}) items.emplace_back(size, 'x');
  Workers workers(twice, options(2));
  const auto taken = run(workers, items);
  REQUIRE(taken.size() == items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    CHECK(taken[i].item == items[i]);
    CHECK(taken[i].answer == items[i] + items[i]);
  }
}

TEST_CASE("a worker that dies takes exactly the item with it that it was at") {
  const unsigned seed = std::random_device{}();
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (const unsigned processes : {1u, 3u})
    for (const std::size_t frame : {std::size_t{1}, std::size_t{40}}) {
      INFO(processes << " processes, frames of " << frame);
      auto items = numbers(1000);
      for (int i = 0; i < 12; ++i) items[random() % items.size()] = i % 3 == 0 ? "exit" : "die";
      items.front() = items.back() = items[500] = items[501] = "die";
      Workers workers(twice, options(processes, frame));
      const auto taken = run(workers, items);
      REQUIRE(taken.size() == items.size());
      for (std::size_t i = 0; i < items.size(); ++i) {
        INFO("item " << i << ", " << items[i]);
        REQUIRE(taken[i].item == items[i]);
        const bool deadly = items[i] == "die" || items[i] == "exit";
        REQUIRE(taken[i].lost == deadly);
        if (!deadly) {
          REQUIRE(taken[i].answer == items[i] + items[i]);
          continue;
        }
        CHECK(taken[i].answer.empty());
        CHECK(taken[i].why.why == Lost::Why::died);
        CHECK(taken[i].why.text ==
              (items[i] == "die" ? "the grader died of signal 6 (SIGABRT)" : "the grader ended with status 7"));
      }
    }
}

TEST_CASE("a worker that is killed from outside costs nobody anything: its item is tried again, three times") {
  const auto items = numbers(50);
  const pid_t parent = getpid();
  // Every worker's first item is the end of it, until the third: as if there were no memory for a while.
  int* const left =
      static_cast<int*>(mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  REQUIRE(left != MAP_FAILED);
  WorkerOptions open = options(1);
  open.sandboxed = false;  // or it cannot kill itself
  const auto killed_so_often = [&](int times) {
    *left = times;
    Workers workers(
        [&](std::string_view item, std::string& answer) {
          if (getpid() != parent && item == "7" && *left > 0) {
            --*left;
            kill(getpid(), SIGKILL);
          }
          twice(item, answer);
        },
        open);
    return run(workers, items);
  };
  for (const auto& taken : killed_so_often(2)) CHECK_FALSE(taken.lost);
  const auto taken = killed_so_often(1000);
  REQUIRE(taken.size() == items.size());
  for (std::size_t i = 0; i < taken.size(); ++i) CHECK(taken[i].lost == (i == 7));
  CHECK(taken[7].why.text.find("SIGKILL") != std::string::npos);
  munmap(left, sizeof(int));
}

TEST_CASE("a worker that takes too long over an item is replaced; the item is lost, its neighbours are not") {
  WorkerOptions quick = options(2, 10);
  quick.seconds_per_item = 0.2;
  auto items = numbers(100);
  items[17] = items[55] = "hang";
  Workers workers(twice, quick);
  const auto taken = run(workers, items);
  REQUIRE(taken.size() == items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    INFO("item " << i);
    REQUIRE(taken[i].lost == (items[i] == "hang"));
    if (!taken[i].lost) CHECK(taken[i].answer == items[i] + items[i]);
  }
  CHECK(taken[17].why.why == Lost::Why::slow);
  CHECK(taken[17].why.text == "the grader took more than 0.2 seconds over it");
}

TEST_CASE("a worker that waits for ever without computing is replaced, too") {
  WorkerOptions open = options(1);
  open.seconds_per_item = 0.05;
  open.sandboxed = false;  // in the sandbox one cannot wait
  Workers workers(
      [](std::string_view item, std::string& answer) {
        if (item == "wait") pause();
        answer = item;
      },
      open);
  const auto taken = run(workers, {"a", "wait", "b"});
  REQUIRE(taken.size() == 3);
  CHECK(taken[0].answer == "a");
  CHECK(taken[1].lost);
  CHECK(taken[1].why.why == Lost::Why::slow);
  CHECK(taken[2].answer == "b");
}

TEST_CASE("what Work throws loses its item, and the worker goes on") {
  // Its process is the same before and after.
  Workers workers(
      [](std::string_view item, std::string& answer) {
        twice(item, answer);
        answer = std::to_string(getpid());
      },
      options(1));
  const auto taken = run(workers, {"a", "throw", "b", "memory", "c"});
  REQUIRE(taken.size() == 5);
  CHECK(taken[1].lost);
  CHECK(taken[1].why.why == Lost::Why::failed);
  CHECK(taken[1].why.text == "the grader failed: no such thing");
  CHECK(taken[3].lost);
  CHECK(taken[3].why.text == "the grader ran out of memory");
  CHECK(taken[0].answer == taken[2].answer);
  CHECK(taken[0].answer == taken[4].answer);
  CHECK(taken[0].answer != std::to_string(getpid()));
}

TEST_CASE("an item that takes all memory is lost, and an answer beyond its limit, too") {
  WorkerOptions small = options(1);
  small.memory_bytes = 64u << 20;
  small.answer_bytes = 1u << 20;
  Workers workers(
      [](std::string_view item, std::string& answer) {
        if (item == "much" && !sanitized) answer.assign(std::size_t{200} << 20, 'x');
        if (item == "long" || (item == "much" && sanitized)) answer.assign(std::size_t{2} << 20, 'x');
        answer += item;
      },
      small);
  const auto taken = run(workers, {"a", "much", "b", "long", "c"});
  REQUIRE(taken.size() == 5);
  CHECK(taken[1].lost);
  if (!sanitized) CHECK(taken[1].why.text == "the grader ran out of memory");
  CHECK(taken[3].lost);
  CHECK(taken[3].why.text == "the grader said too much about it");
  CHECK(taken[2].answer == "b");
  CHECK(taken[4].answer == "c");
}

TEST_CASE("a worker that was taken over can harm its own items only") {
  // It writes to the socket, which is its descriptor 3, whatever it likes.
  const auto say = [](const std::string& bytes) {
    if (write(3, bytes.data(), bytes.size()) < 0) _exit(9);
  };
  Workers workers(
      [&](std::string_view item, std::string& answer) {
        if (item == "endless") say(std::string(8, '\xFF'));
        if (item == "long") say(std::string("\0\0\0\x7F\0\0\0\0", 8));
        if (item == "noise") say(std::string(100'000, '\x01'));
        if (item == "more") say(std::string(8 * 1000, '\0'));
        if (item == "partial") {
          say(std::string("\x10\0\0\0\0\0\0\0abc", 11));
          _exit(0);
        }
        answer = item;
      },
      options(2, 4));
  for (const char* const hostile : {"endless", "long", "noise", "more", "partial"}) {
    INFO(hostile);
    auto items = numbers(64);
    items[20] = hostile;
    const auto taken = run(workers, items);
    REQUIRE(taken.size() == items.size());
    std::size_t harmed = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      REQUIRE(taken[i].item == items[i]);
      if (taken[i].lost || taken[i].answer != items[i]) ++harmed;
    }
    CHECK(harmed >= 1);
    CHECK(harmed <= 8);  // two frames of at most 4 items each
  }
}

TEST_CASE("items are not asked for while too many answers are outstanding") {
  WorkerOptions two = options(2, 8);
  two.seconds_per_item = 0.3;
  Workers workers(twice, two);
  int asked = 0, taken = 0, furthest = 0;
  workers.run(
      [&](std::string& item) {
        item = asked == 0 ? "hang" : std::to_string(asked);  // all the others wait for the first
        furthest = std::max(furthest, asked - taken);
        return ++asked <= 20'000;
      },
      [&](std::string_view, std::string_view, const Lost*) { ++taken; });
  CHECK(taken == 20'000);
  CHECK(furthest <= 8 * (4 * 2 + 4));
}

TEST_CASE("what next or take throws ends the run and the workers") {
  std::vector<int> pids;
  {
    Workers workers([](std::string_view, std::string& answer) { answer = std::to_string(getpid()); }, options(2));
    int asked = 0;
    const auto next = [&](std::string& item) {
      item = "x";
      return ++asked < 5000;
    };
    CHECK_THROWS_AS(workers.run(next,
                                [&](std::string_view, std::string_view answer, const Lost*) {
                                  pids.push_back(std::stoi(std::string(answer)));
                                  throw std::runtime_error("the disk is full");
                                }),
                    std::runtime_error);
    CHECK_THROWS_AS(workers.run(next, [](std::string_view, std::string_view, const Lost*) {}), std::logic_error);
  }
  REQUIRE(pids.size() == 1);
  CHECK(kill(pids[0], 0) == -1);
}

TEST_CASE("no worker outlives its parent") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t parent = fork();
  REQUIRE(parent >= 0);
  if (parent == 0) {
    close(ends[0]);
    Workers workers([](std::string_view, std::string& answer) { answer = std::to_string(getpid()); }, options(1));
    std::vector<Taken> taken = run(workers, {"x"});
    const int pid = std::stoi(taken[0].answer);
    if (write(ends[1], &pid, sizeof pid) != sizeof pid) _exit(1);
    kill(getpid(), SIGKILL);
  }
  close(ends[1]);
  int worker = 0;
  REQUIRE(read(ends[0], &worker, sizeof worker) == sizeof worker);
  close(ends[0]);
  int status = 0;
  REQUIRE(waitpid(parent, &status, 0) == parent);
  // It is dying; whoever adopts it collects it in a moment.
  const auto is_alive = [&] {
    const std::string name = "/proc/" + std::to_string(worker) + "/stat";
    FILE* file = fopen(name.c_str(), "re");
    if (file == nullptr) return false;
    char state = 'X';
    const bool known = fscanf(file, "%*d (%*[^)]) %c", &state) == 1;
    fclose(file);
    return known && state != 'Z' && state != 'X';
  };
  for (int i = 0; i < 1000 && is_alive(); ++i) usleep(10'000);
  CHECK_FALSE(is_alive());
}

TEST_CASE("a worker that the system refuses what it needs says what was refused", "[workers]") {
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  const int first_free = dup(STDIN_FILENO);
  REQUIRE(first_free >= 0);
  close(first_free);
  // Room for both ends of a socket, and for nothing in the worker.
  rlimit tight = before;
  tight.rlim_cur = static_cast<rlim_t>(first_free) + 2;
  REQUIRE(setrlimit(RLIMIT_NOFILE, &tight) == 0);
  std::string message;
  try {
    Workers workers([](std::string_view, std::string&) {}, {.processes = 1});
  } catch (const std::system_error& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_NOFILE, &before);
  CHECK(message == "a worker cannot be started: Too many open files");
}

}  // namespace blossom
