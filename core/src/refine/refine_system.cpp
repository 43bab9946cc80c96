#include "refine/refine_system.h"

#include <algorithm>
#include <utility>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

constexpr std::uint32_t kAssemblyGrain = 2048;  ///< triangles or columns per piece of work
constexpr std::uint32_t kRegions = 16;

/// How z and w change as a vertex moves in u and in v.
using VertexColumns = std::array<PlaneMap, 2>;

std::array<VertexColumns, 3> columnsOf(const RestTriangle& t) {
  const Point2 c[3] = {{-t.c1x, -t.c1y - t.c2y}, {t.c1x, t.c1y}, {0, t.c2y}};
  std::array<VertexColumns, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [x, y] = c[k];
    out[k] = {PlaneMap{x, -y, x, y}, PlaneMap{y, x, -y, x}};
  }
  return out;
}

double innerProduct(const PlaneMap& a, const PlaneMap& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

PlaneMap product(const std::array<double, 10>& h, const PlaneMap& x) {
  return {h[0] * x[0] + h[1] * x[1] + h[3] * x[2] + h[6] * x[3],
          h[1] * x[0] + h[2] * x[1] + h[4] * x[2] + h[7] * x[3],
          h[3] * x[0] + h[4] * x[1] + h[5] * x[2] + h[8] * x[3],
          h[6] * x[0] + h[7] * x[1] + h[8] * x[2] + h[9] * x[3]};
}

}  // namespace

RefineSystem::RefineSystem(const DiskChart& chart, const RestTriangles& rest, ThreadPool* pool)
    : chart_(chart), rest_(rest), pool_(pool) {
  buildPattern();
}

void RefineSystem::divide(const std::vector<std::uint32_t>& rankOfRow) {
  if (!isParallel(pool_) || chart_.triangleCount() < kRegions * kAssemblyGrain) return;
  regionOfVertex_.resize(chart_.vertexCount());
  for (const ChartVertex v : chart_.vertices())
    regionOfVertex_[v] =
        static_cast<std::uint8_t>(kRegions * std::uint64_t{rankOfRow[2 * v]} / rankOfRow.size());
  triangles_.resize(kRegions);
  for (const ChartTriangle f : chart_.triangles()) {
    const auto regionAt = [&](std::size_t k) {
      return regionOfVertex_[chart_.vertexOfCorner[cornerOf(f, k)]];
    };
    const std::uint8_t a = regionAt(0), b = regionAt(1), c = regionAt(2);
    triangles_[a].push_back(f);
    if (b != a) triangles_[b].push_back(f);
    if (c != a && c != b) triangles_[c].push_back(f);
  }
}

void RefineSystem::buildPattern() {
  const std::uint32_t n = chart_.vertexCount();
  // A vertex and a half-edge to it, as one number that is quick to sort.
  const auto later = [](ChartVertex v, ChartCorner h) {
    return std::uint64_t{v} << 32 | std::uint32_t{h};
  };
  std::vector<std::uint32_t> begin(n + 1, 0);
  const auto forEdges = [&](const auto& use) {
    for (const ChartCorner h : chart_.corners()) {
      if (chart_.twin[h].exists() && chart_.twin[h] < h) continue;
      const ChartVertex a = chart_.vertexOfCorner[h], b = chart_.vertexOfCorner[nextCorner(h)];
      use(h, std::min(a, b), std::max(a, b));
    }
  };
  forEdges([&](ChartCorner, ChartVertex a, ChartVertex) { ++begin[a + 1]; });
  for (const ChartVertex v : chart_.vertices()) begin[v + 1] += begin[v];
  std::vector<std::uint64_t> edges(begin.back());
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  forEdges([&](ChartCorner h, ChartVertex a, ChartVertex b) { edges[fill[a]++] = later(b, h); });

  const Eigen::Index rows = 2 * static_cast<Eigen::Index>(n);
  matrix_.resize(rows, rows);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(3 * n + 4 * edges.size()));
  entryOfEdge_.resize(chart_.twin.size());
  int* start = matrix_.outerIndexPtr();
  int* row = matrix_.innerIndexPtr();
  int at = 0;
  for (const ChartVertex v : chart_.vertices()) {
    std::sort(edges.begin() + begin[v], edges.begin() + begin[v + 1]);
    for (int d = 0; d < 2; ++d) {
      start[2 * v + static_cast<std::uint32_t>(d)] = at;
      for (int e = d; e < 2; ++e) row[at++] = 2 * static_cast<int>(v) + e;
      for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
        if (d == 0) {
          const ChartCorner h(static_cast<std::uint32_t>(edges[i])), o = chart_.twin[h];
          entryOfEdge_[h] = static_cast<std::uint32_t>(at);
          if (o.exists()) entryOfEdge_[o] = static_cast<std::uint32_t>(at);
        }
        for (int e = 0; e < 2; ++e) row[at++] = 2 * static_cast<int>(edges[i] >> 32) + e;
      }
    }
  }
  start[2 * n] = at;
  gradient_.resize(rows);
}

