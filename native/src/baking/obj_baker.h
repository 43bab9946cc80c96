#pragma once

#include <vector>

#include "abflat/generated/bake_options.h"
#include "abflat/generated/baking_report.h"
#include "baking/new_layout.h"
#include "baking/obj_corners.h"
#include "baking/old_obj.h"

namespace abflat::cli {

/// Makes new images from those of an OBJ, and from colours of vertices.
class ObjBaker {
 public:
  /// As for makeGltf; the mesh has turned faces already. `colours` are those of an Appearance.
  ObjBaker(OldObj& old, const PolygonMesh& mesh, const NewLayout& layout,
           const std::vector<std::uint32_t>& triangleCorners, const BakeOptionValues& options,
           const std::vector<double>& colours);

  AtlasSize sizeOf(const ObjPlan& plan) const;
  Result<images::Image> bake(const ObjPlan& plan, const AtlasSize& size, int bits);
  /// The file of a new image, and its entry in a report.
  Result<ImageFile> write(const images::Image& image, const ObjPlan& plan, ImageFormat format,
                          BakingReport& report) const;

 private:
  BakeInput inputOf(const ObjPlan& plan) const;
  Status addPixels(const ObjPlan& plan, BakeInput& input);

  OldObj& old_;
  const NewLayout& layout_;
  const BakeOptionValues& options_;
  const ObjCorners corners_;
  const std::vector<double>& colours_;
};

/// JPEG holds colours and greys alone; then `notes` says so.
ImageFormat formatFor(const ObjPlan& plan, ImageFormat wanted, std::vector<std::string>& notes);

}  // namespace abflat::cli
