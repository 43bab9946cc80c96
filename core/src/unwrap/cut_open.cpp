#include "unwrap/cut_open.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seam/plates.h"
#include "seam/seam_value.h"
#include "seam/vary_costs.h"
#include "unwrap/find_within.h"
#include "unwrap/seam_options.h"

namespace abflat {
namespace {

bool isAlone(const SeamMesh& mesh, SurfaceTriangle f) {
  for (const SurfaceCorner h : cornersOf(f))
    if (mesh.twin[h].exists()) return false;
  return true;
}

bool areMostAlone(const SeamMesh& mesh) {
  std::uint32_t alone = 0;
  for (const SurfaceTriangle f : mesh.triangles()) alone += isAlone(mesh, f);
  return alone > mesh.triangleCount() / 2;
}

/// Leaves out fixed islands, which must not be cut and may have holes; their borders are open. Also
/// leaves out isolated triangles if there are many, since they need no search.
void findAround(const IdVector<SurfaceTriangle, std::uint8_t>& isFixed, const SeamOptions& options,
                OpenSurface& open, SeamReport& found) {
  if (isFixed.empty() && !areMostAlone(open.mesh)) {
    open.seams = findSeams(open.mesh, std::move(open.seams), options, &found);
    open.eliminationRanks = std::move(found.eliminationRanks);
    open.scale = std::move(found.scale);
    open.found = std::move(found.found);
    open.foundScale = std::move(found.foundScale);
    open.mirror = std::move(found.mirror);
    open.otherwise = std::move(found.otherwise);
    return;
  }
  const CutSurface islands = cutAlong(open.mesh, Seams(open.mesh.twin.size(), 0));
  IdVector<CutChartId, std::uint8_t> isWanted;
  for (const CutSurface::Chart& chart : islands.charts)
    isWanted.push_back(chart.triangles > 1 && (isFixed.empty() || !isFixed[chart.firstTriangle]));
  findWithin(extractCharts(open.mesh, islands, isWanted), options, open, found);
}

/// The ranks of a surface for the same mesh opened in another way, since a chart must be solved in
/// the same order whenever it is found.
EliminationRanks ranksOf(const OpenSurface& open, std::size_t vertices, const OpenSurface& other) {
  const IdVector<InputVertex, std::uint32_t> ranks = ranksOfMesh(open, vertices);
  EliminationRanks out;
  for (const InputVertex v : other.inputVertex) out.push_back(ranks[v]);
  return out;
}

/// How far beyond 1 a search may go. `asked`: by the options.
double beyondOne(SeamBound bound, double asked, const UnwrapOptions& options) {
  // How much stretch refining leaves is only known to about a third, and cutting again takes
  // another run.
  constexpr double kShare = 0.85, kTighter = 0.5, kExact = 2e-4;
  const double first = options.balance > 0 ? kShare * asked : asked;
  if (bound == SeamBound::Exact) return std::min(first, kExact);
  return bound == SeamBound::Tighter ? kTighter * first : first;
}

OpenSurface openWith(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                     const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                     SeamReport& found) {
  OpenSurface open = openAndFill(uncut, asked, options, listener);
  SeamOptions toBegin = seamOptions(options, open, pool, listener, variant.costs);
  toBegin.maxStretch = 1 + beyondOne(variant.bound, toBegin.maxStretch - 1, options);
  toBegin.isAuto = toBegin.isAuto && !variant.isUncut;
  if (variant.before)
    toBegin.eliminationRanks = ranksOf(*variant.before, uncut.welded.mesh.vertexCount(), open);
  // Symmetric seams that were not preferable hardly ever become so.
  const bool isAsymmetric = variant.before && !variant.before->mirror;
  if (isAsymmetric && options.symmetricSeams == SymmetricSeams::Auto)
    toBegin.symmetricSeams = SymmetricSeams::Never;
  const EliminationRanks ranks = toBegin.eliminationRanks;
  findAround(uncut.fixed.isFixed, toBegin, open, found);
  if (variant.before) open.eliminationRanks = ranks;
  if (isForFront(variant.costs)) open.variant = variant.costs;
  return open;
}

AskedCuts withBorders(AskedCuts asked, const Seams& borders) {
  for (const SurfaceCorner h : asked.seams.ids()) asked.seams[h] = asked.seams[h] || borders[h];
  return asked;
}

/// Cuts flat regions with holes out along their creases, if that costs less than seams through
/// them.
void openPlates(const UncutSurface& uncut, const AskedCuts& asked, SeamVariant variant,
                const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                OpenSurface& open, SeamReport& found) {
  Seams borders = plateBorders(open.mesh);
  if (borders.empty()) return;
  SeamReport report;
  variant.before = &open;
  OpenSurface other =
      openWith(uncut, withBorders(asked, borders), variant, options, pool, listener, report);
  const SeamOptions how = seamOptions(options, open, pool, listener);
  // Of symmetric seams less is known than of those that they were preferred to.
  const auto costOf = [&](const OpenSurface& x) {
    const bool isSure = x.otherwise.seams.empty();
    return costOfWhole(x.mesh, isSure ? x.seams : x.otherwise.seams,
                       isSure ? x.scale : x.otherwise.scale, how.maxStretch, how.prices);
  };
  // On the surface that is open there, the borders no longer know what they cost.
  double ofBorders = 0;
  for (const SurfaceCorner h : borders.ids())
    if (borders[h] && !other.mesh.twin[h].exists()) ofBorders += open.mesh.cost[h] / 2;
  ofBorders /= std::sqrt(open.mesh.totalArea());
  if (listener.isStopped() || !(costOf(other) + ofBorders < costOf(open))) return;
  open = std::move(other);
  open.plates = std::move(borders);
  found = std::move(report);
}

}  // namespace

OpenSurface cutOpen(const UncutSurface& uncut, const AskedCuts& asked, const SeamVariant& variant,
                    const UnwrapOptions& options, ThreadPool& pool, const Listener& listener,
                    SeamSummary& summary) {
  SeamReport found;
  OpenSurface open;
  if (variant.before && !variant.before->plates.empty() && !variant.isUncut) {
    const Seams& plates = variant.before->plates;
    open = openWith(uncut, withBorders(asked, plates), variant, options, pool, listener, found);
    open.plates = plates;
  } else {
    open = openWith(uncut, asked, variant, options, pool, listener, found);
    const bool isSymmetric = options.symmetricSeams == SymmetricSeams::Always;
    // To try both ways takes twice as long, so only the first search does.
    if (options.seams.isAuto && !variant.before && !isSymmetric && !listener.isStopped())
      openPlates(uncut, asked, variant, options, pool, listener, open, found);
  }
  summary.genus = uncut.surface.summary.genus;
  summary.handleLoops = found.handleLoops;
  summary.handleLength = found.handleLength;
  open.asymmetry = found.asymmetry;
  return open;
}

}  // namespace abflat
