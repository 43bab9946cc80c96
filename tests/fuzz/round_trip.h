#pragma once

#include <string_view>
#include <vector>

#include "abflat/appearance.h"
#include "abflat/gltf.h"
#include "abflat/io.h"

namespace abflat::fuzz {

/// Texcoords as they cross into a file, one for each face corner where there are no better ones.
struct CornerTexcoords {
  std::vector<double> uv;
  std::vector<std::uint32_t> cornerUv;
};
CornerTexcoords numberedCorners(const PolygonMesh& mesh);

/// A mesh that was written and read again has the same faces with the same texcoords, number by
/// number.
void expectSame(const PolygonMesh& before, const CornerTexcoords& texcoords,
                const PolygonMesh& after);

/// A mesh that is written as an OBJ or a PLY and read again is the same, with these texcoords.
void expectFile(const PolygonMesh& mesh, const CornerTexcoords& texcoords, MeshFormat format);

/// The file that a mesh was read from, with other texcoords, is that mesh with these texcoords.
void expectRoundTrip(const PolygonMesh& mesh, MeshFormat format, std::string_view source);
void expectRoundTrip(const GltfModel& model);
void expectMadeGltf(const PolygonMesh& mesh, const Appearance& look);

}  // namespace abflat::fuzz
