// _abflat: the library for the Python package, which checks arguments before it calls.

#include "abflat/version.h"
#include "calls.h"

namespace py = pybind11;
using abflat::python::MeshArrays;

PYBIND11_MODULE(_abflat, m) {
  m.attr("__version__") = ABFLAT_VERSION;
  py::class_<MeshArrays>(m, "MeshArrays")
      .def(py::init([](py::array positions, py::array vertices, py::object offsets,
                       py::object texcoords, py::object texcoordOfCorner, py::object materials,
                       py::object objects) {
        return MeshArrays{std::move(positions), std::move(vertices),         std::move(offsets),
                          std::move(texcoords), std::move(texcoordOfCorner), std::move(materials),
                          std::move(objects)};
      }));
  m.def("unwrap", abflat::python::unwrapArrays);
  m.def("flatten", abflat::python::flattenArrays);
  m.def("pack", abflat::python::packArrays);
  m.def("verify", abflat::python::verifyArrays);
}
