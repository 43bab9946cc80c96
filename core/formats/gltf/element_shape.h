#pragma once

#include <cstddef>

#include "gltf/field.h"

namespace abflat::gltf {

enum class ComponentType { Int8, Uint8, Int16, Uint16, Uint32, Float };

bool isUnsigned(ComponentType type);

/// In bytes.
std::size_t componentSize(ComponentType type);

/// The glTF code, 5120 to 5126.
int typeCode(ComponentType type);

ComponentType componentType(const Field& code);

/// Layout of elements in a view, one after another. Types of several columns (matrices) start each
/// column at a multiple of 4 bytes.
struct ElementShape {
  ComponentType type = ComponentType::Float;
  std::size_t columns = 1, rows = 1;

  std::size_t components() const { return columns * rows; }
  std::size_t columnSize() const;
  std::size_t size() const { return columns * columnSize(); }
};

/// What matrix columns and the elements of vertices begin at a multiple of, in bytes.
constexpr std::size_t kElementAlignment = 4;

constexpr std::size_t alignedSize(std::size_t size) {
  return (size + kElementAlignment - 1) / kElementAlignment * kElementAlignment;
}

/// Shape of an accessor, from its componentType and type.
ElementShape shapeOf(const Field& accessor);

}  // namespace abflat::gltf
