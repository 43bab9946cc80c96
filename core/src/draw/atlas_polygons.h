#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "abflat/unwrap.h"

namespace abflat {

/// Whether charts count that lie on others.
enum class Stacked : std::uint8_t { Count, LeftOut };

/// The faces of a mesh as they lie in the atlas, without collapsed ones.
struct AtlasPolygons {
  std::vector<std::uint32_t> offsets = {0};  ///< corners of polygon i: [offsets[i], offsets[i+1])
  std::vector<std::uint32_t> corners;        ///< indices into the mesh's faceVertices
  std::vector<std::uint32_t> face;           ///< per polygon

  std::uint32_t count() const { return static_cast<std::uint32_t>(face.size()); }
};
AtlasPolygons atlasPolygons(const PolygonMesh& mesh, const UnwrapResult& result,
                            Stacked stacked = Stacked::Count);

/// Edges of polygons by their texcoords, each listed once.
struct AtlasEdges {
  std::vector<std::array<std::uint32_t, 2>> inner;    ///< between two polygons of a chart
  std::vector<std::array<std::uint32_t, 2>> outline;  ///< of the charts, which are on their left
};
AtlasEdges atlasEdges(const AtlasPolygons& polygons, const std::vector<std::uint32_t>& cornerUv);

}  // namespace abflat
