#include "unwrap/known.h"

#include <algorithm>
#include <cmath>

#include "base/point2.h"
#include "check/validity.h"
#include "unwrap/straight_seams.h"

namespace abflat {
namespace {

/// What an earlier run knows, by triangle of the surface.
struct Known {
  const KnownLayout& layout;
  TriangleOrder order;
  std::vector<std::uint32_t> trianglesOfChart;  ///< per known chart, on the surface

  std::uint32_t chartOf(SurfaceTriangle f) const {
    return layout.chartOfTriangle[order.ofTriangle[f]];
  }
  std::uint32_t vertex(SurfaceCorner c) const {
    return layout.triangles[3 * std::size_t{order.ofTriangle[triangleOf(c)]} + placeInTriangle(c)];
  }
  Point2 uv(SurfaceCorner c) const { return pointAt(layout.unpacked, vertex(c)); }
};

Status isOfOther(const std::string& what) {
  return {StatusCode::InvalidOption,
          "the known layout belongs to another mesh: " + what + ". Unwrap without it first"};
}

Status checkSizes(const KnownLayout& known, std::size_t triangles) {
  if (known.triangles.size() != 3 * triangles || known.chartOfTriangle.size() != triangles)
    return isOfOther("it has " + std::to_string(known.triangles.size() / 3) +
                     " triangles, but the mesh has " + std::to_string(triangles));
  if (known.unpacked.size() != 2 * known.vertexMap.size())
    return isOfOther("it has " + std::to_string(known.unpacked.size() / 2) + " coordinates for " +
                     std::to_string(known.vertexMap.size()) + " vertices");
  return {};
}

/// Checks that charts can stay where they are.
Status checkPlaces(const KnownLayout& known) {
  const auto invalid = [](std::string text) {
    return Status{StatusCode::InvalidOption, std::move(text)};
  };
  if (known.uv.size() != known.unpacked.size())
    return invalid("the known layout has no uv, so charts cannot stay there");
  // Far more tiles than any atlas has, and well within single precision.
  constexpr double kMost = 1e6;
  for (std::size_t i = 0; i < known.uv.size(); ++i)
    if (!(std::abs(known.uv[i]) <= kMost))
      return invalid("charts cannot stay where they are known: the uv of vertex " +
                     std::to_string(i / 2) + " is not a number from -10^6 to 10^6");
  return {};
}

/// Checks that every triangle has the mesh's vertices, and a chart.
Status checkCorners(const KnownLayout& known, const TriangleOrder& order, const SurfaceMap& map) {
  for (const SurfaceTriangle f : order.ofTriangle.ids()) {
    const OutputTriangle i = order.ofTriangle[f];
    bool isSame = known.chartOfTriangle[i] < known.chartOfTriangle.size();
    for (const SurfaceCorner c : cornersOf(f)) {
      const std::uint32_t v = known.triangles[3 * std::size_t{i} + placeInTriangle(c)];
      isSame = isSame && v < known.vertexMap.size() && known.vertexMap[v] == map.vertex(c);
    }
    if (!isSame) return isOfOther("triangle " + std::to_string(i) + " has different vertices");
  }
  return {};
}

/// Known coordinates of the chart's vertices. Empty if the triangles are not exactly those of a
/// known chart, or if an edge inside the chart was a seam. A new seam is fine: the layout merely
/// touches itself there.
std::vector<double> knownUv(const Known& known, const ChartTopology& chart) {
  const std::uint32_t id = known.chartOf(chart.triangles.front());
  if (known.trianglesOfChart[id] != chart.triangles.size()) return {};
  std::vector<double> uv(2 * chart.vertexCount(), NAN);
  for (const ChartCorner c : chart.surfaceCorners()) {
    const SurfaceCorner onSurface = chart.onSurface(c);
    if (known.chartOf(triangleOf(onSurface)) != id) return {};
    const Point2 from = known.uv(onSurface);
    double* to = &uv[2 * std::size_t{chart.vertexOfCorner[c]}];
    for (std::size_t d = 0; d < 2; ++d) {
      if (!std::isfinite(from[d]) || (!std::isnan(to[d]) && to[d] != from[d])) return {};
      to[d] = from[d];
    }
  }
  return uv;
}

/// Whether the chart has no seam that it did not have in the earlier run.
bool isUncut(const Known& known, const ChartTopology& chart) {
  std::vector<std::uint32_t> vertices;
  for (const ChartCorner c : chart.surfaceCorners())
    vertices.push_back(known.vertex(chart.onSurface(c)));
  std::sort(vertices.begin(), vertices.end());
  const auto end = std::unique(vertices.begin(), vertices.end());
  return static_cast<std::size_t>(end - vertices.begin()) == chart.vertexCount();
}

/// The outlines that charts had in the earlier run.
Outlines knownOutlines(const Known& known, const Surface& surface) {
  IdVector<SurfaceCorner, std::uint8_t> isCut(surface.table.twin.size(), 1);
  for (const SurfaceCorner h : surface.table.corners()) {
    const SurfaceCorner o = surface.table.twin[h];
    if (o.exists() && known.chartOf(triangleOf(h)) == known.chartOf(triangleOf(o)))
      isCut[h] = known.uv(h) != known.uv(nextCorner(o)) || known.uv(nextCorner(h)) != known.uv(o);
  }
  return findOutlines(surface, isCut);
}

/// The layout measured as if it had just been solved.
FlatChart takeOver(const DiskChart& chart, const ChartConstraints& constraints,
                   std::vector<double> unpacked, const std::vector<double>& uv) {
  FlatChart out;
  out.solver = Solver::Known;
  out.area = areaOf(chart);
  out.distortion = ChartDistortion(measureDistortion(chart, uv));
  if (!constraints.straight.empty()) {
    out.uncommon = std::make_unique<UncommonParts>();
    out.uncommon->straight = reportStraight(chart, constraints.straight, uv);
    out.uncommon->straight->released = constraints.released;
    out.uncommon->straightPlaces = constraints.straight;
  }
  out.unpacked = std::move(unpacked);
  return out;
}

/// Whether a chart is valid where it stays, or mirrored and may be so on another one.
bool isValidInPlace(const DiskChart& chart, std::vector<double> uv, Stack stack) {
  if (checkValidity(chart, uv).valid()) return true;
  if (stack != Stack::Mirrored) return false;
  for (std::size_t i = 0; i < uv.size(); i += 2) uv[i] = -uv[i];
  return checkValidity(chart, uv).valid();
}

/// Keeps the chart where it is in the known atlas, even if that is wrong.
void keepPlace(const Known& known, const ChartTopology& topology, const DiskChart& chart,
               Stack stack, FlatChart& flat) {
  flat.isFixed = flat.isGiven = true;
  flat.uv.resize(flat.unpacked.size());
  for (const ChartCorner c : topology.surfaceCorners())
    setPoint(flat.uv, topology.vertexOfCorner[c],
             pointAt(known.layout.uv, known.vertex(topology.onSurface(c))));
  if (!isValidInPlace(chart, flat.uv, stack)) flat.problem = kWrongInPlace;
}

}  // namespace

Result<TriangleOrder> knownTriangles(const KnownLayout& known, const SurfaceMap& map) {
  TriangleOrder order = triangleOrder(map);
  if (Status s = checkSizes(known, order.firstOfFace.back()); !s.ok()) return s;
  if (Status s = checkCorners(known, order, map); !s.ok()) return s;
  return order;
}

Status takeKnown(const CutMesh& mesh, const IdVector<ChartId, ChartConstraints>& constraints,
                 const UnwrapOptions& options, ThreadPool& pool, FlatCharts& flat) {
  const KnownLayout& layout = options.reuse.known;
  if (layout.triangles.empty()) return {};
  Result<TriangleOrder> order = knownTriangles(layout, mesh.map);
  if (!order.ok()) return order.status();
  if (options.reuse.keepsPlaces)
    if (Status s = checkPlaces(layout); !s.ok()) return s;
  Known known{layout, std::move(order.value()), {}};
  // The earlier run asked for different angles.
  if (layout.t != options.t || layout.balance != options.balance ||
      layout.straightSeams != options.straightSeams)
    return {};
  known.trianglesOfChart.assign(layout.chartOfTriangle.size(), 0);
  for (const SurfaceTriangle f : known.order.ofTriangle.ids())
    ++known.trianglesOfChart[known.chartOf(f)];
  // Where a seam ends, and so what is straight, depends on the neighbouring charts.
  Outlines before, now;
  if (options.straightSeams) {
    before = knownOutlines(known, mesh.map.surface());
    now = findOutlines(mesh.map.surface(), mesh.set);
  }
  parallelFor(&pool, mesh.set.size(), [&](std::size_t k) {
    const ChartId i(k);
    if (!flat[i].unpacked.empty()) return;
    std::vector<double> uv = knownUv(known, mesh.set.topology(i));
    if (uv.empty()) return;
    if (options.straightSeams && !hasSameEnds(mesh, i, before, now)) return;
    const DiskChart chart = mesh.set.chart(i);
    const std::vector<double> inUnits = inChartUnit(chart, uv);
    const bool keepsPlace = options.reuse.keepsPlaces && constraints[i].pins.empty();
    if (!checkSeparated(chart, inUnits).valid()) {
      // What is wrong stays so unless a seam may help.
      if (!keepsPlace || options.seams.isAuto || !isUncut(known, mesh.set.topology(i))) return;
    }
    flat[i] = takeOver(chart, constraints[i], std::move(uv), inUnits);
    if (keepsPlace) keepPlace(known, mesh.set.topology(i), chart, options.stack, flat[i]);
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
