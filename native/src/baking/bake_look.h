#pragma once

#include <string>
#include <vector>

#include "abflat/generated/bake_options.h"
#include "abflat/generated/baking_report.h"
#include "abflat/gltf_look.h"
#include "baking/new_layout.h"
#include "baking/old_images.h"

namespace abflat::cli {

/// The look of a mesh before, complete with its images.
struct OldLook {
  GltfLook look;
  OldImages images;
};

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
