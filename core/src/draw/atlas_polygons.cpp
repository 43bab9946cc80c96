#include "draw/atlas_polygons.h"

#include <algorithm>

namespace abflat {
namespace {

class Collector {
 public:
  explicit Collector(const PolygonMesh& mesh) : mesh_(mesh) {}

  void addWhole(std::uint32_t f) {
    for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c)
      out_.corners.push_back(c);
    close(f);
  }

  /// A corner at the place of an earlier one closes a loop, which is split off.
  void addSplit(std::uint32_t f) {
    std::vector<std::uint32_t> path;
    for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c) {
      const auto same = std::find_if(path.begin(), path.end(),
                                     [&](std::uint32_t other) { return isSamePlace(other, c); });
      if (same != path.end()) take(f, path, same);
      path.push_back(c);
    }
    take(f, path, path.begin());
  }

  AtlasPolygons run() { return std::move(out_); }

 private:
  using Path = std::vector<std::uint32_t>;

  bool isSamePlace(std::uint32_t cornerA, std::uint32_t cornerB) const {
    const double* a = &mesh_.positions[3 * static_cast<std::size_t>(mesh_.faceVertices[cornerA])];
    const double* b = &mesh_.positions[3 * static_cast<std::size_t>(mesh_.faceVertices[cornerB])];
    return std::equal(a, a + 3, b);
  }

  void take(std::uint32_t f, Path& path, Path::iterator from) {
    if (path.end() - from >= 3) {
      out_.corners.insert(out_.corners.end(), from, path.end());
      close(f);
    }
    path.erase(from, path.end());
  }

  void close(std::uint32_t f) {
    out_.offsets.push_back(static_cast<std::uint32_t>(out_.corners.size()));
    out_.face.push_back(f);
  }

  const PolygonMesh& mesh_;
  AtlasPolygons out_;
};

}  // namespace

AtlasPolygons atlasPolygons(const PolygonMesh& mesh, const UnwrapResult& result) {
  enum Kind : std::uint8_t { Whole, Split, Collapsed };
  std::vector<Kind> kinds(mesh.faceCount(), Whole);
  for (const std::uint32_t f : result.report.repair.splitFaces) kinds[f] = Split;
  for (const std::uint32_t f : result.report.repair.collapsedFaces) kinds[f] = Collapsed;
  Collector collector(mesh);
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    if (kinds[f] == Whole) collector.addWhole(f);
    if (kinds[f] == Split) collector.addSplit(f);
  }
  return collector.run();
}

AtlasEdges atlasEdges(const AtlasPolygons& polygons, const UnwrapResult& result) {
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
      const std::uint32_t a = result.cornerUv[polygons.corners[c]];
      const std::uint32_t b = result.cornerUv[polygons.corners[c + 1 < end ? c + 1 : begin]];
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
