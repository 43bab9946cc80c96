#include "abflat/orient.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesh/corner_table.h"
#include "mesh/triangle_geometry.h"
#include "mesh/welded_mesh.h"

namespace abflat {
namespace {

/// Sets of faces that are connected, each with a winding relative to one face of its set.
class FaceSets {
 public:
  struct Place {
    std::uint32_t set = 0;  ///< the face that stands for the set
    bool isOpposite = false;
  };

  explicit FaceSets(std::size_t faces) : parent_(faces), isOpposite_(faces, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  Place find(std::uint32_t face) {
    path_.clear();
    for (; parent_[face] != face; face = parent_[face]) path_.push_back(face);
    // From the root down, so that each face ends up directly below the root.
    bool isOpposite = false;
    while (!path_.empty()) {
      const std::uint32_t f = path_.back();
      path_.pop_back();
      isOpposite = isOpposite != (isOpposite_[f] != 0);
      parent_[f] = face;
      isOpposite_[f] = isOpposite;
    }
    return {face, isOpposite};
  }

  /// Does nothing if they are in one set already.
  void join(std::uint32_t a, std::uint32_t b, bool areOpposite) {
    Place p = find(a), q = find(b);
    if (p.set == q.set) return;
    if (q.set < p.set) std::swap(p, q);
    parent_[q.set] = p.set;
    isOpposite_[q.set] = (p.isOpposite != q.isOpposite) != areOpposite;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> isOpposite_;  ///< to the parent
  std::vector<std::uint32_t> path_;
};

/// What decides about one set. Sums count its faces as if all ran like its first.
struct SetSums {
  double area = 0, oppositeArea = 0;
  Vec3 centre{};      ///< weighted by area
  double volume = 0;  ///< seen from the centre
  std::int64_t openEdges = 0;
  std::uint32_t conflicts = 0;

  bool isClosed() const { return openEdges == 0; }

  /// Whether its first face is to be turned.
  bool turnsFirst() const {
    const double total = area + oppositeArea;
    const bool isClear = std::max(area, oppositeArea) >= 0.75 * total;
    const bool isFlat = std::abs(volume) <= 1e-9 * total * std::sqrt(total);
    if (isFlat || (isClear && !isClosed())) return oppositeArea > area;
    return volume < 0;
  }
};

class Orienting {
 public:
  Orienting(const PolygonMesh& mesh, const Listener& listener)
      : faces_(mesh.faceCount()), listener_(listener), sets_(faces_) {
    double largest = 0;
    for (const double x : mesh.positions) largest = std::max(largest, std::abs(x));
    PolygonMesh inUnits = mesh;
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    for (double& x : inUnits.positions) x = std::ldexp(x, -exponent);
    welded_ = weld(inUnits, true, listener_);
    if (listener_.isStopped()) return;
    triangulation_ = triangulate(welded_.mesh, listener_);
    if (!listener_.isStopped())
      table_ = buildCornerTable(triangulation_, welded_.mesh.vertexCount(), listener_);
  }

  std::vector<std::uint32_t> run() {
    if (listener_.isStopped() || table_.misoriented.empty()) return {};
    joinFaces();
    addUp();
    std::vector<std::uint32_t> out;
    for (std::uint32_t f = 0; f < faces_; ++f) {
      const FaceSets::Place place = sets_.find(f);
      const SetSums& sums = sums_[place.set];
      if (sums.conflicts > 0 && sums.turnsFirst() != place.isOpposite) out.push_back(f);
    }
    return out;
  }

 private:
  std::uint32_t faceOf(SurfaceTriangle t) const {
    return welded_.inputFace[triangulation_.face[t]];
  }

  /// Edges at which faces run alike come first, so that a surface with one side is cut where it
  /// changes anyway.
  void joinFaces() {
    for (const SurfaceCorner h : table_.corners())
      if (table_.twin[h].exists())
        sets_.join(faceOf(triangleOf(h)), faceOf(triangleOf(table_.twin[h])), false);
    for (const BadEdge& edge : table_.misoriented)
      sets_.join(welded_.inputFace[edge.faces[0]], welded_.inputFace[edge.faces[1]], true);
  }

  void addUp() {
    sums_.resize(faces_);
    for (const SurfaceCorner h : table_.corners())
      sums_[sets_.find(faceOf(triangleOf(h))).set].openEdges += !table_.twin[h].exists();
    for (const BadEdge& edge : table_.misoriented) {
      SetSums& sums = sums_[sets_.find(welded_.inputFace[edge.faces[0]]).set];
      ++sums.conflicts;
      sums.openEdges -= 2;
    }
    for (const SurfaceTriangle t : table_.triangles()) addArea(t);
    for (SetSums& sums : sums_)
      if (const double area = sums.area + sums.oppositeArea; area > 0)
        for (double& x : sums.centre) x /= area;
    for (const SurfaceTriangle t : table_.triangles()) addVolume(t);
  }

  const double* point(SurfaceTriangle t, std::size_t k) const {
    return &welded_.mesh.positions[3 * std::size_t{triangulation_.vertex[cornerOf(t, k)]}];
  }

  void addArea(SurfaceTriangle t) {
    const FaceSets::Place place = sets_.find(faceOf(t));
    SetSums& sums = sums_[place.set];
    const TriangleVertices v = verticesOf(triangulation_.vertex, t);
    const std::vector<double>& p = welded_.mesh.positions;
    const double area = norm(cross(edgeVector(p, v[0], v[1]), edgeVector(p, v[0], v[2]))) / 2;
    (place.isOpposite ? sums.oppositeArea : sums.area) += area;
    for (std::size_t d = 0; d < 3; ++d)
      sums.centre[d] += area / 3 * (point(t, 0)[d] + point(t, 1)[d] + point(t, 2)[d]);
  }

  void addVolume(SurfaceTriangle t) {
    const FaceSets::Place place = sets_.find(faceOf(t));
    SetSums& sums = sums_[place.set];
    std::array<Vec3, 3> seen;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 3; ++d) seen[k][d] = point(t, k)[d] - sums.centre[d];
    const double volume = dot(seen[0], cross(seen[1], seen[2])) / 6;
    sums.volume += place.isOpposite ? -volume : volume;
  }

  const std::size_t faces_;
  const Listener& listener_;
  FaceSets sets_;
  WeldedMesh welded_;
  Triangulation triangulation_;
  CornerTable table_;
  std::vector<SetSums> sums_;  ///< by the face that stands for a set
};

}  // namespace

std::vector<std::uint32_t> facesToTurn(const PolygonMesh& mesh,
                                       const std::function<bool()>& goesOn) {
  const Listener listener(goesOn ? [&](const Progress&) { return goesOn(); } : ProgressCallback());
  return Orienting(mesh, listener).run();
}

std::vector<std::uint32_t> turnedCorners(const PolygonMesh& mesh,
                                         const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint32_t> out(mesh.faceVertices.size());
  std::iota(out.begin(), out.end(), 0u);
  for (const std::uint32_t f : faces)
    std::reverse(out.begin() + mesh.faceOffsets[f] + 1, out.begin() + mesh.faceOffsets[f + 1]);
  return out;
}

void turnFaces(const std::vector<std::uint32_t>& faces, PolygonMesh& mesh) {
  for (const std::uint32_t f : faces)
    for (std::vector<std::uint32_t>* values :
         {&mesh.faceVertices, &mesh.faceTexcoords, &mesh.faceNormals})
      if (!values->empty())
        std::reverse(values->begin() + mesh.faceOffsets[f] + 1,
                     values->begin() + mesh.faceOffsets[f + 1]);
}

}  // namespace abflat
