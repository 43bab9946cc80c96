#include "unwrap/pinned.h"

#include <utility>

#include "base/number_text.h"
#include "exact/overlap.h"
#include "unwrap/straight_seams.h"

namespace abflat {
namespace {

Status outside(const ChartTopology& chart, std::size_t coordinate, double value) {
  char digits[kMostDoubleChars];
  return {StatusCode::InvalidOption,
          "the pins put vertex " + std::to_string(chart.inputVertex[coordinate / 2]) +
              " outside the unit square, where " + (coordinate % 2 == 0 ? "u" : "v") + " is " +
              std::string(digits, writeDouble(digits, value)) +
              "; move the pins of its chart, or nearer to each other"};
}

}  // namespace

Result<std::vector<ChartWishes>> chartWishes(const CutMesh& mesh, const Texcoords& texcoords,
                                             const FixedTriangles& fixed,
                                             const UnwrapOptions& options) {
  std::vector<ChartWishes> out(mesh.set.size());
  Result<std::vector<std::vector<ChartPin>>> pins =
      pinsOfCharts(mesh.input, texcoords, options.pins);
  if (!pins.ok()) return pins.status;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].pins = std::move(pins.value[i]);
  if (!options.straightSeams) return out;
  std::vector<StraightSeams> straight =
      straightSeams(mesh.surface, mesh.set, findOutlines(mesh.surface, mesh.set), fixed.isFixed);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].straight = std::move(straight[i].places);
    out[i].released = straight[i].released;
  }
  return out;
}

Status checkUnpinned(const ChartSet& charts, const std::vector<ChartWishes>& wishes,
                     const std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < charts.size(); ++i)
    if (flat[i].isGiven && !wishes[i].pins.empty())
      return {StatusCode::InvalidOption,
              "vertex " +
                  std::to_string(charts.topology(i).inputVertex[wishes[i].pins.front().vertex]) +
                  " is pinned, but its chart is to keep its texcoords; leave one of them out"};
  return {};
}

Status checkPinned(const CutMesh& mesh, const std::vector<FlatChart>& flat) {
  std::vector<double> triangles;     // 6 coordinates each
  std::vector<std::uint32_t> faces;  // of the input, for each of these
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (!flat[i].isFixed) continue;
    const ChartTopology chart = mesh.set.topology(i);
    const Indices own = mesh.set.triangles(i);
    const std::vector<double>& uv = flat[i].uv;
    for (std::size_t k = 0; k < uv.size() && !flat[i].isGiven; ++k)
      if (!(uv[k] >= 0 && uv[k] <= 1)) return outside(chart, k, uv[k]);
    if (!flat[i].problem.empty()) continue;  // it overlaps itself, and says so
    for (const std::uint32_t t : own)
      faces.push_back(mesh.welded.inputFace[mesh.surface.triangulation.face[t]]);
    for (std::size_t c = 0; c < 3 * own.size(); ++c) {
      const std::size_t v = chart.vertexOfCorner[c];
      triangles.insert(triangles.end(), {uv[2 * v], uv[2 * v + 1]});
    }
  }
  const auto pair = findOverlap(triangles);
  if (!pair) return {};
  return {StatusCode::InvalidOption, "the pins put faces " + std::to_string(faces[(*pair)[0]]) +
                                         " and " + std::to_string(faces[(*pair)[1]]) +
                                         " on each other; move the pins of their charts apart"};
}

}  // namespace abflat
