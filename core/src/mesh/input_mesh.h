#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "abflat/mesh.h"
#include "abflat/mesh_view.h"

namespace abflat {

/// The mesh as the caller gave it, in the caller's memory: polygons, or a view of triangles. A
/// corner counts from the first corner of the first face.
class InputMesh {
 public:
  InputMesh(const PolygonMesh& mesh) : polygons_(&mesh) {}
  InputMesh(const MeshView& mesh) : view_(mesh) {}

  std::size_t vertexCount() const {
    return polygons_ ? polygons_->vertexCount() : view_->positions.size();
  }
  std::size_t faceCount() const {
    return polygons_ ? polygons_->faceCount() : view_->triangles.size();
  }
  std::size_t cornerCount() const {
    return polygons_ ? polygons_->faceVertices.size() : 3 * view_->triangles.size();
  }

  /// The first corner of a face; of the face after the last one, the number of corners.
  std::uint32_t firstCorner(std::size_t face) const {
    return polygons_ ? polygons_->faceOffsets[face] : static_cast<std::uint32_t>(3 * face);
  }
  std::uint32_t vertex(std::size_t corner) const {
    return polygons_ ? polygons_->faceVertices[corner]
                     : static_cast<std::uint32_t>(view_->triangles.vertex(corner / 3, corner % 3));
  }
  std::array<double, 3> position(std::size_t vertex) const {
    if (!polygons_) return view_->positions[vertex];
    const double* p = &polygons_->positions[3 * vertex];
    return {p[0], p[1], p[2]};
  }

  /// Texcoords, normals, materials and whatever else a PolygonMesh may have; a view has none.
  const PolygonMesh& extras() const;
  /// Null if it is a view.
  const PolygonMesh* polygons() const { return polygons_; }
  PolygonMesh copy() const;
  /// As validateArrays. Errors: InvalidMesh.
  Status validate() const;

 private:
  const PolygonMesh* polygons_ = nullptr;
  std::optional<MeshView> view_;
};

/// Exponent of the power of two that scales the largest coordinate of a face into 1 to 2.
int exponentOf(const InputMesh& mesh);

}  // namespace abflat
