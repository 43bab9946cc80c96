#include "seam/scale_seams.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// The size range of faces that a chart may have, in octaves. Single precision has 24, of which
/// large charts need some for the number of their faces.
constexpr std::size_t kMostOctaves = 16;
/// Up to this share of the faces may be smaller: slivers of isosurfaces, for example.
constexpr double kSliverShare = 0.1;

/// Per triangle, the longest side of the face it belongs to.
IdVector<SurfaceTriangle, double> longestSides(const PolygonMesh& mesh, const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  IdVector<PolygonFace, double> ofFace(mesh.faceCount(), 0);
  IdVector<SurfaceTriangle, double> out(t.face.size());
  for (const SurfaceCorner h : t.vertex.ids()) {
    double& longest = ofFace[t.face[triangleOf(h)]];
    longest =
        std::max(longest, norm(edgeVector(mesh.positions, t.vertex[h], t.vertex[nextCorner(h)])));
  }
  for (const SurfaceTriangle f : out.ids()) out[f] = ofFace[t.face[f]];
  return out;
}

/// Counts per octave, starting with the smallest one.
struct Octaves {
  int first = 0;
  std::vector<std::uint32_t> faces;  ///< triangles of that size
  std::vector<std::uint32_t> jumps;  ///< edges between a smaller triangle and one that is not
};

IdVector<SurfaceTriangle, int> octavesOf(const IdVector<SurfaceTriangle, double>& sides) {
  IdVector<SurfaceTriangle, int> out;
  out.reserve(sides.size());
  int least = 0;
  for (const double x : sides)
    if (x > 0) least = std::min(least, std::ilogb(x));
  for (const double x : sides) out.push_back(x > 0 ? std::ilogb(x) : least);
  return out;
}

Octaves countOctaves(const CornerTable& table, const IdVector<SurfaceTriangle, int>& octave) {
  const auto [least, most] = std::minmax_element(octave.begin(), octave.end());
  Octaves out;
  out.first = *least;
  const auto count = static_cast<std::size_t>(*most - *least) + 1;
  out.faces.resize(count, 0);
  std::vector<std::int64_t> change(count + 1, 0);
  const auto index = [&](SurfaceTriangle f) {
    return static_cast<std::size_t>(octave[f] - out.first);
  };
  for (const SurfaceTriangle f : octave.ids()) ++out.faces[index(f)];
  for (const SurfaceCorner h : table.corners()) {
    const SurfaceCorner o = table.twin[h];
    if (!o.exists() || index(triangleOf(h)) >= index(triangleOf(o))) continue;
    ++change[index(triangleOf(h)) + 1];
    --change[index(triangleOf(o)) + 1];
  }
  std::int64_t jumps = 0;
  for (std::size_t i = 0; i < count; ++i)
    out.jumps.push_back(static_cast<std::uint32_t>(jumps += change[i]));
  return out;
}

/// The border between `begin` and `end`, both of which hold faces, that cuts the fewest edges.
/// Among equally good octaves it is the middle of the longest stretch.
std::size_t bestBetween(const Octaves& octaves, std::size_t begin, std::size_t end) {
  std::size_t best = begin + 1, length = 0;
  for (std::size_t i = begin + 1; i < end;) {
    std::size_t j = i;
    while (j < end && octaves.jumps[j] == octaves.jumps[i]) ++j;
    const bool isBetter = length == 0 || octaves.jumps[i] < octaves.jumps[best] ||
                          (octaves.jumps[i] == octaves.jumps[best] && j - i > length);
    if (isBetter) {
      length = j - i;
      best = i + length / 2;
    }
    i = j;
  }
  return best;
}

/// Splits the octaves from begin to end until each part has few.
void part(const Octaves& octaves, std::size_t begin, std::size_t end,
          std::vector<std::size_t>& borders) {
  const auto& faces = octaves.faces;
  while (end > begin && faces[end - 1] == 0) --end;
  double all = 0, below = 0;
  for (std::size_t i = begin; i < end; ++i) all += faces[i];
  while (begin < end && (below += faces[begin]) <= kSliverShare * all) ++begin;
  if (end < begin + kMostOctaves + 2) return;
  const std::size_t border = bestBetween(octaves, begin, end);
  part(octaves, begin, border, borders);
  borders.push_back(border);
  part(octaves, border, end, borders);
}

}  // namespace

Scales addScaleSeams(const PolygonMesh& mesh, const Surface& surface, Seams& seams) {
  const IdVector<SurfaceTriangle, double> sides = longestSides(mesh, surface);
  const IdVector<SurfaceTriangle, int> octave = octavesOf(sides);
  const Octaves octaves = countOctaves(surface.table, octave);
  std::vector<std::size_t> borders;
  part(octaves, 0, octaves.faces.size(), borders);
  Scales out;
  if (borders.empty()) return out;
  for (const int x : octave) {
    const auto i = static_cast<std::size_t>(x - octaves.first);
    const auto scale = std::upper_bound(borders.begin(), borders.end(), i) - borders.begin();
    out.ofTriangle.push_back(static_cast<std::uint8_t>(scale));
  }
  for (const SurfaceCorner h : surface.table.corners()) {
    const SurfaceCorner o = surface.table.twin[h];
    if (!o.exists()) continue;
    const SurfaceTriangle large = triangleOf(h), small = triangleOf(o);
    if (out.ofTriangle[large] <= out.ofTriangle[small]) continue;
    seams[h] = seams[o] = 1;
    const ScaleJump jump{large, small, sides[large], sides[small]};
    const auto& before = out.sharpest;
    if (!before || jump.largeSide / jump.smallSide > before->largeSide / before->smallSide)
      out.sharpest = jump;
  }
  return out;
}

}  // namespace abflat
