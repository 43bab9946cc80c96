#include "unwrap/known.h"

#include <cmath>

#include "unwrap/straight_seams.h"

namespace abflat {
namespace {

/// What an earlier run knows, by triangles of the surface.
struct Known {
  const KnownLayout& layout;
  TriangleOrder order;
  std::vector<std::uint32_t> trianglesOfChart;  ///< per known chart, on the surface

  std::uint32_t chartOf(std::uint32_t triangle) const {
    return layout.chartOfTriangle[order.ofTriangle[triangle]];
  }
  const double* uv(std::uint32_t triangle, std::size_t k) const {
    const std::size_t corner = 3 * static_cast<std::size_t>(order.ofTriangle[triangle]) + k;
    return &layout.unpacked[2 * static_cast<std::size_t>(layout.triangles[corner])];
  }
};

Status isOfOther(const std::string& what) {
  return {StatusCode::InvalidOption,
          "the known layout is not of this mesh: " + what + "; unwrap without it first"};
}

Status checkSizes(const KnownLayout& known, std::size_t triangles) {
  if (known.triangles.size() != 3 * triangles || known.chartOfTriangle.size() != triangles)
    return isOfOther("it has " + std::to_string(known.triangles.size() / 3) +
                     " triangles and the mesh " + std::to_string(triangles));
  if (known.unpacked.size() != 2 * known.vertexMap.size())
    return isOfOther("it has " + std::to_string(known.unpacked.size() / 2) + " coordinates for " +
                     std::to_string(known.vertexMap.size()) + " vertices");
  return {};
}

/// Every triangle has the vertices of the mesh, and a chart.
Status checkTriangles(const KnownLayout& known, const TriangleOrder& order,
                      const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface) {
  for (std::uint32_t t = 0; t < order.ofTriangle.size(); ++t) {
    const std::uint32_t i = order.ofTriangle[t];
    bool isSame = known.chartOfTriangle[i] < known.chartOfTriangle.size();
    for (std::size_t k = 0; k < 3 && isSame; ++k) {
      const std::uint32_t v = known.triangles[3 * static_cast<std::size_t>(i) + k];
      const std::uint32_t corner = welded.inputCorner[surface.triangulation.corner[3 * t + k]];
      isSame = v < known.vertexMap.size() && known.vertexMap[v] == input.faceVertices[corner];
    }
    if (!isSame) return isOfOther("triangle " + std::to_string(i) + " has other vertices");
  }
  return {};
}

/// Known coordinates of the chart's vertices; empty where triangles are missing or more, or where
/// an edge of the chart was a seam. A seam that is new leaves a layout that touches itself.
std::vector<double> knownUv(const Known& known, const ChartTopology& chart, Indices triangles) {
  const std::uint32_t id = known.chartOf(triangles.front());
  if (known.trianglesOfChart[id] != triangles.size()) return {};
  std::vector<double> uv(2 * static_cast<std::size_t>(chart.vertexCount()), NAN);
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    if (known.chartOf(triangles[f]) != id) return {};
    for (std::size_t k = 0; k < 3; ++k) {
      const double* from = known.uv(triangles[f], k);
      double* to = &uv[2 * static_cast<std::size_t>(chart.vertexOfCorner[3 * f + k])];
      for (std::size_t d = 0; d < 2; ++d) {
        if (!std::isfinite(from[d]) || (!std::isnan(to[d]) && to[d] != from[d])) return {};
        to[d] = from[d];
      }
    }
  }
  return uv;
}

/// Those that charts had then.
Outlines knownOutlines(const Known& known, const Surface& surface) {
  const std::vector<std::uint32_t>& twin = surface.table.twin;
  std::vector<std::uint8_t> isCut(twin.size(), 1);
  const auto isOnePlace = [&](std::uint32_t a, std::uint32_t b) {
    const double *p = known.uv(a / 3, a % 3), *q = known.uv(b / 3, b % 3);
    return p[0] == q[0] && p[1] == q[1];
  };
  for (std::uint32_t h = 0; h < twin.size(); ++h) {
    const std::uint32_t o = twin[h];
    if (o != kNone && known.chartOf(h / 3) == known.chartOf(o / 3))
      isCut[h] = !isOnePlace(h, nextCorner(o)) || !isOnePlace(nextCorner(h), o);
  }
  return findOutlines(surface, isCut);
}

/// Checked and measured as if it had just been solved.
FlatChart takeOver(const DiskChart& chart, const ChartWishes& wishes,
                   std::vector<double> unpacked) {
  FlatChart out;
  out.solver = "known";
  std::vector<double> uv = unpacked;
  for (double& x : uv) x /= chart.unit;
  if (!checkSeparated(chart, uv).valid()) return {};
  out.area = areaOf(chart);
  out.distortion = ChartDistortion(measureDistortion(chart, uv));
  if (!wishes.straight.empty()) {
    out.uncommon = std::make_unique<UncommonParts>();
    out.uncommon->straight = reportStraight(chart, wishes.straight, uv);
    out.uncommon->straight->released = wishes.released;
    out.uncommon->straightPlaces = wishes.straight;
  }
  out.unpacked = std::move(unpacked);
  return out;
}

}  // namespace

