#include "base/guarded.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/abflat.h"
#include "abflat/bake.h"
#include "abflat/compare.h"
#include "abflat/draw.h"
#include "abflat/flatten.h"
#include "abflat/inspect.h"
#include "abflat/io.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "support/little_memory.h"

namespace abflat {
namespace {

using test::checkWithLittleMemory;
using test::Ended;
using test::ended;

/// A bent grid of n x n squares, cut in two triangles each.
PolygonMesh bentGrid(unsigned n) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0};
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i)
      mesh.positions.insert(mesh.positions.end(),
                            {1.0 * i, 1.0 * j, 0.5 * std::sin(1.3 * i) * std::cos(0.9 * j)});
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const unsigned a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      for (const auto& t : {std::array{a, b, c}, std::array{a, c, d}}) {
        mesh.faceVertices.insert(mesh.faceVertices.end(), t.begin(), t.end());
        mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
      }
    }
  return mesh;
}

}  // namespace

TEST_CASE("public functions report lack of memory, leak nothing and work again") {
  const PolygonMesh mesh = bentGrid(6);
  const std::string name = "a mesh with a name that is too long for the string itself.obj";
  Result<UnwrapResult> atlas = unwrap(mesh, UnwrapOptions());
  REQUIRE(atlas.ok());
  const std::string obj = writeObj(mesh, atlas.value().uv, atlas.value().cornerUv, {});
  SECTION("readMesh") {
    for (const std::string& text : {obj, std::string("v 1\n")})
      checkWithLittleMemory(
          [&] { return ended(readMesh(text, MeshFormat::Obj, name), &PolygonMesh::positions); });
  }
  SECTION("inspect") {
    checkWithLittleMemory([&] { return ended(inspect(mesh).disk, ""); });
  }
  for (const int threads : {1, 3}) {
    DYNAMIC_SECTION("unwrap with " << threads << " threads") {
      UnwrapOptions options;
      options.threads = threads;
      checkWithLittleMemory([&] { return ended(unwrap(mesh, options), &UnwrapResult::uv); });
    }
    DYNAMIC_SECTION("flatten with " << threads << " threads") {
      FlattenOptions options;
      options.threads = threads;
      checkWithLittleMemory([&] { return ended(flatten(mesh, options), &FlattenResult::uv); });
    }
  }
  SECTION("compare") {
    checkWithLittleMemory([&] { return ended(compare(mesh, {}).status(), ""); });
  }
  for (const auto call : {abflat_unwrap, abflat_pack}) {
    DYNAMIC_SECTION((call == abflat_pack ? "pack" : "unwrap") << " for C") {
      abflat_mesh triangles{};
      triangles.positions = triangles.texcoords = mesh.positions.data();
      triangles.texcoord_stride = 3 * sizeof(double);
      triangles.vertex_count = mesh.vertexCount();
      triangles.triangles = mesh.faceVertices.data();
      triangles.triangle_count = mesh.faceVertices.size() / 3;
      checkWithLittleMemory([&] {
        abflat_result* result = nullptr;
        const int status = call(&triangles, nullptr, nullptr, nullptr, &result);
        std::size_t count = 0;
        const double* const uv = result ? abflat_uv(result, &count) : nullptr;
        const auto* const bytes = reinterpret_cast<const char*>(uv);
        const Ended out = ended({static_cast<StatusCode>(status), {}},
                                std::string_view(bytes, 2 * count * sizeof(double)));
        abflat_free_result(result);
        return out;
      });
    }
  }
  SECTION("bake") {
    const std::vector<std::uint8_t> pixels(3 * 64 * 64, 100);
    BakeInput input;
    input.textures.resize(1);
    input.textures[0].image = {pixels.data(), 64, 64, 3, 8};
    input.materials.resize(1);
    input.materials[0].texture = 0;
    input.triangles.uv = {0.1, 0.1, 0.9, 0.2, 0.3, 0.8};
    input.triangles.oldUv = {0, 0, 4, 0, 0, 4};
    input.triangles.materials = {0};
    BakeOptions options;
    options.width = options.height = 20;
    checkWithLittleMemory([&] {
      std::string image;
      const Status status = bake(input, options, [&](auto, auto, const auto& bytes) {
        image.append(bytes.begin(), bytes.end());
        return true;
      });
      return ended(status, status.ok() ? image : std::string());
    });
  }
#if ABFLAT_DRAWING
  SECTION("pictures") {
    checkWithLittleMemory([&] { return ended(atlasPng(mesh, atlas.value())); });
  }
#endif
}

}  // namespace abflat
