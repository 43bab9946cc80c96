#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "errors.h"
#include "mesh_arrays.h"
#include "progress_relay.h"

namespace abflat::python {

/// Calls `work(options)` without the GIL, with a progress callback in place, and returns its value
/// or raises what went wrong.
template <class Options, class Work>
auto runWith(Options options, pybind11::object progress, const Work& work) {
  ProgressRelay relay(std::move(progress));
  options.progress = relay.callback();
  auto result = [&] {
    const pybind11::gil_scoped_release noGil;
    return work(std::as_const(options));
  }();
  relay.rethrow();
  return valueOf(std::move(result));
}

/// The same for `work(mesh, options)`, which takes bare triangles where they are, and a copy of any
/// other mesh.
template <class Options, class Work>
auto runOn(const MeshArrays& arrays, Options options, pybind11::object progress, const Work& work) {
  const auto runMesh = [&](const auto& mesh) {
    return runWith(std::move(options), std::move(progress),
                   [&](const Options& ready) { return work(mesh, ready); });
  };
  return arrays.isBare() ? runMesh(viewOf(arrays)) : runMesh(copyOf(arrays));
}

}  // namespace abflat::python
