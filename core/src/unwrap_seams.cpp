#include "unwrap_seams.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hole/fill_holes.h"
#include "seam/find_seams.h"

namespace abflat {
namespace {

/// What seams are sought on.
struct Opened {
  SeamMesh mesh;
  Fans fans;
  Seams given;  ///< those that are not its boundary
};

/// The surface opened along what is given, so that the holes of its charts show, and with these
/// filled; where there are none the surface as it is, which has the same elimination order whatever
/// is given.
Opened openAndFill(const WeldedMesh& welded, const Surface& surface, const Seams& given,
                   FillHoles mode) {
  CornerTable table = surface.table;
  for (std::size_t h = 0; h < given.size(); ++h)
    if (given[h]) table.twin[h] = kNone;
  const auto meshOf = [&](const CornerTable& t, const Fans& fans) {
    return makeSeamMesh(welded.mesh.positions, t, fans, surface.triangulation.isDiagonal);
  };
  const bool isAny = std::find(given.begin(), given.end(), 1) != given.end();
  Opened out;
  out.fans = isAny ? findFans(table, welded.mesh.vertexCount()) : surface.fans;
  out.mesh = meshOf(table, out.fans);
  fillHoles(mode, out.mesh);
  if (isAny && out.mesh.hole.empty())
    out = {meshOf(surface.table, surface.fans), surface.fans, given};
  return out;
}

}  // namespace

CutOpen cutOpen(const WeldedMesh& welded, const Surface& surface, const Seams& given,
                const UnwrapOptions& options, ThreadPool& pool, std::function<bool()> keepsOn,
                SeamSummary& summary) {
  Opened opened = openAndFill(welded, surface, given, options.fillHoles);
  const SeamMesh& mesh = opened.mesh;
  SeamOptions wanted;
  wanted.isAuto = options.seams.isAuto;
  wanted.maxStretch = options.maxStretch;
  wanted.fillHoles = options.fillHoles;
  wanted.pool = &pool;
  wanted.keepsOn = std::move(keepsOn);
  SeamReport found;
  CutOpen out;
  out.seams = findSeams(mesh, std::move(opened.given), wanted, &found);
  for (std::size_t i = 0; i < found.place.size(); ++i) {
    const std::uint32_t v = opened.fans.inputVertex[i];
    if (v >= out.place.size()) out.place.resize(v + 1);
    out.place[v] = found.place[i];
  }
  out.disks = filledTable(mesh, opened.fans.inputVertex, out.seams);
  out.seams.resize(given.size());
  double length = 0;
  for (std::uint32_t h = 0; h < out.seams.size(); ++h) {
    out.seams[h] = given[h] || (out.seams[h] && mesh.isOnSurface(h));
    if (!out.seams[h]) continue;
    length += mesh.length[h] / 2;
    ++summary.edges;
  }
  summary.edges /= 2;
  const double size = std::sqrt(mesh.totalArea());
  summary.relativeLength = size > 0 ? length / size : 0;
  summary.genus = surface.summary.genus;
  summary.handleLoops = found.handleLoops;
  return out;
}

}  // namespace abflat
