#include "seam/find_seams.h"

#include <algorithm>
#include <cmath>

#include "base/stopwatch.h"
#include "seam/crease_seams.h"
#include "seam/extract_charts.h"
#include "seam/find_in_rounds.h"
#include "seam/geometric_order.h"
#include "seam/prediction.h"
#include "seam/seam_value.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

double lengthOf(const SeamMesh& mesh, const Seams& seams) {
  double sum = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mesh.isOnSurface(h)) sum += mesh.length[h] / 2;
  return sum;
}

/// Length of the seams in flat faces, where nothing hides them.
double flatLengthOf(const SeamMesh& mesh, const Seams& seams) {
  double sum = 0;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h] && mesh.isOnSurface(h) && mesh.cost[h] > mesh.length[h]) sum += mesh.length[h] / 2;
  return sum;
}

/// For a mesh without cuts so far, finds seams that are symmetric to its plane of symmetry.
class SymmetricFinder {
 public:
  SymmetricFinder(const SeamMesh& mesh, const SeamOptions& options)
      : mesh_(mesh), options_(options) {}

  /// Replaces `seams`, which `report` describes, by symmetric ones if those are preferable.
  void run(Seams& seams, SeamReport& report) const {
    if (options_.symmetricSeams == SymmetricSeams::Never || costOfSeams(mesh_, seams) == 0) return;
    const bool isForced = options_.symmetricSeams == SymmetricSeams::Always;
    // Of boxes and other parts that unroll, seams follow creases, whatever is opposite.
    if (!isForced && report.stretch - 1 < kExact) return;
    // A seam and its image may reach a hole from two sides, which opens it.
    if (!isForced && options_.fillHoles == FillHoles::Always && !mesh_.hole.empty()) return;
    const Mirror mirror = findMirror(mesh_, Pulse(options_.keepsOn));
    if (!mirror) report.asymmetry = Asymmetry::NoPlane;
    if (!mirror || mirroredShare(mesh_, mirror, seams) > kSymmetric) return;
    const double before = priceOf(seams, report);
    const auto isPreferable = [&](const Found& found) {
      return found.price <= kDearer * before &&
             found.report.charts <= kMoreCharts * report.charts &&
             flatLengthOf(mesh_, found.seams) <= flatLengthOf(mesh_, seams);
    };
    std::optional<Found> best;
    for (const Beginning beginning : {Beginning::OneSide, Beginning::OtherSide, Beginning::Half}) {
      const std::optional<Seams> first = begin(beginning, mirror, costOfSeams(mesh_, seams), report);
      if (!first) continue;
      Found now = findFrom(*first, mirror, report);
      if (now.report.cancelled) report.cancelled = true;
      if (report.cancelled) return;
      if (mirroredShare(mesh_, mirror, now.seams) < kSymmetric) continue;
      if (!best || now.price < best->price) best = std::move(now);
      // Another search takes time.
      if (!isForced && isPreferable(*best)) break;
    }
    if (!best) report.asymmetry = Asymmetry::NoSeams;
    if (!best || !(isForced || isPreferable(*best))) return;
    seams = std::move(best->seams);
    // A chart must be solved in the same order whenever it is found.
    best->report.eliminationRanks = std::move(report.eliminationRanks);
    report = std::move(best->report);
    report.mirror = mirror;
  }

 private:
  /// Mean stretch, less 1, of charts that nearly all unroll.
  static constexpr double kExact = 2e-3;
  /// Mirrored share of seams that are symmetric but for a few edges.
  static constexpr double kSymmetric = 0.95;
  /// How much more symmetric seams may cost, and how many times as many charts there may be.
  static constexpr double kDearer = 1.1, kMoreCharts = 1.25;

  /// Seams to begin with, besides those in the plane: those found before, with one side replaced
  /// by the image of the other one, or those of one side if it is a surface of its own.
  enum class Beginning : std::uint8_t { OneSide, OtherSide, Half };

  struct Found {
    Seams seams;
    SeamReport report;
    double price = 0;
  };

