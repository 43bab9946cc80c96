#include "mesh/open_corners.h"

#include <algorithm>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// The corners at some vertices, and which of them share an edge that only two faces have.
class CornersAround {
 public:
  CornersAround(const std::vector<PolygonCorner>& corners, const PolygonMesh& mesh) : mesh_(mesh) {
    std::vector<std::uint8_t> isWanted(mesh.vertexCount(), 0);
    for (const PolygonCorner c : corners) isWanted[mesh.faceVertices[c]] = 1;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
      const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
      for (std::uint32_t c = begin; c < end; ++c)
        if (isWanted[mesh.faceVertices[c]])
          around_.push_back({PolygonCorner(c), PolygonCorner(c > begin ? c - 1 : end - 1),
                             PolygonCorner(c + 1 < end ? c + 1 : begin), f, kNone, kNone});
    }
    link();
  }

  struct Around {
    PolygonCorner corner, before, after;
    std::uint32_t face;
    std::uint32_t acrossIn, acrossOut;  ///< the corner beyond its edge, as an index, or kNone
  };

  std::uint32_t indexOf(PolygonCorner c) const {
    const auto found =
        std::lower_bound(around_.begin(), around_.end(), c,
                         [](const Around& a, PolygonCorner wanted) { return a.corner < wanted; });
    return static_cast<std::uint32_t>(found - around_.begin());
  }
  const Around& operator[](std::uint32_t i) const { return around_[i]; }
  std::size_t size() const { return around_.size(); }

 private:
  struct Arm {
    std::uint32_t from, to;
    bool isOut;
    std::uint32_t index;
  };

  void link() {
    std::vector<Arm> arms;
    for (std::uint32_t i = 0; i < around_.size(); ++i) {
      const std::uint32_t v = mesh_.faceVertices[around_[i].corner];
      arms.push_back({v, mesh_.faceVertices[around_[i].before], false, i});
      arms.push_back({v, mesh_.faceVertices[around_[i].after], true, i});
    }
    std::sort(arms.begin(), arms.end(), [](const Arm& a, const Arm& b) {
      if (a.from != b.from) return a.from < b.from;
      if (a.to != b.to) return a.to < b.to;
      return a.isOut != b.isOut ? a.isOut : a.index < b.index;
    });
    for (std::size_t i = 0, end = 0; i < arms.size(); i = end) {
      while (end < arms.size() && arms[end].from == arms[i].from && arms[end].to == arms[i].to)
        ++end;
      if (end - i != 2 || !arms[i].isOut || arms[i + 1].isOut) continue;
      around_[arms[i].index].acrossOut = arms[i + 1].index;
      around_[arms[i + 1].index].acrossIn = arms[i].index;
    }
  }

  const PolygonMesh& mesh_;
  std::vector<Around> around_;
};

Vec3 unit(Vec3 a) {
  const double length = norm(a);
  if (length > 0)
    for (double& x : a) x /= length;
  return a;
}

Vec3 normalOf(const PolygonMesh& mesh, std::uint32_t f) {
  std::vector<Vec3> points;
  const std::uint32_t first = mesh.faceVertices[mesh.faceOffsets[f]];
  for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
    points.push_back(edgeVector(mesh.positions, first, mesh.faceVertices[c]));
  return unit(areaVector(points));
}

/// Away from the inside: along the bisector of the angle on the right of the way around the face.
Vec3 moveOf(const PolygonMesh& mesh, const CornersAround::Around& at, const Vec3& normal) {
  const auto arm = [&](PolygonCorner to) {
    return edgeVector(mesh.positions, mesh.faceVertices[at.corner], mesh.faceVertices[to]);
  };
  const Vec3 in = arm(at.before), out = arm(at.after), a = unit(in), b = unit(out);
  Vec3 turn{};
  for (std::size_t d = 0; d < 3; ++d) turn[d] = a[d] - b[d];
  Vec3 way = unit(cross(normal, turn));
  if (!(norm(way) > 0))
    for (std::size_t d = 0; d < 3; ++d) way[d] = -a[d];  // it goes back the way it came
  for (double& x : way) x *= kOpening * std::min(norm(in), norm(out));
  return way;
}

}  // namespace

void openCorners(const std::vector<PolygonCorner>& corners, PolygonMesh& mesh) {
  if (corners.empty()) return;
  const CornersAround around(corners, mesh);
  std::vector<std::uint32_t> vertex(around.size(), kNone);  // the new ones
  std::vector<std::uint8_t> isOpened(around.size(), 0);
  for (const PolygonCorner c : corners) isOpened[around.indexOf(c)] = 1;
  std::uint32_t face = kNone;
  Vec3 normal{};
  std::vector<double> positions;
  for (const PolygonCorner c : corners) {
    const std::uint32_t i = around.indexOf(c);
    if (around[i].face != face) normal = normalOf(mesh, face = around[i].face);
    const Vec3 move = moveOf(mesh, around[i], normal);
    const double* from = &mesh.positions[3 * std::size_t{mesh.faceVertices[c]}];
    vertex[i] = static_cast<std::uint32_t>(mesh.vertexCount() + positions.size() / 3);
    for (std::size_t d = 0; d < 3; ++d) positions.push_back(from[d] + move[d]);
    for (const auto across : {&CornersAround::Around::acrossIn, &CornersAround::Around::acrossOut})
      for (std::uint32_t k = around[i].*across; k != kNone && !isOpened[k] && vertex[k] == kNone;
           k = around[k].*across)
        vertex[k] = vertex[i];
  }
  for (std::uint32_t i = 0; i < around.size(); ++i)
    if (vertex[i] != kNone) mesh.faceVertices[around[i].corner] = vertex[i];
  mesh.positions.insert(mesh.positions.end(), positions.begin(), positions.end());
}

}  // namespace abflat
