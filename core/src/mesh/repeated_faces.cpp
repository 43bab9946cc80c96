#include "mesh/repeated_faces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/ids.h"
#include "base/stable_order.h"

namespace abflat {
namespace {

/// Faces with the same vertices, in order.
using Copies = std::vector<std::uint32_t>;

/// Does not depend on the order of the vertices.
std::uint64_t hashOf(const PolygonMesh& mesh, std::uint32_t f) {
  std::uint64_t sum = 0;
  for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
    std::uint64_t x = (mesh.faceVertices[c] + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 29) * 0xbf58476d1ce4e5b9u;
    sum += x ^ x >> 32;
  }
  return sum;
}

std::vector<std::uint32_t> sortedVertices(const PolygonMesh& mesh, std::uint32_t f) {
  std::vector<std::uint32_t> v(mesh.faceVertices.begin() + mesh.faceOffsets[f],
                               mesh.faceVertices.begin() + mesh.faceOffsets[f + 1]);
  std::sort(v.begin(), v.end());
  return v;
}

std::vector<Copies> findCopies(const PolygonMesh& mesh, const Listener& listener,
                               std::vector<std::uint32_t>& original) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(mesh.faceCount());
  for (std::uint32_t f = 0; f < mesh.faceCount() && listener.beat(); ++f)
    keys[f] = {hashOf(mesh, f), f};
  std::vector<Copies> out;
  if (listener.isStopped()) return out;
  std::sort(keys.begin(), keys.end());
  std::vector<Copies> alike;  // of one hash
  for (std::size_t i = 0, end = 0; i < keys.size() && listener.beat(); i = end) {
    while (end < keys.size() && keys[end].first == keys[i].first) ++end;
    if (end == i + 1) continue;
    alike.clear();
    for (std::size_t j = i; j < end; ++j) {
      const std::uint32_t f = keys[j].second;
      const auto same = std::find_if(alike.begin(), alike.end(), [&](const Copies& copies) {
        return sortedVertices(mesh, copies.front()) == sortedVertices(mesh, f);
      });
      if (same == alike.end()) {
        alike.push_back({f});
      } else {
        original[f] = same->front();
        same->push_back(f);
      }
    }
    for (Copies& copies : alike)
      if (copies.size() > 1) out.push_back(std::move(copies));
  }
  return out;
}

/// Which of two ways around its vertices a face runs.
bool isForward(const PolygonMesh& mesh, std::uint32_t f) {
  const std::uint32_t* const v = &mesh.faceVertices[mesh.faceOffsets[f]];
  const std::size_t n = mesh.faceOffsets[f + 1] - mesh.faceOffsets[f];
  const auto k = static_cast<std::size_t>(std::min_element(v, v + n) - v);
  return v[(k + 1) % n] < v[(k + n - 1) % n];
}

/// An edge of faces that are there in both ways.
struct TwoWayEdge {
  std::uint32_t low, high, copies;
  bool isUpwards;  ///< whether the forward copies run from `low` to `high`

  bool isBefore(const TwoWayEdge& other) const {
    return std::array<std::uint32_t, 3>{low, high, copies} <
           std::array<std::uint32_t, 3>{other.low, other.high, other.copies};
  }
};

template <class Visit>
void visitEdges(const PolygonMesh& mesh, std::uint32_t f, const Visit& visit) {
  const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
  for (std::uint32_t c = begin; c < end; ++c) {
    const std::uint32_t a = mesh.faceVertices[c],
                        b = mesh.faceVertices[c + 1 < end ? c + 1 : begin];
    visit(std::min(a, b), std::max(a, b), a < b);
  }
}

/// Decides which of the copies that run in different ways continue the faces beside them.
class TwoWayCopies {
 public:
  TwoWayCopies(const PolygonMesh& mesh, const std::vector<Copies>& all) : mesh_(mesh) {
    for (const Copies& copies : all) {
      const bool first = isForward(mesh, copies.front());
      const bool isTwoWay = std::any_of(copies.begin(), copies.end(), [&](std::uint32_t f) {
        return isForward(mesh, f) != first;
      });
      if (isTwoWay) copies_.push_back(&copies);
    }
    for (std::uint32_t i = 0; i < copies_.size(); ++i) {
      const std::uint32_t f = copies_[i]->front();
      visitEdges(mesh, f, [&](std::uint32_t low, std::uint32_t high, bool isUpwards) {
        edges_.push_back({low, high, i, isUpwards == isForward(mesh, f)});
      });
    }
    sortStably(edges_, [](const TwoWayEdge& a, const TwoWayEdge& b) { return a.isBefore(b); });
  }

