#pragma once
// The lessons of a folder.

#include <filesystem>
#include <map>
#include <vector>

#include "lesson/lesson.hpp"

namespace blossom {

struct CatalogEntry {
  std::filesystem::path file;
  Lesson lesson;
};

struct Catalog {
  std::vector<CatalogEntry> lessons;  // by file name, which is the order of the course
  Diagnostics diagnostics;            // of the files that are no lessons for a mistake in them

  const CatalogEntry* find(std::string_view id) const;  // or nullptr

  std::map<std::string, std::size_t, std::less<>> by_id;  // places in `lessons`
};

// The *.json of the folder itself, by name, except JSON Schemas (*.schema.json). A folder that cannot be read is a
// diagnostic.
std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder, Diagnostics&);

// Every *.json of the folder itself that is a lesson or would be one but for its mistakes (a file of another kind
// is none). Two lessons of one id are a mistake of the second. A folder that cannot be read is a
// diagnostic.
Catalog load_catalog(const std::filesystem::path& folder);

}  // namespace blossom
