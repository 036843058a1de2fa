// Each step as a picture that can be scaled and whose text stays text.

#include "base/json.hpp"
#include "export/export.hpp"
#include "render/picture.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

Checked<LessonExported> write(const Story& story, const fs::path& folder, const LessonExportOptions& options) {
  return write_pages(story, folder, ".svg", options, [&](const Scene& page, const fs::path& file) -> Checked<bool> {
    const auto text = draw_svg(page, *options.theme);
    if (!text) return text.diagnostics;
    return write_file(file, *text);
  });
}

}  // namespace

const LessonFormat& lesson_svg() {
  static const LessonFormat format{"svg", "SVG pictures",  ".svg", true, "a picture for each step, text as text",
                                   write, export_use::size};
  return format;
}

}  // namespace blossom
