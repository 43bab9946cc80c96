#include "abflat/abflat.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "abflat/pack_layout.h"
#include "abflat/unwrap.h"
#include "abflat/verify.h"
#include "abflat/version.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using test::uvSphere;

namespace {

struct Options {
  abflat_options* all = abflat_new_options();
  ~Options() { abflat_free_options(all); }
  int set(const char* name, const char* value) const { return abflat_set_option(all, name, value); }
};

template <auto call>
struct Outcome {
  abflat_result* result = nullptr;
  int status = 0;
  ~Outcome() { abflat_free_result(result); }
  explicit Outcome(const abflat_mesh& mesh, const abflat_options* options = nullptr,
                   abflat_progress progress = nullptr, void* user = nullptr)
      : status(call(&mesh, options, progress, user, &result)) {}
};
using Unwrapped = Outcome<abflat_unwrap>;
using Packed = Outcome<abflat_pack>;
using Verified = Outcome<abflat_verify>;

abflat_mesh arraysOf(const PolygonMesh& mesh) {
  return {mesh.positions.data(),
          0,
          0,
          mesh.vertexCount(),
          mesh.faceVertices.data(),
          0,
          0,
          mesh.faceCount(),
          nullptr,
          0,
          0};
}

template <class T>
std::vector<T> copied(const T* values, std::size_t count) {
  return {values, values + count};
}

}  // namespace

TEST_CASE("the functions for C give what those for C++ give", "[c]") {
  const PolygonMesh mesh = uvSphere(24, 16);
  UnwrapOptions options;
  options.maxStretch = 1.1;
  options.rotate = Rotate::Quarter;
  options.memory = 2048;
  options.resolution = {512, 256};
  options.udim = false;
  options.seams.sharpDegrees = 60;
  const UnwrapResult expected = unwrap(mesh, options).value();
  REQUIRE(expected.report.valid);

  const Options set;
  REQUIRE(set.set("maxStretch", "1.1") == 0);
  REQUIRE(set.set("--rotate", "quarter") == 0);
  REQUIRE(set.set("memory", "2G") == 0);
  REQUIRE(set.set("resolution", "512x256") == 0);
  REQUIRE(set.set("udim", "false") == 0);
  REQUIRE(set.set("seams", "auto,sharp=60") == 0);
  const Unwrapped got(arraysOf(mesh), set.all);
  REQUIRE(got.status == 0);
  CHECK(abflat_is_valid(got.result) == 1);
  CHECK(std::string(abflat_message(got.result)).empty());
  std::size_t vertices = 0, uvs = 0, triangles = 0, charts = 0;
  const std::uint32_t* const ofInput = abflat_vertices(got.result, &vertices);
  const double* const uv = abflat_uv(got.result, &uvs);
  CHECK(copied(ofInput, vertices) == expected.vertexMap);
  REQUIRE(uvs == vertices);
  for (std::size_t i = 0; i < uvs; ++i)
    for (const std::size_t d : {0, 1})
      REQUIRE(uv[2 * i + d] == expected.uv[2 * std::size_t{expected.vertexUv[i]} + d]);
  const std::uint32_t* const corners = abflat_triangles(got.result, &triangles);
  CHECK(copied(corners, 3 * triangles) == expected.triangles);
  const std::uint32_t* const ofTriangle = abflat_charts(got.result, &charts);
  CHECK(copied(ofTriangle, charts) == expected.chartOfTriangle);
  CHECK(std::string(abflat_report(got.result)).find("\"valid\": true") != std::string::npos);
}

TEST_CASE("positions may be floats between other data", "[c]") {
  const PolygonMesh mesh = uvSphere(12, 8);
  struct Vertex {
    char other;
    float at[3];
  };
  std::vector<Vertex> vertices(mesh.vertexCount());
  PolygonMesh rounded = mesh;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t d = 0; d < 3; ++d)
      rounded.positions[3 * v + d] = vertices[v].at[d] =
          static_cast<float>(mesh.positions[3 * v + d]);
  abflat_mesh arrays = arraysOf(mesh);
  arrays.positions = vertices.front().at;
  arrays.positions_are_floats = 1;
  arrays.position_stride = sizeof(Vertex);
  const Unwrapped got(arrays), expected(arraysOf(rounded));
  std::size_t count = 0;
  const double* const uv = abflat_uv(got.result, &count);
  CHECK(copied(uv, 2 * count) == copied(abflat_uv(expected.result, nullptr), 2 * count));
}

