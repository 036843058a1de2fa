#include "grader/batch/batch.hpp"

#include "grader/batch/collate.hpp"
#include "grader/batch/kept.hpp"
#include "grader/batch/manifest.hpp"
#include "grader/batch/output.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// All that a run is given, read and in order.
struct Given {
  Assignment assignment;
  std::optional<Roster> roster;
  std::string secret;
};

Checked<Given> read_given(const BatchOptions& options) {
  Diagnostics diagnostics;
  const auto take = [&](auto& checked) {
    diagnostics.insert(diagnostics.end(), checked.diagnostics.begin(), checked.diagnostics.end());
    return static_cast<bool>(checked);
  };
  Given given;
  if (auto assignment = load_assignment(options.assignment); take(assignment))
    given.assignment = std::move(*assignment);
  if (options.roster)
    if (auto roster = Roster::load(*options.roster); take(roster)) given.roster = std::move(*roster);
  if (options.secret)
    if (auto secret = load_secret(*options.secret); take(secret)) given.secret = std::move(*secret);
  for (const Assignment::Item& item : given.assignment.items)
    if (diagnostics.empty() && given.secret.empty() && varies(item.document))
      diagnostics.push_back(
          {item.document.name(), 0, 0, "vary",
           "each student has numbers of their own here: the course's secret is needed (--secret-file)"});
  if (!diagnostics.empty()) return diagnostics;
  return given;
}

Checked<std::unique_ptr<SubmissionSource>> open_source(const std::string& submissions) {
  const fs::path path(submissions);
  std::error_code error;
  // What a folder of results keeps of its submissions.
  if (path.filename() == "submissions.jsonl" && fs::exists(path.parent_path() / "run.json", error))
    return open_kept(path);
  return open_submissions(path);
}

// A copied or unpacked file has any time: it is asked for only where somebody vouches for it.
bool has_times(const BatchOptions& options) {
  return options.file_times || options.submissions == "-" || options.submissions.ends_with(".jsonl");
}

bool has_only_work(const fs::path& out) {
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().filename() != ".work") return false;
  return true;
}

// Removes what a run of any options leaves, and nothing else.
void clear(const fs::path& out) {
  for (const auto* name : {"results.jsonl", "incidents.csv", "summary.json", "class.html", "assignment.json",
                           "submissions.jsonl", "roster.csv", "changes.csv", "run.json"})
    fs::remove(out / name);
  for (const auto* name : {"class", "students"}) fs::remove_all(out / name);
  for (const ReportFormat* format : report_formats()) {
    const std::string extension(format->extension), name(format->name);
    fs::remove(out / ("gradebook." + name + "." + extension));
    if (format->scope == ReportFormat::Scope::student) fs::remove_all(out / name);
  }
  for (const auto* name : {"spool", "portions", "out"}) fs::remove_all(out / ".work" / name);
  for (const auto* name : {"read.json", "students", "students.ends", "strays.csv", "submissions.jsonl", "tmp"})
    fs::remove(out / ".work" / name);
}

// The folder of results, found empty, begun, or finished.
class Folder {
 public:
  explicit Folder(const BatchOptions& options) : options_(&options), out_(options.out), work_(out_ / ".work") {
    std::error_code error;
    there_ = read_manifest(out_);
    has_read_ = there_ && !options.fresh && taken_in(work_).has_value();
    is_foreign_ = fs::exists(out_, error) && !there_ && (!fs::is_directory(out_) || !has_only_work(out_));
  }

  // Whether an interrupted run is gone on with, which had come as far as having read everything.
  bool goes_on() const { return has_read_ && !there_->finished; }
  bool is_finished() const { return there_ && there_->finished && !options_->fresh; }

  // The time it is made as of: that of what is there, unless another is asked for.
  Time now() const {
    if (options_->now) return *options_->now;
    if (goes_on() || is_finished()) return there_->now;
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  }

  Diagnostics refuse(std::string message) const { return {{out_.string(), 0, 0, "", std::move(message)}}; }

  // Why nothing may be done here; empty if something may.
  Diagnostics objection(const Manifest& wanted) const {
    if (is_foreign_) return refuse("is not empty, and it is no folder of results; give another one");
    if (!goes_on() && !is_finished()) return {};
    std::string different = difference(*there_, wanted);
    if (different.empty() && there_->finished && options_->submissions == "-")
      different = "what standard input has now cannot be told";
    if (different.empty()) return {};
    return refuse(
        (there_->finished ? "holds the results of another run (" : "holds another run, which was interrupted (") +
        different + "); give another folder, or --fresh to have them replaced");
  }

