#pragma once

namespace abflat::gltf {

/// An extension of primitives.
constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";

}  // namespace abflat::gltf
