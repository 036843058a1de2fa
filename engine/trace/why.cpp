#include "trace/why.hpp"

namespace blossom {

std::vector<WhyLine> why(const TraceGraph& graph, ValueId v, std::size_t most) {
  std::vector<WhyLine> lines;
  std::vector<bool> opened(graph.value_count());
  std::vector<std::pair<ValueId, int>> open{{v, 0}};
  while (!open.empty() && lines.size() < most) {
    const auto [w, depth] = open.back();
    open.pop_back();
    lines.push_back({w, depth, graph.is_input(w), opened[w]});
    if (graph.is_input(w) || opened[w]) continue;
    opened[w] = true;
    const auto operands = graph.operands(w);
    for (auto o = operands.rbegin(); o != operands.rend(); ++o) open.emplace_back(*o, depth + 1);
  }
  return lines;
}

}  // namespace blossom
