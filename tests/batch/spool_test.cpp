// Submissions put in the order of the class, and what happens to files that are not what was written.

#include "grader/batch/spool.hpp"

#include <fstream>
#include <map>
#include <random>
#include <stdexcept>

#include "scratch.hpp"

using namespace blossom;

namespace {

using Records = std::vector<std::pair<std::uint64_t, std::string>>;

Records read(const SpoolReader& reader, std::size_t part) {
  Records records;
  const auto done =
      reader.read(part, [&](std::uint64_t student, std::string_view record) { records.emplace_back(student, record); });
  INFO(to_string(done.diagnostics));
  REQUIRE(done);
  return records;
}

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("records come back by student, each student's as they were added", "[spool]") {
  const unsigned seed = 17;
  INFO("seed " << seed);
  std::mt19937_64 random(seed);
  const test::Scratch folder;
  Spool spool(folder / "spool", 100);
  std::map<std::uint64_t, std::vector<std::string>> expected;
  for (int i = 0; i < 20'000; ++i) {
    // Some longer than any buffer, some empty, some that look like other records.
    const std::uint64_t student = random() % 2500;
    std::string record(random() % 1000 == 0 ? random() % 200'000 : random() % 60, '\0');
    for (char& c : record) c = static_cast<char>(random() % 3);
    spool.add(student, record);
    expected[student].push_back(std::move(record));
  }
  CHECK_FALSE(SpoolReader::open(folder / "spool"));  // not finished yet
  spool.finish();

  const auto reader = SpoolReader::open(folder / "spool");
  REQUIRE(reader);
  CHECK(reader->part_size() == 100);
  CHECK(reader->parts() == 25);
  CHECK(reader->records() == 20'000);
  Records all;
  for (std::size_t part = 0; part < reader->parts(); ++part) {
    const Records records = read(*reader, part);
    CHECK(records.size() == reader->records(part));
    for (const auto& [student, record] : records) REQUIRE(student / 100 == part);
    all.insert(all.end(), records.begin(), records.end());
  }
  Records in_order;
  for (const auto& [student, records] : expected)
    for (const std::string& record : records) in_order.emplace_back(student, record);
  CHECK((all == in_order));
}

TEST_CASE("a spool of nothing, and one with empty parts between", "[spool]") {
  const test::Scratch folder;
  Spool(folder / "none", 10).finish();
  REQUIRE(SpoolReader::open(folder / "none"));
  CHECK(SpoolReader::open(folder / "none")->parts() == 0);

  Spool spool(folder / "some", 10);
  spool.add(2559, "last");
  spool.add(0, "");
  spool.finish();
  const auto reader = SpoolReader::open(folder / "some");
  REQUIRE(reader);
  CHECK(reader->parts() == 256);
  CHECK(read(*reader, 0) == Records{{0, ""}});
  CHECK(read(*reader, 100).empty());
  CHECK(read(*reader, 255) == Records{{2559, "last"}});
}

TEST_CASE("what does not fit is refused, not written somewhere else", "[spool]") {
  const test::Scratch folder;
  Spool spool(folder / "spool", 10);
  CHECK_THROWS_AS(spool.add(2560, ""), std::length_error);
  CHECK_THROWS_AS(spool.add(~0ull, ""), std::length_error);
  CHECK_THROWS_AS(Spool(folder / "other", 0), std::length_error);
  CHECK_THROWS_AS(Spool(folder / "other", (1u << 24) + 1), std::length_error);
}

TEST_CASE("a folder that cannot be written is an error of the system", "[spool]") {
  const test::Scratch folder;
  folder.write("file", "");
  CHECK_THROWS_AS(Spool(folder / "file/spool", 10), std::system_error);
}

TEST_CASE("an interrupted spool is begun again and has nothing of the first one", "[spool]") {
  const test::Scratch folder;
  {
    Spool spool(folder / "spool", 1);
    for (std::uint64_t i = 0; i < 200; ++i) spool.add(i, std::string(20'000, 'x'));
  }
  CHECK_FALSE(SpoolReader::open(folder / "spool"));
  Spool again(folder / "spool", 1);
  again.add(3, "new");
  again.finish();
  const auto reader = SpoolReader::open(folder / "spool");
  REQUIRE(reader);
  CHECK(reader->records() == 1);
  CHECK(read(*reader, 3) == Records{{3, "new"}});
}

TEST_CASE("a part with any byte changed, torn or lengthened is told before anything is read of it", "[spool]") {
  const test::Scratch folder;
  Spool spool(folder / "spool", 10);
  for (std::uint64_t i = 0; i < 10; ++i) spool.add(9 - i, "record " + std::to_string(i));
  spool.finish();
  const std::string path = folder / "spool/000.part";
  const std::string whole = bytes_of(path);
  const auto reader = SpoolReader::open(folder / "spool");
  REQUIRE(reader);
  const auto is_told = [&](const std::string& content) {
    folder.write("spool/000.part", content);
    bool visited = false;
    const auto done = reader->read(0, [&](std::uint64_t, std::string_view) { visited = true; });
    return !done && !done.diagnostics.empty() && !visited;
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    INFO("byte " << i);
    CHECK(is_told(changed));
    CHECK(is_told(whole.substr(0, i)));
  }
  CHECK(is_told(whole + '\0'));
  CHECK(is_told(whole + whole));
  CHECK_FALSE(is_told(whole));
  std::filesystem::remove(path);
  CHECK_FALSE(reader->read(0, [](std::uint64_t, std::string_view) {}));
}

TEST_CASE("a mark of completeness that is torn or foreign is none", "[spool]") {
  const test::Scratch folder;
  Spool spool(folder / "spool", 10);
  spool.add(1, "record");
  spool.finish();
  const std::string mark = bytes_of(folder / "spool/complete");
  const auto opens = [&](const std::string& content) {
    folder.write("spool/complete", content);
    return SpoolReader::open(folder / "spool").has_value();
  };
  CHECK(opens(mark));
  CHECK_FALSE(opens(""));
  CHECK_FALSE(opens(mark.substr(0, mark.size() - 1)));
  CHECK_FALSE(opens(mark + "x"));
  for (std::size_t i = 0; i < mark.size(); i += 5) {
    std::string changed = mark;
    changed[i] = static_cast<char>(changed[i] ^ 4);
    REQUIRE_FALSE(opens(changed));
  }
}
