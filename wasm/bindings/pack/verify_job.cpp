#include "verify_job.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace abflat::bindings {
namespace {

/// The face of each triangle. Triangles are in the order of their faces.
std::vector<std::uint32_t> facesOf(const std::vector<std::uint32_t>& triangleCorners,
                                   const std::vector<std::uint32_t>& faceOffsets) {
  std::vector<std::uint32_t> out(triangleCorners.size() / 3);
  std::uint32_t face = 0;
  for (std::size_t t = 0; t < out.size(); ++t) {
    while (triangleCorners[3 * t] >= faceOffsets[face + 1]) ++face;
    out[t] = face;
  }
  return out;
}

/// The mesh has these texcoords and no others; corners with NaN have none.
Status takeTexcoords(PolygonMesh& mesh, const std::vector<double>& triangleUv) {
  const std::size_t corners = mesh.faceVertices.size();
  mesh.texcoords.assign(2 * corners, std::numeric_limits<double>::quiet_NaN());
  mesh.faceTexcoords.resize(corners);
  std::iota(mesh.faceTexcoords.begin(), mesh.faceTexcoords.end(), 0u);
  return replaceTexcoords(mesh, triangleUv);
}

Status readLayout(Job& job) {
  if (Status s = readInput(job); !s.ok()) return s;
  std::string().swap(job.source);
  return job.triangleUv.empty() ? Status{} : takeTexcoords(job.mesh, job.triangleUv);
}

}  // namespace

Status verifyJob(Job& job, const ProgressCallback& progress) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point started = Clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(Clock::now() - started).count();
  };
  progress({Stage::Read, 0, 0, 0});
  if (Status s = readLayout(job); !s.ok()) return s;
  const double read = seconds();
  job.verifyOptions.progress = progress;
  Result<VerifyResult> verified = verifyLayout(job.mesh, job.verifyOptions);
  if (!verified.ok()) return verified.status();
  VerifyResult& result = verified.value();
  job.layout.faces = facesOf(result.triangleCorners, job.mesh.faceOffsets);
  job.layout.islandOfFace = std::move(result.islandOfFace);
  job.layout.faults = std::move(result.faults);
  result.report.path = job.name;
  result.report.timings.read = read;
  result.report.timings.total = seconds();
  job.text = verifyReportJson(result.report);
  progress({Stage::Check, 0, 0, 1});
  return {};
}

}  // namespace abflat::bindings
