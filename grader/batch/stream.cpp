#include "grader/batch/stream.hpp"

#include <errno.h>
#include <unistd.h>

#include <cstring>
#include <system_error>

#include "grader/batch/source.hpp"
#include "grader/digest.hpp"
#include "grader/report/report.hpp"

namespace blossom {
namespace {

constexpr std::size_t buffer_bytes = 2 * longest_line;
constexpr std::size_t write_from = 256u << 10;
constexpr std::size_t digest_digits = 16;
constexpr std::string_view ungraded_start = R"({"schema":"blossom.grade/1","exercise":"",)";

// A line of the input has no line break, an item that stands for a long one begins with it.
bool is_long(std::string_view item) { return item.starts_with('\n'); }

std::string digest_of(std::string_view item) {
  return is_long(item) ? std::string(item.substr(1)) : sha256_hex(item).substr(0, digest_digits);
}

void write_ungraded(std::string_view item, std::string_view student, std::string_view reason, std::string& line) {
  line = ungraded_start;
  if (!student.empty()) line += R"("student":)" + json_quote(student) + ",";
  line += R"("score":0,"points":0,"max_points":0,"parts":[],"reason":)" + json_quote(reason) + R"(,"digest":")" +
          digest_of(item) + "\"}\n";
}

// Which exercise of the assignment is meant. An assignment of one takes all, for its grader says what is wrong;
// nothing, with the reason, otherwise.
std::optional<std::size_t> item_of(const Assignment& assignment, const Checked<JsonDocument>& document,
                                   std::string& reason) {
  if (assignment.items.size() == 1) return 0;
  if (!document) {
    reason = to_string(document.diagnostics.front());
    return std::nullopt;
  }
  const Json& root = document->root();
  const Json* id = root.kind == Json::Kind::object ? root.find("exercise") : nullptr;
  if (id == nullptr || id->kind != Json::Kind::string) {
    reason = "must be an object {\"schema\", \"exercise\", \"answers\"} with the id of the exercise";
    return std::nullopt;
  }
  const auto item = assignment.item(id->text);
  if (!item) reason = no_exercise_of(assignment, id->text);
  return item;
}

}  // namespace

Extent shard_of(std::uint64_t bytes, unsigned index, unsigned count) {
  const auto begin = [&](std::uint64_t i) { return bytes / count * i + bytes % count * i / count; };
  return {begin(index - 1), begin(index)};
}

LineReader::LineReader(int file, const Extent& extent)
    : file_(file), extent_(extent), buffer_(std::make_unique_for_overwrite<char[]>(buffer_bytes)) {
  if (extent_.begin == 0) return;
  // A line that begins at `begin` follows a line break just before it.
  offset_ = extent_.begin - 1;
  if (lseek(file_, static_cast<off_t>(offset_), SEEK_SET) < 0)
    throw std::system_error(errno, std::generic_category(), "the input has no parts");
  std::string before;
  next(before);
}

LineReader::~LineReader() = default;

// Reads on behind what is not used yet, which moves to the front. False at the end.
bool LineReader::fill() {
  if (ended_) return false;
  if (at_ > 0) {
    std::memmove(buffer_.get(), buffer_.get() + at_, filled_ - at_);
    filled_ -= at_;
    looked_at_ -= at_;
    at_ = 0;
  }
  ssize_t got;
  while ((got = read(file_, buffer_.get() + filled_, buffer_bytes - filled_)) < 0 && errno == EINTR) continue;
  if (got < 0) throw std::system_error(errno, std::generic_category(), "the input cannot be read");
  filled_ += static_cast<std::size_t>(got);
  ended_ = got == 0;
  return !ended_;
}

bool LineReader::next(std::string& item) {
  if (offset_ >= extent_.end) return false;
  for (;;) {
    const char* begin = buffer_.get() + at_;
    const void* found = std::memchr(buffer_.get() + looked_at_, '\n', filled_ - looked_at_);
    const std::size_t length =
        found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - begin) : filled_ - at_;
    looked_at_ = filled_;
    if (length > longest_line) {
      item = rest_of_long_line();
      return true;
    }
    if (found == nullptr && fill()) continue;
    if (found == nullptr && length == 0) return false;
    item.assign(buffer_.get() + at_, length);
    const std::size_t taken = length + (found != nullptr ? 1 : 0);
    at_ += taken;
    offset_ += taken;
    looked_at_ = at_;
    return true;
  }
}

std::string LineReader::rest_of_long_line() {
  Sha256 digest;
  for (;;) {
    const char* begin = buffer_.get() + at_;
    const void* found = std::memchr(begin, '\n', filled_ - at_);
    const std::size_t length =
        found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - begin) : filled_ - at_;
    digest.add({begin, length});
    const std::size_t taken = length + (found != nullptr ? 1 : 0);
    at_ += taken;
    offset_ += taken;
    looked_at_ = at_;
    if (found != nullptr || !fill()) return "\n" + digest.hex().substr(0, digest_digits);
  }
}

void grade_line(Examiner& examiner, std::string_view item, std::string& line) {
  if (is_long(item))
    return write_ungraded(item, {}, "too long; a line has at most " + std::to_string(longest_line) + " bytes", line);
  Found found = read_line(item);
  const std::string student = found.keys.empty() ? std::string() : std::move(found.keys.front().text);
  if (!found.submission.problem.empty()) return write_ungraded(item, student, found.submission.problem, line);

  const auto document = JsonDocument::parse({}, std::move(found.submission.text), submission_limits);
  std::string reason;
  const auto exercise = item_of(examiner.assignment(), document, reason);
  if (!exercise) return write_ungraded(item, student, reason, line);
  const auto grader = examiner.grader(*exercise, student);
  if (!grader) return write_ungraded(item, student, grader.diagnostics.front().message, line);
  write_json((*grader)->grade(document, student), line);
  line += '\n';
}

StreamCounts grade_stream(LineReader& reader, Workers& workers, const std::function<void(std::string_view)>& write) {
  StreamCounts counts;
  std::string out;
  out.reserve(2 * write_from);
  std::string ungraded;
  workers.run([&](std::string& item) { return reader.next(item); },
              [&](std::string_view item, std::string_view line, const Lost* lost) {
                if (lost != nullptr) {
                  write_ungraded(item, {}, lost->text, ungraded);
                  line = ungraded;
                }
                ++counts.lines;
                if (line.starts_with(ungraded_start)) ++counts.ungraded;
                out += line;
                if (out.size() >= write_from) {
                  write(out);
                  out.clear();
                }
              });
  if (!out.empty()) write(out);
  return counts;
}

void prepare_for_workers(Examiner& examiner) {
  // OpenSSL reads its settings when it is first used.
  sha256_hex({});
  for (std::size_t i = 0; i < examiner.assignment().items.size(); ++i)
    if (examiner.varies(i)) static_cast<void>(examiner.grader(i, "nobody"));
}

}  // namespace blossom
