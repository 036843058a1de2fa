#pragma once
// What the parent hands to a worker, and what it gets back: one student with all that they handed in; and all that is
// written of them.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grader/batch/bytes.hpp"
#include "grader/report/report.hpp"

namespace blossom {

inline constexpr std::size_t incident_kinds = 9;
using IncidentCounts = std::array<std::uint64_t, incident_kinds>;

// A record of the spool: a submission, or an entry that was refused.
struct Handed {
  Submission submission;
  bool refused = false;
};
void write(const Handed&, ByteWriter&);
Handed read_handed(ByteReader&);

struct WorkItem {
  std::uint64_t index = 0;  // of the student, in the class
  Student student;
  std::vector<std::string> handed;  // records of the spool
  std::vector<Incident> incidents;  // what is known of them already
  bool with_page = true;
};
std::string to_bytes(const WorkItem&);
WorkItem read_work_item(std::string_view);
std::pair<std::uint64_t, std::string_view> whose_work_item(std::string_view);  // index and ID, without the rest

struct WorkAnswer {
  std::string result;                  // the line of results.jsonl, with its end
  std::string incidents;               // rows of incidents.csv
  std::string for_student;             // the student's JSON
  std::string page;                    // and page; empty: none
  std::vector<std::string> rows;       // of each format of the course
  std::vector<std::string> documents;  // of each format of students
  double score = 0;
  IncidentCounts counts{};
};
std::string to_bytes(const WorkAnswer&);
WorkAnswer read_work_answer(std::string_view);

// A row of incidents.csv; who is the student's ID, or what the submission is known by.
void write_incident(std::string_view who, const Incident&, std::string& out);
std::string incident_header();

struct DeskOptions {
  std::vector<const ReportFormat*> formats;
  ReportContext context;
  bool pages = true;
  bool student_files = true;
};

// What a worker does: grades an item and writes all that is to be said of it. One for each process.
class Desk {
 public:
  Desk(Examiner& examiner, DeskOptions options);
  void work(std::string_view item, std::string& answer);

 private:
  Examiner* examiner_;
  DeskOptions options_;
  std::vector<std::unique_ptr<Report>> of_course_;
  std::vector<const ReportFormat*> of_student_;
};

}  // namespace blossom
