// blossom list: what there is to learn.

#include <iostream>

#include "app/input.hpp"
#include "lesson/catalog.hpp"

namespace blossom {
namespace {

void print_rows(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c + 1 < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (const auto& row : rows) {
    std::cout << "  ";
    for (std::size_t c = 0; c < row.size(); ++c)
      std::cout << row[c] << (c + 1 < row.size() ? std::string(widths[c] - row[c].size() + 2, ' ') : "\n");
  }
}

int list(const std::string& given) {
  const std::filesystem::path folder = given.empty() ? find_folder("lessons") : std::filesystem::path(given);
  const Catalog catalog = load_catalog(folder);
  std::vector<std::vector<std::string>> rows;
  for (const auto& entry : catalog.lessons)
    rows.push_back({entry.file.stem().string(), entry.lesson.title, std::string(entry.lesson.algorithm->id)});
  std::cout << "Lessons in " << folder.string() << "\n";
  print_rows(rows);
  rows.clear();
  std::cout << "\nAlgorithms\n";
  for (const Algorithm* a : algorithms()) rows.push_back({std::string(a->id), std::string(a->summary)});
  print_rows(rows);
  std::cout << "\nNext: blossom trace LESSON, blossom play LESSON, blossom render LESSON --all\n";
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
  static const Command command{"list", "List the lessons and the algorithms", 10, set_up};
  return command;
}

}  // namespace blossom
