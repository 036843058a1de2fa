#include "grader/batch/intake.hpp"

#include <algorithm>

#include "grader/batch/kept.hpp"
#include "grader/batch/output.hpp"
#include "grader/batch/spool.hpp"
#include "grader/digest.hpp"

namespace blossom {
namespace {

// Students of a part of the spool. With a roster the class is spread over all parts there may be.
constexpr std::uint64_t part_size_of_unknown = 16'384;
constexpr std::uint64_t progress_every = 1000;

std::uint64_t part_size(const ClassList& list) {
  if (!list.has_roster()) return part_size_of_unknown;
  return std::max<std::uint64_t>(1, (list.size() + most_spool_parts - 1) / most_spool_parts);
}

std::string read_json(const Intake& intake) {
  std::string text = "{\"submissions\": " + std::to_string(intake.submissions) +
                     ", \"untimed\": " + std::to_string(intake.untimed) + ", \"digest\": " + json_quote(intake.digest) +
                     ", \"strays\": [";
  for (std::size_t i = 0; i < incident_kinds; ++i) text += (i > 0 ? ", " : "") + std::to_string(intake.strays[i]);
  return text + "]}\n";
}

std::string first_key(const Found& found) { return found.keys.empty() ? std::string() : found.keys.front().text; }

// A submission as the spool has it.
void write_record(const Found& found, std::string& record) {
  record.clear();
  ByteWriter out(record);
  write({found.submission, found.refused}, out);
}

void add_to(Sha256& digest, const Found& found, std::string& record) {
  write_record(found, record);
  ByteWriter(record).text(first_key(found));
  digest.add(record);
}

class Taking {
 public:
  Taking(ClassList& list, const std::filesystem::path& work, bool keep)
      : list_(&list), spool_(work / "spool", part_size(list)), strays_(work / "strays.csv") {
    if (keep) kept_.emplace(work / "submissions.jsonl");
  }

  void take(const Found& found) {
    if (!found.refused) {
      ++intake.submissions;
      if (!found.submission.submitted) ++intake.untimed;
    }
    // What is refused is nobody's handing in.
    std::optional<std::uint64_t> index;
    if (!found.refused || list_->has_roster()) index = list_->find(found.keys, why_not_);
    const std::string key = first_key(found);
    if (index) {
      write_record(found, record_);
      spool_.add(*index, record_);
    } else {
      stray(found, key);
    }
    if (!kept_) return;
    line_.clear();
    write_kept(index && list_->has_roster() ? list_->student(*index).id : key, found, line_);
    kept_->write(line_);
  }

  void finish() {
    list_->finish();
    strays_.close();
    if (kept_) kept_->close();
    spool_.finish();
  }

  Intake intake;

 private:
  void stray(const Found& found, const std::string& key) {
    Incident incident{Incident::Kind::unlisted, {}, found.submission.source, {}};
    if (found.refused) {
      incident.kind = Incident::Kind::refused;
      incident.text = found.submission.problem;
    } else if (key.empty()) {
      incident.text = found.submission.problem.empty() ? "it does not say whose it is; it was not graded"
                                                       : "it does not say whose it is: " + found.submission.problem;
    } else {
      incident.text = why_not_ + "; it was not graded";
    }
    ++intake.strays[static_cast<std::size_t>(incident.kind)];
    line_.clear();
    write_incident(key, incident, line_);
    strays_.write(line_);
  }

  ClassList* list_;
  Spool spool_;
  OutputFile strays_;
  std::optional<OutputFile> kept_;
  std::string record_, line_, why_not_;
};

}  // namespace

Checked<Intake> take_in(SubmissionSource& source, ClassList& list, const std::filesystem::path& work,
                        const IntakeOptions& options, const std::function<void(const BatchProgress&)>& progress) {
  Taking taking(list, work, options.keep);
  Found found;
  Sha256 digest;
  std::string record;
  std::uint64_t count = 0;
  while (source.next(found)) {
    if (options.digest) add_to(digest, found, record);
    if (!options.times) found.submission.submitted.reset();
    try {
      taking.take(found);
    } catch (const std::length_error&) {
      return Diagnostics{{"", 0, 0, "", "there are more students than can be graded without a roster"}};
    }
    if (++count % progress_every == 0) {
      const auto share = source.progress();
      const auto all = share && *share > 0 ? static_cast<std::uint64_t>(static_cast<double>(count) / *share) : 0;
      progress({"reading", count, all, "submissions"});
    }
  }
  if (!source.failure().empty()) return Diagnostics{{"", 0, 0, "", source.failure()}};
  taking.finish();
  if (options.digest) taking.intake.digest = digest.hex();
  place_file(work, work / "read.json", read_json(taking.intake));
  return taking.intake;
}

Checked<std::string> digest_of(SubmissionSource& source) {
  Found found;
  Sha256 digest;
  std::string record;
  while (source.next(found)) add_to(digest, found, record);
  if (!source.failure().empty()) return Diagnostics{{"", 0, 0, "", source.failure()}};
  return digest.hex();
}

std::optional<Intake> taken_in(const std::filesystem::path& work) {
  std::error_code error;
  if (!std::filesystem::exists(work / "read.json", error)) return std::nullopt;
  const auto document = JsonDocument::load(work / "read.json");
  if (!document) return std::nullopt;
  Diagnostics diagnostics;
  const Cursor root(*document, diagnostics);
  const auto count = [](const Cursor& at) {
    const auto number = at.number();
    return number ? static_cast<std::uint64_t>(number->to_double()) : 0;
  };
  Intake intake;
  if (const auto at = root.required("submissions")) intake.submissions = count(*at);
  if (const auto at = root.required("untimed")) intake.untimed = count(*at);
  if (const auto at = root.required("digest")) intake.digest = at->string().value_or("");
  if (const auto at = root.required("strays"); at && at->expect_array(incident_kinds, incident_kinds))
    for (std::size_t i = 0; i < incident_kinds; ++i) intake.strays[i] = count((*at)[i]);
  if (!diagnostics.empty()) return std::nullopt;
  return intake;
}

}  // namespace blossom
