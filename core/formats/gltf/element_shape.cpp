#include "gltf/element_shape.h"

#include <string>

namespace abflat::gltf {

bool isUnsigned(ComponentType type) {
  return type == ComponentType::Uint8 || type == ComponentType::Uint16 ||
         type == ComponentType::Uint32;
}

std::size_t componentSize(ComponentType type) {
  switch (type) {
    case ComponentType::Int8:
    case ComponentType::Uint8:
      return 1;
    case ComponentType::Int16:
    case ComponentType::Uint16:
      return 2;
    case ComponentType::Uint32:
    case ComponentType::Float:
      return 4;
  }
  return 0;
}

int typeCode(ComponentType type) {
  switch (type) {
    case ComponentType::Int8:
      return 5120;
    case ComponentType::Uint8:
      return 5121;
    case ComponentType::Int16:
      return 5122;
    case ComponentType::Uint16:
      return 5123;
    case ComponentType::Uint32:
      return 5125;
    case ComponentType::Float:
      return 5126;
  }
  return 0;
}

ComponentType componentType(const Field& code) {
  switch (code.count()) {
    case 5120:
      return ComponentType::Int8;
    case 5121:
      return ComponentType::Uint8;
    case 5122:
      return ComponentType::Int16;
    case 5123:
      return ComponentType::Uint16;
    case 5125:
      return ComponentType::Uint32;
    case 5126:
      return ComponentType::Float;
    default:
      code.complain("must be 5120, 5121, 5122, 5123, 5125 or 5126");
      return ComponentType::Float;
  }
}

ElementShape shapeOf(const Field& accessor) {
  const ComponentType type = componentType(accessor["componentType"]);
  const std::string name = accessor["type"].text();
  if (name == "SCALAR") return {type, 1, 1};
  const bool isVector = name.substr(0, 3) == "VEC", isMatrix = name.substr(0, 3) == "MAT";
  const bool isKnown = name.size() == 4 && name[3] >= '2' && name[3] <= '4';
  if (!isKnown || !(isVector || isMatrix)) {
    accessor["type"].complain("must be SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
    return {};
  }
  const std::size_t n = static_cast<std::size_t>(name[3] - '0');
  return {type, isMatrix ? n : 1, n};
}

std::size_t ElementShape::columnSize() const {
  const std::size_t size = rows * componentSize(type);
  return columns == 1 ? size : alignedSize(size);
}

}  // namespace abflat::gltf
