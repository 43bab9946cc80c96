#include "unwrap/fixed.h"

#include <algorithm>
#include <cmath>

#include "base/invalid.h"
#include "base/number_text.h"
#include "base/point2.h"
#include "check/stacked_charts.h"
#include "exact/orientation.h"
#include "exact/overlap.h"
#include "mesh/triangle_geometry.h"
#include "seam/given_seams.h"
#include "unwrap/unfit_islands.h"

namespace abflat {
namespace {

/// Adds the faces listed in the options, with the texcoords of the input.
Status addFaces(const SurfaceMap& map, const std::vector<std::uint32_t>& faces,
                FixedTriangles& out) {
  if (faces.empty()) return {};
  const InputMesh& input = map.input();
  if (input.extras().faceTexcoords.empty()) return invalid("the mesh has no texcoords to keep");
  IdVector<InputFace, std::uint8_t> isNamed(input.faceCount(), 0);
  for (const std::uint32_t face : faces) {
    const InputFace f(face);
    if (f >= input.faceCount())
      return invalid(nameOf(f) + " cannot keep its texcoords: the mesh has only " +
                     std::to_string(input.faceCount()) + " faces");
    isNamed[f] = 1;
  }
  for (const SurfaceTriangle t : out.isFixed.ids()) out.isFixed[t] = isNamed[map.face(t)];
  return {};
}

/// Adds charts of an earlier run, with the texcoords they had there.
Status addCharts(const SurfaceMap& map, const UnwrapOptions& options, FixedTriangles& out) {
  if (options.reuse.fixedCharts.empty()) return {};
  const KnownLayout& known = options.reuse.known;
  const Result<TriangleOrder> order = knownTriangles(known, map);
  if (!order.ok()) return order.status();
  if (known.uv.size() != 2 * known.vertexMap.size())
    return invalid("the known layout has no uv for the fixed charts");
  std::vector<std::uint8_t> exists(known.chartOfTriangle.size(), 0), stays(exists);
  for (const std::uint32_t chart : known.chartOfTriangle)
    if (chart < exists.size()) exists[chart] = 1;
  for (const std::uint32_t chart : options.reuse.fixedCharts) {
    if (chart >= exists.size() || !exists[chart])
      return invalid("chart " + std::to_string(chart) +
                     " cannot stay fixed: the known layout has no such chart");
    stays[chart] = 1;
  }
  const auto first = static_cast<std::uint32_t>(out.texcoords.size() / 2);
  out.texcoords.insert(out.texcoords.end(), known.uv.begin(), known.uv.end());
  for (const SurfaceTriangle t : out.isFixed.ids()) {
    const std::size_t i = order.value().ofTriangle[t];
    if (!stays[known.chartOfTriangle[i]]) continue;
    out.isFixed[t] = 1;
    for (const SurfaceCorner c : cornersOf(t))
      out.ofCorner[map.corner(c)] = first + known.triangles[3 * i + placeInTriangle(c)];
  }
  return {};
}

/// Grows the fixed set across edges with the same texcoords on both sides.
void growIslands(const SurfaceMap& map, FixedTriangles& out) {
  std::vector<SurfaceTriangle> front;
  for (const SurfaceTriangle t : out.isFixed.ids())
    if (out.isFixed[t]) front.push_back(t);
  while (!front.empty()) {
    const SurfaceTriangle t = front.back();
    front.pop_back();
    for (const SurfaceCorner h : cornersOf(t)) {
      const SurfaceCorner twin = map.surface().table.twin[h];
      if (!twin.exists() || out.isFixed[triangleOf(twin)] ||
          !hasSameTexcoords({out.texcoords, out.ofCorner}, map, h))
        continue;
      out.isFixed[triangleOf(twin)] = 1;
      front.push_back(triangleOf(twin));
    }
  }
}

Status checkTexcoords(const SurfaceMap& map, const FixedTriangles& out) {
  for (const SurfaceTriangle t : out.isFixed.ids()) {
    if (!out.isFixed[t]) continue;
    for (const SurfaceCorner c : cornersOf(t))
      if (out.ofCorner[map.corner(c)] == kNoTexcoord)
        return invalid(nameOf(map.face(t)) +
                       " cannot keep its texcoords: a corner has none. Do not keep that face");
  }
  return {};
}

/// The given coordinates of the chart's vertices.
std::vector<double> givenUv(const SurfaceMap& map, const FixedTriangles& fixed,
                            const ChartTopology& chart) {
  std::vector<double> uv(2 * chart.vertexCount());
  for (const ChartCorner c : chart.surfaceCorners())
    setPoint(uv, chart.vertexOfCorner[c],
             pointAt(fixed.texcoords, fixed.ofCorner[map.corner(chart.onSurface(c))]));
  return uv;
}

std::string placeText(const double* uv) {
  std::string out = "(";
  for (std::size_t d = 0; d < 2; ++d) {
    char digits[kMostDoubleChars];
    out.append(digits, writeDouble(digits, uv[d])).append(d == 0 ? ", " : ")");
  }
  return out;
}

/// A chart and the input face of each of its triangles.
struct FixedChart {
  const DiskChart& chart;
  const std::vector<double>& uv;
  std::function<InputFace(ChartTriangle)> face;
  int side = 1;       ///< -1: it runs clockwise, as it should
  double aspect = 1;  ///< of a tile
};

Status checkTriangles(const FixedChart& c) {
  for (const ChartTriangle f : c.chart.triangles()) {
    const auto p = pointsOf(c.uv, verticesOf(c.chart.vertexOfCorner, f));
    const int sign = c.side * orientation(p[0], p[1], p[2]);
    if (sign < 0 || (sign == 0 && !isDegenerate(c.chart.angles[f])))
      return invalid(nameOf(c.face(f)) + "'s texcoords are " +
                     (sign < 0 ? "mirrored" : "degenerate") +
                     ". Fix that island, or do not keep it");
  }
  return {};
}

/// The chart must lie within the tile that contains the middle of its box.
Status checkTile(const FixedChart& c, bool hasTiles) {
  Point2 low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL};
  for (std::size_t k = 0; k < c.uv.size(); ++k) {
    low[k % 2] = std::min(low[k % 2], c.uv[k]);
    high[k % 2] = std::max(high[k % 2], c.uv[k]);
  }
  const Point2 tile = tileAround(low, high, hasTiles);
  for (const ChartCorner h : c.chart.corners()) {
    const double* uv = &c.uv[2 * std::size_t{c.chart.vertexOfCorner[h]}];
    for (std::size_t d = 0; d < 2; ++d)
      if (!(uv[d] >= tile[d] && uv[d] <= tile[d] + 1))
        return invalid(nameOf(c.face(triangleOf(h))) + "'s texcoord " + placeText(uv) +
                       " is outside " + (hasTiles ? "the tile of its island" : "the unit square") +
                       ". Move that island, or do not keep it");
  }
  return {};
}

/// Which of the fixed charts lie on others, as far as that is wanted.
std::vector<StackedChart> stackedAmongFixed(const CutMesh& mesh, const FixedTriangles& fixed,
                                            Stack stack) {
  std::vector<StackedChart> none(mesh.set.size());
  if (stack == Stack::None) return none;
  std::vector<double> uv;
  std::vector<std::uint32_t> triangles, chartOf;
  for (const ChartId i : mesh.set.ids()) {
    const ChartTopology chart = mesh.set.topology(i);
    if (!fixed.isFixed[chart.triangles.front()]) continue;
    const auto first = static_cast<std::uint32_t>(uv.size() / 2);
    const std::vector<double> own = givenUv(mesh.map, fixed, chart);
    uv.insert(uv.end(), own.begin(), own.end());
    for (const ChartCorner c : chart.surfaceCorners())
      triangles.push_back(first + chart.vertexOfCorner[c]);
    chartOf.insert(chartOf.end(), chart.triangles.size(), i);
  }
  return findStackedCharts(uv, triangles, chartOf, mesh.set.size(), stack == Stack::Mirrored);
}

bool runsClockwise(const DiskChart& chart, const std::vector<double>& uv) {
  for (const ChartTriangle f : chart.triangles()) {
    const auto p = pointsOf(uv, verticesOf(chart.vertexOfCorner, f));
    if (orientation(p[0], p[1], p[2]) > 0) return false;
  }
  return true;
}

ChartDistortion distortionOf(const FixedChart& c) {
  std::vector<double> uv = c.uv;
  for (std::size_t i = 0; i < uv.size(); i += 2) uv[i] *= c.side * c.aspect;
  return ChartDistortion(measureDistortion(c.chart, uv));
}

}  // namespace

