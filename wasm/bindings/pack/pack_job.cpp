#include "pack_job.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace abflat::bindings {

Status packJob(Job& job, WantedFiles wanted, const ProgressCallback& progress) {
  job.packOptions.progress = progress;
  choosePrecision(job.packOptions.precision, wanted);
  const auto compute = [&]() -> Result<PackLayoutResult> {
    if (!job.triangleUv.empty())
      if (Status s = replaceTexcoords(job.mesh, job.triangleUv); !s.ok()) return s;
    return packLayout(job.mesh, job.packOptions);
  };
  const auto turned = [](const PackLayoutResult&) { return std::vector<std::uint32_t>(); };
  const auto arrays = [&](PackLayoutResult& packed) {
    PackedVertices vertices = packedVertices(job.mesh, packed);
    job.layout.uv = std::move(vertices.uv);
    job.layout.triangles = std::move(vertices.triangles);
    job.layout.vertexMap = std::move(vertices.vertexMap);
    job.layout.chartOfTriangle = std::move(vertices.islandOfTriangle);
    job.layout.faults = std::move(packed.faults);
  };
  return layoutJob(job, wanted, progress, compute, turned, arrays, packReportJson);
}

}  // namespace abflat::bindings
