#include "layout_cases.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>

#include "abflat/io.h"
#include "random_mesh.h"
#include "random_options.h"

namespace abflat::fuzz {
namespace {

SeamSources randomSeams(const PolygonMesh& mesh, RandomSource& random) {
  SeamSources out;
  out.isAuto = !random.isOneOf(4);
  if (random.isOneOf(4)) out.sharpDegrees = random.pick({1.0, 30.0, 60.0, 179.0});
  out.followsTexcoords = random.isOneOf(4);
  out.followsMaterials = random.isOneOf(4);
  if (mesh.faceVertices.empty()) return out;
  for (std::uint32_t n = random.isOneOf(4) ? random.below(9) : 0; n > 0; --n) {
    const std::uint32_t f = random.below(mesh.faceCount());
    const std::uint32_t begin = mesh.faceOffsets[f], count = mesh.faceOffsets[f + 1] - begin;
    const std::uint32_t k = random.below(count);
    out.edges.push_back({mesh.faceVertices[begin + k], mesh.faceVertices[begin + (k + 1) % count]});
  }
  return out;
}

/// Normals or smoothing groups, as a file may have them.
void addShading(PolygonMesh& mesh, RandomSource& random) {
  const bool hasNormals = random.flag();
  if (hasNormals)
    for (std::uint32_t n = 4; n > 0; --n)
      mesh.normals.insert(mesh.normals.end(), {random.signedUnit(), random.signedUnit(), 1});
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (!hasNormals) mesh.faceSmoothing.push_back(random.below(3));
  for (std::size_t c = 0; hasNormals && c < mesh.faceVertices.size(); ++c)
    mesh.faceNormals.push_back(random.isOneOf(8) ? kNoNormal : random.below(4));
}

/// Texcoords of all kinds, in place of those that the mesh may have: of a projection, mirrored, of
/// parts that lie on each other or far away, of squares, in a line or in a point; missing at some
/// faces.
void addLayout(PolygonMesh& mesh, RandomSource& random) {
  mesh.texcoords.clear();
  mesh.faceTexcoords.clear();
  const double size = random.pick({1.0, 1.0, 1.0, 1e-9, 1e12});
  const bool isProjected = random.flag();
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const bool isMissing = random.isOneOf(16);
    const double shift = random.isOneOf(4) ? 4 * random.signedUnit() : 0;
    const double across = random.pick({1.0, 1.0, 1.0, -1.0, 0.0});
    const std::uint32_t begin = mesh.faceOffsets[f];
    for (std::uint32_t c = begin; c < mesh.faceOffsets[f + 1]; ++c) {
      if (isMissing) {
        mesh.faceTexcoords.push_back(kNoTexcoord);
        continue;
      }
      const double* p = &mesh.positions[3 * std::size_t{mesh.faceVertices[c]}];
      constexpr double kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      const double* corner = kCorners[(c - begin) % 4];
      const double u = isProjected ? p[0] / 16 : corner[0], v = isProjected ? p[1] / 16 : corner[1];
      mesh.faceTexcoords.push_back(static_cast<std::uint32_t>(mesh.texcoords.size() / 2));
      mesh.texcoords.insert(mesh.texcoords.end(), {size * (across * u + shift), size * v});
    }
  }
}

template <class Options>
void showOptions(std::ostringstream& out, const Options& options) {
  forEachOption(options, [&](const char* name, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, AtlasSize>)
      out << "# " << name << " " << value.width << "x" << value.height << "\n";
    else
      out << "# " << name << " " << value << "\n";
  });
}

}  // namespace

UnwrapCase unwrapCase(const std::uint8_t* bytes, std::size_t size) {
  RandomSource random(bytes, size);
  UnwrapCase out;
  out.isPlain = random.flag();
  const std::uint32_t format = random.below(3);  // OBJ, PLY, GLB
  if (!out.isPlain) randomOptions(out.options, random);
  out.mesh = randomMesh(random);
  if (!out.isPlain) out.options.seams = randomSeams(out.mesh, random);
  if (!out.isPlain && random.isOneOf(3)) {
    addShading(out.mesh, random);
    out.options.seams.followsHardEdges = random.flag();
  }
  out.options.precision = std::array{Precision::Double, Precision::Single, Precision::Gltf}[format];
  return out;
}

