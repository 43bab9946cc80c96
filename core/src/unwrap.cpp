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
#include "seam/find_seams.h"
#include "seam/given_seams.h"
#include "stopwatch.h"
#include "unwrap_chart.h"
#include "unwrap_known.h"
#include "unwrap_output.h"

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

/// Those that have no layout yet, and those with pins.
void flattenAll(const std::vector<DiskChart>& charts,
                const std::vector<std::vector<ChartPin>>& pins, const UnwrapOptionValues& options,
                ThreadPool& pool, Monitor& monitor, std::vector<FlatChart>& flat) {
  const std::vector<std::uint32_t> order = largestFirst(charts);
  std::size_t triangles = 0;
  const auto isKnown = [&](std::size_t i) { return !flat[i].unpacked.empty() && pins[i].empty(); };
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
    flat[order[i]] = flattenOne(chart, options, pins[order[i]], pool, goesOn);
    done += chart.triangleCount();
  });
}

std::vector<PackShape> shapesOf(const std::vector<DiskChart>& charts,
                                const std::vector<FlatChart>& flat) {
  std::vector<PackShape> shapes(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    shapes[i].isFixed = flat[i].isFixed();
    shapes[i].uv = flat[i].isFixed() ? flat[i].fixed : flat[i].unpacked;
    shapes[i].triangles = charts[i].vertexOfCorner;
    for (const std::uint32_t h : charts[i].boundary)
      shapes[i].outline.push_back(charts[i].vertexOfCorner[h]);
  }
  return shapes;
}

/// Charts that stay where they are must be inside the unit square.
Status checkFixed(const std::vector<DiskChart>& charts, const std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < flat.size(); ++i)
    for (std::size_t k = 0; k < flat[i].fixed.size(); ++k) {
      const double x = flat[i].fixed[k];
      if (x >= 0 && x <= 1) continue;
      return {StatusCode::InvalidOption,
              "the pins put vertex " + std::to_string(charts[i].inputVertex[k / 2]) +
                  " outside the unit square, where " + (k % 2 == 0 ? "u" : "v") + " is " +
                  std::to_string(x) + "; move the pins of its chart, or pin it smaller"};
    }
  return {};
}

/// Moves the layouts to their places.
void place(const Packing& packing, std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Placement& p = packing.placements[i];
    const std::vector<double>& from = flat[i].isFixed() ? flat[i].fixed : flat[i].unpacked;
    flat[i].uv.clear();
    for (std::size_t k = 0; k < from.size(); k += 2)
      flat[i].uv.insert(flat[i].uv.end(), {p.u(&from[k]), p.v(&from[k])});
  }
}

/// All charts in the atlas, rounded or as they are.
void checkAll(const std::vector<DiskChart>& charts, const UnwrapOptions& options, ThreadPool& pool,
              std::vector<FlatChart>& flat, std::vector<std::string>& notes) {
  const auto check = [&] {
    parallelFor(&pool, flat.size(), [&](std::size_t i) { checkInPlace(charts[i], flat[i]); });
  };
  if (!options.roundsToSingle && !options.roundsForGltf) return check();
  const std::vector<FlatChart> asTheyAre = flat;
  for (FlatChart& chart : flat) {
    if (!chart.isFixed())
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
  notes.push_back("texcoords are in double precision: rounded to single, " + std::to_string(lost) +
                  (lost == 1 ? " chart" : " charts") + " would not be valid");
}

/// Charts are factored in the order that was found for the whole surface. `place` is per fan.
void orderCharts(const Surface& surface, const std::vector<std::uint32_t>& place, ChartSet& set) {
  std::vector<std::uint32_t> ofVertex;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::uint32_t v = surface.fans.inputVertex[i];
    if (v >= ofVertex.size()) ofVertex.resize(v + 1);
    ofVertex[v] = place[i];
  }
  for (DiskChart& chart : set.charts)
    for (const std::uint32_t v : chart.inputVertex) chart.place.push_back(ofVertex[v]);
}

Seams seamsOf(const WeldedMesh& welded, const Surface& surface, Seams given,
              const UnwrapOptions& options, ThreadPool& pool, Monitor& monitor,
              UnwrapReport& report, std::vector<std::uint32_t>& place) {
  const SeamMesh mesh = makeSeamMesh(welded.mesh.positions, surface.table, surface.fans,
                                     surface.triangulation.isDiagonal);
  SeamOptions wanted;
  wanted.isAuto = options.seams.isAuto;
  wanted.maxStretch = options.maxStretch;
  wanted.pool = &pool;
  wanted.keepsOn = [&] { return monitor.tell(kSeams); };
  SeamReport found;
  Seams seams = findSeams(mesh, std::move(given), wanted, &found);
  report.seams.genus = surface.summary.genus;
  report.seams.relativeLength = found.seamLength;
  report.seams.handleLoops = found.handleLoops;
  for (const std::uint8_t isSeam : seams) report.seams.edges += isSeam;
  report.seams.edges /= 2;
  place = std::move(found.place);
  return seams;
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
  std::vector<std::uint32_t> placeOfFan;
  const Seams seams =
      seamsOf(welded, surface, std::move(given.value), options, pool, monitor, report, placeOfFan);
  if (monitor.stopped()) return aborted;
  ChartSet set = makeCharts(welded.mesh, surface, seams);
  orderCharts(surface, placeOfFan, set);
  const Texcoords texcoords = numberTexcoords(welded, surface, set);
  const Result<std::vector<std::vector<ChartPin>>> pins =
      pinsOfCharts(mesh, texcoords, options.pins);
  if (!pins.ok()) return pins.status;
  report.timings.seams = watch.lap();

  if (!monitor.tell(kSolve)) return aborted;
  Result<std::vector<FlatChart>> known = knownCharts({mesh, welded, surface, set}, options, pool);
  if (!known.ok()) return known.status;
  std::vector<FlatChart>& flat = known.value;
  flattenAll(set.charts, pins.value, options, pool, monitor, flat);
  if (monitor.stopped()) return aborted;
  report.timings.solve = watch.lap();

  if (!monitor.tell(kPack)) return aborted;
  if (Status s = checkFixed(set.charts, flat); !s.ok()) return s;
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
  checkAll(set.charts, options, pool, flat, report.notes);
  fillOutput(mesh, welded, surface, set, texcoords, flat, out);
  out.seams = seamEdges(mesh, welded, surface, seams);
  fillReport(set, flat, surface, welded, report);
  report.timings.check = watch.lap();
  return out;
}

}  // namespace abflat
