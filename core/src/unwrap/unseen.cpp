#include "unwrap/unseen.h"

#include <cmath>
#include <string>

#include "base/long_sum.h"
#include "base/parallel.h"
#include "check/distortion.h"
#include "mesh/triangle_geometry.h"
#include "unwrap/expected_density.h"

namespace abflat {
namespace {

constexpr double kUnseenTexels = 2;

/// Length of a texel on the surface, in units of the welded mesh.
double texelOn(const WeldedMesh& welded, const CornerTable& table, const UnwrapOptions& options,
               double unit) {
  LongSum area;
  for (const SurfaceTriangle f : table.triangles())
    area.add(areaOf(welded.mesh.positions, verticesOf(table.vertex, f)));
  return 1 / expectedDensity(options, area.value(), unit);
}

}  // namespace

double fineLength(const WeldedMesh& welded, const CornerTable& table, const UnwrapOptions& options,
                  double unit) {
  constexpr double kFineTexels = 8;
  return kFineTexels * texelOn(welded, table, options, unit);
}

Smoothed withoutUnseen(const WeldedMesh& welded, const Surface& surface,
                       const UnwrapOptions& options, double unit, const Listener& listener) {
  const double reach = kUnseenTexels * texelOn(welded, surface.table, options, unit);
  return smoothNoise(welded.mesh, surface, reach, listener);
}

std::string unseenNote(const Smoothed& smoothed) {
  if (smoothed.triangles == 0) return {};
  return "steps and grain of less than " + std::to_string(static_cast<int>(kUnseenTexels)) +
         " texels in " + std::to_string(smoothed.triangles) +
         (smoothed.triangles == 1 ? " triangle" : " triangles") +
         " are taken for smooth by seams, flattening and the bound on stretch";
}

void measureUnseen(const ChartSet& set, const IdVector<ChartId, ChartId>& modelOf,
                   const std::vector<double>& smoothed, const std::vector<double>& positions,
                   ThreadPool& pool, FlatCharts& flat) {
  const auto isMoved = [&](ChartId i) {
    for (const InputVertex v : set.topology(i).inputVertex)
      for (std::size_t d = 0; d < 3; ++d)
        if (smoothed[3 * std::size_t{v} + d] != positions[3 * std::size_t{v} + d]) return true;
    return false;
  };
  parallelFor(&pool, set.size(), [&](std::size_t k) {
    const ChartId i(k);
    if (!isMoved(modelOf.empty() ? i : modelOf[i])) return;
    const DiskChart chart = set.chart(i);
    const double area = areaOf(chart);
    std::vector<double> uv = flat[i].unpacked;
    if (flat[i].area > 0)
      for (double& x : uv) x *= std::sqrt(area / flat[i].area);
    flat[i].area = area;
    flat[i].distortion = ChartDistortion(measureDistortion(chart, inChartUnit(chart, uv)));
  });
}

}  // namespace abflat
