#include "export/export_film.hpp"

#include <algorithm>
#include <cmath>

#include "base/scalar.hpp"
#include "base/utf8.hpp"
#include "export/export_encoder.hpp"
#include "export/export_staging.hpp"
#include "export/handout_text.hpp"
#include "render/picture.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr double motion_seconds = 0.6;
constexpr double last_seconds = 1.5;    // the end stays longer
constexpr double waiting_seconds = 2;   // where a lesson waits for the student
constexpr double thinking_seconds = 3;  // about a question that is read
constexpr std::size_t palette_pictures = 24;

double eased(double t) { return t * t * (3 - 2 * t); }

// Whether anything of the picture moves at a step.
bool moves(const StoryScene& scene, std::uint32_t step) {
  return scene.picture(step, 320, 240, 0.25) != scene.picture(step, 320, 240);
}

std::string size_of(const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); }

std::string hex(Color c) {
  constexpr char digits[] = "0123456789ABCDEF";
  std::string text = "0x";
  for (const int channel : {c.r, c.g, c.b}) text += {digits[channel >> 4], digits[channel & 15]};
  return text;
}

// A question, or it with its answer, on the panels beside the picture; on a narrow page in its middle.
View card_of(const Scene& page, const FilmShot& shot, const PageWords& words, const Theme& theme, const Fonts& fonts) {
  const StoryStep::Question& question = *shot.step->question;
  const Algorithm& algorithm = shot.scene->source().algorithm_at(shot.step->step);
  const Paper paper(theme, fonts, words);
  View card;
  card.width = page.width;
  card.height = page.height;
  const View& panels = page.views[2];
  const bool beside = panels.x > page.width / 2 && panels.width >= 300;
  const double width = beside ? panels.width : std::min(0.8 * page.width, 760.0);
  const double x = beside ? panels.x : (page.width - width) / 2;
  const double middle = beside ? panels.y + panels.height / 2 : page.height / 2;
  constexpr double inset = 16;
  for (double size = 20; size >= 8; size -= 1) {
    const PaperPart asked = handout_question(paper, question, algorithm, x, width, size);
    std::vector<PaperText> said{
        {plain_run(words("answer", question.answer), true), size, Role::text_strong, width - 2 * inset}};
    if (!question.right.empty())
      said.push_back({rich_text(question.right, algorithm), size, Role::text, width - 2 * inset});
    double height = asked.height + size;
    for (const PaperText& text : said) height += paper.height(text) + size / 2;
    if (height > 0.9 * page.height && size > 8) continue;
    // The question stands where it stood before its answer came.
    double y = std::max(0.0, middle - height / 2);
    const double top = y;
    asked.draw(card, y);
    y += asked.height;
    if (shot.card == FilmShot::Card::answer) {
      Paper::fill(card, x, y, width, top + height - y, Role::panel);
      Paper::fill(card, x, y, 4, top + height - y, Role::right);
      y += size / 2;
      for (const PaperText& text : said) y += paper.add(card, text, x + inset, y) + size / 2;
      y = top + height;
    }
    Polyline border;
    border.points = {{x, top, 0}, {x + width, top, 0}, {x + width, y, 0}, {x, y, 0}};
    border.closed = true;
    border.role = Role::axis;
    card.polylines.push_back(std::move(border));
    break;
  }
  return card;
}

std::string words_of(const StoryStep::Question& question) {
  std::string words = plain_text(question.ask);
  for (const Prose& option : question.options) words += " " + plain_text(option);
  return words;
}

// When each picture is shown, in frames, as ffmpeg's expression of its number N: every picture takes one frame and what
// it stays longer.
std::string times(const std::vector<FilmShot>& shots) {
  std::string text = "N";
  for (std::size_t i = 0; i < shots.size(); ++i)
    if (shots[i].frames > 1) text += "+" + std::to_string(shots[i].frames - 1) + "*gt(N," + std::to_string(i) + ")";
  return text;
}

class Film {
 public:
  Film(const Story& story, const LessonExportOptions& options, const FilmFormat& format)
      : story_(story),
        options_(options),
        format_(format),
        words_(story.language),
        fps_(options.frames_per_second > 0 ? options.frames_per_second : format.frames_per_second) {}

