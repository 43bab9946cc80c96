#include "unwrap_output.h"

#include <algorithm>

namespace abflat {
namespace {

std::vector<std::array<std::uint32_t, 2>> edgesOf(const std::vector<BadEdge>& bad,
                                                  std::size_t inputVertices) {
  std::vector<std::array<std::uint32_t, 2>> out;
  // Vertices beyond those of the input belong to layers of repeated faces.
  for (const BadEdge& e : bad)
    if (e.v0 < inputVertices && e.v1 < inputVertices) out.push_back({e.v0, e.v1});
  return out;
}

/// Texcoord per corner of the welded mesh's faces.
std::vector<std::uint32_t> texcoordOfCorner(const Surface& surface, const ChartSet& set,
                                            const std::vector<std::uint32_t>& firstOf,
                                            std::size_t corners) {
  std::vector<std::uint32_t> out(corners, kNone);
  for (std::size_t i = 0; i < set.charts.size(); ++i)
    for (std::uint32_t f = 0; f < set.triangles[i].size(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k)
        out[surface.triangulation.corner[3 * set.triangles[i][f] + k]] =
            firstOf[i] + set.charts[i].vertexOfCorner[3 * f + k];
  return out;
}

/// One output vertex for each input vertex and texcoord that occur together, by input vertex.
void splitVertices(const PolygonMesh& input, UnwrapResult& out) {
  struct Use {
    std::uint32_t vertex, texcoord;
    bool operator==(const Use& o) const { return vertex == o.vertex && texcoord == o.texcoord; }
  };
  std::vector<std::uint32_t> offset(input.vertexCount() + 1, 0);
  for (const std::uint32_t v : input.faceVertices) ++offset[v + 1];
  for (std::size_t v = 0; v < input.vertexCount(); ++v) offset[v + 1] += offset[v];
  std::vector<std::uint32_t> fill(offset.begin(), offset.end() - 1), corners(offset.back());
  for (std::uint32_t c = 0; c < input.faceVertices.size(); ++c)
    corners[fill[input.faceVertices[c]]++] = c;
  out.cornerVertex.resize(input.faceVertices.size());
  for (std::uint32_t v = 0; v < input.vertexCount(); ++v) {
    const auto first = corners.begin() + offset[v], last = corners.begin() + offset[v + 1];
    std::stable_sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
      return out.cornerUv[a] < out.cornerUv[b];
    });
    for (auto c = first; c != last; ++c) {
      if (c == first || out.cornerUv[*c] != out.cornerUv[*(c - 1)]) {
        out.vertexMap.push_back(v);
        out.vertexUv.push_back(out.cornerUv[*c]);
      }
      out.cornerVertex[*c] = static_cast<std::uint32_t>(out.vertexMap.size() - 1);
    }
  }
}

UnwrapChart chartRow(const DiskChart& chart, const FlatChart& flat, std::uint32_t firstFace) {
  UnwrapChart row;
  const Attempt& a = flat.attempt;
  row.faces = chart.triangleCount();
  row.firstFace = firstFace;
  row.boundaryVertices = chart.boundary.size();
  row.area = surfaceArea(chart) * chart.unit * chart.unit;
  row.solver = a.solver;
  row.iterations = static_cast<int>(a.solution.history.size());
  row.angularDistortion = a.distortion.angular;
  row.quasiConformalMean = a.distortion.quasiConformalMean;
  row.quasiConformalMax = a.distortion.quasiConformalMax;
  row.symmetricDirichlet = a.distortion.symmetricDirichlet;
  row.fallbacks = a.fallbacks;
  row.problem = flat.problem;
  row.valid = flat.problem.empty();
  return row;
}

}  // namespace

RepairReport repairReport(const WeldedMesh& welded, const Surface& surface) {
  RepairReport out;
  out.mergedVertices = welded.mergedVertices;
  out.collapsedFaces = welded.collapsedFaces;
  out.splitFaces = welded.splitFaces;
  out.duplicateFaces = welded.duplicateFaces;
  out.nonManifoldEdges = edgesOf(surface.table.nonManifold, welded.mesh.vertexCount());
  out.orientationConflicts = edgesOf(surface.table.misoriented, welded.mesh.vertexCount());
  out.degenerateTriangles = surface.summary.degenerateFaces;
  return out;
}

void fillOutput(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                const ChartSet& set, const std::vector<FlatChart>& flat, UnwrapResult& out) {
  std::vector<std::uint32_t> firstOf;
  for (const FlatChart& chart : flat) {
    firstOf.push_back(static_cast<std::uint32_t>(out.uv.size() / 2));
    out.uv.insert(out.uv.end(), chart.uv.begin(), chart.uv.end());
  }
  const std::vector<std::uint32_t> ofCorner =
      texcoordOfCorner(surface, set, firstOf, welded.inputCorner.size());
  out.cornerUv.resize(input.faceVertices.size());
  std::uint32_t corner = kNone;  // where nothing of a face is left, and of no other at its place
  for (std::size_t c = 0; c < out.cornerUv.size(); ++c) {
    if (welded.cornerFor[c] != kNone) {
      out.cornerUv[c] = ofCorner[welded.cornerFor[c]];
      continue;
    }
    if (corner == kNone) {
      corner = static_cast<std::uint32_t>(out.uv.size() / 2);
      out.uv.insert(out.uv.end(), {0, 0});
    }
    out.cornerUv[c] = corner;
  }
  out.chartOfFace.assign(input.faceCount(), kNone);
  for (std::uint32_t f = static_cast<std::uint32_t>(set.ofTriangle.size()); f-- > 0;)
    out.chartOfFace[welded.inputFace[surface.triangulation.face[f]]] = set.ofTriangle[f];
  splitVertices(input, out);
}

void fillReport(const ChartSet& set, const std::vector<FlatChart>& flat, const Surface& surface,
                const WeldedMesh& welded, UnwrapReport& report) {
  double area = 0;
  report.valid = true;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const std::uint32_t face = surface.triangulation.face[set.triangles[i].front()];
    report.charts.push_back(chartRow(set.charts[i], flat[i], welded.inputFace[face]));
    const UnwrapChart& row = report.charts.back();
    area += row.area;
    report.angularDistortion += row.area * row.angularDistortion;
    report.quasiConformalMean += row.area * row.quasiConformalMean;
    report.symmetricDirichlet += row.area * row.symmetricDirichlet;
    report.valid = report.valid && row.valid;
  }
  for (double* mean :
       {&report.angularDistortion, &report.quasiConformalMean, &report.symmetricDirichlet})
    *mean = area > 0 ? *mean / area : 0;
}

}  // namespace abflat
