#pragma once

#include <pybind11/pybind11.h>

#include "mesh_arrays.h"

namespace abflat::python {

/// Each takes options by their names in the schema, and the other arguments of the Python function
/// as `extras`; it returns the fields of the Python result.
pybind11::dict unwrapArrays(const MeshArrays& mesh, const pybind11::dict& options,
                            const pybind11::dict& extras, pybind11::object progress);
pybind11::dict flattenArrays(const MeshArrays& mesh, const pybind11::dict& options,
                             const pybind11::dict& extras, pybind11::object progress);
pybind11::dict packArrays(const MeshArrays& mesh, const pybind11::dict& options,
                          const pybind11::dict& extras, pybind11::object progress);
pybind11::dict verifyArrays(const MeshArrays& mesh, const pybind11::dict& options,
                            pybind11::object progress);

}  // namespace abflat::python
