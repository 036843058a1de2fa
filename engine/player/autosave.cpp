#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <csignal>
#include <fstream>
#include <limits>
#include <system_error>
#include <tuple>

#include "player/kept_file.hpp"
#include "player/settings.hpp"

namespace blossom {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view autosave_schema = "blossom.autosave/1";
constexpr std::size_t most_offered = 20;
constexpr JsonLimits autosave_limits{most_autosave_bytes, 4, 100};

fs::path folder_of(const Places& places) { return places.state.empty() ? fs::path() : places.state / "autosave"; }

// ---- whose file it is -----------------------------------------------------------------------------------------------

// Which of all processes that ever had this id: the boot, and the clock ticks from it to the start of the process
// (proc(5): the 22nd word of stat, the 20th after the name in parentheses, which may have anything in it). Empty where
// the system does not say.
std::string birth_of(pid_t pid) {
  std::string boot, stat;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
  std::getline(std::ifstream("/proc/" + std::to_string(pid) + "/stat"), stat, '\0');
  std::size_t at = stat.rfind(')');
  for (int word = 0; word < 20 && at != std::string::npos; ++word) at = stat.find(' ', at + 1);
  if (boot.empty() || at == std::string::npos) return {};
  return boot + " " + stat.substr(at + 1, stat.find(' ', at + 1) - at - 1);
}

// A process of another user is not the one that wrote the file, though its id is the same.
bool is_gone(pid_t pid, const std::string& birth) {
  if (::kill(pid, 0) != 0) return true;
  const std::string now = birth_of(pid);
  return !birth.empty() && !now.empty() && birth != now;
}

// "<pid>-<n>.json"
std::optional<pid_t> pid_in(const std::string& name) {
  constexpr std::string_view digits = "0123456789", ending = ".json";
  const std::size_t dash = name.find('-');
  if (dash == std::string::npos || !name.ends_with(ending)) return std::nullopt;
  const std::string_view number = std::string_view(name).substr(dash + 1, name.size() - ending.size() - dash - 1);
  if (number.empty() || number.find_first_not_of(digits) != std::string_view::npos) return std::nullopt;
  pid_t pid = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + dash, pid);
  if (error != std::errc() || end != name.data() + dash || pid <= 0) return std::nullopt;
  return pid;
}

// ---- what is in it --------------------------------------------------------------------------------------------------

struct Stored {
  Autosave work;
  std::string birth;
};

std::optional<Stored> read_stored(const fs::path& file) {
  Diagnostics diagnostics;
  const auto document = read_kept(file, autosave_limits, diagnostics);
  if (!document) return std::nullopt;
  const Cursor root(*document, diagnostics);
  const auto text = [&](std::string_view key) -> std::string {
    const auto at = root.required(key);
    if (at && !at->is(Json::Kind::string)) at->error("must be a string");
    return at ? at->json().text : std::string();
  };
  if (!root.is(Json::Kind::object) || text("schema") != autosave_schema) return std::nullopt;
  Stored stored{{file, text("origin"), text("title"), text("content"), 0}, text("started")};
  if (const auto step = root.required("step"))
    stored.work.step = static_cast<std::uint32_t>(step->integer(0, std::numeric_limits<int>::max()).value_or(0));
  return diagnostics.empty() ? std::optional(std::move(stored)) : std::nullopt;
}

struct Candidate {
  fs::file_time_type time;
  fs::path file;
  pid_t pid;
};

std::vector<Candidate> candidates(const fs::path& folder) {
  std::vector<Candidate> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const auto pid = pid_in(it->path().filename().string());
    std::error_code unknown;
    // symlink_status: what a link points to was not written here, and may be anything.
    if (!pid || it->symlink_status(unknown).type() != fs::file_type::regular) continue;
    found.push_back({it->last_write_time(unknown), it->path(), *pid});
  }
  std::ranges::sort(found, [](const Candidate& a, const Candidate& b) {
    return std::tie(b.time, b.file) < std::tie(a.time, a.file);
  });
  return found;
}

}  // namespace

fs::path autosave_file(const Places& places) {
  const fs::path folder = folder_of(places);
  if (folder.empty()) return {};
  // One that is there already is lost work of an earlier process with the same id.
  static std::atomic<unsigned> count{0};
  for (;;) {
    fs::path file = folder / (std::to_string(::getpid()) + "-" + std::to_string(count++) + ".json");
    std::error_code error;
    if (!fs::exists(fs::symlink_status(file, error))) return file;
  }
}

Checked<bool> write_autosave(const Places& places, const Autosave& work) {
  if (folder_of(places).empty() || work.file.empty()) return false;
  const std::string text =
      "{\"schema\": " + json_quote(autosave_schema) + ",\n \"started\": " + json_quote(birth_of(::getpid())) +
      ",\n \"origin\": " + json_quote(work.origin.string()) + ",\n \"title\": " + json_quote(work.title) +
      ",\n \"step\": " + std::to_string(work.step) + ",\n \"content\": " + json_quote(work.content) + "}\n";
  if (text.size() > most_autosave_bytes)
    return Diagnostics{{work.file.string(), 0, 0, "", "cannot be kept: it would have more than 16 MB"}};
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(work.file, error))) fs::remove(work.file, error);
  return write_kept(work.file, text);
}

std::vector<Autosave> lost_work(const Places& places) {
  std::vector<Autosave> lost;
  if (places.state.empty()) return lost;
  for (const Candidate& candidate : candidates(folder_of(places))) {
    if (lost.size() == most_offered) break;
    auto stored = read_stored(candidate.file);
    if (stored && is_gone(candidate.pid, stored->birth)) lost.push_back(std::move(stored->work));
  }
  return lost;
}

void discard(const Autosave& work) {
  std::error_code error;
  if (!work.file.empty()) fs::remove(work.file, error);
}

}  // namespace blossom
