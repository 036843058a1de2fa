#include <algorithm>
#include <utility>

#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_key_bytes = 256;
constexpr std::size_t most_source_bytes = 1024;

// A member of the line's object: where its key and its value stand, and all of it with the comma that belongs to it.
struct Member {
  std::string_view key;  // with its quotation marks
  std::string_view value;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Finds the members of an object without looking into their values: accepts all that is JSON, and some that is not,
// which is told by whoever parses the value.
class Members {
 public:
  explicit Members(std::string_view line) : line_(line) {}

  // False if this is no object.
  bool read(std::vector<Member>& members) {
    skip_blanks();
    if (!take('{')) return false;
    skip_blanks();
    if (!take('}')) {
      do {
        Member& member = members.emplace_back();
        skip_blanks();
        member.begin = at_;
        if (!next_is('"') || !skip_string()) return false;
        member.key = line_.substr(member.begin, at_ - member.begin);
        skip_blanks();
        if (!take(':')) return false;
        skip_blanks();
        const std::size_t value = at_;
        if (!skip_value()) return false;
        member.value = line_.substr(value, at_ - value);
        member.end = at_;
        skip_blanks();
      } while (take(','));
      if (!take('}')) return false;
    }
    skip_blanks();
    return at_ == line_.size();
  }

 private:
  bool next_is(char c) const { return at_ < line_.size() && line_[at_] == c; }
  bool take(char c) {
    if (!next_is(c)) return false;
    ++at_;
    return true;
  }
  void skip_blanks() {
    while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t' || line_[at_] == '\r' || line_[at_] == '\n'))
      ++at_;
  }
  bool skip_string() {
    for (++at_; at_ < line_.size(); ++at_) {
      if (line_[at_] == '\\')
        ++at_;
      else if (line_[at_] == '"')
        return ++at_, true;
    }
    return false;
  }
  // Brackets are only counted: which closes which matters to the parser.
  bool skip_value() {
    std::size_t depth = 0;
    const std::size_t begin = at_;
    while (at_ < line_.size()) {
      switch (line_[at_]) {
        case '"':
          if (!skip_string()) return false;
          break;
        case '{':
        case '[':
          ++depth;
          ++at_;
          break;
        case '}':
        case ']':
          if (depth == 0) return at_ > begin;
          --depth;
          ++at_;
          break;
        case ',':
        case ' ':
        case '\t':
        case '\r':
          if (depth == 0) return at_ > begin;
          ++at_;
          break;
        default:
          ++at_;
      }
      if (depth == 0 && at_ > begin && (line_[at_ - 1] == '"' || line_[at_ - 1] == '}' || line_[at_ - 1] == ']'))
        return true;
    }
    return depth == 0 && at_ > begin;
  }

  std::string_view line_;
  std::size_t at_ = 0;
};

// The text of a JSON string; nothing, with the reason, if it is none.
std::optional<std::string> text_of(std::string_view json, std::string_view name, std::string& problem) {
  const auto is_plain = [](char c) { return ' ' <= c && c <= '~' && c != '\\' && c != '"'; };
  if (json.size() >= 2 && json.front() == '"' && std::ranges::all_of(json.substr(1, json.size() - 2), is_plain))
    return std::string(json.substr(1, json.size() - 2));
  const auto document = JsonDocument::parse("", std::string(json));
  if (!document)
    problem = to_string(document.diagnostics.front());
  else if (document->root().kind != Json::Kind::string)
    problem = "must be a string";
  else
    return document->root().text;
  problem = excerpt(name) + ": " + problem;
  return std::nullopt;
}

bool is_single_line(std::string_view text) { return printable(text) == text; }

// What the keys of the line say, before anything is made of it.
struct Envelope {
  const Member* student = nullptr;
  const Member* submitted = nullptr;
  const Member* source = nullptr;
  const Member* submission = nullptr;
  std::string other;  // the first key that is none of these

