// Streams: a line in, a line out, whatever the line is and wherever the input is cut.

#include "grader/batch/stream.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <random>
#include <sstream>
#include <system_error>

#include "base/json.hpp"
#include "grader/digest.hpp"
#include "scratch.hpp"

namespace blossom {
namespace {

const char* const exercise_text = R"({
  "schema": "blossom.exercise/1", "id": "halves", "title": "T", "prompt": "P", "algorithm": "de_casteljau",
  "inputs": {"curve": {"degree": 2, "points": [[0, 0], [2, 4], [6, 0]]}, "u": "1/2"},
  "ask": [{"value": "P[1][0]", "points": 1}, {"value": "C", "points": 1}], "feedback": "verdict"})";

Assignment assignment_of(const std::string& text) {
  auto document = JsonDocument::parse("assignment", text);
  REQUIRE(document);
  auto assignment = read_assignment(*document);
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  return std::move(*assignment);
}

std::string answers(const std::string& values, const std::string& id = "halves") {
  return R"("schema": "blossom.answers/1", "exercise": ")" + id + R"(", "answers": {)" + values + "}";
}
const std::string right = R"("P[1][0]": [1, 2], "C": ["5/2", 2])";

// An open file of these bytes, closed at the end.
struct Opened {
  explicit Opened(const std::string& path) : file(open(path.c_str(), O_RDONLY | O_CLOEXEC)) { REQUIRE(file >= 0); }
  ~Opened() { close(file); }
  int file;
};

std::vector<std::string> read_lines(const std::string& path, const Extent& extent) {
  const Opened opened(path);
  LineReader reader(opened.file, extent);
  std::vector<std::string> lines;
  for (std::string line; reader.next(line);) lines.push_back(line);
  CHECK_FALSE([&] {
    std::string line;
    return reader.next(line);
  }());
  return lines;
}

std::string graded(Examiner& examiner, const std::string& line) {
  std::string out;
  grade_line(examiner, line, out);
  REQUIRE_FALSE(out.empty());
  REQUIRE(out.find('\n') == out.size() - 1);
  return out;
}

std::string text_at(const JsonDocument& object, const char* key) {
  const Json* found = object.root().find(key);
  return found == nullptr ? "-" : found->text;
}

}  // namespace

TEST_CASE("parts of a file hold each line once, in order, however many there are") {
  const unsigned seed = std::random_device{}();
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  const auto random = [&] { return static_cast<unsigned>(generator()); };
  const test::Scratch scratch;
  for (int time = 0; time < 20; ++time) {
    // Short and empty lines, long ones, some longer than what is read at once; the last with its end or without.
    std::string text;
    std::vector<std::string> lines;
    for (unsigned i = random() % 40; i > 0; --i) {
      const unsigned kind = random() % 10;
      const std::size_t size = kind == 0 ? 200'000 + random() % 50'000 : kind < 3 ? 0 : random() % 300;
      lines.emplace_back(size, static_cast<char>('a' + random() % 26));
      text += lines.back() + "\n";
    }
    if (random() % 2 == 0) text += lines.emplace_back("the last");
    const std::string file = scratch.write("lines", text);
    CHECK(read_lines(file, {}) == lines);
    for (const unsigned count : {1u, 2u, 3u, 7u, 100u}) {
      INFO(text.size() << " bytes in " << count << " parts");
      std::vector<std::string> all;
      for (unsigned i = 1; i <= count; ++i)
        for (std::string& line : read_lines(file, shard_of(text.size(), i, count))) all.push_back(std::move(line));
      REQUIRE(all == lines);
    }
  }
}

TEST_CASE("parts are nearly equal and cover the whole, up to the largest file there can be") {
  for (const std::uint64_t bytes : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1000}, std::uint64_t{INT64_MAX}})
    for (const unsigned count : {1u, 3u, 64u, 1'000'000u}) {
      INFO(bytes << " bytes in " << count);
      CHECK(shard_of(bytes, 1, count).begin == 0);
      CHECK(shard_of(bytes, count, count).end == bytes);
      for (const unsigned index : {1u, count / 2, count - 1}) {
        if (index < 1 || index >= count) continue;
        const Extent part = shard_of(bytes, index, count);
        CHECK(part.end == shard_of(bytes, index + 1, count).begin);
        CHECK(part.end - part.begin >= bytes / count);
        CHECK(part.end - part.begin <= bytes / count + 1);
      }
    }
}

TEST_CASE("a line that is too long is refused with its digest, and its neighbours are read") {
  const test::Scratch scratch;
  for (const std::size_t size : {longest_line, longest_line + 1, 2 * longest_line, 5'000'000ul}) {
    INFO(size);
    const std::string large(size, 'x');
    for (const char* const end : {"\n", "\nafter\n", ""}) {
      const auto lines = read_lines(scratch.write("lines", "before\n" + large + end), {});
      REQUIRE(lines.size() == (std::string(end).size() > 1 ? 3 : 2));
      CHECK(lines[0] == "before");
      CHECK(lines[1] == (size <= longest_line ? large : "\n" + sha256_hex(large).substr(0, 16)));
      if (lines.size() == 3) CHECK(lines[2] == "after");
    }
  }
}

TEST_CASE("what cannot be read is said, not taken for the end") {
  const test::Scratch scratch;
  const Opened folder(scratch.path());
  LineReader reader(folder.file, {});
  std::string line;
  CHECK_THROWS_AS(reader.next(line), std::system_error);
}

