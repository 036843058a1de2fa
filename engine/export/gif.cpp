// A film that stands in a page or a message like a picture, and repeats.

#include "export/export_film.hpp"

namespace blossom {
namespace {

// Browsers show a GIF in hundredths of a second, so 20 frames of 5 each.
const FilmFormat film{"gif", 20, {"-c:v", "gif", "-loop", "0"}, true};

Checked<LessonExported> write(const Story& story, const std::filesystem::path& out,
                              const LessonExportOptions& options) {
  return write_film(story, out, options, film);
}

}  // namespace

const LessonFormat& lesson_gif() {
  static const LessonFormat format{"gif",
                                   "Moving picture (GIF)",
                                   ".gif",
                                   false,
                                   "a film that stands in a page like a picture; needs ffmpeg",
                                   write,
                                   export_use::size | export_use::scale | export_use::time};
  return format;
}

}  // namespace blossom
