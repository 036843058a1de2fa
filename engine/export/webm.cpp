// A film for pages whose formats are to be free: VP9.

#include "export/export_film.hpp"

namespace blossom {
namespace {

// A fixed number of threads and columns, because the encoder's result depends on them.
const FilmFormat film{"webm",
                      30,
                      {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "4",
                       "-threads", "4", "-tile-columns", "2", "-row-mt", "0", "-g", "150"}};

Checked<LessonExported> write(const Story& story, const std::filesystem::path& out,
                              const LessonExportOptions& options) {
  return write_film(story, out, options, film);
}

}  // namespace

const LessonFormat& lesson_webm() {
  static const LessonFormat format{"webm",
                                   "Film (WebM)",
                                   ".webm",
                                   false,
                                   "a film, VP9, free of patents; needs ffmpeg",
                                   write,
                                   export_use::size | export_use::scale | export_use::time};
  return format;
}

}  // namespace blossom
