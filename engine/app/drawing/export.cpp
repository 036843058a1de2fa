// blossom export: lessons as pages, films, handouts and pictures.

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <iostream>
#include <mutex>
#include <thread>

#include "app/export_options.hpp"
#include "app/progress.hpp"
#include "base/text_file.hpp"
#include "lesson/catalog.hpp"
#include "render/lesson_theme.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

volatile sig_atomic_t stop_signal = 0;
void remember(int signal) { stop_signal = signal; }

// While it lives, Ctrl+C and the like only ask to stop.
class Stoppable {
 public:
  Stoppable() {
    struct sigaction action {};
    action.sa_handler = remember;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      sigaction(signals[i], &action, &before_[i]);
      if (before_[i].sa_handler == SIG_IGN) sigaction(signals[i], &before_[i], nullptr);  // as nohup has it
    }
  }
  ~Stoppable() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  }

 private:
  static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> before_{};
};

// The folders above a file, made where they are missing, and taken away if nothing comes into them.
class Folders {
 public:
  explicit Folders(const fs::path& file) {
    std::error_code error;  // is told by whoever writes the file
    for (fs::path at = file.parent_path(); !at.empty() && !fs::exists(at, error); at = at.parent_path())
      made_.push_back(at);
    if (!made_.empty()) fs::create_directories(made_.front(), error);
  }
  ~Folders() {
    for (const fs::path& folder : made_) ::rmdir(folder.c_str());  // those that are empty, the innermost first
  }
  Folders(const Folders&) = delete;

 private:
  std::vector<fs::path> made_;
};

// One lesson, or one run of an algorithm, in all the formats that are asked for.
struct Job {
  std::string name;                         // of its files
  std::function<Checked<Story>()> prepare;  // diagnostics: the input is at fault
  std::vector<std::size_t> shares;          // of each format what is done, of 1000
  std::vector<LessonExported> exported;
};

constexpr std::size_t whole_share = 1000;

class Exporter {
 public:
  Exporter(const ExportRequest& request, std::vector<Job> jobs)
      : request_(request),
        jobs_(std::move(jobs)),
        progress_(request.progress_lines ? Progress::Form::lines : Progress::Form::bar) {
    for (Job& job : jobs_) job.shares.assign(request.formats.size(), 0);
  }

  // The lessons beside each other, on all cores.
  int run() {
    std::vector<std::thread> others;
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(cores, jobs_.size()); ++i) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    progress_.clear();
    return status_;
  }

  const std::vector<Job>& jobs() const { return jobs_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  void work() {
    for (;;) {
      const std::size_t next = next_++;
      if (next >= jobs_.size() || stop_signal != 0) return;
      try {
        write(jobs_[next]);
      } catch (const std::exception& error) {  // out of memory, out of threads
        fail({{"", 0, 0, "", error.what()}}, machine_at_fault);
      }
    }
  }

  void write(Job& job) {
    const auto story = job.prepare();
    if (!story) return fail(story.diagnostics, input_at_fault);
    const Theme theme = with_colors(*request_.options.theme, story->colors);
    for (std::size_t i = 0; i < request_.formats.size() && stop_signal == 0; ++i) {
      LessonExportOptions options = request_.options;
      options.theme = &theme;
      options.progress = [&, i](std::size_t done, std::size_t of) { return tell(job, i, done, of); };
      const LessonFormat& format = *request_.formats[i];
      const fs::path place = request_.place(format, job.name);
      const Folders folders(place);
      auto exported = format.write(*story, place, options);
      if (!exported) {
        const bool usage =
            std::ranges::any_of(exported.diagnostics, [](const Diagnostic& d) { return d.path.starts_with("--"); });
        return fail(exported.diagnostics, usage ? wrong_usage : machine_at_fault);
      }
      job.exported.push_back(*std::move(exported));
      if (jobs_.size() > 1 || request_.formats.size() > 1) tell(job, i, 1, 1);  // even if it told nothing itself
    }
  }

  bool tell(Job& job, std::size_t format, std::size_t done, std::size_t of) {
    if (jobs_.size() == 1 && request_.formats.size() == 1) {
      progress_.show(done, of);
    } else {
      const std::lock_guard lock(mutex_);
      done_ -= job.shares[format];
      done_ += job.shares[format] = of > 0 ? whole_share * done / of : 0;
      progress_.show(done_, whole_share * jobs_.size() * request_.formats.size());
    }
    return stop_signal == 0;
  }

  // What is the same for all lessons, an encoder that is missing, is told once.
  void fail(const Diagnostics& diagnostics, int status) {
    const std::lock_guard lock(mutex_);
    for (const Diagnostic& d : diagnostics)
      if (std::ranges::none_of(diagnostics_, [&](const Diagnostic& o) { return to_string(o) == to_string(d); }))
        diagnostics_.push_back(d);
    status_ = std::max(status_, status);
  }

  const ExportRequest& request_;
  std::vector<Job> jobs_;
  Progress progress_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::size_t done_ = 0;
  Diagnostics diagnostics_;
  int status_ = done;
};

std::string size_text(std::uintmax_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (bytes < 1000) return std::to_string(bytes) + " bytes";
  return size < 999500 ? format_short(size / 1000, 0) + " kB" : format_short(size / 1e6, 1) + " MB";
}