TEST_CASE("numbers of vertices may have 2, 4 or 8 bytes, between other data", "[c]") {
  const PolygonMesh mesh = uvSphere(12, 8);
  const Unwrapped expected(arraysOf(mesh));
  std::size_t count = 0;
  const double* const uv = abflat_uv(expected.result, &count);
  const auto check = [&](auto index) {
    using Index = decltype(index);
    struct Triangle {
      Index vertices[3], other;
    };
    std::vector<Triangle> triangles(mesh.faceCount());
    for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
      triangles[c / 3].vertices[c % 3] = static_cast<Index>(mesh.faceVertices[c]);
    abflat_mesh arrays = arraysOf(mesh);
    arrays.triangles = triangles.data();
    arrays.index_size = sizeof(Index);
    arrays.triangle_stride = sizeof(Triangle);
    const Unwrapped got(arrays);
    REQUIRE(got.status == 0);
    std::size_t found = 0;
    CHECK(copied(abflat_uv(got.result, &found), 2 * count) == copied(uv, 2 * count));
    CHECK(found == count);
  };
  check(std::uint16_t{});
  check(std::uint32_t{});
  check(std::uint64_t{});
  abflat_mesh wrong = arraysOf(mesh);
  wrong.index_size = 3;
  const Unwrapped refused(wrong);
  CHECK(std::string(abflat_status_name(refused.status)) == "InvalidMesh");
}

TEST_CASE("packing from C gives what it gives from C++", "[c]") {
  PolygonMesh mesh =
      makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 5, 0, 0, 6, 0, 0, 5, 2, 0, 9, 9, 9},
                       {0, 1, 2, 1, 3, 2, 4, 5, 6, 3, 1, 7});
  struct Texcoord {
    float at[2];
    char other;
  };
  const std::vector<Texcoord> texcoords = {
      {{0, 0}, 0},         {{0.5f, 0}, 0},     {{0, 0.5f}, 0},     {{0.5f, 0.5f}, 0},
      {{0.25f, 0.25f}, 0}, {{0.75f, 0.5f}, 0}, {{2.5f, 0.75f}, 0}, {{std::nanf(""), 0}, 0}};
  for (const Texcoord& t : texcoords)
    mesh.texcoords.insert(mesh.texcoords.end(), {t.at[0], t.at[1]});
  for (const std::uint32_t v : mesh.faceVertices)
    mesh.faceTexcoords.push_back(v == 7 ? kNoTexcoord : v);
  PackLayoutOptions options;
  options.islandSizes = IslandSizes::Even;
  options.padding = 5;
  const PackLayoutResult packed = packLayout(mesh, options).value();
  REQUIRE(packed.report.valid);
  const PackedVertices expected = packedVertices(mesh, packed);

  const Options set;
  REQUIRE(set.set("islandSizes", "even") == 0);
  REQUIRE(set.set("padding", "5") == 0);
  abflat_mesh arrays = arraysOf(mesh);
  arrays.texcoords = texcoords.front().at;
  arrays.texcoords_are_floats = 1;
  arrays.texcoord_stride = sizeof(Texcoord);
  const Packed got(arrays, set.all);
  REQUIRE(got.status == 0);
  CHECK(abflat_is_valid(got.result) == 1);
  std::size_t vertices = 0, triangles = 0;
  CHECK(copied(abflat_uv(got.result, &vertices), expected.uv.size()) == expected.uv);
  CHECK(copied(abflat_vertices(got.result, nullptr), vertices) == expected.vertexMap);
  CHECK(copied(abflat_triangles(got.result, &triangles), 12) == expected.triangles);
  CHECK(triangles == 4);
  CHECK(copied(abflat_charts(got.result, nullptr), triangles) == expected.islandOfTriangle);
  CHECK(std::string(abflat_report(got.result)).find("\"islands\": 2") != std::string::npos);

  const Packed without(arraysOf(mesh));
  CHECK(std::string(abflat_status_name(without.status)) == "NoTexcoords");
  arrays.vertex_count -= 1;
  CHECK(std::string(abflat_status_name(Packed(arrays).status)) == "InvalidMesh");
}

TEST_CASE("C learns what is wrong", "[c]") {
  const Options options;
  CHECK(std::string(abflat_status_name(options.set("maxStrech", "2"))) == "InvalidOption");
  CHECK(abflat_option_message(options.all) == std::string("there is no option maxStrech"));
  for (const char* value : {"1", "x", "", "nan", "1.1x"})
    CHECK(options.set("maxStretch", value) != 0);
  for (const char* value : {"", "2", "yes"}) CHECK(options.set("udim", value) != 0);
  CHECK(std::string(abflat_option_message(options.all)).find("udim") == 0);
  CHECK(options.set("memory", "1X") != 0);
  CHECK(options.set("minUtilization", "-1") != 0);
  CHECK(options.set("seams", "sharp") != 0);
  CHECK(options.set("maxStretch", "1.5") == 0);
  CHECK(std::string(abflat_option_message(options.all)).empty());

  const PolygonMesh sphere = uvSphere(12, 8);
  abflat_mesh mesh = arraysOf(sphere);
  mesh.vertex_count -= 1;
  const Unwrapped outside(mesh);
  CHECK(std::string(abflat_status_name(outside.status)) == "InvalidMesh");
  CHECK(std::strlen(abflat_message(outside.result)) > 0);
  std::size_t count = 1;
  abflat_uv(outside.result, &count);
  CHECK(count == 0);
  const Unwrapped empty(abflat_mesh{});
  CHECK(std::string(abflat_status_name(empty.status)) == "EmptyMesh");
}

