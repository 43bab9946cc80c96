#include "abflat/pack_layout.h"
#include "calls.h"
#include "extras.h"
#include "result_arrays.h"
#include "run.h"
#include "set_options.h"

namespace py = pybind11;

namespace abflat::python {
namespace {

PackLayoutOptions packOptionsFrom(const py::dict& values, const py::dict& extras) {
  PackLayoutOptions options;
  setOptions(options, values);
  options.precision = precisionFrom(extras);
  return options;
}

}  // namespace

py::dict packArrays(const MeshArrays& arrays, const py::dict& options, const py::dict& extras,
                    py::object progress) {
  const PolygonMesh mesh = copyOf(arrays);
  const PackLayoutResult r =
      runWith(packOptionsFrom(options, extras), std::move(progress),
              [&](const PackLayoutOptions& ready) { return packLayout(mesh, ready); });
  PackedVertices vertices = packedVertices(mesh, r);
  py::dict out;
  out["uv"] = arrayOf(std::move(vertices.uv), 2);
  out["vertex_map"] = arrayOf(std::move(vertices.vertexMap));
  out["triangles"] = arrayOf(std::move(vertices.triangles), 3);
  out["island_of_triangle"] = arrayOf(std::move(vertices.islandOfTriangle));
  out["report"] = packReportJson(r.report);
  return out;
}

}  // namespace abflat::python
