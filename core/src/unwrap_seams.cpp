#include "unwrap_seams.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hole/fill_holes.h"
#include "seam/extract_charts.h"
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
                   const FixedTriangles& fixed, FillHoles mode) {
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
  fillHoles(mode, fixed.isFixed, out.mesh);
  if (isAny && out.mesh.hole.empty() && fixed.isFixed.empty())
    out = {meshOf(surface.table, surface.fans), surface.fans, given};
  return out;
}

/// Fixed islands are left out: they are not to be cut, and may have holes. Their borders are open.
Seams findAround(const SeamMesh& mesh, const std::vector<std::uint8_t>& isFixed, Seams given,
                 const SeamOptions& wanted, SeamReport& found) {
  if (isFixed.empty()) return findSeams(mesh, std::move(given), wanted, &found);
  const CutSurface islands = cutAlong(mesh, Seams(mesh.twin.size(), 0));
  std::vector<std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : islands.charts)
    isWanted.push_back(!isFixed[chart.firstTriangle]);
  const SeamPart rest = extractCharts(mesh, islands, isWanted);
  const Seams ofRest = findSeams(rest.mesh, {}, wanted, &found);
  Seams seams(mesh.twin.size(), 0);
  for (std::size_t h = 0; h < ofRest.size(); ++h)
    if (ofRest[h]) seams[rest.halfEdge[h]] = 1;
  std::vector<std::uint32_t> place(mesh.vertexCount(), 0);
  for (std::size_t v = 0; v < found.place.size(); ++v) place[rest.vertex[v]] = found.place[v];
  found.place = std::move(place);
  return seams;
}

/// What is given, without what lies within fixed islands, and the borders of these.
Seams withBorders(const Seams& given, const FixedTriangles& fixed) {
  if (fixed.isFixed.empty()) return given;
  Seams out = fixed.borders;
  for (std::size_t h = 0; h < out.size(); ++h)
    if (given[h] && !fixed.isFixed[h / 3]) out[h] = 1;
  return out;
}

}  // namespace

CutOpen cutOpen(const WeldedMesh& welded, const Surface& surface, const Seams& asked,
                const FixedTriangles& fixed, const UnwrapOptions& options, ThreadPool& pool,
                std::function<bool()> keepsOn, SeamSummary& summary) {
  const Seams given = withBorders(asked, fixed);
  Opened opened = openAndFill(welded, surface, given, fixed, options.fillHoles);
  const SeamMesh& mesh = opened.mesh;
  SeamOptions wanted;
  wanted.isAuto = options.seams.isAuto;
  wanted.maxStretch = options.maxStretch;
  wanted.fillHoles = options.fillHoles;
  wanted.pool = &pool;
  wanted.keepsOn = std::move(keepsOn);
  SeamReport found;
  CutOpen out;
  out.seams = findAround(mesh, fixed.isFixed, std::move(opened.given), wanted, found);
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
  summary.handleLength = found.handleLength;
  return out;
}

}  // namespace abflat
