// The whole window as a picture that was looked at and found good; see tests/golden/README.md.
#include "app/program.hpp"
#include "block_difference.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("The golden pictures of the window") {
  const Scratch scratch;
  const std::string tests = std::string(BLOSSOM_SOURCE_DIR) + "/tests/";
  const Ended ended = test::blossom(
      {"play", "--headless-script", tests + "play/golden.txt", "--out", scratch / "out", "--state", scratch / "state"});
  SHOW(ended);
  REQUIRE(ended.status == 0);
  int count = 0;
  for (const auto& entry : fs::directory_iterator(scratch / "out")) {
    if (!entry.path().filename().string().starts_with("window-")) continue;
    ++count;
    const auto made = read_png(entry.path());
    REQUIRE(made);
    check_golden(tests + "golden/" + entry.path().filename().string(), *made);
  }
  CHECK(count == 4);
}