  /// None if there are none, or if they will cost too much.
  std::optional<Seams> begin(Beginning beginning, const Mirror& mirror, double cost,
                             const SeamReport& report) const {
    const std::optional<Seams> plane = planeSeams(mesh_, mirror);
    if (beginning == Beginning::Half) {
      const std::optional<SeamPart> half = halfOf(mesh_, mirror, options_.fillHoles);
      if (!plane || !half) return {};
      const Seams found = seamsOfHalf(*half, report.eliminationRanks);
      // By measurement, the result costs more than this.
      constexpr double kLeastOfPlane = 0.6;
      const double least = 2 * costOfSeams(half->mesh, found) + kLeastOfPlane * costOfSeams(mesh_, *plane);
      if (options_.symmetricSeams == SymmetricSeams::Auto && least > kDearer * cost) return {};
      return unfold(mesh_, mirror, *half, found);
    }
    const int from = beginning == Beginning::OneSide ? 1 : -1;
    Seams out = mirrored(mesh_, mirror, report.found, from);
    // A seam beside the plane and its image are joined to one in the plane.
    if (plane)
      for (const SurfaceCorner h : out.ids()) out[h] = out[h] || (*plane)[h];
    return mirrored(mesh_, mirror, out, 1);
  }

  Found findFrom(const Seams& first, const Mirror& mirror, const SeamReport& before) const {
    SeamOptions options = options_;
    options.eliminationRanks = before.eliminationRanks;
    options.first = first;
    options.mirror = mirror;
    Found out;
    out.seams = findInRounds(mesh_, Seams(mesh_.twin.size(), 0), options, out.report);
    out.price = priceOf(out.seams, out.report);
    return out;
  }

  double priceOf(const Seams& seams, const SeamReport& report) const {
    const IdVector<SurfaceTriangle, CutChartId> all(mesh_.triangleCount(), CutChartId(0));
    return costOfParts(mesh_, seams, report.scale, options_.maxStretch, all, 1, options_.prices)
        .front();
  }

  Seams seamsOfHalf(const SeamPart& half, const EliminationRanks& ranks) const {
    SeamOptions options = options_;
    options.eliminationRanks = half.ofVertices(ranks);
    SeamReport own;
    return findInRounds(half.mesh, Seams(half.mesh.twin.size(), 0), options, own);
  }

  const SeamMesh& mesh_;
  const SeamOptions& options_;
};

/// Finds seams once more for components that have creases, starting with the patches between them,
/// and takes those that cost less.
class CreaseFinder {
 public:
  CreaseFinder(const SeamMesh& mesh, const SeamOptions& options)
      : mesh_(mesh),
        options_(options),
        whole_(cutAlong(mesh, Seams(mesh.twin.size(), 0))),
        creases_(creasesToBegin(mesh, whole_)) {}

  /// `seams`, which `report` describes, were found starting with whole components.
  void run(Seams& seams, SeamReport& report) const {
    if (creases_.empty()) return;
    const SeamPart part = extractCharts(mesh_, whole_, componentsWithCreases());
    SeamOptions options = options_;
    options.first = part.ofCorners(creases_);
    options.eliminationRanks = part.ofVertices(report.eliminationRanks);
    SeamReport own;
    const Seams found = findInRounds(part.mesh, Seams(part.mesh.twin.size(), 0), options, own);
    report.cancelled = report.cancelled || own.cancelled;
    if (!report.cancelled) takeCheaper(part, found, own, seams, report);
  }

 private:
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
    for (const SurfaceCorner i : found.ids()) other[part.wholeHalfEdge[i]] = found[i];
    for (const SurfaceVertex i : own.scale.ids()) scale[part.wholeVertex[i]] = own.scale[i];
    const IdVector<CutChartId, double> before = costs(seams, report.scale),
                                       after = costs(other, scale);
    for (const SurfaceCorner i : found.ids()) {
      const SurfaceCorner h = part.wholeHalfEdge[i];
      if (!(after[whole_.chartOf(h)] < before[whole_.chartOf(h)])) continue;
      seams[h] = found[i];
      report.found[h] = own.found[i];
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
  const CutSurface whole_;  ///< its charts are the components
  const Seams creases_;
};

/// With seams marked on both sides.
Seams findInOrder(const SeamMesh& mesh, Seams seams, const SeamOptions& options,
                  SeamReport& report) {
  const bool isFree = options.isAuto && options.first.empty() &&
                      std::find(seams.begin(), seams.end(), 1) == seams.end();
  if (mesh.triangleCount() > 0) seams = findInRounds(mesh, std::move(seams), options, report);
  if (!isFree) report.asymmetry = Asymmetry::SeamsGiven;
  if (isFree && !report.cancelled) CreaseFinder(mesh, options).run(seams, report);
  if (isFree && !report.cancelled) SymmetricFinder(mesh, options).run(seams, report);
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
  const SeamPart part = inGeometricOrder(mesh);
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
