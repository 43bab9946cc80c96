#include "unwrap/certificate.h"

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

}  // namespace

void certify(const PolygonMesh& input, const WeldedMesh& welded, Numbers numbers,
             UnwrapResult& result) {
  const std::vector<double> uv = writtenUv(result.uv, numbers);
  std::vector<std::uint32_t> triangles;
  triangles.reserve(result.triangleCorners.size());
  for (const std::uint32_t corner : result.triangleCorners)
    triangles.push_back(result.cornerUv[corner]);
  const auto hasArea = [&](std::size_t t) {
    std::array<std::uint32_t, 3> v{};
    for (std::size_t k = 0; k < 3; ++k)
      v[k] =
          welded.firstAtPlace[InputVertex(input.faceVertices[result.triangleCorners[3 * t + k]])];
    return !isDegenerate(cornerAngles(welded.mesh.positions, v));
  };
  WrittenAtlas atlas{uv, triangles, result.chartOfTriangle, hasArea, {}, {}, 1, 0};
  for (const UnwrapChart& chart : result.report.charts) {
    atlas.isLeftOut.push_back(!chart.valid);
    atlas.mayTouch.push_back(chart.fixed);
  }
  atlas.tiles = static_cast<std::uint32_t>(result.report.atlas.tiles);
  atlas.lowestV = numbers == Numbers::Gltf ? -1 : 0;
  for (const ChartDefect& defect : checkAtlas(atlas)) {
    UnwrapChart& row = result.report.charts[defect.chart];
    if (row.valid) row.problem = problemOf(defect, result.report.charts);
    row.valid = result.report.valid = false;
  }
}

std::string foldedFansNote(const PolygonMesh& input, const UnwrapResult& result) {
  const auto at = [&](std::uint32_t corner) {
    return &result.uv[2 * std::size_t{result.cornerUv[corner]}];
  };
  std::size_t count = 0;
  for (std::size_t f = 0; f < input.faceCount(); ++f) {
    const std::uint32_t begin = input.faceOffsets[f], end = input.faceOffsets[f + 1];
    bool isFolded = false;
    for (std::uint32_t c = begin + 1; c + 1 < end && end - begin > 3; ++c)
      isFolded = isFolded || orientation(at(begin), at(c), at(c + 1)) < 0;
    count += isFolded;
  }
  if (count == 0) return {};
  return std::to_string(count) + (count == 1 ? " polygon folds" : " polygons fold") +
         " over when triangulated as a fan from the first corner; glTF output contains the "
         "triangles that were checked";
}

}  // namespace abflat
