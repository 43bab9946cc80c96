#include "support/tinyobj.h"

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace abflat::test {

TinyMesh readByTinyobj(const std::string& obj) {
  tinyobj::attrib_t values;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(obj);
  TinyMesh out;
  constexpr bool kTriangulate = false;
  out.isRead = tinyobj::LoadObj(&values, &shapes, &materials, &warning, &error, &stream, nullptr,
                                kTriangulate);
  out.positions = values.vertices;
  out.texcoords = values.texcoords;
  for (const tinyobj::shape_t& shape : shapes) {
    const std::vector<unsigned char>& sizes = shape.mesh.num_face_vertices;
    out.faceSizes.insert(out.faceSizes.end(), sizes.begin(), sizes.end());
    for (const tinyobj::index_t& corner : shape.mesh.indices) {
      out.faceVertices.push_back(corner.vertex_index);
      out.faceTexcoords.push_back(corner.texcoord_index);
    }
  }
  return out;
}

std::vector<TinyMaterial> materialsByTinyobj(const std::string& mtl) {
  std::map<std::string, int> numbers;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(mtl);
  tinyobj::LoadMtl(&numbers, &materials, &stream, &warning, &error);
  std::vector<TinyMaterial> out;
  for (const auto& [name, number] : numbers) {
    const tinyobj::material_t& m = materials[static_cast<std::size_t>(number)];
    TinyMaterial& material = out.emplace_back(
        TinyMaterial{name, m.diffuse_texname, {}, {}, m.dissolve, m.metallic, m.roughness});
    std::copy(m.diffuse, m.diffuse + 3, material.diffuse);
    std::copy(m.emission, m.emission + 3, material.emission);
  }
  return out;
}

}  // namespace abflat::test
