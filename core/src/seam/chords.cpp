#include "seam/chords.h"

#include <algorithm>
#include <cmath>

namespace abflat {

ChordFinder::ChordFinder(const SeamMesh& mesh, const CutSurface& surface, const PathForest& forest)
    : mesh_(mesh),
      surface_(surface),
      forest_(forest),
      parent_(mesh.triangleCount(), kNone),
      area_(mesh.area),
      place_(surface.vertexCount(), kNone) {}

void ChordFinder::walk(std::uint32_t chart) {
  const std::uint32_t root = surface_.charts[chart].firstTriangle;
  order_.assign(1, root);
  parent_[root] = kNone;
  for (std::size_t i = 0; i < order_.size(); ++i)
    for (std::uint32_t h = 3 * order_[i]; h < 3 * order_[i] + 3; ++h) {
      const std::uint32_t o = surface_.twin[h];
      if (o == kNone || h == parent_[order_[i]] || forest_.isTreeEdge(surface_, h)) continue;
      parent_[o / 3] = o;
      order_.push_back(o / 3);
    }
  for (std::size_t i = order_.size(); i-- > 1;)
    area_[surface_.twin[parent_[order_[i]]] / 3] += area_[order_[i]];
}

void ChordFinder::numberLoop(std::uint32_t chart) {
  const std::vector<std::uint32_t>& loop = surface_.loops[surface_.charts[chart].loopBegin];
  for (std::size_t i = 0; i < loop.size(); ++i)
    place_[surface_.vertexOfCorner[loop[i]]] = static_cast<std::uint32_t>(i);
}

/// Of the pairs, those whose half-edges end up in different charts.
double ChordFinder::resolvedShare(std::uint32_t h,
                                  const std::vector<std::array<std::uint32_t, 2>>& pairs) const {
  const auto placeOf = [&](std::uint32_t corner) {
    return place_[forest_.source[surface_.vertexOfCorner[corner]]];
  };
  const std::pair<std::uint32_t, std::uint32_t> ends =
      std::minmax(placeOf(h), placeOf(nextCorner(h)));
  const auto isBetween = [&](std::uint32_t i) { return i >= ends.first && i < ends.second; };
  std::size_t resolved = 0;
  for (const auto& pair : pairs) resolved += isBetween(pair[0]) != isBetween(pair[1]);
  return static_cast<double>(resolved) / static_cast<double>(pairs.size());
}

Chord ChordFinder::best(std::uint32_t chart,
                        const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  walk(chart);
  numberLoop(chart);
  constexpr double kLeastShare = 0.02;
  const double all = surface_.charts[chart].area;
  Chord best;
  double bestScore = 0;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const std::uint32_t h = parent_[order_[i]];
    Chord c;
    c.h = h;
    c.left = area_[order_[i]];
    c.right = all - c.left;
    const double smaller = std::min(c.left, c.right);
    if (!(smaller > kLeastShare * all)) continue;
    c.length = forest_.distance[surface_.vertexOfCorner[h]] + mesh_.cost[h] +
               forest_.distance[surface_.vertexOfCorner[nextCorner(h)]];
    double score = c.length / std::sqrt(smaller);
    if (best.h != kNone && score >= bestScore) continue;
    constexpr double kUnresolved = 3;  // so much longer may a chord be that resolves all
    if (!pairs.empty()) score *= 1 + (kUnresolved - 1) * (1 - resolvedShare(h, pairs));
    if (best.h == kNone || score < bestScore) {
      best = c;
      bestScore = score;
    }
  }
  return best;
}

}  // namespace abflat
