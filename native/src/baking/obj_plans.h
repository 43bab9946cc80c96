#pragma once

#include <optional>
#include <string>
#include <vector>

#include "abflat/bake.h"
#include "abflat/obj_maps.h"
#include "baking/old_images.h"

namespace abflat::cli {

/// How a map of an OBJ uses one of the old images.
struct ObjUse {
  std::size_t image = 0;  ///< in OldImages
  std::array<double, 2> scale = {1, 1}, offset = {0, 0};
  bool isClamped = false;

  bool operator==(const ObjUse& o) const {
    return image == o.image && scale == o.scale && offset == o.offset && isClamped == o.isClamped;
  }
};

/// A new image, and the maps that it takes the place of.
struct ObjPlan {
  std::string name;
  MapKind kind = MapKind::Colour;
  ColourSpace space = ColourSpace::Linear;
  int channels = 3, bits = 8;
  std::vector<std::optional<ObjUse>> uses;  ///< by material
  bool hasVertexColours = false;            ///< they multiply it
};

struct ObjPlans {
  std::vector<ObjPlan> plans;
  /// Plan of each map of each material; kNoPlan: there is no image to bake.
  std::vector<std::vector<std::size_t>> planOf;
};

constexpr std::size_t kNoPlan = static_cast<std::size_t>(-1);

/// What is known of an image once it has been read.
struct ImageTraits {
  int channels = 3;  ///< 1, 3, or 4 if alpha says anything
  int bits = 8;
  bool isNormalMap = false;  ///< by the look of its colours
};

ImageTraits traitsOf(const ImageView& image);

/// One image for all maps that mean the same, more where a material has several of them. `traits`
/// are those of the images of `maps`.
ObjPlans planObj(const ObjMaps& maps, const std::vector<ImageTraits>& traits);

}  // namespace abflat::cli
