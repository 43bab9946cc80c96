#pragma once

#include <cstdint>

#include "abflat/mesh.h"

namespace abflat {

/// Adds the triangles of strips to a mesh, vertex by vertex. Triangles that use a vertex twice only
/// lead from one place to another and are left out.
class TriangleStrip {
 public:
  explicit TriangleStrip(PolygonMesh& mesh) : mesh_(mesh) {}

  /// The next vertex begins a strip.
  void end() { size_ = 0; }

  void add(std::uint32_t vertex) {
    if (size_ >= 2 && first_ != second_ && second_ != vertex && vertex != first_) {
      // Every other triangle of a strip has the opposite orientation.
      const bool isTurned = size_ % 2 == 1;
      mesh_.faceVertices.insert(mesh_.faceVertices.end(),
                                {isTurned ? second_ : first_, isTurned ? first_ : second_, vertex});
      mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
    }
    first_ = second_;
    second_ = vertex;
    ++size_;
  }

 private:
  PolygonMesh& mesh_;
  std::uint64_t size_ = 0;
  std::uint32_t first_ = 0, second_ = 0;  ///< the last two vertices
};

}  // namespace abflat
