#include "abflat/mesh_view.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "abflat/flatten.h"
#include "abflat/orient.h"
#include "abflat/unwrap.h"
#include "catch.h"
#include "support/instrumented.h"
#include "support/little_memory.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Records that begin at an odd address: some bytes of something else, then values.
template <class T>
class Interleaved {
 public:
  template <class From>
  explicit Interleaved(const std::vector<From>& values) : bytes_(values.size() / 3 * kStride + 1) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto value = static_cast<T>(values[i]);
      std::memcpy(bytes_.data() + offsetOf(i), &value, sizeof value);
    }
  }

  const T* first() const { return reinterpret_cast<const T*>(bytes_.data() + 1); }
  std::size_t count() const { return bytes_.size() / kStride; }

  static constexpr std::size_t kStride = 3 * sizeof(T) + 5;

 private:
  static std::size_t offsetOf(std::size_t i) { return 1 + i / 3 * kStride + i % 3 * sizeof(T); }

  std::vector<char> bytes_;
};

MeshView viewOf(const PolygonMesh& mesh) {
  return {{mesh.positions.data(), mesh.vertexCount()},
          {mesh.faceVertices.data(), mesh.faceCount()}};
}

PolygonMesh inSinglePrecision(PolygonMesh mesh) {
  for (double& x : mesh.positions) x = static_cast<float>(x);
  return mesh;
}

void checkSame(const Result<UnwrapResult>& a, const Result<UnwrapResult>& b) {
  REQUIRE(a.ok());
  REQUIRE(b.ok());
  CHECK(a.value().uv == b.value().uv);
  CHECK(a.value().cornerUv == b.value().cornerUv);
  CHECK(a.value().vertexMap == b.value().vertexMap);
  CHECK(a.value().triangles == b.value().triangles);
  CHECK(a.value().chartOfFace == b.value().chartOfFace);
}

template <class Number, class Index>
void checkTypes(const PolygonMesh& mesh, const Result<UnwrapResult>& expected) {
  const Interleaved<Number> positions(mesh.positions);
  const Interleaved<Index> triangles(mesh.faceVertices);
  const MeshView view = {{positions.first(), positions.count(), positions.kStride},
                         {triangles.first(), triangles.count(), triangles.kStride}};
  checkSame(unwrap(view, {}), expected);
}

}  // namespace

TEST_CASE("triangles in the caller's memory are unwrapped as the same mesh", "[mesh]") {
  const PolygonMesh mesh = inSinglePrecision(uvSphere(12, 8));
  const Result<UnwrapResult> expected = unwrap(mesh, {});
  checkTypes<float, std::uint16_t>(mesh, expected);
  checkTypes<float, std::int32_t>(mesh, expected);
  checkTypes<double, std::uint32_t>(mesh, expected);
  checkTypes<double, std::int64_t>(mesh, expected);
  checkTypes<double, std::size_t>(mesh, expected);

  PolygonMesh mixed = mesh;
  turnFaces({1, 7, 30}, mixed);
  UnwrapOptions options;
  options.orient = true;
  checkSame(unwrap(viewOf(mixed), options), unwrap(mixed, options));
  options.stack = Stack::Identical;
  checkSame(unwrap(viewOf(mesh), options), unwrap(mesh, options));
}

TEST_CASE("triangles in the caller's memory are flattened as the same mesh", "[mesh]") {
  const PolygonMesh mesh = bumpyGrid(8, 6, 0.5, 3);
  FlattenOptions options;
  options.pins = {{0, {0, 0}}, {8, {2, 1}}};
  const Result<FlattenResult> expected = flatten(mesh, options);
  const Result<FlattenResult> found = flatten(viewOf(mesh), options);
  REQUIRE(found.ok());
  CHECK(found.value().uv == expected.value().uv);
  CHECK(found.value().cornerUv == expected.value().cornerUv);
  CHECK(found.value().triangles == expected.value().triangles);
}

TEST_CASE("a view is checked like a mesh", "[mesh]") {
  PolygonMesh mesh = uvSphere(6, 4);
  const auto check = [&](const MeshView& view) {
    const std::string message = unwrap(mesh, {}).status().message;
    CHECK_FALSE(message.empty());
    CHECK(unwrap(view, {}).status().message == message);
    CHECK(flatten(view, {}).status().message == message);
  };
  mesh.faceVertices[7] = static_cast<std::uint32_t>(mesh.vertexCount());
  check(viewOf(mesh));
  mesh.faceVertices[7] = static_cast<std::uint32_t>(-1);
  const std::vector<std::int32_t> negative(mesh.faceVertices.begin(), mesh.faceVertices.end());
  check({viewOf(mesh).positions, {negative.data(), mesh.faceCount()}});
  mesh.faceVertices[7] = 0;
  mesh.positions[10] = std::numeric_limits<double>::infinity();
  check(viewOf(mesh));
  const MeshView none = {{mesh.positions.data(), 0}, {mesh.faceVertices.data(), 0}};
  CHECK(unwrap(none, {}).status().code == StatusCode::EmptyMesh);
  CHECK(flatten(none, {}).status().code == StatusCode::EmptyMesh);
}

TEST_CASE("a view is read where it is", "[mesh]") {
  const PolygonMesh mesh = bumpyGrid(cases(60u, 30u), 60, 0.5, 3);
  const std::size_t size = mesh.positions.size() * sizeof(double) +
                           (mesh.faceVertices.size() + mesh.faceOffsets.size()) * 4;
  UnwrapOptions options;
  options.threads = 1;
  const std::size_t ofMesh = mostBytesOf([&] { CHECK(unwrap(mesh, options).ok()); });
  const std::size_t ofView = mostBytesOf([&] { CHECK(unwrap(viewOf(mesh), options).ok()); });
  CAPTURE(size, ofMesh, ofView);
  CHECK(ofView < ofMesh + size / 4);
  FlattenOptions flat;
  flat.threads = 1;
  const std::size_t flatMesh = mostBytesOf([&] { CHECK(flatten(mesh, flat).ok()); });
  const std::size_t flatView = mostBytesOf([&] { CHECK(flatten(viewOf(mesh), flat).ok()); });
  CAPTURE(flatMesh, flatView);
  CHECK(flatView < flatMesh + size / 4);
}