Result<FixedTriangles> fixedTriangles(const SurfaceMap& map, const UnwrapOptions& options) {
  FixedTriangles out;
  if (options.reuse.fixedFaces.empty() && options.reuse.fixedCharts.empty()) return out;
  const CornerTable& table = map.surface().table;
  out.isFixed.assign(table.triangles().size(), 0);
  out.texcoords = map.input().extras().texcoords;
  out.ofCorner = map.input().extras().faceTexcoords;
  out.ofCorner.resize(map.input().cornerCount(), kNoTexcoord);
  if (Status s = addFaces(map, options.reuse.fixedFaces, out); !s.ok()) return s;
  if (Status s = addCharts(map, options, out); !s.ok()) return s;
  growIslands(map, out);
  if (options.reuse.keepsValidOnly) out.note = freeUnfitIslands(map, options.udim, out);
  if (Status s = checkTexcoords(map, out); !s.ok()) return s;
  out.borders.assign(table.twin.size(), 0);
  for (const SurfaceCorner h : table.corners()) {
    const SurfaceCorner twin = table.twin[h];
    if (!twin.exists()) continue;
    const bool isHere = out.isFixed[triangleOf(h)], isThere = out.isFixed[triangleOf(twin)];
    if (isHere != isThere || (isHere && !hasSameTexcoords({out.texcoords, out.ofCorner}, map, h)))
      out.borders[h] = out.borders[twin] = 1;
  }
  return out;
}

