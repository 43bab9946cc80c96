#include "unwrap/open_and_fill.h"

#include <algorithm>
#include <utility>

#include "cut/front.h"
#include "hole/fill_holes.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// The given seams, without those inside fixed islands, plus the borders of these islands.
Seams withBorders(const Seams& given, const FixedTriangles& fixed) {
  if (fixed.isFixed.empty()) return given;
  Seams out = fixed.borders;
  for (const SurfaceCorner h : out.ids())
    if (given[h] && !fixed.isFixed[triangleOf(h)]) out[h] = 1;
  return out;
}

/// The unit of the seam finder's mesh, in that of the welded one; derived from the longest edge.
double unitOf(const WeldedMesh& welded, const OpenSurface& open) {
  const auto longest = std::max_element(open.mesh.length.begin(), open.mesh.length.end());
  if (longest == open.mesh.length.end() || !(*longest > 0)) return 1;
  const SurfaceCorner h(longest - open.mesh.length.begin());
  const InputVertex tail = open.inputVertex[open.mesh.tail(h)];
  const InputVertex head = open.inputVertex[open.mesh.head(h)];
  return norm(edgeVector(welded.mesh.positions, tail, head)) / *longest;
}

}  // namespace

OpenSurface openAndFill(const UncutSurface& uncut, const AskedCuts& asked,
                        const UnwrapOptions& options, const Listener& listener) {
  const Surface& surface = uncut.surface;
  const PolygonMesh& mesh = uncut.welded.mesh;
  Seams given = withBorders(asked.seams, uncut.fixed);
  CornerTable table = surface.table;
  for (const SurfaceCorner h : given.ids())
    if (given[h]) table.twin[h] = SurfaceCorner();
  const auto meshOf = [&](const CornerTable& t, const Fans& fans) {
    SeamMesh out = makeSeamMesh(mesh.positions, t, fans, surface.triangulation.isDiagonal,
                                asked.scales.ofTriangle, asked.breaks, options.seamCosts,
                                asked.upAxis, listener);
    if (options.frontLeeway > 1) out.front = trianglesInFront(out);
    out.frontLeeway = options.frontLeeway;
    return out;
  };
  const bool isAny = std::find(given.begin(), given.end(), 1) != given.end();
  Fans fans = isAny ? findFans(table, mesh.vertexCount()) : surface.fans;
  OpenSurface out;
  out.mesh = meshOf(table, fans);
  fillHoles(options.fillHoles, uncut.fixed.isFixed, out.mesh, listener);
  if (isAny && out.mesh.hole.empty() && uncut.fixed.isFixed.empty() &&
      asked.scales.ofTriangle.empty()) {
    fans = surface.fans;
    out.mesh = meshOf(surface.table, fans);
    out.seams = given;
  }
  out.inputVertex = std::move(fans.inputVertex);
  out.given = std::move(given);
  out.unit = uncut.unit * unitOf(uncut.welded, out);
  return out;
}

}  // namespace abflat
