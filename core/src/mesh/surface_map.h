#pragma once

#include <utility>

#include "mesh/input_mesh.h"
#include "mesh/surface.h"
#include "mesh/welded_mesh.h"

namespace abflat {

/// Where a surface comes from. The single owner of the mapping from its triangles and corners
/// through triangulation and welding to the user's mesh, and back. Refers to all three.
class SurfaceMap {
 public:
  SurfaceMap(const InputMesh& input, const WeldedMesh& welded, const Surface& surface)
      : input_(input), welded_(welded), surface_(surface) {}

  const InputMesh& input() const { return input_; }
  const WeldedMesh& welded() const { return welded_; }
  const Surface& surface() const { return surface_; }

  InputFace face(SurfaceTriangle f) const {
    return welded_.inputFace[surface_.triangulation.face[f]];
  }
  InputCorner corner(SurfaceCorner c) const {
    return welded_.inputCorner[surface_.triangulation.corner[c]];
  }
  InputVertex vertex(SurfaceCorner c) const { return InputVertex(input_.vertex(corner(c))); }

  /// For each input corner, the value of its surface corners, which all have the same; T() if the
  /// corner bounds nothing.
  template <class T>
  IdVector<InputCorner, T> toInput(const IdVector<SurfaceCorner, T>& ofCorner) const {
    IdVector<PolygonCorner, T> ofPolygon(welded_.inputCorner.size());
    for (const SurfaceCorner c : ofCorner.ids())
      ofPolygon[surface_.triangulation.corner[c]] = ofCorner[c];
    IdVector<InputCorner, T> out;
    out.reserve(welded_.cornerFor.size());
    for (const PolygonCorner c : welded_.cornerFor) out.push_back(c.exists() ? ofPolygon[c] : T());
    return out;
  }

 private:
  InputMesh input_;
  const WeldedMesh& welded_;
  const Surface& surface_;
};

}  // namespace abflat
