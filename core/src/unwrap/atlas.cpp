#include "unwrap/atlas.h"

#include <algorithm>
#include <utility>

#include "unwrap/rounding.h"

namespace abflat {
namespace {

/// Coordinates below 16, which is what packing allows for.
constexpr int kMostTilesInSingle = 160;

std::vector<PackShape> shapesOf(const ChartSet& charts, const FlatCharts& flat) {
  std::vector<PackShape> shapes(charts.size());
  for (const ChartId i : charts.ids()) {
    shapes[i].isFixed = flat[i].isFixed;
    shapes[i].uv = flat[i].isFixed ? flat[i].uv : flat[i].unpacked;
    if (!flat[i].isFixed && flat[i].enlarged != 1)
      for (double& x : shapes[i].uv) x *= flat[i].enlarged;
    const ChartTopology chart = charts.topology(i);
    const auto corners = chart.vertexOfCorner.begin();
    shapes[i].triangles.assign(corners, corners + chart.surfaceCorners().size());
    // Others may lie in its holes.
    if (chart.filledHoles > 0 || flat[i].isGiven) continue;
    shapes[i].outline.reserve(chart.boundary.size());
    for (const ChartCorner h : chart.boundary) shapes[i].outline.push_back(chart.vertexOfCorner[h]);
  }
  return shapes;
}

/// What is needed to undo rounding. Charts that were packed can be placed once more.
class BeforeRounding {
 public:
  explicit BeforeRounding(const FlatCharts& flat) {
    for (const FlatChart& chart : flat) {
      const bool isPinned = chart.isFixed && !chart.isGiven;
      uvOfPinned_.push_back(isPinned ? chart.uv : std::vector<double>());
      hadProblem_.push_back(!chart.problem.empty());
    }
  }

  /// Validity of all without a problem has to be decided anew.
  void restore(const Packing& packing, FlatCharts& flat) const {
    placeInAtlas(packing, flat);
    for (const ChartId i : flat.ids()) {
      if (!uvOfPinned_[i].empty()) flat[i].uv = uvOfPinned_[i];
      if (!hadProblem_[i]) flat[i].problem.clear();
    }
  }

 private:
  std::vector<std::vector<double>> uvOfPinned_;  ///< empty for others
  std::vector<bool> hadProblem_;
};

/// What packing may look at, in the unit of PackOptions: per triangle so much that it takes less
/// time than flattening, but enough for a good packing of the smallest meshes. Where charts have
/// been cut for it, it is to be as good as was expected.
double packWork(const std::vector<PackShape>& shapes, bool isCut) {
  constexpr double kWorkOfCorner = 10, kLeastWork = 4000, kLeastOfCut = 100000;
  double corners = 0;
  for (const PackShape& shape : shapes) corners += static_cast<double>(shape.triangles.size());
  return std::max(kWorkOfCorner * corners, isCut ? kLeastOfCut : kLeastWork);
}

/// Packs again what has to be larger, as long as it fits.
void fitAll(const ChartSet& charts, const UnwrapOptionValues& options, double unit, Numbers numbers,
            ThreadPool& pool, FlatCharts& flat, Packing& packing, AtlasReport& atlas) {
  constexpr int kMostPackings = 4;
  for (int round = 0; round <= kMostPackings; ++round) {
    std::vector<double> enlarged;
    enlarged.reserve(flat.size());
    for (const FlatChart& chart : flat) enlarged.push_back(chart.enlarged);
    const bool mayGrow = round < kMostPackings;
    if (fitToNumbers(charts, numbers, options.resolution, mayGrow, pool, packing, flat) == 0)
      return;
    const auto tell = [](double) { return true; };
    if (packAll(charts, options, unit, pool, tell, flat, packing, atlas).ok()) continue;
    // They stay as they are, and say so.
    for (const ChartId i : flat.ids()) flat[i].enlarged = enlarged[i];
    placeInAtlas(packing, flat);
    fitToNumbers(charts, numbers, options.resolution, false, pool, packing, flat);
    return;
  }
}

}  // namespace

Status packAll(const ChartSet& charts, const UnwrapOptionValues& options, double unit,
               ThreadPool& pool, const std::function<bool(double)>& tell, FlatCharts& flat,
               Packing& packing, AtlasReport& atlas) {
  PackOptions how;
  how.resolution = options.resolution;
  how.padding = options.padding;
  how.rotate = options.rotate;
  how.texelDensity = options.texelDensity;
  how.udim = options.udim;
  how.unit = unit;
  how.pool = &pool;
  how.progress = tell;
  std::vector<PackShape> shapes = shapesOf(charts, flat);
  how.work = packWork(shapes, atlas.packingCuts > 0);
  Result<Packing> packed = pack(std::move(shapes), how);
  if (!packed.ok()) return packed.status;
  packing = std::move(packed.value);
  for (const ChartId i : flat.ids()) {
    if (flat[i].isFixed) continue;
    packing.placements[i].a *= flat[i].enlarged;
    packing.placements[i].b *= flat[i].enlarged;
  }
  placeInAtlas(packing, flat);
  atlas.resolution = options.resolution;
  atlas.padding = options.padding;
  atlas.tiles = static_cast<int>(packing.tiles);
  atlas.utilization = packing.utilization;
  atlas.texelDensity = packing.texelDensity;
  return {};
}

void checkAll(const ChartSet& charts, const UnwrapOptions& options, double unit, ThreadPool& pool,
              FlatCharts& flat, Packing& packing, UnwrapReport& report) {
  const bool isSingle = options.roundsToSingle && !options.roundsForGltf;
  const bool isFine = report.atlas.tiles <= kMostTilesInSingle;
  if (isSingle && !isFine)
    report.notes.push_back(
        "texcoords are in double precision: single precision is too coarse for " +
        std::to_string(report.atlas.tiles) + " tiles");
  if (isSingle && isFine) {
    const BeforeRounding before(flat);
    const std::size_t lost = roundToSingle(charts, pool, flat);
    if (lost == 0) return;
    before.restore(packing, flat);
    report.notes.push_back("texcoords are in double precision: rounding to single would make " +
                           std::to_string(lost) + (lost == 1 ? " chart" : " charts") + " invalid");
  }
  const Numbers numbers = options.roundsForGltf ? Numbers::Gltf : Numbers::Double;
  fitAll(charts, options, unit, numbers, pool, flat, packing, report.atlas);
  for (std::string& note : fittingNotes(flat, numbers)) report.notes.push_back(std::move(note));
}

}  // namespace abflat