Status layOutFixed(const CutMesh& mesh, const FixedTriangles& fixed, const UnwrapOptions& options,
                   FlatCharts& flat) {
  if (fixed.isFixed.empty()) return {};
  std::vector<double> triangles;  // 6 coordinates each
  std::vector<InputFace> faces;   // one per triangle
  const std::vector<StackedChart> stacked = stackedAmongFixed(mesh, fixed, options.stack);
  for (const ChartId i : flat.ids()) {
    const ChartTopology topology = mesh.set.topology(i);
    if (!fixed.isFixed[topology.triangles.front()]) continue;
    const DiskChart chart = mesh.set.chart(i);
    FlatChart& out = flat[i];
    out = {};
    out.isFixed = out.isGiven = true;
    out.uv = givenUv(mesh.map, fixed, topology);
    out.unpacked.assign(out.uv.size(), NAN);
    // What it lies on may be a chart that merely keeps its place.
    const bool isMirrored =
        stacked[i].isMirrored || (options.reuse.keepsPlaces && options.stack == Stack::Mirrored &&
                                  runsClockwise(chart, out.uv));
    const FixedChart c{chart, out.uv,
                       [&](ChartTriangle f) { return mesh.map.face(topology.triangles[f]); },
                       isMirrored ? -1 : 1, options.resolution.aspect()};
    if (Status s = options.reuse.keepsPlaces ? Status() : checkTile(c, options.udim); !s.ok())
      return s;
    if (Status s = checkTriangles(c); !s.ok()) {
      if (!options.reuse.keepsPlaces) return s;
      out.problem = kWrongInPlace;
    }
    out.solver = Solver::Given;
    out.area = areaOf(chart);
    out.distortion = distortionOf(c);
    out.isStacked = stacked[i].on != kOnNone;
    if (out.isStacked) continue;
    for (const SurfaceTriangle f : topology.triangles) faces.push_back(mesh.map.face(f));
    for (const ChartVertex v : chart.vertexOfCorner)
      triangles.insert(triangles.end(), {out.uv[2 * v], out.uv[2 * v + 1]});
  }
  if (options.reuse.keepsPlaces) return {};
  const auto pair = findOverlap(triangles);
  if (!pair) return {};
  return invalid("the texcoords of faces " + std::to_string(faces[(*pair)[0]]) + " and " +
                 std::to_string(faces[(*pair)[1]]) +
                 " overlap. Fix their islands, or do not keep both");
}

}  // namespace abflat
