#include "hole/fill_holes.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "hole/triangulate_rim.h"

namespace abflat {
namespace {

/// Clipping the ears of longer ones may take long, and they are no small holes.
constexpr std::size_t kMostEdges = 4096;

/// In the system of the scale, far above that of other edges: it is the same all along the rim.
constexpr double kStiff = 50;

/// One boundary loop, its half-edges the other way round: as what fills it sees them.
class Filler {
 public:
  Filler(SeamMesh& mesh, BoundaryLoop loop, double seamCost)
      : mesh_(mesh), side_(loop.begin(), loop.end()), seamCost_(seamCost) {
    // Side j of the hole runs from place j to j + 1.
    std::reverse(side_.begin(), side_.end());
    std::rotate(side_.begin(), side_.begin() + 1, side_.end());
    for (const std::uint32_t h : side_) place_.push_back(mesh.vertexOfCorner[nextCorner(h)]);
  }

  /// Whether it could be filled.
  bool fill(std::uint32_t hole) {
    const auto triangles = triangulateRim(rim());
    if (triangles.empty()) return false;
    shareAngles(triangles);
    const auto first = static_cast<std::uint32_t>(mesh_.twin.size());
    for (const auto& t : triangles) append(t, hole);
    joinDiagonals(triangles, first);
    return true;
  }

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(side_.size()); }
  /// The half-edge of the surface's boundary that leaves a place.
  std::uint32_t leaving(std::uint32_t place) const {
    return side_[place == 0 ? count() - 1 : place - 1];
  }

  bool isJoined(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t h = leaving(a); h != kNone; h = rotateCounterClockwise(mesh_.twin, h))
      if (mesh_.vertexOfCorner[nextCorner(h)] == place_[b] ||
          mesh_.vertexOfCorner[prevCorner(h)] == place_[b])
        return true;
    return false;
  }

  Rim rim() const {
    Rim out;
    for (std::uint32_t j = 0; j < count(); ++j) {
      const double* p = &mesh_.positions[3 * static_cast<std::size_t>(place_[j])];
      out.points.push_back({p[0], p[1], p[2]});
      out.isCorner.push_back(mesh_.twin[prevCorner(leaving(j))] == kNone);
    }
    out.isJoined = [this](std::uint32_t a, std::uint32_t b) { return isJoined(a, b); };
    return out;
  }

  /// The rim can bend within its plane: what the whole hole is curved is shared out evenly.
  void shareAngles(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<double> uses(count(), 0);
    for (const auto& t : triangles)
      for (const std::uint32_t j : t) ++uses[j];
    const double n = count();
    double share = (n - 2) * kPi / n;
    for (const std::uint32_t v : place_) share += mesh_.angleSum[v] / n;
    for (std::uint32_t j = 0; j < count(); ++j) {
      angle_.push_back((share - mesh_.angleSum[place_[j]]) / uses[j]);
      mesh_.angleSum[place_[j]] = share;
    }
  }

  void append(const std::array<std::uint32_t, 3>& t, std::uint32_t hole) {
    mesh_.area.push_back(0);
    mesh_.hole.push_back(hole);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const auto h = static_cast<std::uint32_t>(mesh_.twin.size());
      const bool isSide = b == (a + 1 == count() ? 0 : a + 1);
      mesh_.vertexOfCorner.push_back(place_[a]);
      mesh_.twin.push_back(isSide ? side_[a] : kNone);
      mesh_.angle.push_back(angle_[a]);
      mesh_.length.push_back(norm(edgeVector(mesh_.positions, place_[a], place_[b])));
      mesh_.cost.push_back(seamCost_);
      mesh_.weight.push_back(kStiff);
      if (!isSide) continue;
      mesh_.twin[side_[a]] = h;
      mesh_.cost[side_[a]] = seamCost_;
    }
  }

  void joinDiagonals(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                     std::uint32_t first) {
    struct End {
      std::array<std::uint32_t, 2> places;
      std::uint32_t h;
      bool operator<(const End& o) const { return places < o.places; }
    };
    std::vector<End> ends;
    for (std::uint32_t i = 0; i < 3 * triangles.size(); ++i) {
      const std::uint32_t h = first + i;
      const std::uint32_t a = triangles[i / 3][i % 3], b = triangles[i / 3][(i + 1) % 3];
      if (mesh_.twin[h] == kNone) ends.push_back({{std::min(a, b), std::max(a, b)}, h});
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      mesh_.twin[ends[i].h] = ends[i + 1].h;
      mesh_.twin[ends[i + 1].h] = ends[i].h;
    }
  }

  SeamMesh& mesh_;
  std::vector<std::uint32_t> side_;   ///< boundary half-edge of the surface along each side
  std::vector<std::uint32_t> place_;  ///< vertex at each
  std::vector<double> angle_;         ///< at each, of every triangle that fills
  double seamCost_;
};

