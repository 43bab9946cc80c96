#include "solve/row_system.h"

#include <algorithm>
#include <utility>

namespace abflat {
namespace {

constexpr std::uint32_t kRegions = 16;
/// Fewer per region are not worth dividing.
constexpr std::size_t kRegionTriangles = 2048;
constexpr std::size_t kEntriesPerPiece = 32768;
/// Where entry (r, c) of TriangleRows::matrix is.
constexpr std::uint8_t kLowerPlace[6][6] = {{0, 1, 3, 6, 10, 15},     {1, 2, 4, 7, 11, 16},
                                            {3, 4, 5, 8, 12, 17},     {6, 7, 8, 9, 13, 18},
                                            {10, 11, 12, 13, 14, 19}, {15, 16, 17, 18, 19, 20}};

}  // namespace

RowSystem::RowSystem(const IdVector<ChartCorner, ChartVertex>& vertexOfCorner,
                     std::vector<std::uint32_t> firstRow, ThreadPool* pool)
    : vertexOfCorner_(vertexOfCorner), firstRow_(std::move(firstRow)), pool_(pool) {
  buildPattern();
}

void RowSystem::buildPattern() {
  const IdRange<ChartVertex> vertices(firstRow_.size() - 1);
  // Per vertex, the half-edges to later ones: the other vertex and the half-edge as one number that
  // is quick to sort.
  std::vector<std::uint32_t> begin(firstRow_.size(), 0);
  const auto forEdges = [&](const auto& use) {
    for (const ChartCorner h : vertexOfCorner_.ids()) {
      const std::uint32_t a = vertexOfCorner_[h], b = vertexOfCorner_[nextCorner(h)];
      use(std::min(a, b), std::uint64_t{std::max(a, b)} << 32 | std::uint32_t{h});
    }
  };
  forEdges([&](std::uint32_t a, std::uint64_t) { ++begin[a + 1]; });
  for (const ChartVertex v : vertices) begin[v + 1] += begin[v];
  std::vector<std::uint64_t> edges(begin.back());
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  forEdges([&](std::uint32_t a, std::uint64_t edge) { edges[fill[a]++] = edge; });

  entryOfEdge_.resize(vertexOfCorner_.size());
  std::vector<int> start{0}, rows;
  const auto addRows = [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t row = from; row < to; ++row) rows.push_back(static_cast<int>(row));
  };
  for (const ChartVertex v : vertices) {
    const auto first = edges.begin() + begin[v], last = edges.begin() + begin[v + 1];
    std::sort(first, last);
    for (std::uint32_t column = firstRow_[v]; column < firstRow_[v + 1]; ++column) {
      addRows(column, firstRow_[v + 1]);
      std::uint32_t entry = 0;
      for (auto edge = first; edge != last; ++edge) {
        const auto later = static_cast<std::uint32_t>(*edge >> 32);
        if (edge == first || later != *(edge - 1) >> 32) {
          entry = static_cast<std::uint32_t>(rows.size());
          addRows(firstRow_[later], firstRow_[later + 1]);
        }
        if (column == firstRow_[v])
          entryOfEdge_[ChartCorner(static_cast<std::uint32_t>(*edge))] = entry;
      }
      start.push_back(static_cast<int>(rows.size()));
    }
  }
  const auto size = static_cast<Eigen::Index>(firstRow_.back());
  matrix_.resize(size, size);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  std::copy(start.begin(), start.end(), matrix_.outerIndexPtr());
  std::copy(rows.begin(), rows.end(), matrix_.innerIndexPtr());
  rightHandSide.resize(size);
}

