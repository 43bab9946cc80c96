#include <string>

#include "abflat/io.h"
#include "catch.h"
#include "io/format_functions.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

std::string inCapitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

}  // namespace

TEST_CASE("every ending is known, in any case, and by any name in front of it") {
  for (const MeshEnding& known : kMeshEndings)
    for (const std::string& ending : {std::string(known.ending), inCapitals(known.ending)}) {
      CAPTURE(ending);
      const Result<MeshFormat> format = detectFormat("folder/a.b" + ending, "");
      REQUIRE(format.ok());
      CHECK(format.value() == known.format);
    }
}

TEST_CASE("a format is written if the schema says how, and read back by name and by content") {
  const PolygonMesh mesh = bumpyGrid(3, 2, 0.3, 1);
  const std::vector<double> uv = {0, 0, 1, 0, 0, 1};
  const std::vector<std::uint32_t> cornerUv(mesh.faceVertices.size(), 1);
  for (int i = 0; i < kMeshFormatCount; ++i) {
    CAPTURE(i);
    const auto format = static_cast<MeshFormat>(i);
    const std::string file = writeMesh(format, mesh, uv, cornerUv);
    const bool isWritten = precisionOf(format) != Precision::None;
    CHECK(file.empty() == !isWritten);
    CHECK((i < kWrittenFormatCount) == isWritten);
    if (!isWritten) continue;
    CHECK(detectFormat("-", file).value() == format);
    const Result<PolygonMesh> again = readMesh(file, format, "a");
    REQUIRE(again.ok());
    CHECK(again.value().positions == mesh.positions);
    CHECK(again.value().faceVertices == mesh.faceVertices);
    // With the file as its source, it is the same again.
    CHECK(writeMesh(format, again.value(), uv, cornerUv, file) == file);
  }
}

TEST_CASE("a file that is no mesh is told which formats there are") {
  const Result<MeshFormat> format = detectFormat("notes.txt", "no mesh");
  CHECK(format.status().message == "notes.txt is not supported. Use OBJ, PLY, STL or OFF");
}
