#include "unwrap/certificate.h"

#include <algorithm>
#include <cmath>

#include "check/atlas_check.h"
#include "exact/orientation.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Texcoords as readers get them. Those of a glTF have v flipped, which makes it point upwards
/// again without rounding.
std::vector<double> writtenUv(const std::vector<double>& uv, Numbers numbers) {
  std::vector<double> out = uv;
  if (numbers != Numbers::Gltf) return out;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = i % 2 == 0 ? static_cast<float>(out[i]) : -static_cast<float>(1 - out[i]);
  return out;
}

std::string problemOf(const ChartDefect& defect, const std::vector<UnwrapChart>& charts) {
  // A chart that was laid out here is valid before that; one that stays may be anywhere.
  const std::string cause =
      charts[defect.chart].fixed ? "" : " after rounding to the precision of the file";
  if (defect.kind == ChartDefect::Flipped)
    return std::to_string(defect.triangles) +
           (defect.triangles == 1 ? " triangle is" : " triangles are") + " flipped or degenerate" +
           cause;
  if (defect.kind == ChartDefect::Outside) return "it extends beyond its tile" + cause;
  if (defect.other == defect.chart) return "its boundary touches or crosses itself" + cause;
  return "it touches or overlaps the chart containing face " +
         std::to_string(charts[defect.other].firstFace) + " in the atlas";
}

/// Twice the area that charts cover which stay where they are, on others.
double repeatedArea(const WrittenAtlas& atlas, const std::vector<UnwrapChart>& charts) {
  double sum = 0;
  for (std::size_t t = 0; t < atlas.chartOf.size(); ++t) {
    const std::uint32_t c = atlas.chartOf[t];
    if (c >= charts.size() || !charts[c].fixed || atlas.stacked[c].on == kOnNone) continue;
    const auto p = pointsOf(
        atlas.uv, {atlas.triangles[3 * t], atlas.triangles[3 * t + 1], atlas.triangles[3 * t + 2]});
    sum += std::abs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                    (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
  }
  return sum;
}

void reportStacked(const WrittenAtlas& atlas, UnwrapReport& report) {
  std::vector<std::uint8_t> isBelow(atlas.stacked.size(), 0);
  for (std::size_t c = 0; c < atlas.stacked.size(); ++c) {
    const StackedChart& chart = atlas.stacked[c];
    if (chart.on == kOnNone) continue;
    report.charts[c].stackedOn = static_cast<int>(chart.on);
    report.charts[c].mirrored = chart.isMirrored;
    isBelow[chart.on] = 1;
    ++report.atlas.stackedCharts;
    report.atlas.stackedMirrored += chart.isMirrored;
  }
  report.atlas.stackedPlaces =
      static_cast<int>(std::count(isBelow.begin(), isBelow.end(), std::uint8_t{1}));
  report.atlas.utilization -= repeatedArea(atlas, report.charts) / 2 / report.atlas.tiles;
}

}  // namespace

void certify(const InputMesh& input, const WeldedMesh& welded, Numbers numbers,
             UnwrapResult& result) {
  const std::vector<double> uv = writtenUv(result.uv, numbers);
  std::vector<std::uint32_t> triangles;
  triangles.reserve(result.triangleCorners.size());
  for (const std::uint32_t corner : result.triangleCorners)
    triangles.push_back(result.cornerUv[corner]);
  const auto hasArea = [&](std::size_t t) {
    std::array<std::uint32_t, 3> v{};
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = welded.firstAtPlace[InputVertex(input.vertex(result.triangleCorners[3 * t + k]))];
    return !isDegenerate(cornerAngles(welded.mesh.positions, v));
  };
  WrittenAtlas atlas{uv, triangles, result.chartOfTriangle, hasArea, {}, {}, 1, 0, {}};
  for (const UnwrapChart& chart : result.report.charts) {
    atlas.isLeftOut.push_back(!chart.valid);
    atlas.mayTouch.push_back(chart.fixed);
  }
  atlas.tiles = static_cast<std::uint32_t>(result.report.atlas.tiles);
  atlas.lowestV = numbers == Numbers::Gltf ? -1 : 0;
  const Stack stack = result.report.options.stack;
  if (stack != Stack::None) {
    atlas.stacked = findStackedCharts(uv, triangles, result.chartOfTriangle,
                                      result.report.charts.size(), stack == Stack::Mirrored);
    reportStacked(atlas, result.report);
  }
  for (const ChartDefect& defect : checkAtlas(atlas)) {
    UnwrapChart& row = result.report.charts[defect.chart];
    if (row.valid) row.problem = problemOf(defect, result.report.charts);
    row.valid = result.report.valid = false;
  }
}

std::string foldedFansNote(const InputMesh& input, const UnwrapResult& result) {
  const auto at = [&](std::uint32_t corner) {
    return &result.uv[2 * std::size_t{result.cornerUv[corner]}];
  };
  std::size_t count = 0;
  for (std::size_t f = 0; f < input.faceCount(); ++f) {
    const std::uint32_t begin = input.firstCorner(f), end = input.firstCorner(f + 1);
    const std::uint32_t chart = result.chartOfFace[f];
    const int side = chart != kNoChart && result.report.charts[chart].mirrored ? -1 : 1;
    bool isFolded = false;
    for (std::uint32_t c = begin + 1; c + 1 < end && end - begin > 3; ++c)
      isFolded = isFolded || side * orientation(at(begin), at(c), at(c + 1)) < 0;
    count += isFolded;
  }
  if (count == 0) return {};
  return std::to_string(count) + (count == 1 ? " polygon folds" : " polygons fold") +
         " over when triangulated as a fan from the first corner; glTF output contains the "
         "triangles that were checked";
}

}  // namespace abflat
