#include "unwrap/output.h"

#include <algorithm>

#include "base/stable_order.h"
#include "mesh/folded_face.h"
#include "unwrap/missing_texcoords.h"
#include "unwrap/triangle_order.h"

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

/// The face corners of the input, grouped by vertex.
struct VertexCorners {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> begin;  ///< first corner of each vertex, then the total
};

VertexCorners cornersByVertex(const InputMesh& input) {
  VertexCorners out;
  out.begin.assign(input.vertexCount() + 1, 0);
  for (std::size_t c = 0; c < input.cornerCount(); ++c) ++out.begin[input.vertex(c) + 1];
  for (std::size_t v = 0; v < input.vertexCount(); ++v) out.begin[v + 1] += out.begin[v];
  std::vector<std::uint32_t> next(out.begin.begin(), out.begin.end() - 1);
  out.corners.resize(input.cornerCount());
  for (std::uint32_t c = 0; c < input.cornerCount(); ++c) out.corners[next[input.vertex(c)]++] = c;
  return out;
}

/// Makes one output vertex for each pair of input vertex and texcoord that occurs, ordered by input
/// vertex.
void splitVertices(const InputMesh& input, UnwrapResult& out) {
  VertexCorners of = cornersByVertex(input);
  out.cornerVertex.resize(input.cornerCount());
  out.vertexMap.reserve(out.uv.size() / 2);
  out.vertexUv.reserve(out.uv.size() / 2);
  const IsBefore isBefore = [&](std::uint32_t a, std::uint32_t b) {
    return out.cornerUv[a] < out.cornerUv[b];
  };
  for (std::uint32_t v = 0; v < input.vertexCount(); ++v) {
    std::uint32_t* const first = of.corners.data() + of.begin[v];
    std::uint32_t* const last = of.corners.data() + of.begin[v + 1];
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

ChartId chartOf(const Texcoords& texcoords, TexcoordId texcoord) {
  const auto& first = texcoords.firstOf;
  return ChartId(std::upper_bound(first.begin(), first.end(), texcoord) - first.begin() - 1);
}

/// The chart of each input face: that of its first triangle, or of its first texcoord if it has no
/// triangle.
void listCharts(const CutMesh& mesh, const Texcoords& texcoords, UnwrapResult& out) {
  const InputMesh& input = mesh.map.input();
  const IdVector<SurfaceTriangle, ChartId>& ofTriangle = mesh.set.ofTriangle;
  out.chartOfFace.assign(input.faceCount(), kNoChart);
  for (const SurfaceTriangle t : ofTriangle.ids()) {
    std::uint32_t& chart = out.chartOfFace[mesh.map.face(t)];
    if (chart == kNoChart) chart = ofTriangle[t];
  }
  for (const InputFace f : IdRange<InputFace>(input.faceCount())) {
    const TexcoordId texcoord = texcoords.ofCorner[InputCorner(input.firstCorner(f))];
    if (out.chartOfFace[f] == kNoChart && texcoord.exists())
      out.chartOfFace[f] = chartOf(texcoords, texcoord);
  }
}

void listTriangles(const CutMesh& mesh, UnwrapResult& out) {
  const SurfaceMap& map = mesh.map;
  const InputMesh& input = map.input();
  const TriangleOrder order = triangleOrder(map);
  out.triangles.resize(3 * std::size_t{order.firstOfFace.back()});
  out.triangleCorners.resize(out.triangles.size());
  out.chartOfTriangle.resize(order.firstOfFace.back());
  const auto put = [&](std::size_t i, std::array<std::uint32_t, 3> corners, std::uint32_t chart) {
    for (std::size_t k = 0; k < 3; ++k) {
      out.triangles[3 * i + k] = out.cornerVertex[corners[k]];
      out.triangleCorners[3 * i + k] = corners[k];
    }
    out.chartOfTriangle[i] = chart;
  };
  for (const SurfaceTriangle t : order.ofTriangle.ids())
    put(order.ofTriangle[t],
        {map.corner(cornerOf(t, 0)), map.corner(cornerOf(t, 1)), map.corner(cornerOf(t, 2))},
        mesh.set.ofTriangle[t]);
  for (const InputFace f : order.isFolded.ids()) {
    if (!order.isFolded[f]) continue;
    const std::uint32_t begin = input.firstCorner(f);
    std::vector<std::uint32_t> places;
    for (std::uint32_t c = begin; c < input.firstCorner(f + 1); ++c)
      places.push_back(map.welded().firstAtPlace[InputVertex(input.vertex(c))]);
    std::size_t i = order.firstOfFace[f];
    for (const auto& t : foldedTriangles(places))
      put(i++, {begin + t[0], begin + t[1], begin + t[2]}, out.chartOfFace[f]);
  }
}

UnwrapChart chartRow(const CutMesh& mesh, ChartId i, const FlatChart& flat) {
  const ChartTopology chart = mesh.set.topology(i);
  UnwrapChart row;
  row.faces = chart.triangles.size();
  row.firstFace = mesh.map.face(chart.triangles.front());
  row.boundaryVertices = chart.boundary.size();
  row.filledHoles = chart.filledHoles;
  row.area = flat.area;
  row.shape = flat.shape;
  row.solver = flat.solver;
  row.fixed = flat.isFixed;
  row.iterations = flat.iterations;
  row.angularDistortion = flat.distortion.angular;
  row.quasiConformalMean = flat.distortion.quasiConformalMean;
  row.quasiConformalMax = flat.distortion.quasiConformalMax;
  row.quasiConformalSheared = flat.distortion.sheared;
  row.symmetricDirichlet = flat.distortion.symmetricDirichlet;
  row.leeway = mesh.set.leewayOf(i);
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

RepairReport repairReport(const SurfaceMap& map) {
  const WeldedMesh& welded = map.welded();
  const CornerTable& table = map.surface().table;
  RepairReport out;
  out.mergedVertices = welded.mergedVertices;
  out.collapsedFaces = welded.collapsedFaces;
  out.splitFaces = welded.splitFaces;
  out.duplicateFaces = welded.duplicateFaces;
  out.nonManifoldEdges = edgesOf(table.nonManifold, welded.mesh.vertexCount());
  out.orientationConflicts = edgesOf(table.misoriented, welded.mesh.vertexCount());
  out.degenerateTriangles = map.surface().summary.degenerateFaces;
  return out;
}

Texcoords numberTexcoords(const CutMesh& mesh) {
  const ChartSet& set = mesh.set;
  IdVector<SurfaceCorner, TexcoordId> ofCorner(mesh.map.surface().table.vertex.size());
  Texcoords out;
  out.firstOf.reserve(set.size() + 1);
  for (const ChartId i : set.ids()) {
    const ChartTopology chart = set.topology(i);
    for (const ChartCorner c : chart.surfaceCorners())
      ofCorner[chart.onSurface(c)] = set.texcoord(i, chart.vertexOfCorner[c]);
    out.firstOf.push_back(set.firstTexcoord(i));
  }
  out.firstOf.push_back(set.firstTexcoord(ChartId(set.size())));
  out.ofCorner = mesh.map.toInput(ofCorner);
  fillMissing(mesh.map, ofCorner, out.ofCorner);
  return out;
}

void measureStraight(const ChartSet& set, FlatCharts& flat) {
  for (const ChartId i : flat.ids()) {
    if (!flat[i].uncommon || !flat[i].uncommon->straight) continue;
    UncommonParts& parts = *flat[i].uncommon;
    parts.straight->deviation =
        reportStraight(set.chart(i), parts.straightPlaces, flat[i].uv).deviation;
  }
}

void fillTexcoords(const Texcoords& texcoords, double unit, FlatCharts& flat, UnwrapResult& out) {
  const std::size_t numbers = 2 * std::size_t{texcoords.firstOf.back()} + 2;
  out.uv.reserve(numbers);
  out.unpacked.reserve(numbers);
  for (FlatChart& chart : flat) {
    out.uv.insert(out.uv.end(), chart.uv.begin(), chart.uv.end());
    for (const double x : chart.unpacked) out.unpacked.push_back(x * unit);
    chart.uv = chart.unpacked = std::vector<double>();
  }
  out.cornerUv.assign(texcoords.ofCorner.begin(), texcoords.ofCorner.end());
  std::uint32_t corner = kNone;  // of faces without area that are not beside a chart
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

void fillFaces(const CutMesh& mesh, const Texcoords& texcoords, UnwrapResult& out) {
  listCharts(mesh, texcoords, out);
  splitVertices(mesh.map.input(), out);
  listTriangles(mesh, out);
}

void fillReport(const CutMesh& mesh, const FlatCharts& flat, double unit, UnwrapReport& report) {
  double area = 0;
  report.valid = true;
  report.charts.reserve(flat.size());
  for (const ChartId i : flat.ids()) {
    report.charts.push_back(chartRow(mesh, i, flat[i]));
    UnwrapChart& row = report.charts.back();
    area += row.area;
    report.angularDistortion += row.area * row.angularDistortion;
    report.quasiConformalMean += row.area * row.quasiConformalMean;
    report.sheared += row.area * row.quasiConformalSheared;
    report.symmetricDirichlet += row.area * row.symmetricDirichlet;
    report.seams.filledHoles += row.filledHoles;
    report.valid = report.valid && row.valid;
    row.area = row.area * unit * unit;
  }
  for (double* mean : {&report.angularDistortion, &report.quasiConformalMean, &report.sheared,
                       &report.symmetricDirichlet})
    *mean = area > 0 ? *mean / area : 0;
}

}  // namespace abflat
