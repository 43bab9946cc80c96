#include "files/compare_files.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace abflat::cli {
namespace {

/// Files may have rounded directions and colours, the latter to bytes.
constexpr double kNormalTolerance = 1e-3, kColorTolerance = 1.0 / 255;

/// Names as numbers, so that they are compared like any values.
class NameNumbers {
 public:
  double of(const std::string& name) {
    return static_cast<double>(numbers_.emplace(name, numbers_.size()).first->second);
  }

 private:
  std::map<std::string, std::size_t> numbers_;
};

/// `row`: per face. Names that are empty are told apart by where they are in the list.
CornerAttribute namedFaces(const char* what, const PolygonMesh& mesh,
                           const std::vector<std::uint32_t>& row,
                           const std::vector<std::string>& list, NameNumbers& names) {
  CornerAttribute out;
  out.name = what;
  for (std::size_t i = 0; i < list.size(); ++i)
    out.values.push_back(names.of(list[i].empty() ? "\n" + std::to_string(i) : list[i]));
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    out.row.insert(out.row.end(), mesh.faceOffsets[f + 1] - mesh.faceOffsets[f], row[f]);
  return out;
}

std::vector<double> ofLengthOne(std::vector<double> vectors) {
  for (std::size_t i = 0; i + 2 < vectors.size(); i += 3) {
    const double length = std::hypot(vectors[i], vectors[i + 1], vectors[i + 2]);
    if (!(length > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) vectors[i + k] /= length;
  }
  return vectors;
}

CornerAttribute smoothingOf(const PolygonMesh& mesh) {
  CornerAttribute out;
  out.name = "smoothing groups";
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
    out.values.push_back(mesh.faceSmoothing[f]);
    out.row.insert(out.row.end(), mesh.faceOffsets[f + 1] - mesh.faceOffsets[f], f);
  }
  return out;
}

std::vector<CornerAttribute> attributesOf(const InputFile& file, std::size_t texcoord,
                                          NameNumbers& names) {
  const PolygonMesh& mesh = file.mesh;
  std::vector<CornerAttribute> out;
  if (!mesh.faceNormals.empty())
    out.push_back({"normals", 3, ofLengthOne(mesh.normals), mesh.faceNormals, kNormalTolerance});
  if (!mesh.faceMaterials.empty())
    out.push_back(namedFaces("materials", mesh, mesh.faceMaterials, mesh.materialNames, names));
  if (file.gltf) {
    for (CornerAttribute& attribute : gltfAttributes(*file.gltf, texcoord))
      out.push_back(std::move(attribute));
    return out;
  }
  if (!mesh.faceSmoothing.empty()) out.push_back(smoothingOf(mesh));
  if (!file.look.colors.empty())
    out.push_back({"colors", 4, file.look.colors, mesh.faceVertices, kColorTolerance});
  if (!file.look.faceObjects.empty())
    out.push_back(namedFaces("objects", mesh, file.look.faceObjects, file.look.objectNames, names));
  return out;
}

}  // namespace

Result<std::vector<MeshDifference>> compareFiles(InputFile& was, InputFile& now,
                                                 std::size_t texcoord) {
  for (InputFile* file : {&was, &now})
    if (Status s = readLook(*file); !s.ok()) return s;
  NameNumbers names;
  const std::vector<CornerAttribute> before = attributesOf(was, texcoord, names);
  const std::vector<CornerAttribute> after = attributesOf(now, texcoord, names);
  const bool wasGltf = was.gltf != nullptr, isGltf = now.gltf != nullptr;
  return compareMeshes({was.mesh, before}, {now.mesh, after},
                       {wasGltf == isGltf, !wasGltf && !isGltf});
}

}  // namespace abflat::cli
