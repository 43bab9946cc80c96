#include "unwrap_atlas.h"

#include <algorithm>
#include <utility>

#include "round_texcoords.h"

namespace abflat {
namespace {

/// Coordinates below 16, which is what packing allows for.
constexpr int kMostTilesInSingle = 160;

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

/// What packing may look at, in the unit of PackOptions: per triangle so much that it takes less
/// time than flattening, but enough for a good packing of the smallest meshes.
double packWork(const std::vector<PackShape>& shapes) {
  constexpr double kWorkOfCorner = 10, kLeastWork = 4000;
  double corners = 0;
  for (const PackShape& shape : shapes) corners += static_cast<double>(shape.triangles.size());
  return std::max(kWorkOfCorner * corners, kLeastWork);
}

}  // namespace

Status packAll(const std::vector<DiskChart>& charts, const UnwrapOptionValues& options,
               ThreadPool& pool, const std::function<bool(double)>& tell,
               std::vector<FlatChart>& flat, Packing& packing, AtlasReport& atlas) {
  PackOptions how;
  how.resolution = options.resolution;
  how.padding = options.padding;
  how.rotate = options.rotate;
  how.texelDensity = options.texelDensity;
  how.udim = options.udim;
  how.pool = &pool;
  how.progress = tell;
  const std::vector<PackShape> shapes = shapesOf(charts, flat);
  how.work = packWork(shapes);
  Result<Packing> packed = pack(shapes, how);
  if (!packed.ok()) return packed.status;
  packing = std::move(packed.value);
  place(packing, flat);
  atlas = {options.resolution, options.padding, static_cast<int>(packing.tiles),
           packing.utilization, packing.texelDensity};
  return {};
}

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

}  // namespace abflat
