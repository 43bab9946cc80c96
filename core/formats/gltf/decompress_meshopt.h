#pragma once

#include "gltf/decoded_views.h"
#include "gltf/document.h"

namespace abflat::gltf {

/// Decodes the views that are compressed by EXT_meshopt_compression or KHR_meshopt_compression.
/// Returns whether there were any.
bool decompressViews(Document& document, DecodedViews& views, Complaints& complaints);

}  // namespace abflat::gltf
