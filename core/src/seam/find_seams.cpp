#include "seam/find_seams.h"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "seam/crease_seams.h"
#include "seam/extract_charts.h"
#include "seam/find_in_rounds.h"
#include "seam/find_symmetric.h"
#include "seam/geometric_order.h"
#include "seam/prediction.h"
#include "seam/seam_value.h"
#include "seam/vary_costs.h"

namespace abflat {
namespace {

double lengthOf(const SeamMesh& mesh, const Seams& seams) {
  double sum = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mesh.isOnSurface(h)) sum += mesh.length[h] / 2;
  return sum;
}

/// Finds seams once more for components that have creases, starting with the patches between them,
/// and takes those that cost less.
class CreaseFinder {
 public:
  CreaseFinder(const SeamMesh& mesh, const Seams& given, const SeamOptions& options)
      : mesh_(mesh),
        options_(options),
        whole_(cutAlong(mesh, given)),
        creases_(creasesToBegin(mesh, whole_, options.speck * options.speck / kFoldedUp)) {}

  /// `seams`, which `report` describes, were found starting with whole components.
  void run(Seams& seams, SeamReport& report) const {
    if (creases_.empty()) return;
    const SeamPart part = extractCharts(mesh_, whole_, componentsWithCreases());
    SeamOptions options = options_;
    options.first = part.ofCorners(creases_);
    options.eliminationRanks = part.ofVertices(report.eliminationRanks);
    SeamReport own;
    const Seams found = findInRounds(part.mesh, Seams(part.mesh.twin.size(), 0), options, own);
    if (!options_.listener.isStopped()) takeCheaper(part, found, own, seams, report);
  }

 private:
  /// Of the square of its extent once it is flat, the inverse of a closed speck's area.
  static constexpr double kFoldedUp = 4;

  IdVector<CutChartId, std::uint8_t> componentsWithCreases() const {
    IdVector<CutChartId, std::uint8_t> out(whole_.charts.size(), 0);
    for (const SurfaceCorner h : creases_.ids())
      if (creases_[h]) out[whole_.chartOf(h)] = 1;
    return out;
  }

  IdVector<CutChartId, double> costs(const Seams& seams, const LogScales& u) const {
    return costOfParts(mesh_, seams, u, options_.maxStretch, whole_.chartOfTriangle,
                       whole_.charts.size(), options_.prices);
  }

  void takeCheaper(const SeamPart& part, const Seams& found, const SeamReport& own, Seams& seams,
                   SeamReport& report) const {
    Seams other = seams;
    LogScales scale = report.scale;
    for (const SurfaceCorner i : found.ids())
      if (part.mesh.twin[i].exists()) other[part.wholeHalfEdge[i]] = found[i];
    for (const SurfaceVertex i : own.scale.ids()) scale[part.wholeVertex[i]] = own.scale[i];
    const IdVector<CutChartId, double> before = costs(seams, report.scale),
                                       after = costs(other, scale);
    for (const SurfaceCorner i : found.ids()) {
      const SurfaceCorner h = part.wholeHalfEdge[i];
      if (!(after[whole_.chartOf(h)] < before[whole_.chartOf(h)])) continue;
      if (part.mesh.twin[i].exists()) {
        seams[h] = found[i];
        report.found[h] = own.found[i];
      }
      report.scale[mesh_.tail(h)] = own.scale[part.mesh.tail(i)];
      report.foundScale[mesh_.tail(h)] = own.foundScale[part.mesh.tail(i)];
    }
    const CutSurface s = cutAlong(mesh_, seams);
    report.stretch = predictStretch(mesh_, s, report.scale).total;
    report.charts = 0;
    for (const CutSurface::Chart& chart : s.charts)
      report.charts += !mesh_.isFilling(chart.firstTriangle);
  }

  const SeamMesh& mesh_;
  const SeamOptions& options_;
  const CutSurface whole_;  ///< its charts are the components, cut along given seams
  const Seams creases_;
};

/// With seams marked on both sides.
Seams findInOrder(const SeamMesh& mesh, Seams seams, const SeamOptions& options,
                  SeamReport& report) {
  const bool isNew = options.isAuto && options.first.empty();
  const bool isFree = isNew && std::find(seams.begin(), seams.end(), 1) == seams.end();
  const Seams given = isNew ? seams : Seams();
  if (mesh.triangleCount() > 0) seams = findInRounds(mesh, std::move(seams), options, report);
  if (!isFree) report.asymmetry = Asymmetry::SeamsGiven;
  if (isNew && !options.listener.isStopped()) CreaseFinder(mesh, given, options).run(seams, report);
  if (isFree && !options.listener.isStopped()) preferSymmetric(mesh, options, seams, report);
  report.seamLength = lengthOf(mesh, seams);
  const double size = std::sqrt(mesh.totalArea());
  if (size > 0) {
    report.seamLength /= size;
    report.handleLength /= size;
  }
  return seams;
}

/// The same for the whole, of which the part has everything in another order.
SeamReport inWhole(const SeamPart& part, SeamReport report) {
  report.found = part.toWhole(report.found);
  report.eliminationRanks = part.toWhole(report.eliminationRanks);
  report.scale = part.toWhole(report.scale);
  report.foundScale = part.toWhole(report.foundScale);
  report.mirror = report.mirror.ofWhole(part);
  KnownSeams& x = report.otherwise;
  if (x.seams.empty()) return report;
  x.seams = part.toWhole(x.seams);
  x.found = part.toWhole(x.found);
  x.scale = part.toWhole(x.scale);
  x.foundScale = part.toWhole(x.foundScale);
  return report;
}

}  // namespace

Seams findSeams(const SeamMesh& mesh, Seams given, const SeamOptions& options, SeamReport* report) {
  Stopwatch watch;
  given.resize(mesh.twin.size(), 0);
  for (const SurfaceCorner h : given.ids()) {
    if (!mesh.twin[h].exists()) given[h] = 0;
    if (given[h]) given[mesh.twin[h]] = given[h] = 1;
  }
  // So that it is not the numbers that decide between seams that are equally good.
  SeamPart part = inGeometricOrder(mesh);
  varyCosts(options.variant, part.mesh);
  SeamOptions own = options;
  own.first = part.ofCorners(options.first);
  own.eliminationRanks = part.ofVertices(options.eliminationRanks);
  own.mirror = options.mirror.ofPart(part);
  SeamReport found;
  const Seams seams = findInOrder(part.mesh, part.ofCorners(given), own, found);
  if (report) {
    *report = inWhole(part, std::move(found));
    report->seconds = watch.lap();
  }
  return part.toWhole(seams);
}

}  // namespace abflat