Result<TriangleOrder> knownTriangles(const KnownLayout& known, const PolygonMesh& input,
                                     const WeldedMesh& welded, const Surface& surface) {
  TriangleOrder order = triangleOrder(input, welded, surface);
  if (Status s = checkSizes(known, order.firstOfFace.back()); !s.ok()) return s;
  if (Status s = checkTriangles(known, order, input, welded, surface); !s.ok()) return s;
  return order;
}

Status takeKnown(const CutMesh& mesh, const std::vector<ChartWishes>& wishes,
                 const UnwrapOptions& options, ThreadPool& pool, std::vector<FlatChart>& flat) {
  const KnownLayout& layout = options.known;
  if (layout.triangles.empty()) return {};
  Result<TriangleOrder> order = knownTriangles(layout, mesh.input, mesh.welded, mesh.surface);
  if (!order.ok()) return order.status;
  Known known{layout, std::move(order.value), {}};
  // Other angles were wanted then.
  if (layout.t != options.t || layout.balance != options.balance ||
      layout.straightSeams != options.straightSeams)
    return {};
  known.trianglesOfChart.assign(layout.chartOfTriangle.size(), 0);
  for (std::uint32_t t = 0; t < known.order.ofTriangle.size(); ++t)
    ++known.trianglesOfChart[known.chartOf(t)];
  // Where a seam ends, and with it what is straight, depends on the charts around.
  Outlines before, now;
  if (options.straightSeams) {
    before = knownOutlines(known, mesh.surface);
    now = findOutlines(mesh.surface, mesh.set);
  }
  parallelFor(&pool, mesh.set.size(), [&](std::size_t i) {
    if (!flat[i].unpacked.empty()) return;
    std::vector<double> uv = knownUv(known, mesh.set.topology(i), mesh.set.triangles(i));
    if (uv.empty()) return;
    if (options.straightSeams && !hasSameEnds(mesh.surface, mesh.set, i, before, now)) return;
    flat[i] = takeOver(mesh.set.chart(i), wishes[i], std::move(uv));
  });
  return {};
}

KnownLayout knownLayout(const UnwrapResult& earlier) {
  KnownLayout out;
  out.t = earlier.report.options.t;
  out.balance = earlier.report.options.balance;
  out.straightSeams = earlier.report.options.straightSeams;
  out.vertexMap = earlier.vertexMap;
  out.triangles = earlier.triangles;
  out.chartOfTriangle = earlier.chartOfTriangle;
  out.unpacked.reserve(2 * earlier.vertexUv.size());
  out.uv.reserve(2 * earlier.vertexUv.size());
  for (const std::size_t i : earlier.vertexUv) {
    out.unpacked.insert(out.unpacked.end(), {earlier.unpacked[2 * i], earlier.unpacked[2 * i + 1]});
    out.uv.insert(out.uv.end(), {earlier.uv[2 * i], earlier.uv[2 * i + 1]});
  }
  return out;
}

}  // namespace abflat