void RowSystem::divide(const std::vector<std::uint32_t>& rankOfRow) {
  const IdRange<ChartTriangle> all(vertexOfCorner_.size() / 3);
  if (!isParallel(pool_) || all.size() < kRegions * kRegionTriangles) return;
  for (std::size_t v = 0; v + 1 < firstRow_.size(); ++v)
    regionOfVertex_.push_back(static_cast<std::uint8_t>(
        kRegions * std::uint64_t{rankOfRow[firstRow_[v]]} / rankOfRow.size()));
  triangles_.resize(kRegions);
  for (const ChartTriangle f : all) {
    const auto regionAt = [&](std::size_t k) {
      return regionOfVertex_[vertexOfCorner_[cornerOf(f, k)]];
    };
    const std::uint8_t a = regionAt(0), b = regionAt(1), c = regionAt(2);
    triangles_[a].push_back(f);
    if (b != a) triangles_[b].push_back(f);
    if (c != a && c != b) triangles_[c].push_back(f);
  }
}

/// Adds only to the rows of the vertices of one region; columns of the matrix count as rows.
void RowSystem::add(const TriangleRows& rows, ChartTriangle f, std::uint32_t region,
                    const IdVector<ChartVertex, std::uint8_t>& isOff) {
  std::array<ChartVertex, 3> vertex;
  std::array<std::uint32_t, 3> row;
  std::array<bool, 3> isPair, isUsed, isOwn;
  for (std::size_t k = 0; k < 3; ++k) {
    const ChartVertex v = vertex[k] = vertexOfCorner_[cornerOf(f, k)];
    row[k] = firstRow_[v];
    isPair[k] = firstRow_[v + 1] - row[k] == 2;
    isUsed[k] = isOff.empty() || !isOff[v];
    isOwn[k] = regionOfVertex_.empty() || regionOfVertex_[v] == region;
  }
  const int* start = matrix_.outerIndexPtr();
  double* values = matrix_.valuePtr();
  // To the rows of vertex k, in one column.
  const auto addColumn = [&](double* entry, std::size_t k, std::size_t column) {
    entry[0] += rows.matrix[kLowerPlace[2 * k][column]];
    if (isPair[k]) entry[1] += rows.matrix[kLowerPlace[2 * k + 1][column]];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!isUsed[k]) continue;
    if (isOwn[k]) {
      addColumn(values + start[row[k]], k, 2 * k);
      rightHandSide.data()[row[k]] += rows.rightHandSide[2 * k];
    }
    if (isOwn[k] && isPair[k]) {
      values[start[row[k] + 1]] += rows.matrix[kLowerPlace[2 * k + 1][2 * k + 1]];
      rightHandSide.data()[row[k] + 1] += rows.rightHandSide[2 * k + 1];
    }
    const std::size_t l = (k + 1) % 3;
    const std::size_t early = vertex[k] < vertex[l] ? k : l, late = k + l - early;
    if (!isUsed[l] || !isOwn[early]) continue;
    double* entry = values + entryOfEdge_[cornerOf(f, k)];
    addColumn(entry, late, 2 * early);
    // The next column begins one row later.
    const int* column = start + row[early];
    if (isPair[early]) addColumn(entry + (column[1] - column[0]) - 1, late, 2 * early + 1);
  }
}

void RowSystem::assemble(const IdVector<ChartVertex, std::uint8_t>& isOff,
                         const std::function<TriangleRows(ChartTriangle)>& rowsOf) {
  double* values = matrix_.valuePtr();
  parallelRanges(pool_, static_cast<std::size_t>(matrix_.nonZeros()), kEntriesPerPiece,
                 [&](std::size_t a, std::size_t b) { std::fill(values + a, values + b, 0.0); });
  if (triangles_.empty())
    for (const ChartTriangle f : IdRange<ChartTriangle>(vertexOfCorner_.size() / 3))
      add(rowsOf(f), f, 0, isOff);
  parallelFor(pool_, triangles_.size(), [&](std::size_t region) {
    for (const ChartTriangle f : triangles_[region])
      add(rowsOf(f), f, static_cast<std::uint32_t>(region), isOff);
  });
  for (const ChartVertex v : isOff.ids())
    for (std::uint32_t row = firstRow_[v]; isOff[v] && row < firstRow_[v + 1]; ++row) {
      *diagonal(row) = 1;
      rightHandSide[row] = 0;
    }
}

}  // namespace abflat
