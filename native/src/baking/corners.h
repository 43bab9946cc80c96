#pragma once

#include <cstdint>
#include <vector>

#include "abflat/corner_frames.h"
#include "abflat/gltf_look.h"
#include "baking/new_layout.h"

namespace abflat::cli {

/// What bake needs of each corner of the mesh.
class Corners {
 public:
  Corners(const GltfLook& look, const NewLayout& layout);
  Corners(const Corners&) = delete;
  Corners& operator=(const Corners&) = delete;

  std::size_t faces() const { return frames_.faces(); }
  std::size_t materialOf(std::size_t face) const { return materials_[face]; }

  /// In the new layout, 2 numbers per corner.
  const std::vector<double>& uv() const { return uv_; }
  /// Those that a texture of each material is at; 0 without one.
  std::vector<double> oldUv(GltfTexture GltfMaterial::*texture) const;
  /// Of vertices, 4 linear numbers per corner; empty if none has any.
  std::vector<float> colours() const;
  const FrameMesh& frames() const { return frames_; }

 private:
  const GltfLook& look_;
  std::vector<bool> isTurned_;            ///< per face
  std::vector<std::uint32_t> materials_;  ///< per face
  std::vector<double> uv_;
  FrameMesh frames_;
};

}  // namespace abflat::cli
