#include "unwrap/atlas.h"

#include <algorithm>
#include <utility>

#include "pack/outline.h"
#include "unwrap/rounding.h"
#include "unwrap/upward.h"

namespace abflat {
namespace {

/// Keeps coordinates below 16, which is what packing allows for.
constexpr int kMostTilesInSingle = 160;

/// Size of a chart beside those that need no other.
double sizeOf(const PackedCharts& packed, ChartId i) {
  return packed.charts.flat[i].enlarged * packed.density(i);
}

PackShape shapeOf(const ChartTopology& chart, const FlatChart& flat, const Point2& up,
                  double size) {
  PackShape out;
  out.isFixed = flat.isFixed;
  out.uv = flat.isFixed ? flat.uv : flat.unpacked;
  out.upU = up[0];
  out.upV = up[1];
  if (!flat.isFixed && size != 1)
    for (double& x : out.uv) x *= size;
  const auto corners = chart.vertexOfCorner.begin();
  out.triangles.assign(corners, corners + chart.surfaceCorners().size());
  // Other charts may lie in its holes.
  if (chart.filledHoles > 0 || flat.isGiven) return out;
  out.outline.reserve(chart.boundary.size());
  for (const ChartCorner h : chart.boundary) out.outline.push_back(chart.vertexOfCorner[h]);
  return out;
}

std::vector<PackShape> shapesOf(const PackedCharts& packed) {
  const auto& [set, flat] = packed.charts;
  std::vector<PackShape> out;
  out.reserve(set.size());
  for (const ChartId i : set.ids()) {
    const ChartTopology chart = set.topology(i);
    const Point2 upInUv = flat[i].isFixed
                              ? Point2{}
                              : upward(chart, flat[i].unpacked, packed.positions, packed.upAxis);
    out.push_back(shapeOf(chart, flat[i], upInUv, sizeOf(packed, i)));
  }
  return out;
}

/// Keeps what is needed to undo rounding. Packed charts can simply be placed again.
class BeforeRounding {
 public:
  explicit BeforeRounding(const FlatCharts& flat) {
    for (const FlatChart& chart : flat) {
      const bool isPinned = chart.isFixed && !chart.isGiven;
      uvOfPinned_.push_back(isPinned ? chart.uv : std::vector<double>());
      hadProblem_.push_back(!chart.problem.empty());
    }
  }

  /// The validity of charts that had no problem before has to be decided again.
  void restore(const Packing& packing, FlatCharts& flat) const {
    placeInAtlas(packing, flat);
    for (const ChartId i : flat.ids()) {
      if (!uvOfPinned_[i].empty()) flat[i].uv = uvOfPinned_[i];
      if (!hadProblem_[i]) flat[i].problem.clear();
    }
  }

