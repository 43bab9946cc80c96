#include "abflat/unwrap.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "abflat/io.h"
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
};
constexpr Stage kSurface{"surface", 0, 0.05}, kSeams{"seams", 0.05, 0.2},
    kSolve{"solve", 0.2, 0.85}, kPack{"pack", 0.85, 0.97}, kCheck{"check", 0.97, 1};

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
    flat[i].uv.clear();
    for (std::size_t k = 0; k < from.size(); k += 2)
      flat[i].uv.insert(flat[i].uv.end(), {p.u(&from[k]) + p.column(), p.v(&from[k]) + p.row()});
  }
}

Status packAll(const std::vector<DiskChart>& charts, const UnwrapOptionValues& options,
               ThreadPool& pool, Monitor& monitor, std::vector<FlatChart>& flat,
               AtlasReport& atlas) {
  PackOptions packing;
  packing.resolution = options.resolution;
  packing.padding = options.padding;
  packing.rotate = options.rotate;
  packing.texelDensity = options.texelDensity;
  packing.udim = options.udim;
  packing.pool = &pool;
  packing.progress = [&](double share) { return monitor.tell(kPack, share); };
  const Result<Packing> packed = pack(shapesOf(charts, flat), packing);
  if (!packed.ok()) return packed.status;
  place(packed.value, flat);
  atlas = {options.resolution, options.padding, static_cast<int>(packed.value.tiles),
           packed.value.utilization, packed.value.texelDensity};
  return {};
}

/// All charts in the atlas, rounded or as they are.
void checkAll(const std::vector<DiskChart>& charts, const UnwrapOptions& options, ThreadPool& pool,
              std::vector<FlatChart>& flat, UnwrapReport& report) {
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
  const std::vector<FlatChart> asTheyAre = flat;
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
  std::size_t lost = 0;
  for (std::size_t i = 0; i < flat.size(); ++i)
    lost += !flat[i].problem.empty() && asTheyAre[i].problem.empty();
  if (lost == 0) return;
  flat = asTheyAre;
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

}  // namespace

Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options) {
  Stopwatch watch;
  Monitor monitor(options.progress);
  const Status aborted{StatusCode::Aborted, "cancelled"};
  if (Status s = validateArrays(mesh); !s.ok()) return s;
  if (options.udim && options.texelDensity == kAutoTexelDensity)
    return Status{StatusCode::InvalidOption,
                  "several tiles (udim) are for a texel density, which is auto: give a number"};
  if (mesh.faceCount() == 0) return Status{StatusCode::EmptyMesh, "the mesh has no faces"};
  if (!monitor.tell(kSurface)) return aborted;
  UnwrapResult out;
  UnwrapReport& report = out.report;
  report.options = options;
  report.input = inspect(mesh);
  // A mesh that is a disk may be one because it has been cut: it is taken as it is.
  const WeldedMesh welded = weld(mesh, !report.input.disk.ok());
  const Surface surface = buildSurface(welded.mesh);
  if (surface.table.vertex.empty())
    return Status{StatusCode::EmptyMesh, "all faces have fewer than three different corners"};
  report.repair = repairReport(welded, surface);
  report.timings.surface = watch.lap();

  if (!monitor.tell(kSeams)) return aborted;
  ThreadPool pool(usefulThreads(options.threads, surface.table.triangleCount()));
  report.threads = pool.threads();
  const Result<Seams> given = givenSeams(mesh, welded, surface, options.seams);
  if (!given.ok()) return given.status;
  const Result<FixedTriangles> fixed = fixedTriangles(mesh, welded, surface, options.fixedFaces);
  if (!fixed.ok()) return fixed.status;
  const CutOpen open = cutOpen(
      welded, surface, given.value, fixed.value, options, pool,
      [&] { return monitor.tell(kSeams); }, report.seams);
  if (monitor.stopped()) return aborted;
  ChartSet set = makeCharts(welded.mesh, open.disks);
  orderCharts(open.place, set.charts);
  const Texcoords texcoords = numberTexcoords(welded, surface, set);
  Result<std::vector<ChartWishes>> wishes =
      chartWishes({mesh, welded, surface, set}, texcoords, options);
  if (!wishes.ok()) return wishes.status;
  report.timings.seams = watch.lap();

  if (!monitor.tell(kSolve)) return aborted;
  const CutMesh cut{mesh, welded, surface, set};
  Result<std::vector<FlatChart>> known = knownCharts(cut, options, pool);
  if (!known.ok()) return known.status;
  std::vector<FlatChart>& flat = known.value;
  if (Status s = layOutFixed(cut, fixed.value, options.udim, flat); !s.ok()) return s;
  if (Status s = checkUnpinned(set.charts, wishes.value, flat); !s.ok()) return s;
  flattenAll(set.charts, wishes.value, options, pool, monitor, flat);
  if (monitor.stopped()) return aborted;
  report.timings.solve = watch.lap();

  if (!monitor.tell(kPack)) return aborted;
  if (Status s = checkPinned(cut, flat); !s.ok()) return s;
  if (Status s = packAll(set.charts, options, pool, monitor, flat, report.atlas); !s.ok()) return s;
  report.timings.pack = watch.lap();

  if (!monitor.tell(kCheck)) return aborted;
  checkAll(set.charts, options, pool, flat, report);
  fillOutput(mesh, welded, surface, set, texcoords, flat, out);
  out.seams = seamEdges(mesh, welded, surface, open.seams);
  fillReport(set, flat, surface, welded, report);
  report.timings.check = watch.lap();
  return out;
}

}  // namespace abflat
