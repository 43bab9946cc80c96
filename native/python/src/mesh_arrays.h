#pragma once

#include <pybind11/numpy.h>

#include "abflat/mesh.h"
#include "abflat/mesh_view.h"

namespace abflat::python {

/// A mesh as the Python side hands it over. It has checked the shapes and types, so that
/// `positions` is V x 3 of floats. With `offsets`, `vertices` has the corners of polygons one after
/// another; without, it is F x 3. What follows is None where the mesh has none.
struct MeshArrays {
  pybind11::array positions, vertices;
  pybind11::object offsets;
  pybind11::object texcoords, texcoordOfCorner;
  pybind11::object materialOfFace, objectOfVertex;

  /// Triangles and nothing else.
  bool isBare() const {
    return offsets.is_none() && texcoords.is_none() && materialOfFace.is_none() &&
           objectOfVertex.is_none();
  }
};

/// The triangles of a bare mesh where they are. The arrays must live as long.
MeshView viewOf(const MeshArrays& arrays);

/// A copy with all that the mesh has.
PolygonMesh copyOf(const MeshArrays& arrays);

}  // namespace abflat::python
