#pragma once

#include "gltf/document.h"

namespace abflat::gltf {

/// Recomputes the `min` and `max` of accessors of decoded views: lossy compression keeps those of
/// the original values.
void refreshBoxes(Document& document, Complaints& complaints);

}  // namespace abflat::gltf