TEST_CASE("C hears of progress and may cancel", "[c]") {
  const PolygonMesh mesh = uvSphere(24, 16);
  int calls = 0;
  const auto count = [](const char*, double, void* user) { return ++*static_cast<int*>(user); };
  const Unwrapped done(arraysOf(mesh), nullptr, count, &calls);
  CHECK(done.status == 0);
  CHECK(calls > 3);
  const auto cancel = [](const char*, double, void*) { return 0; };
  const Unwrapped cancelled(arraysOf(mesh), nullptr, cancel);
  CHECK(std::string(abflat_status_name(cancelled.status)) == "Aborted");
  CHECK(std::string(abflat_version()) == ABFLAT_VERSION);
}

TEST_CASE("verifying gives what C++ gives, by rules of its own", "[c]") {
  // Two triangles of which one covers a part of the other, and one without texcoords.
  const PolygonMesh mesh = makeTriangleMesh(
      {0, 0, 0, 1, 0, 0, 0, 1, 0, 4, 0, 0, 5, 0, 0, 4, 1, 0, 8, 0, 0}, {0, 1, 2, 3, 4, 5, 6, 4, 5});
  const double nan = std::nan("");
  std::vector<double> texcoords = {0, 0, 0.4, 0, 0, 0.4, 0.1, 0.1, 0.5, 0.1, 0.1, 0.5, nan, nan};
  abflat_mesh arrays = arraysOf(mesh);
  arrays.texcoords = texcoords.data();
  const Verified found(arrays);
  REQUIRE(found.status == 0);
  CHECK(abflat_is_valid(found.result) == 0);
  std::size_t islands = 0, triangles = 0, vertices = 1;
  const std::uint32_t* const ofTriangle = abflat_charts(found.result, &islands);
  CHECK(copied(ofTriangle, islands) == std::vector<std::uint32_t>{0, 1, kNoIsland});
  const std::uint8_t* const faults = abflat_faults(found.result, &triangles);
  CHECK(copied(faults, triangles) == std::vector<std::uint8_t>{1, 1, 0});
  abflat_vertices(found.result, &vertices);
  CHECK(vertices == 0);
  const std::string report = abflat_report(found.result);
  CHECK(report.find("overlapBetween") != std::string::npos);
  CHECK(report.find("unmapped") != std::string::npos);

  const Options rules;
  REQUIRE(abflat_set_rule(rules.all, "allowOverlaps", "true") == 0);
  REQUIRE(abflat_set_rule(rules.all, "--allow-unmapped", "true") == 0);
  REQUIRE(abflat_set_rule(rules.all, "maxStretch", "none") == 0);
  CHECK(abflat_is_valid(Verified(arrays, rules.all).result) == 1);
  // An option of the same name is another.
  REQUIRE(rules.set("padding", "99") == 0);
  REQUIRE(rules.set("maxStretch", "1.2") == 0);
  CHECK(abflat_is_valid(Verified(arrays, rules.all).result) == 1);
  CHECK(abflat_set_rule(rules.all, "padding", "wide") ==
        static_cast<int>(StatusCode::InvalidOption));
  CHECK(std::string(abflat_option_message(rules.all)).find("padding cannot be") == 0);
  CHECK(abflat_set_rule(rules.all, "rotate", "none") ==
        static_cast<int>(StatusCode::InvalidOption));
  CHECK(std::string(abflat_option_message(rules.all)) == "there is no rule rotate");
}

TEST_CASE("verifying a mesh without texcoords, and cancelling it, are errors", "[c]") {
  const PolygonMesh mesh = uvSphere(6, 4);
  const Verified bare(arraysOf(mesh));
  CHECK(bare.status == static_cast<int>(StatusCode::NoTexcoords));
  CHECK_FALSE(std::string(abflat_message(bare.result)).empty());
  abflat_mesh arrays = arraysOf(mesh);
  const std::vector<double> texcoords(2 * mesh.vertexCount(), 0.5);
  arrays.texcoords = texcoords.data();
  const Verified stopped(arrays, nullptr, [](const char*, double, void*) { return 0; });
  CHECK(stopped.status == static_cast<int>(StatusCode::Aborted));
}
