#include "set_options.h"

#include <cctype>

namespace py = pybind11;

namespace abflat::python {

std::string pythonName(const OptionInfo& info) {
  std::string out;
  for (const char letter : std::string(info.name)) {
    const auto lower = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (lower != letter) out += '_';
    out += lower;
  }
  return out;
}

Status notAValue(const OptionInfo& info, const py::handle& value) {
  const std::string range = info.isSwitch ? "True or False" : info.range;
  const std::string given = py::str(py::repr(value));
  return {StatusCode::InvalidOption, pythonName(info) + " cannot be " + given + "; it is " + range};
}

}  // namespace abflat::python
