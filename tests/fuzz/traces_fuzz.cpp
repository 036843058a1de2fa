// Any document as a trace: an accepted one is written as text that gives the same trace.

#include "algorithms/trace_json.hpp"
#include "fuzz.hpp"

using namespace blossom;
using namespace blossom::fuzz;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = text_of(data, size);
  const auto document = JsonDocument::parse("f", text);
  if (!document) return 0;
  const auto stored = read_trace(*document);
  check_outcome(stored, text);
  if (!stored) return 0;
  std::visit(
      [&](const auto& run) {
        const std::string written = write_trace(Narrator(run));
        const auto again_document = JsonDocument::parse("g", written);
        require(again_document.value.has_value(), "a written trace is JSON", to_string(again_document.diagnostics));
        const auto again = read_trace(*again_document);
        require(again.value.has_value(), "a written trace reads back", written + "\n" + to_string(again.diagnostics));
        const auto* same_scalar = std::get_if<std::remove_cvref_t<decltype(run)>>(&*again);
        require(same_scalar != nullptr && same_scalar->trace == run.trace, "and is the same trace", written);
      },
      *stored);
  return 0;
}
