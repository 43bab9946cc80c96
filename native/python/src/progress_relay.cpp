#include "progress_relay.h"

#include <utility>

namespace py = pybind11;

namespace abflat::python {
namespace {

/// Often enough for Ctrl+C and progress bars, rarely enough to leave other threads alone.
constexpr std::chrono::milliseconds kInterval{20};

}  // namespace

ProgressCallback ProgressRelay::callback() {
  return [this](const Progress& now) { return !isDue(now) || tell(now); };
}

bool ProgressRelay::isDue(const Progress& now) {
  const auto time = std::chrono::steady_clock::now();
  if (stage_ == now.stage && time < next_) return false;
  stage_ = now.stage;
  next_ = time + kInterval;
  return true;
}

bool ProgressRelay::tell(const Progress& now) {
  const py::gil_scoped_acquire gil;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callback_.is_none()) callback_(nameOf(now), now.fraction);
    return true;
  } catch (const py::error_already_set&) {
    error_ = std::current_exception();
    return false;
  }
}

void ProgressRelay::rethrow() {
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

}  // namespace abflat::python