TEST_CASE("a line gives the grade that the submission has by itself, with its student") {
  Examiner examiner(assignment_of(exercise_text), "", Time());
  const std::string expected =
      R"({"schema":"blossom.grade/1","exercise":"halves","student":"s1","score":1,"points":2,"max_points":2,"parts":[)"
      R"({"value":"P[1][0]","verdict":"correct","points":1,"max_points":1,"feedback":""},)"
      R"({"value":"C","verdict":"correct","points":1,"max_points":1,"feedback":""}]})"
      "\n";
  const std::string file = "{" + answers(right) + "}";
  CHECK(graded(examiner, R"({"student": "s1", )" + answers(right) + "}") == expected);
  CHECK(graded(examiner, "{" + answers(right) +
                             R"(, "student": "s1"})"
                             "\r") == expected);
  CHECK(graded(examiner, R"({"student": "s1", "submission": )" + file + "}") == expected);
  CHECK(graded(examiner, R"({"submission": )" + json_quote(file) + R"(, "student": "s1"})") == expected);
  // The only exercise there is says itself what is wrong with a submission.
  const std::string other = graded(examiner, R"({"student": "s1", )" + answers(right, "thirds") + "}");
  CHECK(other.find(R"("exercise":"halves","student":"s1","score":0)") != std::string::npos);
  CHECK(other.find(R"("reason":)") != std::string::npos);
}

TEST_CASE("a line that cannot be graded gives an object that says why, and which line it was") {
  Examiner examiner(assignment_of(exercise_text), "", Time());
  for (const std::string& line :
       {std::string(), std::string("   "), std::string("nonsense"), std::string("[1, 2]"), std::string("{}"),
        "{" + answers(right) + "}", R"({"student": 7, )" + answers(right) + "}", std::string("\xFF\xFE\x00", 3),
        std::string(R"({"student": "s1", "submission": 5})"), std::string(200'000, '[')}) {
    INFO(line.substr(0, 80));
    const auto object = JsonDocument::parse("out", graded(examiner, line));
    REQUIRE(object);
    CHECK(text_at(*object, "schema") == "blossom.grade/1");
    CHECK(text_at(*object, "exercise").empty());
    CHECK(text_at(*object, "score") == "0");
    CHECK(object->root().find("parts")->items.empty());
    CHECK(text_at(*object, "reason").size() > 5);
    CHECK(text_at(*object, "digest") == sha256_hex(line).substr(0, 16));
  }
  const auto lost = JsonDocument::parse("out", graded(examiner, "\n0123456789abcdef"));
  REQUIRE(lost);
  CHECK(text_at(*lost, "digest") == "0123456789abcdef");
}

TEST_CASE("of several exercises, a line says which") {
  const test::Scratch scratch;
  std::string other = exercise_text;
  other.replace(other.find("halves"), 6, "thirds");
  const std::string files = scratch.write("a.json", exercise_text) + scratch.write("b.json", other);
  auto assignment = load_assignment(scratch.write("course.json", R"({
    "schema": "blossom.assignment/1", "id": "course", "title": "C",
    "exercises": [{"file": "a.json"}, {"file": "b.json"}]})"));
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  Examiner examiner(std::move(*assignment), "", Time());
  for (const char* const id : {"halves", "thirds"})
    CHECK(graded(examiner, R"({"student": "s1", )" + answers(right, id) + "}")
              .starts_with(R"({"schema":"blossom.grade/1","exercise":")" + std::string(id) +
                           R"(","student":"s1","score":1,)"));
  for (const std::string& line : {R"({"student": "s1", )" + answers(right, "fifths") + "}",
                                  std::string(R"({"student": "s1", "schema": "blossom.answers/1", "answers": {}})"),
                                  std::string(R"({"student": "s1", "submission": "not JSON"})")}) {
    INFO(line);
    CHECK(graded(examiner, line).starts_with(R"({"schema":"blossom.grade/1","exercise":"","student":"s1","score":0,)"));
  }
}

TEST_CASE("a stream gives the same bytes on any number of workers; what a worker died of has its object") {
  const test::Scratch scratch;
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += i % 100 == 50 ? "DIE\n"
                          : R"({"student": "s)" + std::to_string(i) + "\", " +
                                answers(i % 3 == 0 ? right : R"("C": [1, )" + std::to_string(i) + "]") + "}\n";
  const std::string file = scratch.write("lines", text);
  const auto run = [&](unsigned processes) {
    Examiner examiner(assignment_of(exercise_text), "", Time());
    prepare_for_workers(examiner);
    WorkerOptions options;
    options.processes = processes;
    Workers workers(
        [&](std::string_view item, std::string& line) {
          if (item == "DIE") abort();
          grade_line(examiner, item, line);
        },
        options);
    const Opened opened(file);
    LineReader reader(opened.file, {});
    std::string out;
    const StreamCounts counts = grade_stream(reader, workers, [&](std::string_view lines) { out += lines; });
    CHECK(counts.lines == 3000);
    CHECK(counts.ungraded == 30);
    return out;
  };
  const std::string one = run(1);
  CHECK(one == run(2));
  CHECK(one == run(5));
  std::istringstream lines(one);
  int number = 0;
  for (std::string line; std::getline(lines, line); ++number) {
    const auto object = JsonDocument::parse("out", line);
    REQUIRE(object);
    const bool died = number % 100 == 50;
    REQUIRE(text_at(*object, "student") == (died ? "-" : "s" + std::to_string(number)));
    if (!died) continue;
    CHECK(text_at(*object, "reason") == "the grader died of signal 6 (SIGABRT)");
    CHECK(text_at(*object, "digest") == sha256_hex("DIE").substr(0, 16));
  }
  CHECK(number == 3000);
}

}  // namespace blossom
