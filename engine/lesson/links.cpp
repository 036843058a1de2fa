#include "lesson/links.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <set>

#include "lesson/catalog.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/prose.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// One name for a folder, however it is said.
fs::path normal(const fs::path& folder) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
  return error ? folder.lexically_normal() : path;
}

std::string text_at(const Json& object, std::string_view key) {
  const Json* found = object.find(key);
  return found != nullptr && found->kind == Json::Kind::string ? found->text : std::string();
}

template <class Map>
std::vector<std::string> ids_of(const Map& map) {
  std::vector<std::string> ids;
  for (const auto& [id, entry] : map) ids.push_back(id);
  return ids;
}

template <class Map>
fs::path file_of(const Map& map, const std::string& id) {
  const auto found = map.find(id);
  return found != map.end() ? found->second.file : fs::path();
}

}  // namespace

void CourseIndex::add(const fs::path& file, const JsonDocument& document) {
  Folder& folder = folders_[normal(file.parent_path())];
  folder.files[file.filename()] = true;
  const Json& root = document.root();
  const FileKind kind = file_kind(root);
  const std::string id = text_at(root, "id");
  if (id.empty() || (kind != FileKind::lesson && kind != FileKind::exercise)) return;
  Entry entry{file, {}};
  if (const Json* before = root.find("prerequisites"); before != nullptr && before->kind == Json::Kind::array)
    for (const Json& item : before->items)
      if (item.kind == Json::Kind::string) entry.prerequisites.push_back(item.text);
  (kind == FileKind::lesson ? folder.lessons : folder.exercises).try_emplace(id, std::move(entry));
}

void CourseIndex::add_folder(const fs::path& path) {
  const fs::path name = normal(path);
  if (folders_[name].whole) return;
  folders_[name].whole = true;
  Diagnostics none;  // a folder that cannot be read has no files
  for (const fs::path& file : json_files(path.empty() ? fs::path(".") : path, none)) {
    if (folders_[name].files.contains(file.filename())) continue;
    if (const auto document = JsonDocument::load(file)) add(file, *document);
  }
}

const CourseIndex::Folder* CourseIndex::find(const fs::path& folder) const {
  const auto found = folders_.find(normal(folder));
  return found != folders_.end() ? &found->second : nullptr;
}

bool CourseIndex::has_lesson(const fs::path& folder, const std::string& id) const {
  const Folder* here = find(folder);
  return here != nullptr && here->lessons.contains(id);
}

bool CourseIndex::has_exercise(const fs::path& folder, const std::string& id) const {
  const Folder* here = find(folder);
  return here != nullptr && here->exercises.contains(id);
}

fs::path CourseIndex::lesson_file(const fs::path& folder, const std::string& id) const {
  const Folder* here = find(folder);
  return here != nullptr ? file_of(here->lessons, id) : fs::path();
}

fs::path CourseIndex::exercise_file(const fs::path& folder, const std::string& id) const {
  const Folder* here = find(folder);
  return here != nullptr ? file_of(here->exercises, id) : fs::path();
}

std::vector<std::string> CourseIndex::lessons(const fs::path& folder) const {
  const Folder* here = find(folder);
  return here != nullptr ? ids_of(here->lessons) : std::vector<std::string>();
}

std::vector<std::string> CourseIndex::exercises(const fs::path& folder) const {
  const Folder* here = find(folder);
  return here != nullptr ? ids_of(here->exercises) : std::vector<std::string>();
}

std::vector<std::string> CourseIndex::way_back(const fs::path& folder, const std::string& lesson,
                                               const std::string& prerequisite) const {
  const Folder* here = find(folder);
  if (here == nullptr) return {};
  std::map<std::string, std::string, std::less<>> reached_from{{prerequisite, {}}};
  std::deque<std::string> open{prerequisite};
  while (!open.empty() && !reached_from.contains(lesson)) {
    const auto entry = here->lessons.find(open.front());
    if (entry != here->lessons.end())
      for (const std::string& next : entry->second.prerequisites)
        if (reached_from.emplace(next, open.front()).second) open.push_back(next);
    open.pop_front();
  }
  if (!reached_from.contains(lesson)) return {};
  std::vector<std::string> way;
  for (std::string at = lesson; !at.empty(); at = reached_from.find(at)->second) way.push_back(at);
  std::ranges::reverse(way);
  return way;
}

std::vector<fs::path> folders_of_exercises(const fs::path& lesson) {
  const fs::path own = lesson.parent_path();
  return {own, (own.empty() ? fs::path(".") : own) / ".." / "exercises"};
}

