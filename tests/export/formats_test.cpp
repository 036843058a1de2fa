// What every format of lessons keeps to, and what single ones promise.
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "algorithms/trace_json.hpp"
#include "export/export_encoder.hpp"
#include "export/export_film.hpp"
#include "export/html_course.hpp"
#include "export/short_lesson.hpp"
#include "render/picture.hpp"
#include "scratch.hpp"

using namespace blossom;
using namespace blossom::test;
namespace fs = std::filesystem;

namespace {

// All files below a folder by their names, hidden ones as well.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) {
      contents[entry.path().lexically_relative(folder).string() + "/"];
      continue;
    }
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    contents[entry.path().lexically_relative(folder).string()] = bytes.str();
  }
  return contents;
}

fs::path place(const LessonFormat& format, const fs::path& folder) {
  return format.many_files ? folder / "pages" : folder / ("lesson" + std::string(format.extension));
}

// Films cannot be tested where their encoder is missing.
bool lacks_encoder(const Diagnostics& diagnostics) {
  if (find_ffmpeg() || to_string(diagnostics).find("ffmpeg") == std::string::npos) return false;
  WARN("not tested: ffmpeg is not installed");
  return true;
}

class PathWithout {
 public:
  PathWithout() : before_(std::getenv("PATH")) { setenv("PATH", "", 1); }
  ~PathWithout() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

// What ffprobe says of the first stream, such as "r_frame_rate".
std::string probe(const fs::path& film, const std::string& entry) {
  const std::string command = "ffprobe -v error -count_frames -select_streams v:0 -show_entries " + entry +
                              " -of default=nokey=1:noprint_wrappers=1 '" + film.string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string said;
  for (int c = 0; (c = fgetc(pipe)) != EOF;) said += static_cast<char>(c);
  REQUIRE(pclose(pipe) == 0);
  while (said.ends_with('\n')) said.pop_back();
  return said;
}

std::size_t frames_of(const std::vector<FilmShot>& shots) {
  std::size_t frames = 0;
  for (const FilmShot& shot : shots) frames += shot.frames;
  return frames;
}

}  // namespace

TEST_CASE("Every format writes the same story as the same bytes, and tells its files") {
  const Story story = story_of(short_lesson);
  for (const LessonFormat* format : lesson_formats()) {
    INFO(format->id);
    const Scratch first, second;
    const auto exported = format->write(story, place(*format, first.path()), small_pages());
    if (!exported && lacks_encoder(exported.diagnostics)) continue;
    INFO(to_string(exported.diagnostics));
    REQUIRE(exported);
    REQUIRE_FALSE(exported->files.empty());
    CHECK(exported->files[0].extension() == format->extension);
    for (const fs::path& file : exported->files) {
      INFO(file);
      CHECK(fs::file_size(file) > 100);
    }
    REQUIRE(format->write(story_of(short_lesson), place(*format, second.path()), small_pages()));
    const auto contents = contents_of(first.path());
    std::size_t files = 0;
    for (const auto& [name, bytes] : contents) files += name.ends_with('/') ? 0 : 1;
    CHECK(files == exported->files.size());  // nothing is left beside them
    CHECK(contents == contents_of(second.path()));
  }
}

TEST_CASE("A lesson of several scenes is exported whole by every format") {
  const std::string inputs = R"("inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 2]]}, "u": "1/2"})";
  const Story story = story_of(R"({"schema": "blossom.lesson/1", "id": "two", "title": "Two scenes", "scenes": [
      {"id": "one", "title": "The first", "algorithm": "de_casteljau", )" +
                               inputs +
                               R"(, "beats": [{"at": "start", "say": "A segment."}]},
      {"id": "other", "title": "The second", "algorithm": "de_casteljau", )" +
                               inputs + R"(, "beats": [{"at": "start", "say": "Again."}]}]})");
  REQUIRE(story.scenes.size() == 2);
  for (const LessonFormat* format : lesson_formats()) {
    INFO(format->id);
    const Scratch scratch;
    const auto exported = format->write(story, place(*format, scratch.path()), small_pages());
    if (!exported && lacks_encoder(exported.diagnostics)) continue;
    INFO(to_string(exported.diagnostics));
    REQUIRE(exported);
    if (format->many_files) CHECK(exported->files.size() >= story.step_count());
  }
}

