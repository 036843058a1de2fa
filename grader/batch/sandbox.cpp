#include "grader/batch/sandbox.hpp"

#include <errno.h>
#include <fcntl.h>
#include <seccomp.h>
#include <stdio.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <memory>
#include <system_error>

namespace blossom {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

// The address space of this process, in bytes; 0 where the system does not say.
std::uint64_t address_space() {
  const std::unique_ptr<FILE, int (*)(FILE*)> file(fopen("/proc/self/statm", "re"), fclose);
  unsigned long long pages = 0;
  if (!file || fscanf(file.get(), "%llu", &pages) != 1) return 0;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

bool limit(decltype(RLIMIT_AS) which, std::uint64_t most) {
  rlimit now{};
  if (getrlimit(which, &now) == 0 && now.rlim_max <= most) most = now.rlim_max;
  const rlimit wanted{most, most};
  return setrlimit(which, &wanted) == 0;
}

std::string limit_all(std::size_t memory_bytes) {
  bool limited = true;
  if (memory_bytes != 0 && !sanitized) {
    const std::uint64_t begun_with = address_space();  // asked first, for it is a file
    limited = begun_with != 0 && limit(RLIMIT_AS, begun_with + memory_bytes);
  }
  limited = limited && limit(RLIMIT_CORE, 0) && limit(RLIMIT_FSIZE, 0) && (sanitized || limit(RLIMIT_NOFILE, 0)) &&
            limit(RLIMIT_NPROC, 0);
  return limited ? "" : "the grader's memory, files and processes have no limits (" + reason(errno) + ")";
}

// What computing takes. With conditions where a call can do more than that.
class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_KILL_PROCESS)) {}
  ~Filter() {
    if (context_ != nullptr) seccomp_release(context_);
  }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  template <class... Conditions>
  void allow(int call, Conditions... conditions) {
    add(SCMP_ACT_ALLOW, call, conditions...);
  }
  template <class... Conditions>
  void refuse(int error, int call, Conditions... conditions) {
    add(SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), call, conditions...);
  }
  // 0, or what went wrong.
  int load() {
    if (context_ == nullptr) return ENOMEM;
    if (failed_ == 0) failed_ = seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    if (failed_ == 0) failed_ = seccomp_load(context_);
    return -failed_;
  }

 private:
  template <class... Conditions>
  void add(std::uint32_t action, int call, Conditions... conditions) {
    if (context_ == nullptr || failed_ != 0) return;
    failed_ = seccomp_rule_add(context_, action, call, sizeof...(conditions), conditions...);
  }

  scmp_filter_ctx context_;
  int failed_ = 0;
};

int close_off() {
  Filter filter;
  for (const int call : {SCMP_SYS(read), SCMP_SYS(write), SCMP_SYS(readv), SCMP_SYS(writev), SCMP_SYS(lseek),
                         SCMP_SYS(close), SCMP_SYS(fstat)})
    filter.allow(call);
  for (const int call :
       {SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(brk), SCMP_SYS(madvise), SCMP_SYS(futex), SCMP_SYS(sched_yield),
        SCMP_SYS(getrandom), SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(getpid), SCMP_SYS(gettid),
        SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(restart_syscall), SCMP_SYS(sigaltstack), SCMP_SYS(rt_sigaction),
        SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn)})
    filter.allow(call);
  // Memory, but none that can be run.
  const auto not_executable = SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0);
  filter.allow(SCMP_SYS(mmap), not_executable);
  filter.allow(SCMP_SYS(mprotect), not_executable);
  // The C library's fstat is newfstatat of no name; its stdio asks whether it writes to a terminal.
  filter.allow(SCMP_SYS(newfstatat), SCMP_A3(SCMP_CMP_EQ, AT_EMPTY_PATH));
  filter.refuse(ENOTTY, SCMP_SYS(ioctl));
  // Abort sends a signal to this very process.
  filter.allow(SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, static_cast<scmp_datum_t>(getpid())));
  // The sanitizer for undefined behaviour looks through a pipe whether memory can be read.
  if (sanitized) filter.allow(SCMP_SYS(pipe2));
  return filter.load();
}

}  // namespace

std::string enter_sandbox(std::size_t memory_bytes) {
  std::string open = limit_all(memory_bytes);
  const auto add = [&](const std::string& sentence) { open += (open.empty() ? "" : "; ") + sentence; };
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) add("new privileges cannot be ruled out (" + reason(errno) + ")");
  if (const int error = close_off(); error != 0)
    add("network, files and processes are open to the grader, for the kernel takes no seccomp filter (" +
        reason(error) + ")");
  return open;
}

}  // namespace blossom
