#pragma once

#include "gltf/decoded_views.h"
#include "gltf/document.h"

namespace abflat::gltf {

/// Decodes the primitives that are compressed by KHR_draco_mesh_compression. Returns whether there
/// were any.
bool decompressPrimitives(Document& document, DecodedViews& views, Complaints& complaints);

}  // namespace abflat::gltf
