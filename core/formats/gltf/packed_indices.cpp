#include "gltf/packed_indices.h"

#include <cstring>
#include <limits>

namespace abflat::gltf {

ComponentType typeFor(ComponentType type, std::uint32_t highest) {
  if (type == ComponentType::Uint8 && highest < std::numeric_limits<std::uint8_t>::max())
    return type;
  if (type != ComponentType::Uint32 && highest < std::numeric_limits<std::uint16_t>::max())
    return ComponentType::Uint16;
  return ComponentType::Uint32;
}

std::string packed(const std::vector<std::uint32_t>& numbers, ComponentType type) {
  const std::size_t size = ElementShape{type, 1, 1}.size();
  std::string out(numbers.size() * size, '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(&out[i * size], &numbers[i], size);
  return out;
}

}  // namespace abflat::gltf
