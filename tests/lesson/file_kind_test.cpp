#include "lesson/file_kind.hpp"

#include <catch2/catch.hpp>

using namespace blossom;

namespace {

FileKind kind_of(const std::string& text) {
  const auto document = JsonDocument::parse("f", text);
  REQUIRE(document);
  return file_kind(document->root());
}

}  // namespace

TEST_CASE("a file says what it is") {
  CHECK(kind_of(R"({"schema": "blossom.lesson/1"})") == FileKind::lesson);
  CHECK(kind_of(R"({"schema": "blossom.exercise/1"})") == FileKind::exercise);
  CHECK(kind_of(R"({"schema": "blossom.assignment/1"})") == FileKind::assignment);
  CHECK(kind_of(R"({"schema": "blossom.answers/1"})") == FileKind::answers);
  CHECK(kind_of(R"({"schema": "blossom.grade/1"})") == FileKind::grade);
  CHECK(kind_of(R"({"schema": "blossom.result/1"})") == FileKind::result);
  CHECK(kind_of(R"({"schema": "blossom.trace/1", "beats": []})") == FileKind::trace);
  CHECK(kind_of(R"({"schema": "blossom.scene/1"})") == FileKind::scene);
  CHECK(kind_of(R"({"schema": "blossom.lesson/7"})") == FileKind::lesson);  // its reader knows which version it reads
  CHECK(kind_of(R"({"schema": "blossom.curve/1"})") == FileKind::unknown);
}

TEST_CASE("a file that does not say what it is, or says it wrong, is known by its keys") {
  CHECK(kind_of(R"({"schema": "blosom.lesson/1", "beats": []})") == FileKind::lesson);
  CHECK(kind_of(R"({"schema": 1, "ask": []})") == FileKind::exercise);
  CHECK(kind_of(R"({"exercises": []})") == FileKind::assignment);
  CHECK(kind_of(R"({"exercises": [], "score": 1})") == FileKind::result);
  CHECK(kind_of(R"({"answers": {}})") == FileKind::answers);
  CHECK(kind_of(R"({"parts": []})") == FileKind::grade);
  CHECK(kind_of(R"({"steps": [], "values": []})") == FileKind::trace);
  CHECK(kind_of(R"({"objects": []})") == FileKind::scene);
  CHECK(kind_of(R"({"degree": 2, "points": []})") == FileKind::curve);
  CHECK(kind_of(R"({"points": []})") == FileKind::curve);
  CHECK(kind_of(R"({"degree": [2, 2], "points": []})") == FileKind::surface);
  CHECK(kind_of("{}") == FileKind::unknown);
  CHECK(kind_of("[]") == FileKind::unknown);
  CHECK(kind_of("3") == FileKind::unknown);
}

TEST_CASE("a JSON Schema is about files and none of them") {
  CHECK(kind_of(R"({"$schema": "https://json-schema.org/draft/2020-12/schema", "ask": []})") == FileKind::schema);
  CHECK(kind_of(R"({"$schema": "http://json-schema.org/draft-07/schema#"})") == FileKind::schema);
  CHECK(kind_of(R"({"$schema": "lesson.schema.json", "beats": []})") == FileKind::lesson);
  CHECK(kind_of(R"({"$schema": "https://json-schema.org/x", "schema": "blossom.exercise/1"})") == FileKind::exercise);
  CHECK(kind_of(R"({"$schema": 7})") == FileKind::unknown);
}

TEST_CASE("kinds have names") {
  CHECK(file_kind_name(FileKind::lesson) == "lesson");
  CHECK(file_kind_name(FileKind::surface) == "surface");
  CHECK(file_kind_name(FileKind::unknown) == "unknown");
}
