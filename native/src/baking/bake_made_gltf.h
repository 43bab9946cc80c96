#pragma once

#include <string>
#include <vector>

#include "baking/obj_baker.h"

namespace abflat::cli {

/// Gives a glTF that is made from an OBJ the look of the OBJ in images for another layout: base
/// colour with opacity and with the colours of vertices, metals with roughness, normals and
/// emission. `notes` says what a glTF has no place for.
Status bakeMadeGltf(const OldObj& old, ObjBaker& baker, ImageFormat format, Appearance& look,
                    BakingReport& report, std::vector<std::string>& notes);

}  // namespace abflat::cli
