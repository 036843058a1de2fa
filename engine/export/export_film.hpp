#pragma once
// Films of lessons. The pictures are drawn here and encoded by the program ffmpeg, beside the drawing. What a step
// makes moves to its place, and the camera to where it sees it from; then the picture stays until its words are read. A
// question stands on a card before the picture until one has thought about it, and then with its answer. A picture that
// stays is drawn and encoded once.

#include <string>
#include <string_view>
#include <vector>

#include "export/export.hpp"

namespace blossom {

struct FilmFormat {
  std::string_view muxer;            // as ffmpeg calls it
  double frames_per_second = 30;     // by default
  std::vector<std::string> encoder;  // ffmpeg's options
  bool palette = false;              // at most 256 colours, found in a first pass over some of the pictures
};

// One picture of a film and how long it is seen.
struct FilmShot {
  const StoryScene* scene = nullptr;
  const StoryStep* step = nullptr;
  double motion = 1, glide = 1;  // how far the step and the camera have come
  std::size_t frames = 1;
  enum class Card : std::uint8_t { none, question, answer } card = Card::none;
};
// Of at most this many hours.
inline constexpr double longest_film = 4;
Checked<std::vector<FilmShot>> film_shots(const Story&, const LessonExportOptions&, double frames_per_second);

// How long a text is read: that of a slow reader, who also looks at the picture.
double reading_seconds(std::string_view words);

Checked<LessonExported> write_film(const Story&, const std::filesystem::path& out, const LessonExportOptions&,
                                   const FilmFormat&);

}  // namespace blossom
