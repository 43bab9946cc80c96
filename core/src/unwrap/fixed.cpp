#include "unwrap/fixed.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "exact/orientation.h"
#include "exact/overlap.h"
#include "mesh/triangle_geometry.h"
#include "seam/given_seams.h"

namespace abflat {
namespace {

std::string nameOf(std::uint32_t face) { return "face " + std::to_string(face); }

Status invalid(std::string text) { return {StatusCode::InvalidOption, std::move(text)}; }

std::uint32_t inputFace(const WeldedMesh& welded, const Surface& surface, std::uint32_t triangle) {
  return welded.inputFace[surface.triangulation.face[triangle]];
}

/// Corners of the input's faces, for a corner of the surface.
std::uint32_t inputCorner(const WeldedMesh& welded, const Surface& surface, std::size_t corner) {
  return welded.inputCorner[surface.triangulation.corner[corner]];
}

/// The faces that are named, with the texcoords of the input.
Status addFaces(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                const std::vector<std::uint32_t>& faces, FixedTriangles& out) {
  if (faces.empty()) return {};
  if (input.faceTexcoords.empty())
    return invalid("faces are to keep their texcoords, but the mesh has none");
  std::vector<std::uint8_t> isNamed(input.faceCount(), 0);
  for (const std::uint32_t f : faces) {
    if (f >= input.faceCount())
      return invalid(nameOf(f) + " is to keep its texcoords, but there are only " +
                     std::to_string(input.faceCount()) + " faces");
    isNamed[f] = 1;
  }
  for (std::uint32_t t = 0; t < out.isFixed.size(); ++t)
    out.isFixed[t] = isNamed[inputFace(welded, surface, t)];
  return {};
}

/// Charts of an earlier run, with the texcoords that they have there.
Status addCharts(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                 const UnwrapOptions& options, FixedTriangles& out) {
  if (options.fixedCharts.empty()) return {};
  const KnownLayout& known = options.known;
  const Result<TriangleOrder> order = knownTriangles(known, input, welded, surface);
  if (!order.ok()) return order.status;
  if (known.uv.size() != 2 * known.vertexMap.size())
    return invalid("charts are to stay, but the known layout has no uv for them");
  std::vector<std::uint8_t> exists(known.chartOfTriangle.size(), 0), stays(exists);
  for (const std::uint32_t chart : known.chartOfTriangle)
    if (chart < exists.size()) exists[chart] = 1;
  for (const std::uint32_t chart : options.fixedCharts) {
    if (chart >= exists.size() || !exists[chart])
      return invalid("chart " + std::to_string(chart) +
                     " is to stay, but the known layout has no such chart");
    stays[chart] = 1;
  }
  const auto first = static_cast<std::uint32_t>(out.texcoords.size() / 2);
  out.texcoords.insert(out.texcoords.end(), known.uv.begin(), known.uv.end());
  for (std::uint32_t t = 0; t < out.isFixed.size(); ++t) {
    const std::size_t i = order.value.ofTriangle[t];
    if (!stays[known.chartOfTriangle[i]]) continue;
    out.isFixed[t] = 1;
    for (std::size_t k = 0; k < 3; ++k)
      out.ofCorner[inputCorner(welded, surface, 3 * std::size_t{t} + k)] =
          first + known.triangles[3 * i + k];
  }
  return {};
}

/// Grows what is fixed over edges with the same texcoords on both sides.
void growIslands(const WeldedMesh& welded, const Surface& surface, FixedTriangles& out) {
  std::vector<std::uint32_t> front;
  for (std::uint32_t t = 0; t < out.isFixed.size(); ++t)
    if (out.isFixed[t]) front.push_back(t);
  while (!front.empty()) {
    const std::uint32_t t = front.back();
    front.pop_back();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t twin = surface.table.twin[h];
      if (twin == kNone || out.isFixed[twin / 3] ||
          !hasSameTexcoords({out.texcoords, out.ofCorner}, welded, surface, h))
        continue;
      out.isFixed[twin / 3] = 1;
      front.push_back(twin / 3);
    }
  }
}

Status checkTexcoords(const WeldedMesh& welded, const Surface& surface, const FixedTriangles& out) {
  for (std::uint32_t t = 0; t < out.isFixed.size(); ++t) {
    if (!out.isFixed[t]) continue;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      if (out.ofCorner[inputCorner(welded, surface, h)] == kNoTexcoord)
        return invalid(nameOf(inputFace(welded, surface, t)) +
                       " is to keep its texcoords, but has none at a corner; leave it out");
  }
  return {};
}

/// Given coordinates of the chart's vertices.
std::vector<double> givenUv(const CutMesh& mesh, const FixedTriangles& fixed, std::size_t i) {
  const ChartTopology chart = mesh.set.topology(i);
  const Indices triangles = mesh.set.triangles(i);
  std::vector<double> uv(2 * static_cast<std::size_t>(chart.vertexCount()));
  for (std::size_t c = 0; c < chart.vertexOfCorner.size(); ++c) {
    const std::size_t h = 3 * static_cast<std::size_t>(triangles[c / 3]) + c % 3;
    const std::size_t texcoord = fixed.ofCorner[inputCorner(mesh.welded, mesh.surface, h)];
    for (std::size_t d = 0; d < 2; ++d)
      uv[2 * static_cast<std::size_t>(chart.vertexOfCorner[c]) + d] =
          fixed.texcoords[2 * texcoord + d];
  }
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
  std::function<std::uint32_t(std::size_t)> face;
};

Status checkTriangles(const FixedChart& c) {
  for (std::uint32_t f = 0; f < c.chart.triangleCount(); ++f) {
    const std::uint32_t* v = &c.chart.vertexOfCorner[3 * f];
    const int sign = orientation(&c.uv[2 * v[0]], &c.uv[2 * v[1]], &c.uv[2 * v[2]]);
    if (sign < 0 || (sign == 0 && !isDegenerate(c.chart.angles[f])))
      return invalid(nameOf(c.face(f)) + " is to keep its texcoords, but is " +
                     (sign < 0 ? "flipped" : "without area") +
                     " there; mend its island or leave it out");
  }
  return {};
}

/// Within the tile that has the middle of its box.
Status checkTile(const FixedChart& c, bool hasTiles) {
  constexpr double kLastColumn = 9, kLastRow = 898;  // of UDIM
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (std::size_t k = 0; k < c.uv.size(); ++k) {
    low[k % 2] = std::min(low[k % 2], c.uv[k]);
    high[k % 2] = std::max(high[k % 2], c.uv[k]);
  }
  double tile[2] = {0, 0};
  for (std::size_t d = 0; d < 2 && hasTiles; ++d)
    tile[d] = std::clamp(std::floor((low[d] + high[d]) / 2), 0.0, d == 0 ? kLastColumn : kLastRow);
  for (std::size_t h = 0; h < c.chart.vertexOfCorner.size(); ++h) {
    const double* uv = &c.uv[2 * static_cast<std::size_t>(c.chart.vertexOfCorner[h])];
    for (std::size_t d = 0; d < 2; ++d)
      if (!(uv[d] >= tile[d] && uv[d] <= tile[d] + 1))
        return invalid(nameOf(c.face(h / 3)) + " is to keep its texcoords, but with " +
                       placeText(uv) + " its island is not within " +
                       (hasTiles ? "one tile" : "the unit square") +
                       "; move the island or leave it out");
  }
  return {};
}

}  // namespace

