#include "cut/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/few_bits.h"
#include "base/long_sum.h"
#include "base/smooth_step.h"
#include "cut/edge_bends.h"
#include "cut/front.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Relative to the largest extent; areas of anything smaller would be 0.
constexpr double kLeastScale = 1e-120;

/// Cotangent weights outside this range come from needles; within it the matrix is well
/// conditioned.
constexpr double kLeastWeight = 0.01, kMostWeight = 50;

/// Where the vertices of one scale lie, halved so that no difference overflows.
struct Extent {
  Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<LongSum, 3> middle;  ///< from there
  double vertices = 0;
  double most = 0;  ///< across, which is the same however the mesh is turned
};

/// Moves the vertices into the unit cube, each scale by itself.
std::vector<double> inUnitCube(const std::vector<double>& positions, const Fans& fans,
                               const IdVector<SurfaceTriangle, std::uint8_t>& scale) {
  const std::size_t count = fans.inputVertex.size();
  IdVector<SurfaceVertex, std::uint8_t> ofFan(count, 0);
  for (const SurfaceTriangle f : scale.ids())
    for (const SurfaceCorner c : cornersOf(f)) ofFan[fans.ofCorner[c]] = scale[f];
  const auto at = [&](SurfaceVertex v, std::size_t d) {
    return positions[3 * std::size_t{fans.inputVertex[v]} + d] / 2;
  };
  std::vector<Extent> extents(256);
  for (const SurfaceVertex v : fans.inputVertex.ids()) {
    Extent& extent = extents[ofFan[v]];
    ++extent.vertices;
    for (std::size_t d = 0; d < 3; ++d) extent.low[d] = std::min(extent.low[d], at(v, d));
  }
  const auto fromLow = [&](SurfaceVertex v, std::size_t d) {
    return at(v, d) - extents[ofFan[v]].low[d];
  };
  for (const SurfaceVertex v : fans.inputVertex.ids()) {
    Extent& extent = extents[ofFan[v]];
    for (std::size_t d = 0; d < 3; ++d) extent.middle[d].add(fromLow(v, d) / extent.vertices);
  }
  for (const SurfaceVertex v : fans.inputVertex.ids()) {
    Extent& extent = extents[ofFan[v]];
    const auto off = [&](std::size_t d) { return fromLow(v, d) - extent.middle[d].value(); };
    extent.most = std::max(extent.most, 2 * portable::hypot(off(0), off(1), off(2)));
  }
  double largest = 0;
  for (const Extent& extent : extents) largest = std::max(largest, extent.most);
  std::vector<double> out;
  out.reserve(3 * count);
  for (const SurfaceVertex v : fans.inputVertex.ids())
    for (std::size_t d = 0; d < 3; ++d) {
      const Extent& extent = extents[ofFan[v]];
      const double x = fromLow(v, d) / extent.most;
      out.push_back(extent.most > 0 ? x * std::max(extent.most / largest, kLeastScale) : 0);
    }
  return out;
}

void measureTriangle(SeamMesh& m, SurfaceTriangle f, IdVector<SurfaceCorner, double>& cotangent) {
  const std::array<std::uint32_t, 3> v = verticesOf(m.vertexOfCorner, f);
  std::array<Vec3, 3> e;
  for (std::size_t k = 0; k < 3; ++k) e[k] = edgeVector(m.positions, v[k], v[(k + 1) % 3]);
  const double doubleArea = norm(cross(e[0], e[1]));
  m.area[f] = inFewBits(doubleArea / 2);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, m.length[cornerOf(f, k)] = inFewBits(norm(e[k])));
  constexpr double kFlat = 1e-9;  // of the longest side squared
  const bool isFlat = !(doubleArea > kFlat * longest * longest);
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = -dot(e[k], e[(k + 2) % 3]);
    cotangent[cornerOf(f, k)] = isFlat ? 1 / std::sqrt(3.0) : along / doubleArea;
    m.angle[cornerOf(f, k)] = isFlat ? kPi / 3 : inFewBits(portable::atan2(doubleArea, along));
  }
}

