#include "grader/batch/grading.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "grader/batch/output.hpp"
#include "grader/digest.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// What one student may hand in; beyond that a submission is refused.
constexpr std::size_t most_submissions = 1000;
constexpr std::size_t most_bytes = 8u << 20;
// So many of one student's submissions are tried alone after the grader failed on one.
constexpr std::size_t most_killers = 4;

constexpr std::string_view end_mark = "end of portion\n";

bool is_finished(const fs::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in || in.tellg() < static_cast<std::streamoff>(end_mark.size())) return false;
  in.seekg(-static_cast<std::streamoff>(end_mark.size()), std::ios::end);
  std::string tail(end_mark.size(), '\0');
  return in.read(tail.data(), static_cast<std::streamsize>(tail.size())) && tail == end_mark;
}

}  // namespace

std::string StudentFiles::path(std::string_view folder, std::string_view id, std::string_view extension) const {
  std::string path(folder);
  path += '/';
  if (spread_) path += sha256_hex(id).substr(0, 2) + "/";
  return path + file_name_of(id) + "." + std::string(extension);
}

void StudentFiles::make_folders(const fs::path& out, std::string_view folder) const {
  make_folder(out / folder);
  if (!spread_) return;
  for (int i = 0; i < 256; ++i) {
    char name[3];
    std::snprintf(name, sizeof name, "%02x", static_cast<unsigned>(i));
    make_folder(out / folder / name);
  }
}

fs::path portion_file(const fs::path& work, std::uint64_t number) { return work / "portions" / std::to_string(number); }

PortionContent read_portion(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  ByteReader reader(bytes);
  PortionContent content;
  content.students = reader.number<std::uint64_t>();
  content.results = reader.text();
  content.incidents = reader.text();
  for (auto n = reader.number<std::uint64_t>(); n > 0; --n) content.rows.emplace_back(reader.text());
  content.score = reader.number<double>();
  for (std::uint64_t& count : content.counts) count = reader.number<std::uint64_t>();
  return content;
}

Grading::Grading(const BatchOptions& options, const ClassList& list, const SpoolReader& spool, fs::path work)
    : options_(&options), list_(&list), spool_(&spool), work_(std::move(work)), files_(list.size()) {
  for (const ReportFormat* format : options.formats)
    if (format->scope == ReportFormat::Scope::student) of_student_.push_back(format);
  make_folder(work_ / "portions");
  if (options.student_files) files_.make_folders(options.out, "students");
  for (const ReportFormat* format : of_student_) files_.make_folders(options.out, format->name);
}

Checked<bool> Grading::run(Workers& workers, const std::function<void(const BatchProgress&)>& progress) {
  const auto take = [&](std::string_view item, std::string_view bytes, const Lost* lost) {
    if (lost != nullptr)
      lost_.push_back({read_work_item(item), lost->text});
    else
      answer(item, read_work_answer(bytes));
    progress({"grading", done_, list_->size(), "students"});
  };
  // While somebody's submission is looked for that the grader failed on, nothing else is begun: what is finished but
  // for them must not pile up.
  bool more = true;
  while (more) {
    workers.run([&](std::string& item) { return lost_.empty() && torn_.empty() && (more = next(item)); }, take);
    if (!torn_.empty()) return torn_;
    for (; !lost_.empty(); lost_.pop_front()) settle(workers, std::move(lost_.front()));
  }
  return true;
}

bool Grading::next(std::string& item) {
  skip_finished();
  if (next_ == list_->size()) return false;
  if (next_ % portion_size == 0) {
    Portion& portion = open_.emplace_back();
    portion.number = next_ / portion_size;
    portion.left = static_cast<std::size_t>(std::min(portion_size, list_->size() - next_));
    portion.answers.resize(portion.left);
  }
  item = to_bytes(next_student());
  return torn_.empty();
}

void Grading::skip_finished() {
  while (next_ < list_->size() && next_ % portion_size == 0 && is_finished(portion_file(work_, next_ / portion_size))) {
    next_ = std::min(next_ + portion_size, list_->size());
    done_ = std::max(done_, next_);
  }
}

WorkItem Grading::next_student() {
  WorkItem item;
  item.index = next_;
  item.student = list_->student(next_);
  if (next_ / spool_->part_size() != part_) open_part(next_ / spool_->part_size());
  while (fetched_ && *fetched_ < next_) fetch();
  std::size_t bytes = 0, refused = 0;
  for (; fetched_ && *fetched_ == next_; fetch()) {
    bytes += record_.size();
    if (item.handed.size() < most_submissions && bytes <= most_bytes)
      item.handed.push_back(std::move(record_));
    else
      ++refused;
  }
  if (refused > 0)
    item.incidents.push_back({Incident::Kind::refused,
                              {},
                              {},
                              std::to_string(refused) + " more submissions of this student were not read: at most " +
                                  std::to_string(most_submissions) + " are, of " + std::to_string(most_bytes >> 20) +
                                  " MiB in all"});
  ++next_;
  return item;
}

