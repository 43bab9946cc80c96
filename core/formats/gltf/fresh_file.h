#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "abflat/status.h"
#include "gltf/json.h"

namespace abflat::gltf {

/// A file made from scratch: a buffer and the lists that describe it. All functions return the
/// index of what they add.
class FreshFile {
 public:
  FreshFile();

  /// For "VEC2", "VEC3" and so on, which have this many components.
  std::size_t addFloats(const std::vector<float>& values, const char* type, std::size_t components);
  /// In units of 1/65535.
  std::size_t addColors(const std::vector<std::uint16_t>& rgba);
  /// With the bounding box that positions must have.
  std::size_t addPositions(const std::vector<float>& xyz);
  /// In the narrowest type that the number of vertices allows.
  std::size_t addIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices);
  /// A texture that uses an image in the file.
  std::size_t addTexture(const std::string& name, const std::string& mimeType,
                         const std::string& bytes);
  std::size_t addMaterial(Json material);

  /// A mesh in a node of its own, which moves it. Primitives are added to the last mesh.
  void addMesh(const std::string& name, const std::array<double, 3>& translation);
  void addPrimitive(Json primitive);

  /// Errors: CannotWrite (a .glb of 4 GB).
  Result<std::string> finish(bool isBinary);

 private:
  std::size_t addView(const void* bytes, std::size_t size);
  std::size_t addAccessor(const void* values, std::size_t size, int target, Json accessor);

  Json json_;
  std::string buffer_;
};

}  // namespace abflat::gltf
