#include "seam/find_symmetric.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "seam/find_in_rounds.h"
#include "seam/seam_value.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

/// Mean stretch, less 1, of charts that nearly unroll.
constexpr double kHardlyStretched = 0.01;
/// Mirrored share of seams that are symmetric but for a few edges.
constexpr double kSymmetric = 0.95;

/// Seams to begin with have those of one side on both. The plane is added to narrow charts, or to
/// all but very broad ones.
constexpr double kNarrowChart = 0.15, kBroadChart = 1;

/// The seams of one search, with what is known of them.
struct FoundSymmetric {
  Seams seams;
  SeamReport report;
  double price = 0;
};

SeamOptions withMirror(SeamOptions options, Mirror mirror) {
  options.mirror = std::move(mirror);
  return options;
}

class SymmetricFinder {
 public:
  SymmetricFinder(const SeamMesh& mesh, const SeamOptions& options, Mirror mirror)
      : mesh_(mesh), options_(withMirror(options, std::move(mirror))), dear_(mesh) {
    // Two seams instead of one are bad only where they are seen.
    constexpr double kInSight = 0.85, kDearInSight = 2;
    for (const SurfaceCorner h : mesh.corners())
      if (mesh.plainCost(h) > kInSight * mesh.length[h] && mesh.cost[h] < kBarredCost)
        dear_.cost[h] *= kDearInSight;
  }

  void run(Seams& seams, SeamReport& report) {
    std::optional<FoundSymmetric> found = isForced() ? findAny(report) : findCheap(seams, report);
    if (options_.listener.isStopped()) return;
    if (!found) report.asymmetry = Asymmetry::NoSeams;
    if (!found || !(isForced() || isPreferable(*found, seams, report))) return;
    KnownSeams otherwise{std::move(seams), std::move(report.found), std::move(report.scale),
                         std::move(report.foundScale)};
    seams = std::move(found->seams);
    // A chart must be solved in the same order whenever it is found.
    found->report.eliminationRanks = std::move(report.eliminationRanks);
    if (!isForced()) found->report.otherwise = std::move(otherwise);
    report = std::move(found->report);
    report.mirror = options_.mirror;
  }

 private:
  bool isForced() const { return options_.symmetricSeams == SymmetricSeams::Always; }

  /// The best of all searches.
  std::optional<FoundSymmetric> findAny(const SeamReport& report) const {
    std::optional<FoundSymmetric> best;
    for (const double broadest : {kNarrowChart, kBroadChart}) {
      for (const Seams& first : beginningsFrom(report.found, broadest)) {
        JoinedSeams joined = joinedFrom(first, report);
        if (options_.listener.isStopped()) return {};
        takeBetter(std::move(joined), best);
      }
    }
    return best;
  }

  /// Finishes only those that are cheapest once charts are joined, and none if even these cost so
  /// much more than `seams` that finishing will not make up for it.
  std::optional<FoundSymmetric> findCheap(const Seams& seams, const SeamReport& report) const {
    constexpr std::size_t kFinished = 2;
    constexpr double kHopeless = 1.26;
    const double most = kHopeless * priceOf(dear_, seams, report.scale);
    std::vector<std::pair<double, JoinedSeams>> open;  // cheapest first
    for (const double broadest : {kNarrowChart, kBroadChart}) {
      for (const Seams& first : beginningsFrom(report.found, broadest)) {
        JoinedSeams now = joinedFrom(first, report);
        if (options_.listener.isStopped()) return {};
        const double price = priceOf(dear_, now.seams, now.scale);
        const auto dearer = std::find_if(open.begin(), open.end(),
                                         [&](const auto& other) { return price < other.first; });
        open.emplace(dearer, price, std::move(now));
      }
      if (open.front().first > most) return {};
      open.resize(std::min(open.size(), kFinished));
    }
    std::optional<FoundSymmetric> best;
    for (auto& [price, joined] : open) takeBetter(std::move(joined), best);
    return best;
  }

