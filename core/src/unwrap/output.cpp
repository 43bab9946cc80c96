#include "unwrap/output.h"

#include <algorithm>

#include "base/stable_order.h"
#include "mesh/folded_face.h"

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
  out.vertexMap.reserve(out.uv.size() / 2);
  out.vertexUv.reserve(out.uv.size() / 2);
  const IsBefore isBefore = [&](std::uint32_t a, std::uint32_t b) {
    return out.cornerUv[a] < out.cornerUv[b];
  };
  for (std::uint32_t v = 0; v < input.vertexCount(); ++v) {
    std::uint32_t* const first = corners.data() + offset[v];
    std::uint32_t* const last = corners.data() + offset[v + 1];
    sortStably(first, last, isBefore);
    for (const std::uint32_t* c = first; c != last; ++c) {
      if (c == first || out.cornerUv[*c] != out.cornerUv[*(c - 1)]) {
        out.vertexMap.push_back(v);
        out.vertexUv.push_back(out.cornerUv[*c]);
      }
      out.cornerVertex[*c] = static_cast<std::uint32_t>(out.vertexMap.size() - 1);
    }
  }
}

/// Chart of each input face: of its first triangle, otherwise that of its first texcoord.
void listCharts(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                const ChartSet& set, const std::vector<std::uint32_t>& firstOf, UnwrapResult& out) {
  out.chartOfFace.assign(input.faceCount(), kNoChart);
  for (std::uint32_t t = static_cast<std::uint32_t>(set.ofTriangle.size()); t-- > 0;)
    out.chartOfFace[welded.inputFace[surface.triangulation.face[t]]] = set.ofTriangle[t];
  for (std::uint32_t f = 0; f < input.faceCount(); ++f) {
    const std::uint32_t corner = input.faceOffsets[f];
    if (out.chartOfFace[f] != kNoChart || welded.cornerFor[corner] == kNone) continue;
    const auto next = std::upper_bound(firstOf.begin(), firstOf.end(), out.cornerUv[corner]);
    out.chartOfFace[f] = static_cast<std::uint32_t>(next - firstOf.begin() - 1);
  }
}

void listTriangles(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
                   const ChartSet& set, UnwrapResult& out) {
  const TriangleOrder order = triangleOrder(input, welded, surface);
  out.triangles.resize(3 * static_cast<std::size_t>(order.firstOfFace.back()));
  out.triangleCorners.resize(out.triangles.size());
  out.chartOfTriangle.resize(order.firstOfFace.back());
  const auto put = [&](std::size_t i, std::array<std::uint32_t, 3> corners, std::uint32_t chart) {
    for (std::size_t k = 0; k < 3; ++k) {
      out.triangles[3 * i + k] = out.cornerVertex[corners[k]];
      out.triangleCorners[3 * i + k] = corners[k];
    }
    out.chartOfTriangle[i] = chart;
  };
  const auto cornerOf = [&](std::uint32_t h) {
    return welded.inputCorner[surface.triangulation.corner[h]];
  };
  for (std::uint32_t t = 0; t < order.ofTriangle.size(); ++t)
    put(order.ofTriangle[t], {cornerOf(3 * t), cornerOf(3 * t + 1), cornerOf(3 * t + 2)},
        set.ofTriangle[t]);
  for (std::uint32_t f = 0; f < input.faceCount(); ++f) {
    if (!order.isFolded[f]) continue;
    const std::uint32_t begin = input.faceOffsets[f];
    std::vector<std::uint32_t> places;
    for (std::uint32_t c = begin; c < input.faceOffsets[f + 1]; ++c)
      places.push_back(welded.place[input.faceVertices[c]]);
    std::size_t i = order.firstOfFace[f];
    for (const auto& t : foldedTriangles(places))
      put(i++, {begin + t[0], begin + t[1], begin + t[2]}, out.chartOfFace[f]);
  }
}

UnwrapChart chartRow(const ChartSet& set, std::size_t i, const FlatChart& flat,
                     std::uint32_t firstFace) {
  const ChartTopology chart = set.topology(i);
  UnwrapChart row;
  row.faces = chart.surfaceTriangles();
  row.firstFace = firstFace;
  row.boundaryVertices = chart.boundary.size();
  row.filledHoles = chart.filledHoles;
  row.area = flat.area;
  row.solver = flat.solver;
  row.fixed = flat.isFixed;
  row.iterations = flat.iterations;
  row.angularDistortion = flat.distortion.angular;
  row.quasiConformalMean = flat.distortion.quasiConformalMean;
  row.quasiConformalMax = flat.distortion.quasiConformalMax;
  row.symmetricDirichlet = flat.distortion.symmetricDirichlet;
  if (flat.uncommon) {
    row.refined = flat.uncommon->refined;
    row.pins = flat.uncommon->pins;
    row.straight = flat.uncommon->straight;
    row.fallbacks = flat.uncommon->fallbacks;
  }
  row.problem = flat.problem;
  row.valid = flat.problem.empty();
  return row;
}

}  // namespace

