#include "abflat/unwrap.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "abflat/io.h"
#include "abflat/peak_memory.h"
#include "chart/chart_set.h"
#include "mesh/surface.h"
#include "mesh/triangle_geometry.h"
#include "mesh/welded_mesh.h"
#include "pack/pack.h"
#include "parallel.h"
#include "round_texcoords.h"
#include "seam/given_seams.h"
#include "stopwatch.h"
#include "unwrap_chart.h"
#include "unwrap_fixed.h"
#include "unwrap_known.h"
#include "unwrap_output.h"
#include "unwrap_pinned.h"
#include "unwrap_seams.h"

namespace abflat {
namespace {

/// Where the stages are in the progress bar.
struct Stage {
  const char* name;
  double from, to;
  double UnwrapStages::*field;
};
constexpr Stage kSurface{"surface", 0, 0.05, &UnwrapStages::surface},
    kSeams{"seams", 0.05, 0.2, &UnwrapStages::seams},
    kSolve{"solve", 0.2, 0.85, &UnwrapStages::solve},
    kPack{"pack", 0.85, 0.97, &UnwrapStages::pack}, kCheck{"check", 0.97, 1, &UnwrapStages::check};

/// Coordinates below 16, which is what packing allows for.
constexpr int kMostTilesInSingle = 160;

class Monitor {
 public:
  explicit Monitor(const ProgressCallback& callback) : callback_(callback) {}

  /// False when the run is to end. `share` of the stage is done.
  bool tell(const Stage& stage, double share = 0) {
    Progress now;
    now.stage = stage.name;
    now.fraction = stage.from + share * (stage.to - stage.from);
    if (callback_ && !stopped_ && !callback_(now)) stopped_ = true;
    return !stopped_;
  }
  bool stopped() const { return stopped_; }

 private:
  const ProgressCallback& callback_;
  std::atomic<bool> stopped_{false};
};

/// Charts by size, the largest first: what takes longest begins first.
std::vector<std::uint32_t> largestFirst(const std::vector<DiskChart>& charts) {
  std::vector<std::uint32_t> order(charts.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return charts[a].triangleCount() > charts[b].triangleCount();
  });
  return order;
}

/// What the input gives is not to be pinned elsewhere.
Status checkUnpinned(const std::vector<DiskChart>& charts, const std::vector<ChartWishes>& wishes,
                     const std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < charts.size(); ++i)
    if (flat[i].isGiven && !wishes[i].pins.empty())
      return {StatusCode::InvalidOption,
              "vertex " + std::to_string(charts[i].inputVertex[wishes[i].pins.front().vertex]) +
                  " is pinned, but its chart is to keep its texcoords; leave one of them out"};
  return {};
}

/// Those that have no layout yet, and those with pins.
void flattenAll(const std::vector<DiskChart>& charts, const std::vector<ChartWishes>& wishes,
                const UnwrapOptionValues& options, ThreadPool& pool, Monitor& monitor,
                std::vector<FlatChart>& flat) {
  const std::vector<std::uint32_t> order = largestFirst(charts);
  std::size_t triangles = 0;
  const auto isKnown = [&](std::size_t i) {
    return !flat[i].unpacked.empty() && wishes[i].pins.empty();
  };
  for (std::size_t i = 0; i < charts.size(); ++i)
    if (!isKnown(i)) triangles += charts[i].triangleCount();
  std::atomic<std::size_t> done{0};
  parallelFor(&pool, charts.size(), [&](std::size_t i) {
    if (monitor.stopped()) return;
    const DiskChart& chart = charts[order[i]];
    if (isKnown(order[i])) return;
    // The caller hears of all charts, but from its own thread only.
    const auto goesOn = [&] {
      if (!pool.isOwner()) return !monitor.stopped();
      return monitor.tell(kSolve, static_cast<double>(done) / static_cast<double>(triangles));
    };
    flat[order[i]] = flattenOne(chart, options, wishes[order[i]], pool, goesOn);
    done += chart.triangleCount();
  });
}

std::vector<PackShape> shapesOf(const std::vector<DiskChart>& charts,
                                const std::vector<FlatChart>& flat) {
  std::vector<PackShape> shapes(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    shapes[i].isFixed = flat[i].isFixed;
    shapes[i].uv = flat[i].isFixed ? flat[i].uv : flat[i].unpacked;
    const auto corners = charts[i].vertexOfCorner.begin();
    shapes[i].triangles.assign(corners, corners + 3 * charts[i].surfaceTriangles());
    // Others may lie in its holes.
    if (charts[i].filledHoles > 0 || flat[i].isGiven) continue;
    for (const std::uint32_t h : charts[i].boundary)
      shapes[i].outline.push_back(charts[i].vertexOfCorner[h]);
  }
  return shapes;
}