Result<FixedTriangles> fixedTriangles(const PolygonMesh& input, const WeldedMesh& welded,
                                      const Surface& surface, const UnwrapOptions& options) {
  FixedTriangles out;
  if (options.fixedFaces.empty() && options.fixedCharts.empty()) return out;
  out.isFixed.assign(surface.table.triangleCount(), 0);
  out.texcoords = input.texcoords;
  out.ofCorner = input.faceTexcoords;
  out.ofCorner.resize(input.faceVertices.size(), kNoTexcoord);
  if (Status s = addFaces(input, welded, surface, options.fixedFaces, out); !s.ok()) return s;
  if (Status s = addCharts(input, welded, surface, options, out); !s.ok()) return s;
  growIslands(welded, surface, out);
  if (Status s = checkTexcoords(welded, surface, out); !s.ok()) return s;
  out.borders.assign(surface.table.twin.size(), 0);
  for (std::uint32_t h = 0; h < out.borders.size(); ++h) {
    const std::uint32_t twin = surface.table.twin[h];
    if (twin == kNone || !(out.isFixed[h / 3] || out.isFixed[twin / 3])) continue;
    if (out.isFixed[h / 3] != out.isFixed[twin / 3] ||
        !hasSameTexcoords({out.texcoords, out.ofCorner}, welded, surface, h))
      out.borders[h] = out.borders[twin] = 1;
  }
  return out;
}

Status layOutFixed(const CutMesh& mesh, const FixedTriangles& fixed, bool hasTiles,
                   std::vector<FlatChart>& flat) {
  if (fixed.isFixed.empty()) return {};
  std::vector<double> triangles;     // 6 coordinates each
  std::vector<std::uint32_t> faces;  // of the input, for each of these
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Indices own = mesh.set.triangles(i);
    if (!fixed.isFixed[own.front()]) continue;
    const DiskChart chart = mesh.set.chart(i);
    FlatChart& out = flat[i];
    out = {};
    out.isFixed = out.isGiven = true;
    out.uv = givenUv(mesh, fixed, i);
    out.unpacked.assign(out.uv.size(), NAN);
    const FixedChart c{chart, out.uv,
                       [&](std::size_t f) { return inputFace(mesh.welded, mesh.surface, own[f]); }};
    if (Status s = checkTile(c, hasTiles); !s.ok()) return s;
    if (Status s = checkTriangles(c); !s.ok()) return s;
    out.solver = "given";
    out.area = areaOf(chart);
    out.distortion = ChartDistortion(measureDistortion(chart, out.uv));
    for (std::size_t f = 0; f < own.size(); ++f) faces.push_back(c.face(f));
    for (const std::size_t v : chart.vertexOfCorner)
      triangles.insert(triangles.end(), {out.uv[2 * v], out.uv[2 * v + 1]});
  }
  const auto pair = findOverlap(triangles);
  if (!pair) return {};
  return invalid("faces " + std::to_string(faces[(*pair)[0]]) + " and " +
                 std::to_string(faces[(*pair)[1]]) +
                 " are to keep their texcoords, but overlap there; mend their islands or leave one "
                 "of them out");
}

}  // namespace abflat
