// blossom-grade stream: JSON Lines in, JSON Lines out, for whatever spreads lines over cores and machines.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <system_error>

#include "grader/batch/stream.hpp"
#include "grader/command.hpp"
#include "grader/variant.hpp"

namespace blossom {
namespace {

constexpr const char* manual = R"(Examples:
  blossom-grade stream course.json < submissions.jsonl > grades.jsonl
      Each line a submission, and its grade in the same place; on all cores.
  blossom-grade stream course.json --input submissions.jsonl --shard 2/5 --output grades-2.jsonl
      The second fifth: what the five of them write, one after the other, is what one run writes.
  parallel --pipe --keep-order --block 4M blossom-grade stream course.json --jobs 1 < submissions.jsonl > grades.jsonl
      With GNU parallel, here or on other machines. grader/adapters/slurm has the same for Slurm.

A line:
  {"student": "s17", "schema": "blossom.answers/1", "exercise": "de-boor", "answers": {"k": 4, ...}}
  {"student": "s17", "submission": the answers file, as an object or as a string}

A line that cannot be graded gives an object, too: its exercise is "", its score 0, and it has the reason and the first
16 digits of the line's SHA-256. A line has at most 132 KiB, the answers in it at most 64 KiB.

Exit status: 0 every line has its object; 1 the assignment, the secret or the input's name is at fault; 2 wrong usage;
3 the machine is at fault (memory, output).)";

struct Given {
  std::string assignment, input = "-", output = "-", shard, secret_file, now;
  unsigned jobs = 0;
  bool no_sandbox = false;
};

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

int complain(const Diagnostics& diagnostics, int status = input_at_fault) {
  std::fputs(to_string(diagnostics).c_str(), stderr);
  return status;
}

// A regular file gets its name only when it is whole.
class Output {
 public:
  explicit Output(const std::string& path) : path_(path) {
    struct stat about {};
    if (path_ == "-") {
      file_ = STDOUT_FILENO;
    } else if (stat(path_.c_str(), &about) == 0 && !S_ISREG(about.st_mode)) {
      file_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
      unfinished_ = path_ + ".unfinished-" + std::to_string(getpid());
      file_ = open(unfinished_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
    }
    if (file_ < 0) fail(path_);
  }
  ~Output() {
    if (!unfinished_.empty()) unlink(unfinished_.c_str());
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t put = ::write(file_, bytes.data(), bytes.size());
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) fail("the output cannot be written");
      bytes.remove_prefix(static_cast<std::size_t>(put));
    }
  }

  // A file of another machine may say only now that its disk is full.
  void finish() {
    if (!unfinished_.empty() && fsync(file_) != 0) fail("the output cannot be written");
    if (path_ != "-" && close(file_) != 0) fail("the output cannot be written");
    if (!unfinished_.empty() && rename(unfinished_.c_str(), path_.c_str()) != 0) fail(path_);
    unfinished_.clear();
  }

 private:
  std::string path_;
  std::string unfinished_;
  int file_ = -1;
};

// "2/5"
bool parse_shard(const std::string& text, unsigned& index, unsigned& count) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, index);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return false;
  const auto second = std::from_chars(first.ptr + 1, end, count);
  return second.ec == std::errc() && second.ptr == end && 1 <= index && index <= count && count <= 1'000'000;
}

int open_input(const Given& given, Extent& extent) {
  const int file = given.input == "-" ? STDIN_FILENO : open(given.input.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (file < 0 || fstat(file, &about) != 0) {
    complain({{given.input, 0, 0, "", "cannot be read: " + std::generic_category().message(errno)}});
    return -1;
  }
  if (S_ISDIR(about.st_mode)) {
    complain({{given.input, 0, 0, "", "is a folder; `blossom-grade batch` grades folders"}});
    return -1;
  }
  unsigned index = 0, count = 0;
  if (given.shard.empty() || !parse_shard(given.shard, index, count)) return file;
  if (!S_ISREG(about.st_mode)) {
    complain({{given.input, 0, 0, "", "has no parts; --shard needs --input of a regular file"}});
    return -1;
  }
  extent = shard_of(static_cast<std::uint64_t>(about.st_size), index, count);
  return file;
}

int grade(const Given& given) {
  auto assignment = load_assignment(given.assignment);
  if (!assignment) return complain(assignment.diagnostics);
  std::string secret;
  if (!given.secret_file.empty()) {
    auto read = load_secret(given.secret_file);
    if (!read) return complain(read.diagnostics);
    secret = std::move(*read);
  }
  const Time now = given.now.empty() ? std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now())
                                     : parse_time(given.now).value();
  const bool has_secret = !secret.empty();
  Examiner examiner(std::move(*assignment), std::move(secret), now);
  for (std::size_t i = 0; i < examiner.assignment().items.size(); ++i)
    if (!has_secret && examiner.varies(i)) return complain(examiner.grader(i, "nobody").diagnostics);

  Extent extent;
  const int input = open_input(given, extent);
  if (input < 0) return input_at_fault;
  LineReader reader(input, extent);
  Output output(given.output);
  prepare_for_workers(examiner);
  WorkerOptions options;
  options.processes = given.jobs;
  options.sandboxed = !given.no_sandbox;
  Workers workers([&](std::string_view item, std::string& line) { grade_line(examiner, item, line); }, options);
  if (!workers.open_because().empty())
    std::fprintf(stderr, "blossom-grade: the workers are not wholly closed off: %s\n",
                 printable(workers.open_because()).c_str());
  const StreamCounts counts = grade_stream(reader, workers, [&](std::string_view lines) { output.write(lines); });
  output.finish();
  if (counts.ungraded > 0)
    std::fprintf(stderr, "blossom-grade: %llu of %llu lines could not be graded; their objects say why\n",
                 static_cast<unsigned long long>(counts.ungraded), static_cast<unsigned long long>(counts.lines));
  return done;
}

void set_up(CLI::App& app, int& status) {
  auto given = std::make_shared<Given>();
  app.add_option("assignment", given->assignment, "the assignment, or one exercise: a JSON file")
      ->required()
      ->option_text("ASSIGNMENT");
  app.add_option("-i,--input", given->input, "JSON Lines; - is standard input")->option_text("FILE (default: -)");
  app.add_option("-o,--output", given->output, "where the grades go; a file has its name only when it is whole")
      ->option_text("FILE (default: -)");
  app.add_option("--shard", given->shard, "the i-th of n parts of the input, which must be a file")
      ->check([](const std::string& text) {
        unsigned index = 0, count = 0;
        return parse_shard(text, index, count) ? std::string() : "must be i/n with 1 <= i <= n, such as 2/5";
      })
      ->option_text("I/N");
  app.add_option("-j,--jobs", given->jobs, "how many processes grade")
      ->check(CLI::Range(1u, 1024u))
      ->option_text("N (default: one for each core)");
  app.add_option("--secret-file", given->secret_file, "the course's secret, which variants are drawn with")
      ->option_text("FILE");
  app.add_option("--now", given->now, "the time that decides which feedback is given (default: the clock's)")
      ->check(is_time)
      ->option_text("TIME");
  app.add_flag("--no-sandbox", given->no_sandbox, "grade in processes that are not closed off");
  app.footer(manual);
  app.callback([given, &status] { status = grade(*given); });
}

}  // namespace

const GradeCommand& command_stream() {
  static const GradeCommand command{"stream", "Grade JSON Lines, for many cores and machines", 35, set_up};
  return command;
}

}  // namespace blossom
