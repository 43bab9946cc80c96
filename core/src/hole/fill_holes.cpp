#include "hole/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/constants.h"
#include "base/few_bits.h"
#include "base/stable_order.h"
#include "hole/triangulate_rim.h"

namespace abflat {
namespace {

/// Clipping the ears of longer loops may take long, and they are not small holes.
constexpr std::size_t kMostEdges = 4096;

/// Stiffness in the system of the scale, far above that of other edges, so that the scale is the
/// same all along the rim.
constexpr double kStiff = 50;

/// Where the loop of sides begins whose lengths come first in order, of all that begin elsewhere.
std::size_t leastStart(const SeamMesh& mesh, const std::vector<SurfaceCorner>& sides) {
  const std::size_t n = sides.size();
  std::size_t i = 0, j = 1, alike = 0;
  while (i < n && j < n && alike < n) {
    const double a = mesh.length[sides[(i + alike) % n]], b = mesh.length[sides[(j + alike) % n]];
    if (a == b) {
      ++alike;
      continue;
    }
    (a > b ? i : j) += alike + 1;
    if (i == j) ++j;
    alike = 0;
  }
  return std::min(i, j);
}

/// One boundary loop with its half-edges reversed, as seen by the triangles that fill it.
class Filler {
 public:
  Filler(SeamMesh& mesh, BoundaryLoop loop, double seamCost) : mesh_(mesh), seamCost_(seamCost) {
    // Side j of the hole runs from vertex j to j + 1. Between ears that are alike the numbers of
    // the sides decide, so these have to depend on the shape alone.
    std::vector<SurfaceCorner> sides(loop.begin(), loop.end());
    std::reverse(sides.begin(), sides.end());
    const auto first = static_cast<std::ptrdiff_t>(leastStart(mesh, sides));
    std::rotate(sides.begin(), sides.begin() + first, sides.end());
    side_ = IdVector<RimIndex, SurfaceCorner>(std::move(sides));
    for (const SurfaceCorner h : side_) vertex_.push_back(mesh.head(h));
  }

  /// Returns whether the hole could be filled.
  bool fill(HoleId hole) {
    const std::vector<RimTriangle> triangles = triangulateRim(rim());
    if (triangles.empty()) return false;
    shareAngles(triangles);
    const SurfaceTriangle first(mesh_.triangleCount());
    for (const RimTriangle& t : triangles) append(t, hole);
    joinDiagonals(triangles, first);
    return true;
  }

 private:
  RimIndex next(RimIndex i) const { return RimIndex(i + 1 == side_.size() ? 0 : i + 1); }
  /// The half-edge of the surface's boundary that leaves vertex i.
  SurfaceCorner leaving(RimIndex i) const { return i == 0 ? side_.back() : side_[RimIndex(i - 1)]; }

  bool isJoined(RimIndex a, RimIndex b) const {
    for (SurfaceCorner h = leaving(a); h.exists(); h = rotateCounterClockwise(mesh_.twin, h))
      if (mesh_.head(h) == vertex_[b] || mesh_.tail(prevCorner(h)) == vertex_[b]) return true;
    return false;
  }

  Rim rim() const {
    Rim out;
    for (const RimIndex j : side_.ids()) {
      const double* p = &mesh_.positions[3 * std::size_t{vertex_[j]}];
      out.points.push_back({p[0], p[1], p[2]});
      out.isCorner.push_back(!mesh_.twin[prevCorner(leaving(j))].exists());
    }
    out.isJoined = [this](RimIndex a, RimIndex b) { return isJoined(a, b); };
    return out;
  }

  /// The rim can bend within its plane, so the curvature of the whole hole is distributed evenly.
  void shareAngles(const std::vector<RimTriangle>& triangles) {
    IdVector<RimIndex, double> uses(side_.size(), 0);
    for (const RimTriangle& t : triangles)
      for (const RimIndex j : t) ++uses[j];
    const auto n = static_cast<double>(side_.size());
    double share = (n - 2) * kPi / n;
    for (const SurfaceVertex v : vertex_) share += mesh_.angleSum[v] / n;
    for (const RimIndex j : side_.ids()) {
      angle_.push_back((share - mesh_.angleSum[vertex_[j]]) / uses[j]);
      mesh_.angleSum[vertex_[j]] = share;
    }
  }

  void append(const RimTriangle& t, HoleId hole) {
    mesh_.area.push_back(0);
    mesh_.hole.push_back(hole);
    for (std::size_t k = 0; k < 3; ++k) {
      const RimIndex a = t[k], b = t[(k + 1) % 3];
      const bool isSide = b == next(a);
      mesh_.vertexOfCorner.push_back(vertex_[a]);
      const SurfaceCorner h = mesh_.twin.push_back(isSide ? side_[a] : SurfaceCorner());
      mesh_.angle.push_back(angle_[a]);
      mesh_.length.push_back(inFewBits(norm(edgeVector(mesh_.positions, vertex_[a], vertex_[b]))));
      mesh_.cost.push_back(seamCost_);
      mesh_.weight.push_back(kStiff);
      if (!isSide) continue;
      mesh_.twin[side_[a]] = h;
      mesh_.cost[side_[a]] = seamCost_;
    }
  }

  void joinDiagonals(const std::vector<RimTriangle>& triangles, SurfaceTriangle first) {
    struct Side {
      std::array<RimIndex, 2> ends;
      SurfaceCorner h;
      bool operator<(const Side& o) const { return ends < o.ends; }
    };
    std::vector<Side> sides;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const SurfaceCorner h = cornerOf(SurfaceTriangle(first + i), k);
        const RimIndex a = triangles[i][k], b = triangles[i][(k + 1) % 3];
        if (!mesh_.twin[h].exists()) sides.push_back({{std::min(a, b), std::max(a, b)}, h});
      }
    sortStably(sides, std::less<>());
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
      mesh_.twin[sides[i].h] = sides[i + 1].h;
      mesh_.twin[sides[i + 1].h] = sides[i].h;
    }
  }

