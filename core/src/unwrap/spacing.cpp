#include "unwrap/spacing.h"

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/number_text.h"
#include "base/point2.h"
#include "hole/fill_holes.h"
#include "seam/part_charts.h"
#include "unwrap/part_of_charts.h"

namespace abflat {
namespace {

/// The chart's outline in texels, in the atlas and, at the chart's mean scale, in space.
PlacedOutline placedOutline(const ChartTopology& chart, const FlatChart& flat,
                            const std::vector<double>& positions, const AtlasSize& resolution) {
  double twiceArea = 0;
  for (const ChartCorner c : chart.surfaceCorners()) {
    const Point2 a = pointAt(flat.uv, chart.vertexOfCorner[c]);
    const Point2 b = pointAt(flat.uv, chart.vertexOfCorner[nextCorner(c)]);
    twiceArea += a[0] * b[1] - a[1] * b[0];
  }
  const double scale = resolution.meanSide() * std::sqrt(std::max(twiceArea / 2, 0.0) / flat.area);
  PlacedOutline out;
  out.uv.reserve(2 * chart.boundary.size());
  out.positions.reserve(3 * chart.boundary.size());
  for (const ChartCorner h : chart.boundary) {
    const ChartVertex v = chart.vertexOfCorner[h];
    const auto [x, y] = pointAt(flat.uv, v);
    out.uv.insert(out.uv.end(), {resolution.width * x, resolution.height * y});
    const std::size_t at = 3 * std::size_t{chart.inputVertex[v]};
    for (std::size_t d = 0; d < 3; ++d) out.positions.push_back(scale * positions[at + d]);
  }
  return out;
}

/// Adds the chart's pairs of edges, at most so many, evenly spread: enough to tell how many a cut
/// separates.
void addPairs(const ChartTopology& chart, const NearParts& near,
              const IdVector<SurfaceCorner, SurfaceCorner>& inPart,
              std::vector<OutlinePair>& pairs) {
  constexpr std::size_t kMost = 256;
  const std::size_t step = (near.edges.size() + kMost - 1) / kMost;
  const auto edge = [&](std::uint32_t i) {
    return inPart[chart.onSurface(chart.boundary[BoundaryIndex(i)])];
  };
  for (std::size_t i = 0; i < near.edges.size(); i += step)
    pairs.push_back({edge(near.edges[i][0]), edge(near.edges[i][1])});
}

std::string remedy(const UnwrapOptions& options, bool isFixed) {
  if (isFixed) return "charts that are pinned or kept are not cut";
  if (!options.seams.isAuto) return "charts are cut there only if seams are automatic";
  if (options.t != kAutoT) return "charts are cut there only if t is auto";
  if (options.straightSeams) return "with straight seams, charts are not cut there";
  return "no cut was found whose pieces fit. A higher resolution or less padding helps";
}

}  // namespace

IdVector<ChartId, NearParts> nearPartsOf(const PackedCharts& packed,
                                         const UnwrapOptionValues& options) {
  const ChartSet& set = packed.charts.set;
  const FlatCharts& flat = packed.charts.flat;
  IdVector<ChartId, NearParts> out(set.size());
  if (options.padding == 0) return out;
  parallelFor(&packed.pool, set.size(), [&](std::size_t k) {
    const ChartId i(k);
    const ChartTopology chart = set.topology(i);
    // An outline that crosses itself is told of otherwise; what is projected is as near in space.
    if (!flat[i].problem.empty() || flat[i].solver == Solver::Projection) return;
    out[i] = findNearParts(placedOutline(chart, flat[i], packed.positions, options.resolution),
                           options.padding);
  });
  return out;
}

bool cutBetween(const LaidCharts& charts, const IdVector<ChartId, NearParts>& near,
                const UnwrapOptionValues& options, OpenSurface& open) {
  IdVector<ChartId, std::uint8_t> isCut;
  for (const ChartId i : near.ids())
    isCut.push_back(!near[i].edges.empty() && !charts.flat[i].isFixed);
  if (std::find(isCut.begin(), isCut.end(), 1) == isCut.end()) return false;
  open.seams.resize(open.mesh.twin.size(), 0);
  const SeamPart part = partOfCharts(charts, open, isCut);
  const IdVector<SurfaceCorner, SurfaceCorner> inPart = part.cornersInPart(open.mesh.twin.size());
  std::vector<OutlinePair> pairs;
  for (const ChartId i : isCut.ids())
    if (isCut[i]) addPairs(charts.set.topology(i), near[i], inPart, pairs);
  Seams seams = part.ofCorners(open.seams);
  for (const SurfaceCorner h : seams.ids()) seams[h] = seams[h] && part.mesh.twin[h].exists();
  if (!partCharts(part.mesh, pairs, seams)) return false;
  for (const SurfaceCorner h : seams.ids())
    if (seams[h]) open.seams[part.wholeHalfEdge[h]] = 1;
  openTouchedHoles(open.mesh, cutAlong(open.mesh, open.seams), options.fillHoles, open.seams);
  return true;
}

std::string spacingNote(const CutMesh& mesh, const FlatCharts& flat,
                        const IdVector<ChartId, NearParts>& near, const UnwrapOptions& options) {
  std::size_t count = 0;
  ChartId worst(0);
  for (const ChartId i : near.ids()) {
    if (near[i].edges.empty()) continue;
    if (count++ == 0 || near[i].gap < near[worst].gap) worst = i;
  }
  if (count == 0) return {};
  const ChartTopology chart = mesh.set.topology(worst);
  const ChartCorner h = chart.boundary[BoundaryIndex(near[worst].point)];
  const std::uint32_t face{mesh.map.face(triangleOf(chart.onSurface(h)))};
  return "parts of " + counted(count, "chart", "charts") +
         " that are far apart on the surface are nearer to each other in the atlas than the "
         "padding, down to " +
         withDigits(near[worst].gap, 2) + " texels at face " + std::to_string(face) + ": " +
         remedy(options, flat[worst].isFixed);
}

}  // namespace abflat
