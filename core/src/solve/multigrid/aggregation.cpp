#include "solve/multigrid/aggregation.h"

#include <algorithm>
#include <cmath>

namespace abflat {
namespace {

/// A row whose entries of its kind sum to less than this share of its diagonal is as good as solved
/// by the smoother.
constexpr double kDominated = 0.05;
/// For a Jacobi step whose matrix has its spectrum in [0, 2].
constexpr double kDamping = 2.0 / 3.0;

/// Largest magnitude and sum of magnitudes right and left of the diagonal, within a kind.
struct RowSize {
  double largest = 0, sum = 0;
  void add(double magnitude) {
    largest = std::max(largest, magnitude);
    sum += magnitude;
  }
};

std::vector<RowSize> rowSizes(const HalfMatrix& a, const std::vector<std::uint8_t>& kind) {
  std::vector<RowSize> size(a.rows);
  for (std::uint32_t i = 0; i < a.rows; ++i)
    a.forEachRight(i, [&](std::uint32_t j, double value) {
      if (kind[i] != kind[j]) return;
      size[i].add(std::abs(value));
      size[j].add(std::abs(value));
    });
  return size;
}

/// The aggregate of the row's most strongly connected neighbour that already has one.
std::uint32_t strongestAggregate(const StrongGraph& graph, const std::vector<std::uint32_t>& of,
                                 std::uint32_t i) {
  double largest = 0;
  std::uint32_t best = kNoAggregate;
  graph.off.forEach(i, [&](std::uint32_t j, double value) {
    if (of[j] == kNoAggregate || std::abs(value) <= largest) return;
    largest = std::abs(value);
    best = of[j];
  });
  return best;
}

}  // namespace

StrongGraph strongGraph(const HalfMatrix& a, const std::vector<std::uint8_t>& kind, double share) {
  const std::vector<RowSize> size = rowSizes(a, kind);
  const auto isDominated = [&](std::uint32_t i) {
    return size[i].sum <= kDominated * a.diagonal(i);
  };
  const auto isStrong = [&](std::uint32_t i, std::uint32_t j, double value) {
    return std::abs(value) >= share * std::min(size[i].largest, size[j].largest) && value != 0 &&
           !isDominated(i) && !isDominated(j);
  };
  StrongGraph graph;
  graph.diagonal.resize(a.rows);
  for (std::uint32_t i = 0; i < a.rows; ++i) graph.diagonal[i] = a.diagonal(i);
  CompressedRows& off = graph.off;
  off.start.assign(a.rows + 1, 0);
  for (std::uint32_t i = 0; i < a.rows; ++i)
    a.forEachRight(i, [&](std::uint32_t j, double value) {
      if (kind[i] != kind[j]) return;
      if (isStrong(i, j, value)) {
        ++off.start[i + 1];
        ++off.start[j + 1];
      } else {
        graph.diagonal[i] += value;
        graph.diagonal[j] += value;
      }
    });
  for (std::uint32_t i = 0; i < a.rows; ++i) off.start[i + 1] += off.start[i];
  off.column.resize(static_cast<std::size_t>(off.start.back()));
  off.value.resize(off.column.size());
  std::vector<int> next(off.start.begin(), off.start.end() - 1);
  const auto put = [&](std::uint32_t i, std::uint32_t j, double value) {
    off.column[next[i]] = static_cast<int>(j);
    off.value[next[i]++] = value;
  };
  for (std::uint32_t i = 0; i < a.rows; ++i)
    a.forEachRight(i, [&](std::uint32_t j, double value) {
      if (kind[i] != kind[j] || !isStrong(i, j, value)) return;
      put(i, j, value);
      put(j, i, value);
    });
  return graph;
}

Aggregates aggregate(const StrongGraph& graph, const std::vector<std::uint8_t>& kind) {
  const std::uint32_t rows = graph.off.rows();
  Aggregates out;
  std::vector<std::uint32_t>& of = out.ofRow;
  of.assign(rows, kNoAggregate);
  const auto isAlone = [&](std::uint32_t i) {
    return graph.off.start[i] == graph.off.start[i + 1];
  };
  // First, each row with all its neighbours, if none of them is taken.
  for (std::uint32_t i = 0; i < rows; ++i) {
    if (isAlone(i) || of[i] != kNoAggregate) continue;
    bool isFree = true;
    graph.off.forEach(i, [&](std::uint32_t j, double) { isFree &= of[j] == kNoAggregate; });
    if (!isFree) continue;
    of[i] = out.count();
    graph.off.forEach(i, [&](std::uint32_t j, double) { of[j] = of[i]; });
    out.kind.push_back(kind[i]);
  }
  // Then the others join. Only the aggregates so far count, so that none grows long.
  const std::vector<std::uint32_t> cores = of;
  for (std::uint32_t i = 0; i < rows; ++i)
    if (!isAlone(i) && of[i] == kNoAggregate) of[i] = strongestAggregate(graph, cores, i);
  for (std::uint32_t i = 0; i < rows; ++i) {
    if (isAlone(i) || of[i] != kNoAggregate) continue;
    of[i] = out.count();
    graph.off.forEach(i, [&](std::uint32_t j, double) {
      if (of[j] == kNoAggregate) of[j] = of[i];
    });
    out.kind.push_back(kind[i]);
  }
  return out;
}

CompressedRows smoothedProlongation(const StrongGraph& graph, const Aggregates& aggregates) {
  const std::uint32_t rows = graph.off.rows();
  CompressedRows p;
  p.start.reserve(rows + 1);
  p.column.reserve(2 * static_cast<std::size_t>(rows));
  p.value.reserve(2 * static_cast<std::size_t>(rows));
  for (std::uint32_t i = 0; i < rows; ++i) {
    if (aggregates.ofRow[i] == kNoAggregate) {
      p.endRow();
      continue;
    }
    double sum = 0;
    graph.off.forEach(i, [&](std::uint32_t, double value) { sum += std::abs(value); });
    // With this for the diagonal, Gershgorin's circles end at 2.
    const double scale = std::max(sum, graph.diagonal[i]);
    const auto first = static_cast<std::size_t>(p.start.back());
    const auto add = [&](std::uint32_t row, double value) {
      const auto coarse = static_cast<int>(aggregates.ofRow[row]);
      for (std::size_t k = first; k < p.column.size(); ++k)
        if (p.column[k] == coarse) return void(p.value[k] += value);
      p.push(aggregates.ofRow[row], value);
    };
    add(i, 1 - kDamping * graph.diagonal[i] / scale);
    graph.off.forEach(i, [&](std::uint32_t j, double value) { add(j, -kDamping * value / scale); });
    p.endRow();
  }
  p.column.shrink_to_fit();
  p.value.shrink_to_fit();
  return p;
}

}  // namespace abflat
