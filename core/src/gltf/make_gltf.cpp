#include <algorithm>
#include <array>
#include <limits>

#include "abflat/gltf.h"
#include "gltf/container.h"
#include "gltf/json.h"
#include "gltf/uri.h"
#include "mesh/triangulate.h"

namespace abflat {
namespace gltf {
namespace {

constexpr std::uint32_t kNoNumber = 0xffffffff;

/// A buffer and the lists that describe it.
class FreshFile {
 public:
  FreshFile() {
    json_["asset"] = {{"generator", "abflat " ABFLAT_VERSION}, {"version", "2.0"}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", {0}}}});
    json_["nodes"] = Json::array({{{"mesh", 0}}});
    json_["meshes"] = Json::array({{{"primitives", Json::array()}}});
  }

  /// Returns the number of the accessor.
  std::size_t add(const std::vector<float>& values, const char* type, std::size_t components) {
    Json accessor = {
        {"componentType", 5126}, {"count", values.size() / components}, {"type", type}};
    return put(values.data(), values.size() * sizeof(float), 34962, std::move(accessor));
  }

  /// With the box that POSITION must have.
  std::size_t addPositions(const std::vector<float>& values) {
    Json least = Json::array(), most = Json::array();
    for (std::size_t d = 0; d < 3; ++d) {
      float lo = std::numeric_limits<float>::infinity(), hi = -lo;
      for (std::size_t i = d; i < values.size(); i += 3) {
        lo = std::min(lo, values[i]);
        hi = std::max(hi, values[i]);
      }
      least.push_back(lo);
      most.push_back(hi);
    }
    const std::size_t accessor = add(values, "VEC3", 3);
    json_["accessors"][accessor]["min"] = std::move(least);
    json_["accessors"][accessor]["max"] = std::move(most);
    return accessor;
  }

  std::size_t addIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    Json accessor = {{"componentType", 5125}, {"count", indices.size()}, {"type", "SCALAR"}};
    if (vertices > std::numeric_limits<std::uint16_t>::max())
      return put(indices.data(), indices.size() * sizeof(std::uint32_t), 34963, accessor);
    const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
    accessor["componentType"] = 5123;
    return put(narrow.data(), narrow.size() * sizeof(std::uint16_t), 34963, accessor);
  }

  void addPrimitive(Json primitive) {
    json_["meshes"][0]["primitives"].push_back(std::move(primitive));
  }

  std::size_t addMaterial(const std::string& name) {
    json_["materials"].push_back(name.empty() ? Json::object() : Json{{"name", name}});
    return json_["materials"].size() - 1;
  }

  Result<std::string> finish(bool isBinary) {
    json_["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
    const auto text = [&](int indent) {
      return json_.dump(indent, ' ', false, Json::error_handler_t::replace);
    };
    if (isBinary) return binaryFile(text(-1), buffer_, {});
    json_["buffers"][0]["uri"] = dataUri(buffer_);
    return text(2) + "\n";
  }

 private:
  std::size_t put(const void* values, std::size_t size, int target, Json accessor) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    const std::size_t begin = buffer_.size();
    buffer_.append(static_cast<const char*>(values), size);
    accessor["bufferView"] = json_["bufferViews"].size();
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", size}, {"target", target}});
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
  }

  Json json_;
  std::string buffer_;
};

/// Vertices of the primitives, each once for all that a corner refers to.
class CornerTable {
 public:
  struct Corner {
    std::uint32_t vertex, texcoord, normal;
  };
  struct PrimitiveVertices {
    std::vector<Corner> corners;  ///< by vertex of the primitive
    std::vector<std::uint32_t> indices;
  };

  CornerTable(std::size_t vertices, std::size_t primitives)
      : newest_(vertices, kNoNumber), primitives_(primitives) {}

