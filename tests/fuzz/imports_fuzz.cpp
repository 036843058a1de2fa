// Any bytes as another program's file; the first one says of which format. OpenCASCADE's run in a process each, and are
// left out.

#include "exchange/format.hpp"
#include "fuzz.hpp"

using namespace blossom;
using namespace blossom::fuzz;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto formats = [] {
    std::vector<const ExchangeFormat*> own;
    for (const ExchangeFormat* format : exchange_formats())
      if (format->import != nullptr && format->id != "step" && format->id != "iges") own.push_back(format);
    return own;
  }();
  if (size == 0) return 0;
  const std::string bytes = text_of(data + 1, size - 1);
  check_outcome(formats[data[0] % formats.size()]->import("f", bytes), bytes);
  return 0;
}
