#pragma once

#include <string>
#include <vector>

#include "abflat/made_obj.h"
#include "baking/bake_maps.h"

namespace abflat::cli {

/// The look of a glTF as an OBJ has it, in images for another layout.
struct LookOfObj {
  std::vector<ImageFile> images;  ///< named as their files
  std::vector<MadeMaterial> materials;
  BakingReport report;
  std::vector<std::string> notes;
};

/// `stem` begins the names of the images; `names` are those of materials, where they have any.
Result<LookOfObj> bakeLookOfObj(OldLook& old, const NewLayout& layout,
                                const BakeOptionValues& options, const std::string& stem,
                                const std::vector<std::string>& names);

/// Names of all images that there may be.
std::vector<std::string> lookOfObjNames(const std::string& stem, ImageFormat format);

}  // namespace abflat::cli
