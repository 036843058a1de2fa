// The whole window as a picture that was looked at and found good; see tests/golden/README.md.
#include <cstdlib>

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
    const fs::path file = fs::path(tests + "golden") / entry.path().filename();
    const auto made = read_png(entry.path());
    REQUIRE(made);
    if (std::getenv("BLOSSOM_UPDATE_GOLDEN") != nullptr) {
      fs::copy_file(entry.path(), file, fs::copy_options::overwrite_existing);
      WARN("written: " << file);
      continue;
    }
    INFO(file << " differs; if that is meant: BLOSSOM_UPDATE_GOLDEN=1");
    const auto kept = read_png(file);
    INFO(to_string(kept.diagnostics));
    REQUIRE(kept);
    CHECK(difference(*made, *kept).mean < 2);
    CHECK(block_difference(*made, *kept) <= tolerated_difference);
  }
  CHECK(count == 4);
}
