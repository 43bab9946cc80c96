#pragma once

#include <string>
#include <vector>

#include "baking/obj_baker.h"

namespace abflat::cli {

/// The look of an OBJ in images for another layout, as files beside it.
struct NewObj {
  std::vector<ImageFile> images;
  std::string mtl;
  BakingReport report;
  std::vector<std::string> notes;
};

/// `stem` begins the names of the images.
Result<NewObj> bakeObj(OldObj& old, ObjBaker& baker, const std::string& stem, ImageFormat format);

/// Name of the file of a new image.
std::string objImageName(const std::string& stem, const ObjPlan& plan, ImageFormat format);

}  // namespace abflat::cli
