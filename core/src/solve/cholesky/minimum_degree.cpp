#include "solve/cholesky/minimum_degree.h"

#include <algorithm>

namespace abflat {
namespace {

/// Neighbours outside the set beyond this number are ignored, which changes only the order of
/// vertices of very high degree.
constexpr std::size_t kMaxHalo = 256;

unsigned lowestBit(std::uint64_t bits) { return static_cast<unsigned>(__builtin_ctzll(bits)); }

std::uint32_t countBits(std::uint64_t bits) {
  return static_cast<std::uint32_t>(__builtin_popcountll(bits));
}

}  // namespace

void LocalMinimumDegree::order(std::vector<std::uint32_t>& vertices) {
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) local_[vertices[i]] = static_cast<std::uint32_t>(i + 1);
  halo_.clear();
  for (const std::uint32_t v : vertices)
    for (const std::uint32_t* u = g_.begin(v); u != g_.end(v) && halo_.size() < kMaxHalo; ++u)
      if (local_[*u] == 0) {
        halo_.push_back(*u);
        local_[*u] = static_cast<std::uint32_t>(n + halo_.size());
      }
  const std::size_t words = (n + halo_.size() + 63) / 64;
  adjacency_.assign(n * words, 0);
  const auto row = [&](std::size_t i) { return adjacency_.data() + i * words; };
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::uint32_t* u = g_.begin(vertices[i]); u != g_.end(vertices[i]); ++u)
      if (const std::uint32_t j = local_[*u]) row(i)[(j - 1) / 64] |= 1ull << ((j - 1) % 64);
    row(i)[i / 64] |= 1ull << (i % 64);
  }
  // Vertices count equally: in a mesh nearly all have the same weight.
  const auto degree = [&](std::size_t i) {
    std::uint32_t sum = 0;
    for (std::size_t w = 0; w < words; ++w) sum += countBits(row(i)[w]);
    return sum;
  };
  std::vector<std::uint32_t> score(n), result;
  for (std::size_t i = 0; i < n; ++i) score[i] = degree(i);
  constexpr std::uint32_t kDone = 0xffffffffu;
  for (std::size_t step = 0; step < n; ++step) {
    const auto best =
        static_cast<std::size_t>(std::min_element(score.begin(), score.end()) - score.begin());
    result.push_back(vertices[best]);
    score[best] = kDone;
    std::uint64_t* const gone = row(best);
    gone[best / 64] &= ~(1ull << (best % 64));
    for (std::size_t w = 0; w * 64 < n; ++w)
      for (std::uint64_t bits = gone[w]; bits; bits &= bits - 1) {
        const std::size_t i = w * 64 + lowestBit(bits);
        if (i >= n) break;
        for (std::size_t k = 0; k < words; ++k) row(i)[k] |= gone[k];
        row(i)[best / 64] &= ~(1ull << (best % 64));
        score[i] = degree(i);
      }
  }
  for (const std::uint32_t v : vertices) local_[v] = 0;
  for (const std::uint32_t v : halo_) local_[v] = 0;
  vertices.swap(result);
}

}  // namespace abflat
