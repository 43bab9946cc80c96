// What tinyobjloader reads from a text, in double precision: a second opinion.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace abflat::test {

struct TinyMesh {
  bool isRead = false;
  std::vector<double> positions, texcoords;
  std::vector<std::uint32_t> faceSizes;
  std::vector<int> faceVertices, faceTexcoords;  ///< by face corner; -1: none
};

TinyMesh readByTinyobj(const std::string& obj);

struct TinyMaterial {
  std::string name, diffuseMap;
  double diffuse[3], emission[3], opacity, metallic, roughness;
};

/// If two materials have the same name, the first one counts.
std::vector<TinyMaterial> materialsByTinyobj(const std::string& mtl);

}  // namespace abflat::test
