// blossom list: what there is to learn.

#include <algorithm>
#include <iostream>
#include <map>

#include "app/input.hpp"
#include "app/text.hpp"
#include "base/json_write.hpp"
#include "lesson/catalog.hpp"
#include "lesson/file_kind.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

struct SceneEntry {
  std::string name, title;
};

// The scenes of a folder, by name: what they are called. Whether they are in order, `blossom lint` says.
std::vector<SceneEntry> scenes_in(const fs::path& folder) {
  std::vector<SceneEntry> scenes;
  Diagnostics none;  // a folder that cannot be read has no scenes
  for (const auto& file : json_files(folder, none)) {
    const auto document = JsonDocument::load(file);
    if (!document || file_kind(document->root()) != FileKind::scene) continue;
    const Json* title = document->root().find("title");
    scenes.push_back({file.stem().string(), title != nullptr ? title->text : std::string()});
  }
  return scenes;
}

std::string of(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string duration(int minutes) {
  if (minutes < 60) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h" + (minutes % 60 == 0 ? "" : " " + std::to_string(minutes % 60) + " min");
}

using Entries = std::vector<const CatalogEntry*>;

// The lessons of each unit, in the order of the course; a unit stands where its first lesson does.
std::vector<std::pair<std::string, Entries>> by_unit(const Entries& entries) {
  std::vector<std::pair<std::string, Entries>> units;
  std::map<std::string, std::size_t> known;
  for (const CatalogEntry* entry : entries) {
    const std::string& unit = entry->lesson.unit.own();
    const auto [at, is_new] = known.emplace(unit, units.size());
    if (is_new) units.emplace_back(unit, Entries());
    units[at->second].second.push_back(entry);
  }
  return units;
}

std::string lower(std::string text) {
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// The lessons of the units that have this in their names. A unit of exactly this name is meant alone.
Entries of_unit(const Catalog& catalog, const std::string& wanted) {
  Entries exactly, partly;
  std::vector<std::string> units;
  for (const CatalogEntry& entry : catalog.lessons) {
    const std::string unit = lower(entry.lesson.unit.own());
    if (unit == lower(wanted)) exactly.push_back(&entry);
    if (unit.find(lower(wanted)) != std::string::npos) partly.push_back(&entry);
    if (std::ranges::find(units, entry.lesson.unit.own()) == units.end()) units.push_back(entry.lesson.unit.own());
  }
  if (!exactly.empty()) return exactly;
  if (!partly.empty()) return partly;
  std::string message = "there is no unit " + excerpt(wanted);
  if (const auto near = did_you_mean(wanted, units))
    throw CLI::ValidationError("--unit", message + "; did you mean " + excerpt(*near) + "?");
  message += "; the units are";
  for (const std::string& unit : units) message += (unit == units.front() ? " " : ", ") + excerpt(unit);
  throw CLI::ValidationError("--unit", message);
}

std::size_t checkpoints_of(const Lesson& lesson) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < lesson.scene_count(); ++i)
    count += static_cast<std::size_t>(
        std::ranges::count_if(lesson.scene_at(i).beats, [](const Beat& beat) { return beat.checkpoint.has_value(); }));
  return count;
}

void write_lessons(const Entries& entries) {
  for (const auto& [unit, lessons] : by_unit(entries)) {
    int minutes = 0;
    std::vector<std::vector<std::string>> rows;
    for (const CatalogEntry* entry : lessons) {
      const Lesson& lesson = entry->lesson;
      minutes += lesson.minutes;
      rows.push_back(
          {printable(entry->file.stem().string()), printable(lesson.title.own()),
           lesson.minutes > 0 ? (lesson.minutes < 10 ? " " : "") + std::to_string(lesson.minutes) + " min" : "",
           lesson.exercises.empty() ? "" : of(lesson.exercises.size(), "exercise")});
      while (rows.back().back().empty()) rows.back().pop_back();  // no blanks at the end of a line
    }
    std::cout << "\n"
              << (unit.empty() ? "Of no unit" : printable(unit)) << " (" << of(lessons.size(), "lesson")
              << (minutes > 0 ? ", " + duration(minutes) : "") << ")\n"
              << table(rows);
  }
}

// ---- for tools ------------------------------------------------------------------------------------------------------

Json strings(const auto& texts) {
  std::vector<Json> items;
  for (const auto& text : texts) items.push_back(json_string(text));
  return json_array(std::move(items));
}

