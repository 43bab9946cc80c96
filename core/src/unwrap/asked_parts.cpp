#include "unwrap/asked_parts.h"

#include <utility>

#include "seam/given_seams.h"
#include "seam/hard_edges.h"
#include "seam/scale_seams.h"
#include "unwrap/seam_notes.h"

namespace abflat {

Result<AskedParts> askedParts(const SurfaceMap& map, const UnwrapOptions& options, double unit,
                              std::size_t upAxis, std::vector<std::string>& notes) {
  AskedParts out;
  out.cuts.upAxis = upAxis;
  out.cuts.breaks = hardEdges(map);
  Result<Seams> given = givenSeams(map, options.seams, out.cuts.breaks);
  if (!given.ok()) return given.status();
  addMaterialBorders(map, out.cuts.breaks);
  out.cuts.seams = std::move(given.value());
  if (options.seams.isAuto)
    out.cuts.scales = addScaleSeams(map.welded().mesh, map.surface(), out.cuts.seams);
  if (out.cuts.scales.sharpest) notes.push_back(scaleNote(*out.cuts.scales.sharpest, map, unit));
  Result<FixedTriangles> fixed = fixedTriangles(map, options);
  if (!fixed.ok()) return fixed.status();
  out.fixed = std::move(fixed.value());
  if (!out.fixed.note.empty()) notes.push_back(out.fixed.note);
  return out;
}

}  // namespace abflat
