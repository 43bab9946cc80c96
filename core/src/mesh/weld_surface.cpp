#include <algorithm>
#include <cmath>

#include "mesh/corner_table.h"
#include "mesh/weld.h"

namespace abflat {
namespace {

/// More places within the tolerance are detail, not rounding.
constexpr std::size_t kMostPlaces = 64;

/// Merges places that are near each other, one group of them after the other.
class Merger {
 public:
  Merger(const PolygonMesh& mesh, const Welding& near, Welding equal)
      : mesh_(mesh), near_(near), equal_(std::move(equal)), of_(equal_.ofVertex) {
    findGroups();
    findFaces();
  }

  Welding run() {
    for (std::size_t i = 0, j = 0; i < grouped_.size(); i = j) {
      while (j < grouped_.size() && group(grouped_[j]) == group(grouped_[i])) ++j;
      if (j - i <= kMostPlaces) mergeGroup(&grouped_[i], &grouped_[i] + (j - i));
    }
    Welding out;
    out.ofVertex.reserve(of_.size());
    for (std::uint32_t v = 0; v < of_.size(); ++v) {
      out.ofVertex.push_back(of_[equal_.ofVertex[v]]);
      out.merged += out.ofVertex.back() != v;
    }
    out.reach = near_.reach;
    out.isExact = out.merged == equal_.merged;
    return out;
  }

 private:
  struct Incidence {
    std::uint32_t place, corner;
    bool operator<(const Incidence& o) const {
      return place != o.place ? place < o.place : corner < o.corner;
    }
  };

  std::uint32_t group(std::uint32_t place) const { return near_.ofVertex[place]; }
  std::uint32_t placeAt(std::uint32_t c) const { return equal_.ofVertex[mesh_.faceVertices[c]]; }

  /// Places that have others near them, group by group.
  void findGroups() {
    std::vector<std::uint32_t> count(of_.size(), 0);
    for (std::uint32_t v = 0; v < of_.size(); ++v) count[group(v)] += of_[v] == v;
    for (std::uint32_t v = 0; v < of_.size(); ++v)
      if (of_[v] == v && count[group(v)] > 1) grouped_.push_back(v);
    std::stable_sort(grouped_.begin(), grouped_.end(),
                     [this](std::uint32_t a, std::uint32_t b) { return group(a) < group(b); });
  }

  void findFaces() {
    std::vector<std::uint8_t> isGrouped(of_.size(), 0);
    for (const std::uint32_t v : grouped_) isGrouped[v] = 1;
    faceOfCorner_.reserve(mesh_.faceVertices.size());
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f)
      for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c) {
        faceOfCorner_.push_back(f);
        if (isGrouped[placeAt(c)]) incidences_.push_back({placeAt(c), c});
      }
    std::sort(incidences_.begin(), incidences_.end());
  }

  template <class Visit>
  void forCorners(std::uint32_t place, const Visit& visit) const {
    auto i = std::lower_bound(incidences_.begin(), incidences_.end(), Incidence{place, 0});
    for (; i != incidences_.end() && i->place == place; ++i) visit(i->corner);
  }

  /// Whether an edge there has one face only.
  bool isOpen(std::uint32_t place) const {
    std::vector<std::uint32_t> others;
    forCorners(place, [&](std::uint32_t c) {
      const std::uint32_t f = faceOfCorner_[c];
      const std::uint32_t begin = mesh_.faceOffsets[f], last = mesh_.faceOffsets[f + 1] - 1;
      others.push_back(placeAt(c == last ? begin : c + 1));
      others.push_back(placeAt(c == begin ? last : c - 1));
    });
    std::sort(others.begin(), others.end());
    for (std::size_t i = 0; i < others.size(); ++i) {
      const bool isLikeLast = i > 0 && others[i - 1] == others[i];
      const bool isLikeNext = i + 1 < others.size() && others[i + 1] == others[i];
      if (!isLikeLast && !isLikeNext) return true;
    }
    return false;
  }

  bool sharesFace(std::uint32_t place, std::uint32_t with) const {
    bool shares = false;
    forCorners(place, [&](std::uint32_t corner) {
      const std::uint32_t f = faceOfCorner_[corner];
      for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c)
        shares = shares || of_[placeAt(c)] == with;
    });
    return shares;
  }

  /// In units of the tolerance.
  double distance(std::uint32_t a, std::uint32_t b) const {
    double square = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = (mesh_.positions[3 * static_cast<std::size_t>(a) + d] -
                        mesh_.positions[3 * static_cast<std::size_t>(b) + d]) /
                       near_.reach;
      square += x * x;
    }
    return std::sqrt(square);
  }

  /// Each to the nearest that stands for others.
  void mergeGroup(const std::uint32_t* begin, const std::uint32_t* end) {
    std::vector<std::uint32_t> standing;
    for (const std::uint32_t* v = begin; v != end; ++v) {
      if (!isOpen(*v)) continue;
      std::uint32_t nearest = kNone;
      double least = 1;
      for (const std::uint32_t u : standing) {
        const double d = distance(u, *v);
        if (d > least || (nearest != kNone && d == least) || sharesFace(*v, u)) continue;
        nearest = u;
        least = d;
      }
      if (nearest == kNone)
        standing.push_back(*v);
      else
        of_[*v] = nearest;
    }
  }

  const PolygonMesh& mesh_;
  const Welding& near_;
  Welding equal_;
  std::vector<std::uint32_t> of_;       ///< per vertex that stands for its coordinates
  std::vector<std::uint32_t> grouped_;  ///< places
  std::vector<std::uint32_t> faceOfCorner_;
  std::vector<Incidence> incidences_;  ///< of places that are grouped
};

}  // namespace

Welding weldSurface(const PolygonMesh& mesh) {
  Welding near = weldVertices(mesh.positions);
  if (near.isExact) return near;
  return Merger(mesh, near, weldEqualVertices(mesh.positions)).run();
}

}  // namespace abflat
