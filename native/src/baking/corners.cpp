#include "baking/corners.h"

namespace abflat::cli {

Corners::Corners(const GltfLook& look, const NewLayout& layout)
    : look_(look),
      isTurned_(look.corners.size() / 3),
      materials_(look.corners.size() / 3),
      frames_{look.corners, isTurned_, look.positions, look.normals, look.tangents, {}} {
  for (const std::uint32_t face : layout.turnedFaces) isTurned_[face] = true;
  for (const GltfPart& part : look.parts) {
    frames_.parts.push_back({part.firstFace, part.faceCount, part.isMirrored, part.hasTangents});
    for (std::size_t f = part.firstFace; f < std::size_t{part.firstFace} + part.faceCount; ++f)
      materials_[f] = static_cast<std::uint32_t>(part.material);
  }
  uv_.reserve(2 * look.corners.size());
  for (std::size_t c = 0; c < look.corners.size(); ++c) {
    const std::uint32_t i = layout.ofCorner[c];
    const bool isMapped = i != kNoTexcoord;
    // As they are written.
    uv_.push_back(isMapped ? static_cast<float>(layout.uv[2 * std::size_t{i}]) : 0);
    uv_.push_back(isMapped ? static_cast<float>(1 - layout.uv[2 * std::size_t{i} + 1]) : 0);
  }
}

std::vector<float> Corners::colours() const {
  std::vector<float> out;
  if (look_.colours.empty()) return out;
  out.reserve(4 * look_.corners.size());
  for (std::size_t f = 0; f < faces(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const float* const colour = &look_.colours[4 * std::size_t{frames_.vertex(f, k)}];
      out.insert(out.end(), colour, colour + 4);
    }
  return out;
}

std::vector<double> Corners::oldUv(GltfTexture GltfMaterial::*texture) const {
  std::vector<double> out(2 * look_.corners.size());
  for (std::size_t f = 0; f < faces(); ++f) {
    const GltfTexture& use = look_.materials[materials_[f]].*texture;
    if (use.image == kNoImage) continue;
    const std::vector<double>& set = look_.texcoords[use.texcoord];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 2; ++d)
        out[2 * (3 * f + k) + d] = set[2 * std::size_t{frames_.vertex(f, k)} + d];
  }
  return out;
}

}  // namespace abflat::cli
