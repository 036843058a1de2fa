// Any document as a scene: what is accepted is written, and reads back as the same scene.

#include "fuzz.hpp"
#include "studio/scene_file.hpp"

using namespace blossom;
using namespace blossom::fuzz;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("f", text);
  if (!document) return 0;
  const auto scene = read_scene(*document);
  check_outcome(scene, text);
  if (!scene) return 0;
  const std::string written = write_scene(*scene);
  const auto again = JsonDocument::parse("again", written);
  require(again.value.has_value(), "what is written is JSON", written);
  const auto read = read_scene(*again);
  require(read && *read == *scene, "what is written reads back as the same scene", written);
  return 0;
}
