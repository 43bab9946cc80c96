#include "unwrap/alike_parts.h"

#include <algorithm>
#include <utility>

#include "base/double_bits.h"

namespace abflat {
namespace {

using PartFlags = IdVector<PartId, std::uint8_t>;

/// What tells faces of the same shape from each other: they share texels.
std::uint64_t markOf(const SurfaceMap& map, InputFace f, const UnwrapOptions& options) {
  const auto& materials = map.input().extras().faceMaterials;
  const double density = options.faceDensities.empty() ? 1 : options.faceDensities[f];
  return bitsOf(density) * 31 + (materials.empty() ? 0 : materials[f]);
}

Cells markedCells(const SurfaceMap& map, const IdVector<SurfaceTriangle, PartId>& part,
                  const IdVector<SurfaceCorner, SurfaceCorner>& twin, std::size_t parts,
                  const UnwrapOptions& options) {
  Cells out = cellsOf(map.welded().mesh, map.surface().triangulation, part, twin, parts);
  for (const PolygonFace f : out.part.ids())
    out.faceMark[f] = markOf(map, map.welded().inputFace[f], options);
  return out;
}

/// Parts with faces that do not fit, or that have lost corners: a later run has to find the
/// triangles of this one.
PartFlags oddParts(const SurfaceMap& map, const Cells& cells, const UnfitFaces& unfit) {
  PartFlags out(cells.parts, 0);
  IdVector<InputFace, std::uint8_t> isUnfit(map.input().faceCount(), 0);
  for (const std::uint32_t f : unfit) isUnfit[InputFace(f)] = 1;
  for (const PolygonFace f : cells.part.ids()) {
    const InputFace face = map.welded().inputFace[f];
    const bool isWhole =
        cells.size(f) == map.input().firstCorner(face + 1) - map.input().firstCorner(face);
    if (cells.part[f].exists() && (isUnfit[face] || !isWhole)) out[cells.part[f]] = 1;
  }
  return out;
}

bool isAnyMatched(const CornerMatch& match) {
  for (const PolygonCorner c : match.ids())
    if (match[c].exists() && match[c] != c) return true;
  return false;
}

CornerMatch matchOf(const Cells& cells, const PartFlags& isLeftOut, const UnwrapOptions& options) {
  CornerMatch out = findAlike(cells, isLeftOut, options.stack == Stack::Mirrored);
  return isAnyMatched(out) ? std::move(out) : CornerMatch();
}

}  // namespace

CornerMatch alikeComponents(const SurfaceMap& map, const Seams& given, const FixedTriangles& fixed,
                            const UnwrapOptions& options, const UnfitFaces& unfit) {
  const CornerTable& table = map.surface().table;
  const Components components = findComponents(table);
  IdVector<SurfaceTriangle, PartId> part;
  for (const ComponentId i : components.ofTriangle) part.push_back(PartId(std::uint32_t{i}));
  const std::size_t parts = components.firstTriangle.size();
  Cells cells = markedCells(map, part, table.twin, parts, options);
  PartFlags isLeftOut = oddParts(map, cells, unfit);
  for (const SurfaceCorner h : given.ids())
    if (given[h]) cells.edgeMark[map.surface().triangulation.corner[h]] = 1;
  for (const SurfaceTriangle f : fixed.isFixed.ids())
    if (fixed.isFixed[f]) isLeftOut[part[f]] = 1;
  IdVector<InputVertex, std::uint8_t> isPinned(map.input().vertexCount(), 0);
  for (const Pin& pin : options.pins)
    if (pin.vertex < isPinned.size()) isPinned[InputVertex(pin.vertex)] = 1;
  for (const SurfaceCorner c : table.corners())
    if (isPinned[map.vertex(c)]) isLeftOut[part[triangleOf(c)]] = 1;
  return matchOf(cells, isLeftOut, options);
}

CornerMatch alikeCharts(const CutMesh& mesh, const IdVector<ChartId, ChartConstraints>& constraints,
                        const FlatCharts& flat, const UnwrapOptions& options,
                        const UnfitFaces& unfit) {
  const SurfaceMap& map = mesh.map;
  IdVector<SurfaceTriangle, PartId> part;
  for (const ChartId i : mesh.set.ofTriangle) part.push_back(PartId(std::uint32_t{i}));
  IdVector<SurfaceCorner, SurfaceCorner> twin(3 * part.size());
  IdVector<SurfaceCorner, std::uint8_t> straight(twin.size(), 0);
  for (const ChartId i : mesh.set.ids()) {
    const ChartTopology chart = mesh.set.topology(i);
    for (const ChartCorner c : chart.surfaceCorners())
      if (const ChartCorner o = chart.twin[c]; o.exists() && o < chart.surfaceCorners().size())
        twin[chart.onSurface(c)] = chart.onSurface(o);
    const StraightPlaces& places = constraints[i].straight;
    for (const BoundaryIndex k : places.ids())
      straight[chart.onSurface(chart.boundary[k])] =
          places[k] + places[BoundaryIndex((k + 1) % places.size())];
  }
  Cells cells = markedCells(map, part, twin, mesh.set.size(), options);
  PartFlags isLeftOut = oddParts(map, cells, unfit);
  for (const SurfaceCorner h : straight.ids())
    if (straight[h]) cells.edgeMark[map.surface().triangulation.corner[h]] = straight[h];
  for (const ChartId i : flat.ids())
    if (flat[i].isFixed || !flat[i].problem.empty()) isLeftOut[PartId(std::uint32_t{i})] = 1;
  return matchOf(cells, isLeftOut, options);
}

IdVector<SurfaceTriangle, std::uint8_t> areModels(const Surface& surface,
                                                  const CornerMatch& model) {
  IdVector<SurfaceTriangle, std::uint8_t> out;
  for (const SurfaceTriangle f : surface.table.triangles()) {
    const PolygonCorner c = surface.triangulation.corner[cornerOf(f, 0)];
    out.push_back(model[c] == c);
  }
  return out;
}

}  // namespace abflat
