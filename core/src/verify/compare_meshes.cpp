#include "abflat/compare_meshes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/counted.h"
#include "base/guarded.h"
#include "verify/match_faces.h"

namespace abflat {
namespace {

/// Relative to the diagonal: above the rounding of float32, below most edges.
constexpr double kSamePlace = 1e-6;

double samePlace(const PolygonMesh& mesh) {
  // Far from the origin, single precision is coarser.
  double most = 0;
  for (const double x : mesh.positions) most = std::max(most, std::abs(x));
  return std::max(kSamePlace * diagonalOf(mesh.positions), std::ldexp(most, -23));
}

class Comparison {
 public:
  Comparison(const ComparedMesh& was, const ComparedMesh& now)
      : was_(was),
        now_(now),
        tolerance_(samePlace(was.mesh)),
        match_(matchFaces(was.mesh, now.mesh, tolerance_)) {}

  std::vector<MeshDifference> run(const CompareMeshesOptions& options) {
    findFaces();
    if (options.faceOrder) findFaceOrder();
    if (options.vertexOrder) findVertices();
    for (const CornerAttribute& attribute : was_.attributes) findAttribute(attribute);
    return std::move(out_);
  }

 private:
  void add(MeshDifferenceKind kind, std::string message, std::vector<std::uint32_t> faces) {
    out_.push_back({kind, std::move(message), std::move(faces)});
  }

  /// `faces`: of the new mesh.
  void addFaces(MeshDifferenceKind kind, std::vector<std::uint32_t> faces, const std::string& one,
                const std::string& many) {
    if (faces.empty()) return;
    std::string message = counted(faces.size(), one.c_str(), many.c_str()) +
                          (faces.size() > 1 ? ", the first of which is face " : ": face ") +
                          std::to_string(faces.front());
    add(kind, std::move(message), std::move(faces));
  }

  void findFaces() {
    if (!match_.missing.empty()) {
      const std::size_t count = match_.missing.size();
      add(MeshDifferenceKind::Geometry,
          counted(count, "face is missing", "faces are missing") +
              (count > 1 ? ", the first of which was face " : ": it was face ") +
              std::to_string(match_.missing.front()),
          {});
    }
    std::vector<std::uint32_t> fresh;
    for (std::uint32_t f = 0; f < match_.face.size(); ++f)
      if (match_.face[f] == kNoMatch) fresh.push_back(f);
    addFaces(MeshDifferenceKind::Geometry, std::move(fresh), "face was not there before",
             "faces were not there before");
    addFaces(MeshDifferenceKind::Geometry, match_.turned, "face runs the other way round",
             "faces run the other way round");
  }

  void findFaceOrder() {
    std::uint32_t last = 0;
    for (std::uint32_t f = 0; f < match_.face.size(); ++f) {
      const std::uint32_t old = match_.face[f];
      if (old == kNoMatch) continue;
      if (old < last)
        return add(MeshDifferenceKind::Order,
                   "faces are in another order: face " + std::to_string(f) + " was face " +
                       std::to_string(old),
                   {f});
      last = old;
    }
  }

  void findVertices() {
    const std::vector<double>&a = was_.mesh.positions, &b = now_.mesh.positions;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const std::string vertex = std::to_string(i / 3);
      if (i >= b.size())
        return add(MeshDifferenceKind::Order, "vertices are missing, from vertex " + vertex + " on",
                   {});
      if (!(std::abs(a[i] - b[i]) <= tolerance_))
        return add(MeshDifferenceKind::Order,
                   "vertex " + vertex + " is elsewhere, or vertices are in another order", {});
    }
  }

  void findAttribute(const CornerAttribute& was) {
    const auto now = std::find_if(now_.attributes.begin(), now_.attributes.end(),
                                  [&](const CornerAttribute& a) { return a.name == was.name; });
    if (now == now_.attributes.end())
      return add(MeshDifferenceKind::Attribute, was.name + " are missing", {});
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < now_.mesh.faceCount(); ++f)
      if (!isSame(f, was, *now)) faces.push_back(f);
    addFaces(MeshDifferenceKind::Attribute, std::move(faces), "face has other " + was.name,
             "faces have other " + was.name);
  }

  bool isSame(std::uint32_t face, const CornerAttribute& was, const CornerAttribute& now) const {
    for (std::uint32_t c = now_.mesh.faceOffsets[face]; c < now_.mesh.faceOffsets[face + 1]; ++c)
      if (match_.corner[c] != kNoMatch && !areSame(was, was.row[match_.corner[c]], now, now.row[c]))
        return false;
    return true;
  }

  static bool areSame(const CornerAttribute& a, std::uint32_t i, const CornerAttribute& b,
                      std::uint32_t k) {
    if (i == kNoRow || k == kNoRow) return i == k;
    if (a.width != b.width) return false;
    for (std::size_t n = 0; n < a.width; ++n)
      if (!(std::abs(a.values[i * a.width + n] - b.values[k * a.width + n]) <=
            std::max(a.tolerance, b.tolerance)))
        return false;
    return true;
  }

  const ComparedMesh& was_;
  const ComparedMesh& now_;
  double tolerance_;
  FaceMatch match_;
  std::vector<MeshDifference> out_;
};

}  // namespace

Result<std::vector<MeshDifference>> compareMeshes(const ComparedMesh& was, const ComparedMesh& now,
                                                  const CompareMeshesOptions& options) {
  return guarded([&]() -> Result<std::vector<MeshDifference>> {
    for (const PolygonMesh* mesh : {&was.mesh, &now.mesh})
      if (Status s = validateArrays(*mesh); !s.ok()) return s;
    return Comparison(was, now).run(options);
  });
}

}  // namespace abflat