void Grading::open_part(std::uint64_t part) {
  part_ = part;
  fetched_.reset();
  auto walk = spool_->walk(static_cast<std::size_t>(part));
  torn_ = walk.diagnostics;
  if (!walk) return;
  walk_ = std::move(*walk);
  fetch();
}

void Grading::fetch() {
  std::uint64_t student = 0;
  fetched_.reset();
  if (walk_->next(student, record_))
    fetched_ = student;
  else if (!walk_->failure().empty())
    torn_ = {{(work_ / "spool").string(), 0, 0, "", walk_->failure()}};
}

void Grading::answer(std::string_view item, WorkAnswer answer) {
  const auto [index, id] = whose_work_item(item);
  if (options_->student_files) {
    place_file(work_, options_->out / files_.path("students", id, "json"), answer.for_student);
    if (options_->pages && !answer.page.empty())
      place_file(work_, options_->out / files_.path("students", id, "html"), answer.page);
  }
  for (std::size_t i = 0; i < of_student_.size(); ++i)
    place_file(work_, options_->out / files_.path(of_student_[i]->name, id, of_student_[i]->extension),
               answer.documents[i]);
  answer.for_student = answer.page = {};
  answer.documents = {};

  const auto portion = std::ranges::find(open_, index / portion_size, &Portion::number);
  portion->answers[index % portion_size] = std::move(answer);
  ++done_;
  if (--portion->left > 0) return;
  finish(*portion);
  open_.erase(portion);
}

void Grading::finish(Portion& portion) {
  PortionContent content;
  content.students = portion.answers.size();
  for (const auto& answer : portion.answers) {
    content.results += answer->result;
    content.incidents += answer->incidents;
    content.rows.resize(answer->rows.size());
    for (std::size_t i = 0; i < answer->rows.size(); ++i) content.rows[i] += answer->rows[i];
    content.score += answer->score;
    for (std::size_t i = 0; i < incident_kinds; ++i) content.counts[i] += answer->counts[i];
  }
  std::string bytes;
  ByteWriter out(bytes);
  out.number(content.students);
  out.text(content.results);
  out.text(content.incidents);
  out.number(static_cast<std::uint64_t>(content.rows.size()));
  for (const std::string& rows : content.rows) out.text(rows);
  out.number(content.score);
  for (const std::uint64_t count : content.counts) out.number(count);
  bytes += end_mark;
  place_file(work_, portion_file(work_, portion.number), bytes);
}

// The grader failed on one of somebody's submissions: each is tried alone to find out which, so that only that one is
// lost. Should they do harm only together, all are.
void Grading::settle(Workers& workers, LostItem lost) {
  const WorkItem& whole = lost.item;
  std::optional<std::string> failure;
  std::optional<WorkAnswer> answered;
  const auto ask = [&](const WorkItem& item) {
    bool given = false;
    failure.reset();
    answered.reset();
    workers.run([&](std::string& bytes) { return !std::exchange(given, true) && (bytes = to_bytes(item), true); },
                [&](std::string_view, std::string_view bytes, const Lost* again) {
                  if (again != nullptr)
                    failure = again->text;
                  else
                    answered = read_work_answer(bytes);
                });
    return !failure;
  };
  const auto failed = [](const std::string& record, const std::string& text) {
    ByteReader in(record);
    return Incident{Incident::Kind::failed, {}, read_handed(in).submission.source, text};
  };

  WorkItem good = whole;
  good.handed.clear();
  std::size_t killers = 0;
  for (const std::string& record : whole.handed) {
    WorkItem alone = whole;
    alone.handed = {record};
    if (killers == most_killers)
      good.incidents.push_back(failed(record, "not graded: the grader failed on others of this student"));
    else if (whole.handed.size() > 1 && ask(alone))
      good.handed.push_back(record);
    else {
      ++killers;
      good.incidents.push_back(failed(record, failure.value_or(lost.text)));
    }
  }
  if (!ask(good)) {
    for (const std::string& record : good.handed) good.incidents.push_back(failed(record, *failure));
    good.handed.clear();
    good.with_page = false;
    if (!ask(good)) throw std::runtime_error("the grader fails even on nothing: " + *failure);
  }
  answer(to_bytes(whole), std::move(*answered));
}

}  // namespace blossom
