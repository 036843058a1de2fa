#include "grader/batch/collate.hpp"

#include <fstream>

#include "base/json_write.hpp"
#include "grader/batch/output.hpp"
#include "grader/csv.hpp"
#include "grader/page/class_page.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// A line of results.jsonl may be long: its answers are a student's.
constexpr JsonLimits result_limits{64u << 20, 64, 4'000'000};

std::string course_file(const ReportFormat& format) {
  return "gradebook." + std::string(format.name) + "." + std::string(format.extension);
}

// The files that grow portion by portion, and what of them is to be moved to its place.
class Books {
 public:
  Books(const Collation& collation, const fs::path& folder)
      : results_(folder / "results.jsonl"), incidents_(folder / "incidents.csv") {
    incidents_.write(incident_header());
    for (const ReportFormat* format : collation.options->formats) {
      if (format->scope != ReportFormat::Scope::course) continue;
      std::string out;
      Book& book = books_.emplace_back();
      book.report = format->open(collation.context);
      book.file = std::make_unique<OutputFile>(folder / course_file(*format));
      book.report->begin(out);
      book.file->write(out);
    }
  }

  void add(const PortionContent& portion) {
    results_.write(portion.results);
    incidents_.write(portion.incidents);
    for (std::size_t i = 0; i < books_.size() && i < portion.rows.size(); ++i) books_[i].file->write(portion.rows[i]);
  }

  void finish(const fs::path& strays) {
    std::ifstream in(strays, std::ios::binary);
    std::string chunk(64u << 10, '\0');
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0)
      incidents_.write(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
    results_.close();
    incidents_.close();
    for (Book& book : books_) {
      std::string out;
      book.report->finish(out);
      book.file->write(out);
      book.file->close();
    }
  }

 private:
  struct Book {
    std::unique_ptr<Report> report;
    std::unique_ptr<OutputFile> file;
  };
  OutputFile results_;
  OutputFile incidents_;
  std::vector<Book> books_;
};

void count(ClassStatistics& statistics, const PortionContent& portion, const StudentFiles* pages) {
  for (std::size_t begin = 0; begin < portion.results.size();) {
    const std::size_t end = portion.results.find('\n', begin);
    const auto line = JsonDocument::parse("results.jsonl", portion.results.substr(begin, end - begin), result_limits);
    begin = end + 1;
    if (!line) throw std::runtime_error("a line of results is no JSON: " + to_string(line.diagnostics));
    const Json* student = line->root().find("student");
    const Json* id = student != nullptr ? student->find("id") : nullptr;
    statistics.add(line->root(), pages != nullptr && id != nullptr ? pages->path("students", id->text, "html") : "");
  }
}

// What is nobody's; of more than a page lists, the rows are counted.
void count_strays(ClassStatistics& statistics, const fs::path& strays) {
  std::ifstream in(strays, std::ios::binary);
  CsvReader reader(strays.filename().string(), in, {}, ',');
  std::vector<std::string> cells;
  while (reader.next(cells))
    if (cells.size() == 5) statistics.add_stray(cells[1], cells[0], cells[3], cells[4]);
}

std::string write_summary(const Collation& collation, const BatchSummary& summary, const std::string& figures) {
  const Assignment& assignment = *collation.assignment;
  std::string text = "{\n  \"schema\": \"blossom.summary/1\",\n  \"assignment\": " + json_quote(assignment.id) +
                     ",\n  \"title\": " + json_quote(assignment.title) +
                     ",\n  \"now\": " + json_quote(format_time(collation.now)) +
                     ",\n  \"students\": " + std::to_string(summary.students) +
                     ",\n  \"submissions\": " + std::to_string(summary.submissions) +
                     ",\n  \"mean_score\": " + format_number(summary.mean_score) + ",\n  \"incidents\": {";
  for (std::size_t i = 0; i < incident_kinds; ++i)
    text += (i > 0 ? ", \"" : "\"") + std::string(incident_name(static_cast<Incident::Kind>(i))) +
            "\": " + std::to_string(summary.incidents[i]);
  return text + "},\n  \"class\": " + figures + "\n}\n";
}

}  // namespace

