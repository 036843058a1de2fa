// blossom lint: every mistake of lessons, exercises, geometry and answers, each at its line and column.

#include <algorithm>
#include <iostream>

#include "app/input.hpp"
#include "geometry/document.hpp"
#include "grader/exercise.hpp"
#include "lesson/file_kind.hpp"
#include "algorithms/trace_json.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// The files meant: a folder means the *.json files in it, except JSON Schemas.
std::vector<fs::path> expand(const std::vector<std::string>& given) {
  std::vector<fs::path> files;
  for (const std::string& name : given) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(name, error))
      if (entry.path().extension() == ".json" && !entry.path().stem().string().ends_with(".schema")) found.push_back(entry.path());
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

Diagnostics lint(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  switch (file_kind(document.root())) {
    case FileKind::lesson: return load_lesson(document).diagnostics;
    case FileKind::exercise: return read_exercise(document).diagnostics;
    case FileKind::trace: return read_trace(document).diagnostics;
    case FileKind::curve: read_curve(root); break;
    case FileKind::surface: read_surface(root); break;
    case FileKind::answers:
    case FileKind::grade: break;
    case FileKind::unknown:
      root.error(
          "is no file of Blossom's: \"schema\" must be \"blossom.lesson/1\", \"blossom.exercise/1\", \"blossom.answers/1\" or "
          "\"blossom.trace/1\"; a curve or surface has \"degree\" and \"points\"");
      break;
  }
  return diagnostics;
}

int run(const std::vector<std::string>& given) {
  Diagnostics all;
  std::size_t good = 0;
  for (const fs::path& file : expand(given)) {
    const auto document = JsonDocument::load(file);
    const Diagnostics found = document ? lint(*document) : document.diagnostics;
    good += found.empty() ? 1 : 0;
    all.insert(all.end(), found.begin(), found.end());
  }
  std::cout << good << (good == 1 ? " file is" : " files are") << " in order";
  if (!all.empty()) std::cout << ", " << all.size() << (all.size() == 1 ? " mistake" : " mistakes") << " in the others";
  std::cout << "\n";
  return report(all);
}

void set_up(CLI::App& app, int& status) {
  auto files = std::make_shared<std::vector<std::string>>();
  app.add_option("FILES", *files, "Files, or folders of them; by default `lessons` and `exercises`");
  app.footer(
      "Names every mistake at once, as file:line:column: path: what is wrong, and what would be right.\n"
      "Examples:\n"
      "  blossom lint\n"
      "  blossom lint my-lesson.json exercises\n"
      "Exit status: 0 all in order, 1 mistakes, 2 wrong usage.");
  app.callback([files, &status] {
    if (files->empty()) *files = {find_folder("lessons").string(), find_folder("exercises").string()};
    status = run(*files);
  });
}

}  // namespace

const Command& command_lint() {
  static const Command command{"lint", "Check lessons, exercises, geometry, answers and traces", 40, set_up};
  return command;
}

}  // namespace blossom
