// One step of each algorithm as a picture that was looked at and found good; see tests/golden/README.md.
#include "base/json.hpp"
#include "block_difference.hpp"
#include "render/picture.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double width = 800, height = 500, scale = 0.7;  // 560 x 350 pixels

struct Golden {
  const char* lesson;
  const char* value;  // drawn is the step that makes it
  const char* theme;
};
constexpr Golden goldens[] = {
    {"de-casteljau", "P[2][0]", "light"},        {"de-boor", "P[1][3]", "light"}, {"knot-insertion", "", "light"},
    {"degree-elevation", "", "light"},           {"skinning", "", "light"},       {"de-boor-nurbs", "", "dark"},
    {"rational-quarter-circle", "", "contrast"},
};

Scene golden_scene(const Golden& golden) {
  const auto lesson = prepare<Exact>(golden.lesson);
  const std::string name = golden.value;
  const std::uint32_t step =
      name.empty() ? lesson->step_count() - 1 : lesson->run.trace.value(lesson->run.trace.find(name).value()).step;
  return lesson->page(step, width, height);
}

Image draw(const Scene& scene, const char* theme) {
  auto image = draw_image(scene, **find_theme(theme), scale);
  REQUIRE(image);
  return std::move(*image);
}

constexpr int tolerated = tolerated_difference;

}  // namespace

TEST_CASE("The golden pictures") {
  for (const Golden& golden : goldens) {
    const auto file = std::string(BLOSSOM_SOURCE_DIR) + "/tests/golden/" + golden.lesson + "-" + golden.theme + ".png";
    check_golden(file, draw(golden_scene(golden), golden.theme));
  }
}

TEST_CASE("The comparison with golden pictures sees a missing label, line and marker") {
  for (const Golden& golden : {goldens[0], goldens[5], goldens[6]}) {
    const Scene scene = golden_scene(golden);
    const Image whole = draw(scene, golden.theme);
    CHECK(block_difference(whole, draw(scene, golden.theme)) == 0);
    const auto without = [&](auto&& remove) {
      Scene less = scene;
      remove(less.views[1]);
      return block_difference(whole, draw(less, golden.theme));
    };
    const View& picture = scene.views[1];
    int names = 0;
    for (std::size_t i = 0; i < picture.labels.size(); ++i) {
      if (picture.labels[i].optional) continue;
      INFO("label " << plain_text(picture.labels[i].text));
      CHECK(without([&](View& view) { view.labels.erase(view.labels.begin() + static_cast<std::ptrdiff_t>(i)); }) >
            tolerated);
      ++names;
    }
    CHECK(names > 0);
    CHECK(without([](View& view) {
            std::erase_if(view.polylines, [](const Polyline& line) { return line.role == Role::curve; });
          }) > tolerated);
    CHECK(without([](View& view) {
            std::erase_if(view.markers, [](const Marker& marker) { return marker.role == Role::current; });
          }) > tolerated);
  }
}

TEST_CASE("The comparison with golden pictures forgives another anti-aliasing") {
  for (const Golden& golden : goldens) {
    INFO(golden.lesson);
    const Scene scene = golden_scene(golden);
    const Image whole = draw(scene, golden.theme);
    // The same picture drawn at twice the size and averaged: every edge is smoothed otherwise, every letter stands
    // elsewhere by a part of a pixel.
    auto large = draw_image(scene, **find_theme(golden.theme), 2 * scale);
    REQUIRE(large);
    const Image smooth = downscale(*large, whole.width, whole.height);
    CHECK(difference(whole, smooth).max > 30);
    CHECK(difference(whole, smooth).mean < 2);
    CHECK(block_difference(whole, smooth) <= tolerated);
  }
}
