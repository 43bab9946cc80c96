#include "abflat/join_meshes.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "abflat/orient.h"
#include "base/guarded.h"

namespace abflat {
namespace {

using IndexList = std::vector<std::uint32_t>;

/// One more than the largest number, without those that stand for nothing.
std::uint32_t endOf(const IndexList& numbers) {
  std::uint32_t out = 0;
  for (const std::uint32_t x : numbers)
    if (x != kNoNormal) out = std::max(out, x + 1);
  return out;
}

/// Appends numbers that count from `base` on, but for those that stand for nothing.
void appendCounted(const IndexList& numbers, std::size_t base, IndexList& out) {
  for (const std::uint32_t x : numbers)
    out.push_back(x == kNoNormal ? x : x + static_cast<std::uint32_t>(base));
}

/// Values per corner, which refer to a list of which the first `base` belong to other meshes.
void appendOfCorners(const IndexList& ofCorner, std::size_t corners, std::size_t base,
                     IndexList& out) {
  if (ofCorner.empty())
    out.resize(out.size() + corners, kNoNormal);
  else
    appendCounted(ofCorner, base, out);
}

/// y points up in the copy.
void appendPlaces(const std::vector<double>& places, bool isTurned, std::vector<double>& out) {
  if (!isTurned) {
    out.insert(out.end(), places.begin(), places.end());
    return;
  }
  for (std::size_t i = 0; i + 2 < places.size(); i += 3)
    out.insert(out.end(), {places[i], places[i + 2], -places[i + 1]});
}

class MeshJoiner {
 public:
  explicit MeshJoiner(const std::vector<const PolygonMesh*>& meshes) : meshes_(meshes) {
    const auto isAny = [&](const auto& test) {
      return std::any_of(meshes.begin(), meshes.end(), [&](const auto* m) { return test(*m); });
    };
    isZUp_ = !isAny([](const PolygonMesh& m) { return !m.isZUp; });
    hasTexcoords_ = isAny([](const PolygonMesh& m) { return !m.faceTexcoords.empty(); });
    hasMaterials_ = isAny([](const PolygonMesh& m) { return !m.faceMaterials.empty(); });
    hasNormals_ = isAny([](const PolygonMesh& m) { return !m.faceNormals.empty(); });
    hasGroups_ = isAny([](const PolygonMesh& m) { return !m.faceSmoothing.empty(); }) ||
                 (hasNormals_ && isAny([](const PolygonMesh& m) { return m.faceNormals.empty(); }));
  }

  Result<PolygonMesh> join() {
    if (meshes_.empty()) return std::move(out_);
    if (Status s = check(); !s.ok()) return s;
    out_.isZUp = isZUp_;
    out_.faceOffsets = {0};
    for (const PolygonMesh* mesh : meshes_) append(*mesh);
    return std::move(out_);
  }

 private:
  Status check() const {
    std::size_t vertices = 0, corners = 0;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      if (const Status s = validateArrays(*meshes_[i]); !s.ok())
        return {s.code, "mesh " + std::to_string(i) + ": " + s.message};
      vertices += meshes_[i]->vertexCount();
      corners += meshes_[i]->faceVertices.size();
    }
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    if (vertices <= kMost && corners <= kMost) return {};
    return {StatusCode::InvalidMesh,
            "the meshes have more than 4294967295 vertices or face corners together"};
  }

  void append(const PolygonMesh& mesh) {
    const std::size_t corners = mesh.faceVertices.size();
    if (hasTexcoords_)
      appendOfCorners(mesh.faceTexcoords, corners, out_.texcoords.size() / 2, out_.faceTexcoords);
    if (hasNormals_)
      appendOfCorners(mesh.faceNormals, corners, out_.normals.size() / 3, out_.faceNormals);
    if (hasMaterials_) appendMaterials(mesh);
    if (hasGroups_) appendGroups(mesh);
    appendObjects(mesh);
    for (std::size_t f = 1; f < mesh.faceOffsets.size(); ++f)
      out_.faceOffsets.push_back(
          static_cast<std::uint32_t>(out_.faceVertices.size() + mesh.faceOffsets[f]));
    appendCounted(mesh.faceVertices, out_.vertexCount(), out_.faceVertices);
    const bool isTurned = mesh.isZUp && !isZUp_;
    appendPlaces(mesh.positions, isTurned, out_.positions);
    appendPlaces(mesh.normals, isTurned, out_.normals);
    out_.texcoords.insert(out_.texcoords.end(), mesh.texcoords.begin(), mesh.texcoords.end());
  }

