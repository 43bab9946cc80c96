#include "verify/match_faces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "mesh/weld.h"

namespace abflat {
namespace {

const double* placeOf(const PolygonMesh& mesh, std::uint32_t corner) {
  return &mesh.positions[3 * std::size_t{mesh.faceVertices[corner]}];
}

bool areNear(const double* a, const double* b, double tolerance) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(a[k] - b[k]) <= tolerance)) return false;
  return true;
}

/// All faces have the same corners, in the same order: what is usual.
std::optional<FaceMatch> matchInOrder(const PolygonMesh& was, const PolygonMesh& now,
                                      double tolerance) {
  if (was.faceOffsets != now.faceOffsets) return {};
  for (std::uint32_t c = 0; c < now.faceVertices.size(); ++c)
    if (!areNear(placeOf(was, c), placeOf(now, c), tolerance)) return {};
  FaceMatch out;
  out.face.resize(now.faceCount());
  out.corner.resize(now.faceVertices.size());
  std::iota(out.face.begin(), out.face.end(), 0u);
  std::iota(out.corner.begin(), out.corner.end(), 0u);
  return out;
}

/// Numbers of places that both meshes share, per face corner.
struct SharedPlaces {
  std::vector<std::uint32_t> was, now;
  std::uint32_t count = 0;
};

SharedPlaces sharedPlaces(const PolygonMesh& was, const PolygonMesh& now, double tolerance) {
  std::vector<double> all = was.positions;
  all.insert(all.end(), now.positions.begin(), now.positions.end());
  const double diagonal = diagonalOf(all);
  const std::vector<std::uint32_t> place =
      weldVertices(all, diagonal > 0 ? tolerance / diagonal : 0).ofVertex;
  SharedPlaces out;
  out.count = static_cast<std::uint32_t>(place.size());
  for (const std::uint32_t v : was.faceVertices) out.was.push_back(place[v]);
  for (const std::uint32_t v : now.faceVertices) out.now.push_back(place[was.vertexCount() + v]);
  return out;
}

class FaceMatcher {
 public:
  FaceMatcher(const PolygonMesh& was, const PolygonMesh& now, double tolerance)
      : was_(was), now_(now), places_(sharedPlaces(was, now, tolerance)) {
    for (std::uint32_t f = 0; f < was.faceCount(); ++f)
      left_.push_back(trianglesOf(was, f));  // none is found yet
    listFaces();
    out_.face.assign(now.faceCount(), kNoMatch);
    out_.corner.assign(now.faceVertices.size(), kNoMatch);
  }

  FaceMatch run() {
    for (std::uint32_t f = 0; f < now_.faceCount(); ++f) {
      if (find(f, false)) continue;
      if (find(f, true)) out_.turned.push_back(f);
    }
    for (std::uint32_t f = 0; f < left_.size(); ++f)
      if (left_[f] > 0) out_.missing.push_back(f);
    return std::move(out_);
  }

 private:
  static std::uint32_t trianglesOf(const PolygonMesh& mesh, std::uint32_t face) {
    return mesh.faceOffsets[face + 1] - mesh.faceOffsets[face] - 2;
  }

  /// The faces of `was` at each place.
  void listFaces() {
    begin_.assign(std::size_t{places_.count} + 1, 0);
    for (const std::uint32_t place : places_.was) ++begin_[place + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    facesAt_.resize(places_.was.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t f = 0; f < was_.faceCount(); ++f)
      for (std::uint32_t c = was_.faceOffsets[f]; c < was_.faceOffsets[f + 1]; ++c)
        facesAt_[next[places_.was[c]]++] = f;
  }

  bool find(std::uint32_t f, bool isTurned) {
    // Faces mostly follow each other as before.
    for (const std::uint32_t guess : {last_, last_ + 1})
      if (guess < left_.size() && take(f, guess, isTurned)) return true;
    std::uint32_t rarest = places_.now[now_.faceOffsets[f]];
    for (std::uint32_t c = now_.faceOffsets[f]; c < now_.faceOffsets[f + 1]; ++c)
      if (facesAt(places_.now[c]) < facesAt(rarest)) rarest = places_.now[c];
    for (std::uint32_t i = begin_[rarest]; i < begin_[rarest + 1]; ++i)
      if (take(f, facesAt_[i], isTurned)) return true;
    return false;
  }

  std::uint32_t facesAt(std::uint32_t place) const { return begin_[place + 1] - begin_[place]; }

  /// Whether face `f` is the whole of `old`, or a part of it that is still to be found.
  bool take(std::uint32_t f, std::uint32_t old, bool isTurned) {
    if (left_[old] < trianglesOf(now_, f)) return false;
    const std::uint32_t begin = was_.faceOffsets[old];
    const std::uint32_t count = was_.faceOffsets[old + 1] - begin;
    for (std::uint32_t start = 0; start < count; ++start)
      if (takeFrom(f, begin, count, start, isTurned)) {
        left_[old] -= trianglesOf(now_, f);
        out_.face[f] = last_ = old;
        return true;
      }
    return false;
  }

  /// Walks once around the old face, from its corner `start` on.
  bool takeFrom(std::uint32_t f, std::uint32_t begin, std::uint32_t count, std::uint32_t start,
                bool isTurned) {
    std::uint32_t c = now_.faceOffsets[f];
    const std::uint32_t end = now_.faceOffsets[f + 1];
    if (places_.was[begin + start] != places_.now[c]) return false;
    for (std::uint32_t step = 0; step < count && c < end; ++step) {
      const std::uint32_t old = begin + (start + (isTurned ? count - step : step)) % count;
      if (places_.was[old] == places_.now[c]) out_.corner[c++] = old;
    }
    if (c < end) std::fill(&out_.corner[now_.faceOffsets[f]], &out_.corner[c], kNoMatch);
    return c == end;
  }

  const PolygonMesh& was_;
  const PolygonMesh& now_;
  SharedPlaces places_;
  std::vector<std::uint32_t> left_;  ///< triangles of each old face that are not found yet
  std::vector<std::uint32_t> begin_, facesAt_;
  std::uint32_t last_ = 0;  ///< the old face found last
  FaceMatch out_;
};

}  // namespace

double diagonalOf(const std::vector<double>& positions) {
  double out = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = k; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    if (low <= high) out = std::hypot(out, high - low);
  }
  return out;
}

FaceMatch matchFaces(const PolygonMesh& was, const PolygonMesh& now, double tolerance) {
  if (std::optional<FaceMatch> same = matchInOrder(was, now, tolerance)) return std::move(*same);
  return FaceMatcher(was, now, tolerance).run();
}

}  // namespace abflat
