#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "abflat/progress.h"

namespace abflat::python {

/// Passes the progress of a run, which does not hold the GIL, on to Python. An exception there,
/// also of a signal handler such as that of Ctrl+C, cancels the run; rethrow() raises it
/// afterwards, since it must not pass through the threads of the library.
class ProgressRelay {
 public:
  explicit ProgressRelay(pybind11::object callback) : callback_(std::move(callback)) {}

  /// What the options of a run take. It refers to this object.
  ProgressCallback callback();

  /// Needs the GIL.
  void rethrow();

 private:
  bool isDue(const Progress& now);
  bool tell(const Progress& now);

  pybind11::object callback_;
  std::exception_ptr error_;
  std::optional<Stage> stage_;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace abflat::python