FlattenCase flattenCase(const std::uint8_t* bytes, std::size_t size) {
  RandomSource random(bytes, size);
  FlattenCase out;
  out.precision = random.pick({Precision::Double, Precision::Single, Precision::Gltf});
  const bool isPlain = random.flag();
  if (!isPlain) randomOptions(out.options, random);
  out.mesh = randomDisk(random);
  if (isPlain) return out;
  const auto vertex = [&] { return random.below(out.mesh.vertexCount()); };
  for (std::uint32_t n = random.below(4); n > 0; --n)
    out.options.bounds.push_back({vertex(), random.pick({0.6, 0.9, 1.0, 1.5})});
  for (std::uint32_t n = random.below(4); n > 0; --n)
    out.options.pins.push_back({vertex(), {random.signedUnit(), random.signedUnit()}, kAnyFace});
  return out;
}

PackCase packCase(const std::uint8_t* bytes, std::size_t size) {
  RandomSource random(bytes, size);
  PackCase out;
  out.options.precision = random.pick({Precision::Double, Precision::Single, Precision::Gltf});
  if (!random.flag()) randomOptions(out.options, random);
  out.mesh = randomMesh(random);
  addLayout(out.mesh, random);
  return out;
}

VerifyCase verifyCase(const std::uint8_t* bytes, std::size_t size) {
  RandomSource random(bytes, size);
  VerifyCase out;
  // Letters, as a file in either format begins with one.
  const std::uint8_t kind = random.byte();
  if (kind == 'o' || kind == 'p') {
    const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
    Result<PolygonMesh> mesh =
        readMesh(text, kind == 'o' ? MeshFormat::Obj : MeshFormat::Ply, "made-up");
    if (mesh.ok()) out.mesh = std::move(mesh.value());
    return out;
  }
  if (!random.flag()) randomValues(out.options, random);
  out.mesh = randomMesh(random);
  addLayout(out.mesh, random);
  return out;
}

std::string shown(const UnwrapCase& c) {
  std::ostringstream out;
  showOptions(out, static_cast<const UnwrapOptionValues&>(c.options));
  const SeamSources& seams = c.options.seams;
  out << "# seams: auto " << seams.isAuto << ", sharp " << seams.sharpDegrees << ", uv "
      << seams.followsTexcoords << ", material " << seams.followsMaterials << ", hard "
      << seams.followsHardEdges << "\n";
  for (const EdgeVertices& e : seams.edges) out << "# seam " << e[0] << " " << e[1] << "\n";
  out << "# precision " << static_cast<int>(c.options.precision) << "\n";
  const bool hasAll =
      std::count(c.mesh.faceTexcoords.begin(), c.mesh.faceTexcoords.end(), kNoTexcoord) == 0;
  if (!hasAll) out << "# texcoords: of some faces only, not shown\n";
  return out.str() + (hasAll ? writeObj(c.mesh, c.mesh.texcoords, c.mesh.faceTexcoords)
                             : writeObj(c.mesh, {}, {}));
}

std::string shown(const FlattenCase& c) {
  std::ostringstream out;
  showOptions(out, static_cast<const FlattenOptionValues&>(c.options));
  for (const VertexBound& b : c.options.bounds) out << "# bound " << b.vertex << " " << b.t << "\n";
  for (const Pin& p : c.options.pins)
    out << "# pin " << p.vertex << " " << p.uv[0] << " " << p.uv[1] << "\n";
  out << "# precision " << static_cast<int>(c.precision) << "\n";
  return out.str() + writeObj(c.mesh, {}, {});
}

std::string shown(const PackCase& c) {
  std::ostringstream out;
  showOptions(out, static_cast<const PackOptionValues&>(c.options));
  out << "# precision " << static_cast<int>(c.options.precision) << "\n";
  return out.str() + writeObj(c.mesh, c.mesh.texcoords, c.mesh.faceTexcoords);
}

std::string shown(const VerifyCase& c) {
  std::ostringstream out;
  showOptions(out, static_cast<const VerifyOptionValues&>(c.options));
  return out.str() + writeObj(c.mesh, c.mesh.texcoords, c.mesh.faceTexcoords);
}

}  // namespace abflat::fuzz
