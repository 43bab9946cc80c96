#include "unwrap/find_within.h"

#include <utility>

namespace abflat {

bool findWithin(const SeamPart& part, SeamOptions options, OpenSurface& open, SeamReport& found) {
  const bool hasRanks = !open.eliminationRanks.empty();
  if (hasRanks) options.eliminationRanks = part.ofVertices(open.eliminationRanks);
  options.mirror = open.mirror.ofPart(part);
  open.seams.resize(open.mesh.twin.size(), 0);
  open.found.resize(open.mesh.twin.size(), 0);
  Seams given;
  for (const SurfaceCorner h : part.wholeHalfEdge) {
    given.push_back(open.seams[h] && open.isGiven(h));
    options.first.push_back(open.found[h]);
  }
  const Seams seams = findSeams(part.mesh, std::move(given), options, &found);
  bool isAny = false;
  for (const SurfaceCorner i : seams.ids()) {
    const SurfaceCorner h = part.wholeHalfEdge[i];
    if (!part.mesh.twin[i].exists()) continue;
    isAny = isAny || open.seams[h] != seams[i];
    open.seams[h] = seams[i];
    open.found[h] = found.found[i];
  }
  open.eliminationRanks.resize(open.mesh.vertexCount(), 0);
  open.scale.resize(open.mesh.vertexCount(), 0);
  open.foundScale.resize(open.mesh.vertexCount(), 0);
  for (const SurfaceVertex i : found.eliminationRanks.ids()) {
    const SurfaceVertex v = part.wholeVertex[i];
    // A chart must be solved in the same order whenever it is found.
    if (!hasRanks) open.eliminationRanks[v] = found.eliminationRanks[i];
    open.scale[v] = found.scale[i];
    open.foundScale[v] = found.foundScale[i];
  }
  return isAny;
}

}  // namespace abflat
