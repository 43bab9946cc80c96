#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "base/pulse.h"
#include "mesh/weld.h"

namespace abflat {

using VertexPairs = std::vector<std::array<std::uint32_t, 2>>;

/// Points vertices to the first one of those they are joined with.
void joinVertices(const VertexPairs& pairs, Welding& welding);

/// Merges the ends of edges whose length is negligible compared with all faces around both ends:
/// * without any length, such as the many at poles of spheres and capsules. Angles computed from
///   them would be noise;
/// * too short to be seen, if a face that is not a sliver is at both ends. A place never grows
///   beyond that length, so many short edges in a row stay a curve.
void weldEdges(const PolygonMesh& mesh, const Pulse& pulse, Welding& welding);

}  // namespace abflat
