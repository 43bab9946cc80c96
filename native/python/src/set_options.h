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

/// The number or text that a Python object stands for, read as option `index`. False if it is
/// neither, or no value of the option.
template <class Options>
bool setFrom(Options& options, int index, const pybind11::handle& value) {
  const OptionInfo& info = optionInfos(options)[index];
  if (pybind11::isinstance<pybind11::str>(value)) {
    double number = 0;
    bool isWord = false;
    return !info.isSwitch &&
           readOption(options, index, value.cast<std::string>(), number, isWord) &&
           setOption(options, index, number, isWord);
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