 private:
  IdVector<ChartId, std::vector<double>> uvOfPinned_;  ///< empty for charts that are not pinned
  IdVector<ChartId, std::uint8_t> hadProblem_;
};

/// Texels per mesh unit of the charts that stay where they are, on average, less what they are
/// denser than others; 0 if there are none.
double densityOfFixed(const PackedCharts& packed, const std::vector<PackShape>& shapes,
                      const AtlasSize& resolution) {
  double inUv = 0, onSurface = 0;
  for (const ChartId i : packed.charts.flat.ids()) {
    const FlatChart& flat = packed.charts.flat[i];
    if (!flat.isFixed) continue;
    inUv += massOf(shapes[i]).area;
    onSurface += flat.area * packed.density(i) * packed.density(i);
  }
  if (!(onSurface > 0 && inUv > 0)) return 0;
  return resolution.meanSide() * std::sqrt(inUv / onSurface) / packed.unit;
}

/// Whether islands of the input stay: new charts get their texel density then, not all the room.
bool keepsIslands(const FlatCharts& flat) {
  return std::any_of(flat.begin(), flat.end(), [](const FlatChart& c) { return c.isGiven; });
}

bool areAllFixed(const FlatCharts& flat) {
  for (const FlatChart& chart : flat)
    if (!chart.isFixed) return false;
  return true;
}

/// Packs again with larger copies of the charts that need it, as long as everything fits.
void fitAll(const PackedCharts& packed, const UnwrapOptions& options, Numbers numbers,
            AtlasReport& atlas) {
  constexpr int kMostPackings = 4;
  for (int round = 0; round <= kMostPackings; ++round) {
    IdVector<ChartId, double> enlarged;
    enlarged.reserve(packed.charts.flat.size());
    for (const FlatChart& chart : packed.charts.flat) enlarged.push_back(chart.enlarged);
    const bool mayGrow = round < kMostPackings;
    if (fitToNumbers(packed, numbers, options.resolution, mayGrow) == 0) return;
    if (packAll(packed, options, {}, atlas).ok()) continue;
    // The charts keep their size, and the report says so.
    for (const ChartId i : enlarged.ids()) packed.charts.flat[i].enlarged = enlarged[i];
    placeInAtlas(packed.packing, packed.charts.flat);
    fitToNumbers(packed, numbers, options.resolution, false);
    return;
  }
}

}  // namespace

Status packAll(const PackedCharts& packed, const UnwrapOptions& options, const Listener& listener,
               AtlasReport& atlas, double formerDensity) {
  PackOptions how = packOptionsOf(options);
  how.unit = packed.unit;
  how.formerDensity = formerDensity;
  how.pool = &packed.pool;
  how.listener = listener;
  std::vector<PackShape> shapes = shapesOf(packed);
  how.work = usualWork(shapes);
  how.fixedMayLeave = options.reuse.keepsPlaces;
  const double fixedDensity = densityOfFixed(packed, shapes, options.resolution);
  if (options.reuse.keepsPlaces || keepsIslands(packed.charts.flat)) how.mostDensity = fixedDensity;
  Result<Packing> result = pack(std::move(shapes), how);
  if (!result.ok()) return result.status();
  Packing& packing = packed.packing;
  packing = std::move(result.value());
  for (const ChartId i : packed.charts.flat.ids()) {
    if (packed.charts.flat[i].isFixed) continue;
    packing.placements[i].a *= sizeOf(packed, i);
    packing.placements[i].b *= sizeOf(packed, i);
  }
  placeInAtlas(packing, packed.charts.flat);
  atlas.resolution = options.resolution.longer();
  atlas.width = options.resolution.width;
  atlas.height = options.resolution.height;
  atlas.padding = options.padding;
  atlas.margin = marginOf(options);
  atlas.tiles = static_cast<int>(packing.tiles);
  atlas.utilization = packing.utilization;
  // Nothing was packed, so that what was asked for says nothing of the layout.
  const bool isMeasured = fixedDensity > 0 && areAllFixed(packed.charts.flat);
  atlas.texelDensity = isMeasured ? fixedDensity : packing.texelDensity;
  return {};
}

std::vector<std::string> checkAll(const PackedCharts& packed, const UnwrapOptions& options,
                                  AtlasReport& atlas) {
  std::vector<std::string> notes;
  const bool isSingle = options.precision == Precision::Single;
  const bool isFine = atlas.tiles <= kMostTilesInSingle;
  if (isSingle && !isFine)
    notes.push_back("texcoords are in double precision: single precision is too coarse for " +
                    std::to_string(atlas.tiles) + " tiles");
  if (isSingle && isFine) {
    const BeforeRounding before(packed.charts.flat);
    const std::size_t lost = roundToSingle(packed.charts.set, packed.pool, packed.charts.flat);
    if (lost == 0) return fittingNotes(packed.charts.flat, Numbers::Gltf);
    before.restore(packed.packing, packed.charts.flat);
    notes.push_back("texcoords are in double precision: rounding to single would make " +
                    std::to_string(lost) + (lost == 1 ? " chart" : " charts") + " invalid");
  }
  const Numbers numbers = options.precision == Precision::Gltf ? Numbers::Gltf : Numbers::Double;
  fitAll(packed, options, numbers, atlas);
  for (std::string& note : fittingNotes(packed.charts.flat, numbers))
    notes.push_back(std::move(note));
  return notes;
}

}  // namespace abflat
