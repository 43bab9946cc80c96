#include <cstddef>
#include <cstdint>
#include <vector>

#include "abflat/verify.h"
#include "calls.h"
#include "result_arrays.h"
#include "run.h"
#include "set_options.h"

namespace py = pybind11;

namespace abflat::python {
namespace {

/// The face of each triangle. Triangles are in the order of their faces.
std::vector<std::uint32_t> faceOfTriangles(const VerifyResult& result, const PolygonMesh& mesh) {
  std::vector<std::uint32_t> out(result.triangleCorners.size() / 3);
  std::uint32_t face = 0;
  for (std::size_t t = 0; t < out.size(); ++t) {
    while (result.triangleCorners[3 * t] >= mesh.faceOffsets[face + 1]) ++face;
    out[t] = face;
  }
  return out;
}

}  // namespace

py::dict verifyArrays(const MeshArrays& arrays, const py::dict& options, py::object progress) {
  const PolygonMesh mesh = copyOf(arrays);
  VerifyOptions wanted;
  setOptions(wanted, options);
  VerifyResult r = runWith(std::move(wanted), std::move(progress),
                           [&](const VerifyOptions& ready) { return verifyLayout(mesh, ready); });
  py::dict out;
  out["face_of_triangle"] = arrayOf(faceOfTriangles(r, mesh));
  out["island_of_face"] = arrayOf(std::move(r.islandOfFace));
  out["faults"] = arrayOf(std::move(r.faults));
  out["report"] = verifyReportJson(r.report);
  return out;
}

}  // namespace abflat::python
