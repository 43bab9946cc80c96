#include <algorithm>
#include <random>

#include "abflat/unwrap.h"
#include "catch.h"
#include "gltf/container.h"
#include "gltf/elements.h"
#include "gltf/merged_buffer.h"
#include "gltf/source.h"
#include "gltf/triangles.h"
#include "gltf/uri.h"
#include "gltf_files.h"
#include "support/instrumented.h"

namespace abflat {
namespace {

using test::octahedronGlb;
using test::readAlone;

/// The file with an atlas, written and read again.
GltfModel unwrappedAgain(const GltfModel& model, const GltfWriteOptions& options = {}) {
  UnwrapOptions wanted;
  wanted.precision = Precision::Gltf;
  const Result<UnwrapResult> result = unwrap(model.mesh, wanted);
  REQUIRE(result.ok());
  const Result<std::string> bytes =
      writeGltf(*model.source, result.value().uv, result.value().cornerUv, options);
  REQUIRE(bytes.ok());
  Result<GltfModel> again = readAlone(bytes.value());
  REQUIRE(again.status().message.empty());
  return again.value();
}

TEST_CASE("base64 gives the same bytes back", "[gltf]") {
  std::string bytes;
  for (int size = 0; size < 70; ++size) {
    const Result<std::string> back = gltf::dataOf(gltf::dataUri(bytes));
    CHECK(back.ok());
    CHECK(back.value() == bytes);
    bytes.push_back(static_cast<char>(37 * size));
  }
  CHECK_FALSE(gltf::dataOf("data:;base64,ab!c").ok());
  CHECK_FALSE(gltf::dataOf("data:nothing").ok());
}

TEST_CASE("paths survive as URIs", "[gltf]") {
  for (const std::string path : {"a.bin", "../a b/100%.png", "\xC3\xA4#?.bin"})
    CHECK(gltf::pathOfUri(gltf::uriOfPath(path)) == path);
  CHECK(gltf::pathOfUri("50%") == "50%");
  CHECK(gltf::hasScheme("https://a/b"));
  CHECK_FALSE(gltf::hasScheme("a/b:c"));
}

TEST_CASE("strips and fans have the triangles that the specification says", "[gltf]") {
  using Vertices = std::vector<std::uint32_t>;
  const Vertices v = {5, 6, 7, 8, 9};
  CHECK(gltf::asTriangles(gltf::Mode::TriangleStrip, v) == Vertices{5, 6, 7, 6, 8, 7, 7, 8, 9});
  CHECK(gltf::asTriangles(gltf::Mode::TriangleFan, v) == Vertices{6, 7, 5, 7, 8, 5, 8, 9, 5});
  CHECK(gltf::asTriangles(gltf::Mode::Triangles, v) == Vertices{5, 6, 7});
}

TEST_CASE("a GLB is read with its transform, strides and sparse values", "[gltf]") {
  const Result<GltfModel> model = readAlone(octahedronGlb());
  REQUIRE(model.ok());
  CHECK(model.value().mesh.vertexCount() == 6);
  CHECK(model.value().mesh.faceCount() == 8);
  const gltf::Document& document = model.value().source->document;
  CHECK(gltf::numbersOf(document, document.accessors[2])[3] == 40 / 255.0);
  const std::vector<double> target = gltf::numbersOf(document, document.accessors[3]);
  CHECK(target == std::vector<double>{0, 0, 0, 5, 6, 7, 0, 0, 0, 0, 0, 0, 8, 9, 10, 0, 0, 0});
}

TEST_CASE("meshes of a file are objects, until their vertices are joined", "[gltf]") {
  CHECK(readAlone(octahedronGlb()).value().mesh.vertexObjects.empty());
  PolygonMesh mesh = readAlone(octahedronGlb(2)).value().mesh;
  CHECK(mesh.vertexObjects == std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
  CHECK(unwrap(mesh, {}).value().report.repair.mergedVertices == 0);
  CHECK(joinVertices(mesh) == 6);
  CHECK(mesh.vertexObjects.empty());
}

TEST_CASE("written vertices repeat all attributes and morph targets", "[gltf]") {
  const GltfModel before = readAlone(octahedronGlb()).value();
  for (const bool isBinary : {true, false}) {
    GltfWriteOptions options;
    options.isBinary = isBinary;
    options.texcoord = 1;
    const GltfModel after = unwrappedAgain(before, options);
    REQUIRE(after.mesh.faceCount() == before.mesh.faceCount());
    REQUIRE(after.mesh.vertexCount() > before.mesh.vertexCount());
    const gltf::Document &was = before.source->document, &is = after.source->document;
    const gltf::Primitive& primitive = is.meshes[0][0];
    // Without set 0 there cannot be a set 1.
    const std::size_t texcoord = gltf::accessorNamed(primitive.attributes, "TEXCOORD_1");
    CHECK(texcoord == gltf::accessorNamed(primitive.attributes, "TEXCOORD_0"));
    CHECK(is.accessors[texcoord].count == after.mesh.vertexCount());
    CHECK(is.accessors[primitive.targets[0][0].second].sparse);
    for (const std::size_t accessor : {std::size_t{0}, std::size_t{2}, std::size_t{3}}) {
      const std::string a = gltf::elementsOf(was, was.accessors[accessor]);
      const std::string b = gltf::elementsOf(is, is.accessors[accessor]);
      const std::size_t size = was.accessors[accessor].shape.size();
      CHECK(b.substr(0, a.size()) == a);
      for (std::size_t c = 0; c < before.mesh.faceVertices.size(); ++c)
        CHECK(a.substr(before.mesh.faceVertices[c] * size, size) ==
              b.substr(after.mesh.faceVertices[c] * size, size));
    }
  }
}

TEST_CASE("texcoords of a file are exactly those that were checked", "[gltf]") {
  const GltfModel model = readAlone(octahedronGlb()).value();
  UnwrapOptions options;
  options.precision = Precision::Gltf;
  const UnwrapResult result = unwrap(model.mesh, options).value();
  REQUIRE(result.report.valid);
  const std::string bytes =
      writeGltf(*model.source, result.uv, result.cornerUv, GltfWriteOptions()).value();
  const PolygonMesh again = readAlone(bytes).value().mesh;
  for (std::size_t c = 0; c < result.cornerUv.size(); ++c)
    for (std::size_t d = 0; d < 2; ++d)
      CHECK(again.texcoords[2 * again.faceTexcoords[c] + d] ==
            result.uv[2 * result.cornerUv[c] + d]);
}

TEST_CASE("a merged buffer keeps what is used, and its alignment", "[gltf]") {
  gltf::Document document;
  document.buffers = {"0123456789abcdefghijklmnopqrstuvwxyz", "ABCDEFGHIJ"};
  document.views = {{0, 0, 9, 0}, {0, 6, 12, 0}, {0, 20, 10, 0}, {1, 3, 4, 0}};
  for (std::size_t left = 0; left < 16; ++left) {
    std::vector<bool> isLeft;
    for (std::size_t v = 0; v < 4; ++v) isLeft.push_back((left >> v & 1) != 0);
    const gltf::MergedBuffer merged(document, isLeft);
    for (std::size_t v = 0; v < 4; ++v) {
      if (isLeft[v]) continue;
      const gltf::BufferView& view = document.views[v];
      const std::size_t offset = merged.offsetOf(view);
      CHECK(merged.bytes().substr(offset, view.length) == document.viewBytes(v));
      CHECK(offset % 8 == view.offset % 8);
    }
  }
  CHECK(gltf::MergedBuffer(document, {true, true, true, true}).bytes().empty());
}

/// The error from reading this JSON with a buffer of that many zero bytes.
std::string errorOf(const std::string& json, std::size_t bufferSize) {
  return readAlone(test::glbOf(json, std::string(bufferSize, '\0'))).status().message;
}

/// JSON with an accessor that has no view, and these entries besides its type.
std::string withoutView(const std::string& entries) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": {SIZE}}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"componentType": 5126, "type": "VEC3", )" +
         entries + R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})";
}

