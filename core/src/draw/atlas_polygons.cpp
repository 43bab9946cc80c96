#include "draw/atlas_polygons.h"

#include <algorithm>

namespace abflat {

AtlasPolygons atlasPolygons(const PolygonMesh& mesh, const UnwrapResult& result, Stacked stacked) {
  std::vector<std::uint8_t> isCollapsed(mesh.faceCount(), 0);
  for (const std::uint32_t f : result.report.repair.collapsedFaces) isCollapsed[f] = 1;
  const auto isOnOther = [&](std::uint32_t f) {
    const std::uint32_t chart = result.chartOfFace[f];
    return chart != kNoChart && result.report.charts[chart].stackedOn >= 0;
  };
  AtlasPolygons out;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    if (isCollapsed[f] || (stacked == Stacked::LeftOut && isOnOther(f))) continue;
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      out.corners.push_back(c);
    out.offsets.push_back(static_cast<std::uint32_t>(out.corners.size()));
    out.face.push_back(f);
  }
  return out;
}

AtlasEdges atlasEdges(const AtlasPolygons& polygons, const std::vector<std::uint32_t>& cornerUv) {
  struct HalfEdge {
    std::array<std::uint32_t, 2> key;  ///< texcoords, the smaller one first
    std::array<std::uint32_t, 2> ends;
    bool operator<(const HalfEdge& o) const { return key < o.key; }
  };
  std::vector<HalfEdge> all;
  all.reserve(polygons.corners.size());
  for (std::uint32_t i = 0; i < polygons.count(); ++i) {
    const std::uint32_t begin = polygons.offsets[i], end = polygons.offsets[i + 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t a = cornerUv[polygons.corners[c]];
      const std::uint32_t b = cornerUv[polygons.corners[c + 1 < end ? c + 1 : begin]];
      if (a != b) all.push_back({{std::min(a, b), std::max(a, b)}, {a, b}});
    }
  }
  std::stable_sort(all.begin(), all.end());
  AtlasEdges out;
  for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
    while (next < all.size() && all[next].key == all[i].key) ++next;
    (next - i == 1 ? out.outline : out.inner).push_back(all[i].ends);
  }
  return out;
}

}  // namespace abflat
