#include "seam/run_images.h"

#include <algorithm>
#include <utility>

namespace abflat {

bool RunImages::has(const SharedRun& run) const {
  return mirror_ && std::all_of(run.edges.begin(), run.edges.end(),
                                [&](SurfaceCorner h) { return mirror_.hasImage(h); });
}

bool RunImages::isOn(const SharedRun& run, SurfaceCorner edge) const {
  return std::any_of(run.edges.begin(), run.edges.end(),
                     [&](SurfaceCorner h) { return edge == h || edge == mesh_.twin[h]; });
}

bool RunImages::isImageOn(const SharedRun& run, SurfaceCorner edge) const {
  bool out = mirror_.hasImage(edge);
  mirror_.forEachImage(edge, [&](SurfaceCorner i) { out = out && isOn(run, i); });
  return out;
}

bool RunImages::isOwn(const SharedRun& run) const {
  return mirror_ && std::all_of(run.edges.begin(), run.edges.end(),
                                [&](SurfaceCorner h) { return isImageOn(run, h); });
}

bool RunImages::isInPlane(const SharedRun& run) const {
  return mirror_ && std::all_of(run.edges.begin(), run.edges.end(), [&](SurfaceCorner h) {
           const SurfaceCorner image = mirror_.image[h];
           return image == h || image == mesh_.twin[h];
         });
}

SharedRun RunImages::inItself(const SharedRun& run) const {
  SharedRun out{run.a, run.b, {}, run.begin, 0, 0};
  for (const SurfaceCorner h : run.edges) {
    if (isImageOn(run, h))
      out.add(mesh_, h);
    else if (out.edges.empty())
      ++out.begin;
  }
  return out;
}

RunsTogether RunImages::together(const CutSurface& s, const Seams& kept,
                                 const SharedRun& run) const {
  if (!has(run) || isOwn(run)) return {run};
  // With the image of a on the left; the mirror turns its outline around.
  std::vector<SurfaceCorner> edges;
  for (const SurfaceCorner h : run.edges)
    mirror_.forEachImage(h, [&](SurfaceCorner i) { edges.push_back(mesh_.twin[i]); });
  std::reverse(edges.begin(), edges.end());
  CutChartId a = s.chartOf(edges.front()), b = s.chartOf(mesh_.twin[edges.front()]);
  if (a > b) {
    std::swap(a, b);
    std::reverse(edges.begin(), edges.end());
    for (SurfaceCorner& h : edges) h = mesh_.twin[h];
  }
  // Joined along both runs, two charts would be a ring.
  if (a == b || !s.charts[a].isDisk() || !s.charts[b].isDisk() || (a == run.a && b == run.b))
    return {};
  SharedRun image{a, b, {}, BoundaryIndex(0), 0, 0};
  for (const SurfaceCorner h : edges) {
    if (s.twin[h].exists() || s.chartOf(h) != a || chartBehind(mesh_, kept, s, h) != b) return {};
    image.add(mesh_, h);
  }
  const BoundaryLoop loop = s.outline(a);
  const auto first = std::find(loop.begin(), loop.end(), edges.front());
  image.begin = BoundaryIndex(first - loop.begin());
  return {run, std::move(image)};
}

}  // namespace abflat
