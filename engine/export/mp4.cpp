// A film for lecture slides, course pages and phones: H.264, which everything plays.

#include "export/export_film.hpp"

namespace blossom {
namespace {

// A fixed number of threads, because the encoder's result depends on it; whole colours of thin lines come from "crf",
// and the index at the beginning lets a page play the film while it is fetched.
const FilmFormat film{"mp4",
                      30,
                      {"-c:v", "libx264", "-preset", "medium", "-tune", "animation", "-crf", "18", "-profile:v", "high",
                       "-threads", "4", "-g", "150", "-movflags", "+faststart"}};

Checked<LessonExported> write(const Story& story, const std::filesystem::path& out,
                              const LessonExportOptions& options) {
  return write_film(story, out, options, film);
}

}  // namespace

const LessonFormat& lesson_mp4() {
  static const LessonFormat format{"mp4",
                                   "Film (MP4)",
                                   ".mp4",
                                   false,
                                   "a film, H.264, for slides and phones; needs ffmpeg",
                                   write,
                                   export_use::size | export_use::scale | export_use::time};
  return format;
}

}  // namespace blossom