/// Adds only to the rows of the vertices of one region; columns of the matrix count as rows.
void RefineSystem::addTriangle(const RefinePoint& at, ChartTriangle f, std::uint32_t region) {
  const RestTriangle& rest = rest_[f];
  if (rest.weight == 0) return;
  const TriangleVertices v = verticesOf(chart_.vertexOfCorner, f);
  const auto isOwn = [&](std::size_t k) {
    return regionOfVertex_.empty() || regionOfVertex_[ChartVertex(v[k])] == region;
  };
  const auto p = pointsOf(at.uv, v);
  const ElementDerivatives d =
      elementDerivatives(rest.mapTo(p[0], p[1], p[2]), at.energy, at.curvature);
  const std::array<VertexColumns, 3> columns = columnsOf(rest);
  std::array<VertexColumns, 3> products;
  const int* start = matrix_.outerIndexPtr();
  double* value = matrix_.valuePtr();
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t e = 0; e < 2; ++e) {
      products[k][e] = product(d.hessian, columns[k][e]);
      for (double& x : products[k][e]) x *= rest.weight;
    }
  for (std::size_t k = 0; k < 3; ++k) {
    if (isOwn(k)) {
      for (std::size_t e = 0; e < 2; ++e)
        gradient_.data()[2 * std::size_t{v[k]} + e] +=
            rest.weight * innerProduct(d.gradient, columns[k][e]);
      double* own = value + start[2 * v[k]];
      own[0] += innerProduct(columns[k][0], products[k][0]);
      own[1] += innerProduct(columns[k][1], products[k][0]);
      value[start[2 * v[k] + 1]] += innerProduct(columns[k][1], products[k][1]);
    }
    const std::size_t l = (k + 1) % 3;
    const std::size_t early = v[k] < v[l] ? k : l, late = v[k] < v[l] ? l : k;
    if (!isOwn(early)) continue;
    // The columns of the earlier vertex, one after the other.
    double* first = value + entryOfEdge_[cornerOf(f, k)];
    const std::uint32_t u = 2 * v[early];
    double* second = first + (start[u + 1] - start[u]) - 1;
    for (std::size_t e = 0; e < 2; ++e) {
      first[e] += innerProduct(columns[late][e], products[early][0]);
      second[e] += innerProduct(columns[late][e], products[early][1]);
    }
  }
}

void RefineSystem::pull(ChartVertex vertex, const Point2& direction, double stiffness) {
  const auto [x, y] = direction;
  double* value = matrix_.valuePtr();
  const int* start = matrix_.outerIndexPtr();
  value[start[2 * vertex]] += stiffness * x * x;
  value[start[2 * vertex] + 1] += stiffness * x * y;
  value[start[2 * vertex + 1]] += stiffness * y * y;
}

void RefineSystem::fix(const IdVector<ChartVertex, std::uint8_t>& isFixed) {
  const int* start = matrix_.outerIndexPtr();
  const int* row = matrix_.innerIndexPtr();
  double* value = matrix_.valuePtr();
  parallelRanges(pool_, 2 * isFixed.size(), kAssemblyGrain,
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t c = begin; c < end; ++c) {
                     const bool isOwnFixed = isFixed[ChartVertex(c / 2)];
                     for (int i = start[c]; i < start[c + 1]; ++i) {
                       const auto r = static_cast<std::size_t>(row[i]);
                       if (isOwnFixed || isFixed[ChartVertex(r / 2)]) value[i] = r == c ? 1 : 0;
                     }
                     if (isOwnFixed) gradient_.data()[c] = 0;
                   }
                 });
}

void RefineSystem::assemble(const RefinePoint& at,
                            const IdVector<ChartVertex, std::uint8_t>& isFixed) {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  gradient_.setZero();
  if (triangles_.empty())
    for (const ChartTriangle f : chart_.triangles()) addTriangle(at, f, 0);
  parallelFor(pool_, triangles_.size(), [&](std::size_t region) {
    for (const ChartTriangle f : triangles_[region])
      addTriangle(at, f, static_cast<std::uint32_t>(region));
  });
  if (!isFixed.empty()) fix(isFixed);
}

}  // namespace abflat