  // False, with the reason, when a key of ours stands twice or cannot be read.
  bool sort(const std::vector<Member>& members, std::string& problem) {
    for (const Member& member : members) {
      const auto key = text_of(member.key, "key", problem);
      if (!key) return false;
      const Member** place = *key == "student"      ? &student
                             : *key == "submitted"  ? &submitted
                             : *key == "source"     ? &source
                             : *key == "submission" ? &submission
                                                    : nullptr;
      if (place == nullptr) {
        if (other.empty()) other = *key;
      } else if (std::exchange(*place, &member) != nullptr) {
        problem = "duplicate key " + excerpt(*key) + "; each key may stand once in an object";
        return false;
      }
    }
    return true;
  }
};

// Puts blanks over a member and one comma beside it, so that all else stays where it stands.
void blank_out(std::string& text, const Member& member) {
  std::size_t begin = member.begin, end = member.end;
  const std::size_t after = text.find_first_not_of(" \t\r\n", end);
  if (after != std::string::npos && text[after] == ',') {
    end = after + 1;
  } else {
    const std::size_t before = text.find_last_not_of(" \t\r\n", begin - 1);
    if (text[before] == ',') begin = before;
  }
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
}

// The submission's text, or the problem with it.
void take_submission(std::string_view line, const Envelope& envelope, const SourceLimits& limits,
                     Submission& submission) {
  if (envelope.submission != nullptr) {
    const std::string_view value = envelope.submission->value;
    if (!envelope.other.empty()) {
      const std::vector<std::string> known = {"student", "submitted", "source", "submission"};
      const auto near = did_you_mean(envelope.other, known);
      submission.problem = "unknown key " + excerpt(envelope.other) +
                           (near ? "; did you mean " + excerpt(*near) + "?"
                                 : R"(; the keys beside "submission" are "student", "submitted" and "source")");
    } else if (value.starts_with('{')) {
      submission.text = value;
    } else if (value.starts_with('"')) {
      if (auto text = text_of(value, "submission", submission.problem)) submission.text = std::move(*text);
    } else {
      submission.problem = "\"submission\" must be the answers file, as an object or as a string";
    }
  } else {
    submission.text = line;
    for (const Member* member : {envelope.student, envelope.submitted, envelope.source})
      if (member != nullptr) blank_out(submission.text, *member);
  }
  if (submission.text.size() > limits.submission_bytes && submission.problem.empty())
    submission.problem = too_large(limits);
  if (!submission.problem.empty()) submission.text.clear();
}

std::optional<Time> submitted_of(const Member& member, std::string& problem) {
  const auto text = text_of(member.value, "submitted", problem);
  if (!text) return std::nullopt;
  const auto time = parse_time(*text);
  if (!time)
    problem = "\"submitted\" must be a time with its offset from UTC such as \"2026-10-01T23:59:00+02:00\", not " +
              excerpt(*text);
  return time;
}

}  // namespace

// A string inside a submission may take two bytes for one: a line break, a quotation mark.
std::size_t most_line_bytes(const SourceLimits& limits) { return 2 * limits.submission_bytes + 4096; }

std::string too_long(const SourceLimits& limits) {
  return "too long; a line has at most " + std::to_string(most_line_bytes(limits)) + " bytes";
}

Found read_line(std::string_view line, const SourceLimits& limits) {
  Found found;
  Submission& submission = found.submission;
  if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  const auto nobodys = [&](std::string problem) {
    submission.problem = std::move(problem);
    return found;
  };
  if (line.size() > most_line_bytes(limits)) return nobodys(too_long(limits));

  std::vector<Member> members;
  members.reserve(8);
  if (!Members(line).read(members)) {
    const auto document = JsonDocument::parse("", std::string(line), {most_line_bytes(limits), 64});
    if (document) return nobodys("must be an object with the key \"student\"");
    Diagnostic first = document.diagnostics.front();
    first.line = first.column = 0;  // of the line itself
    return nobodys(to_string(first));
  }
  Envelope envelope;
  std::string problem;
  if (!envelope.sort(members, problem)) return nobodys(problem);
  if (envelope.student == nullptr) return nobodys("missing key \"student\"");
  auto student = text_of(envelope.student->value, "student", problem);
  if (!student) return nobodys(problem);
  if (student->empty() || student->size() > most_key_bytes || !is_single_line(*student))
    return nobodys("\"student\" must be the ID of a student, not " + excerpt(*student));
  found.keys.push_back({normal_form(*student)});

  take_submission(line, envelope, limits, submission);
  if (envelope.submitted != nullptr) submission.submitted = submitted_of(*envelope.submitted, problem);
  if (envelope.source != nullptr)
    if (const auto source = text_of(envelope.source->value, "source", problem))
      submission.source = printable(std::string_view(*source).substr(0, most_source_bytes));
  if (!problem.empty() && submission.problem.empty()) {
    submission.problem = problem;
    submission.text.clear();
  }
  return found;
}

}  // namespace blossom
