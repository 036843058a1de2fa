#pragma once
// Places in a view that stand for something, and what is lit because of it. A panel tells its spots as it lays itself
// out; whoever shows the panel finds the one under the mouse, and asks every panel to light what belongs to it.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scene/display_list.hpp"
#include "trace/trace.hpp"

namespace blossom {

// What a place stands for.
struct Link {
  enum class Kind : std::uint8_t {
    none,
    value,      // id: the ValueId
    line,       // id: the line of pseudo-code, from 1
    phase,      // id: the phase
    step,       // id: the step
    knot,       // id: the index of the first of the equal knots, in the knots of the input curve
    parameter,  // the input u
    basis,      // id: i of the basis function N_{i,p}
    object,     // id: the thing of a scene; part: 0 the thing itself, from 1 its control points
    handle,     // id: a handle for moving (0 to 2 along x, y, z; 3 in the view), turning (4 to 6) and scaling (7)
  };
  Kind kind = Kind::none;
  std::uint32_t id = 0;
  std::uint32_t part = 0;
  explicit operator bool() const { return kind != Kind::none; }
  bool operator==(const Link&) const = default;
};

struct Spot {
  Link link;
  double x = 0, y = 0, width = 0, height = 0;  // in page units, from the top left of its view
  std::string name;                            // what scripts and screen readers call it: "P[1][4]", "line 3"
};

// A view of page coordinates with its spots.
struct Sheet {
  View view;
  std::vector<Spot> spots;
};

// What is lit besides the step itself.
struct Emphasis {
  std::vector<ValueId> lit;                        // ascending: what one points at, has pinned, or follows
  std::vector<std::pair<ValueId, double>> shares;  // ascending: what the lit value came from, and with which weight
  int line = 0;                                    // of the pseudo-code; 0: none
  bool quiet = false;                              // so many are lit that rings around them all would point at nothing

  bool empty() const { return lit.empty() && shares.empty() && line == 0; }
  bool lights(ValueId v) const { return std::binary_search(lit.begin(), lit.end(), v); }
  double share(ValueId v) const {  // 0: none
    const auto found = std::lower_bound(shares.begin(), shares.end(), v,
                                        [](const auto& entry, ValueId id) { return entry.first < id; });
    return found != shares.end() && found->first == v ? found->second : 0;
  }
  bool operator==(const Emphasis&) const = default;
};

}  // namespace blossom
