#pragma once

#include <cstdint>
#include <vector>

#include "abflat/pack_layout.h"
#include "islands/place_texcoords.h"
#include "islands/read_layout.h"
#include "pack/pack.h"

namespace abflat {

/// Measures and checks a packed layout, and fills in what follows from it in the report. Returns
/// what is wrong with each triangle of the mesh, see UvFault.
std::vector<std::uint8_t> describeLayout(const MeshLayout& layout, const Packing& packing,
                                         const PlacedTexcoords& texcoords,
                                         const PackLayoutOptions& options, PackReport& report);

}  // namespace abflat
