// The instructor's guide: its files are in order, its commands do what they say, and it has every key.
#include <sstream>

#include "app/program.hpp"
#include "base/json.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

struct Block {
  std::string language, name, text;
};

// ```LANGUAGE NAME ... ```
std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  bool inside = false;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (!inside) continue;
      const std::string head = line.substr(3);
      const auto blank = head.find(' ');
      blocks.push_back({head.substr(0, blank), blank == std::string::npos ? "" : head.substr(blank + 1), ""});
    } else if (inside) {
      blocks.back().text += line + "\n";
    }
  }
  REQUIRE_FALSE(inside);
  return blocks;
}

std::string guide() { return read_all(fs::path(BLOSSOM_SOURCE_DIR) / "lessons/GUIDE.md"); }

// Every key of a schema's "properties", as deep as they go, of what may stand in a lesson.
void collect_keys(const Json& schema, std::vector<std::string>& keys) {
  for (std::size_t i = 0; i < schema.items.size(); ++i) {
    if (schema.kind == Json::Kind::object && schema.keys[i] == "properties" &&
        schema.items[i].kind == Json::Kind::object)
      for (const std::string& key : schema.items[i].keys) keys.push_back(key);
    collect_keys(schema.items[i], keys);
  }
}

}  // namespace

TEST_CASE("the instructor's guide: its commands run, in a folder of their own, on its own files", "[app][guide]") {
  const Scratch scratch;
  std::string commands = "set -e\nexport PATH=\"" + std::string(BLOSSOM_BIN_DIR) + ":$PATH\" BLOSSOM=\"" +
                         std::string(BLOSSOM_SOURCE_DIR) + "\"\n";
  std::size_t count = 0;
  for (const Block& block : blocks_of(guide())) {
    if (block.language == "json" && !block.name.empty()) scratch.write(block.name, block.text);
    if (block.language != "sh") continue;
    std::istringstream lines(block.text);
    for (std::string line; std::getline(lines, line); ++count) {
#ifndef BLOSSOM_PLAYER
      if (line.starts_with("blossom export")) continue;  // what draws is left out of this build
#endif
      commands += "echo \"$ " + line.substr(0, line.find('"')) + "\"\n" + line + "\n";
    }
  }
  CHECK(count >= 10);
  const auto ended = run_program("/bin/bash", {scratch.write("guide.sh", commands)}, {.folder = scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
}

TEST_CASE("the instructor's guide: its files are in order", "[app][guide]") {
  const Scratch scratch;
  std::size_t checked = 0;
  for (const Block& block : blocks_of(guide())) {
    if (block.language != "json") continue;
    const auto document = JsonDocument::parse("GUIDE.md", block.text);
    SECTION("block " + std::to_string(++checked)) {
      INFO(block.text << to_string(document.diagnostics));
      REQUIRE(document);
      if (document->root().find("schema") == nullptr) continue;  // of an editor
      // Beside the page's other files, which an assignment names; prerequisites are found among the shipped lessons.
      for (const Block& other : blocks_of(guide()))
        if (!other.name.empty()) scratch.write(other.name, other.text);
      const auto linted = blossom::test::blossom({"lint", scratch.write(block.name, block.text)});
      SHOW(linted);
      CHECK(linted.status == 0);
    }
  }
}

TEST_CASE("the instructor's guide: the lesson of every key has every key of the schema", "[app][guide]") {
  std::vector<std::string> keys;
  const auto schema = JsonDocument::load(fs::path(BLOSSOM_SOURCE_DIR) / "lessons/lesson.schema.json");
  REQUIRE(schema);
  collect_keys(schema->root(), keys);
  REQUIRE(keys.size() > 30);
  std::string lesson;
  for (const Block& block : blocks_of(guide()))
    if (block.name == "every-key.json") lesson = block.text;
  REQUIRE_FALSE(lesson.empty());
  for (const std::string& key : keys)
    if (key != "$schema") {
      INFO(key);
      CHECK(contains(lesson, "\"" + key + "\":"));
    }
}
