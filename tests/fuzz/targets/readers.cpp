#include <string>
#include <string_view>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/gltf.h"
#include "abflat/gltf_look.h"
#include "abflat/inspect.h"
#include "abflat/io.h"
#include "abflat/obj_maps.h"
#include "expect.h"
#include "round_trip.h"
#include "targets.h"

namespace abflat::fuzz {
namespace {

std::string_view text(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// Refused with a sentence that names the file.
void expectReason(const Status& status) {
  expect(status.message.find("made-up") != std::string::npos,
         "a refusal names the file, not \"" + status.message + "\"");
}

void expectMesh(const PolygonMesh& mesh) {
  const Status status = validateArrays(mesh);
  expect(status.ok() || status.code == StatusCode::EmptyMesh,
         "what was read is a mesh: " + status.message);
  inspect(mesh);
}

bool readFile(std::string_view bytes, MeshFormat format) {
  const Result<PolygonMesh> mesh = readMesh(bytes, format, "made-up");
  if (!mesh.ok()) {
    expectReason(mesh.status());
    return false;
  }
  expectMesh(mesh.value());
  if (format == MeshFormat::Obj || format == MeshFormat::Ply)
    expectRoundTrip(mesh.value(), format, bytes);
  return true;
}

/// What a file refers to is all the same file.
ReadResource always(std::string_view bytes) {
  return [bytes](const std::string& path) -> Result<std::string> {
    if (path.size() % 2 == 1) return Status{StatusCode::UnreadableFile, "there is no such file"};
    return std::string(bytes);
  };
}

/// A material file that is written anew has the same maps, with images that are placed nowhere.
void expectSameMaps(std::string_view obj, const PolygonMesh& mesh, std::string_view other) {
  const ObjMaps maps = readObjMaps(obj, mesh, always(other)).value();
  expect(maps.materials.size() == mesh.materialNames.size(), "every material has maps");
  std::vector<std::vector<std::string>> names;
  std::size_t count = 0;
  for (const std::vector<MtlMap>& row : maps.materials) {
    names.emplace_back(row.size(), "new.png");
    count += row.size();
  }
  const std::string mtl = writeMtl(maps, names);
  const ObjMaps again = readObjMaps(withMtl(obj, "news.mtl"), mesh, always(mtl)).value();
  if (maps.files.empty()) return;
  for (const std::vector<MtlMap>& row : again.materials) {
    expect(row.size() <= count, "no map is added");
    count -= row.size();
    for (const MtlMap& map : row)
      expect(map.scale[0] == 1 && map.offset[0] == 0 && !map.isClamped, "new images fill the tile");
  }
  expect(count == 0, "no map is lost");
}

}  // namespace

bool readObj(const std::uint8_t* bytes, std::size_t size) {
  return readFile(text(bytes, size), MeshFormat::Obj);
}
bool readPly(const std::uint8_t* bytes, std::size_t size) {
  return readFile(text(bytes, size), MeshFormat::Ply);
}
bool readStl(const std::uint8_t* bytes, std::size_t size) {
  return readFile(text(bytes, size), MeshFormat::Stl);
}
bool readOff(const std::uint8_t* bytes, std::size_t size) {
  return readFile(text(bytes, size), MeshFormat::Off);
}

bool readGltf(const std::uint8_t* bytes, std::size_t size) {
  const std::string buffer(64, '\1');
  const Result<GltfModel> model = abflat::readGltf(text(bytes, size), "made-up", always(buffer));
  if (!model.ok()) {
    expectReason(model.status());
    return false;
  }
  expectMesh(model.value().mesh);
  expectRoundTrip(model.value());
  const Result<GltfLook> look = readGltfLook(*model.value().source, always(buffer));
  if (!look.ok()) expectReason(look.status());
  PolygonMesh joined = model.value().mesh;
  joinVertices(joined);
  expectMesh(joined);
  return true;
}

bool readMaterials(const std::uint8_t* bytes, std::size_t size) {
  // What comes behind the last NUL is the file that the OBJ refers to.
  const std::string_view all = text(bytes, size);
  const std::size_t end = all.rfind('\0');
  const std::string_view obj = all.substr(0, end == all.npos ? size : end);
  const std::string_view other = end == all.npos ? all : all.substr(end + 1);
  const Result<PolygonMesh> mesh = readMesh(obj, MeshFormat::Obj, "made-up");
  if (!mesh.ok()) return false;
  const Appearance look = readAppearance(obj, MeshFormat::Obj, mesh.value(), always(other)).value();
  expectMadeGltf(mesh.value(), look);
  expectSameMaps(obj, mesh.value(), other);
  return true;
}

}  // namespace abflat::fuzz
