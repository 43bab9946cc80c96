#pragma once

#include <string_view>

#include "abflat/mesh.h"
#include "baking/obj_plans.h"

namespace abflat::cli {

/// The materials of an OBJ or a PLY, and what becomes of their images.
struct OldObj {
  ObjMaps maps;
  OldImages images;
  ObjPlans plans;
};

/// Errors: OutOfMemory, and too many pixels in all. Images that cannot be used are left out, and
/// `notes` of the maps say so.
Result<OldObj> readOldObj(std::string_view bytes, const PolygonMesh& mesh,
                          const ReadResource& readResource);

/// The same of the image that a PLY may name, as if it were the colour of a material. Colours of
/// its vertices are not in it.
Result<OldObj> readOldPly(std::string_view bytes, const PolygonMesh& mesh,
                          const ReadResource& readResource);

}  // namespace abflat::cli