TriangleOrder triangleOrder(const PolygonMesh& input, const WeldedMesh& welded,
                            const Surface& surface) {
  const std::vector<std::uint32_t>& face = surface.triangulation.face;
  TriangleOrder out;
  out.firstOfFace.assign(input.faceCount() + 1, 0);
  out.isFolded.assign(input.faceCount(), 0);
  for (const std::uint32_t w : face) ++out.firstOfFace[welded.inputFace[w] + 1];
  for (std::size_t f = 0; f < input.faceCount(); ++f) {
    std::uint32_t& count = out.firstOfFace[f + 1];
    out.isFolded[f] = count == 0;
    if (out.isFolded[f]) count = input.faceOffsets[f + 1] - input.faceOffsets[f] - 2;
    count += out.firstOfFace[f];
  }
  std::vector<std::uint32_t> fill = out.firstOfFace;
  out.ofTriangle.reserve(face.size());
  for (const std::uint32_t w : face) out.ofTriangle.push_back(fill[welded.inputFace[w]]++);
  return out;
}

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

Texcoords numberTexcoords(const WeldedMesh& welded, const Surface& surface, const ChartSet& set) {
  Texcoords out;
  std::vector<std::uint32_t> ofWelded(welded.inputCorner.size(), kNone);
  out.firstOf.push_back(0);
  out.firstOf.reserve(set.size() + 1);
  for (std::size_t i = 0; i < set.size(); ++i) {
    const ChartTopology chart = set.topology(i);
    const Indices triangles = set.triangles(i);
    for (std::uint32_t f = 0; f < triangles.size(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k)
        ofWelded[surface.triangulation.corner[3 * triangles[f] + k]] =
            out.firstOf.back() + chart.vertexOfCorner[3 * f + k];
    out.firstOf.push_back(out.firstOf.back() + chart.vertexCount());
  }
  out.ofCorner.reserve(welded.cornerFor.size());
  for (const std::uint32_t corner : welded.cornerFor)
    out.ofCorner.push_back(corner == kNone ? kNone : ofWelded[corner]);
  return out;
}

void measureStraight(const ChartSet& set, std::vector<FlatChart>& flat) {
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (!flat[i].uncommon || !flat[i].uncommon->straight) continue;
    UncommonParts& parts = *flat[i].uncommon;
    parts.straight->deviation =
        reportStraight(set.chart(i), parts.straightPlaces, flat[i].uv).deviation;
  }
}

void fillTexcoords(const Texcoords& texcoords, double unit, std::vector<FlatChart>& flat,
                   UnwrapResult& out) {
  const std::size_t numbers = 2 * std::size_t{texcoords.firstOf.back()} + 2;
  out.uv.reserve(numbers);
  out.unpacked.reserve(numbers);
  for (FlatChart& chart : flat) {
    out.uv.insert(out.uv.end(), chart.uv.begin(), chart.uv.end());
    for (const double x : chart.unpacked) out.unpacked.push_back(x * unit);
    chart.uv = chart.unpacked = std::vector<double>();
  }
  out.cornerUv = texcoords.ofCorner;
  std::uint32_t corner = kNone;  // where nothing of a face is left, and of no other at its place
  for (std::uint32_t& texcoord : out.cornerUv) {
    if (texcoord != kNone) continue;
    if (corner == kNone) {
      corner = static_cast<std::uint32_t>(out.uv.size() / 2);
      out.uv.insert(out.uv.end(), {0, 0});
      out.unpacked.insert(out.unpacked.end(), {0, 0});
    }
    texcoord = corner;
  }
}

void fillFaces(const PolygonMesh& input, const WeldedMesh& welded, const Surface& surface,
               const ChartSet& set, const Texcoords& texcoords, UnwrapResult& out) {
  listCharts(input, welded, surface, set, texcoords.firstOf, out);
  splitVertices(input, out);
  listTriangles(input, welded, surface, set, out);
}

void fillReport(const ChartSet& set, const std::vector<FlatChart>& flat, const Surface& surface,
                const WeldedMesh& welded, double unit, UnwrapReport& report) {
  double area = 0;
  report.valid = true;
  report.charts.reserve(flat.size());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const std::uint32_t face = surface.triangulation.face[set.triangles(i).front()];
    report.charts.push_back(chartRow(set, i, flat[i], welded.inputFace[face]));
    UnwrapChart& row = report.charts.back();
    area += row.area;
    report.angularDistortion += row.area * row.angularDistortion;
    report.quasiConformalMean += row.area * row.quasiConformalMean;
    report.symmetricDirichlet += row.area * row.symmetricDirichlet;
    report.seams.filledHoles += row.filledHoles;
    report.valid = report.valid && row.valid;
    row.area = row.area * unit * unit;
  }
  for (double* mean :
       {&report.angularDistortion, &report.quasiConformalMean, &report.symmetricDirichlet})
    *mean = area > 0 ? *mean / area : 0;
}

}  // namespace abflat
