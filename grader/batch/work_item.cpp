#include "grader/batch/work_item.hpp"

#include <algorithm>
#include <iterator>

#include "grader/csv.hpp"
#include "grader/page/student_page.hpp"

namespace blossom {
namespace {

void write_time(const std::optional<Time>& time, ByteWriter& out) {
  out.number(static_cast<char>(time ? 1 : 0));
  if (time) out.number(static_cast<std::int64_t>(time->time_since_epoch().count()));
}

std::optional<Time> read_time(ByteReader& in) {
  if (in.number<char>() == 0) return std::nullopt;
  return Time(std::chrono::seconds(in.number<std::int64_t>()));
}

template <class Each>
void for_each_text(Student& student, Each&& each) {
  for (std::string* text :
       {&student.id, &student.name, &student.login, &student.sis_id, &student.lms_id, &student.email, &student.section})
    each(*text);
}

}  // namespace

void write(const Handed& handed, ByteWriter& out) {
  out.number(static_cast<char>(handed.refused ? 1 : 0));
  out.text(handed.submission.source);
  write_time(handed.submission.submitted, out);
  out.text(handed.submission.text);
  out.text(handed.submission.problem);
}

Handed read_handed(ByteReader& in) {
  Handed handed;
  handed.refused = in.number<char>() != 0;
  handed.submission.source = in.text();
  handed.submission.submitted = read_time(in);
  handed.submission.text = in.text();
  handed.submission.problem = in.text();
  return handed;
}

std::string to_bytes(const WorkItem& item) {
  std::string bytes;
  ByteWriter out(bytes);
  out.number(item.index);
  Student student = item.student;
  for_each_text(student, [&](std::string& text) { out.text(text); });
  out.number(static_cast<char>(student.is_participant ? 1 : 0));
  write_time(student.due, out);
  out.number(static_cast<char>(item.with_page ? 1 : 0));
  out.number(static_cast<std::uint64_t>(item.handed.size()));
  for (const std::string& record : item.handed) out.text(record);
  out.number(static_cast<std::uint64_t>(item.incidents.size()));
  for (const Incident& incident : item.incidents) {
    out.number(static_cast<char>(incident.kind));
    out.text(incident.exercise);
    out.text(incident.source);
    out.text(incident.text);
  }
  return bytes;
}

std::pair<std::uint64_t, std::string_view> whose_work_item(std::string_view bytes) {
  ByteReader in(bytes);
  const auto index = in.number<std::uint64_t>();
  return {index, in.text()};
}

WorkItem read_work_item(std::string_view bytes) {
  ByteReader in(bytes);
  WorkItem item;
  item.index = in.number<std::uint64_t>();
  for_each_text(item.student, [&](std::string& text) { text = in.text(); });
  item.student.is_participant = in.number<char>() != 0;
  item.student.due = read_time(in);
  item.with_page = in.number<char>() != 0;
  for (auto n = in.number<std::uint64_t>(); n > 0; --n) item.handed.emplace_back(in.text());
  for (auto n = in.number<std::uint64_t>(); n > 0; --n) {
    Incident incident;
    incident.kind = static_cast<Incident::Kind>(in.number<char>());
    incident.exercise = in.text();
    incident.source = in.text();
    incident.text = in.text();
    item.incidents.push_back(std::move(incident));
  }
  return item;
}

std::string to_bytes(const WorkAnswer& answer) {
  std::string bytes;
  ByteWriter out(bytes);
  for (const std::string* text : {&answer.result, &answer.incidents, &answer.for_student, &answer.page})
    out.text(*text);
  for (const auto* texts : {&answer.rows, &answer.documents}) {
    out.number(static_cast<std::uint64_t>(texts->size()));
    for (const std::string& text : *texts) out.text(text);
  }
  out.number(answer.score);
  for (const std::uint64_t count : answer.counts) out.number(count);
  return bytes;
}

WorkAnswer read_work_answer(std::string_view bytes) {
  ByteReader in(bytes);
  WorkAnswer answer;
  for (std::string* text : {&answer.result, &answer.incidents, &answer.for_student, &answer.page}) *text = in.text();
  for (auto* texts : {&answer.rows, &answer.documents})
    for (auto n = in.number<std::uint64_t>(); n > 0; --n) texts->emplace_back(in.text());
  answer.score = in.number<double>();
  for (std::uint64_t& count : answer.counts) count = in.number<std::uint64_t>();
  return answer;
}

std::string incident_header() {
  std::string row;
  write_csv_row({"student", "kind", "exercise", "source", "text"}, row);
  return row;
}

void write_incident(std::string_view who, const Incident& incident, std::string& out) {
  write_csv_row({csv_text(who), std::string(incident_name(incident.kind)), csv_text(incident.exercise),
                 csv_text(incident.source), csv_text(incident.text)},
                out);
}

Desk::Desk(Examiner& examiner, DeskOptions options) : examiner_(&examiner), options_(std::move(options)) {
  for (const ReportFormat* format : options_.formats) {
    if (format->scope == ReportFormat::Scope::course)
      of_course_.push_back(format->open(options_.context));
    else
      of_student_.push_back(format);
  }
}

void Desk::work(std::string_view bytes, std::string& out) {
  WorkItem item = read_work_item(bytes);
  std::vector<Submission> submissions;
  for (const std::string& record : item.handed) {
    ByteReader in(record);
    Handed handed = read_handed(in);
    if (handed.refused)
      item.incidents.push_back(
          {Incident::Kind::refused, {}, std::move(handed.submission.source), std::move(handed.submission.problem)});
    else
      submissions.push_back(std::move(handed.submission));
  }
  StudentResult result = grade_student(*examiner_, item.student, std::move(submissions));
  std::ranges::move(item.incidents, std::back_inserter(result.incidents));

  WorkAnswer answer;
  write_json(result, Audience::instructor, answer.result);
  answer.result += '\n';
  for (const Incident& incident : result.incidents) {
    write_incident(result.student.id, incident, answer.incidents);
    ++answer.counts[static_cast<std::size_t>(incident.kind)];
  }
  if (options_.student_files) {
    write_json(result, Audience::student, answer.for_student);
    answer.for_student += '\n';
    if (options_.pages && item.with_page) answer.page = student_page(result);
  }
  for (const auto& report : of_course_) report->add(result, answer.rows.emplace_back());
  for (const ReportFormat* format : of_student_) {
    const auto report = format->open(options_.context);
    std::string& document = answer.documents.emplace_back();
    report->begin(document);
    report->add(result, document);
    report->finish(document);
  }
  answer.score = result.score();
  out = to_bytes(answer);
}

}  // namespace blossom
