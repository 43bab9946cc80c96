#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "abflat/option_text.h"
#include "errors.h"

namespace abflat::python {

/// "max_stretch" for maxStretch.
std::string pythonName(const OptionInfo& info);

/// What is wrong with a value that setFrom() refuses.
Status notAValue(const OptionInfo& info, const pybind11::handle& value);

template <class Options>
bool setFromText(Options& options, int index, const std::string& text) {
  double number = 0;
  bool isWord = false;
  return readOption(options, index, text, number, isWord) &&
         setOption(options, index, number, isWord);
}

/// A width and a height, as on the command line.
inline std::string pairText(const pybind11::sequence& sides) {
  return std::string(pybind11::str(sides[0])) + "x" + std::string(pybind11::str(sides[1]));
}

/// The number, text or pair that a Python object stands for, read as option `index`. False if it is
/// none of these, or no value of the option.
template <class Options>
bool setFrom(Options& options, int index, const pybind11::handle& value) {
  const OptionInfo& info = optionInfos(options)[index];
  if (pybind11::isinstance<pybind11::str>(value))
    return !info.isSwitch && setFromText(options, index, value.cast<std::string>());
  if (pybind11::isinstance<pybind11::tuple>(value) || pybind11::isinstance<pybind11::list>(value)) {
    const auto sides = pybind11::reinterpret_borrow<pybind11::sequence>(value);
    return sides.size() == 2 && setFromText(options, index, pairText(sides));
  }
  const bool isBool = pybind11::isinstance<pybind11::bool_>(value);
  if (isBool != info.isSwitch || info.isChoice) return false;
  if (!isBool && !PyNumber_Check(value.ptr())) return false;
  return setOption(options, index, value.cast<double>(), false);
}

/// Sets options from a dictionary whose names the Python side has checked.
template <class Options>
void setOptions(Options& options, const pybind11::dict& values) {
  const OptionInfos infos = optionInfos(options);
  for (const auto& [key, value] : values) {
    const std::string name = pybind11::str(key);
    for (int i = 0; i < infos.count; ++i)
      if (name == pythonName(infos[i]) && !setFrom(options, i, value))
        throwStatus(notAValue(infos[i], value));
  }
}

}  // namespace abflat::python
