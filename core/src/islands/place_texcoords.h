#pragma once

#include <cstdint>
#include <vector>

#include "abflat/mesh.h"
#include "abflat/pack_layout.h"
#include "islands/read_layout.h"
#include "pack/pack.h"

namespace abflat {

/// As in PackLayoutResult.
struct PlacedTexcoords {
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerUv;
};

/// Moves texcoords with their stacks; those of faces without an island stay, or all if asked for.
PlacedTexcoords placeTexcoords(const PolygonMesh& mesh, const MeshLayout& layout,
                               const Packing& packing, const PackLayoutOptions& options);

}  // namespace abflat
