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
#include "seam/given_seams.h"
#include "stopwatch.h"
#include "unwrap_chart.h"
#include "unwrap_output.h"
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

std::vector<FlatChart> flattenAll(const std::vector<DiskChart>& charts,
                                  const UnwrapOptionValues& options, ThreadPool& pool,
                                  Monitor& monitor) {
  std::vector<FlatChart> flat(charts.size());
  const std::vector<std::uint32_t> order = largestFirst(charts);
  std::size_t triangles = 0;
  for (const DiskChart& c : charts) triangles += c.triangleCount();
  std::atomic<std::size_t> done{0};
  parallelFor(&pool, charts.size(), [&](std::size_t i) {
    if (monitor.stopped()) return;
    const DiskChart& chart = charts[order[i]];
    // The caller hears of all charts, but from its own thread only.
    const auto goesOn = [&] {
      if (!pool.isOwner()) return !monitor.stopped();
      return monitor.tell(kSolve, static_cast<double>(done) / static_cast<double>(triangles));
    };
    flat[order[i]] = flattenOne(chart, options, pool, goesOn);
    done += chart.triangleCount();
  });
  return flat;
}

std::vector<PackShape> shapesOf(const std::vector<DiskChart>& charts,
                                const std::vector<FlatChart>& flat) {
  std::vector<PackShape> shapes(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    shapes[i].uv = flat[i].uv;
    const auto corners = charts[i].vertexOfCorner.begin();
    shapes[i].triangles.assign(corners, corners + 3 * charts[i].surfaceTriangles());
    if (charts[i].filledHoles > 0) continue;  // others may lie in its holes
    for (const std::uint32_t h : charts[i].boundary)
      shapes[i].outline.push_back(charts[i].vertexOfCorner[h]);
  }
  return shapes;
}

/// Moves the layouts to their places.
void place(const Packing& packing, std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Placement& p = packing.placements[i];
    std::vector<double>& uv = flat[i].uv;
    for (std::size_t k = 0; k < uv.size(); k += 2) {
      const double u = p.u(&uv[k]), v = p.v(&uv[k]);
      uv[k] = u;
      uv[k + 1] = v;
    }
  }
}

/// All charts in the atlas, rounded or as they are.
void checkAll(const std::vector<DiskChart>& charts, bool roundsToSingle, ThreadPool& pool,
              std::vector<FlatChart>& flat, std::vector<std::string>& notes) {
  const auto check = [&] {
    parallelFor(&pool, flat.size(), [&](std::size_t i) { checkInPlace(charts[i], flat[i]); });
  };
  if (!roundsToSingle) return check();
  const std::vector<FlatChart> asTheyAre = flat;
  for (FlatChart& chart : flat)
    for (double& x : chart.uv) x = static_cast<double>(static_cast<float>(x));
  check();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < flat.size(); ++i)
    lost += !flat[i].problem.empty() && asTheyAre[i].problem.empty();
  if (lost == 0) return;
  flat = asTheyAre;
  check();
  notes.push_back("texcoords are in double precision: rounded to single, " + std::to_string(lost) +
                  (lost == 1 ? " chart" : " charts") + " would not be valid");
}

}  // namespace

Result<UnwrapResult> unwrap(const PolygonMesh& mesh, const UnwrapOptions& options) {
  Stopwatch watch;
  Monitor monitor(options.progress);
  const Status aborted{StatusCode::Aborted, "cancelled"};
  if (Status s = validateArrays(mesh); !s.ok()) return s;
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
  Result<Seams> given = givenSeams(mesh, welded, surface, options.seams);
  if (!given.ok()) return given.status;
  const CutMesh cut = cutMesh(
      welded, surface, given.value, options, pool, [&] { return monitor.tell(kSeams); },
      report.seams);
  if (monitor.stopped()) return aborted;
  const ChartSet set = makeCharts(welded.mesh, cut.disks);
  report.timings.seams = watch.lap();

  if (!monitor.tell(kSolve)) return aborted;
  std::vector<FlatChart> flat = flattenAll(set.charts, options, pool, monitor);
  if (monitor.stopped()) return aborted;
  report.timings.solve = watch.lap();

  if (!monitor.tell(kPack)) return aborted;
  PackOptions packing;
  packing.resolution = options.resolution;
  packing.padding = options.padding;
  packing.pool = &pool;
  packing.progress = [&](double share) { return monitor.tell(kPack, share); };
  const Result<Packing> packed = pack(shapesOf(set.charts, flat), packing);
  if (!packed.ok()) return packed.status;
  place(packed.value, flat);
  report.atlas = {options.resolution, options.padding, packed.value.utilization,
                  packed.value.texelDensity};
  report.timings.pack = watch.lap();

  if (!monitor.tell(kCheck)) return aborted;
  checkAll(set.charts, options.roundsToSingle, pool, flat, report.notes);
  fillOutput(mesh, welded, surface, set, flat, out);
  out.seams = seamEdges(mesh, welded, surface, cut.seams);
  fillReport(set, flat, surface, welded, report);
  report.timings.check = watch.lap();
  return out;
}

}  // namespace abflat