  void add(const Corner& corner, std::uint32_t primitive) {
    PrimitiveVertices& out = primitives_[primitive];
    std::uint32_t at = newest_[corner.vertex];
    while (at != kNoNumber && !entries_[at].is(corner, primitive)) at = entries_[at].older;
    if (at == kNoNumber) {
      at = static_cast<std::uint32_t>(entries_.size());
      entries_.push_back({corner, primitive, static_cast<std::uint32_t>(out.corners.size()),
                          newest_[corner.vertex]});
      newest_[corner.vertex] = at;
      out.corners.push_back(corner);
    }
    out.indices.push_back(entries_[at].number);
  }

  const std::vector<PrimitiveVertices>& primitives() const { return primitives_; }

 private:
  struct Entry {
    Corner corner;
    std::uint32_t primitive, number, older;  ///< older: entry of the same vertex of the mesh

    bool is(const Corner& c, std::uint32_t p) const {
      return primitive == p && corner.texcoord == c.texcoord && corner.normal == c.normal;
    }
  };

  std::vector<std::uint32_t> newest_;  ///< entry by vertex of the mesh
  std::vector<Entry> entries_;
  std::vector<PrimitiveVertices> primitives_;
};

/// The values of the corners, `size` numbers each; where a corner has none: 0.
std::vector<float> gathered(const std::vector<double>& values, std::size_t size,
                            const std::vector<CornerTable::Corner>& corners,
                            std::uint32_t CornerTable::Corner::*number) {
  std::vector<float> out;
  out.reserve(size * corners.size());
  for (const CornerTable::Corner& corner : corners)
    for (std::size_t d = 0; d < size; ++d)
      out.push_back(static_cast<float>(values[size * (corner.*number) + d]));
  return out;
}

Json attributesOf(const CornerTable::PrimitiveVertices& vertices, const PolygonMesh& mesh,
                  const std::vector<double>& uv, FreshFile& file) {
  using Corner = CornerTable::Corner;
  Json out = Json::object();
  out["POSITION"] =
      file.addPositions(gathered(mesh.positions, 3, vertices.corners, &Corner::vertex));
  if (uv.empty()) return out;
  std::vector<float> texcoords;
  for (const Corner& corner : vertices.corners) {
    texcoords.push_back(static_cast<float>(uv[2 * std::size_t{corner.texcoord}]));
    texcoords.push_back(static_cast<float>(1 - uv[2 * std::size_t{corner.texcoord} + 1]));
  }
  out["TEXCOORD_0"] = file.add(texcoords, "VEC2", 2);
  return out;
}

}  // namespace
}  // namespace gltf

Result<std::string> makeGltf(const PolygonMesh& mesh, const std::vector<double>& uv,
                             const std::vector<std::uint32_t>& cornerUv, bool isBinary) {
  const auto materialOf = [&](std::uint32_t face) {
    return mesh.faceMaterials.empty() ? 0u : mesh.faceMaterials[face];
  };
  std::uint32_t materials = 1;
  for (const std::uint32_t m : mesh.faceMaterials) materials = std::max(materials, m + 1);
  gltf::CornerTable table(mesh.vertexCount(), materials);
  const Triangulation triangles = triangulate(mesh);
  for (std::size_t i = 0; i < triangles.corner.size(); ++i) {
    const std::uint32_t corner = triangles.corner[i];
    table.add({triangles.vertex[i], uv.empty() ? 0 : cornerUv[corner], gltf::kNoNumber},
              materialOf(triangles.face[i / 3]));
  }
  gltf::FreshFile file;
  for (const gltf::CornerTable::PrimitiveVertices& vertices : table.primitives()) {
    if (vertices.indices.empty()) continue;
    gltf::Json primitive;
    primitive["attributes"] = gltf::attributesOf(vertices, mesh, uv, file);
    primitive["indices"] = file.addIndices(vertices.indices, vertices.corners.size());
    primitive["material"] = file.addMaterial("");
    file.addPrimitive(std::move(primitive));
  }
  return file.finish(isBinary);
}

}  // namespace abflat
