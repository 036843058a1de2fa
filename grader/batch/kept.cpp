#include "grader/batch/kept.hpp"

#include <algorithm>
#include <fstream>

#include "base/utf8.hpp"
#include "grader/batch/sources.hpp"

namespace blossom {
namespace {

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

void write_hex(std::string_view bytes, std::string& out) {
  constexpr char digits[] = "0123456789abcdef";
  for (const char c : bytes) {
    out += digits[static_cast<unsigned char>(c) >> 4];
    out += digits[static_cast<unsigned char>(c) & 15];
  }
}

std::string from_hex(std::string_view text) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    bytes += static_cast<char>(16 * value(text[i]) + value(text[i + 1]));
  return bytes;
}

class KeptSource final : public SubmissionSource {
 public:
  explicit KeptSource(const std::filesystem::path& path) : in_(path, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(path, error);
  }

  bool is_open() const { return in_.is_open(); }

  bool next(Found& found) override {
    std::string line;
    if (!std::getline(in_, line)) {
      if (in_.bad()) failure_ = "cannot be read on";
      return false;
    }
    read_ += line.size() + 1;
    if (!read_special(line, found)) found = read_line(line);
    // Of somebody who was not on the roster only the first key was kept; all of them are in the path it came from.
    if (!found.keys.empty())
      if (auto keys = keys_of(found.submission.source); !keys.empty() && keys.front() == found.keys.front())
        found.keys = std::move(keys);
    return true;
  }

  std::optional<double> progress() const override {
    if (size_ == 0) return std::nullopt;
    return std::min(1.0, static_cast<double>(read_) / static_cast<double>(size_));
  }

 private:
  // What our own writer puts last stands nowhere else: a submission's own quotation marks are escaped.
  static bool read_special(const std::string& line, Found& found) {
    const auto has = [&](std::string_view key) { return line.find(key) != std::string::npos; };
    if (!has("\"problem\":\"") && !has("\"refused\":\"") && !has("\"submission_hex\":\"")) return false;
    const auto document = JsonDocument::parse("submissions.jsonl", line);
    if (!document) return false;
    const auto text = [&](std::string_view key) -> const std::string* {
      const Json* at = document->root().find(key);
      return at != nullptr && at->kind == Json::Kind::string ? &at->text : nullptr;
    };
    const std::string *problem = text("problem"), *refused = text("refused"), *hex = text("submission_hex");
    if (problem == nullptr && refused == nullptr && hex == nullptr) return false;
    found = {};
    if (const auto* student = text("student")) found.keys.push_back({*student});
    if (const auto* source = text("source")) found.submission.source = *source;
    if (const auto* submitted = text("submitted")) found.submission.submitted = parse_time(*submitted);
    if (refused != nullptr) found.refused = true;
    if (refused != nullptr || problem != nullptr) found.submission.problem = refused != nullptr ? *refused : *problem;
    if (hex != nullptr) found.submission.text = from_hex(*hex);
    return true;
  }

  std::ifstream in_;
  std::uint64_t size_ = 0;
  std::uint64_t read_ = 0;
};

}  // namespace

void write_kept(const std::string& student, const Found& found, std::string& out) {
  const auto member = [&](std::string_view key, std::string_view value) {
    out += out.back() == '{' ? "\"" : ",\"";
    out += key;
    out += "\":";
    out += json_quote(value);
  };
  const Submission& submission = found.submission;
  out += '{';
  if (!student.empty()) member("student", student);
  if (submission.submitted) member("submitted", format_time(*submission.submitted));
  if (!submission.source.empty()) member("source", submission.source);
  if (found.refused) {
    member("refused", submission.problem);
  } else if (!submission.problem.empty()) {
    member("problem", submission.problem);
  } else if (is_utf8(submission.text)) {
    member("submission", submission.text);
  } else {
    member("submission_hex", {});
    out.pop_back();
    write_hex(submission.text, out);
    out += '"';
  }
  out += "}\n";
}

Checked<std::unique_ptr<SubmissionSource>> open_kept(const std::filesystem::path& path) {
  auto source = std::make_unique<KeptSource>(path);
  if (!source->is_open()) return Diagnostics{{path.string(), 0, 0, "", "cannot be read"}};
  return std::unique_ptr<SubmissionSource>(std::move(source));
}

}  // namespace blossom
