#pragma once

#include <string>
#include <vector>

#include "abflat/generated/bake_options.h"
#include "abflat/generated/baking_report.h"
#include "abflat/gltf_look.h"
#include "baking/maps.h"
#include "baking/new_layout.h"
#include "baking/old_images.h"

namespace abflat::cli {

/// The look of a mesh before, complete with its images.
struct OldLook {
  GltfLook look;
  OldImages images;
};

/// A map of all materials in the new layout.
struct BakedMap {
  MapPlan plan;
  images::Image image;
};

struct BakedMaps {
  std::vector<BakedMap> maps;
  double emissiveStrength = 1;  ///< as in MapPlans
};

/// Metals with roughness and occlusion have one size.
Result<BakedMaps> bakeMaps(OldLook& old, const NewLayout& layout, const BakeOptionValues& options);

/// The file of a new image, named after its map, and its entry in a report.
Result<ImageFile> writeMap(const BakedMap& map, const BakeOptionValues& options,
                           BakingReport& report, std::vector<std::string>& notes);

/// What there was before. `hasNone`: there are no new images.
void noteOld(const OldLook& old, bool hasNone, BakingReport& report,
             std::vector<std::string>& notes);

}  // namespace abflat::cli
