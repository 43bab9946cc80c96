#include "seam/log_scale.h"

#include <algorithm>

#include "base/constants.h"

namespace abflat {

namespace {

CholeskyOptions positiveDefinite(ThreadPool* pool) {
  CholeskyOptions options;
  options.pool = pool;
  options.allowNegative = false;
  return options;
}

template <typename Scalar>
bool solveWith(BasicCholesky<Scalar>& factor, const std::vector<double>& values, LogScales& u) {
  if (!factor.factorize(values.data()).isOk()) return false;
  factor.solve(u.raw().data());
  return true;
}

}  // namespace

LogScale::LogScale(const SeamMesh& mesh, ThreadPool* pool, EliminationRanks ranks)
    : mesh_(mesh),
      pool_(pool),
      symbolic_([&] {
        buildPattern();
        CholeskyAnalysisOptions options;
        options.eliminationRank = std::move(ranks.raw());
        options.pool = pool;
        return std::make_shared<const CholeskySymbolic>(
            analyzePattern({mesh.vertexCount(), columnStart_.data(), row_.data()}, options));
      }()),
      factor_(symbolic_, positiveDefinite(pool)) {}

/// Lower triangle by columns: the diagonal first, then neighbours with greater numbers. Several
/// edges between the same two vertices share an entry.
void LogScale::buildPattern() {
  const std::uint32_t n = mesh_.vertexCount();
  // Rows and columns are plain numbers.
  const auto low = [&](SurfaceCorner h) -> std::uint32_t {
    return std::min(mesh_.tail(h), mesh_.head(h));
  };
  // Half-edges by their higher vertex, as one number that is quick to sort.
  const auto highFirst = [&](SurfaceCorner h) {
    return std::uint64_t{std::max(mesh_.tail(h), mesh_.head(h))} << 32 | std::uint32_t{h};
  };
  const auto isFirst = [&](SurfaceCorner h) { return h < mesh_.twin[h]; };
  std::vector<std::uint32_t> begin(n + 1, 0);
  for (const SurfaceCorner h : mesh_.corners())
    if (isFirst(h)) ++begin[low(h) + 1];
  for (std::uint32_t v = 0; v < n; ++v) begin[v + 1] += begin[v];
  std::vector<std::uint64_t> edges(begin[n]);
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  for (const SurfaceCorner h : mesh_.corners())
    if (isFirst(h)) edges[fill[low(h)]++] = highFirst(h);
  beat(pool_, mesh_.corners().size());
  entryOfEdge_.assign(mesh_.corners().size(), kNone);
  for (std::uint32_t v = 0; v < n; ++v) {
    columnStart_.push_back(static_cast<int>(row_.size()));
    row_.push_back(static_cast<int>(v));
    std::sort(edges.begin() + begin[v], edges.begin() + begin[v + 1]);
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const SurfaceCorner h(static_cast<std::uint32_t>(edges[i]));
      const auto w = static_cast<std::uint32_t>(edges[i] >> 32);
      if (w == v) continue;
      if (row_.back() != static_cast<int>(w)) row_.push_back(static_cast<int>(w));
      entryOfEdge_[h] = static_cast<std::uint32_t>(row_.size() - 1);
    }
  }
  columnStart_.push_back(static_cast<int>(row_.size()));
  values_.resize(row_.size());
  beat(pool_, values_.size());
}

LogScales LogScale::solve(const CutSurface& s, const std::vector<OpenVertex>& anchors) {
  IdVector<SurfaceVertex, std::uint8_t> isFixed(mesh_.vertexCount(), 0);
  LogScales u(mesh_.vertexCount(), 0);
  for (const OpenVertex v : s.vertices()) {
    const SurfaceVertex i = s.meshVertex[v];
    if (s.isBoundary[v]) {
      isFixed[i] = 1;
      continue;
    }
    u[i] = mesh_.angleSum[i] - 2 * kPi;
    const CutSurface::Chart& chart = s.charts[s.chartOf(v)];
    if (chart.loops == 0 && chart.area > 0)
      u[i] += 2 * kPi * static_cast<double>(chart.euler()) * mesh_.vertexArea[i] / chart.area;
  }
  for (const OpenVertex v : anchors) isFixed[s.meshVertex[v]] = 1;

  for (const SurfaceVertex v : mesh_.vertices())
    if (isFixed[v]) u[v] = 0;
  assemble(isFixed);
  if (solveWith(factor_, values_, u)) return u;
  Cholesky precise(symbolic_, positiveDefinite(pool_));
  if (!solveWith(precise, values_, u)) u.clear();
  return u;
}

/// Rows of fixed vertices become identity rows, so that the pattern stays the same.
void LogScale::assemble(const IdVector<SurfaceVertex, std::uint8_t>& isFixed) {
  std::fill(values_.begin(), values_.end(), 0.0);
  for (const SurfaceVertex v : mesh_.vertices())
    if (isFixed[v]) values_[static_cast<std::size_t>(columnStart_[v])] = 1;
  for (const SurfaceCorner h : entryOfEdge_.ids()) {
    if (entryOfEdge_[h] == kNone) continue;
    const SurfaceVertex a = mesh_.tail(h), b = mesh_.head(h);
    const double w = mesh_.stiffness(h);
    if (!isFixed[a]) values_[static_cast<std::size_t>(columnStart_[a])] += w;
    if (!isFixed[b]) values_[static_cast<std::size_t>(columnStart_[b])] += w;
    if (!isFixed[a] && !isFixed[b]) values_[entryOfEdge_[h]] -= w;
  }
  beat(pool_, values_.size());
}

}  // namespace abflat