BatchSummary collate(const Collation& collation, const fs::path& work,
                     const std::function<void(const BatchProgress&)>& progress) {
  const BatchOptions& options = *collation.options;
  const fs::path folder = work / "out";
  fs::remove_all(folder);
  make_folder(folder / "class");
  BatchSummary summary;
  summary.submissions = collation.intake.submissions;
  summary.incidents = collation.intake.strays;

  const auto write = [&](const fs::path& name, std::string_view content) {
    make_folder((folder / name).parent_path());
    OutputFile file(folder / name);
    file.write(content);
    file.close();
  };
  const StudentFiles files(collation.students);
  const bool pages = options.pages && options.student_files;
  Books books(collation, folder);
  ClassStatistics statistics(collation.assignment->title, write, collation.assignment);
  double score = 0;
  for (std::uint64_t number = 0; number * portion_size < collation.students; ++number) {
    const PortionContent portion = read_portion(portion_file(work, number));
    books.add(portion);
    count(statistics, portion, pages ? &files : nullptr);
    summary.students += portion.students;
    score += portion.score;
    for (std::size_t i = 0; i < incident_kinds; ++i) summary.incidents[i] += portion.counts[i];
    progress({"writing", summary.students, collation.students, "students"});
  }
  books.finish(work / "strays.csv");
  summary.mean_score = summary.students > 0 ? score / static_cast<double>(summary.students) : 0;

  count_strays(statistics, work / "strays.csv");
  statistics.finish();
  write("summary.json", write_summary(collation, summary, statistics.json()));
  const auto assignment = JsonDocument::load(options.assignment);
  if (assignment) write("assignment.json", write_assignment(*collation.assignment, *assignment));
  if (options.roster) fs::copy_file(*options.roster, folder / "roster.csv");
  if (options.keep_submissions) {
    // It stays here, too, under a second name: what comes now may be interrupted and done again.
    std::error_code no_links;
    fs::create_hard_link(work / "submissions.jsonl", folder / "submissions.jsonl", no_links);
    if (no_links) fs::copy_file(work / "submissions.jsonl", folder / "submissions.jsonl");
  }

  fs::remove_all(options.out / "class");
  if (fs::is_empty(folder / "class")) fs::remove(folder / "class");
  const std::vector<fs::path> made{fs::directory_iterator(folder), {}};
  for (const fs::path& path : made) move_file(path, options.out / path.filename());
  return summary;
}

std::optional<BatchSummary> read_summary(const fs::path& out) {
  const auto document = JsonDocument::load(out / "summary.json");
  if (!document) return std::nullopt;
  const Json& root = document->root();
  const auto number = [](const Json* at) {
    const auto parsed = at != nullptr && at->kind == Json::Kind::number ? Exact::parse(at->text) : std::nullopt;
    return parsed ? parsed->to_double() : 0;
  };
  BatchSummary summary;
  summary.students = static_cast<std::uint64_t>(number(root.find("students")));
  summary.submissions = static_cast<std::uint64_t>(number(root.find("submissions")));
  summary.mean_score = number(root.find("mean_score"));
  if (const Json* incidents = root.find("incidents"); incidents != nullptr && incidents->kind == Json::Kind::object)
    for (std::size_t i = 0; i < incident_kinds; ++i)
      summary.incidents[i] =
          static_cast<std::uint64_t>(number(incidents->find(incident_name(static_cast<Incident::Kind>(i)))));
  return summary;
}

std::string write_assignment(const Assignment& assignment, const JsonDocument& file) {
  std::vector<std::pair<std::string, Json>> members;
  members.emplace_back("schema", json_string("blossom.assignment/1"));
  members.emplace_back("id", json_string(assignment.id));
  members.emplace_back("title", json_string(assignment.title));
  std::vector<Json> exercises;
  for (const Assignment::Item& item : assignment.items) {
    std::vector<std::pair<std::string, Json>> exercise;
    exercise.emplace_back("exercise", item.document.root());
    exercise.emplace_back("points", json_number(item.points));
    exercises.push_back(json_object(std::move(exercise)));
  }
  members.emplace_back("exercises", json_array(std::move(exercises)));
  // The rest as it was written, unless the file is an exercise alone.
  if (file.root().find("exercises") != nullptr)
    for (const auto* key : {"due", "late", "attempts", "feedback", "full_feedback_from", "lms_id", "source"})
      if (const Json* member = file.root().find(key)) members.emplace_back(key, *member);
  return write_json(json_object(std::move(members))) + "\n";
}

}  // namespace blossom
