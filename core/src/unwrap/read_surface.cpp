#include "unwrap/read_surface.h"

#include <string>
#include <utility>

#include "mesh/notches.h"
#include "seam/given_seams.h"
#include "seam/hard_edges.h"
#include "seam/scale_seams.h"
#include "unwrap/output.h"
#include "unwrap/turned.h"
#include "unwrap/unseen.h"

namespace abflat {
namespace {

/// Nothing is built once the pulse has stopped.
void weldAndBuild(const PolygonMesh& mesh, bool byPosition, const VertexPairs& joined,
                  const UnwrapOptions& options, double unit, const Pulse& pulse,
                  WeldedSurface& out) {
  if (pulse.isStopped()) return;
  out.welded = weld(mesh, byPosition, pulse, joined);
  if (pulse.isStopped()) return;
  out.surface = buildSurface(out.welded.mesh, pulse, [&](const CornerTable& table) {
    return fineLength(out.welded, table, options, unit);
  });
}

}  // namespace

Result<WeldedSurface> readSurface(const PolygonMesh& input, const UnwrapOptions& options,
                                  double unit, const Pulse& pulse, UnwrapReport& report) {
  WeldedSurface out;
  PolygonMesh inUnits = input;
  for (double& x : inUnits.positions) x /= unit;
  report.input = inspect(inUnits, pulse);
  // A disk may be one because it has been cut, so it is not welded, except at poles that are open
  // because each face has its own vertex there.
  const bool isDisk = report.input.disk.ok();
  weldAndBuild(inUnits, !isDisk, {}, options, unit, pulse, out);
  if (isDisk && !pulse.isStopped())
    if (const VertexPairs notches = findNotches(out.welded.mesh, out.surface); !notches.empty())
      weldAndBuild(inUnits, false, notches, options, unit, pulse, out);
  if (pulse.isStopped()) return out;
  if (out.surface.table.vertex.empty())
    return Status{StatusCode::EmptyMesh, "every face has fewer than three distinct corners"};
  report.repair = repairReport({input, out.welded, out.surface});
  if (std::string note = orientationNote(report.repair, options.orient); !note.empty())
    report.notes.push_back(std::move(note));
  out.surface.boundaryLoops = std::vector<SurfaceLoop>();
  return out;
}

Result<AskedParts> askedParts(const SurfaceMap& map, const UnwrapOptions& options, double unit,
                              std::size_t upAxis, std::vector<std::string>& notes) {
  AskedParts out;
  out.cuts.upAxis = upAxis;
  out.cuts.breaks = hardEdges(map);
  Result<Seams> given = givenSeams(map, options.seams, out.cuts.breaks);
  if (!given.ok()) return given.status;
  addMaterialBorders(map, out.cuts.breaks);
  out.cuts.seams = std::move(given.value);
  if (options.seams.isAuto)
    out.cuts.scales = addScaleSeams(map.welded().mesh, map.surface(), out.cuts.seams);
  if (out.cuts.scales.sharpest) notes.push_back(scaleNote(*out.cuts.scales.sharpest, map, unit));
  Result<FixedTriangles> fixed = fixedTriangles(map, options);
  if (!fixed.ok()) return fixed.status;
  out.fixed = std::move(fixed.value);
  if (!out.fixed.note.empty()) notes.push_back(out.fixed.note);
  return out;
}

}  // namespace abflat
