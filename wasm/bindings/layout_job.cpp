#include "layout_job.h"

#include <string_view>

namespace abflat::bindings {
namespace {

/// The bit of a format.
constexpr WantedFiles fileOf(MeshFormat format) { return 1u << static_cast<int>(format); }

constexpr WantedFiles filesOfSinglePrecision() {
  WantedFiles out = 0;
  for (int i = 0; i < kWrittenFormatCount; ++i)
    if (precisionOf(static_cast<MeshFormat>(i)) == Precision::Single) out |= 1u << i;
  return out;
}

}  // namespace

bool wantsSingle(WantedFiles wanted) { return (wanted & filesOfSinglePrecision()) != 0; }

void choosePrecision(Precision& precision, WantedFiles wanted) {
  if (precision != Precision::Gltf)
    precision = wanted == 0 || wantsSingle(wanted) ? Precision::Single : Precision::Double;
}

void writeFiles(InputJob& job, WantedFiles wanted, const std::vector<double>& uv,
                const std::vector<std::uint32_t>& cornerUv,
                const std::vector<std::uint32_t>& turned) {
  for (int i = 0; i < kWrittenFormatCount; ++i) {
    const auto format = static_cast<MeshFormat>(i);
    if ((wanted & fileOf(format)) == 0) continue;
    const std::string_view source = format == job.format ? job.source : std::string_view();
    job.files[i] = writeMesh(format, job.mesh, uv, cornerUv, source, turned);
  }
}

void dropSource(InputJob& job, WantedFiles wanted) {
  if ((wanted & fileOf(job.format)) == 0) std::string().swap(job.source);
}

}  // namespace abflat::bindings
