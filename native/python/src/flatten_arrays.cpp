#include "abflat/flatten.h"
#include "calls.h"
#include "extras.h"
#include "result_arrays.h"
#include "run.h"
#include "set_options.h"

namespace py = pybind11;

namespace abflat::python {
namespace {

FlattenOptions flattenOptionsFrom(const py::dict& values, const py::dict& extras) {
  FlattenOptions options;
  setOptions(options, values);
  options.pins = pinsFrom(extras);
  const auto bounds = arrayFrom<double>(extras, "bounds");
  for (std::size_t i = 0; i + 1 < bounds.size(); i += 2)
    options.bounds.push_back({static_cast<std::uint32_t>(bounds[i]), bounds[i + 1]});
  const auto runs = arrayFrom<std::uint32_t>(extras, "straight");
  for (std::size_t i = 0; i + 1 < runs.size(); i += 2)
    options.straight.push_back({runs[i], runs[i + 1]});
  return options;
}

}  // namespace

py::dict flattenArrays(const MeshArrays& mesh, const py::dict& options, const py::dict& extras,
                       py::object progress) {
  FlattenResult r =
      runOn(mesh, flattenOptionsFrom(options, extras), std::move(progress),
            [](const auto& input, const FlattenOptions& ready) { return flatten(input, ready); });
  py::dict out;
  out["uv"] = arrayOf(std::move(r.uv), 2);
  out["vertex_map"] = arrayOf(std::move(r.vertexMap));
  out["triangles"] = arrayOf(std::move(r.triangles), 3);
  out["corner_vertex"] = arrayOf(std::move(r.cornerUv));
  out["report"] = reportJson(r.report);
  return out;
}

}  // namespace abflat::python