TEST_CASE("a file gets no more elements than it has bytes without paying for them", "[gltf]") {
  const std::string refused = "a.glb: accessors[0] declares ";
  for (const std::string count : {"600000000", "9007199254740991", "1e15", "4294967296"}) {
    CHECK(errorOf(withoutView("\"count\": " + count), 36).substr(0, refused.size()) == refused);
    const std::string sparse = R"("sparse": {"count": 1, "indices": {"bufferView": 0,
      "componentType": 5125}, "values": {"bufferView": 0}}, "count": )";
    CHECK(errorOf(withoutView(sparse + count), 36).substr(0, refused.size()) == refused);
  }
  for (const std::string count :
       {"-1", "0.5", "1e400", "-1e300", "9007199254740993", "\"3\"", "[]"})
    CHECK(errorOf(withoutView("\"count\": " + count), 36).substr(0, 7) == "a.glb: ");
  CHECK(errorOf(withoutView("\"count\": 9"), 36).empty());
}

TEST_CASE("meshes that share bytes do not multiply them without end", "[gltf]") {
  constexpr std::size_t kVertices = 3000;
  const auto shared = [&](std::size_t meshes, const std::string& primitive) {
    std::string json = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": {SIZE}}],
      "bufferViews": [{"buffer": 0, "byteLength": 36000}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3000, "type": "VEC3"},
        {"bufferView": 0, "componentType": 5121, "count": 36000, "type": "SCALAR"}],
      "meshes": [)";
    for (std::size_t m = 0; m < meshes; ++m)
      json += std::string(m == 0 ? "" : ",") + R"({"primitives": [{"attributes": {"POSITION": 0})" +
              primitive + "}]}";
    return errorOf(json + "]}", 12 * kVertices);
  };
  CHECK(shared(50, "").empty());
  const std::string refused = "too many meshes share the same data";
  for (const std::string primitive : {"", ",\"indices\": 1", ",\"indices\": 1, \"mode\": 5",
                                      ",\"targets\": [{\"POSITION\": 0}]"}) {
    const std::string error = shared(1500, primitive);
    CHECK(error.find(refused) != std::string::npos);
  }
}

