#include "solve/schur_system.h"

#include <algorithm>

namespace abflat {
namespace {

constexpr std::size_t kAssemblyGrain = 2048;  ///< triangles per piece of work
constexpr std::uint32_t kRegions = 16;

}  // namespace

SchurSystem::SchurSystem(const AngleProblem& problem, const ConstraintRows& rows, ThreadPool* pool)
    : problem_(problem), rows_(rows), pool_(pool) {
  buildPattern();
  buildScatter();
}

void SchurSystem::buildPattern() {
  const std::uint32_t vertices = problem_.vertexCount();
  // Larger neighbours per vertex: counting sort, then unique.
  std::vector<std::uint32_t> offset(vertices + 1, 0);
  const auto forEachEdge = [&](auto&& visit) {
    for (const ChartCorner c : problem_.corners()) {
      const ChartVertex a = problem_.vertexOfCorner[c];
      const ChartVertex b = problem_.vertexOfCorner[nextCorner(c)];
      visit(std::min(a, b), std::max(a, b));
    }
  };
  forEachEdge([&](std::uint32_t a, std::uint32_t) { ++offset[a + 1]; });
  for (std::uint32_t v = 0; v < vertices; ++v) offset[v + 1] += offset[v];
  std::vector<std::uint32_t> fill(offset.begin(), offset.end() - 1), neighbours(offset.back());
  forEachEdge([&](std::uint32_t a, std::uint32_t b) { neighbours[fill[a]++] = b; });

  const auto n = static_cast<Eigen::Index>(rows_.count());
  std::vector<int> outer(static_cast<std::size_t>(n) + 1, 0), inner;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto first = neighbours.begin() + offset[v];
    auto last = neighbours.begin() + offset[v + 1];
    std::sort(first, last);
    last = std::unique(first, last);
    for (std::uint32_t column = rows_.ofVertex[v]; column < rows_.ofVertex[v + 1]; ++column) {
      for (std::uint32_t r = column; r < rows_.ofVertex[v + 1]; ++r)
        inner.push_back(static_cast<int>(r));
      for (auto u = first; u != last; ++u)
        for (std::uint32_t r = rows_.ofVertex[*u]; r < rows_.ofVertex[*u + 1]; ++r)
          inner.push_back(static_cast<int>(r));
      outer[column + 1] = static_cast<int>(inner.size());
    }
  }
  matrix_.resize(n, n);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(outer.begin(), outer.end(), matrix_.outerIndexPtr());
  std::copy(inner.begin(), inner.end(), matrix_.innerIndexPtr());
  rhs_.resize(n);
}

void SchurSystem::buildScatter() {
  scatter_.reserve(21 * problem_.triangles().size());
  const int* outer = matrix_.outerIndexPtr();
  const int* inner = matrix_.innerIndexPtr();
  for (const ChartTriangle f : problem_.triangles()) {
    std::array<std::uint32_t, 6> row;
    for (std::size_t k = 0; k < 3; ++k) {
      const ChartVertex v = problem_.vertexOfCorner[cornerOf(f, k)];
      row[2 * k] = rows_.ofVertex[v];
      row[2 * k + 1] = problem_.isBoundary[v] ? kDropped : rows_.ofVertex[v] + 1;
    }
    for (unsigned r = 0; r < 6; ++r)
      for (unsigned c = 0; c <= r; ++c) {
        if (row[r] == kDropped || row[c] == kDropped) {
          scatter_.push_back(kDropped);
          continue;
        }
        const std::uint32_t column = std::min(row[r], row[c]);
        const int wanted = static_cast<int>(std::max(row[r], row[c]));
        scatter_.push_back(static_cast<std::uint32_t>(
            std::lower_bound(inner + outer[column], inner + outer[column + 1], wanted) - inner));
      }
  }
}

void SchurSystem::divide(const std::vector<std::uint32_t>& rankOfRow) {
  if (!isParallel(pool_) || problem_.triangleCount() < kRegions * kAssemblyGrain) return;
  regionOfVertex_.resize(problem_.vertexCount());
  const std::uint64_t rows = rows_.count();
  for (const ChartVertex v : problem_.vertices())
    regionOfVertex_[v] =
        static_cast<std::uint8_t>(kRegions * std::uint64_t{rankOfRow[rows_.ofVertex[v]]} / rows);
  triangles_.resize(kRegions);
  for (const ChartTriangle f : problem_.triangles()) {
    const auto regionAt = [&](std::size_t k) {
      return regionOfVertex_[problem_.vertexOfCorner[cornerOf(f, k)]];
    };
    const std::uint8_t a = regionAt(0), b = regionAt(1), c = regionAt(2);
    triangles_[a].push_back(f);
    if (b != a) triangles_[b].push_back(f);
    if (c != a && c != b) triangles_[c].push_back(f);
  }
}

