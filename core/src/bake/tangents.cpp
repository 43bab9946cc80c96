#include "abflat/tangents.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/disjoint_sets.h"
#include "base/stable_order.h"
#include "mesh/triangle_geometry.h"
#include "mesh/vec3_sum.h"

namespace abflat {
namespace {

/// How a face lies in its texture.
enum class Side { None, Front, Mirrored };  // None: without area, and nothing beside it has any

Vec3 across(const Vec3& vector, const Vec3& normal) {
  return unit(sum(vector, normal, -dot(normal, vector)));
}

/// Some unit vector across a normal.
Vec3 anyAcross(const Vec3& normal) {
  std::size_t least = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(normal[d]) < std::abs(normal[least])) least = d;
  Vec3 axis{};
  axis[least] = 1;
  return across(axis, normal);
}

class Tangents {
 public:
  explicit Tangents(const TangentInput& input)
      : input_(input),
        corners_(static_cast<std::uint32_t>(input.uv.size() / 2)),
        point_(samePoints()),
        groups_(corners_),
        sums_(corners_) {}

  std::vector<float> run() {
    for (std::uint32_t f = 0; f < corners_ / 3; ++f) addFace(f);
    joinAlongEdges();
    for (std::uint32_t c = 0; c < corners_; ++c) {
      const std::uint32_t group = groups_.leastOf(c);
      if (group != c)
        sums_[group] = {sum(sums_[group].tangent, sums_[c].tangent),
                        sums_[group].angle + sums_[c].angle};
    }
    const std::vector<std::uint32_t> widest = widestGroups();
    std::vector<float> out;
    out.reserve(4 * std::size_t{corners_});
    for (std::uint32_t c = 0; c < corners_; ++c) {
      const bool hasOwn = sums_[groups_.leastOf(c)].angle > 0;
      const std::uint32_t from = hasOwn ? c : widest[point_[c]];
      const Vec3 summed = sums_[groups_.leastOf(from)].tangent;
      const Vec3 tangent = dot(summed, summed) > 0 ? unit(summed) : anyAcross(normal(c));
      for (const double x : tangent) out.push_back(static_cast<float>(x));
      out.push_back(sides_[from / 3] == Side::Mirrored ? -1.0f : 1.0f);
    }
    return out;
  }

 private:
  struct Sum {
    Vec3 tangent{};
    double angle = 0;
  };

  Vec3 position(std::uint32_t c) const {
    const double* const p = &input_.positions[3 * std::size_t{c}];
    return {p[0], p[1], p[2]};
  }
  Vec3 normal(std::uint32_t c) const {
    const float* const n = &input_.normals[3 * std::size_t{c}];
    return {n[0], n[1], n[2]};
  }
  std::array<double, 8> attributes(std::uint32_t c) const {
    const Vec3 p = position(c), n = normal(c);
    const double* const uv = &input_.uv[2 * std::size_t{c}];
    return {p[0], p[1], p[2], n[0], n[1], n[2], uv[0], uv[1]};
  }

  /// Per corner the first one with equal position, normal and uv.
  std::vector<std::uint32_t> samePoints() const {
    const std::vector<std::uint32_t> order = stableOrder(
        corners_, [&](std::uint32_t a, std::uint32_t b) { return attributes(a) < attributes(b); });
    std::vector<std::uint32_t> out(corners_);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool isSame = i > 0 && attributes(order[i]) == attributes(order[i - 1]);
      out[order[i]] = isSame ? out[order[i - 1]] : order[i];
    }
    return out;
  }

