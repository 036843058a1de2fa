#pragma once
// "Why?": the chain from a value down to what was given.

#include "trace/trace.hpp"

namespace blossom {

struct WhyLine {
  ValueId value = 0;
  int depth = 0;
  bool given = false;
  bool told_above = false;
};

// Depth first, operands in the rule's order. A value that was told already is not opened again.
std::vector<WhyLine> why(const TraceGraph&, ValueId, std::size_t most = 5000);

}  // namespace blossom