/// Adds only to the rows of the vertices of one region; columns of the matrix count as rows.
void SchurSystem::assembleTriangle(const Linearization& lin,
                                   const std::vector<std::uint8_t>& active, ChartTriangle f,
                                   std::uint32_t region) {
  const Element& e = lin.elements[f];
  double* values = matrix_.valuePtr();
  std::array<bool, 3> off, own;  // off: vertices whose only row is inactive
  std::array<ChartVertex, 3> vertex;
  for (std::size_t k = 0; k < 3; ++k) {
    vertex[k] = problem_.vertexOfCorner[cornerOf(f, k)];
    off[k] = problem_.isBoundary[vertex[k]] && !active[vertex[k]];
    own[k] = regionOfVertex_.empty() || regionOfVertex_[vertex[k]] == region;
  }
  const std::array<double, 21> m = elementMatrix(e);
  const std::uint32_t* place = &scatter_[21 * std::size_t{f}];
  unsigned i = 0;
  for (unsigned r = 0; r < 6; ++r)
    for (unsigned c = 0; c <= r; ++c, ++i)
      if (place[i] != kDropped && !off[r / 2] && !off[c / 2] &&
          own[vertex[r / 2] < vertex[c / 2] ? r / 2 : c / 2])
        values[place[i]] += m[i];
  // h - B P g - B D 1 r / (1^T D 1)
  std::array<double, 3> z = applyProjected(e, e.gradient);
  const std::array<double, 3> unit = unitStep(e);
  for (unsigned k = 0; k < 3; ++k) z[k] += unit[k] * e.triangleResidual;
  const std::array<double, 6> y = applyJacobian(e, z);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!own[k]) continue;
    rhs_[rows_.ofVertex[vertex[k]]] -= y[2 * k];
    if (!problem_.isBoundary[vertex[k]]) rhs_[rows_.ofVertex[vertex[k]] + 1] -= y[2 * k + 1];
  }
}

void SchurSystem::assembleBoundary(const std::vector<std::uint8_t>& active,
                                   const std::vector<double>& compliance) {
  for (const ChartVertex v : problem_.vertices()) {
    if (!problem_.isBoundary[v]) continue;
    double& diagonal = matrix_.valuePtr()[matrix_.outerIndexPtr()[rows_.ofVertex[v]]];
    if (active[v]) {
      if (!compliance.empty()) diagonal += compliance[v];
      continue;
    }
    diagonal = 1;
    rhs_[rows_.ofVertex[v]] = 0;
  }
}

void SchurSystem::assemble(const Linearization& lin, const std::vector<std::uint8_t>& active,
                           const std::vector<double>& compliance) {
  double* values = matrix_.valuePtr();
  parallelRanges(pool_, static_cast<std::size_t>(matrix_.nonZeros()), 16 * kAssemblyGrain,
                 [&](std::size_t a, std::size_t b) { std::fill(values + a, values + b, 0.0); });
  std::copy(lin.residual.begin(), lin.residual.end(), rhs_.begin());
  if (regionOfVertex_.empty())
    for (const ChartTriangle f : problem_.triangles()) assembleTriangle(lin, active, f, 0);
  else
    parallelFor(pool_, kRegions, [&](std::size_t region) {
      for (const ChartTriangle f : triangles_[region])
        assembleTriangle(lin, active, f, static_cast<std::uint32_t>(region));
    });
  assembleBoundary(active, compliance);
}

void SchurSystem::backSubstitute(const Linearization& lin,
                                 const std::vector<double>& rowMultipliers, std::vector<double>& dx,
                                 std::vector<double>& triangleMultipliers) const {
  dx.resize(problem_.vertexOfCorner.size());
  triangleMultipliers.resize(problem_.triangleCount());
  parallelRanges(pool_, problem_.triangleCount(), kAssemblyGrain,
                 [&](std::size_t begin, std::size_t end) {
                   for (const ChartTriangle f : IdRange{ChartTriangle(begin), ChartTriangle(end)}) {
                     const Element& e = lin.elements[f];
                     std::array<double, 3> z =
                         applyTransposedJacobian(e, gatherRows(problem_, rows_, rowMultipliers, f));
                     for (unsigned k = 0; k < 3; ++k) z[k] += e.gradient[k];
                     const std::array<double, 3> step = applyProjected(e, z), unit = unitStep(e);
                     double& lambda = triangleMultipliers[f];
                     lambda = e.triangleResidual * e.hessian[0] * unit[0];
                     for (unsigned k = 0; k < 3; ++k) {
                       lambda -= unit[k] * z[k];
                       dx[cornerOf(f, k)] = -step[k] - unit[k] * e.triangleResidual;
                     }
                   }
                 });
}

}  // namespace abflat
