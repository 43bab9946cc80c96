#include "solve/cholesky/separator.h"

#include <algorithm>
#include <numeric>

#include "base/stable_order.h"
#include "solve/cholesky/coarsen.h"

namespace abflat {
namespace {

constexpr std::uint32_t kUnreached = 0xffffffffu;
/// Rounds in which the difference of distances is averaged with the neighbours': straightens the
/// steps of a distance that counts edges.
constexpr int kSmoothingRounds = 3;
/// Graphs of at most this size are cut without coarsening: 3 % more work for the factorisation, a
/// quarter less for the ordering.
constexpr std::uint32_t kMediumGraph = 4000;
/// Coarsening ends at this size, and the coarsest graph is cut from several places.
constexpr std::uint32_t kSmallGraph = 120;
constexpr std::uint32_t kTries = 3;
/// A graph of about 1/16 of the size is cut several times: its cuts have nearly the final length,
/// at little cost.
constexpr int kLevelOfTries = 2;
constexpr std::uint32_t kCoarseTries = 6;
/// Coarsening stops when it leaves more than this share of the vertices.
constexpr double kLeastShrinking = 0.8;

/// Edges from `start`; `visited` gets the reached vertices in the order of their distance.
void distancesFrom(const WeightedGraph& g, std::uint32_t start,
                   std::vector<std::uint32_t>& distance, std::vector<std::uint32_t>& visited) {
  distance.assign(g.size(), kUnreached);
  visited.assign(1, start);
  distance[start] = 0;
  for (std::size_t i = 0; i < visited.size(); ++i) {
    const std::uint32_t v = visited[i];
    for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
      if (distance[*u] == kUnreached) {
        distance[*u] = distance[v] + 1;
        visited.push_back(*u);
      }
  }
}

void addWeights(const WeightedGraph& g, Separation& s) {
  s.weight = {};
  for (std::uint32_t v = 0; v < g.size(); ++v) s.weight[s.set[v]] += g.weight[v];
}

/// Whole components, the heaviest first, each to the lighter part.
Separation splitComponents(const WeightedGraph& g) {
  std::vector<std::uint32_t> component(g.size(), kUnreached), queue;
  std::vector<std::uint64_t> weight;
  for (std::uint32_t start = 0; start < g.size(); ++start) {
    if (component[start] != kUnreached) continue;
    const auto id = static_cast<std::uint32_t>(weight.size());
    weight.push_back(0);
    queue.assign(1, start);
    component[start] = id;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      weight[id] += g.weight[queue[i]];
      for (const std::uint32_t* u = g.begin(queue[i]); u != g.end(queue[i]); ++u)
        if (component[*u] == kUnreached) {
          component[*u] = id;
          queue.push_back(*u);
        }
    }
  }
  const std::vector<std::uint32_t> byWeight = stableOrder(
      weight.size(), [&](std::uint32_t a, std::uint32_t b) { return weight[a] > weight[b]; });
  std::vector<std::uint8_t> part(weight.size());
  std::array<std::uint64_t, 2> sum{};
  for (const std::uint32_t c : byWeight) {
    part[c] = sum[1] < sum[0];
    sum[part[c]] += weight[c];
  }
  Separation s;
  s.set.resize(g.size());
  for (std::uint32_t v = 0; v < g.size(); ++v) s.set[v] = part[component[v]];
  addWeights(g, s);
  return s;
}

/// Distance to `a` minus distance to `b`, smoothed.
std::vector<float> distanceDifference(const WeightedGraph& g, const std::vector<std::uint32_t>& a,
                                      const std::vector<std::uint32_t>& b) {
  std::vector<float> key(g.size()), next(g.size());
  for (std::uint32_t v = 0; v < g.size(); ++v)
    key[v] = static_cast<float>(a[v]) - static_cast<float>(b[v]);
  for (int round = 0; round < kSmoothingRounds; ++round) {
    for (std::uint32_t v = 0; v < g.size(); ++v) {
      float sum = key[v];
      for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u) sum += key[*u];
      next[v] = sum / static_cast<float>(g.degree(v) + 1);
    }
    key.swap(next);
  }
  return key;
}

