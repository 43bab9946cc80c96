#include "abflat/verify.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "abflat/inspect.h"
#include "abflat/pack_layout.h"
#include "base/guarded.h"
#include "base/listener.h"
#include "base/stopwatch.h"
#include "islands/check_places.h"
#include "islands/find_islands.h"
#include "islands/judge_faces.h"
#include "mesh/triangulate.h"
#include "verify/findings.h"
#include "verify/outline_edges.h"

namespace abflat {
namespace {

/// UDIM 1001 to 9999.
constexpr std::uint32_t kAllTiles = 8999;

/// A tile by its column and row.
struct TileAt {
  double column = 0, row = 0;

  /// In texels, negative outside of the tile.
  double toEdge(const UvBox& box, const AtlasSize& size) const {
    return std::min({(box.low[0] - column) * size.width, (column + 1 - box.high[0]) * size.width,
                     (box.low[1] - row) * size.height, (row + 1 - box.high[1]) * size.height});
  }
  bool isOneOf(std::uint32_t tiles) const {
    return isInTile({{column, row}, {column, row}}, tiles);
  }
  bool contains(const UvBox& box) const {
    return box.low[0] >= column && box.high[0] <= column + 1 && box.low[1] >= row &&
           box.high[1] <= row + 1;
  }
};

/// The one that the middle of a box is in.
TileAt tileOf(const UvBox& box, bool isUdim) {
  if (!isUdim) return {};
  return {std::floor(box.low[0] / 2 + box.high[0] / 2),
          std::floor(box.low[1] / 2 + box.high[1] / 2)};
}

/// What is known of where islands lie.
struct IslandPlaces {
  std::vector<TileAt> tile;
  std::vector<std::uint8_t> isOutside;
  std::vector<double> toEdge;  ///< in texels
};

IslandPlaces placesOf(const IslandTriangles& islands, const VerifyOptions& options) {
  IslandPlaces out;
  for (std::uint32_t i = 0; i < islands.islands(); ++i) {
    const UvBox box = islands.box(i);
    const TileAt tile = tileOf(box, options.udim);
    const bool exists = tile.isOneOf(options.udim ? kAllTiles : 1);
    out.tile.push_back(tile);
    out.isOutside.push_back(!exists || !tile.contains(box));
    out.toEdge.push_back(tile.toEdge(box, options.resolution));
  }
  return out;
}

std::vector<std::uint32_t> islandsOfTriangles(const MappedTriangles& triangles) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < triangles.inUv.islands(); ++i)
    out.resize(triangles.inUv.begin[i + 1], i);
  return out;
}

std::vector<std::uint8_t> faultsOf(const MappedTriangles& triangles,
                                   const std::vector<std::uint32_t>& island,
                                   const FoundOverlaps& overlaps, const IslandPlaces& places) {
  std::vector<std::uint8_t> out(triangles.face.size());
  for (std::size_t t = 0; t < out.size(); ++t) {
    const double* uv = &triangles.inUv.uv[6 * t];
    UvBox box;
    for (std::size_t k = 0; k < 3; ++k) box.add(uv + 2 * k);
    const bool isOutside = places.isOutside[island[t]] &&
                           (!places.tile[island[t]].contains(box) || places.toEdge[island[t]] >= 0);
    out[t] = faultsAt(uv, overlaps.overlapping[t] != 0, isOutside);
  }
  return out;
}

void countOverlaps(const FoundOverlaps& overlaps, VerifyReport& report) {
  for (const IslandOverlap& pair : overlaps.pairs) {
    if (pair.isOwn())
      ++report.overlappingThemselves;
    else
      ++(pair.isStacked ? report.overlappingStacked : report.overlappingPairs);
  }
}

void listTiles(const IslandPlaces& places, VerifyReport& report) {
  std::set<std::uint32_t> numbers;
  for (const TileAt& tile : places.tile)
    if (tile.isOneOf(kAllTiles))
      numbers.insert(1001 + static_cast<std::uint32_t>(10 * tile.row + tile.column));
  report.tiles = {numbers.begin(), numbers.end()};
}

/// Tiles are textures of their own: their outlines are moved apart.
void partTiles(const IslandPlaces& places, const AtlasSize& size, OutlineEdges& outlines) {
  for (std::size_t e = 0; e < outlines.chart.size(); ++e) {
    const TileAt& tile = places.tile[outlines.chart[e]];
    for (std::size_t k = 0; k < 4; k += 2) {
      outlines.ends[4 * e + k] += tile.column * size.width;
      outlines.ends[4 * e + k + 1] += tile.row * size.height;
    }
  }
}

