#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

namespace abflat::python {

/// The vector as an array that owns it, without a copy; with `columns`, as rows of that many.
template <class T>
pybind11::array_t<T> arrayOf(std::vector<T> values, std::size_t columns = 0) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  const T* const data = owned->data();
  const std::size_t count = owned->size();
  const pybind11::capsule owner(owned.release(),
                                [](void* p) { delete static_cast<std::vector<T>*>(p); });
  std::vector<std::size_t> shape{count};
  if (columns > 0) shape = {count / columns, columns};
  return pybind11::array_t<T>(shape, data, owner);
}

}  // namespace abflat::python
