#pragma once
// Other programs' files. One format is one file of this folder, which defines `const ExchangeFormat& format_NAME()`.

#include <filesystem>

#include "studio/workspace.hpp"

namespace blossom {

// What was read: things to be added to a scene, and what in the file could not be taken, as words for people.
struct Imported {
  std::vector<SceneObject> objects;
  std::vector<std::string> notes;  // "2 trimmed surfaces are taken without their trimming curves"
};
// What is written, and what of the scene the format cannot hold.
struct Exported {
  std::string bytes;
  std::vector<std::string> notes;  // "colours and names are left out", "3 surfaces are written as triangles"
};

struct ExportOptions {
  std::vector<std::size_t> objects;  // empty: all that are not hidden
  double tolerance = 0.001;          // of meshes and polylines: share of the size of all of it
  int digits = 17;                   // of decimals, where the format has text
};

struct ExchangeFormat {
  std::string_view id;                       // "obj"
  std::string_view title;                    // "Wavefront OBJ"
  std::vector<std::string_view> extensions;  // ".obj", the first is what new files get
  std::string_view holds;                    // "Curves and surfaces exactly (curv, surf), or meshes"
  // nullptr: it cannot be read (written). Files are hostile: bounded time and memory, every mistake with its line.
  Checked<Imported> (*import)(const std::string& name, std::string_view bytes) = nullptr;
  Checked<Exported> (*write)(const Workspace&, const ExportOptions&) = nullptr;
};

const std::vector<const ExchangeFormat*>& exchange_formats();
const ExchangeFormat* format_of(const std::filesystem::path&);  // by its extension; nullptr: none

inline constexpr std::size_t most_import_bytes = 64u << 20;
Checked<Imported> import_file(const std::filesystem::path&);
// Writes it to a temporary name and renames; the notes of what was left out.
Checked<std::vector<std::string>> export_file(const Workspace&, const std::filesystem::path&,
                                              const ExportOptions& = {});

}  // namespace blossom