  SeamMesh& mesh_;
  IdVector<RimIndex, SurfaceCorner> side_;  ///< half-edge of the surface's boundary along each side
  IdVector<RimIndex, SurfaceVertex> vertex_;
  IdVector<RimIndex, double> angle_;  ///< at each vertex, in every filling triangle
  double seamCost_;
};

double lengthOf(const SeamMesh& mesh, BoundaryLoop loop) {
  double sum = 0;
  for (const SurfaceCorner h : loop) sum += mesh.length[h];
  return sum;
}

/// Total curvature of a hole: 0 if it is cut into a plane, 2 pi if it is the end of a tube.
double curvatureOf(const SeamMesh& mesh, const CutSurface& s, BoundaryLoop loop) {
  double sum = 2 * kPi;
  for (const SurfaceCorner first : loop) {
    sum += kPi;
    for (SurfaceCorner h = first; h.exists(); h = s.twin[prevCorner(h)]) sum -= mesh.angle[h];
  }
  return sum;
}

/// All loops but the longest one of each chart. If holes are filled to save seams, leaves out those
/// that are both long and curved: filling them would bend the chart more than it saves.
std::vector<LoopId> holesOf(const SeamMesh& mesh, const CutSurface& s,
                            const IdVector<SurfaceTriangle, std::uint8_t>& isFixed,
                            FillHoles mode) {
  constexpr double kSmall = 0.1, kFlat = kPi / 2;
  std::vector<LoopId> out;
  for (const CutSurface::Chart& chart : s.charts) {
    if (!isFixed.empty() && isFixed[chart.firstTriangle]) continue;
    LoopId longest = chart.firstLoop;
    double length = 0;
    if (chart.loops < 2) continue;
    for (const LoopId i : chart.loopIds()) {
      const double own = lengthOf(mesh, s.loop(i));
      if (own > length) {
        longest = i;
        length = own;
      }
    }
    for (const LoopId i : chart.loopIds()) {
      const BoundaryLoop loop = s.loop(i);
      if (i == longest || loop.size() > kMostEdges) continue;
      if (mode == FillHoles::Always || lengthOf(mesh, loop) <= kSmall * length ||
          std::abs(curvatureOf(mesh, s, loop)) <= kFlat)
        out.push_back(i);
    }
  }
  return out;
}

}  // namespace

void fillHoles(FillHoles mode, const IdVector<SurfaceTriangle, std::uint8_t>& isFixed,
               SeamMesh& mesh, const Listener& listener) {
  const bool isOpen =
      std::find(mesh.twin.begin(), mesh.twin.end(), SurfaceCorner()) != mesh.twin.end();
  if (mode == FillHoles::Never || !isOpen) return;
  const CutSurface s = cutAlong(mesh, Seams(mesh.twin.size(), 0), listener);
  const std::vector<LoopId> holes = holesOf(mesh, s, isFixed, mode);
  if (holes.empty()) return;
  const double seamCost = mode == FillHoles::Always ? kBarredCost : 0;
  mesh.hole.resize(mesh.triangleCount());
  HoleId filled(0);
  for (const LoopId loop : holes)
    if (Filler(mesh, s.loop(loop), seamCost).fill(filled)) ++filled;
  if (filled == 0) mesh.hole.clear();
}

namespace {

/// Holes whose fillings alone join parts of the surface.
void markJoining(const SeamMesh& mesh, Seams seams, IdVector<HoleId, std::uint8_t>& isMarked) {
  const IdRange<SurfaceCorner> filling = mesh.fillingCorners();
  const auto isRim = [&](SurfaceCorner h) { return !mesh.isFilling(triangleOf(mesh.twin[h])); };
  for (const SurfaceCorner h : filling)
    if (isRim(h)) seams[h] = seams[mesh.twin[h]] = 1;
  const CutSurface parts = cutAlong(mesh, seams);
  IdVector<HoleId, CutChartId> part(isMarked.size());
  for (const SurfaceCorner h : filling) {
    if (!isRim(h)) continue;
    const HoleId hole = mesh.hole[triangleOf(h)];
    const CutChartId beside = parts.chartOf(mesh.twin[h]);
    if (!part[hole].exists()) part[hole] = beside;
    if (part[hole] != beside) isMarked[hole] = 1;
  }
}

}  // namespace

bool openTouchedHoles(const SeamMesh& mesh, const CutSurface& s, FillHoles mode, Seams& seams) {
  if (mesh.hole.empty()) return false;
  const IdRange<SurfaceCorner> filling = mesh.fillingCorners();
  IdVector<HoleId, std::uint8_t> isTouched;
  for (const SurfaceCorner h : filling) {
    const HoleId hole = mesh.hole[triangleOf(h)];
    isTouched.resize(std::max<std::size_t>(isTouched.size(), hole + 1), 0);
    if (seams[h] || (mode != FillHoles::Always && s.isBoundary[s.vertexOfCorner[h]]))
      isTouched[hole] = 1;
  }
  if (mode == FillHoles::Always) markJoining(mesh, seams, isTouched);
  bool isAny = false;
  for (const SurfaceCorner h : filling) {
    const SurfaceCorner o = mesh.twin[h];
    if (!isTouched[mesh.hole[triangleOf(h)]] || mesh.isFilling(triangleOf(o)) || seams[h]) continue;
    seams[h] = seams[o] = 1;
    isAny = true;
  }
  return isAny;
}

}  // namespace abflat
