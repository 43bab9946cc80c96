#include "solve/cholesky/coarsen.h"

#include <algorithm>

namespace abflat {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr unsigned kClusterSize = 4;

std::uint32_t scatter(std::uint32_t v, std::uint32_t seed) {
  return ((v + 977 * seed) * 2654435761u) >> 16;
}

/// Numbers often run along rows of a mesh. Visiting them in order would make clusters, and after a
/// few levels the whole graph, longer in that direction.
std::uint32_t visited(std::uint32_t i, std::uint32_t n, std::uint32_t seed) {
  constexpr std::uint32_t kWindow = 1024, kStride = 619;
  const std::uint32_t begin = i - i % kWindow;
  return begin + kWindow <= n ? begin + ((i + 31 * seed) * (kStride + 2 * seed)) % kWindow : i;
}

/// Clusters of a vertex and its most strongly connected free neighbours; a vertex left alone joins
/// the lightest cluster beside it.
std::uint32_t findClusters(const WeightedGraph& g, const std::vector<std::uint32_t>& edgeWeight,
                           std::uint32_t seed, std::vector<std::uint32_t>& cluster) {
  std::uint64_t total = 0;
  for (const std::uint32_t w : g.weight) total += w;
  // Keeps clusters of similar weight, so that coarse cuts can be balanced.
  const std::uint64_t heaviest = std::max<std::uint64_t>(8 * total / g.size(), total / 100);
  std::vector<std::uint64_t> weight;
  cluster.assign(g.size(), kNone);
  for (std::uint32_t i = 0; i < g.size(); ++i) {
    const std::uint32_t v = visited(i, g.size(), seed);
    if (cluster[v] != kNone) continue;
    const auto id = static_cast<std::uint32_t>(weight.size());
    std::uint64_t sum = g.weight[v];
    bool isAlone = true;
    cluster[v] = id;
    for (unsigned member = 1; member < kClusterSize; ++member) {
      std::uint32_t best = kNone, bestWeight = 0;
      const std::uint32_t degree = g.degree(v), skip = scatter(v, seed) % std::max(degree, 1u);
      for (std::uint32_t k = 0; k < degree; ++k) {
        const std::size_t e = g.offset[v] + (k + skip < degree ? k + skip : k + skip - degree);
        const std::uint32_t u = g.neighbour[e], w = edgeWeight.empty() ? 1 : edgeWeight[e];
        if (cluster[u] != kNone || w <= bestWeight || sum + g.weight[u] > heaviest) continue;
        best = u;
        bestWeight = w;
      }
      if (best == kNone) break;
      cluster[best] = id;
      sum += g.weight[best];
      isAlone = false;
    }
    std::uint32_t host = kNone;
    if (isAlone)
      for (const std::uint32_t* u = g.begin(v); u != g.end(v); ++u)
        if (cluster[*u] != kNone && cluster[*u] != id && weight[cluster[*u]] + sum <= heaviest &&
            (host == kNone || weight[cluster[*u]] < weight[host]))
          host = cluster[*u];
    if (host == kNone) {
      weight.push_back(sum);
    } else {
      cluster[v] = host;
      weight[host] += sum;
    }
  }
  return static_cast<std::uint32_t>(weight.size());
}

}  // namespace

CoarseGraph coarsen(const WeightedGraph& fine, const std::vector<std::uint32_t>& edgeWeight,
                    std::uint32_t seed) {
  CoarseGraph out;
  const std::uint32_t n = findClusters(fine, edgeWeight, seed, out.cluster);
  std::vector<std::uint32_t> memberBegin(n + 1, 0), member(fine.size());
  for (const std::uint32_t c : out.cluster) ++memberBegin[c + 1];
  for (std::uint32_t c = 0; c < n; ++c) memberBegin[c + 1] += memberBegin[c];
  for (std::uint32_t v = fine.size(); v-- > 0;) member[--memberBegin[out.cluster[v] + 1]] = v;
  // Filling moved each end of a cluster to its begin.
  std::rotate(memberBegin.begin(), memberBegin.begin() + 1, memberBegin.end());
  memberBegin[n] = fine.size();

  WeightedGraph& g = out.graph;
  g.weight.assign(n, 0);
  g.offset.reserve(n + 1);
  g.offset.push_back(0);
  g.neighbour.reserve(fine.neighbour.size() / 2);
  out.edgeWeight.reserve(fine.neighbour.size() / 2);
  std::vector<std::size_t> edge(n, 0);  // 1 + place of the edge to a cluster
  for (std::uint32_t c = 0; c < n; ++c) {
    const std::size_t begin = g.neighbour.size();
    for (std::uint32_t m = memberBegin[c]; m < memberBegin[c + 1]; ++m) {
      const std::uint32_t v = member[m];
      g.weight[c] += fine.weight[v];
      for (std::size_t e = fine.offset[v]; e < fine.offset[v + 1]; ++e) {
        const std::uint32_t d = out.cluster[fine.neighbour[e]];
        if (d == c) continue;
        if (edge[d] <= begin) {
          g.neighbour.push_back(d);
          out.edgeWeight.push_back(0);
          edge[d] = g.neighbour.size();
        }
        out.edgeWeight[edge[d] - 1] += edgeWeight.empty() ? 1 : edgeWeight[e];
      }
    }
    g.offset.push_back(g.neighbour.size());
  }
  return out;
}

}  // namespace abflat
