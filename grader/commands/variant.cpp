// blossom-grade variant: each student's own numbers, as files and on paper.

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "grader/command.hpp"
#include "grader/result.hpp"
#include "grader/roster.hpp"
#include "grader/variant.hpp"
#include "grader/variant_sheet.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr const char* manual = R"(Examples:
  blossom-grade variant exercises/11-own-de-casteljau.json --student s17 --secret-file course.secret
      The exercise with the numbers of s17, on standard output.
  blossom-grade variant exercises/11-own-de-casteljau.json --roster roster.csv --secret-file course.secret --out own
      own/s17.json and so on, one file for each student, and own/sheet.html, a page for each to print; of a class above
      1000, own/sheet-1.html, own/sheet-2.html, ... Says how many of the exercises differ: where the file leaves little
      to choose from, several students have the same numbers.
  ... --answers
      And own/solutions.html, for the instructor.

The numbers are a function of the exercise, the ID and the secret: grading makes them again, so nothing but the ID has
to be kept. Make the secret once for a course, such as with `openssl rand -hex 32 > course.secret`, and keep it from
students: whoever has it can make anybody's exercise.

Exit status: 0 done; 1 the exercise, the roster or the secret is at fault; 2 wrong usage; 3 a file cannot be written.)";

constexpr std::size_t most_pages = 1000;  // of a file

struct Given {
  std::string exercise, student, roster, secret_file, out;
  bool answers = false;
};

int complain(const Diagnostics& diagnostics, int status = input_at_fault) {
  std::fputs(to_string(diagnostics).c_str(), stderr);
  return status;
}

int make_one(const Given& given, const JsonDocument& exercise, const std::string& secret) {
  const auto variant = make_variant(exercise, given.student, secret);
  if (!variant) return complain(variant.diagnostics);
  if (!given.out.empty()) {
    const auto written = write_file(given.out, variant->text());
    return written ? done : complain(written.diagnostics, machine_at_fault);
  }
  const std::string& text = variant->text();
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return done;
  std::fputs("blossom-grade: the output cannot be written\n", stderr);
  return machine_at_fault;
}

