#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "abflat/status.h"
#include "gltf/budget.h"
#include "gltf/element_shape.h"

namespace draco {
class Mesh;
}

namespace abflat::gltf {

/// A mesh decoded by Draco.
class DracoMesh {
 public:
  /// `budget` is asked for about as many bytes as the mesh takes, before any are allocated. Errors:
  /// ParseError, worded to follow the name of the place.
  static Result<DracoMesh> decode(std::string_view bytes, Budget& budget);

  std::size_t points() const;

  /// Three points per triangle.
  std::vector<std::uint32_t> indices() const;

  /// Values of the attribute `id` by point, as `components` components of `type`, each value
  /// starting at a multiple of 4 bytes. Errors: as above.
  Result<std::string> attribute(std::uint32_t id, ComponentType type, std::size_t components) const;

  DracoMesh() = default;

 private:
  explicit DracoMesh(std::shared_ptr<const draco::Mesh> mesh) : mesh_(std::move(mesh)) {}

  std::shared_ptr<const draco::Mesh> mesh_;
};

}  // namespace abflat::gltf
