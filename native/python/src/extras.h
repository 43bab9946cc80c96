#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <vector>

#include "abflat/generated/mesh_format.h"
#include "abflat/pins.h"

namespace abflat::python {

/// An argument that may be missing: the array as T, row by row; empty if there is none.
template <class T>
std::vector<T> arrayFrom(const pybind11::dict& extras, const char* name) {
  if (!extras.contains(name)) return {};
  const auto array =
      pybind11::array_t<T, pybind11::array::c_style | pybind11::array::forcecast>::ensure(
          extras[name]);
  if (!array) throw pybind11::error_already_set();
  return {array.data(), array.data() + array.size()};
}

/// "pins": rows of vertex, u and v.
std::vector<Pin> pinsFrom(const pybind11::dict& extras);

/// "precision": "single", or else doubles.
Precision precisionFrom(const pybind11::dict& extras);

}  // namespace abflat::python
