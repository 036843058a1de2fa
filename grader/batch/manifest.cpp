#include "grader/batch/manifest.hpp"

#include <sys/stat.h>

#include <fstream>
#include <system_error>

#include "grader/batch/bytes.hpp"
#include "grader/batch/output.hpp"
#include "grader/digest.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view file_name = "run.json";

std::string digest_of_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  Sha256 digest;
  std::string chunk(64u << 10, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0)
    digest.add(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
  return digest.hex();
}

std::string size_and_time(const struct stat& status) {
  std::string text;
  ByteWriter out(text);
  out.number(static_cast<std::int64_t>(status.st_size));
  out.number(static_cast<std::int64_t>(status.st_mtim.tv_sec));
  out.number(static_cast<std::int64_t>(status.st_mtim.tv_nsec));
  return text;
}

// Of a folder, the sum over its files: their order does not matter, and nothing has to be held.
std::string fingerprint(const std::string& submissions) {
  if (submissions == "-") return "standard input";
  struct stat status {};
  if (::stat(submissions.c_str(), &status) != 0 || (!S_ISDIR(status.st_mode) && !S_ISREG(status.st_mode)))
    return "a stream";
  if (S_ISREG(status.st_mode)) return sha256_hex(size_and_time(status));
  std::uint64_t sum = 0, count = 0;
  std::error_code error;
  for (fs::recursive_directory_iterator it(submissions, fs::directory_options::skip_permission_denied, error), end;
       !error && it != end; it.increment(error)) {
    struct stat entry {};
    if (::lstat(it->path().c_str(), &entry) != 0) continue;
    const std::string name = it->path().lexically_relative(submissions).string() + '\0';
    const std::string digest = sha256_hex(name + (S_ISDIR(entry.st_mode) ? std::string() : size_and_time(entry)));
    sum += std::stoull(digest.substr(0, 16), nullptr, 16);
    ++count;
  }
  return sha256_hex(std::to_string(sum) + " of " + std::to_string(count));
}

}  // namespace

Manifest manifest_of(const BatchOptions& options, const Assignment& assignment, const std::string& secret, Time now) {
  Manifest manifest;
  manifest.now = now;
  std::string text;
  ByteWriter out(text);
  for (const Assignment::Item& item : assignment.items) out.text(item.document.text());
  if (const auto document = JsonDocument::load(options.assignment)) out.text(document->text());
  manifest.assignment = sha256_hex(text);
  if (options.roster) manifest.roster = digest_of_file(*options.roster);
  text.clear();
  for (const ReportFormat* format : options.formats) out.text(format->name);
  out.number(static_cast<char>(options.pages));
  out.number(static_cast<char>(options.student_files));
  out.number(static_cast<char>(options.keep_submissions));
  out.number(static_cast<char>(options.file_times));
  manifest.options = sha256_hex(text);
  manifest.secret = digest_of_secret(secret);
  manifest.program = options.program;
  manifest.submissions = fingerprint(options.submissions);
  return manifest;
}

std::string difference(const Manifest& there, const Manifest& wanted) {
  if (there.assignment != wanted.assignment) return "the assignment or one of its exercises has changed";
  if (there.roster != wanted.roster) return "the roster has changed";
  if (there.submissions != wanted.submissions) return "the submissions have changed";
  if (there.secret != wanted.secret) return "the course's secret is another one";
  if (there.program != wanted.program) return "this is another version of the program";
  if (there.options != wanted.options) return "other formats or options are asked for";
  if (there.now != wanted.now) return "it was made as of " + format_time(there.now);
  return {};
}

std::optional<Manifest> read_manifest(const fs::path& out) {
  std::error_code error;
  if (!fs::is_regular_file(out / file_name, error)) return std::nullopt;
  const auto document = JsonDocument::load(out / file_name);
  if (!document) return std::nullopt;
  Diagnostics diagnostics;
  const Cursor root(*document, diagnostics);
  Manifest manifest;
  const auto text = [&](std::string_view key, std::string& into) {
    if (const auto at = root.required(key)) into = at->string().value_or("");
  };
  std::string schema, state, now;
  text("schema", schema);
  text("state", state);
  text("now", now);
  text("assignment", manifest.assignment);
  text("roster", manifest.roster);
  text("options", manifest.options);
  text("secret", manifest.secret);
  text("program", manifest.program);
  text("submissions", manifest.submissions);
  const auto time = parse_time(now);
  if (!diagnostics.empty() || schema != "blossom.run/1" || !time) return std::nullopt;
  manifest.finished = state == "finished";
  manifest.now = *time;
  return manifest;
}

void write_manifest(const Manifest& manifest, const fs::path& out, const fs::path& work) {
  std::string text = "{\n";
  const auto member = [&](std::string_view key, std::string_view value) {
    text += (text.size() > 2 ? ",\n  \"" : "  \"") + std::string(key) + "\": " + json_quote(value);
  };
  member("schema", "blossom.run/1");
  member("state", manifest.finished ? "finished" : "running");
  member("now", format_time(manifest.now));
  member("assignment", manifest.assignment);
  member("roster", manifest.roster);
  member("options", manifest.options);
  member("secret", manifest.secret);
  member("program", manifest.program);
  member("submissions", manifest.submissions);
  place_file(work, out / file_name, text + "\n}\n");
}

std::string digest_of_secret(const std::string& secret) {
  return secret.empty() ? std::string() : sha256_hex("blossom course secret\n" + secret);
}

}  // namespace blossom