// "de-boor.html, 312 kB", "16 files in pictures, 1.9 MB".
std::string summary_of(const LessonExported& exported, std::uintmax_t& total) {
  std::uintmax_t bytes = 0;
  std::error_code error;
  for (const fs::path& file : exported.files)
    if (const auto size = fs::file_size(file, error); !error) bytes += size;
  total += bytes;
  if (exported.files.empty()) return "nothing";
  const fs::path& first = exported.files.front();
  if (exported.files.size() == 1) return printable(first.string()) + ", " + size_text(bytes);
  const bool document = exported.files[1].parent_path() != first.parent_path();
  const std::string count = std::to_string(exported.files.size() - (document ? 1 : 0));
  if (document)
    return printable(first.string()) + " and " + count + (count == "1" ? " file in " : " files in ") +
           printable(exported.files[1].parent_path().string()) + ", " + size_text(bytes);
  const fs::path folder = first.has_parent_path() ? first.parent_path() : fs::path(".");
  return count + " files in " + printable(folder.string()) + ", " + size_text(bytes);
}

void print_summary(const std::vector<Job>& jobs) {
  std::uintmax_t total = 0;
  std::size_t count = 0;
  std::vector<std::string> notes;
  for (const Job& job : jobs) {
    for (const LessonExported& exported : job.exported) {
      std::cout << summary_of(exported, total) << "\n";
      ++count;
      for (const std::string& note : exported.notes)
        if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
    }
  }
  if (count > 1) std::cout << "in all " << size_text(total) << "\n";
  for (const std::string& note : notes) std::cout << note << "\n";
}

// Scenes without any of the steps that are asked for are left out; no step at all is a mistake.
Checked<Story> with_steps(Checked<Story> story, const ExportRequest& request) {
  if (!story) return story;
  std::uint32_t last = 0;
  for (const StoryScene& scene : story->scenes) last = std::max(last, scene.recording->last());
  std::erase_if(story->scenes, [](const StoryScene& scene) { return scene.steps.empty(); });
  if (story->scenes.empty())
    return Diagnostics{
        {"", 0, 0, "--steps",
         "begin at " + std::to_string(request.first) + ", but there are only those from 0 to " + std::to_string(last)}};
  return story;
}

StoryOptions story_options(const ExportOptions& typed, const ExportRequest& request) {
  StoryOptions options;
  options.language = typed.subject.language;
  options.first = request.first;
  options.last = request.last;
  options.exact = !typed.decimals;
  return options;
}

Checked<std::vector<Job>> one_job(const ExportOptions& typed, const ExportRequest& request) {
  auto loaded = load_subject(typed.subject);
  if (!loaded) return loaded.diagnostics;
  const auto subject = std::make_shared<const Subject>(*std::move(loaded));
  StoryOptions options = story_options(typed, request);
  if (!typed.subject.scene.empty()) options.scene = subject->scene;
  Job job;
  job.name = subject->lesson ? fs::path(subject->document.name()).stem().string() : std::string(subject->algorithm->id);
  if (subject->document.name() == file_title("-") && subject->lesson) job.name = subject->lesson->id;
  job.prepare = [subject, options, &request]() -> Checked<Story> {
    if (subject->lesson) return with_steps(make_story(*subject->lesson, options), request);
    auto story = make_story(*subject->algorithm, subject->inputs, options);
    if (story) return with_steps(std::move(story), request);
    Diagnostics diagnostics;
    report_at(Cursor(subject->document, diagnostics), story.diagnostics);
    return diagnostics;
  };
  return std::vector<Job>{std::move(job)};
}

Checked<std::vector<Job>> all_jobs(const ExportOptions& typed, const ExportRequest& request) {
  auto catalog = std::make_shared<Catalog>(load_catalog(find_folder("lessons")));
  if (!catalog->diagnostics.empty()) return catalog->diagnostics;
  std::vector<Job> jobs;
  for (const CatalogEntry& entry : catalog->lessons) {
    Job job;
    job.name = entry.file.stem().string();
    job.prepare = [catalog, &entry, &request, options = story_options(typed, request)] {
      return with_steps(make_story(entry.lesson, options), request);
    };
    jobs.push_back(std::move(job));
  }
  return jobs;
}

int run(const ExportOptions& typed) {
  Diagnostics mistakes;
  const ExportRequest request = read_export_options(typed, mistakes);
  Checked<std::vector<Job>> jobs;
  try {
    jobs = typed.all ? all_jobs(typed, request) : one_job(typed, request);
  } catch (const CLI::ParseError& error) {
    if (mistakes.empty()) throw;
    mistakes.push_back({"", 0, 0, "", error.what()});
  }
  if (!mistakes.empty()) {
    report(mistakes);
    return wrong_usage;
  }
  if (!jobs) return report(jobs.diagnostics);
  int status = done;
  {
    const Stoppable stoppable;
    Exporter exporter(request, *std::move(jobs));
    status = exporter.run();
    print_summary(exporter.jobs());
    if (stop_signal == 0) report(exporter.diagnostics());
  }
  if (stop_signal != 0) {
    std::cout.flush();
    std::cerr << "blossom: stopped; what was not finished is not written\n";
    raise(stop_signal);  // whoever started this sees that a signal ended it
  }
  return status;
}

void set_up(CLI::App& app, int& status) {
  auto options = std::make_shared<ExportOptions>();
  add_export_options(app, *options);
  app.callback([options, &status] { status = run(*options); });
}

}  // namespace

const Command& command_export() {
  static const Command command{"export", "Write lessons as web pages, films, handouts, pictures", 32, set_up};
  return command;
}

}  // namespace blossom