double lengthOf(const SeamMesh& mesh, BoundaryLoop loop) {
  double sum = 0;
  for (const std::uint32_t h : loop) sum += mesh.length[h];
  return sum;
}

/// What a hole is curved in all: 0 where it is cut into a plane, 2 pi where it is an end of a tube.
double curvatureOf(const SeamMesh& mesh, const CutSurface& s, BoundaryLoop loop) {
  double sum = 2 * kPi;
  for (const std::uint32_t first : loop) {
    sum += kPi;
    for (std::uint32_t h = first; h != kNone; h = s.twin[prevCorner(h)]) sum -= mesh.angle[h];
  }
  return sum;
}

/// All loops but the longest one of each chart; when that is to spare seams, without those that are
/// both long and curved: filled they would bend the chart more than they spare.
std::vector<std::uint32_t> holesOf(const SeamMesh& mesh, const CutSurface& s,
                                   const IdVector<SurfaceTriangle, std::uint8_t>& isFixed,
                                   FillHoles mode) {
  constexpr double kSmall = 0.1, kFlat = kPi / 2;
  std::vector<std::uint32_t> out;
  for (const CutSurface::Chart& chart : s.charts) {
    if (!isFixed.empty() && isFixed[SurfaceTriangle(chart.firstTriangle)]) continue;
    std::uint32_t longest = chart.firstLoop;
    double length = 0;
    for (std::uint32_t i = 0; chart.loops > 1 && i < chart.loops; ++i) {
      const double own = lengthOf(mesh, s.loop(chart.firstLoop + i));
      if (own > length) {
        longest = chart.firstLoop + i;
        length = own;
      }
    }
    for (std::uint32_t i = chart.firstLoop; i < chart.firstLoop + chart.loops; ++i) {
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
               SeamMesh& mesh, const Pulse& pulse) {
  const bool isOpen = std::find(mesh.twin.begin(), mesh.twin.end(), kNone) != mesh.twin.end();
  if (mode == FillHoles::Never || !isOpen) return;
  const CutSurface s = cutAlong(mesh, Seams(mesh.twin.size(), 0), pulse);
  const std::vector<std::uint32_t> holes = holesOf(mesh, s, isFixed, mode);
  if (holes.empty()) return;
  const double seamCost = mode == FillHoles::Always ? kBarredCost : 0;
  mesh.hole.assign(mesh.triangleCount(), kNone);
  std::uint32_t filled = 0;
  for (const std::uint32_t loop : holes)
    if (Filler(mesh, s.loop(loop), seamCost).fill(filled)) ++filled;
  if (filled == 0) mesh.hole.clear();
}

bool openTouchedHoles(const SeamMesh& mesh, const CutSurface& s, FillHoles mode, Seams& seams) {
  if (mesh.hole.empty()) return false;
  std::uint32_t begin = 0, holes = 0;
  while (begin < mesh.triangleCount() && !mesh.isFilling(begin)) ++begin;
  for (std::uint32_t f = begin; f < mesh.triangleCount(); ++f)
    holes = std::max(holes, mesh.hole[f] + 1);
  std::vector<std::uint8_t> isTouched(holes, 0);
  for (std::uint32_t h = 3 * begin; h < mesh.twin.size(); ++h)
    if (seams[h] || (mode != FillHoles::Always && s.isBoundary[s.vertexOfCorner[h]]))
      isTouched[mesh.hole[h / 3]] = 1;
  bool isAny = false;
  for (std::uint32_t h = 3 * begin; h < mesh.twin.size(); ++h) {
    const std::uint32_t o = mesh.twin[h];
    if (!isTouched[mesh.hole[h / 3]] || mesh.isFilling(o / 3) || seams[h]) continue;
    seams[h] = seams[o] = 1;
    isAny = true;
  }
  return isAny;
}

}  // namespace abflat