Json lesson_json(const CatalogEntry& entry) {
  const Lesson& lesson = entry.lesson;
  std::vector<std::string_view> algorithms;
  for (std::size_t i = 0; i < lesson.scene_count(); ++i)
    if (const auto id = lesson.scene_at(i).algorithm->id; std::ranges::find(algorithms, id) == algorithms.end())
      algorithms.push_back(id);
  std::vector<std::string> languages{lesson.languages.own};
  languages.insert(languages.end(), lesson.languages.others.begin(), lesson.languages.others.end());
  return json_object({{"file", json_string(entry.file.string())},
                      {"id", json_string(lesson.id)},
                      {"title", json_string(lesson.title.own())},
                      {"unit", json_string(lesson.unit.own())},
                      {"summary", json_string(lesson.summary.own())},
                      {"minutes", json_number(std::to_string(lesson.minutes))},
                      {"algorithms", strings(algorithms)},
                      {"scenes", json_number(std::to_string(lesson.scene_count()))},
                      {"checkpoints", json_number(std::to_string(checkpoints_of(lesson)))},
                      {"prerequisites", strings(lesson.prerequisites)},
                      {"exercises", strings(lesson.exercises)},
                      {"languages", strings(languages)}});
}

void write_for_tools(const Entries& entries, const std::vector<SceneEntry>& scenes) {
  std::vector<Json> lessons, of_scenes, of_algorithms;
  for (const CatalogEntry* entry : entries) lessons.push_back(lesson_json(*entry));
  for (const SceneEntry& scene : scenes)
    of_scenes.push_back(json_object({{"name", json_string(scene.name)}, {"title", json_string(scene.title)}}));
  for (const Algorithm* a : algorithms())
    of_algorithms.push_back(json_object(
        {{"id", json_string(a->id)}, {"title", json_string(a->title)}, {"summary", json_string(a->summary)}}));
  std::cout << write_json(json_object({{"lessons", json_array(std::move(lessons))},
                                       {"scenes", json_array(std::move(of_scenes))},
                                       {"algorithms", json_array(std::move(of_algorithms))}}))
            << "\n";
}

// ---- the command ----------------------------------------------------------------------------------------------------

struct Given {
  std::string folder;
  std::string unit;
  std::string format = "text";
};

int list(const Given& given) {
  const fs::path folder = given.folder.empty() ? find_folder("lessons") : fs::path(given.folder);
  std::error_code error;
  const bool has_lessons = !given.folder.empty() || fs::exists(folder, error);
  const Catalog catalog = has_lessons ? load_catalog(folder) : Catalog();
  Entries entries;
  for (const CatalogEntry& entry : catalog.lessons) entries.push_back(&entry);
  if (!given.unit.empty()) entries = of_unit(catalog, given.unit);
  const auto scenes = has_lessons && given.unit.empty() ? scenes_in(folder / "scenes") : std::vector<SceneEntry>();
  if (given.format == "json") {
    write_for_tools(entries, scenes);
    return report(catalog.diagnostics);
  }
  if (has_lessons) {
    std::cout << "Lessons in " << printable(folder.string()) << "\n";
    write_lessons(entries);
  } else {
    std::cout << "There is no folder `lessons` here: go to one that has it, or name another with --lessons.\n";
  }
  std::vector<std::vector<std::string>> rows;
  for (const SceneEntry& scene : scenes) rows.push_back({printable(scene.name), printable(scene.title)});
  if (!rows.empty()) std::cout << "\nScenes in " << printable((folder / "scenes").string()) << "\n" << table(rows);
  if (given.unit.empty()) {
    rows.clear();
    for (const Algorithm* a : algorithms()) rows.push_back({std::string(a->id), std::string(a->summary)});
    std::cout << "\nAlgorithms\n" << table(rows);
  }
  if (has_lessons)
    std::cout << "\nNext: blossom play LESSON, blossom step LESSON, blossom export LESSON --to html, blossom describe "
                 "ALGORITHM, blossom new lesson --algorithm ALGORITHM\n";
  else
    std::cout << "\nNext: blossom describe ALGORITHM, blossom trace --algorithm ALGORITHM --inputs FILE\n";
  return report(catalog.diagnostics);
}

void set_up(CLI::App& app, int& status) {
  auto given = std::make_shared<Given>();
  app.add_option("--lessons", given->folder, "The folder of lessons; by default `lessons`");
  app.add_option("--unit", given->unit, "Only the lessons of the units that have this in their names");
  app.add_option("--format", given->format, "text, to be read, or json, for programs")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  app.footer(
      "Examples:\n"
      "  blossom list\n"
      "  blossom list --unit bézier\n"
      "  blossom list --format json");
  app.callback([given, &status] { status = list(*given); });
}

}  // namespace

const Command& command_list() {
  static const Command command{"list", "List the lessons by unit, the scenes and the algorithms", 10, set_up};
  return command;
}

}  // namespace blossom
