#pragma once
// From recipes to geometry: what algorithms can be applied to what is chosen, and things made anew when what they are
// made from has changed.

#include "algorithms/run.hpp"
#include "studio/workspace.hpp"

namespace blossom {

// Makes every made thing anew. One that cannot be made keeps its geometry and says why in `problem`. Exact arithmetic
// where it takes little time and what it is made from is exact; otherwise (and with `quick`, while something is
// dragged) doubles, marked approximate. Where one looks at a thing moves into its new domain.
void remake(Workspace&, bool quick = false);
// Those that follow, directly or not, from one of these.
void remake_after(Workspace&, const std::vector<std::size_t>& changed, bool quick = false);

// The inputs of a recipe with its references looked up among the things before index `before`: to be run, or stepped.
// A curve stands for the row of its control points, a surface for the net of them, where points are wanted.
// Diagnostics have paths that begin at the inputs.
Checked<Inputs<Exact>> inputs_of(const Workspace&, const Recipe&, std::size_t before);
// The geometry a recipe gives: one of a curve or surface, or all pieces of a result of several. A point of an
// evaluation is a row of one point.
Checked<std::vector<Geometry>> made_by(const Workspace&, const Recipe&, std::size_t before, bool quick = false);
Checked<std::vector<Geometry>> made_by(const Algorithm&, const Inputs<Exact>&, bool quick = false);

// What SceneObject::problem says of it: one line for each.
std::string problem_of(const Diagnostics&);

// What the algorithm demands of inputs that are each valid alone (Algorithm::check), with paths that begin at them.
Diagnostics complaints(const Algorithm&, const Inputs<Exact>&);

// Whether the algorithm can take these things as its inputs, all of them: one curve for `curve`, two for two, three for
// `profiles`; and has no complaint about them.
bool takes(const Algorithm&, const Workspace&, const std::vector<std::size_t>& objects);
// The algorithms that do, by family and title.
std::vector<const Algorithm*> algorithms_for(const Workspace&, const std::vector<std::size_t>& objects);
// The recipe with these things as inputs in this order, parameters where the things are looked at (u, v), and fallbacks
// for the rest; where there is no fallback: a number in the middle of the domain, the least integer, the first choice.
// Of a parameter the algorithm complains about: the middle of a span. Precondition: the things fit (takes).
Recipe recipe_for(const Algorithm&, const Workspace&, const std::vector<std::size_t>& objects);

// The names of the things a recipe refers to, each once.
std::vector<std::string> sources_of(const Recipe&);

// How many points a thing has, a scene in all, and inputs together: what is bounded, so that no scene takes for ever.
std::size_t point_count(const Geometry&);
std::size_t point_count(const Workspace&);
std::size_t point_count(const Inputs<Exact>&);
inline constexpr std::size_t most_scene_points = 262'144;  // in all
inline constexpr std::size_t most_recipe_points = 65'536;  // that one thing is made from

}  // namespace blossom