/// Cost of a seam where the surface bends that much, relative to its length. Nothing hides a seam
/// in a flat face; a crease does, a concave one better. Where shading breaks, there is a crease,
/// and where the material changes, the textures do not continue anyway. `signedBend`: see
/// edgeBends.
double costWhere(double signedBend, std::uint8_t breaks) {
  const bool isConcave = signedBend < 0;
  double bend = std::abs(signedBend);
  constexpr double kDegree = kPi / 180;
  constexpr double kBent = 35 * kDegree, kSharp = 75 * kDegree;
  constexpr double kOfFlat = 5, kOfBent = 0.6, kOfConvex = 0.25, kOfConcave = 0.2;
  // What is flat is concave or convex only by rounding.
  if ((breaks & kMaterialBorder) && bend < kSharp) return kOfConvex;
  if (bend < kFlatBend) return kOfFlat;
  if (breaks & kHardEdge) bend = std::max(bend, kBent);
  if (bend < kBent) return 1 - (1 - kOfBent) * smoothStep(kSmoothBend, kBent, bend);
  return kOfBent -
         (kOfBent - (isConcave ? kOfConcave : kOfConvex)) * smoothStep(kBent, kSharp, bend);
}

void weighEdges(SeamMesh& m, const IdVector<SurfaceCorner, double>& cotangent) {
  for (const SurfaceCorner h : m.corners()) {
    const SurfaceCorner o = m.twin[h];
    if (o < h) continue;
    double w = cotangent[prevCorner(h)] / 2;
    m.cost[h] = m.length[h];
    if (o.exists()) {
      w += cotangent[prevCorner(o)] / 2;
      m.cost[o] = m.length[o] = m.length[h];
    }
    m.weight[h] = inFewBits(std::clamp(w, kLeastWeight, kMostWeight));
    if (o.exists()) m.weight[o] = m.weight[h];
  }
}

/// Costs by how much seams are in sight.
void hideSeams(SeamMesh& m, const IdVector<SurfaceCorner, std::uint8_t>& breaks, std::size_t upAxis,
               const Listener& listener) {
  const IdVector<SurfaceCorner, double> bend = edgeBends(m, listener);
  m.dearness = findFront(m, bend, upAxis);
  for (double& x : m.dearness) x = 1 + (kDearInFront - 1) * x;
  const auto breaksAt = [&](SurfaceCorner h) {
    return h < breaks.size() ? breaks[h] : std::uint8_t(0);
  };
  for (const SurfaceCorner h : m.corners()) {
    const SurfaceCorner o = m.twin[h];
    if (o.exists() && h < o)
      m.cost[h] = m.cost[o] =
          inFewBits(m.length[h] * m.dearnessAt(h) * costWhere(bend[h], breaksAt(h)));
  }
}

}  // namespace

double SeamMesh::totalArea() const {
  double sum = 0;
  for (const double a : area) sum += a;
  return sum;
}

IdRange<SurfaceCorner> SeamMesh::fillingCorners() const {
  const auto first = std::find_if(hole.begin(), hole.end(), [](HoleId i) { return i.exists(); });
  const SurfaceTriangle begin(first - hole.begin());
  const SurfaceTriangle end(hole.size());
  return {cornerOf(begin, 0), cornerOf(end, 0)};
}

SeamMesh makeSeamMesh(const std::vector<double>& positions, const CornerTable& table,
                      const Fans& fans, const IdVector<SurfaceCorner, std::uint8_t>& isDiagonal,
                      const IdVector<SurfaceTriangle, std::uint8_t>& scale,
                      const IdVector<SurfaceCorner, std::uint8_t>& breaks, SeamCosts costs,
                      std::size_t upAxis, const Listener& listener) {
  SeamMesh m;
  m.vertexOfCorner = fans.ofCorner;
  m.twin = table.twin;
  m.positions = inUnitCube(positions, fans, scale);
  const std::size_t corners = m.vertexOfCorner.size();
  m.angle.resize(corners);
  m.area.resize(corners / 3);
  m.length.resize(corners);
  m.cost.resize(corners);
  m.weight.resize(corners);
  IdVector<SurfaceCorner, double> cotangent(corners);
  for (const SurfaceTriangle f : m.triangles()) {
    measureTriangle(m, f, cotangent);
    listener.beat();
  }
  weighEdges(m, cotangent);
  if (costs == SeamCosts::Sight) hideSeams(m, breaks, upAxis, listener);
  listener.beat(corners);
  for (const SurfaceCorner h : isDiagonal.ids())
    if (isDiagonal[h]) m.cost[h] = std::numeric_limits<double>::infinity();
  m.vertexArea.assign(fans.inputVertex.size(), 0);
  m.angleSum.assign(fans.inputVertex.size(), 0);
  for (const SurfaceCorner c : m.corners()) {
    m.vertexArea[m.vertexOfCorner[c]] += m.area[triangleOf(c)] / 3;
    m.angleSum[m.vertexOfCorner[c]] += m.angle[c];
  }
  return m;
}

}  // namespace abflat
