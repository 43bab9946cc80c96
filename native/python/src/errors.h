#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "abflat/status.h"

namespace abflat::python {

/// Raises an abflat.AbflatError with the code and message of a status. Needs the GIL.
[[noreturn]] void throwStatus(const Status& status);

template <class T>
T valueOf(Result<T> result) {
  if (!result.ok()) throwStatus(result.status());
  return std::move(result).value();
}

}  // namespace abflat::python
