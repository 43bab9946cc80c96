#include "unwrap/pinned.h"

#include <utility>

#include "base/number_text.h"
#include "base/point2.h"
#include "exact/overlap.h"
#include "unwrap/straight_seams.h"

namespace abflat {
namespace {

Status outside(InputVertex vertex, std::size_t coordinate, double value) {
  char digits[kMostDoubleChars];
  return {StatusCode::InvalidOption,
          "the pins push vertex " + std::to_string(vertex) +
              " outside the unit square: " + (coordinate % 2 == 0 ? "u" : "v") + " is " +
              std::string(digits, writeDouble(digits, value)) +
              ". Move the pins of its chart inward or closer together"};
}

}  // namespace

Result<IdVector<ChartId, ChartConstraints>> chartConstraints(const CutMesh& mesh,
                                                             const Texcoords& texcoords,
                                                             const FixedTriangles& fixed,
                                                             const UnwrapOptions& options) {
  IdVector<ChartId, ChartConstraints> out(mesh.set.size());
  Result<IdVector<ChartId, std::vector<ChartPin>>> pins =
      pinsOfCharts(mesh.map.input(), texcoords, options.pins);
  if (!pins.ok()) return pins.status();
  for (const ChartId i : out.ids()) out[i].pins = std::move(pins.value()[i]);
  if (!options.straightSeams) return out;
  const Surface& surface = mesh.map.surface();
  IdVector<ChartId, StraightSeams> straight =
      straightSeams(surface, mesh.set, findOutlines(surface, mesh.set), fixed.isFixed);
  for (const ChartId i : out.ids()) {
    out[i].straight = std::move(straight[i].places);
    out[i].released = straight[i].released;
  }
  return out;
}

Status checkUnpinned(const ChartSet& charts, const IdVector<ChartId, ChartConstraints>& constraints,
                     const FlatCharts& flat) {
  for (const ChartId i : charts.ids())
    if (flat[i].isGiven && !constraints[i].pins.empty())
      return {
          StatusCode::InvalidOption,
          "vertex " +
              std::to_string(
                  charts.topology(i).inputVertex[ChartVertex(constraints[i].pins.front().vertex)]) +
              " is pinned, but its chart keeps its texcoords. Remove the pin, or do not keep "
              "the chart"};
  return {};
}

Status checkPinned(const CutMesh& mesh, const UnwrapOptions& options, const FlatCharts& flat) {
  std::vector<double> triangles;  // 6 coordinates each
  std::vector<InputFace> faces;   // one per triangle
  for (const ChartId i : flat.ids()) {
    if (!flat[i].isFixed || flat[i].isStacked || (flat[i].isGiven && options.reuse.keepsPlaces))
      continue;
    const ChartTopology chart = mesh.set.topology(i);
    const std::vector<double>& uv = flat[i].uv;
    for (std::size_t k = 0; k < uv.size() && !flat[i].isGiven; ++k)
      if (!(uv[k] >= 0 && uv[k] <= 1))
        return outside(chart.inputVertex[ChartVertex(k / 2)], k, uv[k]);
    if (!flat[i].problem.empty()) continue;  // it overlaps itself, which its problem already says
    for (const SurfaceTriangle f : chart.triangles) faces.push_back(mesh.map.face(f));
    for (const ChartCorner c : chart.surfaceCorners()) {
      const Point2 p = pointAt(uv, chart.vertexOfCorner[c]);
      triangles.insert(triangles.end(), p.begin(), p.end());
    }
  }
  const auto pair = findOverlap(triangles);
  if (!pair) return {};
  return {StatusCode::InvalidOption, "the pins make faces " + std::to_string(faces[(*pair)[0]]) +
                                         " and " + std::to_string(faces[(*pair)[1]]) +
                                         " overlap. Move the pins of their charts apart"};
}

}  // namespace abflat
