#pragma once
// Stripes on a mesh with sharp edges, whatever its triangles are.

#include "scene/display_list.hpp"

namespace blossom {

// Dark where the whole part of a vertex's number is even, light where it is odd: triangles are cut where the number,
// running linearly in each, is whole. A triangle with a number that is none keeps the mesh's own colour as dark; one
// with very many stripes has their mean, for they could not be seen.
Mesh banded(const Mesh&, const std::vector<double>& numbers);

}  // namespace blossom
