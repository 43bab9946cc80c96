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
bool solveWith(BasicCholesky<Scalar>& factor, const std::vector<double>& values,
               std::vector<double>& u) {
  if (!factor.factorize(values.data()).isOk()) return false;
  factor.solve(u.data());
  return true;
}

}  // namespace

LogScale::LogScale(const SeamMesh& mesh, ThreadPool* pool, std::vector<std::uint32_t> place)
    : mesh_(mesh),
      pool_(pool),
      symbolic_([&] {
        buildPattern();
        CholeskyAnalysisOptions options;
        options.place = std::move(place);
        options.pool = pool;
        return std::make_shared<const CholeskySymbolic>(
            analyzePattern({mesh.vertexCount(), columnStart_.data(), row_.data()}, options));
      }()),
      factor_(symbolic_, positiveDefinite(pool)) {}

/// Lower triangle by columns: the diagonal first, then the neighbours of greater number. Several
/// edges between the same two vertices share an entry.
void LogScale::buildPattern() {
  const std::uint32_t n = mesh_.vertexCount();
  const auto low = [&](std::uint32_t h) {
    return std::min(mesh_.vertexOfCorner[h], mesh_.vertexOfCorner[nextCorner(h)]);
  };
  const auto high = [&](std::uint32_t h) {
    return std::max(mesh_.vertexOfCorner[h], mesh_.vertexOfCorner[nextCorner(h)]);
  };
  const auto isFirst = [&](std::uint32_t h) { return mesh_.twin[h] == kNone || h < mesh_.twin[h]; };
  const auto corners = static_cast<std::uint32_t>(mesh_.twin.size());
  std::vector<std::uint32_t> begin(n + 1, 0), edges;
  for (std::uint32_t h = 0; h < corners; ++h)
    if (isFirst(h)) ++begin[low(h) + 1];
  for (std::uint32_t v = 0; v < n; ++v) begin[v + 1] += begin[v];
  edges.resize(begin[n]);
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  for (std::uint32_t h = 0; h < corners; ++h)
    if (isFirst(h)) edges[fill[low(h)]++] = h;
  beat(pool_, corners);
  entryOfEdge_.assign(corners, kNone);
  for (std::uint32_t v = 0; v < n; ++v) {
    columnStart_.push_back(static_cast<int>(row_.size()));
    row_.push_back(static_cast<int>(v));
    std::sort(edges.begin() + begin[v], edges.begin() + begin[v + 1],
              [&](std::uint32_t a, std::uint32_t b) {
                return high(a) != high(b) ? high(a) < high(b) : a < b;
              });
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const std::uint32_t h = edges[i], w = high(h);
      if (w == v) continue;
      if (row_.back() != static_cast<int>(w)) row_.push_back(static_cast<int>(w));
      entryOfEdge_[h] = static_cast<std::uint32_t>(row_.size() - 1);
    }
  }
  columnStart_.push_back(static_cast<int>(row_.size()));
  values_.resize(row_.size());
  beat(pool_, values_.size());
}

std::vector<double> LogScale::solve(const CutSurface& s,
                                    const std::vector<std::uint32_t>& anchors) {
  const std::uint32_t n = mesh_.vertexCount();
  std::vector<std::uint8_t> isFixed(n, 0);
  std::vector<double> u(n, 0);
  for (std::uint32_t v = 0; v < s.vertexCount(); ++v) {
    const std::uint32_t i = s.meshVertex[v];
    if (s.isBoundary[v]) {
      isFixed[i] = 1;
      continue;
    }
    u[i] = mesh_.angleSum[i] - 2 * kPi;
    const CutSurface::Chart& chart = s.charts[s.chartOfVertex(v)];
    if (chart.loops == 0 && chart.area > 0)
      u[i] += 2 * kPi * static_cast<double>(chart.euler()) * mesh_.vertexArea[i] / chart.area;
  }
  for (const std::uint32_t v : anchors) isFixed[s.meshVertex[v]] = 1;

  for (std::uint32_t v = 0; v < n; ++v)
    if (isFixed[v]) u[v] = 0;
  assemble(isFixed);
  if (solveWith(factor_, values_, u)) return u;
  Cholesky precise(symbolic_, positiveDefinite(pool_));
  if (!solveWith(precise, values_, u)) u.clear();
  return u;
}

/// Rows of fixed vertices are those of the identity: the pattern stays.
void LogScale::assemble(const std::vector<std::uint8_t>& isFixed) {
  std::fill(values_.begin(), values_.end(), 0.0);
  for (std::uint32_t v = 0; v < mesh_.vertexCount(); ++v)
    if (isFixed[v]) values_[static_cast<std::size_t>(columnStart_[v])] = 1;
  for (std::uint32_t h = 0; h < entryOfEdge_.size(); ++h) {
    if (entryOfEdge_[h] == kNone) continue;
    const std::uint32_t a = mesh_.vertexOfCorner[h], b = mesh_.vertexOfCorner[nextCorner(h)];
    const double w = mesh_.stiffness(h);
    if (!isFixed[a]) values_[static_cast<std::size_t>(columnStart_[a])] += w;
    if (!isFixed[b]) values_[static_cast<std::size_t>(columnStart_[b])] += w;
    if (!isFixed[a] && !isFixed[b]) values_[entryOfEdge_[h]] -= w;
  }
  beat(pool_, values_.size());
}

}  // namespace abflat