  Checked<bool> make(const fs::path& file, const Staging& staging) {
    auto shots = film_shots(story_, options_, fps_);
    if (!shots) return shots.diagnostics;
    auto fonts = Fonts::load();
    if (!fonts) return fonts.diagnostics;
    fonts_ = *std::move(fonts);
    shots_ = *std::move(shots);
    // The same rule as everywhere: what is shown at the end ends one frame after its last picture was sent again.
    FilmShot end = shots_.back();
    end.frames = 1;
    if (shots_.back().frames > 1) {
      --shots_.back().frames;
      shots_.push_back(end);
    }
    const std::vector<std::size_t> sample = format_.palette ? palette_sample() : std::vector<std::size_t>();
    pictures_ = shots_.size() + sample.size();

    std::vector<std::size_t> all(shots_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    const fs::path palette = staging.scratch("palette.png");
    if (format_.palette) {
      std::vector<std::string> output{"-vf", "palettegen=max_colors=256:reserve_transparent=0:stats_mode=full"};
      output.insert(output.end(), {"-frames:v", "1", "-f", "image2", "-update", "1", "file:" + palette.string()});
      const auto found = encode(sample, {}, output, staging.scratch("palette.log"));
      if (!found || !*found) return found;
    }
    return encode(all, format_.palette ? palette : fs::path(), film_output(file), staging.scratch("film.log"));
  }

 private:
  // Pictures that stay, at equal distances.
  std::vector<std::size_t> palette_sample() const {
    std::vector<std::size_t> still, sample;
    for (std::size_t i = 0; i < shots_.size(); ++i)
      if (shots_[i].motion == 1 && shots_[i].glide == 1) still.push_back(i);
    const std::size_t count = std::min(still.size(), palette_pictures);
    for (std::size_t i = 0; i < count; ++i) sample.push_back(still[(i + 1) * still.size() / count - 1]);
    return sample;
  }

  std::vector<std::string> film_output(const fs::path& file) const {
    const std::string at = "setpts='" + times(shots_) + "'";
    std::vector<std::string> output;
    if (format_.palette) {
      output = {"-filter_complex", "[0:v]" + at + "[v];[v][1:v]paletteuse=dither=none:diff_mode=rectangle"};
    } else {
      // Half the resolution for colours, as every player takes it, so sides are even; and the matrix is said.
      output = {"-vf", at + ",pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + hex(options_.theme->background) +
                           ",scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int+bitexact,"
                           "format=yuv420p"};
      output.insert(output.end(),
                    {"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"});
    }
    output.insert(output.end(), {"-fps_mode", "vfr", "-enc_time_base", "-1"});
    // In hundredths of a second; otherwise the last picture would stay as long as the one before.
    if (format_.muxer == "gif") output.insert(output.end(), {"-final_delay", format_short(100 / fps_, 0)});
    output.insert(output.end(), format_.encoder.begin(), format_.encoder.end());
    // The same bytes for the same pictures: no versions, no dates.
    output.insert(output.end(), {"-flags:v", "+bitexact", "-fflags", "+bitexact", "-map_metadata", "-1"});
    output.insert(output.end(), {"-metadata", "title=" + story_.title, "-metadata", "comment=" + story_.summary});
    output.insert(output.end(), {"-f", std::string(format_.muxer), "file:" + file.string()});
    return output;
  }

  Checked<Image> draw(const FilmShot& shot) const {
    Scene page = shot.scene->page(*shot.step, story_.title, options_.width, options_.height, shot.motion, shot.glide);
    if (shot.card != FilmShot::Card::none) page.views.push_back(card_of(page, shot, words_, *options_.theme, *fonts_));
    return draw_image(page, *options_.theme, options_.scale);
  }

  bool go_on() const { return report_progress(options_, drawn_, pictures_); }

  // These pictures through ffmpeg. False: stopped.
  Checked<bool> encode(const std::vector<std::size_t>& which, const fs::path& palette,
                       const std::vector<std::string>& output, const fs::path& log) {
    auto first = draw(shots_[which.front()]);
    if (!first) return first.diagnostics;
    std::vector<std::string> arguments{"-hide_banner", "-nostdin", "-loglevel", "error", "-y", "-f", "rawvideo"};
    arguments.insert(arguments.end(), {"-pixel_format", "rgba", "-video_size", size_of(*first), "-framerate",
                                       format_short(fps_, 3), "-i", "pipe:0"});
    if (!palette.empty()) arguments.insert(arguments.end(), {"-i", "file:" + palette.string()});
    arguments.insert(arguments.end(), output.begin(), output.end());
    const auto encoder = Encoder::start(arguments, log);
    if (!encoder) return encoder.diagnostics;
    const auto going = [this] { return go_on(); };
    Image image = *std::move(first);
    for (std::size_t i = 0; i < which.size(); ++i) {
      if (i > 0 && !repeats(which[i])) {
        auto drawn = draw(shots_[which[i]]);
        if (!drawn) return drawn.diagnostics;
        image = *std::move(drawn);
      }
      if (!(*encoder)->put(image.pixels, going)) break;  // finish says why
      ++drawn_;
      if (!go_on()) return false;
    }
    return (*encoder)->finish(going);
  }

  // The very last picture is the one before it.
  bool repeats(std::size_t i) const {
    const FilmShot &now = shots_[i], &before = shots_[i - 1];
    return now.step == before.step && now.motion == before.motion && now.glide == before.glide &&
           now.card == before.card;
  }

  const Story& story_;
  const LessonExportOptions& options_;
  const FilmFormat& format_;
  PageWords words_;
  std::shared_ptr<const Fonts> fonts_;
  double fps_;
  std::vector<FilmShot> shots_;
  std::size_t drawn_ = 0, pictures_ = 0;
};

}  // namespace