/// Moves the layouts to their places.
void place(const Packing& packing, std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (flat[i].isFixed) continue;
    const Placement& p = packing.placements[i];
    const std::vector<double>& from = flat[i].unpacked;
    flat[i].uv.resize(from.size());
    for (std::size_t k = 0; k < from.size(); k += 2) {
      flat[i].uv[k] = p.u(&from[k]) + p.column();
      flat[i].uv[k + 1] = p.v(&from[k]) + p.row();
    }
  }
}

Status packAll(const std::vector<DiskChart>& charts, const UnwrapOptionValues& options,
               ThreadPool& pool, Monitor& monitor, std::vector<FlatChart>& flat, Packing& packing,
               AtlasReport& atlas) {
  PackOptions how;
  how.resolution = options.resolution;
  how.padding = options.padding;
  how.rotate = options.rotate;
  how.texelDensity = options.texelDensity;
  how.udim = options.udim;
  how.pool = &pool;
  how.progress = [&](double share) { return monitor.tell(kPack, share); };
  Result<Packing> packed = pack(shapesOf(charts, flat), how);
  if (!packed.ok()) return packed.status;
  packing = std::move(packed.value);
  place(packing, flat);
  atlas = {options.resolution, options.padding, static_cast<int>(packing.tiles),
           packing.utilization, packing.texelDensity};
  return {};
}

/// What is needed to undo rounding. Charts that were packed can be placed once more.
class BeforeRounding {
 public:
  explicit BeforeRounding(const std::vector<FlatChart>& flat) {
    for (const FlatChart& chart : flat) {
      const bool isPinned = chart.isFixed && !chart.isGiven;
      uvOfPinned_.push_back(isPinned ? chart.uv : std::vector<double>());
      hadProblem_.push_back(!chart.problem.empty());
    }
  }

  /// Charts that have a problem since.
  std::size_t lost(const std::vector<FlatChart>& flat) const {
    std::size_t out = 0;
    for (std::size_t i = 0; i < flat.size(); ++i)
      out += !flat[i].problem.empty() && !hadProblem_[i];
    return out;
  }

  /// Validity of all without a problem has to be decided anew.
  void restore(const Packing& packing, std::vector<FlatChart>& flat) const {
    place(packing, flat);
    for (std::size_t i = 0; i < flat.size(); ++i) {
      if (!uvOfPinned_[i].empty()) flat[i].uv = uvOfPinned_[i];
      if (!hadProblem_[i]) flat[i].problem.clear();
    }
  }

 private:
  std::vector<std::vector<double>> uvOfPinned_;  ///< empty for others
  std::vector<bool> hadProblem_;
};

/// All charts in the atlas, rounded or as they are.
void checkAll(const std::vector<DiskChart>& charts, const UnwrapOptions& options,
              const Packing& packing, ThreadPool& pool, std::vector<FlatChart>& flat,
              UnwrapReport& report) {
  const auto check = [&] {
    parallelFor(&pool, flat.size(), [&](std::size_t i) {
      if (!flat[i].isGiven) checkInPlace(charts[i], flat[i]);
    });
  };
  const bool isFine = report.atlas.tiles <= kMostTilesInSingle;
  if (options.roundsToSingle && !isFine)
    report.notes.push_back("texcoords are in double precision: single is too coarse for " +
                           std::to_string(report.atlas.tiles) + " tiles");
  if (!options.roundsForGltf && !(options.roundsToSingle && isFine)) return check();
  const BeforeRounding before(flat);
  for (FlatChart& chart : flat) {
    if (chart.isGiven) continue;
    if (!chart.isFixed)
      roundInAtlas(chart.uv);
    else if (options.roundsForGltf)
      roundForGltf(chart.uv);
    else
      roundToSingle(chart.uv);
  }
  check();
  if (options.roundsForGltf) return;  // which holds nothing else
  const std::size_t lost = before.lost(flat);
  if (lost == 0) return;
  before.restore(packing, flat);
  check();
  report.notes.push_back("texcoords are in double precision: rounded to single, " +
                         std::to_string(lost) + (lost == 1 ? " chart" : " charts") +
                         " would not be valid");
}

/// Charts are factored in the order that was found for the whole surface.
void orderCharts(const std::vector<std::uint32_t>& place, std::vector<DiskChart>& charts) {
  for (DiskChart& chart : charts)
    for (const std::uint32_t v : chart.inputVertex) chart.place.push_back(place[v]);
}

/// One run, stage by stage.
class Unwrapping {
 public:
  Unwrapping(const PolygonMesh& mesh, const UnwrapOptions& options)
      : mesh_(mesh), options_(options), monitor_(options.progress) {}

