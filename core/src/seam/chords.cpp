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
      // Of a disk no triangle is met twice; were the chart none, the walk would still end.
      if (o == kNone || o / 3 == root || parent_[o / 3] != kNone || forest_.isTreeEdge(surface_, h))
        continue;
      parent_[o / 3] = o;
      order_.push_back(o / 3);
    }
  for (std::size_t i = order_.size(); i-- > 1;)
    area_[surface_.twin[parent_[order_[i]]] / 3] += area_[order_[i]];
}

void ChordFinder::numberLoop(std::uint32_t chart) {
  const BoundaryLoop loop = surface_.outline(chart);
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

/// h is kNone where it would cut off next to nothing or open a hole that stays filled.
Chord ChordFinder::chordAt(std::uint32_t h, std::uint32_t chart) const {
  constexpr double kLeastShare = 0.02;
  const double all = surface_.charts[chart].area;
  Chord c;
  c.left = area_[h / 3];
  c.right = all - c.left;
  c.length = forest_.distance[surface_.vertexOfCorner[h]] + mesh_.cost[h] +
             forest_.distance[surface_.vertexOfCorner[nextCorner(h)]];
  if (!(std::min(c.left, c.right) > kLeastShare * all) || !(c.length < kBarredCost)) return {};
  c.h = h;
  return c;
}

Chord ChordFinder::best(std::uint32_t chart,
                        const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  walk(chart);
  numberLoop(chart);
  Chord best;
  double bestScore = 0;
  for (std::size_t i = 1; i < order_.size(); ++i) {
    const std::uint32_t h = parent_[order_[i]];
    Chord c = chordAt(h, chart);
    if (c.h == kNone) continue;
    const double smaller = std::min(c.left, c.right);
    double score = c.length / std::sqrt(smaller);
    if (best.h != kNone && score >= bestScore) continue;
    constexpr double kUnresolved = 3;  // so much longer may a chord be that resolves all
    c.resolved = pairs.empty() ? 1 : resolvedShare(h, pairs);
    score *= 1 + (kUnresolved - 1) * (1 - c.resolved);
    if (best.h == kNone || score < bestScore) {
      best = c;
      bestScore = score;
    }
  }
  return best;
}

void markChord(const SeamMesh& mesh, const CutSurface& s, const PathForest& forest,
               const Chord& chord, Seams& seams) {
  markEdge(mesh, chord.h, seams);
  markPath(mesh, forest, s.vertexOfCorner[chord.h], seams);
  markPath(mesh, forest, s.vertexOfCorner[nextCorner(chord.h)], seams);
}

}  // namespace abflat
