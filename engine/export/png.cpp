// Each step as a picture of pixels, with what is said as its description.

#include "export/export.hpp"
#include "render/picture.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

Checked<LessonExported> write(const Story& story, const fs::path& folder, const LessonExportOptions& options) {
  return write_pages(story, folder, ".png", options, [&](const Scene& page, const fs::path& file) -> Checked<bool> {
    const auto image = draw_image(page, *options.theme, options.scale);
    if (!image) return image.diagnostics;
    return write_png(file, *image, page.title, page.description);
  });
}

}  // namespace

const LessonFormat& lesson_png() {
  static const LessonFormat format{
      "png", "PNG pictures", ".png", true, "a picture for each step", write, export_use::size | export_use::scale};
  return format;
}

}  // namespace blossom
