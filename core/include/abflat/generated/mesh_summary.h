// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <cstdint>

#include "abflat/status.h"

namespace abflat {

/// What a mesh is, topologically.
struct MeshSummary {
  /// Number of vertices.
  std::size_t vertices = 0;
  /// Vertices that no face uses.
  std::size_t unreferencedVertices = 0;
  /// Number of faces.
  std::size_t faces = 0;
  /// Number of triangles, once polygons are triangulated.
  std::size_t triangles = 0;
  /// Edge-connected components.
  std::size_t components = 0;
  /// Number of boundary loops.
  std::size_t boundaryLoops = 0;
  /// Number of boundary edges.
  std::size_t boundaryEdges = 0;
  /// Edges with more than two faces.
  std::size_t nonManifoldEdges = 0;
  /// Edges whose two faces run in the same direction.
  std::size_t orientationConflicts = 0;
  /// Faces of zero area.
  std::size_t degenerateFaces = 0;
  /// Vertices - edges + faces.
  std::int64_t eulerCharacteristic = 0;
  /// Sum over components; -1 if the surface is not manifold, or not oriented consistently.
  std::int64_t genus = 0;
  /// Texcoords of the file.
  std::size_t texcoords = 0;
  /// Shading normals of the file; those of facets, as in STL, do not count.
  std::size_t normals = 0;
  /// Smoothing groups that faces use, off among them; 0 if the file has normals.
  std::size_t smoothingGroups = 0;
  /// Materials that faces use.
  std::size_t materials = 0;
  /// Whether the mesh is one topological disk, which flatten accepts.
  Status disk;
};

template <class Visitor>
void visitFields(const MeshSummary& r, Visitor& v) {
  v.field("vertices", r.vertices);
  v.field("unreferencedVertices", r.unreferencedVertices);
  v.field("faces", r.faces);
  v.field("triangles", r.triangles);
  v.field("components", r.components);
  v.field("boundaryLoops", r.boundaryLoops);
  v.field("boundaryEdges", r.boundaryEdges);
  v.field("nonManifoldEdges", r.nonManifoldEdges);
  v.field("orientationConflicts", r.orientationConflicts);
  v.field("degenerateFaces", r.degenerateFaces);
  v.field("eulerCharacteristic", r.eulerCharacteristic);
  v.field("genus", r.genus);
  v.field("texcoords", r.texcoords);
  v.field("normals", r.normals);
  v.field("smoothingGroups", r.smoothingGroups);
  v.field("materials", r.materials);
  v.verdict("disk", r.disk);
}

template <class Visitor>
void visitInputSummary(const MeshSummary& r, Visitor& v) {
  v.field("vertices", r.vertices);
  v.field("faces", r.faces);
  v.field("triangles", r.triangles);
  v.field("components", r.components);
  v.field("boundaryLoops", r.boundaryLoops);
  v.field("boundaryEdges", r.boundaryEdges);
  v.field("genus", r.genus);
}

}  // namespace abflat
