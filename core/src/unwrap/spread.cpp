#include "unwrap/spread.h"

#include <algorithm>
#include <utility>

#include "base/point2.h"
#include "base/stable_order.h"
#include "cut/filled_table.h"

namespace abflat {
namespace {

/// A half-edge of the whole surface where a filled hole begins.
struct RimEdge {
  ComponentId chart;
  HoleId hole;
  SurfaceCorner h, filling;  ///< on the whole surface; beside its model
  bool isMirrored = false;
};

/// The half-edge of a triangle's copy that was the k-th.
SurfaceCorner copiedEdge(SurfaceTriangle f, std::size_t k, bool isMirrored) {
  return cornerOf(f, isMirrored ? 2 - k : k);
}

class Spreader {
 public:
  Spreader(const WeldedMesh& welded, const Surface& whole, const CornerMatch& match,
           const Models& models)
      : welded_(welded),
        whole_(whole),
        match_(match),
        models_(models.charts),
        cells_{welded.mesh, facesOfCorners(welded.mesh), {}, {}, {}, {}, 0},
        filled_(filledTable(models.open.mesh, models.open.inputVertex, models.open.seams)) {
    edge_.resize(match_.size());
    const Surface& surface = models.surface;
    for (const SurfaceCorner h : surface.table.corners())
      if (!surface.triangulation.isDiagonal[h]) edge_[surface.triangulation.corner[h]] = h;
    vertex_.resize(surface.table.vertex.size());
    for (const ChartId i : models_.set.ids()) {
      const ChartTopology chart = models_.set.topology(i);
      for (const ChartCorner c : chart.surfaceCorners())
        vertex_[chart.onSurface(c)] = chart.vertexOfCorner[c];
    }
  }

  SpreadCharts run() {
    SpreadCharts out;
    cutLikeModels();
    for (const SurfaceCorner h : whole_.table.corners())
      out.seams.push_back(whole_.table.twin[h].exists() && !table_.table.twin[h].exists());
    fillLikeModels();
    out.charts.set = makeCharts(welded_.mesh, table_);
    IdVector<PolygonCorner, SurfaceTriangle> wholeTriangle(match_.size());
    for (const SurfaceCorner c : whole_.table.corners()) wholeTriangle[cornerAt(c)] = triangleOf(c);
    for (const ChartId i : out.charts.set.ids()) {
      const ChartTopology chart = out.charts.set.topology(i);
      const PolygonCorner c = cornerAt(cornerOf(chart.triangles.front(), 0));
      out.modelOf.push_back(out.charts.set.ofTriangle[wholeTriangle[match_[c]]]);
      out.charts.flat.push_back(layoutOf(chart));
    }
    return out;
  }

 private:
  static IdVector<PolygonCorner, PolygonFace> facesOfCorners(const PolygonMesh& mesh) {
    IdVector<PolygonCorner, PolygonFace> out;
    out.reserve(mesh.faceVertices.size());
    for (PolygonFace f(0); f < mesh.faceCount(); ++f)
      for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
        out.push_back(f);
    return out;
  }

  PolygonCorner cornerAt(SurfaceCorner c) const { return whole_.triangulation.corner[c]; }
  bool isMirrored(PolygonCorner c) const { return isMirroredAt(cells_, match_, c); }

  /// The half-edge of the models that corresponds to the side of a polygon that leaves a corner.
  SurfaceCorner modelEdge(PolygonCorner c) const {
    return edge_[isMirrored(c) ? cells_.prev(match_[c]) : match_[c]];
  }

  void cutLikeModels() {
    table_.surfaceTriangles = whole_.table.triangles().size();
    table_.table.vertex = whole_.table.vertex;
    table_.table.twin = whole_.table.twin;
    for (const SurfaceCorner h : whole_.table.corners()) {
      if (whole_.triangulation.isDiagonal[h]) continue;
      const SurfaceCorner beside = filled_.table.twin[modelEdge(cornerAt(h))];
      const bool isFilling = beside.exists() && triangleOf(beside) >= filled_.surfaceTriangles;
      if (isFilling) rims_.push_back({{}, {}, h, beside, isMirrored(cornerAt(h))});
      if (isFilling || !beside.exists()) table_.table.twin[h] = SurfaceCorner();
    }
  }

  HoleId holeOf(SurfaceTriangle filling) const {
    return filled_.hole[filling - filled_.surfaceTriangles];
  }

  void fillLikeModels() {
    const Components components = findComponents(table_.table);
    for (RimEdge& rim : rims_) {
      rim.chart = components.ofTriangle[triangleOf(rim.h)];
      rim.hole = holeOf(triangleOf(rim.filling));
    }
    sortStably(rims_, [](const RimEdge& a, const RimEdge& b) {
      return a.chart != b.chart ? a.chart < b.chart : a.hole < b.hole;
    });
    listHoles();
    for (std::size_t i = 0, end = 0; i < rims_.size(); i = end) {
      for (end = i + 1; end < rims_.size() && rims_[end].chart == rims_[i].chart &&
                        rims_[end].hole == rims_[i].hole;)
        ++end;
      fillHole(i, end);
    }
  }

