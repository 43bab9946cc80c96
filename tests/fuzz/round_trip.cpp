#include "round_trip.h"

#include <string>

#include "expect.h"

namespace abflat::fuzz {
namespace {

Result<std::string> nothing(const std::string&) {
  return Status{StatusCode::UnreadableFile, "there is no such file"};
}

PolygonMesh readAgain(const std::string& bytes) {
  Result<GltfModel> again = readGltf(bytes, "written", nothing);
  expect(again.ok(), "what is written can be read: " + again.status().message);
  return std::move(again.value().mesh);
}

}  // namespace

CornerTexcoords numberedCorners(const PolygonMesh& mesh) {
  CornerTexcoords out;
  const std::size_t corners = mesh.faceVertices.size();
  for (std::uint32_t c = 0; c < corners; ++c) {
    // Multiples of 2^-11: exact in single precision, with v from the top as well.
    out.uv.insert(out.uv.end(), {(c % 2048) / 2048.0, (c / 2048 % 2048) / 2048.0});
    out.cornerUv.push_back(c);
  }
  return out;
}

void expectSame(const PolygonMesh& before, const CornerTexcoords& texcoords,
                const PolygonMesh& after) {
  expect(before.faceOffsets == after.faceOffsets, "faces keep their number and their corners");
  const bool hasTexcoords = !texcoords.cornerUv.empty();
  expect(!hasTexcoords || after.faceTexcoords.size() == after.faceVertices.size(),
         "all corners have texcoords");
  for (std::size_t c = 0; c < before.faceVertices.size(); ++c) {
    const std::string corner = "corner " + std::to_string(c);
    for (std::size_t d = 0; d < 3; ++d)
      expect(before.positions[3 * std::size_t{before.faceVertices[c]} + d] ==
                 after.positions[3 * std::size_t{after.faceVertices[c]} + d],
             corner + " stays where it is");
    if (!hasTexcoords) continue;
    expect(after.faceTexcoords[c] != kNoTexcoord, corner + " has a texcoord");
    for (std::size_t d = 0; d < 2; ++d)
      expect(texcoords.uv[2 * std::size_t{texcoords.cornerUv[c]} + d] ==
                 after.texcoords[2 * std::size_t{after.faceTexcoords[c]} + d],
             corner + " has the texcoord that was written");
  }
}

void expectFile(const PolygonMesh& mesh, const CornerTexcoords& texcoords, MeshFormat format) {
  const auto& [uv, cornerUv] = texcoords;
  const std::string bytes =
      format == MeshFormat::Obj ? writeObj(mesh, uv, cornerUv) : writePly(mesh, uv, cornerUv);
  const Result<PolygonMesh> again = readMesh(bytes, format, "written");
  expect(again.ok(), "what is written can be read: " + again.status().message);
  expectSame(mesh, texcoords, again.value());
}

void expectRoundTrip(const PolygonMesh& mesh, MeshFormat format, std::string_view source) {
  const CornerTexcoords texcoords = numberedCorners(mesh);
  const auto& [uv, cornerUv] = texcoords;
  for (const std::string_view from : {source, std::string_view()}) {
    const std::string bytes = format == MeshFormat::Obj ? writeObj(mesh, uv, cornerUv, from)
                                                        : writePly(mesh, uv, cornerUv, from);
    const Result<PolygonMesh> again = readMesh(bytes, format, "written");
    expect(again.ok(), "what is written can be read: " + again.status().message);
    expectSame(mesh, texcoords, again.value());
  }
}

void expectRoundTrip(const GltfModel& model) {
  const CornerTexcoords texcoords = numberedCorners(model.mesh);
  GltfBaked baked;
  baked.images = {{"colours", "image/png", "bytes"}, {"bumps", "image/webp", "more bytes"}};
  baked.baseColor = baked.occlusion = 0;
  baked.normal = 1;
  for (const auto& [isBinary, look] :
       {std::pair<bool, const GltfBaked*>{true, nullptr}, {false, nullptr}, {true, &baked}}) {
    GltfWriteOptions options;
    options.isBinary = isBinary;
    options.baked = look;
    const Result<std::string> bytes =
        writeGltf(*model.source, texcoords.uv, texcoords.cornerUv, options);
    expect(bytes.ok(), "what was read can be written: " + bytes.status().message);
    expectSame(model.mesh, texcoords, readAgain(bytes.value()));
  }
}

void expectMadeGltf(const PolygonMesh& mesh, const Appearance& look) {
  const CornerTexcoords texcoords = numberedCorners(mesh);
  const Result<std::string> bytes =
      makeGltf(mesh, texcoords.uv, texcoords.cornerUv, triangleCornersOf(mesh), look, {});
  if (bytes.ok()) readAgain(bytes.value());
}

}  // namespace abflat::fuzz