  bool isAny() const { return !copies_.empty(); }

  /// Puts the copies that continue other faces first. `isLeftOut`: faces that do not count, since
  /// they repeat others.
  template <class IsLeftOut>
  std::vector<Copies> inOrder(const IsLeftOut& isLeftOut) {
    votes_.assign(copies_.size(), 0);
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f)
      if (!isLeftOut(f))
        visitEdges(mesh_, f, [&](std::uint32_t low, std::uint32_t high, bool isUpwards) {
          vote(low, high, isUpwards, kNone);
        });
    decideAll();
    std::vector<Copies> out;
    for (std::size_t i = 0; i < copies_.size(); ++i) {
      out.push_back(*copies_[i]);
      sortStably(out.back(),
                 [&](std::uint32_t a, std::uint32_t b) { return isFirst(i, a) && !isFirst(i, b); });
    }
    return out;
  }

  const std::vector<const Copies*>& copies() const { return copies_; }

 private:
  bool isFirst(std::size_t i, std::uint32_t f) const {
    return isForward(mesh_, f) == (votes_[i] > 0);
  }

  /// A face that runs up an edge asks for a copy that runs down. Tells the copies beside it that
  /// are new to it.
  void vote(std::uint32_t low, std::uint32_t high, bool isUpwards, std::uint32_t from) {
    const TwoWayEdge first{low, high, 0, false};
    auto edge =
        std::lower_bound(edges_.begin(), edges_.end(), first,
                         [](const TwoWayEdge& a, const TwoWayEdge& b) { return a.isBefore(b); });
    for (; edge != edges_.end() && edge->low == low && edge->high == high; ++edge) {
      if (edge->copies == from || (from != kNone && votes_[edge->copies] != 0)) continue;
      votes_[edge->copies] += edge->isUpwards != isUpwards ? 1 : -1;
      if (from != kNone) open_.push_back(edge->copies);
    }
  }

  /// What is decided spreads. Where nothing decides, it begins with a first copy.
  void decideAll() {
    for (std::uint32_t i = 0; i < copies_.size(); ++i)
      if (votes_[i] != 0) open_.push_back(i);
    for (std::uint32_t next = 0;; ++next) {
      spread();
      while (next < copies_.size() && votes_[next] != 0) ++next;
      if (next == copies_.size()) return;
      votes_[next] = isForward(mesh_, copies_[next]->front()) ? 1 : -1;
      open_.push_back(next);
    }
  }

  void spread() {
    for (std::size_t k = 0; k < open_.size(); ++k) {
      const std::uint32_t i = open_[k];
      const std::uint32_t f = copies_[i]->front();
      const bool isTurned = !isFirst(i, f);
      visitEdges(mesh_, f, [&](std::uint32_t low, std::uint32_t high, bool isUpwards) {
        vote(low, high, isUpwards != isTurned, i);
      });
    }
    open_.clear();
  }

  const PolygonMesh& mesh_;
  std::vector<const Copies*> copies_;
  std::vector<TwoWayEdge> edges_;
  std::vector<int> votes_;  ///< for forward copies, less those for others; 0: undecided
  std::vector<std::uint32_t> open_;
};

}  // namespace

RepeatedFaces findRepeated(const PolygonMesh& mesh, const Listener& listener) {
  RepeatedFaces out;
  out.original.assign(mesh.faceCount(), kNone);
  out.layer.assign(mesh.faceCount(), 0);
  const std::vector<Copies> all = findCopies(mesh, listener, out.original);
  const auto setLayers = [&](const Copies& copies) {
    for (std::size_t k = 0; k < copies.size(); ++k)
      out.layer[copies[k]] = static_cast<std::uint32_t>(k);
  };
  for (const Copies& copies : all) setLayers(copies);
  TwoWayCopies twoWay(mesh, all);
  if (listener.isStopped() || !twoWay.isAny()) return out;
  std::vector<std::uint8_t> isTwoWay(mesh.faceCount(), 0);
  for (const Copies* copies : twoWay.copies())
    for (const std::uint32_t f : *copies) isTwoWay[f] = 1;
  const auto isLeftOut = [&](std::uint32_t f) { return isTwoWay[f] || out.layer[f] > 0; };
  for (const Copies& copies : twoWay.inOrder(isLeftOut)) setLayers(copies);
  return out;
}

}  // namespace abflat
