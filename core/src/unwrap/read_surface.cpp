#include "unwrap/read_surface.h"

#include <string>
#include <utility>

#include "mesh/notches.h"
#include "unwrap/output.h"
#include "unwrap/turned.h"
#include "unwrap/unseen.h"

namespace abflat {
namespace {

/// Nothing is built once the listener has stopped.
void weldAndBuild(const PolygonMesh& mesh, bool byPosition, const VertexPairs& joined,
                  const UnwrapOptions& options, double unit, const Listener& listener,
                  WeldedSurface& out) {
  if (listener.isStopped()) return;
  out.welded = weld(mesh, byPosition, listener, joined);
  if (listener.isStopped()) return;
  out.surface = buildSurface(out.welded.mesh, listener, [&](const CornerTable& table) {
    return fineLength(out.welded, table, options, unit);
  });
}

}  // namespace

Result<WeldedSurface> readSurface(const InputMesh& input, const UnwrapOptions& options, double unit,
                                  const Listener& listener, UnwrapReport& report) {
  WeldedSurface out;
  PolygonMesh inUnits = input.copy();
  for (double& x : inUnits.positions) x /= unit;
  report.input = inspect(inUnits, listener);
  // A disk may be one because it has been cut, so it is not welded, except at poles that are open
  // because each face has its own vertex there.
  const bool isDisk = report.input.disk.ok();
  weldAndBuild(inUnits, !isDisk, {}, options, unit, listener, out);
  if (isDisk && !listener.isStopped())
    if (const VertexPairs notches = findNotches(out.welded.mesh, out.surface); !notches.empty())
      weldAndBuild(inUnits, false, notches, options, unit, listener, out);
  if (listener.isStopped()) return out;
  if (out.surface.table.vertex.empty())
    return Status{StatusCode::EmptyMesh, "every face has fewer than three distinct corners"};
  report.repair = repairReport({input, out.welded, out.surface});
  if (std::string note = orientationNote(report.repair, options.orient); !note.empty())
    report.notes.push_back(std::move(note));
  out.surface.boundaryLoops = std::vector<SurfaceLoop>();
  return out;
}

}  // namespace abflat