TEST_CASE("An export that is stopped leaves nothing, and what stood there stays") {
  const Story story = story_of(short_lesson);
  for (const LessonFormat* format : lesson_formats()) {
    INFO(format->id);
    const Scratch scratch;
    const fs::path out = place(*format, scratch.path());
    if (!format->many_files) std::ofstream(out) << "before";
    const auto before = contents_of(scratch.path());
    LessonExportOptions options = small_pages();
    std::size_t calls = 0;
    options.progress = [&](std::size_t done, std::size_t of) {
      CHECK(done <= of);
      return ++calls < 3;
    };
    const auto exported = format->write(story, out, options);
    if (!exported && lacks_encoder(exported.diagnostics)) continue;
    if (calls < 3) continue;  // it was done before it could be stopped
    CHECK_FALSE(exported);
    CHECK(to_string(exported.diagnostics).find("stopped") != std::string::npos);
    CHECK(contents_of(scratch.path()) == before);
  }
}

TEST_CASE("A place that cannot be written to is named, and nothing is left") {
  const Story story = story_of(short_lesson);
  for (const LessonFormat* format : lesson_formats()) {
    INFO(format->id);
    const Scratch scratch;
    const std::string file = scratch.write("file", "mine");
    const auto exported =
        format->write(story, format->many_files ? fs::path(file) : fs::path(file) / "lesson", small_pages());
    if (lacks_encoder(exported.diagnostics)) continue;
    CHECK_FALSE(exported);
    CHECK(to_string(exported.diagnostics).find(file) != std::string::npos);
    CHECK(contents_of(scratch.path()) == std::map<std::string, std::string>{{"file", "mine"}});
  }
}

TEST_CASE("PNG pictures are the pages, with title and words") {
  const Scratch scratch;
  const Story story = story_of(short_lesson);
  LessonExportOptions options = small_pages();
  options.scale = 1.5;
  const auto exported = find_lesson_format("png")->write(story, scratch.path(), options);
  REQUIRE(exported);
  const StoryScene& scene = story.scenes[0];
  REQUIRE(exported->files.size() == scene.steps.size());
  for (std::size_t i = 0; i < scene.steps.size(); ++i) {
    const auto image = read_png(exported->files[i]);
    REQUIRE(image);
    CHECK(image->width == 960);
    const auto page = draw_image(scene.page(scene.steps[i], story.title, 640, 480), light_theme(), 1.5);
    REQUIRE(page);
    CHECK(*image == *page);
    const std::string bytes = contents_of(scratch.path())[exported->files[i].filename().string()];
    CHECK(bytes.find(story.title) != std::string::npos);
  }
  CHECK(exported->files[0].filename() == "short-0.png");
}

TEST_CASE("A trace that is exported is the run") {
  const Scratch scratch;
  const Story story = story_of(short_lesson);
  const auto exported = find_lesson_format("json")->write(story, scratch / "run.json", small_pages());
  REQUIRE(exported);
  const auto document = JsonDocument::load(exported->files[0]);
  REQUIRE(document);
  const auto stored = read_trace(*document);
  INFO(to_string(stored.diagnostics));
  REQUIRE(stored);
  const auto* run = std::get_if<Run<Exact>>(&*stored);
  REQUIRE(run != nullptr);
  CHECK(run->trace.step_count() == story.scenes[0].recording->last() + 1);
}

