#include <string>

#include "abflat/unwrap.h"
#include "calls.h"
#include "extras.h"
#include "result_arrays.h"
#include "run.h"
#include "set_options.h"

namespace py = pybind11;

namespace abflat::python {
namespace {

UnwrapOptions unwrapOptionsFrom(const py::dict& values, const py::dict& extras) {
  UnwrapOptions options;
  setOptions(options, values);
  if (extras.contains("seams"))
    options.seams = valueOf(parseSeams(extras["seams"].cast<std::string>()));
  const auto edges = arrayFrom<std::uint32_t>(extras, "seam_edges");
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
    options.seams.edges.push_back({edges[i], edges[i + 1]});
  options.faceDensities = arrayFrom<double>(extras, "face_densities");
  options.pins = pinsFrom(extras);
  options.precision = precisionFrom(extras);
  return options;
}

std::vector<double> uvPerVertex(const UnwrapResult& result) {
  std::vector<double> uv;
  uv.reserve(2 * result.vertexUv.size());
  for (const std::size_t i : result.vertexUv)
    uv.insert(uv.end(), {result.uv[2 * i], result.uv[2 * i + 1]});
  return uv;
}

std::vector<std::uint32_t> flatEdges(const std::vector<EdgeVertices>& edges) {
  std::vector<std::uint32_t> flat;
  for (const EdgeVertices& edge : edges) flat.insert(flat.end(), edge.begin(), edge.end());
  return flat;
}

}  // namespace

py::dict unwrapArrays(const MeshArrays& mesh, const py::dict& options, const py::dict& extras,
                      py::object progress) {
  UnwrapResult r =
      runOn(mesh, unwrapOptionsFrom(options, extras), std::move(progress),
            [](const auto& input, const UnwrapOptions& ready) { return unwrap(input, ready); });
  py::dict out;
  out["uv"] = arrayOf(uvPerVertex(r), 2);
  out["vertex_map"] = arrayOf(std::move(r.vertexMap));
  out["triangles"] = arrayOf(std::move(r.triangles), 3);
  out["corner_vertex"] = arrayOf(std::move(r.cornerVertex));
  out["chart_of_triangle"] = arrayOf(std::move(r.chartOfTriangle));
  out["chart_of_face"] = arrayOf(std::move(r.chartOfFace));
  out["seams"] = arrayOf(flatEdges(r.seams), 2);
  out["report"] = unwrapReportJson(r.report);
  return out;
}

}  // namespace abflat::python
