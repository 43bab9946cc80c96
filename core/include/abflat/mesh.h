#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/export.h"
#include "abflat/status.h"

namespace abflat {

/// Stands for "no texcoord" in faceTexcoords.
constexpr std::uint32_t kNoTexcoord = 0xffffffffu;

/// Stands for "no normal" in faceNormals.
constexpr std::uint32_t kNoNormal = 0xffffffffu;

/// Polygon mesh as the user gave it; nothing is welded, dropped or reordered.
struct PolygonMesh {
  std::vector<double> positions;  ///< xyz per vertex, size 3V, finite
  std::vector<std::uint32_t>
      faceOffsets;  ///< size F+1; corners of face f: [faceOffsets[f], faceOffsets[f+1])
  std::vector<std::uint32_t>
      faceVertices;  ///< vertex of each face corner, counter-clockwise seen from outside

  // Further data of the file about the surface. Each array is empty if the file has none.
  std::vector<double> texcoords;             ///< uv per texcoord, in any range
  std::vector<std::uint32_t> faceTexcoords;  ///< texcoord of each face corner, or kNoTexcoord
  std::vector<std::uint32_t> faceMaterials;  ///< per face; numbered by first appearance
  std::vector<std::string> materialNames;    ///< by these numbers; empty if it has no name
  std::vector<double> normals;               ///< xyz per shading normal, of any length
  std::vector<std::uint32_t> faceNormals;    ///< normal of each face corner, or kNoNormal
  /// Smoothing group per face, 0 = off. Counts for edges where no corner has a normal.
  std::vector<std::uint32_t> faceSmoothing;
  bool isZUp = false;  ///< z points up in such files, not y
  /// Per vertex, the number of the object that it belongs to. Those of different objects are apart,
  /// even at one place. Empty: there is one object.
  std::vector<std::uint32_t> vertexObjects;

  std::size_t vertexCount() const { return positions.size() / 3; }
  std::size_t faceCount() const { return faceOffsets.empty() ? 0 : faceOffsets.size() - 1; }
};

/// Makes a mesh of triangles only. `indices` has 3 vertices per triangle.
ABFLAT_API PolygonMesh makeTriangleMesh(std::vector<double> positions,
                                        std::vector<std::uint32_t> indices);

/// Checks arrays that did not come from a file: index ranges, finite coordinates, face sizes.
/// Errors: InvalidMesh (names vertex, face or corner).
ABFLAT_API Status validateArrays(const PolygonMesh& mesh);

}  // namespace abflat
