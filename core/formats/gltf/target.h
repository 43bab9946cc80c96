#pragma once

namespace abflat::gltf {

/// What a view is for: values of `bufferView.target`.
enum class Target { Other = 0, Vertices = 34962, Indices = 34963 };

}  // namespace abflat::gltf
