#include "mesh/welded_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/corner_table.h"
#include "mesh/weld.h"

namespace abflat {
namespace {

/// Input corners of a face, or of a part of one.
using Loop = std::vector<std::uint32_t>;

/// Takes loops without repeated places off a face: between two corners at one place lies a loop.
/// Those of fewer than three corners are dropped.
class FaceSplitter {
 public:
  explicit FaceSplitter(std::size_t vertexCount) : positionOf_(vertexCount, kNone) {}

  /// `placeOf(corner)`; the loops are valid until the next call.
  template <class PlaceOf>
  const std::vector<Loop>& split(std::uint32_t begin, std::uint32_t end, const PlaceOf& placeOf) {
    loops_.clear();
    path_.clear();
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t place = placeOf(c);
      if (positionOf_[place] != kNone) take(positionOf_[place], placeOf);
      positionOf_[place] = static_cast<std::uint32_t>(path_.size());
      path_.push_back(c);
    }
    take(0, placeOf);
    return loops_;
  }

 private:
  template <class PlaceOf>
  void take(std::uint32_t from, const PlaceOf& placeOf) {
    for (std::size_t i = from; i < path_.size(); ++i) positionOf_[placeOf(path_[i])] = kNone;
    if (path_.size() - from >= 3) loops_.emplace_back(path_.begin() + from, path_.end());
    path_.resize(from);
  }

  std::vector<std::uint32_t> positionOf_;  ///< in the path, per place
  Loop path_;
  std::vector<Loop> loops_;
};

/// Faces that have the same vertices.
class Repetitions {
 public:
  explicit Repetitions(const PolygonMesh& mesh) : mesh_(mesh) {
    layer_.assign(mesh.faceCount(), 0);
    original_.assign(mesh.faceCount(), kNone);
    std::vector<Key> keys(mesh.faceCount());
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) keys[f] = {hash(f), f};
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 1; i < keys.size(); ++i)
      for (std::size_t j = i; j-- > 0 && keys[j].first == keys[i].first;)
        if (repeats(keys[i].second, keys[j].second)) break;
  }
  /// Earlier faces of the same vertices.
  std::uint32_t layer(std::uint32_t f) const { return layer_[f]; }
  /// The first of them, or kNone.
  std::uint32_t original(std::uint32_t f) const { return original_[f]; }

 private:
  using Key = std::pair<std::uint64_t, std::uint32_t>;

  /// The same for any order of the vertices.
  std::uint64_t hash(std::uint32_t f) const {
    std::uint64_t sum = 0;
    for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c) {
      std::uint64_t x = (mesh_.faceVertices[c] + 1) * 0x9e3779b97f4a7c15u;
      x = (x ^ x >> 29) * 0xbf58476d1ce4e5b9u;
      sum += x ^ x >> 32;
    }
    return sum;
  }

  std::vector<std::uint32_t> sorted(std::uint32_t f) const {
    std::vector<std::uint32_t> v(mesh_.faceVertices.begin() + mesh_.faceOffsets[f],
                                 mesh_.faceVertices.begin() + mesh_.faceOffsets[f + 1]);
    std::sort(v.begin(), v.end());
    return v;
  }

  /// Of faces in their order: the one found first is the last that f repeats.
  bool repeats(std::uint32_t f, std::uint32_t earlier) {
    if (sorted(f) != sorted(earlier)) return false;
    layer_[f] = layer_[earlier] + 1;
    original_[f] = original_[earlier] == kNone ? earlier : original_[earlier];
    return true;
  }

  const PolygonMesh& mesh_;
  std::vector<std::uint32_t> layer_, original_;
};

