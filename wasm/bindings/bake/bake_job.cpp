#include "bake/bake_job.h"

#include <utility>

#include "bake/bake_corners.h"

namespace abflat::bindings {
namespace {

std::array<double, 4> backgroundOf(const BakeJob& job) {
  switch (job.kind) {
    case ImageKind::Colour:
      return {0, 0, 0, job.isOpaque ? 1.0 : 0.0};
    case ImageKind::Data:
      return {1, 1, 1, 1};
    case ImageKind::Normal:
      return {0.5, 0.5, 1, 1};
  }
  return {};
}

std::string countedSources(std::size_t count) {
  return count == 1 ? "is only 1 source" : "are only " + std::to_string(count) + " sources";
}

BakeOptions optionsOf(const BakeJob& job) {
  BakeOptions out;
  out.kind = job.kind == ImageKind::Normal ? MapKind::Normal : MapKind::Colour;
  out.space = job.kind == ImageKind::Colour ? ColourSpace::Srgb : ColourSpace::Linear;
  out.width = static_cast<std::uint32_t>(job.size.width);
  out.height = static_cast<std::uint32_t>(job.size.height);
  out.background = backgroundOf(job);
  out.padding = bakePadding(job.padding, job.size, job.layoutResolution);
  return out;
}

}  // namespace

Status bakeJob(BakeJob& job, const ProgressCallback& progress) {
  progress({Stage::Read, 0, 0, 0});
  std::vector<bool> isTurned;
  if (Status s = matchCorners(job, isTurned); !s.ok()) return s;
  BakeInput input{trianglesOf(job), std::move(job.materials), std::move(job.textures)};
  for (std::size_t f = 0; f < input.triangles.materials.size(); ++f)
    if (const std::uint32_t source = input.triangles.materials[f]; source >= input.materials.size())
      return {StatusCode::InvalidMesh, "triangle " + std::to_string(f) + " uses source " +
                                           std::to_string(source) + ", but there " +
                                           countedSources(input.materials.size())};
  job.size = bakeSize(input, job.resolution, job.layoutResolution);
  if (job.kind == ImageKind::Normal)
    if (Status s = addFrames(job, isTurned, input.triangles); !s.ok()) return s;
  const BakeOptions options = optionsOf(job);
  job.pixels.reserve(4 * std::size_t{options.width} * options.height);
  return bake(input, options,
              [&](std::uint32_t first, std::uint32_t rows, const std::vector<std::uint8_t>& bytes) {
                job.pixels.insert(job.pixels.end(), bytes.begin(), bytes.end());
                return progress({Stage::Write, 0, 0, double(first + rows) / options.height});
              });
}

}  // namespace abflat::bindings
