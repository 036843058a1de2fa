#include "grader/batch/batch.hpp"

#include <algorithm>
#include <array>

#include "grader/batch/collate.hpp"
#include "grader/batch/folder_lock.hpp"
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

// The path as it is, and as it is where its last name is a link.
std::array<fs::path, 2> whole_paths(const fs::path& path) {
  std::error_code error;
  fs::path typed = fs::absolute(path, error).lexically_normal();
  if (!typed.has_filename()) typed = typed.parent_path();
  return {fs::weakly_canonical(typed, error), fs::weakly_canonical(typed.parent_path(), error) / typed.filename()};
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

// Results are replaced, and submissions are read, as a folder: neither may be inside the other.
Diagnostics overlap(const BatchOptions& options, const Assignment& assignment) {
  const auto refuse = [&](std::string message) {
    return Diagnostics{{options.out.string(), 0, 0, "", std::move(message) + "; give another folder for the results"}};
  };
  if (options.out.empty()) return refuse("the folder of results has no name");
  std::vector<std::pair<std::string_view, fs::path>> inputs{{"the assignment", options.assignment}};
  for (const Assignment::Item& item : assignment.items) inputs.emplace_back("an exercise", item.document.name());
  if (options.roster) inputs.emplace_back("the roster", *options.roster);
  if (options.secret) inputs.emplace_back("the secret", *options.secret);
  if (options.submissions != "-") inputs.emplace_back("the submissions", options.submissions);
  const fs::path out = whole_paths(options.out).front();
  for (const auto& [what, path] : inputs)
    for (const fs::path& whole : whole_paths(path)) {
      std::error_code error;
      if (is_inside(whole, out) && fs::exists(whole, error))
        return refuse("holds " + std::string(what) + " (" + path.string() + ")");
      if (what == "the submissions" && fs::is_directory(whole, error) && is_inside(out, whole))
        return refuse("is inside the submissions (" + path.string() + "), and would be read as one of them");
    }
  return {};
}

bool has_only_work(const fs::path& out) {
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().filename() != ".work") return false;
  return true;
}

// Nobody's results, and not empty.
bool is_foreign(const fs::path& out) {
  std::error_code error;
  return fs::exists(out, error) && !read_manifest(out) && (!fs::is_directory(out) || !has_only_work(out));
}

// Removes what a run of any options leaves, and nothing else; run.json, which says that it may, stays.
void clear(const fs::path& out) {
  for (const auto* name : {"results.jsonl", "incidents.csv", "summary.json", "class.html", "assignment.json",
                           "submissions.jsonl", "roster.csv", "changes.csv", "changes.csv.unfinished"})
    fs::remove(out / name);
  for (const auto* name : {"class", "students"}) fs::remove_all(out / name);
  for (const ReportFormat* format : report_formats()) {
    const std::string extension(format->extension), name(format->name);
    fs::remove(out / ("gradebook." + name + "." + extension));
    if (format->scope == ReportFormat::Scope::student) fs::remove_all(out / name);
  }
}

// The folder of results, found empty, begun, or finished; while it is locked.
class Folder {
 public:
  explicit Folder(const BatchOptions& options) : options_(&options), out_(options.out), work_(out_ / ".work") {
    there_ = read_manifest(out_);
    has_read_ = there_ && !options.fresh && taken_in(work_).has_value();
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
    if (!goes_on() && !is_finished()) return {};
    std::string different = difference(*there_, wanted);
    if (different.empty() && there_->finished && options_->submissions == "-")
      different = "what standard input has now cannot be told";
    return different.empty() ? Diagnostics{} : refuse_for(different);
  }

  // Standard input cannot be told from another before it is read.
  Diagnostics objection(SubmissionSource& again) const {
    const auto digest = digest_of(again);
    if (digest && *digest == taken_in(work_)->digest) return {};
    return digest ? refuse_for("standard input has other submissions now") : digest.diagnostics;
  }

  // Whenever this is interrupted, run.json says whose the folder is, and that nothing of it counts yet.
  void begin(const Manifest& wanted, const FolderLock& lock) const {
    lock.clear_work();
    write_manifest(wanted, out_, work_);
    if (there_) clear(out_);
  }

  void finish(Manifest manifest, const FolderLock& lock) const {
    manifest.finished = true;
    write_manifest(manifest, out_, work_);
    lock.clear_work();
  }

  const fs::path& work() const { return work_; }

 private:
  Diagnostics refuse_for(const std::string& different) const {
    return refuse(
        (there_->finished ? "holds the results of another run (" : "holds another run, which was interrupted (") +
        different + "); give another folder, or --fresh to have them replaced");
  }