void measureTotals(const LayoutMeasures& measures, const FoundOverlaps& overlaps,
                   const IslandPlaces& places, const VerifyOptions& options, VerifyReport& report) {
  double covered = 0, least = kNotMeasured, most = kNotMeasured;
  for (std::size_t i = 0; i < measures.islands.size(); ++i) {
    const IslandMeasures& own = measures.islands[i];
    report.mirrored += own.isMirrored();
    if (!overlaps.isOnAnother[i]) covered += own.area;
    if (!(report.narrowest <= own.width)) report.narrowest = own.width;
    if (!(report.distanceEdge <= places.toEdge[i])) report.distanceEdge = places.toEdge[i];
    if (!(report.worstStretch >= own.stretch) && !std::isnan(own.stretch))
      report.worstStretch = own.stretch;
    if (std::isnan(own.density)) continue;
    if (!(least <= own.density)) least = own.density;
    if (!(most >= own.density)) most = own.density;
  }
  const auto tiles = static_cast<double>(std::max<std::size_t>(report.tiles.size(), 1));
  const double texels = static_cast<double>(options.resolution.width) * options.resolution.height;
  report.utilization = covered / (texels * tiles);
  report.texelDensityMean = measures.density;
  report.texelDensityMin = measures.leastDensity.value;
  report.texelDensityMax = measures.mostDensity.value;
  report.texelDensityRatio = most / least;
  report.symmetricDirichlet = measures.stretch;
  report.quasiConformalMean = measures.conformalMean;
  report.quasiConformalMax = measures.conformalMost;
}

/// In the order of the triangles of the mesh; those without texcoords have none.
std::vector<std::uint8_t> inOrderOfMesh(const MappedTriangles& triangles, std::size_t count,
                                        const std::vector<std::uint8_t>& faults) {
  std::vector<std::uint8_t> out(count);
  for (std::size_t t = 0; t < faults.size(); ++t) out[triangles.ofMesh[t]] = faults[t];
  return out;
}

Result<VerifyResult> verifyIslands(const PolygonMesh& mesh, const VerifyOptions& options) {
  const Listener listener = Listener(options.progress).at(Stage::Check);
  const auto cancelled = [] { return Status{StatusCode::Aborted, "cancelled"}; };
  Stopwatch watch;
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (mesh.faceCount() == 0) return Status{StatusCode::EmptyMesh, "the mesh has no faces"};
  const Status none{StatusCode::NoTexcoords,
                    "no face has texcoords, so there is no layout to verify"};
  if (mesh.faceTexcoords.empty()) return none;
  VerifyResult out;
  VerifyReport& report = out.report;
  report.options = options;
  report.input = inspect(mesh);
  if (!listener.tell(0.1)) return cancelled();
  Islands islands = findIslands(mesh);
  if (islands.count == 0) return none;
  const Triangulation all = triangulate(mesh);
  const MappedTriangles triangles = mappedTriangles(mesh, islands, all);
  const std::vector<std::uint32_t> island = islandsOfTriangles(triangles);
  if (!listener.tell(0.25)) return cancelled();
  const LayoutMeasures measures = measureIslands(mesh, triangles, options.resolution);
  const IslandPlaces places = placesOf(triangles.inUv, options);
  if (!listener.tell(0.4)) return cancelled();
  const FoundOverlaps overlaps = findOverlaps(triangles, island, measures, options.resolution);
  if (!listener.tell(0.7)) return cancelled();
  OutlineEdges outlines = outlineEdges(triangles.inUv, options.resolution, overlaps.isOnAnother);
  partTiles(places, options.resolution, outlines);
  if (const auto gap = leastGap(outlines)) report.distanceIslands = gap->distance;
  if (!listener.tell(0.9)) return cancelled();
  const std::vector<std::uint8_t> faults = faultsOf(triangles, island, overlaps, places);
  std::vector<std::uint32_t> unmapped;
  for (std::uint32_t f = 0; f < islands.ofFace.size(); ++f)
    if (islands.ofFace[f] == kNoIsland) unmapped.push_back(f);
  report.islands = islands.count;
  report.unmapped = unmapped.size();
  countFaults(triangles.face, faults, report);
  countOverlaps(overlaps, report);
  listTiles(places, report);
  measureTotals(measures, overlaps, places, options, report);
  report.findings = findingsOf({triangles, island, measures, overlaps, faults, places.isOutside,
                                places.toEdge, outlines, unmapped},
                               options, report);
  report.valid = report.findings.empty();
  report.timings.check = watch.lap();
  out.islandOfFace = std::move(islands.ofFace);
  out.triangleCorners.assign(all.corner.begin(), all.corner.end());
  out.faults = inOrderOfMesh(triangles, all.face.size(), faults);
  return out;
}

}  // namespace

Result<VerifyResult> verifyLayout(const PolygonMesh& mesh, const VerifyOptions& options) {
  return guarded([&] { return verifyIslands(mesh, options); });
}

}  // namespace abflat