double reading_seconds(std::string_view words) {
  // 1080 characters a minute, 180 words, and a moment to look.
  return std::clamp(1.0 + static_cast<double>(utf8_count(words)) / 18, 1.5, 20.0);
}

Checked<std::vector<FilmShot>> film_shots(const Story& story, const LessonExportOptions& options, double fps) {
  std::vector<FilmShot> shots;
  const auto frames = [&](double seconds) {
    return static_cast<std::size_t>(std::max(1.0, std::round(seconds * fps)));
  };
  double total = 0;
  for (const StoryScene& scene : story.scenes) {
    for (const StoryStep& step : scene.steps) {
      double seconds =
          options.seconds_per_step > 0 ? options.seconds_per_step : reading_seconds(plain_text(step.prose));
      if (step.beat != nullptr) seconds += step.beat->seconds + (step.beat->waits ? waiting_seconds : 0);
      const double motion = std::min(motion_seconds, 0.4 * seconds);
      const bool moving = moves(scene, step.step), gliding = scene.glides(step.step);
      if (moving || gliding) {
        const auto count = static_cast<std::size_t>(std::floor(motion * fps));
        for (std::size_t i = 0; i < count; ++i) {
          const double come = eased(static_cast<double>(i + 1) / static_cast<double>(count + 1));
          shots.push_back({&scene, &step, moving ? come : 1, gliding ? come : 1, 1});
        }
        seconds -= static_cast<double>(count) / fps;
      }
      shots.push_back({&scene, &step, 1, 1, frames(seconds)});
      total += seconds + motion;
      if (options.checkpoints && step.question) {
        const auto stays = [&](const std::string& words, double longer) {
          return options.seconds_per_step > 0 ? options.seconds_per_step : reading_seconds(words) + longer;
        };
        const double asked = stays(words_of(*step.question), thinking_seconds),
                     told = stays(step.question->answer + plain_text(step.question->right), 0);
        shots.push_back({&scene, &step, 1, 1, frames(asked), FilmShot::Card::question});
        shots.push_back({&scene, &step, 1, 1, frames(told), FilmShot::Card::answer});
        total += asked + told;
      }
      if (total > longest_film * 3600)
        return Diagnostics{
            {"", 0, 0, "--steps",
             "all the steps make a film of more than 4 hours; choose some of them (--steps 3..9), or give "
             "each less time (--seconds)"}};
    }
  }
  if (!shots.empty()) shots.back().frames += frames(last_seconds);
  return shots;
}

Checked<LessonExported> write_film(const Story& story, const fs::path& out, const LessonExportOptions& options,
                                   const FilmFormat& format) {
  if (const auto ffmpeg = find_ffmpeg(); !ffmpeg) return ffmpeg.diagnostics;
  auto staging = Staging::open(out.parent_path());
  if (!staging) return staging.diagnostics;
  const auto made = Film(story, options, format).make(staging->path(out.filename()), *staging);
  if (!made) return made.diagnostics;
  if (!*made) return stopped();
  auto files = staging->publish();
  if (!files) return files.diagnostics;
  LessonExported exported{*std::move(files), {}};
  if (!format.palette) {
    const auto pixels = [&](double units) { return std::lround(units * options.scale); };
    const long width = pixels(options.width), height = pixels(options.height);
    if (width % 2 != 0 || height % 2 != 0)
      exported.notes.push_back("the film is " + std::to_string(width + width % 2) + "x" +
                               std::to_string(height + height % 2) + " pixels large, for its sides must be even");
  }
  return exported;
}

}  // namespace blossom
