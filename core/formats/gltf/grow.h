#pragma once

#include <cstdint>
#include <vector>

#include "gltf/edit.h"

namespace abflat::gltf {

/// The accessor with further elements after its own, which repeat the bytes of the elements in
/// `copied`. Its views are added to `edit`; sparse ones stay sparse.
Json grownAccessor(const Document& document, std::size_t accessor,
                   const std::vector<std::uint32_t>& copied, Edit& edit);

/// An accessor of unsigned numbers, of `type` or the next wider one that holds them all.
Json indexAccessor(Json base, const std::vector<std::uint32_t>& indices, ComponentType type,
                   Edit& edit);

/// An accessor of two floats per element.
Json texcoordAccessor(Json base, const std::vector<float>& uv, Edit& edit);

}  // namespace abflat::gltf