  void listHoles() {
    for (std::size_t i = 0; i < filled_.hole.size(); ++i) {
      holeBegin_.resize(std::max<std::size_t>(holeBegin_.size(), filled_.hole[i] + 1), kNone);
      if (holeBegin_[filled_.hole[i]] == kNone)
        holeBegin_[filled_.hole[i]] = static_cast<std::uint32_t>(i);
    }
  }

  /// Adds a copy of the filling at these rim edges.
  void fillHole(std::size_t first, std::size_t last) {
    const HoleId hole = rims_[first].hole;
    const bool isMirrored = rims_[first].isMirrored;
    const std::size_t begin = filled_.surfaceTriangles + holeBegin_[hole];
    const SurfaceTriangle to(table_.table.triangles().size());
    const auto copied = [&](SurfaceCorner h) {
      const SurfaceTriangle f(to + (triangleOf(h) - begin));
      return copiedEdge(f, placeInTriangle(h), isMirrored);
    };
    std::size_t end = begin;
    while (end - filled_.surfaceTriangles < filled_.hole.size() &&
           holeOf(SurfaceTriangle(end)) == hole)
      ++end;
    const HoleId number(holes_++);
    table_.hole.insert(table_.hole.end(), end - begin, number);
    table_.table.vertex.resize(3 * (to + end - begin));
    table_.table.twin.resize(table_.table.vertex.size());
    for (const SurfaceCorner h :
         IdRange(cornerOf(SurfaceTriangle(begin), 0), cornerOf(SurfaceTriangle(end), 0)))
      if (const SurfaceCorner o = filled_.table.twin[h];
          o.exists() && triangleOf(o) >= filled_.surfaceTriangles)
        table_.table.twin[copied(h)] = copied(o);
    // Vertices of fillings are those of the rim, which the surface numbers.
    for (std::size_t i = first; i < last; ++i) {
      const SurfaceCorner h = rims_[i].h, o = copied(rims_[i].filling);
      table_.table.twin[h] = o;
      table_.table.twin[o] = h;
      table_.table.vertex[o] = whole_.table.vertex[nextCorner(h)];
    }
  }

  FlatChart layoutOf(const ChartTopology& chart) const {
    const PolygonCorner first = cornerAt(cornerOf(chart.triangles.front(), 0));
    const ChartId k = models_.set.ofTriangle[triangleOf(edge_[match_[first]])];
    const FlatChart& from = models_.flat[k];
    FlatChart out = copyOf(from);
    const double side = isMirrored(first) ? -1 : 1;
    out.uv.resize(2 * chart.vertexCount());
    out.unpacked.resize(out.uv.size());
    for (const ChartCorner c : chart.surfaceCorners()) {
      const ChartVertex at = vertex_[edge_[match_[cornerAt(chart.onSurface(c))]]];
      const ChartVertex v = chart.vertexOfCorner[c];
      setPoint(out.uv, v, pointAt(from.uv, at));
      // Before packing, it is the layout of its own chart, counter-clockwise.
      const auto [x, y] = pointAt(from.unpacked, at);
      setPoint(out.unpacked, v, {side * x, y});
    }
    return out;
  }

  static FlatChart copyOf(const FlatChart& from) {
    FlatChart out;
    out.area = from.area;
    out.distortion = from.distortion;
    if (from.uncommon) out.uncommon = std::make_unique<UncommonParts>(*from.uncommon);
    out.problem = from.problem;
    out.iterations = from.iterations;
    out.solver = from.solver;
    out.isFixed = from.isFixed;
    return out;
  }

  const WeldedMesh& welded_;
  const Surface& whole_;
  const CornerMatch& match_;
  const LaidCharts& models_;
  const Cells cells_;
  const FilledTable filled_;                     ///< of the models
  IdVector<PolygonCorner, SurfaceCorner> edge_;  ///< of the models, by the side of a polygon
  IdVector<SurfaceCorner, ChartVertex> vertex_;  ///< of the models
  IdVector<HoleId, std::uint32_t> holeBegin_;    ///< in filled_.hole
  std::vector<RimEdge> rims_;
  FilledTable table_;
  std::size_t holes_ = 0;  ///< filled so far
};

}  // namespace

SpreadCharts spread(const WeldedMesh& welded, const Surface& whole, const CornerMatch& match,
                    const Models& models) {
  return Spreader(welded, whole, match, models).run();
}

}  // namespace abflat
