// The sandbox: what grades files that nobody can trust can compute, answer and end, and nothing else.

#include "grader/batch/sandbox.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <ctime>
#include <map>

#include "base/scalar.hpp"
#include "grader/batch/workers.hpp"
#include "scratch.hpp"

namespace blossom {
namespace {

// How a process ends that enters the sandbox and does this: 0 if it came to the end, otherwise the signal's number.
template <class Deed>
int ending(Deed&& deed) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    signal(SIGABRT, SIG_DFL);  // the test program's own handler would speak
    if (!enter_sandbox(1u << 30).empty()) _exit(99);
    deed();
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status) ? WTERMSIG(status) : -WEXITSTATUS(status);
}

// Asked of the kernel itself.
bool kernel_filters() {
  const std::uint32_t action = 0x80000000u;  // SECCOMP_RET_KILL_PROCESS
  return syscall(SYS_seccomp, 2 /* SECCOMP_GET_ACTION_AVAIL */, 0, &action) == 0;
}

}  // namespace

TEST_CASE("in the sandbox every door is closed: network, files, processes, privileges, other processes") {
  if (!kernel_filters()) {
    WARN("test skipped: this kernel takes no seccomp filter");
    return;
  }
  const test::Scratch scratch;
  const std::string file = scratch.write("file", "text");
  const pid_t self = getpid();
  const std::map<std::string, std::function<void()>> deeds{
      {"socket", [] { socket(AF_INET, SOCK_STREAM, 0); }},
      {"local socket", [] { socket(AF_UNIX, SOCK_STREAM, 0); }},
      {"socket pair",
       [] {
         int ends[2];
         [[maybe_unused]] int r = socketpair(AF_UNIX, SOCK_STREAM, 0, ends);
       }},
      {"connect",
       [] {
         sockaddr_in to{};
         to.sin_family = AF_INET;
         connect(0, reinterpret_cast<sockaddr*>(&to), sizeof to);
       }},
      {"open", [&] { [[maybe_unused]] int r = open(file.c_str(), O_RDONLY); }},
      {"old open", [&] { syscall(SYS_open, file.c_str(), O_RDONLY); }},
      {"create", [&] { [[maybe_unused]] int r = open((file + "2").c_str(), O_CREAT | O_WRONLY, 0600); }},
      {"unlink", [&] { unlink(file.c_str()); }},
      {"rename", [&] { rename(file.c_str(), (file + "2").c_str()); }},
      {"mkdir", [&] { mkdir((file + "3").c_str(), 0700); }},
      {"stat",
       [&] {
         struct stat about;
         stat(file.c_str(), &about);
       }},
      {"read a link",
       [] {
         char to[100];
         [[maybe_unused]] auto r = readlink("/proc/self/exe", to, sizeof to);
       }},
      {"fork", [] { fork(); }},
      {"vfork", [] { syscall(SYS_vfork); }},
      {"thread", [] { syscall(SYS_clone, 0, 0, 0, 0, 0); }},
      {"execve",
       [] {
         char* none[] = {nullptr};
         execve("/bin/true", none, none);
       }},
      {"kill", [&] { kill(self, 0); }},
      {"signal to another", [&] { syscall(SYS_tgkill, self, self, 0); }},
      {"ptrace", [] { syscall(SYS_ptrace, 0, 0, 0, 0); }},
      {"read another's memory", [&] { syscall(SYS_process_vm_readv, self, 0, 0, 0, 0, 0); }},
      {"run what was written", [] { mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); }},
      {"make memory run",
       [] {
         void* page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
         mprotect(page, 4096, PROT_READ | PROT_EXEC);
       }},
      {"namespace", [] { syscall(SYS_unshare, 0x10000000); }},
      {"mount", [] { syscall(SYS_mount, "none", "/", "tmpfs", 0, nullptr); }},
      {"io_uring", [] { syscall(SYS_io_uring_setup, 1, nullptr); }},
      {"bpf", [] { syscall(SYS_bpf, 0, nullptr, 0); }},
      {"another filter", [] { syscall(SYS_seccomp, 1, 0, nullptr); }},
      {"set a limit",
       [] {
         rlimit any{1, 1};
         setrlimit(RLIMIT_AS, &any);
       }},
      {"the time of the machine",
       [] {
         timespec now{};
         clock_settime(CLOCK_REALTIME, &now);
       }},
  };
  for (const auto& [name, deed] : deeds) {
    INFO(name);
    CHECK(ending(deed) == SIGSYS);
  }
  CHECK(scratch.count() == 1);
}

