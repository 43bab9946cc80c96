#include "gltf/elements.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace abflat::gltf {
namespace {

/// glTF is little endian, and so is every machine that this is built for.
template <class T>
T valueAt(const char* at) {
  T out;
  std::memcpy(&out, at, sizeof out);
  return out;
}

template <class T>
double numberFrom(const char* at, bool isNormalized) {
  const double value = valueAt<T>(at);
  if (!isNormalized || !std::is_integral_v<T>) return value;
  // The lowest signed value has no counterpart above 0.
  return std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double numberAt(const char* at, ComponentType type, bool isNormalized) {
  switch (type) {
    case ComponentType::Int8:
      return numberFrom<std::int8_t>(at, isNormalized);
    case ComponentType::Uint8:
      return numberFrom<std::uint8_t>(at, isNormalized);
    case ComponentType::Int16:
      return numberFrom<std::int16_t>(at, isNormalized);
    case ComponentType::Uint16:
      return numberFrom<std::uint16_t>(at, isNormalized);
    case ComponentType::Uint32:
      return numberFrom<std::uint32_t>(at, isNormalized);
    case ComponentType::Float:
      return numberFrom<float>(at, isNormalized);
  }
  return 0;
}

}  // namespace

std::string elementsOf(const Document& document, const Accessor& accessor) {
  const std::size_t size = accessor.shape.size();
  std::string out;
  if (accessor.view == kNone || accessor.count == 0) {
    out.assign(accessor.count * size, '\0');
  } else {
    const std::string_view bytes = document.viewBytes(accessor.view).substr(accessor.offset);
    const std::size_t given = document.views[accessor.view].stride;
    const std::size_t stride = given == 0 ? size : given;
    if (stride == size) {
      out.assign(bytes.substr(0, accessor.count * size));
    } else {
      out.reserve(accessor.count * size);
      for (std::size_t i = 0; i < accessor.count; ++i) out.append(bytes.substr(i * stride, size));
    }
  }
  if (!accessor.sparse) return out;
  const SparseElements& sparse = *accessor.sparse;
  const std::vector<std::uint32_t> at = sparseIndices(document, sparse);
  const std::string_view values = document.viewBytes(sparse.valueView).substr(sparse.valueOffset);
  for (std::size_t i = 0; i < at.size(); ++i)
    std::memcpy(&out[at[i] * size], &values[i * size], size);
  return out;
}

std::vector<double> numbersOf(const Document& document, const Accessor& accessor) {
  const std::string bytes = elementsOf(document, accessor);
  const ElementShape& shape = accessor.shape;
  const std::size_t size = shape.size(), columnSize = shape.columnSize();
  const std::size_t componentSize = ElementShape{shape.type, 1, 1}.size();
  std::vector<double> out;
  out.reserve(accessor.count * shape.components());
  for (std::size_t i = 0; i < accessor.count; ++i)
    for (std::size_t column = 0; column < shape.columns; ++column)
      for (std::size_t row = 0; row < shape.rows; ++row)
        out.push_back(numberAt(&bytes[i * size + column * columnSize + row * componentSize],
                               shape.type, accessor.isNormalized));
  return out;
}

std::vector<std::uint32_t> integersOf(const Document& document, const Accessor& accessor) {
  const std::string bytes = elementsOf(document, accessor);
  const std::size_t size = accessor.shape.size();
  std::vector<std::uint32_t> out(accessor.count);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<std::uint32_t>(numberAt(&bytes[i * size], accessor.shape.type, false));
  return out;
}

std::vector<std::uint32_t> sparseIndices(const Document& document, const SparseElements& sparse) {
  Accessor indices;
  indices.view = sparse.indexView;
  indices.offset = sparse.indexOffset;
  indices.count = sparse.count;
  indices.shape.type = sparse.indexType;
  return integersOf(document, indices);
}

bool hasSparseOrder(const Document& document, const Accessor& accessor) {
  if (!accessor.sparse) return true;
  const std::vector<std::uint32_t> at = sparseIndices(document, *accessor.sparse);
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i] >= accessor.count || (i > 0 && at[i] <= at[i - 1])) return false;
  return true;
}

}  // namespace abflat::gltf