// Both would take minutes if each one were compared with, or moved for, all others.
TEST_CASE("many keys of an object are refused, many meshes are read", "[gltf]") {
  constexpr std::size_t kCount = test::cases<std::size_t>(300000, 30000);
  std::string keys, meshes;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::string comma = i == 0 ? "" : ",";
    keys += comma + "\"k" + std::to_string(i) + "\":0";
    meshes += comma + R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  }
  const std::string head = R"({"asset": {"version": "2.0"}, )";
  CHECK(readAlone(head + "\"extras\": {" + keys + "}}").status().message ==
        "a.glb: the JSON has an object of more than 4096 entries");
  const Result<GltfModel> model = readAlone(test::glbOf(
      head +
          R"("buffers": [{"byteLength": {SIZE}}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [)" +
          meshes + "]}",
      std::string(36, '\0')));
  CHECK(model.status().message.empty());
  CHECK(model.value().mesh.faceCount() == kCount);
}

// A file may contain anything: either it is read, or a sentence names it.
TEST_CASE("damaged files are refused or read, never more", "[gltf]") {
  const std::string good = octahedronGlb();
  std::mt19937 random(1);
  const auto tryIt = [](const std::string& bytes) {
    const Result<GltfModel> model = readAlone(bytes);
    if (!model.ok()) {
      CHECK(model.status().message.substr(0, 7) == "a.glb: ");
      return;
    }
    const std::size_t corners = model.value().mesh.faceVertices.size();
    std::vector<std::uint32_t> cornerUv(corners);
    for (std::size_t c = 0; c < corners; ++c) cornerUv[c] = static_cast<std::uint32_t>(c % 3);
    CHECK(writeGltf(*model.value().source, {0, 0, 1, 0, 0, 1}, cornerUv, GltfWriteOptions()).ok());
  };
  for (std::size_t size = 0; size < good.size(); ++size) tryIt(good.substr(0, size));
  for (int i = 0; i < 4000; ++i) {
    std::string bytes = good;
    const std::size_t flips = 1 + random() % 3;
    for (std::size_t k = 0; k < flips; ++k) {
      char& c = bytes[random() % bytes.size()];
      c = random() % 2 == 0 ? static_cast<char>(random()) : static_cast<char>('0' + random() % 10);
    }
    tryIt(bytes);
  }
  tryIt(std::string(100000, '['));
  tryIt("{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[{}]}]}");
}

}  // namespace
}  // namespace abflat
