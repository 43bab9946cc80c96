#include "unwrap_fixed.h"

#include <algorithm>
#include <cmath>

#include "check/orientation.h"
#include "check/overlap.h"
#include "io/number_text.h"
#include "mesh/triangle_geometry.h"
#include "seam/given_seams.h"

namespace abflat {
namespace {

std::string nameOf(std::uint32_t face) { return "face " + std::to_string(face); }

Status invalid(std::string text) { return {StatusCode::InvalidOption, std::move(text)}; }

std::uint32_t inputFace(const WeldedMesh& welded, const Surface& surface, std::uint32_t triangle) {
  return welded.inputFace[surface.triangulation.face[triangle]];
}

/// Grows what is fixed over edges with the same texcoords on both sides.
void growIslands(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                 std::vector<std::uint8_t>& isFixed) {
  std::vector<std::uint32_t> front;
  for (std::uint32_t t = 0; t < isFixed.size(); ++t)
    if (isFixed[t]) front.push_back(t);
  while (!front.empty()) {
    const std::uint32_t t = front.back();
    front.pop_back();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t twin = surface.table.twin[h];
      if (twin == kNone || isFixed[twin / 3] || !hasSameTexcoords(input, welded, surface, h))
        continue;
      isFixed[twin / 3] = 1;
      front.push_back(twin / 3);
    }
  }
}

Status checkTexcoords(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                      const std::vector<std::uint8_t>& isFixed) {
  for (std::uint32_t t = 0; t < isFixed.size(); ++t) {
    if (!isFixed[t]) continue;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      if (input.faceTexcoords[welded.inputCorner[surface.triangulation.corner[h]]] == kNoTexcoord)
        return invalid(nameOf(inputFace(welded, surface, t)) +
                       " is to keep its texcoords, but has none at a corner; leave it out");
  }
  return {};
}

/// Coordinates of the chart's vertices in the input.
std::vector<double> givenUv(const CutMesh& mesh, std::size_t i) {
  const DiskChart& chart = mesh.set.charts[i];
  std::vector<double> uv(2 * static_cast<std::size_t>(chart.vertexCount()));
  for (std::size_t c = 0; c < chart.vertexOfCorner.size(); ++c) {
    const std::size_t h = 3 * static_cast<std::size_t>(mesh.set.triangles[i][c / 3]) + c % 3;
    const std::size_t texcoord =
        mesh.input.faceTexcoords[mesh.welded.inputCorner[mesh.surface.triangulation.corner[h]]];
    for (std::size_t d = 0; d < 2; ++d)
      uv[2 * static_cast<std::size_t>(chart.vertexOfCorner[c]) + d] =
          mesh.input.texcoords[2 * texcoord + d];
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
                                      const Surface& surface,
                                      const std::vector<std::uint32_t>& faces) {
  FixedTriangles out;
  if (faces.empty()) return out;
  if (input.faceTexcoords.empty())
    return invalid("faces are to keep their texcoords, but the mesh has none");
  std::vector<std::uint8_t> isNamed(input.faceCount(), 0);
  for (const std::uint32_t f : faces) {
    if (f >= input.faceCount())
      return invalid(nameOf(f) + " is to keep its texcoords, but there are only " +
                     std::to_string(input.faceCount()) + " faces");
    isNamed[f] = 1;
  }
  for (std::uint32_t t = 0; t < surface.table.triangleCount(); ++t)
    out.isFixed.push_back(isNamed[inputFace(welded, surface, t)]);
  growIslands(input, welded, surface, out.isFixed);
  if (Status s = checkTexcoords(input, welded, surface, out.isFixed); !s.ok()) return s;
  out.borders.assign(surface.table.twin.size(), 0);
  for (std::uint32_t h = 0; h < out.borders.size(); ++h) {
    const std::uint32_t twin = surface.table.twin[h];
    if (twin == kNone || !(out.isFixed[h / 3] || out.isFixed[twin / 3])) continue;
    if (out.isFixed[h / 3] != out.isFixed[twin / 3] || !hasSameTexcoords(input, welded, surface, h))
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
    const std::vector<std::uint32_t>& own = mesh.set.triangles[i];
    if (!fixed.isFixed[own.front()]) continue;
    const DiskChart& chart = mesh.set.charts[i];
    FlatChart& out = flat[i];
    out = {};
    out.isFixed = out.isGiven = true;
    out.uv = givenUv(mesh, i);
    out.unpacked.assign(out.uv.size(), NAN);
    const FixedChart c{chart, out.uv,
                       [&](std::size_t f) { return inputFace(mesh.welded, mesh.surface, own[f]); }};
    if (Status s = checkTile(c, hasTiles); !s.ok()) return s;
    if (Status s = checkTriangles(c); !s.ok()) return s;
    out.attempt.solver = "given";
    out.attempt.distortion = measureDistortion(chart, out.uv);
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
