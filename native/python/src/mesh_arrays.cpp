#include "mesh_arrays.h"

#include <cstdint>
#include <vector>

namespace py = pybind11;

namespace abflat::python {
namespace {

template <class T>
const T* dataOf(const py::array& array) {
  return static_cast<const T*>(array.data());
}

PointView pointsOf(const py::array& a) {
  const auto count = static_cast<std::size_t>(a.shape(0));
  const auto stride = static_cast<std::size_t>(a.strides(0));
  return a.itemsize() == 4 ? PointView(dataOf<float>(a), count, stride)
                           : PointView(dataOf<double>(a), count, stride);
}

TriangleView trianglesOf(const py::array& a) {
  const auto count = static_cast<std::size_t>(a.shape(0));
  const auto stride = static_cast<std::size_t>(a.strides(0));
  switch (a.itemsize()) {
    case 2:
      return {dataOf<std::uint16_t>(a), count, stride};
    case 4:
      return {dataOf<std::uint32_t>(a), count, stride};
    default:
      return {dataOf<std::uint64_t>(a), count, stride};
  }
}

template <class T>
std::vector<T> listOf(const py::object& values) {
  if (values.is_none()) return {};
  const auto array = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(values);
  if (!array) throw py::error_already_set();
  return {array.data(), array.data() + array.size()};
}

std::vector<std::uint32_t> offsetsOf(const MeshArrays& arrays) {
  if (!arrays.offsets.is_none()) return listOf<std::uint32_t>(arrays.offsets);
  std::vector<std::uint32_t> offsets;
  for (py::ssize_t corner = 0; corner <= arrays.vertices.size(); corner += 3)
    offsets.push_back(static_cast<std::uint32_t>(corner));
  return offsets;
}

}  // namespace

MeshView viewOf(const MeshArrays& arrays) {
  return {pointsOf(arrays.positions), trianglesOf(arrays.vertices)};
}

PolygonMesh copyOf(const MeshArrays& arrays) {
  PolygonMesh mesh;
  mesh.positions = listOf<double>(arrays.positions);
  mesh.faceVertices = listOf<std::uint32_t>(arrays.vertices);
  mesh.faceOffsets = offsetsOf(arrays);
  mesh.texcoords = listOf<double>(arrays.texcoords);
  mesh.faceTexcoords = listOf<std::uint32_t>(arrays.texcoordOfCorner);
  mesh.faceMaterials = listOf<std::uint32_t>(arrays.materialOfFace);
  mesh.vertexObjects = listOf<std::uint32_t>(arrays.objectOfVertex);
  return mesh;
}

}  // namespace abflat::python