  /// Faces of different meshes have different materials.
  void appendMaterials(const PolygonMesh& mesh) {
    const std::uint32_t base = materials_;
    if (mesh.faceMaterials.empty())
      out_.faceMaterials.resize(out_.faceMaterials.size() + mesh.faceCount(), base);
    else
      appendCounted(mesh.faceMaterials, base, out_.faceMaterials);
    materials_ += std::max<std::uint32_t>(
        {1, endOf(mesh.faceMaterials), static_cast<std::uint32_t>(mesh.materialNames.size())});
    for (const std::string& name : mesh.materialNames) out_.materialNames.push_back(name);
    out_.materialNames.resize(materials_);
  }

  /// Edges of a mesh that has neither normals nor groups are smooth, as those within a group.
  void appendGroups(const PolygonMesh& mesh) {
    const std::uint32_t group = mesh.faceNormals.empty() ? 1 : 0;
    if (mesh.faceSmoothing.empty())
      out_.faceSmoothing.resize(out_.faceSmoothing.size() + mesh.faceCount(), group);
    else
      appendCounted(mesh.faceSmoothing, 0, out_.faceSmoothing);
  }

  void appendObjects(const PolygonMesh& mesh) {
    if (mesh.vertexObjects.empty())
      out_.vertexObjects.resize(out_.vertexObjects.size() + mesh.vertexCount(), objects_);
    else
      appendCounted(mesh.vertexObjects, objects_, out_.vertexObjects);
    objects_ += std::max<std::uint32_t>(1, endOf(mesh.vertexObjects));
  }

  const std::vector<const PolygonMesh*>& meshes_;
  bool isZUp_ = false, hasTexcoords_ = false, hasMaterials_ = false;
  bool hasNormals_ = false, hasGroups_ = false;
  std::uint32_t materials_ = 0, objects_ = 0;
  PolygonMesh out_;
};

/// Moves on through values that are sorted by mesh; takes those below an end.
IndexList takeBelow(const IndexList& values, std::size_t& next, std::size_t begin,
                    std::size_t end) {
  IndexList out;
  for (; next < values.size() && values[next] < end; ++next)
    out.push_back(values[next] - static_cast<std::uint32_t>(begin));
  return out;
}

/// Texcoords keep their order, but are numbered anew: those of one mesh need not lie side by side.
void takeTexcoords(const UnwrapResult& joined, std::size_t begin, std::size_t end,
                   JoinedPart& out) {
  IndexList used(joined.cornerUv.begin() + static_cast<std::ptrdiff_t>(begin),
                 joined.cornerUv.begin() + static_cast<std::ptrdiff_t>(end));
  out.cornerUv = used;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t& c : out.cornerUv)
    c = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), c) - used.begin());
  for (const std::uint32_t t : used)
    out.uv.insert(out.uv.end(), {joined.uv[2 * std::size_t{t}], joined.uv[2 * std::size_t{t} + 1]});
}

}  // namespace

Result<PolygonMesh> joinMeshes(const std::vector<const PolygonMesh*>& meshes) {
  return guarded([&] { return MeshJoiner(meshes).join(); });
}

std::vector<JoinedPart> splitLayout(const UnwrapResult& joined,
                                    const std::vector<const PolygonMesh*>& meshes) {
  std::vector<JoinedPart> out;
  std::size_t face = 0, corner = 0, triangleCorner = 0, turned = 0;
  for (const PolygonMesh* mesh : meshes) {
    JoinedPart& part = out.emplace_back();
    const std::size_t faceEnd = face + mesh->faceCount();
    const std::size_t cornerEnd = corner + mesh->faceVertices.size();
    takeTexcoords(joined, corner, cornerEnd, part);
    part.chartOfFace.assign(joined.chartOfFace.begin() + static_cast<std::ptrdiff_t>(face),
                            joined.chartOfFace.begin() + static_cast<std::ptrdiff_t>(faceEnd));
    part.triangleCorners = takeBelow(joined.triangleCorners, triangleCorner, corner, cornerEnd);
    part.turnedFaces = takeBelow(joined.report.repair.turnedFaces, turned, face, faceEnd);
    face = faceEnd;
    corner = cornerEnd;
  }
  return out;
}

void turnFaces(PolygonMesh& mesh, JoinedPart& layout) {
  if (layout.turnedFaces.empty()) return;
  turnFaces(layout.turnedFaces, mesh);
  const IndexList order = turnedCorners(mesh, layout.turnedFaces);
  layout.cornerUv = reordered(layout.cornerUv, order);
  for (std::uint32_t& corner : layout.triangleCorners) corner = order[corner];
}

}  // namespace abflat