/// Gives faces that repeat others vertices of their own: one for each vertex and layer.
void separateLayers(WeldedMesh& out) {
  const Repetitions repetitions(out.mesh);
  struct Copy {
    std::uint32_t vertex, layer, corner;
  };
  std::vector<Copy> copies;
  for (std::uint32_t f = 0; f < out.mesh.faceCount(); ++f) {
    if (repetitions.layer(f) == 0) continue;
    out.duplicateFaces.push_back({out.inputFace[f], out.inputFace[repetitions.original(f)]});
    for (std::uint32_t c = out.mesh.faceOffsets[f]; c < out.mesh.faceOffsets[f + 1]; ++c)
      copies.push_back({out.mesh.faceVertices[c], repetitions.layer(f), c});
  }
  std::sort(copies.begin(), copies.end(), [](const Copy& a, const Copy& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex
           : a.layer != b.layer ? a.layer < b.layer
                                : a.corner < b.corner;
  });
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const Copy& c = copies[i];
    if (i == 0 || copies[i - 1].vertex != c.vertex || copies[i - 1].layer != c.layer)
      for (std::size_t d = 0; d < 3; ++d)
        out.mesh.positions.push_back(
            double{out.mesh.positions[3 * static_cast<std::size_t>(c.vertex) + d]});
    out.mesh.faceVertices[c.corner] = static_cast<std::uint32_t>(out.mesh.vertexCount() - 1);
  }
}

void findCornersFor(const PolygonMesh& input, const std::vector<std::uint32_t>& placeOf,
                    WeldedMesh& out) {
  out.cornerFor.assign(input.faceVertices.size(), kNone);
  std::vector<std::uint32_t> anyAt(input.vertexCount(), kNone);
  for (std::uint32_t c = static_cast<std::uint32_t>(out.inputCorner.size()); c-- > 0;) {
    out.cornerFor[out.inputCorner[c]] = c;
    anyAt[placeOf[input.faceVertices[out.inputCorner[c]]]] = c;
  }
  for (std::uint32_t f = 0; f < input.faceCount(); ++f)
    for (std::uint32_t c = input.faceOffsets[f]; c < input.faceOffsets[f + 1]; ++c) {
      const std::uint32_t place = placeOf[input.faceVertices[c]];
      for (std::uint32_t other = input.faceOffsets[f];
           out.cornerFor[c] == kNone && other < input.faceOffsets[f + 1]; ++other) {
        const std::uint32_t found = out.cornerFor[other];
        if (placeOf[input.faceVertices[other]] == place && found != kNone &&
            out.inputCorner[found] == other)
          out.cornerFor[c] = found;
      }
      if (out.cornerFor[c] == kNone) out.cornerFor[c] = anyAt[place];
    }
}

}  // namespace

WeldedMesh weld(const PolygonMesh& mesh, bool byPosition) {
  Welding welding;
  if (byPosition) {
    welding = weldSurface(mesh);
  } else {
    welding.ofVertex.resize(mesh.vertexCount());
    std::iota(welding.ofVertex.begin(), welding.ofVertex.end(), 0u);
  }
  const auto placeOf = [&](std::uint32_t c) { return welding.ofVertex[mesh.faceVertices[c]]; };
  WeldedMesh out;
  out.mergedVertices = welding.merged;
  out.mesh.positions = mesh.positions;
  out.mesh.faceOffsets.push_back(0);
  out.mesh.faceVertices.reserve(mesh.faceVertices.size());
  out.inputCorner.reserve(mesh.faceVertices.size());
  FaceSplitter splitter(mesh.vertexCount());
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t begin = mesh.faceOffsets[f], end = mesh.faceOffsets[f + 1];
    const std::vector<Loop>& loops = splitter.split(begin, end, placeOf);
    if (loops.empty())
      out.collapsedFaces.push_back(f);
    else if (loops.size() > 1 || loops.front().size() < end - begin)
      out.splitFaces.push_back(f);
    for (const Loop& loop : loops) {
      out.inputFace.push_back(f);
      for (const std::uint32_t c : loop) {
        out.inputCorner.push_back(c);
        out.mesh.faceVertices.push_back(placeOf(c));
      }
      out.mesh.faceOffsets.push_back(static_cast<std::uint32_t>(out.mesh.faceVertices.size()));
    }
  }
  findCornersFor(mesh, welding.ofVertex, out);
  separateLayers(out);
  out.place = std::move(welding.ofVertex);
  return out;
}

}  // namespace abflat