  Result<UnwrapResult> run() {
    if (Status s = checkInput(); !s.ok()) return s;
    report_.options = options_;
    const std::pair<const Stage&, Status (Unwrapping::*)()> stages[] = {
        {kSurface, &Unwrapping::seeSurface}, {kSeams, &Unwrapping::cut},
        {kSolve, &Unwrapping::flatten},      {kPack, &Unwrapping::packCharts},
        {kCheck, &Unwrapping::finish},
    };
    for (const auto& [stage, work] : stages) {
      if (monitor_.tell(stage))
        if (Status s = (this->*work)(); !s.ok()) return s;
      if (monitor_.stopped()) return Status{StatusCode::Aborted, "cancelled"};
      report_.timings.*stage.field = watch_.lap();
      report_.peakMemory.*stage.field = peakMemory();
    }
    return std::move(out_);
  }

 private:
  CutMesh cutMesh() const { return {mesh_, welded_, surface_, set_}; }

  Status checkInput() const {
    if (Status s = validateArrays(mesh_); !s.ok()) return s;
    if (options_.udim && options_.texelDensity == kAutoTexelDensity)
      return {StatusCode::InvalidOption,
              "several tiles (udim) are for a texel density, which is auto: give a number"};
    if (mesh_.faceCount() == 0) return {StatusCode::EmptyMesh, "the mesh has no faces"};
    return {};
  }

  Status seeSurface() {
    report_.input = inspect(mesh_);
    // A mesh that is a disk may be one because it has been cut: it is taken as it is.
    welded_ = weld(mesh_, !report_.input.disk.ok());
    surface_ = buildSurface(welded_.mesh);
    if (surface_.table.vertex.empty())
      return {StatusCode::EmptyMesh, "all faces have fewer than three different corners"};
    report_.repair = repairReport(welded_, surface_);
    pool_ = std::make_unique<ThreadPool>(
        usefulThreads(options_.threads, surface_.table.triangleCount()));
    report_.threads = pool_->threads();
    return {};
  }

  Status cut() {
    const Result<Seams> given = givenSeams(mesh_, welded_, surface_, options_.seams);
    if (!given.ok()) return given.status;
    Result<FixedTriangles> fixed = fixedTriangles(mesh_, welded_, surface_, options_);
    if (!fixed.ok()) return fixed.status;
    fixed_ = std::move(fixed.value);
    CutOpen open = cutOpen(
        welded_, surface_, given.value, fixed_, options_, *pool_,
        [&] { return monitor_.tell(kSeams); }, report_.seams);
    if (monitor_.stopped()) return {};
    seams_ = std::move(open.seams);
    set_ = makeCharts(welded_.mesh, open.disks);
    orderCharts(open.place, set_.charts);
    return {};
  }

  Status flatten() {
    texcoords_ = numberTexcoords(welded_, surface_, set_);
    const Result<std::vector<ChartWishes>> wishes = chartWishes(cutMesh(), texcoords_, options_);
    if (!wishes.ok()) return wishes.status;
    Result<std::vector<FlatChart>> known = knownCharts(cutMesh(), wishes.value, options_, *pool_);
    if (!known.ok()) return known.status;
    flat_ = std::move(known.value);
    if (Status s = layOutFixed(cutMesh(), fixed_, options_.udim, flat_); !s.ok()) return s;
    if (Status s = checkUnpinned(set_.charts, wishes.value, flat_); !s.ok()) return s;
    flattenAll(set_.charts, wishes.value, options_, *pool_, monitor_, flat_);
    return {};
  }

  Status packCharts() {
    if (Status s = checkPinned(cutMesh(), flat_); !s.ok()) return s;
    return packAll(set_.charts, options_, *pool_, monitor_, flat_, packing_, report_.atlas);
  }

  Status finish() {
    checkAll(set_.charts, options_, packing_, *pool_, flat_, report_);
    fillOutput(mesh_, welded_, surface_, set_, texcoords_, flat_, out_);
    out_.seams = seamEdges(mesh_, welded_, surface_, seams_);
    fillReport(set_, flat_, surface_, welded_, report_);
    return {};
  }

  const PolygonMesh& mesh_;
  const UnwrapOptions& options_;
  Stopwatch watch_;
  Monitor monitor_;
  UnwrapResult out_;
  UnwrapReport& report_ = out_.report;
  WeldedMesh welded_;
  Surface surface_;
  std::unique_ptr<ThreadPool> pool_;
  FixedTriangles fixed_;
  Seams seams_;
  ChartSet set_;
  Texcoords texcoords_;
  std::vector<FlatChart> flat_;
  Packing packing_;
};

}  // namespace

Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options) {
  return Unwrapping(mesh, options).run();
}

}  // namespace abflat