// How far it is, on a terminal, a few times a second.
class Progress {
 public:
  explicit Progress(std::size_t all) : all_(all), seen_(isatty(STDERR_FILENO) == 1) {}
  ~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(std::size_t count) {
    const auto now = std::chrono::steady_clock::now();
    if (!seen_ || now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r%zu of %zu students", count, all_);
    std::fflush(stderr);
  }

 private:
  std::size_t all_;
  bool seen_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// The printed pages of one kind, written whenever a file of them is full.
class Sheets {
 public:
  Sheets(fs::path folder, std::string name, std::string title, bool solutions, std::size_t students)
      : folder_(std::move(folder)),
        name_(std::move(name)),
        title_(std::move(title)),
        solutions_(solutions),
        several_(students > most_pages) {}

  Checked<bool> add(const Exercise& variant, const Student& student, Sharing sharing) {
    if (pages_ == 0) text_ = sheet_head(title_);
    text_ += sheet_page(variant, student, solutions_, sharing);
    return ++pages_ == most_pages ? write() : Checked<bool>(true);
  }

  Checked<bool> write() {
    if (pages_ == 0) return true;
    pages_ = 0;
    ++files_;
    text_ += sheet_end();
    return write_file(folder_ / (name_ + (several_ ? "-" + std::to_string(files_) : "") + ".html"), text_);
  }

 private:
  fs::path folder_;
  std::string name_, title_;
  bool solutions_, several_;
  std::string text_;
  std::size_t pages_ = 0, files_ = 0;
};

// The files of a class's exercises, by student in the order of the roster, and how many of them are the same.
struct Drawn {
  std::vector<std::optional<std::string>> texts;  // nothing: there was no variant to be found
  std::unordered_map<std::string_view, std::size_t> times;

  Sharing sharing(const std::string& text) const {
    if (times.size() == 1 && texts.size() > 1) return Sharing::everybody;
    return times.at(text) == 1 ? Sharing::nobody_else : Sharing::some;
  }
};

// What there is to know before the sheets are given out.
void tell(const Drawn& drawn) {
  std::size_t students = 0;
  for (const auto& [text, times] : drawn.times) students += times;
  const std::size_t variants = drawn.times.size();
  std::printf("%zu student%s, %zu different variant%s%s\n", students, students == 1 ? "" : "s", variants,
              variants == 1 ? "" : "s", variants < students ? ": some have the same numbers" : "");
}

int make_all(const Given& given, const JsonDocument& document, const Exercise& exercise, const std::string& secret) {
  const auto roster = Roster::load(given.roster);
  if (!roster) return complain(roster.diagnostics);
  const fs::path folder(given.out);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return complain({{given.out, 0, 0, "", "cannot be made: " + error.message()}}, machine_at_fault);
  std::optional<VariantMaker> maker;
  if (varies(document)) maker.emplace(document);
  int status = done;
  Drawn drawn;
  {
    Progress progress(roster->size());
    for (std::size_t i = 0; i < roster->size(); ++i) {
      progress.at(i);
      const std::string id = roster->student(i).id;
      const auto variant = maker ? maker->make(id, secret) : Checked<JsonDocument>(document);
      if (!variant) status = complain(variant.diagnostics);
      drawn.texts.push_back(variant ? std::optional(variant->text()) : std::nullopt);
    }
  }
  for (const auto& text : drawn.texts)
    if (text) ++drawn.times[*text];
  std::vector<Sheets> sheets;
  sheets.emplace_back(folder, "sheet", exercise.title, false, roster->size());
  if (given.answers) sheets.emplace_back(folder, "solutions", "Solutions: " + exercise.title, true, roster->size());
  for (std::size_t i = 0; i < roster->size(); ++i) {
    if (!drawn.texts[i]) continue;
    const Student student = roster->student(i);
    const std::string& text = *drawn.texts[i];
    const std::string file = (folder / (file_name_of(student.id) + ".json")).string();
    const auto written = write_file(file, text);
    if (!written) return complain(written.diagnostics, machine_at_fault);
    const auto read = read_exercise(*JsonDocument::parse(file, text));
    for (Sheets& sheet : sheets)
      if (const auto added = sheet.add(*read, student, drawn.sharing(text)); !added)
        return complain(added.diagnostics, machine_at_fault);
  }
  for (Sheets& sheet : sheets)
    if (const auto last = sheet.write(); !last) return complain(last.diagnostics, machine_at_fault);
  if (maker) tell(drawn);
  return status;
}

int make(const Given& given) {
  const auto document = JsonDocument::load(given.exercise);
  if (!document) return complain(document.diagnostics);
  const auto exercise = read_exercise(*document);
  if (!exercise) return complain(exercise.diagnostics);
  const auto secret = load_secret(given.secret_file);
  if (!secret) return complain(secret.diagnostics);
  if (!varies(*document))
    std::fprintf(stderr, "blossom-grade: nothing varies in %s: everybody has the same numbers\n",
                 printable(given.exercise).c_str());
  return given.roster.empty() ? make_one(given, *document, *secret) : make_all(given, *document, *exercise, *secret);
}

void set_up(CLI::App& app, int& status) {
  auto given = std::make_shared<Given>();
  app.add_option("exercise", given->exercise, "the exercise, a JSON file (schema blossom.exercise/1) with \"vary\"")
      ->required()
      ->option_text("EXERCISE");
  auto* student = app.add_option("--student", given->student, "whose exercise")->option_text("ID");
  auto* roster = app.add_option("--roster", given->roster, "the class: an exercise for each, CSV with a column id")
                     ->option_text("FILE")
                     ->excludes(student);
  app.add_option("--secret-file", given->secret_file, "the course's secret, 16 to 4096 bytes")
      ->required()
      ->option_text("FILE");
  auto* out = app.add_option("--out", given->out,
                             "the file to write instead of standard output; with --roster, the folder (made if needed)")
                  ->option_text("FILE");
  roster->needs(out);
  app.add_flag("--answers", given->answers, "with --roster, the solutions too, on sheets of their own")->needs(roster);
  app.footer(manual);
  app.callback([given, student, roster, &status] {
    if (student->count() + roster->count() == 0) throw CLI::RequiredError("--student or --roster");
    status = make(*given);
  });
}

}  // namespace

const GradeCommand& command_variant() {
  static const GradeCommand command{"variant", "Make each student's own exercise", 40, set_up};
  return command;
}

}  // namespace blossom
