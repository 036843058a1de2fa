#include "lesson/catalog.hpp"

#include <algorithm>
#include <system_error>

#include "lesson/file_kind.hpp"

namespace blossom {
std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder, Diagnostics& diagnostics) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.ends_with(".json") && !name.ends_with(".schema.json")) files.push_back(it->path());
  }
  if (error) diagnostics.push_back({folder.string(), 0, 0, "", "cannot read this folder: " + error.message()});
  std::sort(files.begin(), files.end());
  return files;
}

const CatalogEntry* Catalog::find(std::string_view id) const {
  const auto found = by_id.find(id);
  return found != by_id.end() ? &lessons[found->second] : nullptr;
}

Catalog load_catalog(const std::filesystem::path& folder) {
  Catalog catalog;
  const auto add = [&](const Diagnostics& more) {
    catalog.diagnostics.insert(catalog.diagnostics.end(), more.begin(), more.end());
  };
  for (const auto& file : json_files(folder, catalog.diagnostics)) {
    const auto document = JsonDocument::load(file);
    if (!document) {
      add(document.diagnostics);
      continue;
    }
    const FileKind kind = file_kind(document->root());
    if (kind != FileKind::lesson && kind != FileKind::unknown) continue;
    auto lesson = load_lesson(*document);
    if (!lesson) {
      add(lesson.diagnostics);
      continue;
    }
    if (const CatalogEntry* other = catalog.find(lesson->id)) {
      const auto [line, column] = document->line_and_column(document->root().find("id")->token);
      add({{document->name(), line, column, "id",
            excerpt(lesson->id) + " is the id of " + other->file.string() + " already"}});
      continue;
    }
    catalog.by_id.emplace(lesson->id, catalog.lessons.size());
    catalog.lessons.push_back({file, *std::move(lesson)});
  }
  return catalog;
}

}  // namespace blossom