TEST_CASE("Markdown has every step's words, and its pictures are there") {
  const Scratch scratch;
  const Story story = story_of(short_lesson);
  const auto exported = find_lesson_format("md")->write(story, scratch / "my lesson.md", small_pages());
  REQUIRE(exported);
  const std::string text = contents_of(scratch.path())["my lesson.md"];
  std::size_t at = 0;
  for (const StoryStep& step : story.scenes[0].steps) {
    at = text.find("### Step " + std::to_string(step.step) + "\n", at);
    REQUIRE(at != std::string::npos);
  }
  CHECK(text.find("Walk 1/4 of the way along the first leg: that is **(1/2, 1)**.") != std::string::npos);
  CHECK(text.find("> P₀⁽¹⁾ = ") != std::string::npos);
  for (std::size_t i = 1; i < exported->files.size(); ++i) {
    const std::string name = exported->files[i].filename().string();
    CHECK(text.find("](my%20lesson-files/" + name + ")") != std::string::npos);
    CHECK(fs::exists(scratch / ("my lesson-files/" + name)));
  }
  CHECK(text.find("# A point on a parabola & more\n") == 0);
  CHECK(text.find("- **a)** the second leg") != std::string::npos);
  CHECK(text.find("There is another leg.") > text.find("<details>"));

  LessonExportOptions without = small_pages();
  without.checkpoints = false;
  REQUIRE(find_lesson_format("md")->write(story, scratch / "b.md", without));
  CHECK(contents_of(scratch.path())["b.md"].find("<details>") == std::string::npos);
}

TEST_CASE("The words around a lesson are in its language in every format") {
  std::string lesson = short_lesson;
  lesson.insert(lesson.find("\"unit\""), "\"language\": \"de\", \"prerequisites\": [\"before\"], ");
  const Story story = story_of(lesson);
  CHECK(story.foreign_count() == story.step_count() - story.scenes[0].beats.size());
  const std::map<std::string, std::pair<std::vector<std::string>, std::vector<std::string>>> words{
      {"md",
       {{"### Schritt 1", "**Vorher**", "**Frage.**", "<summary>Antwort", "Zeile 3"}, {"Step", "Question", "Answer"}}},
      {"tex",
       {{"Schritt 1}", "Dauer:", "Vorher:", "{Frage}", "{Antworten}", "Zeile 3"}, {"Step ", "Question.", "line 3"}}},
      {"svg", {{"Schritt 1 / 4", "Dieser Schritt", "Polarform"}, {"step 1", "This step", "blossom value"}}}};
  for (const auto& [format, said] : words) {
    INFO(format);
    const Scratch scratch;
    REQUIRE(
        find_lesson_format(format)->write(story, place(*find_lesson_format(format), scratch.path()), small_pages()));
    std::string all;
    for (const auto& [name, bytes] : contents_of(scratch.path())) all += bytes;
    for (const std::string& word : said.first) {
      INFO(word);
      CHECK(all.find(word) != std::string::npos);
    }
    for (const std::string& word : said.second) {
      INFO(word);
      CHECK(all.find(word) == std::string::npos);
    }
  }
}

