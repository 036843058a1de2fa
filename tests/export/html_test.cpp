// The page of a lesson: what it is made of.
#define BLOSSOM_BIN_DIR ""
#include <set>

#include "export/html_canvas.hpp"
#include "export/lesson_page.hpp"
#include "render/painter.hpp"
#include "render/picture.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("texts that would be markup are text", "[export][html]") {
  Story story = story_of(all_questions);
  const std::string attack = "</script></style></template><script>x()</script><img src=x onerror=x()>'\"&amp;\x01\xff";
  story.title = story.unit = story.summary = story.source = attack;
  story.language = "en\" onload=\"x()";
  story.objectives = {"[x](javascript:x()) " + attack};
  story.prerequisites = story.exercises = {StoryLink{attack, attack, attack, attack}};
  for (StoryScene& scene : story.scenes) {
    scene.id = scene.heading = attack;
    for (StoryStep& step : scene.steps) {
      step.words = attack;
      step.phase = attack;
      step.prose = read_prose("[x](javascript:x()) `" + attack + "` $\\text{<script>x()</script>}$ " + attack);
      if (step.question) step.question->ask = step.question->right = step.question->wrong = step.prose;
    }
  }
  const std::string page = page_of(story);
  CHECK(count_of(page, "<script") == 2);
  CHECK(count_of(page, "</script") == 2);
  CHECK(count_of(page, "<style") == 1);
  CHECK(count_of(page, "</style") == 1);
  CHECK(count_of(page, "<img") == 0);
  CHECK(count_of(page, "href=\"javascript") == 0);
  CHECK(count_of(page, " onload=\"") == 0);
  CHECK(page.find('\x01') == std::string::npos);
  CHECK(page.find('\xff') == std::string::npos);
}

TEST_CASE("the words of all steps stand in the page without its script", "[export][html]") {
  const Story story = story_of(all_questions);
  const std::string page = page_of(story);
  const std::string document = page.substr(0, page.find("<script"));
  const std::string flat = without_blanks(std::regex_replace(document, std::regex("<[^>]*>"), ""));
  for (const StoryScene& scene : story.scenes)
    for (const StoryStep& step : scene.steps) {
      std::string letters = letters_of(step.prose, scene.source().algorithm_at(step.step));
      letters = std::regex_replace(std::regex_replace(letters, std::regex("<"), "&lt;"), std::regex(">"), "&gt;");
      CAPTURE(scene.id, step.step, letters);
      CHECK(contains(flat, letters));
    }
  CHECK(contains(flat, "Howmanypointstookpart?"));
}

TEST_CASE("questions are left out of a page where that is wished", "[export][html]") {
  const Story story = story_of(all_questions);
  const std::string with = page_of(story), without = page_of(story, false);
  CHECK(count_of(with, "<div class=\"ask\">") == 6);
  CHECK(count_of(without, "<div class=\"ask\">") == 0);
  CHECK_FALSE(contains(without, "How many points took part?"));
  CHECK_FALSE(contains(without, "\"answer\":\"b\""));
}

TEST_CASE("a page speaks the language of its lesson, and its controls do where they can", "[export][html]") {
  Story story = story_of(short_lesson);
  story.language = "de";
  const std::string german = page_of(story);
  CHECK(contains(german, "<html lang=\"de\">"));
  CHECK(contains(german, "Ein Schritt vor"));
  CHECK_FALSE(contains(german, "One step forward"));
  story.language = "pt";
  const std::string other = page_of(story);
  CHECK(contains(other, "<html lang=\"pt\">"));
  CHECK(contains(other, "One step forward"));
  CHECK(contains(between(other, "<div class=\"bar\"", ">"), "lang=\"en\""));
}

TEST_CASE("the same lesson gives the same page, byte for byte", "[export][html]") {
  const Story story = story_of(all_questions);
  CHECK(page_of(story) == page_of(story));
  CHECK(page_of(story_of(all_questions)) == page_of(story));
}

TEST_CASE("every colour of a page is one of its themes", "[export][html]") {
  const std::string page = page_of(shipped("60-ruled-hyperboloid"), true, **find_theme("dark"));
  CHECK(contains(page, "data-theme=\"dark\""));
  const std::string css = between(page, "<style>", "</style>");
  const std::regex used("var\\((--[a-z0-9-]+)\\)");
  std::set<std::string> names;
  for (std::sregex_iterator it(css.begin(), css.end(), used), end; it != end; ++it) names.insert((*it)[1]);
  CHECK(names.size() > 40);
  for (const std::string& name : names) {
    CAPTURE(name);
    // Light, dark twice (wished and preferred), contrast twice; the page's own mixtures once.
    const std::size_t defined = count_of(css, name + ":");
    CHECK((defined == 5 || (defined == 1 && contains(css, name + ": color-mix"))));
  }
}

TEST_CASE("shaded faces keep their shades in every theme", "[export][html]") {
  const auto fonts = Fonts::load();
  REQUIRE(fonts);
  for (const double angle : {0.0, 0.3, 0.7, 1.1, 1.4}) {
    View view;
    view.width = view.height = 100;
    view.camera = {.kind = Camera::Kind::orbit, .centre = {}, .height = 4, .azimuth = 0, .elevation = 0};
    const glm::dvec3 normal{std::cos(angle), std::sin(angle), 0};
    view.meshes.push_back({{{0, -1, -1}, {0, 1, -1}, {0, 0, 1}}, {normal, normal, normal}, {0, 1, 2}, Role::surface});
    HtmlLooks looks;
    HtmlCanvas canvas(looks);
    paint_view(view, HtmlLooks::probe(), **fonts, canvas, 1, {0, 0}, {0, 0, 100, 100});
    const auto elements = std::move(canvas).take();
    REQUIRE(elements.size() == 1);
    const std::string themes = looks.themes({});
    for (const char* name : {"light", "dark"}) {
      Scene scene;
      scene.width = scene.height = 100;
      scene.views = {view};
      const auto svg = draw_svg(scene, **find_theme(name));
      REQUIRE(svg);
      const std::string of_theme =
          name == std::string("light") ? themes : themes.substr(themes.find("[data-theme=dark]{"));
      const std::string expected = between(*svg, "Z\" fill=\"#", "\""),
                        got = between(of_theme, ";--m0:#", "}").substr(0, 6);
      CAPTURE(angle, name, expected, got);
      REQUIRE(expected.size() == 6);
      for (const std::size_t channel : {0u, 2u, 4u})
        CHECK(std::abs(std::stoi(expected.substr(channel, 2), nullptr, 16) -
                       std::stoi(got.substr(channel, 2), nullptr, 16)) <= 8);
    }
  }
}

TEST_CASE("a page of a shipped lesson of at most 60 steps takes less than 2 MB", "[export][html]") {
  std::size_t pages = 0;
  for (const auto& entry : fs::directory_iterator("lessons")) {
    const std::string file = entry.path().filename().string();
    if (!std::regex_match(file, std::regex("[0-9]+-.*\\.json"))) continue;
    const Story story = shipped(file.substr(0, file.size() - 5));
    if (story.step_count() > 60) continue;
    ++pages;
    const std::size_t bytes = page_of(story).size();
    CAPTURE(file, bytes);
    CHECK(bytes < 2'000'000);
  }
  CHECK(pages >= 20);
}
