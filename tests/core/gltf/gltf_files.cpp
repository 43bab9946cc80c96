#include "gltf_files.h"

#include "gltf/container.h"

namespace abflat::test {

std::string glbOf(std::string json, const std::string& buffer) {
  const std::string kSize = "{SIZE}";
  const std::size_t at = json.find(kSize);
  if (at != std::string::npos) json.replace(at, kSize.size(), std::to_string(buffer.size()));
  return gltf::binaryFile(json, buffer, {}).value();
}

std::string octahedronGlb(std::size_t meshes) {
  const std::vector<float> positions = {1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1};
  const std::vector<unsigned char> indices = {0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2,
                                              1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5};
  const std::vector<unsigned char> colours = {10, 20, 30, 0, 40, 50, 60, 0, 70, 80, 90, 0,
                                              11, 21, 31, 0, 41, 51, 61, 0, 71, 81, 91, 0};
  const std::vector<unsigned char> moved = {1, 4, 0, 0};
  const std::vector<float> shifts = {5, 6, 7, 8, 9, 10};
  std::string json = R"({
    "asset": {"version": "2.0"}, "buffers": [{"byteLength": {SIZE}}],
    "bufferViews": [
      {"buffer": 0, "byteOffset": 0, "byteLength": 72},
      {"buffer": 0, "byteOffset": 72, "byteLength": 24},
      {"buffer": 0, "byteOffset": 96, "byteLength": 24, "byteStride": 4},
      {"buffer": 0, "byteOffset": 120, "byteLength": 4},
      {"buffer": 0, "byteOffset": 124, "byteLength": 24}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3",
       "min": [-1, -1, -1], "max": [1, 1, 1]},
      {"bufferView": 1, "componentType": 5121, "count": 24, "type": "SCALAR"},
      {"bufferView": 2, "componentType": 5121, "count": 6, "type": "VEC3", "normalized": true},
      {"componentType": 5126, "count": 6, "type": "VEC3", "sparse": {"count": 2,
       "indices": {"bufferView": 3, "componentType": 5121}, "values": {"bufferView": 4}}}],
    "meshes": [{MESHES}]})";
  const std::string mesh =
      R"({"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1,
                          "targets": [{"POSITION": 3}]}]})";
  std::string list = mesh;
  for (std::size_t i = 1; i < meshes; ++i) list += "," + mesh;
  const std::string kMeshes = "{MESHES}";
  json.replace(json.find(kMeshes), kMeshes.size(), list);
  return glbOf(json, bytesOf(positions) + bytesOf(indices) + bytesOf(colours) + bytesOf(moved) +
                         bytesOf(shifts));
}

Result<GltfModel> readAlone(const std::string& bytes) {
  return readGltf(bytes, "a.glb", [](const std::string& path) -> Result<std::string> {
    return Status{StatusCode::UnreadableFile, "there is no " + path};
  });
}

}  // namespace abflat::test