TEST_CASE("What a lesson calls by its id is called by its title where a file has it") {
  const Scratch scratch;
  fs::create_directories(scratch / "lessons");
  fs::create_directories(scratch / "exercises");
  const std::string file = scratch.write(
      "lessons/03-short.json",
      std::string(short_lesson).insert(1, R"("prerequisites": ["first", "other", "none"], "exercises": ["e"],)"));
  scratch.write("lessons/01-first.json", R"({"schema": "blossom.lesson/1", "id": "first", "languages": ["de"],
      "title": {"en": "The first", "de": "Die erste"}})");
  scratch.write("exercises/07-e.json", R"({"schema": "blossom.exercise/1", "id": "e", "title": "An exercise"})");
  fs::create_directories(scratch / "course");
  scratch.write("course/02-other.json", R"({"schema": "blossom.lesson/1", "id": "other", "title": "Another"})");

  const CourseTitles titles(file, {scratch / "course", scratch / "nowhere"}, true);
  CHECK(titles.lesson("first", "").words() == "01 The first");
  CHECK(titles.lesson("first", "de").words() == "01 Die erste");
  CHECK(titles.lesson("first", "").page == "01-first");
  CHECK(titles.lesson("other", "").words() == "02 Another");
  CHECK(titles.lesson("other", "").page.empty());  // its page would not stand beside this one
  CHECK(titles.lesson("none", "").words() == "none");
  CHECK(titles.exercise("e", "").words() == "07 An exercise");

  StoryOptions options;
  options.titles = &titles;
  const auto document = JsonDocument::load(file);
  REQUIRE(document);
  const auto lesson = load_lesson(*document);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  const auto story = make_story(*lesson, options);
  REQUIRE(story);
  REQUIRE(find_lesson_format("md")->write(*story, scratch / "out/a.md", small_pages()));
  REQUIRE(find_lesson_format("html")->write(*story, scratch / "out/a.html", small_pages()));
  const std::string text = contents_of(scratch / "out")["a.md"], page = contents_of(scratch / "out")["a.html"];
  CHECK(text.find("- [01 The first](01-first.md)\n- 02 Another\n- none\n") != std::string::npos);
  CHECK(page.find("<li><a href=\"01-first.html\">01 The first</a></li>\n<li>02 Another</li>") != std::string::npos);
  CHECK(page.find("<a href=\"index.html\">") != std::string::npos);
}

TEST_CASE("A course's list has its lessons by units, and lets nothing run") {
  Story story = story_of(short_lesson);
  story.prerequisites = {{"a", "01", "Before <it>", "01-a"}, {"b", "", "", ""}};
  CoursePage other = course_page(story, "02-other");
  other.unit = "Other";
  const std::string html = html_course({course_page(story, "01-short"), other, course_page(story, "x y")}, "dark");
  CHECK(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\" data-theme=\"dark\">"));
  CHECK(html.find("default-src 'none'") != std::string::npos);
  CHECK(html.find("script-src 'none'") != std::string::npos);
  CHECK(html.find("<script") == std::string::npos);
  CHECK(html.find("http:") == std::string::npos);
  const auto place_of = [&](const std::string& words) {
    INFO(words);
    REQUIRE(html.find(words) != std::string::npos);
    return html.find(words);
  };
  CHECK(place_of("<h2>Bézier curves</h2>") <
        place_of("<a href=\"01-short.html\">01 A point on a parabola &amp; more</a>"));
  CHECK(place_of("<a href=\"x%20y.html\">") < place_of("<h2>Other</h2>"));
  CHECK(place_of("<h2>Other</h2>") < place_of("<a href=\"02-other.html\">"));
  place_of("<p>Three points, two divisions, one point.</p>");
  place_of("about 5 minutes, " + std::to_string(story.step_count()) + " steps");
  place_of("<a href=\"01-a.html\">01 Before &lt;it&gt;</a>; b");
}

TEST_CASE("A film has the pictures and the length that the lesson asks for, and even sides") {
  if (!find_ffmpeg()) {
    WARN("not tested: ffmpeg is not installed");
    return;
  }
  const Story story = story_of(short_lesson);
  LessonExportOptions options = small_pages();
  options.width = 641;
  options.height = 481;
  options.seconds_per_step = 0.5;
  for (const std::string id : {"mp4", "webm", "gif"}) {
    INFO(id);
    const Scratch scratch;
    const double fps = id == "gif" ? 20 : 30;
    const auto exported = find_lesson_format(id)->write(story, scratch / ("film." + id), options);
    INFO(to_string(exported.diagnostics));
    REQUIRE(exported);
    const auto shots = film_shots(story, options, fps);
    REQUIRE(shots);
    // One more than drawn: the last picture is sent again, so that it stays.
    CHECK(probe(exported->files[0], "stream=nb_read_frames") == std::to_string(shots->size() + 1));
    CHECK(std::stod(probe(exported->files[0], "format=duration")) ==
          Approx(static_cast<double>(frames_of(*shots)) / fps).margin(0.06));
    CHECK(probe(exported->files[0], "stream=width,height") == (id == "gif" ? "641\n481" : "642\n482"));
    if (id != "gif") CHECK(probe(exported->files[0], "stream=pix_fmt") == "yuv420p");
    // Of the sides that were made even.
    CHECK(exported->notes ==
          (id == "gif" ? std::vector<std::string>{}
                       : std::vector<std::string>{"the film is 642x482 pixels large, for its sides must be even"}));
  }
}

