#include "seam/mirror_plane.h"

#include <map>

#include "seam/principal_axes.h"

namespace abflat {
namespace {

/// Of the vertices that are sampled, those off the plane that have an image.
constexpr double kLeastSampled = 0.6;
/// How many vertices are sampled, and how many the samples are compared with at first.
constexpr std::uint32_t kFew = 100, kMany = 1000, kTargets = 5000;
/// Distances of images while the plane is only roughly known.
constexpr std::array<double, 3> kFar = {0.05, 0.03, 0.015};
constexpr std::array<double, 2> kNear = {4e-3, kMirrorTolerance};

/// Where a plane across a coordinate axis would have to be for most pairs of vertices that lie
/// opposite each other. A part of the mesh that has no image does not move it.
class PlaneVotes {
 public:
  PlaneVotes(const SeamMesh& mesh, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<Entry> entries;
    entries.reserve(mesh.vertexCount());
    for (const SurfaceVertex i : mesh.vertices()) {
      const Vec3 p = placeOf(mesh, i);
      entries.push_back({columnOf(p[u]), columnOf(p[v]), p[axis]});
    }
    std::sort(entries.begin(), entries.end());
    for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
      while (end < entries.size() && entries[end].isBeside(entries[begin])) ++end;
      vote(&entries[begin], end - begin);
    }
  }

  /// `otherwise`: if there are no pairs.
  double winner(double otherwise) const {
    int most = 0;
    double out = otherwise;
    for (const auto& [slot, count] : votes_) {
      const auto next = votes_.find(slot + 1);
      const int both = count + (next == votes_.end() ? 0 : next->second);
      if (both <= most) continue;
      most = both;
      out = (slot + 1) * kSlot;
    }
    return out;
  }

 private:
  static constexpr double kColumn = 2 * kMirrorTolerance, kSlot = kMirrorTolerance;
  /// So that numbers with few digits do not lie between two columns.
  static constexpr double kShift = 0.3819660113;
  /// More vertices in a row tell little.
  static constexpr std::size_t kMostInColumn = 12;

  struct Entry {
    std::int32_t u, v;
    double at;
    bool isBeside(const Entry& o) const { return u == o.u && v == o.v; }
    bool operator<(const Entry& o) const {
      if (u != o.u) return u < o.u;
      return v != o.v ? v < o.v : at < o.at;
    }
  };

  static std::int32_t columnOf(double x) {
    return static_cast<std::int32_t>(std::floor(x / kColumn + kShift));
  }

  void vote(const Entry* column, std::size_t count) {
    if (count > kMostInColumn) return;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j)
        if (column[j].at - column[i].at > 4 * kMirrorTolerance)
          ++votes_[static_cast<int>(std::floor((column[i].at + column[j].at) / 2 / kSlot))];
  }

  std::map<int, int> votes_;
};

/// A plane of symmetry is perpendicular to a principal axis if all of the mesh is symmetric; most
/// models are symmetric to a coordinate axis.
std::vector<MirrorPlane> candidates(const SeamMesh& mesh) {
  if (!(mesh.totalArea() > 0)) return {};
  const PrincipalAxes principal = principalAxes(mesh);
  std::vector<MirrorPlane> out;
  for (const Vec3& normal : principal.axes) out.push_back({normal, dot(normal, principal.middle)});
  const PrincipalAxes coordinates;
  for (std::size_t d = 0; d < 3; ++d)
    out.push_back({coordinates.axes[d], PlaneVotes(mesh, d).winner(principal.middle[d])});
  return out;
}

struct MirrorFit {
  MirrorPlane plane;
  double share = 0;  ///< of the sampled vertices off the plane, those with an image
};

/// The plane that best mirrors every n-th vertex, among those that have an image.
MirrorFit fitTo(const SeamMesh& mesh, const VertexCells& cells, const MirrorPlane& plane,
                double tolerance, std::uint32_t sample) {
  const std::uint32_t stride = 1 + mesh.vertexCount() / sample;
  double all = 0, found = 0;
  Vec3 across{}, middle{};
  for (SurfaceVertex v(0); v < mesh.vertexCount(); v = SurfaceVertex(v + stride)) {
    const Vec3 p = placeOf(mesh, v);
    if (std::abs(plane.of(p)) <= tolerance) continue;
    ++all;
    const SurfaceVertex image = cells.nearest(plane.image(p), tolerance);
    if (!image.exists()) continue;
    ++found;
    const Vec3 q = placeOf(mesh, image);
    const double sign = plane.of(p) > 0 ? 1 : -1;
    for (std::size_t i = 0; i < 3; ++i) {
      across[i] += sign * (p[i] - q[i]);
      middle[i] += (p[i] + q[i]) / 2;
    }
  }
  const double length = norm(across);
  if (!(length > 0)) return {plane, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    across[i] /= length;
    middle[i] /= found;
  }
  return {{across, dot(across, middle)}, found / all};
}

}  // namespace

std::optional<MirrorPlane> findMirrorPlane(const SeamMesh& mesh, const VertexCells& cells,
                                           const Listener& listener) {
  const VertexCells targets(mesh, kFar[0], 1 + mesh.vertexCount() / kTargets);
  MirrorFit best;
  const auto fit = [&](MirrorFit from, bool isRough) {
    if (isRough)
      for (const double tolerance : kFar) from = fitTo(mesh, targets, from.plane, tolerance, kFew);
    for (const double tolerance : kNear) from = fitTo(mesh, cells, from.plane, tolerance, kFew);
    if (from.share > best.share) best = from;
  };
  for (const MirrorPlane& candidate : candidates(mesh))
    // Exactly as it is, or as a rough guess.
    for (const bool isRough : {false, true}) {
      if (!listener.beat(kFew)) return {};
      constexpr double kNearlyAll = 0.95;
      if (!isRough || best.share < kNearlyAll) fit({candidate, 0}, isRough);
    }
  if (best.share > 0) best = fitTo(mesh, cells, best.plane, kMirrorTolerance, kMany);
  if (best.share < kLeastSampled) return {};
  return best.plane;
}

}  // namespace abflat