  const BatchOptions* options_;
  fs::path out_;
  fs::path work_;
  std::optional<Manifest> there_;
  bool has_read_ = false;
};

// A source of which the first submission has been read: what is no archive at all is found out before anything is
// removed for it.
class BegunSource final : public SubmissionSource {
 public:
  explicit BegunSource(std::unique_ptr<SubmissionSource> rest) : rest_(std::move(rest)) { has_first_ = read(first_); }

  bool next(Found& found) override {
    if (!std::exchange(has_first_, false)) return failure_.empty() && read(found);
    found = std::move(first_);
    return true;
  }
  std::optional<double> progress() const override { return rest_->progress(); }

 private:
  bool read(Found& found) {
    const bool more = rest_->next(found);
    if (!more) failure_ = rest_->failure();
    open_because_ = rest_->open_because();
    return more;
  }

  std::unique_ptr<SubmissionSource> rest_;
  Found first_;
  bool has_first_ = false;
};

// Stages one to three; the folder is begun.
Checked<BatchSummary> work_on(const BatchOptions& options, Given given, const Folder& folder, Time now,
                              std::unique_ptr<SubmissionSource> source,
                              const std::function<void(const BatchProgress&)>& progress) {
  const fs::path& work = folder.work();
  std::string open_because;
  auto intake = source ? std::nullopt : taken_in(work);
  ClassList list = given.roster ? ClassList(std::move(*given.roster))
                   : intake     ? ClassList(Newcomers::open(work / "students"))
                                : ClassList(Newcomers::begin(work / "students"));
  if (!intake) {
    auto taken = take_in(*source, list, work,
                         {options.keep_submissions, has_times(options), options.submissions == "-"}, progress);
    if (!taken) {
      for (Diagnostic& diagnostic : taken.diagnostics) diagnostic.file = options.submissions;
      return taken.diagnostics;
    }
    intake = *taken;
    open_because = source->open_because();
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
  {
    Workers workers([&](std::string_view item, std::string& answer) { desk.work(item, answer); }, options.workers);
    if (!workers.open_because().empty()) open_because = workers.open_because();
    Grading grading(options, list, *spool, work);
    const auto graded = grading.run(workers, progress);
    if (!graded) return graded.diagnostics;
  }
  BatchSummary summary = collate(collation, work, progress);
  summary.open_because = std::move(open_because);
  if (collation.assignment->due) summary.untimed = intake->untimed;
  return summary;
}

}  // namespace

Checked<BatchSummary> run_batch(const BatchOptions& options,
                                const std::function<void(const BatchProgress&)>& progress) {
  auto given = read_given(options);
  if (!given) return given.diagnostics;
  if (auto objection = overlap(options, given->assignment); !objection.empty()) return objection;
  const auto refuse = [&](std::string message) {
    return Diagnostics{{options.out.string(), 0, 0, "", std::move(message)}};
  };
  if (is_foreign(options.out)) return refuse("is not empty, and it is no folder of results; give another one");
  // What is in the folder is looked at only when nobody else can change it any more.
  const FolderLock lock(options.out, options.out / ".work");
  if (!lock.held()) return refuse("another run is at work in this folder");
  const Folder folder(options);
  const Manifest wanted = manifest_of(options, given->assignment, given->secret, folder.now());
  if (auto objection = folder.objection(wanted); !objection.empty()) return objection;
  if (folder.is_finished()) {
    lock.clear_work();
    auto summary = read_summary(options.out);
    if (!summary) return refuse("has no summary.json that can be read; --fresh grades anew");
    summary->was_finished = true;
    return std::move(*summary);
  }
  std::unique_ptr<SubmissionSource> source;
  if (!folder.goes_on() || options.submissions == "-") {
    auto opened = open_source(options.submissions);
    if (!opened) return opened.diagnostics;
    source = std::move(*opened);
  }
  if (folder.goes_on()) {
    if (source)
      if (auto objection = folder.objection(*std::exchange(source, nullptr)); !objection.empty()) return objection;
  } else {
    source = std::make_unique<BegunSource>(std::move(source));
    if (!source->failure().empty()) return Diagnostics{{options.submissions, 0, 0, "", source->failure()}};
    folder.begin(wanted, lock);
  }
  auto summary = work_on(options, std::move(*given), folder, wanted.now, std::move(source), progress);
  if (!summary) return summary;
  folder.finish(wanted, lock);
  summary->resumed = folder.goes_on();
  return summary;
}

}  // namespace blossom
