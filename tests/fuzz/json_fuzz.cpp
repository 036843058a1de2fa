// Any bytes as JSON: what is accepted is JSON to another reader, too, and reads back the same when it is written; what
// is refused is either no JSON to it or refused for one of the reasons that json.hpp names.

#include <array>
#include <nlohmann/json.hpp>

#include "fuzz.hpp"

using namespace blossom;
using namespace blossom::fuzz;

namespace {

constexpr JsonLimits limits{1u << 20, 32, 20'000};

void check_places(const JsonDocument& document, const Json& json) {
  const auto [line, column] = document.line_and_column(json.token);
  require(line > 0 && column > 0, "each value has a place");
  for (const Json& item : json.items) check_places(document, item);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("f", text, limits);
  check_outcome(document, text);
  if (!document) {
    constexpr std::array stricter{"duplicate key", "too large", "nested too deep", "too many values", "a NUL byte"};
    const std::string& reason = document.diagnostics.front().message;
    const bool ours = std::any_of(stricter.begin(), stricter.end(),
                                  [&](const char* s) { return reason.find(s) != std::string::npos; });
    require(ours || !nlohmann::json::accept(text), "JSON is refused for a reason", reason);
    return 0;
  }
  require(nlohmann::json::accept(text), "what is accepted is JSON");
  check_places(*document, document->root());
  const std::string written = write_json(document->root());
  const auto again = JsonDocument::parse("g", written, limits);
  require(again && same(document->root(), again->root()), "written and read again it is the same", written);
  require(write_json(again->root()) == written, "and written again, too", written);
  return 0;
}