  void begin(const Manifest& wanted) const {
    if (goes_on()) return;
    clear(out_);
    write_manifest(wanted, out_, work_);
  }

  void finish(Manifest manifest) {
    manifest.finished = true;
    write_manifest(manifest, out_, work_);
    remove_work();
  }
  void remove_work() const { fs::remove_all(work_); }

  const fs::path& work() const { return work_; }

 private:
  const BatchOptions* options_;
  fs::path out_;
  fs::path work_;
  std::optional<Manifest> there_;
  bool has_read_ = false;
  bool is_foreign_ = false;
};

// Stages one to three; the folder is begun.
Checked<BatchSummary> work_on(const BatchOptions& options, Given given, const Folder& folder, Time now,
                              std::unique_ptr<SubmissionSource> source,
                              const std::function<void(const BatchProgress&)>& progress) {
  const fs::path& work = folder.work();
  auto intake = source ? std::nullopt : taken_in(work);
  ClassList list = given.roster ? ClassList(std::move(*given.roster))
                   : intake     ? ClassList(Newcomers::open(work / "students"))
                                : ClassList(Newcomers::begin(work / "students"));
  if (!intake) {
    auto taken = take_in(*source, list, work, {options.keep_submissions, has_times(options)}, progress);
    if (!taken) {
      for (Diagnostic& diagnostic : taken.diagnostics) diagnostic.file = options.submissions;
      return taken.diagnostics;
    }
    intake = *taken;
    source.reset();
  }
  const auto spool = SpoolReader::open(work / "spool");
  if (!spool) return Diagnostics{{(work / "spool").string(), 0, 0, "", "is damaged; begin anew with --fresh"}};

  Collation collation{&options, nullptr, {}, now, *intake};
  Examiner examiner(std::move(given.assignment), std::move(given.secret), now);
  collation.assignment = &examiner.assignment();
  // Reports are not told how many students come: one that gathers them for a closing table would hold the class.
  collation.context = {&examiner.assignment(), 0, list.has_roster()};
  collation.students = list.size();
  Desk desk(examiner, {options.formats, collation.context, options.pages, options.student_files});
  std::string open_because;
  {
    Workers workers([&](std::string_view item, std::string& answer) { desk.work(item, answer); }, options.workers);
    open_because = workers.open_because();
    Grading grading(options, list, *spool, work);
    const auto graded = grading.run(workers, progress);
    if (!graded) return graded.diagnostics;
  }
  BatchSummary summary = collate(collation, work, progress);
  summary.open_because = std::move(open_because);
  return summary;
}

}  // namespace

Checked<BatchSummary> run_batch(const BatchOptions& options,
                                const std::function<void(const BatchProgress&)>& progress) {
  auto given = read_given(options);
  if (!given) return given.diagnostics;
  std::error_code error;
  if (fs::equivalent(fs::path(options.submissions).parent_path(), options.out, error) ||
      fs::equivalent(options.submissions, options.out, error))
    return Diagnostics{{options.out.string(), 0, 0, "", "holds the submissions; give another folder for the results"}};
  Folder folder(options);
  const Manifest wanted = manifest_of(options, given->assignment, given->secret, folder.now());
  if (auto objection = folder.objection(wanted); !objection.empty()) return objection;
  if (folder.is_finished()) {
    folder.remove_work();
    auto summary = read_summary(options.out);
    if (!summary) return folder.refuse("has no summary.json that can be read; --fresh grades anew");
    summary->was_finished = true;
    return std::move(*summary);
  }
  std::unique_ptr<SubmissionSource> source;
  if (!folder.goes_on()) {
    auto opened = open_source(options.submissions);
    if (!opened) return opened.diagnostics;
    source = std::move(*opened);
  }
  make_folder(folder.work());
  const FolderLock lock(folder.work() / "lock");
  if (!lock.held()) return folder.refuse("another run is at work in this folder");
  folder.begin(wanted);
  auto summary = work_on(options, std::move(*given), folder, wanted.now, std::move(source), progress);
  if (!summary) return summary;
  folder.finish(wanted);
  summary->resumed = folder.goes_on();
  return summary;
}

}  // namespace blossom
