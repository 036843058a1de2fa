#include "grader/batch/source.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr std::string_view moodle_mark = "_assignsubmission_";

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// Takes "_4711" from the front of the text: the number, or nothing.
std::string_view take_number(std::string_view& text) {
  if (!text.starts_with('_')) return {};
  const std::size_t end = std::min(text.find_first_not_of(digits, 1), text.size());
  const std::string_view number = text.substr(1, end - 1);
  if (!number.empty()) text.remove_prefix(end);
  return number;
}

// Canvas names a file it hands out NAME[_LATE]_USER_FILE_anything.json, NAME being letters and digits only: so what a
// student may choose comes after the number that counts.
std::string_view canvas_user(std::string_view name) {
  std::string_view rest = name.substr(std::min(name.find('_'), name.size()));
  if (rest.starts_with("_LATE_")) rest.remove_prefix(5);
  const std::string_view user = take_number(rest);
  return !user.empty() && !take_number(rest).empty() && rest.starts_with('_') ? user : std::string_view();
}

// Moodle names a folder, or the beginning of a file, FULL NAME_PARTICIPANT_assignsubmission_file_. Where the mark
// stands twice, somebody chose a name to be taken for somebody else.
// The full name is the student's own to change, and is no key.
std::string_view moodle_participant(std::string_view name) {
  const std::size_t end = name.find(moodle_mark);
  if (end == std::string_view::npos || name.find(moodle_mark, end + 1) != std::string_view::npos) return {};
  const std::string_view before = name.substr(0, end);
  const std::size_t number = before.find_last_not_of(digits) + 1;
  if (number < 2 || number == before.size() || before[number - 1] != '_') return {};
  return before.substr(number);
}

Diagnostics problem(const std::filesystem::path& path, std::string message) {
  return {{path.string(), 0, 0, "", std::move(message)}};
}

}  // namespace

std::vector<StudentKey> keys_of(std::string_view path) {
  const std::size_t slash = path.find('/');
  const bool is_file = slash == std::string_view::npos;
  std::string_view name = path.substr(0, slash);
  if (is_file && is_json_name(name)) name.remove_suffix(5);
  std::vector<StudentKey> keys;
  if (name.empty()) return keys;
  keys.push_back({normal_form(name)});
  // A file may look like both, for the beginning of Moodle's and the end of Canvas's is what a student chose.
  const std::string_view user = is_file ? canvas_user(name) : std::string_view();
  const std::string_view participant = moodle_participant(name);
  const bool looks_like_both = !user.empty() && name.find(moodle_mark) != std::string_view::npos;
  if (const std::string_view number = user.empty() ? participant : user; !number.empty() && !looks_like_both)
    keys.push_back({std::string(number), StudentKey::Kind::lms_number});
  return keys;
}

bool is_json_name(std::string_view name) { return lower(name).ends_with(".json"); }

std::string too_large(const SourceLimits& limits) {
  return "too large; a submission has at most " + std::to_string(limits.submission_bytes) + " bytes";
}

std::string too_deep(const SourceLimits& limits) {
  return "not read: more than " + std::to_string(limits.depth) + " folders inside each other";
}

std::optional<Time> time_of(std::int64_t seconds) {
  constexpr std::int64_t end = 253'402'300'800;  // 10000-01-01
  if (seconds < 0 || seconds >= end) return std::nullopt;
  return Time{std::chrono::seconds{seconds}};
}

std::string system_says(int error) { return std::generic_category().message(error); }

Checked<std::unique_ptr<SubmissionSource>> open_submissions(const std::filesystem::path& path,
                                                            const SourceLimits& limits) {
  if (path == "-") return lines_of(Descriptor(STDIN_FILENO), limits);
  // Without O_NONBLOCK opening a pipe would wait for a writer, perhaps for ever.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat status {};
  if (file < 0 || ::fstat(file, &status) != 0) return problem(path, "cannot be read: " + system_says(errno));
  if (S_ISDIR(status.st_mode)) return folder_of(std::move(file), limits);
  if (!S_ISREG(status.st_mode))
    return problem(path, "must be a folder, an archive or a file of JSON Lines; use - for standard input");
  if (lower(path.extension().string()) == ".jsonl") return lines_of(std::move(file), limits);
  if (is_json_name(path.string()))
    return problem(path, "must be a folder, an archive, or a file of JSON Lines whose name ends in .jsonl");
  return archive_of(std::move(file), limits);
}

}  // namespace blossom