Diagnostics check_links(const JsonDocument& document, const CourseIndex& index, const CourseFolders& course) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  const fs::path file = document.name();
  const std::string own = text_at(document.root(), "id");
  const auto each = [&](std::string_view key, auto&& check) {
    const auto list = root.optional(key);
    for (std::size_t i = 0; list && list->is(Json::Kind::array) && i < list->size(); ++i)
      if ((*list)[i].is(Json::Kind::string)) check((*list)[i], (*list)[i].json().text);
  };
  const auto meant = [](const std::string& id, const std::vector<std::string>& known) {
    const auto near = did_you_mean(id, known);
    return near ? "; did you mean " + excerpt(*near) + "?" : std::string();
  };
  each("prerequisites", [&](const Cursor& at, const std::string& id) {
    const fs::path folder = file.parent_path();
    if (!index.has_lesson(folder, id)) {
      if (!course.lessons.empty() && index.has_lesson(course.lessons, id)) return;
      auto known = index.lessons(folder);
      if (!course.lessons.empty())
        for (std::string& other : index.lessons(course.lessons)) known.push_back(std::move(other));
      return at.error("no lesson beside this file or in the course has the id " + excerpt(id) + meant(id, known));
    }
    if (id == own) return;  // that is told already
    const auto way = index.way_back(folder, own, id);
    if (way.empty()) return;
    std::string circle = excerpt(own);
    for (const std::string& next : way) circle += " needs " + excerpt(next) + (next == way.back() ? "" : ", which");
    at.error("prerequisites go in a circle: " + circle);
  });
  each("exercises", [&](const Cursor& at, const std::string& id) {
    std::vector<std::string> known;
    auto folders = folders_of_exercises(file);
    if (!course.exercises.empty()) folders.push_back(course.exercises);
    for (const fs::path& folder : folders) {
      if (index.has_exercise(folder, id)) return;
      const auto here = index.exercises(folder);
      known.insert(known.end(), here.begin(), here.end());
    }
    at.error("no exercise beside this file, in ../exercises or in the course has the id " + excerpt(id) +
             meant(id, known));
  });
  return diagnostics;
}

namespace {

void check_words(const Cursor& at, const fs::path& folder) {
  if (at.json().text.find("](") == std::string::npos) return;
  std::set<std::string> told;
  for (const Block& block : read_prose(at.json().text))
    for (const Span& span : block.spans) {
      const std::string file = span.link.substr(0, span.link.find_first_of("#?"));
      std::error_code error;
      if (file.empty() || file.find(':') != std::string::npos || fs::exists(folder / file, error)) continue;
      if (told.insert(file).second) at.error("there is no file " + excerpt(file) + " beside this one");
    }
}

// Strings under the keys that hold words, in whatever languages.
void check_below(const Cursor& at, bool words, const fs::path& folder) {
  static constexpr std::array<std::string_view, 8> keys{"say",   "ask",  "right",    "wrong",
                                                        "items", "text", "feedback", "prompt"};
  if (words && at.is(Json::Kind::string)) return check_words(at, folder);
  for (std::size_t i = 0; at.is(Json::Kind::array) && i < at.size(); ++i) check_below(at[i], words, folder);
  for (std::size_t i = 0; at.is(Json::Kind::object) && i < at.size(); ++i) {
    const std::string& key = at.json().keys[i];
    if (key == "inputs" || key == "$comment") continue;
    check_below(at.member(i), words || std::ranges::find(keys, key) != keys.end(), folder);
  }
}

}  // namespace

Diagnostics check_addresses(const JsonDocument& document) {
  Diagnostics diagnostics;
  check_below(Cursor(document, diagnostics), false, fs::path(document.name()).parent_path());
  return diagnostics;
}

Diagnostics check_id(const JsonDocument& document, const CourseIndex& index) {
  Diagnostics diagnostics;
  const fs::path file = document.name();
  const std::string id = text_at(document.root(), "id");
  const fs::path first = file_kind(document.root()) == FileKind::lesson ? index.lesson_file(file.parent_path(), id)
                                                                        : index.exercise_file(file.parent_path(), id);
  if (!first.empty() && first.filename() != file.filename())
    Cursor(document, diagnostics)
        .optional("id")
        ->error(excerpt(id) + " is the id of " + first.string() + " already; each needs one of its own");
  return diagnostics;
}

}  // namespace blossom
