#include "extras.h"

#include <string>

namespace py = pybind11;

namespace abflat::python {

std::vector<Pin> pinsFrom(const py::dict& extras) {
  const std::vector<double> rows = arrayFrom<double>(extras, "pins");
  std::vector<Pin> pins;
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3)
    pins.push_back({static_cast<std::uint32_t>(rows[i]), {rows[i + 1], rows[i + 2]}, kAnyFace});
  return pins;
}

Precision precisionFrom(const py::dict& extras) {
  const bool isSingle =
      extras.contains("precision") && extras["precision"].cast<std::string>() == "single";
  return isSingle ? Precision::Single : Precision::Double;
}

}  // namespace abflat::python