  JoinedSeams joinedFrom(const Seams& first, const SeamReport& report) const {
    SeamOptions options = options_;
    options.eliminationRanks = report.eliminationRanks;
    options.first = first;
    return findJoined(dear_, Seams(dear_.twin.size(), 0), options);
  }

  /// The seams of either side with their images; charts of their own image that are narrower than
  /// `broadest` are cut along the plane.
  std::vector<Seams> beginningsFrom(const Seams& found, double broadest) const {
    std::vector<Seams> out;
    for (const int from : {1, -1}) {
      Seams seams = mirrored(mesh_, options_.mirror, found, from);
      cutAlongPlane(mesh_, options_.mirror, broadest, seams);
      seams = mirrored(mesh_, options_.mirror, seams, 1);
      if (out.empty() || seams != out.back()) out.push_back(std::move(seams));
    }
    return out;
  }

  /// Finishes a search, and takes what it finds if that is symmetric and cheaper than `best`.
  void takeBetter(JoinedSeams joined, std::optional<FoundSymmetric>& best) const {
    FoundSymmetric now;
    now.seams = finishJoined(dear_, std::move(joined), options_, now.report);
    now.price = priceOf(mesh_, now.seams, now.report.scale);
    if (mirroredShare(mesh_, options_.mirror, now.seams) < kSymmetric) return;
    if (!best || now.price < best->price) best = std::move(now);
  }

  double priceOf(const SeamMesh& mesh, const Seams& seams, const LogScales& u) const {
    return costOfWhole(mesh, seams, u, options_.maxStretch, options_.prices);
  }

  /// Length of the seams, and of those in flat faces, where nothing hides them.
  std::pair<double, double> lengthsOf(const Seams& seams) const {
    double all = 0, flat = 0;
    for (const SurfaceCorner h : seams.ids()) {
      if (!seams[h] || !mesh_.isOnSurface(h)) continue;
      all += mesh_.length[h] / 2;
      if (mesh_.plainCost(h) > mesh_.length[h]) flat += mesh_.length[h] / 2;
    }
    return {all, flat};
  }

  bool isPreferable(const FoundSymmetric& found, const Seams& seams,
                    const SeamReport& report) const {
    constexpr double kMore = 1.1, kMoreCharts = 1.25;
    // Where people look, a seam on one side only is worse than longer ones on both.
    const bool hasFront = !mesh_.front.empty();
    const double longer = hasFront ? 1.6 : kMore, flatter = hasFront ? longer : 1;
    constexpr std::uint32_t kPair = 2;
    const std::pair<double, double> now = lengthsOf(found.seams), before = lengthsOf(seams);
    return found.price <= kMore * priceOf(mesh_, seams, report.scale) &&
           now.first <= longer * before.first && now.second <= flatter * before.second &&
           found.report.charts <=
               std::max<double>(kMoreCharts * report.charts, report.charts + kPair);
  }

  const SeamMesh& mesh_;
  const SeamOptions options_;  ///< with the mirror
  SeamMesh dear_;              ///< where seams in sight cost more
};

}  // namespace

void preferSymmetric(const SeamMesh& mesh, const SeamOptions& options, Seams& seams,
                     SeamReport& report) {
  if (options.symmetricSeams == SymmetricSeams::Never || costOfSeams(mesh, seams) == 0) return;
  const bool isForced = options.symmetricSeams == SymmetricSeams::Always;
  // Of boxes and other parts that unroll, seams follow creases, whatever is opposite.
  if (!isForced && report.stretch - 1 < kHardlyStretched) return;
  // A seam and its image may reach a hole from two sides, which opens it.
  if (!isForced && options.fillHoles == FillHoles::Always && !mesh.hole.empty()) return;
  Mirror mirror = findMirror(mesh, options.listener);
  if (!mirror) report.asymmetry = Asymmetry::NoPlane;
  if (!mirror || mirroredShare(mesh, mirror, seams) > kSymmetric) return;
  SymmetricFinder(mesh, options, std::move(mirror)).run(seams, report);
}

}  // namespace abflat
