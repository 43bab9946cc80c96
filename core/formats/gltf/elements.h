#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gltf/document.h"

namespace abflat::gltf {

/// Bytes of all elements of an accessor, tightly packed, with sparse elements in place.
std::string elementsOf(const Document& document, const Accessor& accessor);

/// All components as numbers; integers are scaled if they are normalized.
std::vector<double> numbersOf(const Document& document, const Accessor& accessor);

/// First components of an unsigned type, unscaled.
std::vector<std::uint32_t> integersOf(const Document& document, const Accessor& accessor);

/// Indices of the elements that a sparse accessor replaces.
std::vector<std::uint32_t> sparseIndices(const Document& document, const SparseElements& sparse);

/// Whether sparse indices ascend and are within the accessor, which all other functions expect.
bool hasSparseOrder(const Document& document, const Accessor& accessor);

}  // namespace abflat::gltf
