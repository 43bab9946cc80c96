#include "errors.h"

namespace py = pybind11;

namespace abflat::python {

void throwStatus(const Status& status) {
  const py::object type = py::module_::import("abflat._errors").attr("AbflatError");
  const py::object error = type(statusName(status.code), status.message);
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace abflat::python
