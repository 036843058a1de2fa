// The generator of grader/VARIANTS.md. The expected numbers come from another implementation of that text (Python's
// hmac and hashlib).

#include <catch2/catch.hpp>
#include <set>

#include "grader/variant.hpp"
#include "scratch.hpp"

using namespace blossom;

namespace {

std::vector<std::uint64_t> numbers(VariantStream stream, std::uint64_t below, int count) {
  std::vector<std::uint64_t> drawn;
  for (int i = 0; i < count; ++i) drawn.push_back(stream.below(below));
  return drawn;
}

const std::string secret = "correct horse battery";

}  // namespace

TEST_CASE("The stream of numbers is the published one") {
  using Numbers = std::vector<std::uint64_t>;
  CHECK(numbers({secret, "own-de-casteljau", "s17"}, std::uint64_t{1} << 63, 6) ==
        Numbers{4795246437884189396u, 7039532471855029861u, 609780503983947830u, 6194015568327177360u,
                175338941814068965u, 4621405183265467397u});
  CHECK(numbers({secret, "own-de-casteljau", "s17"}, 10, 20) ==
        Numbers{3, 6, 1, 4, 6, 3, 0, 9, 4, 0, 2, 5, 7, 3, 8, 7, 2, 3, 6, 4});
  SECTION("whatever bytes an ID has") {
    std::string id;
    for (int i = 0; i < 256; ++i) id += static_cast<char>(i);
    CHECK(numbers({secret, "own-de-casteljau", id}, 1000, 5) == Numbers{860, 658, 232, 603, 173});
  }
  SECTION(
      "below a number that nearly half of the words are not below a multiple of; with a secret longer than a block "
      "of SHA-256") {
    CHECK(numbers({std::string(200, 'k'), "x", ""}, (std::uint64_t{1} << 63) + 1, 6) ==
          Numbers{4663341641099980062u, 136179569128589675u, 7767962645602194691u, 7997153217932773284u,
                  3069304230404308635u, 1193010827398797481u});
  }
}

TEST_CASE("Secret, exercise and student each make another stream") {
  std::set<std::vector<std::uint64_t>> streams;
  for (const char* key : {"correct horse battery", "correct horse batterz"})
    for (const char* exercise : {"a", "b", "ab"})
      for (const char* student : {"", "a", "b", "b\n"})
        streams.insert(numbers({key, exercise, student}, std::uint64_t{1} << 62, 3));
  CHECK(streams.size() == 2 * 3 * 4);
}

TEST_CASE("Every number below n comes, about equally often") {
  constexpr int draws = 7000;
  std::vector<int> count(7, 0);
  VariantStream stream(secret, "a", "b");
  for (int i = 0; i < draws; ++i) ++count[stream.below(7)];
  // Beyond five standard deviations of a binomial distribution: less than once in a million streams, and it is one
  // stream.
  for (const int n : count) CHECK(std::abs(n - draws / 7) < 5 * 30);
  CHECK(stream.below(1) == 0);
}

TEST_CASE("A secret is a file's bytes without its last line break") {
  const test::Scratch scratch;
  const auto load = [&](const std::string& content) { return load_secret(scratch.write("secret", content)); };
  for (const char* end : {"", "\n", "\r\n"}) {
    const auto read = load("0123456789abcdef" + std::string(end));
    REQUIRE(read);
    CHECK(*read == "0123456789abcdef");
  }
  CHECK(*load("0123456789abcdef\n\n") == "0123456789abcdef\n");
  CHECK(*load("0123456789abcdef\r") == "0123456789abcdef\r");
  CHECK(*load(std::string(16, '\0')) == std::string(16, '\0'));
  CHECK(load(std::string(4096, 'x') + "\r\n")->size() == 4096);
  for (const std::string& wrong :
       {std::string(), std::string("0123456789abcde\n"), std::string(4097, 'x'), std::string(9999, 'x')}) {
    const auto read = load(wrong);
    CHECK_FALSE(read);
    CHECK(to_string(read.diagnostics).find("at least 16 bytes and at most 4096") != std::string::npos);
  }
  CHECK_FALSE(load_secret(scratch / "none"));
  CHECK_FALSE(load_secret(scratch.path()));
  CHECK_FALSE(load_secret("/dev/zero"));
}