  /// Where u grows, at each corner across its normal and weighted by the corner's angle.
  void addFace(std::uint32_t f) {
    const std::uint32_t c = 3 * f;
    const double* const uv = &input_.uv[2 * std::size_t{c}];
    const double u1 = uv[2] - uv[0], v1 = uv[3] - uv[1];
    const double u2 = uv[4] - uv[0], v2 = uv[5] - uv[1];
    const double area = u1 * v2 - u2 * v1;
    const std::array<Vec3, 3> p = {position(c), position(c + 1), position(c + 2)};
    Vec3 along{};
    for (std::size_t d = 0; d < 3; ++d)
      along[d] = v2 * (p[1][d] - p[0][d]) - v1 * (p[2][d] - p[0][d]);
    if (area < 0)
      for (double& x : along) x = -x;
    const bool hasArea = (area < 0 || area > 0) && dot(along, along) > 0 && p[0] != p[1] &&
                         p[1] != p[2] && p[2] != p[0];
    // The bitangent points to smaller v.
    sides_.push_back(!hasArea ? Side::None : area < 0 ? Side::Front : Side::Mirrored);
    if (!hasArea) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::uint32_t>(c + k);
      const Vec3 n = normal(corner);
      const Vec3 next = across(sum(p[(k + 1) % 3], p[k], -1), n);
      const Vec3 last = across(sum(p[(k + 2) % 3], p[k], -1), n);
      const double angle = angleBetween(next, last);
      sums_[corner] = {sum(Vec3{}, across(along, n), angle), angle};
    }
  }

  struct Edge {
    std::array<std::uint32_t, 2> points;   ///< ascending
    std::array<std::uint32_t, 2> corners;  ///< likewise

    std::uint32_t face() const { return corners[0] / 3; }
  };

  /// All edges of faces, those between the same points one after another.
  std::vector<Edge> sortedEdges() const {
    std::vector<Edge> out;
    for (std::uint32_t c = 0; c < corners_; ++c) {
      const std::uint32_t next = c % 3 == 2 ? c - 2 : c + 1;
      if (point_[c] < point_[next])
        out.push_back({{point_[c], point_[next]}, {c, next}});
      else
        out.push_back({{point_[next], point_[c]}, {next, c}});
    }
    sortStably(out, [](const Edge& a, const Edge& b) { return a.points < b.points; });
    return out;
  }

  /// work(first, last) for the edges between the same points.
  template <class Work>
  static void visitShared(const std::vector<Edge>& edges, const Work& work) {
    for (auto first = edges.begin(); first != edges.end();) {
      const auto last = std::find_if(
          first, edges.end(), [&](const Edge& edge) { return edge.points != first->points; });
      work(first, last);
      first = last;
    }
  }

  /// A face without area lies as most of its neighbours do.
  void settleSides(const std::vector<Edge>& edges) {
    std::vector<int> votes(sides_.size());
    visitShared(edges, [&](auto first, auto last) {
      int sum = 0;
      for (auto edge = first; edge != last; ++edge) {
        const Side side = sides_[edge->face()];
        sum += side == Side::Front ? 1 : side == Side::Mirrored ? -1 : 0;
      }
      for (auto edge = first; edge != last; ++edge) votes[edge->face()] += sum;
    });
    for (std::size_t f = 0; f < sides_.size(); ++f)
      if (sides_[f] == Side::None && votes[f] != 0)
        sides_[f] = votes[f] > 0 ? Side::Front : Side::Mirrored;
  }

  /// Corners at the two ends of an edge have a tangent in common with those of faces beyond it.
  void joinAlongEdges() {
    const std::vector<Edge> edges = sortedEdges();
    settleSides(edges);
    visitShared(edges, [&](auto first, auto last) {
      for (const Side side : {Side::Front, Side::Mirrored}) {
        const auto hasSide = [&](const Edge& edge) { return sides_[edge.face()] == side; };
        const auto one = std::find_if(first, last, hasSide);
        for (auto other = one; other != last; ++other)
          if (hasSide(*other))
            for (std::size_t k = 0; k < 2; ++k) groups_.join(one->corners[k], other->corners[k]);
      }
    });
  }

  /// Per point, a corner of the group that has most of the angle there.
  std::vector<std::uint32_t> widestGroups() {
    std::vector<std::uint32_t> out(point_);
    for (std::uint32_t c = 0; c < corners_; ++c) {
      std::uint32_t& best = out[point_[c]];
      if (sums_[groups_.leastOf(c)].angle > sums_[groups_.leastOf(best)].angle) best = c;
    }
    return out;
  }

  const TangentInput& input_;
  std::uint32_t corners_;
  std::vector<std::uint32_t> point_;
  std::vector<Side> sides_;
  DisjointSets groups_;
  std::vector<Sum> sums_;  ///< by corner; of a group, at its least one
};

}  // namespace

std::vector<float> mikkTangents(const TangentInput& input) { return Tangents(input).run(); }

}  // namespace abflat