/// The lighter half by key is part 0; of the two rims along the cut the lighter one separates.
Separation cutAtMedian(const WeightedGraph& g, const std::vector<float>& key) {
  std::vector<std::uint32_t> order(g.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    return key[a] < key[b] || (key[a] == key[b] && a < b);
  };
  // Split by count: vertices weigh 1 or 2, and the refinement balances weights.
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  std::nth_element(order.begin(), middle, order.end(), less);
  Separation s;
  s.set.assign(g.size(), 1);
  for (auto v = order.begin(); v != middle; ++v) s.set[*v] = 0;
  std::array<std::vector<std::uint32_t>, 2> rim;
  std::array<std::uint64_t, 2> rimWeight{};
  for (std::uint32_t v = 0; v < g.size(); ++v)
    if (std::any_of(g.begin(v), g.end(v), [&](std::uint32_t u) { return s.set[u] != s.set[v]; })) {
      rim[s.set[v]].push_back(v);
      rimWeight[s.set[v]] += g.weight[v];
    }
  for (const std::uint32_t v : rim[rimWeight[1] < rimWeight[0]]) s.set[v] = 2;
  addWeights(g, s);
  return s;
}

/// Cuts by the distances to `start`'s farthest vertex and to the one farthest from that; false if
/// the graph is not connected.
bool cutFrom(const WeightedGraph& g, std::uint32_t start, Separation& s) {
  std::vector<std::uint32_t> fromStart, fromEnd, visited;
  distancesFrom(g, start, fromStart, visited);
  if (visited.size() < g.size()) return false;
  distancesFrom(g, visited.back(), fromStart, visited);
  distancesFrom(g, visited.back(), fromEnd, visited);
  s = cutAtMedian(g, distanceDifference(g, fromStart, fromEnd));
  refineSeparator(g, s);
  return true;
}

bool isBetter(const Separation& a, const Separation& b) {
  const auto cost = [](const Separation& s) {
    const auto larger = static_cast<double>(std::max(s.weight[0], s.weight[1]));
    const auto both = static_cast<double>(s.weight[0] + s.weight[1]);
    return static_cast<double>(s.weight[2]) * (larger > 0.6 * both ? 2 + larger / both : 1);
  };
  return cost(a) < cost(b);
}

/// The best of cuts from several places, for a small graph.
bool cutSmall(const WeightedGraph& g, Separation& s) {
  if (!cutFrom(g, 0, s)) return false;
  for (std::uint32_t i = 1; i < kTries; ++i) {
    Separation other;
    cutFrom(g, static_cast<std::uint32_t>(static_cast<std::uint64_t>(i) * g.size() / kTries),
            other);
    if (isBetter(other, s)) s = std::move(other);
  }
  return true;
}

bool cutByLevels(const WeightedGraph& g, const std::vector<std::uint32_t>& edgeWeight, int level,
                 std::uint32_t seed, ThreadPool* pool, Separation& best);

/// One cut of a coarsened graph, refined in this one.
bool cutCoarsened(const WeightedGraph& g, const std::vector<std::uint32_t>& edgeWeight, int level,
                  std::uint32_t seed, ThreadPool* pool, Separation& s) {
  const CoarseGraph coarse = coarsen(g, edgeWeight, seed);
  beat(pool, g.size());
  if (coarse.graph.size() > kLeastShrinking * g.size()) return cutFrom(g, 0, s);
  Separation rough;
  if (!cutByLevels(coarse.graph, coarse.edgeWeight, level + 1, seed, pool, rough)) return false;
  s.set.resize(g.size());
  for (std::uint32_t v = 0; v < g.size(); ++v) s.set[v] = rough.set[coarse.cluster[v]];
  addWeights(g, s);
  refineSeparator(g, s);
  beat(pool, g.size());
  return true;
}

/// `level`: how many times the graph has been coarsened already.
bool cutByLevels(const WeightedGraph& g, const std::vector<std::uint32_t>& edgeWeight, int level,
                 std::uint32_t seed, ThreadPool* pool, Separation& best) {
  if (g.size() <= kSmallGraph) return cutSmall(g, best);
  if (level != kLevelOfTries) return cutCoarsened(g, edgeWeight, level, seed, pool, best);
  std::array<Separation, kCoarseTries> tries;
  std::array<bool, kCoarseTries> isCut{};
  parallelFor(pool, kCoarseTries, [&](std::size_t t) {
    isCut[t] =
        cutCoarsened(g, edgeWeight, level, seed + static_cast<std::uint32_t>(t), pool, tries[t]);
  });
  best = std::move(tries[0]);
  for (std::size_t t = 1; t < tries.size(); ++t)
    if (isCut[t] && isBetter(tries[t], best)) best = std::move(tries[t]);
  return isCut[0];
}

}  // namespace

Separation separate(const WeightedGraph& g, ThreadPool* pool) {
  Separation s;
  const bool isConnected =
      g.size() <= kMediumGraph ? cutFrom(g, 0, s) : cutByLevels(g, {}, 0, 0, pool, s);
  return isConnected ? s : splitComponents(g);
}

}  // namespace abflat
