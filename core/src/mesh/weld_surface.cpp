#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "mesh/corner_table.h"
#include "mesh/weld.h"

namespace abflat {
namespace {

/// More places than this within the tolerance are detail, not rounding.
constexpr std::size_t kMostPlaces = 64;

/// Places farther apart than this share of the edges there are detail as well: a single vertex far
/// off makes the tolerance large, but not the edges elsewhere.
constexpr double kMostOfEdge = 1e-3;

bool haveCommon(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

/// Merges places that are near each other, one group at a time.
class Merger {
 public:
  Merger(const PolygonMesh& mesh, const Welding& near, Welding equal, const Listener& listener)
      : mesh_(mesh),
        near_(near),
        equal_(std::move(equal)),
        listener_(listener),
        of_(equal_.ofVertex) {
    findGroups();
    findFaces();
  }

  Welding run() {
    for (std::size_t i = 0, j = 0; i < grouped_.size() && listener_.beat(); i = j) {
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
  std::uint32_t group(std::uint32_t place) const { return near_.ofVertex[place]; }
  std::uint32_t placeAt(std::uint32_t c) const { return equal_.ofVertex[mesh_.faceVertices[c]]; }

  /// Finds places that have others near them, group by group.
  void findGroups() {
    std::vector<std::uint32_t> count(of_.size(), 0);
    for (std::uint32_t v = 0; v < of_.size() && listener_.beat(); ++v)
      count[group(v)] += of_[v] == v;
    std::uint32_t sum = 0;
    std::vector<std::uint32_t> begin(of_.size(), kNone);
    for (std::uint32_t g = 0; g < of_.size(); ++g) {
      if (count[g] < 2) continue;
      begin[g] = sum;
      sum += count[g];
    }
    if (listener_.isStopped()) return;
    grouped_.resize(sum);
    for (std::uint32_t v = 0; v < of_.size() && listener_.beat(); ++v)
      if (of_[v] == v && begin[group(v)] != kNone) grouped_[begin[group(v)]++] = v;
  }

  void findFaces() {
    std::vector<std::uint8_t> isGrouped(of_.size(), 0);
    for (const std::uint32_t v : grouped_) isGrouped[v] = 1;
    firstCorner_.assign(of_.size() + 1, 0);
    const auto corners = static_cast<std::uint32_t>(mesh_.faceVertices.size());
    for (std::uint32_t c = 0; c < corners && listener_.beat(); ++c)
      if (isGrouped[placeAt(c)]) ++firstCorner_[placeAt(c) + 1];
    for (std::size_t v = 0; v < of_.size(); ++v) firstCorner_[v + 1] += firstCorner_[v];
    cornersAt_.resize(firstCorner_.back());
    faceOfCorner_.assign(corners, 0);
    if (listener_.isStopped()) return;
    std::vector<std::uint32_t> next = firstCorner_;
    for (std::uint32_t f = 0; f < mesh_.faceCount() && listener_.beat(); ++f)
      for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c) {
        faceOfCorner_[c] = f;
        if (isGrouped[placeAt(c)]) cornersAt_[next[placeAt(c)]++] = c;
      }
  }

  template <class Visit>
  void forCorners(std::uint32_t place, const Visit& visit) const {
    for (std::uint32_t i = firstCorner_[place]; i < firstCorner_[place + 1]; ++i)
      visit(cornersAt_[i]);
  }

  /// Places that edges lead to, in order; one entry for each face next to an edge.
  std::vector<std::uint32_t> neighbours(std::uint32_t place) const {
    std::vector<std::uint32_t> out;
    forCorners(place, [&](std::uint32_t c) {
      const std::uint32_t f = faceOfCorner_[c];
      const std::uint32_t begin = mesh_.faceOffsets[f], last = mesh_.faceOffsets[f + 1] - 1;
      out.push_back(placeAt(c == last ? begin : c + 1));
      out.push_back(placeAt(c == begin ? last : c - 1));
    });
    std::sort(out.begin(), out.end());
    return out;
  }

  /// Whether an edge there has only one face.
  static bool isOpen(const std::vector<std::uint32_t>& others) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      const bool isLikeLast = i > 0 && others[i - 1] == others[i];
      const bool isLikeNext = i + 1 < others.size() && others[i + 1] == others[i];
      if (!isLikeLast && !isLikeNext) return true;
    }
    return false;
  }

  /// Faces at a place, in order.
  std::vector<std::uint32_t> facesAt(std::uint32_t place) const {
    std::vector<std::uint32_t> out;
    forCorners(place, [&](std::uint32_t c) {
      if (out.empty() || out.back() != faceOfCorner_[c]) out.push_back(faceOfCorner_[c]);
    });
    return out;
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

  /// How far away others may be to be merged with a place, in units of the tolerance.
  double reachAt(std::uint32_t place, const std::vector<std::uint32_t>& others) const {
    double longest = 0;
    for (const std::uint32_t o : others) longest = std::max(longest, distance(place, o));
    return std::min(1.0, kMostOfEdge * longest);
  }

  /// Merges each place with the nearest one that represents others and does not share a face with
  /// it.
  void mergeGroup(const std::uint32_t* begin, const std::uint32_t* end) {
    struct Standing {
      std::uint32_t place;
      double reach;
      std::vector<std::uint32_t> faces;  ///< of all that it represents, in order
    };
    std::vector<Standing> standing;
    for (const std::uint32_t* v = begin; v != end; ++v) {
      const std::vector<std::uint32_t> others = neighbours(*v);
      if (!isOpen(others)) continue;
      const double reach = reachAt(*v, others);
      std::vector<std::uint32_t> faces = facesAt(*v);
      Standing* nearest = nullptr;
      double least = reach;
      for (Standing& u : standing) {
        const double d = distance(u.place, *v);
        if (d > std::min(least, u.reach) || (nearest && d == least) || haveCommon(faces, u.faces))
          continue;
        nearest = &u;
        least = d;
      }
      if (!nearest) {
        standing.push_back({*v, reach, std::move(faces)});
        continue;
      }
      of_[*v] = nearest->place;
      std::vector<std::uint32_t> both;
      std::set_union(faces.begin(), faces.end(), nearest->faces.begin(), nearest->faces.end(),
                     std::back_inserter(both));
      nearest->faces = std::move(both);
    }
  }

  const PolygonMesh& mesh_;
  const Welding& near_;
  Welding equal_;
  const Listener& listener_;
  std::vector<std::uint32_t> of_;       ///< per vertex, the one that represents its coordinates
  std::vector<std::uint32_t> grouped_;  ///< places
  std::vector<std::uint32_t> faceOfCorner_;
  std::vector<std::uint32_t> firstCorner_;  ///< per place, in cornersAt_; grouped places only
  std::vector<std::uint32_t> cornersAt_;
};

/// Vertices that faces use, in order.
std::vector<std::uint32_t> usedVertices(const PolygonMesh& mesh) {
  std::vector<std::uint8_t> isUsed(mesh.vertexCount(), 0);
  for (const std::uint32_t v : mesh.faceVertices) isUsed[v] = 1;
  std::vector<std::uint32_t> out;
  for (std::uint32_t v = 0; v < isUsed.size(); ++v)
    if (isUsed[v]) out.push_back(v);
  return out;
}

std::vector<double> positionsOf(const PolygonMesh& mesh, const std::vector<std::uint32_t>& used) {
  std::vector<double> out;
  out.reserve(3 * used.size());
  for (const std::size_t v : used)
    for (std::size_t d = 0; d < 3; ++d) out.push_back(mesh.positions[3 * v + d]);
  return out;
}

/// Takes apart what is merged of different objects.
void separateObjects(const PolygonMesh& mesh, const Listener& listener, Welding& welding) {
  std::vector<double> keys;  // a place and an object, as if they were coordinates
  keys.reserve(3 * welding.ofVertex.size());
  for (std::size_t v = 0; v < welding.ofVertex.size(); ++v)
    for (const std::uint32_t x : {welding.ofVertex[v], mesh.vertexObjects[v], 0u})
      keys.push_back(x);
  Welding apart = weldEqualVertices(keys, listener);
  welding.ofVertex.swap(apart.ofVertex);
  welding.merged = apart.merged;
}

/// Makes a welding of used vertices one of all: others stay as they are, wherever they lie.
void extend(const PolygonMesh& mesh, const std::vector<std::uint32_t>& used,
            const Listener& listener, Welding& welding) {
  if (used.size() < mesh.vertexCount()) {
    std::vector<std::uint32_t> ofVertex(mesh.vertexCount());
    std::iota(ofVertex.begin(), ofVertex.end(), 0u);
    for (std::size_t i = 0; i < used.size(); ++i) ofVertex[used[i]] = used[welding.ofVertex[i]];
    welding.ofVertex.swap(ofVertex);
  }
  if (!mesh.vertexObjects.empty()) separateObjects(mesh, listener, welding);
}

}  // namespace

Welding weldSurface(const PolygonMesh& mesh, const Listener& listener) {
  const std::vector<std::uint32_t> used = usedVertices(mesh);
  const bool usesAll = used.size() == mesh.vertexCount();
  const std::vector<double> some = usesAll ? std::vector<double>() : positionsOf(mesh, used);
  const std::vector<double>& positions = usesAll ? mesh.positions : some;
  Welding near = weldVertices(positions, kWeldTolerance, listener);
  extend(mesh, used, listener, near);
  if (near.isExact || listener.isStopped()) return near;
  Welding equal = weldEqualVertices(positions, listener);
  extend(mesh, used, listener, equal);
  if (listener.isStopped()) return equal;
  return Merger(mesh, near, std::move(equal), listener).run();
}

}  // namespace abflat
