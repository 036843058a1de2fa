// Variants are the same for ever. The golden values of own-de-casteljau were made by another implementation of
// grader/VARIANTS.md, written in Python from that text alone; those of the others by the first version of this one.

#include "base/json_write.hpp"
#include "grader/helpers.hpp"
#include "grader/variant.hpp"

using namespace blossom;

namespace {

struct Golden {
  const char* exercise;
  const char* s17;
  const char* lovelace;
  const char* zero;
  std::uint64_t class_of_300;  // FNV-1a of the inputs of s0 to s299, a line break behind each
};
const Golden goldens[] = {
    {"11-own-de-casteljau", R"({"curve": {"degree": 3, "points": [[0, 0], [2, 16], [12, 13], [18, 5]]}, "u": "2/3"})",
     R"({"curve": {"degree": 3, "points": [[0, 0], [2, 11], [15, 13], [21, 8]]}, "u": 0.75})",
     R"({"curve": {"degree": 3, "points": [[0, 0], [5, 13], [14, 12], [24, 5]]}, "u": "1/3"})", 0x8a7baeb859afdd5f},
    {"40-own-rational",
     R"({"curve": {"degree": 2, "points": [[4, 6], [2, 5], [3, 8]], "weights": [3, 5, 2]}, "u": 0.75})",
     R"({"curve": {"degree": 2, "points": [[5, 3], [2, 2], [7, 5]], "weights": [2, 3, 1]}, "u": "2/3"})",
     R"({"curve": {"degree": 2, "points": [[2, 5], [6, 4], [2, 7]], "weights": [3, 3, 1]}, "u": 0.25})",
     0xb1420cb9f346af74},
    {"22-own-de-boor",
     R"({"curve": {"degree": 2, "knots": [0, 0, 0, 1, 4, 6, 6, 6], "points": [[0, 0], [3, 5], [6, 4], [12, 4], [14, 5]]}, "u": 3})",
     R"({"curve": {"degree": 2, "knots": [0, 0, 0, 2, 5, 8, 8, 8], "points": [[0, 0], [4, 4], [8, 5], [9, 0], [14, 5]]}, "u": 4})",
     R"({"curve": {"degree": 2, "knots": [0, 0, 0, 1, 4, 7, 7, 7], "points": [[0, 0], [2, 7], [8, 12], [11, 0], [14, 5]]}, "u": 3})",
     0x86cd9f80b246e38b},
    {"28-own-knot-insertion",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], "points": [[0, 0], [4, 10], [5, 16], [11, 5], [13, 5], [20, 4], [24, 10]]}, "u": 1.75, "times": 1})",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], "points": [[0, 0], [3, 9], [5, 11], [12, 6], [17, 4], [20, 4], [24, 10]]}, "u": "5/3", "times": 1})",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4], "points": [[0, 0], [3, 6], [7, 11], [9, 8], [16, 1], [20, 4], [24, 10]]}, "u": 1.75, "times": 1})",
     0x90a0c7a6a4616910},
    {"16-own-degree-elevation",
     R"({"curve": {"degree": 4, "points": [[3, 0], [1, 6], [9, 13], [12, 8], [16, 0]]}, "times": 1})",
     R"({"curve": {"degree": 4, "points": [[2, -1], [3, 8], [10, 9], [12, 6], [14, 0]]}, "times": 1})",
     R"({"curve": {"degree": 4, "points": [[1, -2], [4, 8], [8, 10], [16, 10], [14, 2]]}, "times": 1})",
     0x187f35f79cac105a},
};

const std::string secret = "correct horse battery";

std::string inputs_of(const VariantMaker& maker, const std::string& student) {
  const auto variant = maker.make(student, secret);
  INFO(to_string(variant.diagnostics));
  REQUIRE(variant);
  return write_json(*variant->root().find("inputs"));
}

std::string written_alike(const std::string& json) {
  const auto document = JsonDocument::parse("golden", json);
  REQUIRE(document);
  return write_json(document->root());
}

}  // namespace

TEST_CASE("Variants of shipped exercises are what they always were") {
  for (const Golden& golden : goldens) {
    const auto document = JsonDocument::load("exercises/" + std::string(golden.exercise) + ".json");
    REQUIRE(document);
    const VariantMaker maker(*document);
    INFO(golden.exercise);
    CHECK(inputs_of(maker, "s17") == written_alike(golden.s17));
    CHECK(inputs_of(maker, "lovelace") == written_alike(golden.lovelace));
    CHECK(inputs_of(maker, "0") == written_alike(golden.zero));
    std::uint64_t hash = 0xcbf29ce484222325;
    for (int i = 0; i < 300; ++i)
      for (const char c : inputs_of(maker, "s" + std::to_string(i)) + "\n")
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    CHECK(hash == golden.class_of_300);
  }
}
