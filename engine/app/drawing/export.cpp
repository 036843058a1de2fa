// blossom export: lessons as pages, films, handouts and pictures.

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "app/export_options.hpp"
#include "app/progress.hpp"
#include "base/json.hpp"
#include "base/text_file.hpp"
#include "export/html_course.hpp"
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
  std::optional<CoursePage> page;      // for the list of a course
  std::size_t steps = 0, foreign = 0;  // those in another language than the lesson
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
    job.page = course_page(*story, job.name);
    job.steps = story->step_count();
    job.foreign = story->foreign_count();
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

// "22-de-boor, 44-conics and 3 more".
std::string names_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i > 0 ? ", " : "") + printable(names[i]);
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

// What is to be said, once, with the lessons that it is about.
void print_notes(const std::vector<Job>& jobs, const std::string& language) {
  std::vector<std::string> notes;
  std::map<std::string, std::vector<std::string>> lessons;  // of each note
  std::size_t steps = 0, foreign = 0;
  for (const Job& job : jobs) {
    if (job.foreign > 0) steps += job.steps;
    foreign += job.foreign;
    for (const LessonExported& exported : job.exported) {
      for (const std::string& note : exported.notes) {
        std::vector<std::string>& names = lessons[note];
        if (names.empty()) notes.push_back(note);
        if (names.empty() || names.back() != job.name) names.push_back(job.name);
      }
    }
  }
  for (const std::string& note : notes)
    std::cout << (lessons[note].size() < jobs.size() ? names_of(lessons[note]) + ": " : "") << note << "\n";
  if (foreign > 0)
    std::cout << foreign << " of " << steps << " steps are not told in "
              << (language.empty() ? std::string("the lesson's language") : printable(language))
              << ": where a lesson says nothing, the algorithm's English words stand\n";
}

void print_summary(const std::vector<Job>& jobs, const fs::path& list) {
  std::uintmax_t total = 0;
  std::size_t count = 0;
  for (const Job& job : jobs) {
    for (const LessonExported& exported : job.exported) {
      std::cout << summary_of(exported, total) << "\n";
      ++count;
    }
  }
  if (!list.empty()) std::cout << summary_of({{list}, {}}, total) << ", the list of the pages\n";
  if (count > 1) std::cout << "in all " << size_text(total) << "\n";
}

// The list of a course's pages, where it was all written. Its name; empty: there is none.
Checked<fs::path> write_list(const std::vector<Job>& jobs, const ExportRequest& request) {
  const std::string name = "index";
  const bool any =
      std::ranges::any_of(request.formats, [](const LessonFormat* format) { return format->id == "html"; });
  if (!request.all || !any) return fs::path();
  std::vector<CoursePage> pages;
  for (const Job& job : jobs) {
    if (job.name == name) return fs::path();  // a lesson's own page
    if (job.page) pages.push_back(*job.page);
  }
  const fs::path file = request.out / (name + ".html");
  if (const auto written = write_file(file, html_course(pages, request.options.theme->name)); !written)
    return written.diagnostics;
  return file;
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

// The titles of what a lesson names.
std::shared_ptr<const CourseTitles> titles_for(const fs::path& lesson, bool pages) {
  return std::make_shared<const CourseTitles>(lesson, CourseFolders{find_folder("lessons"), find_folder("exercises")},
                                              pages);
}

Checked<std::vector<Job>> one_job(const ExportOptions& typed, const ExportRequest& request) {
  auto loaded = load_subject(typed.subject);
  if (!loaded) return loaded.diagnostics;
  const auto subject = std::make_shared<const Subject>(*std::move(loaded));
  StoryOptions options = story_options(typed, request);
  if (!typed.subject.scene.empty()) options.scene = subject->scene;
  const auto titles = titles_for(subject->document.name(), false);
  options.titles = titles.get();
  Job job;
  job.name = subject->lesson ? fs::path(subject->document.name()).stem().string() : std::string(subject->algorithm->id);
  if (subject->document.name() == file_title("-") && subject->lesson) job.name = subject->lesson->id;
  job.prepare = [subject, options, titles, &request]() -> Checked<Story> {
    if (subject->lesson) return with_steps(make_story(*subject->lesson, options), request);
    auto story = make_story(*subject->algorithm, subject->inputs, options);
    if (story) return with_steps(std::move(story), request);
    Diagnostics diagnostics;
    report_at(Cursor(subject->document, diagnostics), story.diagnostics);
    return diagnostics;
  };
  return std::vector<Job>{std::move(job)};
}

// Of a language that no lesson has, nothing is exported; of one that some lack, that is said.
void check_language(const Catalog& catalog, const std::string& language) {
  std::set<std::string> known;
  std::size_t without = 0;
  for (const auto& [file, lesson] : catalog.lessons) {
    const auto& others = lesson.languages.others;
    known.insert(lesson.languages.own);
    known.insert(others.begin(), others.end());
    if (lesson.languages.own != language && std::ranges::find(others, language) == others.end()) ++without;
  }
  if (without == 0) return;
  if (without == catalog.lessons.size()) {
    std::string names;
    for (const std::string& each : known) names += (names.empty() ? "" : ", ") + each;
    throw CLI::ValidationError("--language", excerpt(language) + " is no language of any lesson; they are in " + names);
  }
  std::cout << without << " of " << catalog.lessons.size() << " lessons are not in " << printable(language)
            << " and are written in their own language\n";
}

Checked<std::vector<Job>> all_jobs(const ExportOptions& typed, const ExportRequest& request) {
  auto catalog = std::make_shared<Catalog>(load_catalog(find_folder("lessons")));
  if (!catalog->diagnostics.empty()) return catalog->diagnostics;
  if (const std::string& language = typed.subject.language; !language.empty()) check_language(*catalog, language);
  if (catalog->lessons.empty()) return std::vector<Job>();
  const auto titles = titles_for(catalog->lessons.front().file, true);
  StoryOptions options = story_options(typed, request);
  options.titles = titles.get();
  std::vector<Job> jobs;
  for (const CatalogEntry& entry : catalog->lessons) {
    Job job;
    job.name = entry.file.stem().string();
    job.prepare = [catalog, titles, &entry, &request, options] {
      return with_steps(make_story(entry.lesson, options), request);
    };
    jobs.push_back(std::move(job));
  }
  return jobs;
}

int run(const CLI::App& app, const ExportOptions& typed) {
  Diagnostics mistakes;
  const ExportRequest request = read_export_options(app, typed, mistakes);
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
    Checked<fs::path> list = fs::path();
    if (status == done && stop_signal == 0) list = write_list(exporter.jobs(), request);
    print_summary(exporter.jobs(), list ? *list : fs::path());
    print_notes(exporter.jobs(), typed.subject.language);
    if (stop_signal == 0) report(exporter.diagnostics());
    if (!list) {
      report(list.diagnostics);
      status = machine_at_fault;
    }
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
  app.callback([&app, options, &status] { status = run(app, *options); });
}

}  // namespace

const Command& command_export() {
  static const Command command{"export", "Write lessons as web pages, films, handouts, pictures", 32, set_up};
  return command;
}

}  // namespace blossom
