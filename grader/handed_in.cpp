#include "grader/handed_in.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr int most_levels = 8;
constexpr std::size_t most_entries = 1000;

// A file that is open, or why it is not.
class Opened {
 public:
  Opened(const std::string& path, bool follow) {
    if (path == "-") return;
    fd_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | (follow ? 0 : O_NOFOLLOW));
    owned_ = fd_ >= 0;
    if (fd_ < 0) error_ = errno;
  }
  ~Opened() {
    if (owned_) ::close(fd_);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  // Reads at most `most` bytes and one more.
  std::string read(std::size_t most, std::string& text) const {
    if (error_ == ELOOP) return "is a symbolic link, which is not read";
    if (error_ != 0) return says(error_);
    struct stat status {};
    if (owned_ && ::fstat(fd_, &status) != 0) return says(errno);
    if (owned_ && !S_ISREG(status.st_mode)) return "is no file: a device, a pipe or a folder";
    text.resize(most + 1);
    std::size_t size = 0;
    while (size < text.size()) {
      const auto got = ::read(fd_, text.data() + size, text.size() - size);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return says(errno);
      if (got == 0) break;
      size += static_cast<std::size_t>(got);
    }
    text.resize(size);
    return {};
  }

 private:
  static std::string says(int error) { return "cannot be read: " + std::string(std::strerror(error)); }

  int fd_ = STDIN_FILENO;
  int error_ = 0;
  bool owned_ = false;
};

Submission read_one(const std::string& path, std::string source, bool follow) {
  Submission submission;
  submission.source = std::move(source);
  submission.problem = Opened(path, follow).read(submission_limits.bytes, submission.text);
  if (!submission.problem.empty()) submission.text.clear();
  return submission;
}

bool is_json(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension == ".json";
}

void read_folder(const fs::path& folder, HandedIn& out) {
  std::vector<fs::path> files;
  std::error_code error;
  auto each = fs::recursive_directory_iterator(folder, fs::directory_options::none, error);
  for (std::size_t seen = 0; !error && each != fs::recursive_directory_iterator(); each.increment(error)) {
    if (++seen > most_entries) {
      out.refused.push_back({Incident::Kind::refused,
                             {},
                             folder.filename().string(),
                             "only " + std::to_string(most_entries) + " entries of it were looked at"});
      break;
    }
    std::error_code ignored;
    const bool is_folder = each->symlink_status(ignored).type() == fs::file_type::directory;
    const std::string name = each->path().filename().string();
    const bool passed_over = is_litter(name), hidden = name.starts_with('.');
    if (passed_over || hidden || each.depth() + 1 >= most_levels) each.disable_recursion_pending();
    if (!passed_over && (hidden || !is_folder)) files.push_back(each->path());
  }
  if (error)
    out.refused.push_back(
        {Incident::Kind::refused, {}, folder.filename().string(), "cannot be read: " + error.message()});
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    std::string source = file.lexically_relative(folder).string();
    if (file.filename().string().starts_with('.'))
      out.refused.push_back({Incident::Kind::refused, {}, std::move(source), "its name hides it, and it was not read"});
    else if (is_json(file))
      out.submissions.push_back(read_one(file.string(), std::move(source), false));
    else
      out.refused.push_back({Incident::Kind::refused, {}, std::move(source), "is no .json file and was not read"});
  }
}

// A member that is there and not null.
const Json* member(const Json& object, std::string_view key, Json::Kind kind) {
  const Json* found = object.kind == Json::Kind::object ? object.find(key) : nullptr;
  return found != nullptr && found->kind == kind ? found : nullptr;
}

// A text, or a number as it was typed.
std::string text_of(const Json& object, std::string_view key) {
  for (const Json::Kind kind : {Json::Kind::string, Json::Kind::number})
    if (const Json* found = member(object, key, kind)) return found->text;
  return {};
}

std::optional<Time> time_of(const Json& object, std::string_view key) {
  const Json* found = member(object, key, Json::Kind::string);
  return found != nullptr ? parse_time(found->text) : std::nullopt;
}

}  // namespace

HandedIn read_handed_in(const std::vector<std::string>& paths) {
  HandedIn out;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (path != "-" && fs::is_directory(path, ignored))
      read_folder(path, out);
    else
      out.submissions.push_back(read_one(path, path == "-" ? std::string() : fs::path(path).filename().string(), true));
  }
  return out;
}

Checked<SubmissionMetadata> read_submission_metadata(const JsonDocument& document) {
  const Json& root = document.root();
  const auto wrong = [&](std::string path, std::string message) {
    return Diagnostics{{document.name(), 0, 0, std::move(path), std::move(message)}};
  };
  const Json* users = member(root, "users", Json::Kind::array);
  if (users == nullptr || users->items.empty())
    return wrong("users", "must be an array of at least one user, as Gradescope writes it");
  const Json& user = users->items[0];
  SubmissionMetadata metadata;
  Student& student = metadata.student;
  student.name = text_of(user, "name");
  student.email = text_of(user, "email");
  student.lms_id = text_of(user, "id");
  student.sis_id = text_of(user, "sid");
  student.id = !student.sis_id.empty() ? student.sis_id : !student.email.empty() ? student.email : student.lms_id;
  if (student.id.empty()) return wrong("users[0]", "must have a \"sid\", an \"email\" or an \"id\"");
  metadata.submitted = time_of(root, "created_at");
  if (!metadata.submitted) return wrong("created_at", "must be a time such as \"2026-10-01T21:59:00.000000-07:00\"");
  // The user's own assignment has their extension.
  if (const Json* own = member(user, "assignment", Json::Kind::object)) student.due = time_of(*own, "due_date");
  if (const Json* whole = member(root, "assignment", Json::Kind::object); whole != nullptr && !student.due)
    student.due = time_of(*whole, "due_date");
  return metadata;
}

}  // namespace blossom