TEST_CASE("in the sandbox one can compute, take memory, throw, tell the time, read and write what is open, and abort") {
  if (!kernel_filters()) {
    WARN("test skipped: this kernel takes no seccomp filter");
    return;
  }
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  CHECK(ending([&] {
          Exact x = 3;  // 3^8192 has 3909 digits
          for (int i = 0; i < 13; ++i) x = x * x;
          if (x.to_string().size() != 3909) _exit(1);
        }) == 0);
  CHECK(ending([&] {
          std::string large(100u << 20, 'x');
          large.resize(200u << 20);
        }) == 0);
  CHECK(ending([&] {
          try {
            throw std::runtime_error("caught");
          } catch (const std::exception&) {
          }
        }) == 0);
  CHECK(ending([&] {
          if (std::time(nullptr) == 0 || write(ends[1], "x", 1) != 1) _exit(1);
          char c;
          if (read(ends[0], &c, 1) != 1 || c != 'x') _exit(2);
        }) == 0);
  CHECK(ending([] { abort(); }) == SIGABRT);
  close(ends[0]);
  close(ends[1]);
}

TEST_CASE("in the sandbox memory has a limit, files cannot grow, and no core is left") {
  if (!kernel_filters()) {
    WARN("test skipped: this kernel takes no seccomp filter");
    return;
  }
  if (!sanitized)
    CHECK(ending([] {
            void* much = mmap(nullptr, 2u << 30, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            _exit(much == MAP_FAILED ? 17 : 0);
          }) == -17);
  const test::Scratch scratch;
  const int file = open((scratch / "file").c_str(), O_CREAT | O_RDWR, 0600);
  REQUIRE(file >= 0);
  CHECK(ending([&] { [[maybe_unused]] auto r = write(file, "x", 1); }) == SIGXFSZ);
  close(file);
}

TEST_CASE("a worker that tries a closed door dies of it, and its item is reported; the others are answered") {
  const auto work = [](std::string_view item, std::string& answer) {
    if (item == "socket") socket(AF_INET, SOCK_STREAM, 0);
    if (item == "open") answer = std::to_string(open("/etc/passwd", O_RDONLY));
    if (item == "fork") answer = std::to_string(fork());
    if (item == "execve") execl("/bin/true", "true", nullptr);
    answer += item;
  };
  WorkerOptions options;
  options.processes = 2;
  Workers workers(work, options);
  if (!kernel_filters()) {
    CHECK_FALSE(workers.open_because().empty());
    WARN("test skipped: " << workers.open_because());
    return;
  }
  REQUIRE(workers.open_because().empty());
  const std::vector<std::string> items{"a", "socket", "b", "open", "c", "fork", "execve", "d"};
  std::size_t next = 0, taken = 0;
  workers.run([&](std::string& item) { return next < items.size() && (item = items[next++], true); },
              [&](std::string_view item, std::string_view answer, const Lost* lost) {
                INFO(item);
                CHECK(item == items[taken++]);
                CHECK((lost != nullptr) == (item.size() > 1));
                if (lost == nullptr) {
                  CHECK(answer == item);
                } else {
                  CHECK(lost->text == "the grader tried what is not allowed (SIGSYS)");
                }
              });
  CHECK(taken == items.size());
}

}  // namespace blossom
