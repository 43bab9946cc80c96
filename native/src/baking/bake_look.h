#pragma once

#include <string>
#include <vector>

#include "baking/bake_maps.h"

namespace abflat::cli {

/// Errors: those of readGltfLook and readImage.
Result<OldLook> readOldLook(const gltf::Source& source, const ReadResource& readResource);

struct NewLook {
  GltfBaked baked;
  BakingReport report;
  std::vector<std::string> notes;
};

/// The same look in images for another layout.
Result<NewLook> bakeLook(OldLook& old, const NewLayout& layout, const BakeOptionValues& options);

}  // namespace abflat::cli
