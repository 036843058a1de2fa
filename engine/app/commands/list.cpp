// blossom list: what there is to learn.

#include <iostream>

#include "app/input.hpp"
#include "app/text.hpp"
#include "lesson/catalog.hpp"
#include "lesson/file_kind.hpp"

namespace blossom {
namespace {

// The scenes of a folder, by name: what they are called. Whether they are in order, `blossom lint` says.
std::vector<std::vector<std::string>> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::vector<std::string>> rows;
  Diagnostics none;  // a folder that cannot be read has no scenes
  for (const auto& file : json_files(folder, none)) {
    const auto document = JsonDocument::load(file);
    if (!document || file_kind(document->root()) != FileKind::scene) continue;
    const Json* title = document->root().find("title");
    rows.push_back({printable(file.stem().string()), title != nullptr ? printable(title->text) : std::string()});
  }
  return rows;
}

int list(const std::string& given) {
  const std::filesystem::path folder = given.empty() ? find_folder("lessons") : std::filesystem::path(given);
  std::error_code error;
  const bool has_lessons = !given.empty() || std::filesystem::exists(folder, error);
  Catalog catalog;
  std::vector<std::vector<std::string>> rows;
  if (has_lessons) {
    catalog = load_catalog(folder);
    for (const auto& entry : catalog.lessons)
      rows.push_back({printable(entry.file.stem().string()), printable(entry.lesson.title),
                      std::string(entry.lesson.algorithm->id)});
    std::cout << "Lessons in " << printable(folder.string()) << "\n" << table(rows);
    if (const auto scenes = scenes_in(folder / "scenes"); !scenes.empty())
      std::cout << "\nScenes in " << printable((folder / "scenes").string()) << "\n" << table(scenes);
  } else {
    std::cout << "There is no folder `lessons` here: go to one that has it, or name another with --lessons.\n";
  }
  rows.clear();
  for (const Algorithm* a : algorithms()) rows.push_back({std::string(a->id), std::string(a->summary)});
  std::cout << "\nAlgorithms\n" << table(rows) << "\nNext: ";
  if (has_lessons)
    std::cout << "blossom trace LESSON, blossom step LESSON, blossom play LESSON, blossom render LESSON --all\n";
  else
    std::cout << "blossom trace --algorithm ALGORITHM --inputs FILE (see blossom trace --help)\n";
  return report(catalog.diagnostics);
}

void set_up(CLI::App& app, int& status) {
  auto folder = std::make_shared<std::string>();
  app.add_option("--lessons", *folder, "The folder of lessons; by default `lessons`");
  app.footer("Example:\n  blossom list");
  app.callback([folder, &status] { status = list(*folder); });
}

}  // namespace

const Command& command_list() {
  static const Command command{"list", "List the lessons, the scenes and the algorithms", 10, set_up};
  return command;
}

}  // namespace blossom
