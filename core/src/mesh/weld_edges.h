#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/listener.h"

namespace abflat {

using VertexPairs = std::vector<std::array<std::uint32_t, 2>>;

/// The first vertex of those that are joined, per vertex. `place`: as it was before.
std::vector<std::uint32_t> joinVertices(const VertexPairs& pairs, std::vector<std::uint32_t> place);

/// Merges the ends of edges whose length is negligible compared with all faces around both ends:
/// * without any length, such as the many at poles of spheres and capsules. Angles computed from
///   them would be noise;
/// * too short to be seen, if a face that is not a sliver is at both ends. A place never grows
///   beyond that length, so many short edges in a row stay a curve.
/// `place` and the result: the first vertex at the same place, per vertex.
std::vector<std::uint32_t> weldEdges(const PolygonMesh& mesh, const Listener& listener,
                                     const std::vector<std::uint32_t>& place);

}  // namespace abflat