TEST_CASE("A picture of a film stays while its words are read and its beat pauses") {
  const Story story = story_of(short_lesson);
  const StoryScene& scene = story.scenes[0];
  const auto shots = film_shots(story, small_pages(), 10);
  REQUIRE(shots);
  std::map<std::uint32_t, double> seconds, moving, gliding;
  std::vector<FilmShot::Card> cards;
  for (const FilmShot& shot : *shots) {
    gliding[shot.step->step] += shot.glide < 1 ? 1 : 0;
    if (shot.card != FilmShot::Card::none) {
      CHECK(shot.step->question);
      cards.push_back(shot.card);
      continue;
    }
    seconds[shot.step->step] += static_cast<double>(shot.frames) / 10;
    moving[shot.step->step] += shot.motion < 1 ? 1 : 0;
  }
  for (const StoryStep& step : scene.steps) {
    INFO(step.step);
    double expected = reading_seconds(plain_text(step.prose)) + (step.beat != nullptr ? step.beat->seconds : 0);
    if (step.step == scene.recording->last()) expected += 1.5;
    CHECK((gliding[step.step] > 0) == scene.glides(step.step));
    CHECK(seconds[step.step] == Approx(expected).margin(0.11));
    const ValueId v = scene.source().graph->main_value(step.step);
    const bool divides = v != absent && !scene.recording->graph().is_input(v) &&
                         scene.recording->graph().value(v).kind == ValueKind::point;
    CHECK((moving[step.step] > 0) == divides);
  }
  CHECK(seconds.size() == scene.steps.size());
  CHECK(cards == std::vector{FilmShot::Card::question, FilmShot::Card::answer});
  CHECK(std::ranges::any_of(gliding, [](const auto& step) { return step.second > 0; }));
  LessonExportOptions unasked = small_pages();
  unasked.checkpoints = false;
  const auto without = film_shots(story, unasked, 10);
  REQUIRE(without);
  CHECK(without->size() == shots->size() - 2);
  CHECK(reading_seconds("Short.") < reading_seconds(std::string(200, 'x')));
}

TEST_CASE("Without ffmpeg a film says what is missing, how to get it, and what there is instead") {
  const Story story = story_of(short_lesson);
  const Scratch scratch;
  const PathWithout empty;
  for (const std::string id : {"mp4", "webm", "gif"}) {
    const auto exported = find_lesson_format(id)->write(story, scratch / ("film." + id), small_pages());
    CHECK_FALSE(exported);
    const std::string said = to_string(exported.diagnostics);
    INFO(said);
    CHECK(said.find("ffmpeg") != std::string::npos);
    CHECK(said.find("apt-get install ffmpeg") != std::string::npos);
    CHECK(said.find("--to html") != std::string::npos);
    CHECK(exported.diagnostics[0].file.empty());
  }
  CHECK(scratch.count() == 0);
}

TEST_CASE("What ffmpeg complains of is passed on") {
  if (!find_ffmpeg()) {
    WARN("not tested: ffmpeg is not installed");
    return;
  }
  const Scratch scratch;
  const FilmFormat broken{"mp4", 30, {"-c:v", "no_such_encoder"}};
  const auto exported = write_film(story_of(short_lesson), scratch / "film.mp4", small_pages(), broken);
  CHECK_FALSE(exported);
  INFO(to_string(exported.diagnostics));
  CHECK(to_string(exported.diagnostics).find("no_such_encoder") != std::string::npos);
  CHECK(scratch.count() == 0);
}
