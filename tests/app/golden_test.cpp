// Texts and drawings as they were looked at and found good; see tests/golden/README.md.
#include <cstdlib>

#include "app/program.hpp"

using namespace blossom::test;

namespace {

void check_golden(const std::string& name, const std::string& made) {
  const fs::path file = fs::path(BLOSSOM_SOURCE_DIR) / "tests/golden" / name;
  if (std::getenv("BLOSSOM_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(file, std::ios::binary) << made;
    WARN("written: " << file.string());
    return;
  }
  INFO(file.string() << " differs; if that is meant: BLOSSOM_UPDATE_GOLDEN=1");
  CHECK(made == read_all(file));
}

}  // namespace

TEST_CASE("Traces as text are the golden ones") {
  for (const std::string lesson : {"11-de-casteljau", "16-degree-elevation", "40-rational-quarter-circle", "22-de-boor",
                                   "28-knot-insertion", "32-degree-elevation-bspline"}) {
    const auto ended = blossom::test::blossom({"trace", lesson, "--exact"});
    SHOW(ended);
    CHECK(ended.status == 0);
    check_golden(lesson + "-exact.txt", ended.out);
  }
  // In doubles: the digits are the same on every machine.
  for (const std::string lesson : {"45-de-boor-nurbs", "24-de-boor-unclamped"}) {
    const auto ended = blossom::test::blossom({"trace", lesson});
    SHOW(ended);
    CHECK(ended.status == 0);
    check_golden(lesson + ".txt", ended.out);
  }
}

#if BLOSSOM_PLAYER
TEST_CASE("A step as SVG is the golden one") {
  const Scratch scratch;
  const auto ended =
      blossom::test::blossom({"render", "22-de-boor", "--step", "6", "--exact", "--svg", "--out", scratch.path()});
  SHOW(ended);
  REQUIRE(ended.status == 0);
  check_golden("de-boor-06.svg", read_all(scratch / "de-boor-06.svg"));
}
#endif
