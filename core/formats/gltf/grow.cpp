#include "gltf/grow.h"

#include <algorithm>
#include <cstring>

#include "gltf/elements.h"
#include "gltf/packed_indices.h"

namespace abflat::gltf {
namespace {

/// Puts elements of `size` bytes at multiples of `stride`.
std::string spread(const std::string& bytes, std::size_t size, std::size_t stride) {
  std::string out(bytes.size() / size * stride, '\0');
  for (std::size_t i = 0; i < bytes.size() / size; ++i)
    std::memcpy(&out[i * stride], &bytes[i * size], size);
  return out;
}

void appendCopies(std::string& bytes, std::size_t size, const std::vector<std::uint32_t>& copied) {
  bytes.reserve(bytes.size() + size * copied.size());
  for (const std::uint32_t from : copied) bytes.append(bytes, from * size, size);
}

void growBase(const Document& document, const Accessor& accessor,
              const std::vector<std::uint32_t>& copied, Json& json, Edit& edit) {
  const std::size_t size = accessor.shape.size();
  const std::size_t stride = alignedSize(size);
  std::string bytes = elementsOf(document, accessor);
  appendCopies(bytes, size, copied);
  if (stride != size) bytes = spread(bytes, size, stride);
  json["bufferView"] =
      edit.addView(std::move(bytes), stride == size ? 0 : stride, Target::Vertices);
}

void growSparse(const Document& document, const Accessor& accessor,
                const std::vector<std::uint32_t>& copied, Json& json, Edit& edit) {
  const SparseElements& sparse = *accessor.sparse;
  const std::size_t size = accessor.shape.size();
  std::vector<std::uint32_t> at = sparseIndices(document, sparse), more;
  std::string values(
      document.viewBytes(sparse.valueView).substr(sparse.valueOffset, at.size() * size));
  std::vector<std::uint32_t> moreAt;
  for (std::size_t i = 0; i < copied.size(); ++i) {
    const auto found = std::lower_bound(at.begin(), at.end(), copied[i]);
    if (found == at.end() || *found != copied[i]) continue;
    more.push_back(static_cast<std::uint32_t>(found - at.begin()));
    moreAt.push_back(static_cast<std::uint32_t>(accessor.count + i));
  }
  appendCopies(values, size, more);
  at.insert(at.end(), moreAt.begin(), moreAt.end());
  const ComponentType type = typeFor(sparse.indexType, at.empty() ? 0 : at.back());
  Json& out = json["sparse"];
  out["count"] = at.size();
  for (const char* key : {"indices", "values"}) out[key].erase("byteOffset");
  out["indices"]["bufferView"] = edit.addView(packed(at, type), 0, Target::Other);
  out["indices"]["componentType"] = typeCode(type);
  out["values"]["bufferView"] = edit.addView(std::move(values), 0, Target::Other);
}

}  // namespace

Json grownAccessor(const Document& document, std::size_t accessor,
                   const std::vector<std::uint32_t>& copied, Edit& edit) {
  Json json = document.json["accessors"][accessor];
  Accessor base = document.accessors[accessor];
  json["count"] = base.count + copied.size();
  json.erase("byteOffset");
  if (base.sparse) growSparse(document, base, copied, json, edit);
  base.sparse.reset();
  if (base.view != kNone) growBase(document, base, copied, json, edit);
  return json;
}

Json indexAccessor(Json base, const std::vector<std::uint32_t>& indices, ComponentType type,
                   Edit& edit) {
  const auto highest = std::max_element(indices.begin(), indices.end());
  const ComponentType used = typeFor(type, highest == indices.end() ? 0 : *highest);
  for (const char* key : {"byteOffset", "min", "max", "sparse", "normalized"}) base.erase(key);
  base["bufferView"] = edit.addView(packed(indices, used), 0, Target::Indices);
  base["componentType"] = typeCode(used);
  base["count"] = indices.size();
  base["type"] = "SCALAR";
  return base;
}

Json texcoordAccessor(Json base, const std::vector<float>& uv, Edit& edit) {
  std::string bytes(uv.size() * sizeof(float), '\0');
  if (!uv.empty()) std::memcpy(&bytes[0], uv.data(), bytes.size());
  for (const char* key : {"byteOffset", "min", "max", "sparse", "normalized"}) base.erase(key);
  base["bufferView"] = edit.addView(std::move(bytes), 0, Target::Vertices);
  base["componentType"] = typeCode(ComponentType::Float);
  base["count"] = uv.size() / 2;
  base["type"] = "VEC2";
  return base;
}

}  // namespace abflat::gltf
