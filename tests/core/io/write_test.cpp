#include <cmath>
#include <cstring>
#include <random>

#include "abflat/io.h"
#include "catch.h"
#include "io/number_text.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("doubles survive being written and read") {
  std::mt19937_64 random(1);
  std::vector<double> values{0.0,          -0.0, 1, 0.1, 1e22, 5e-324, 1.7976931348623157e308,
                             123456789.125};
  while (values.size() < 20000) {
    const std::uint64_t bits = random();
    double d;
    std::memcpy(&d, &bits, sizeof d);
    if (std::isfinite(d)) values.push_back(d);
  }
  for (const double d : values) {
    std::string text;
    appendDouble(text, d);
    double back = 1;
    REQUIRE(parseDouble(text, back));
    CHECK(std::memcmp(&back, &d, sizeof d) == 0);
  }
  std::string text;
  appendDouble(text, 0.1);
  CHECK(text == "0.1");
}

TEST_CASE("a mesh without source text is written completely") {
  const PolygonMesh mesh = renumbered(bumpyGrid(5, 4, 0.3, 1), 2).mesh;
  const Result<PolygonMesh> back = readMesh(writeObj(mesh, {}, {}), MeshFormat::Obj, "a");
  REQUIRE(back.ok());
  CHECK(back.value.positions == mesh.positions);
  CHECK(back.value.faceOffsets == mesh.faceOffsets);
  CHECK(back.value.faceVertices == mesh.faceVertices);
}

TEST_CASE("everything but texcoords and faces is copied from the source text") {
  const std::string source =
      "# made by hand\nmtllib x.mtl\no thing\nv 0.10 0 0\nv 1 0 0\nv 1.000 1 0\nv 0 1 0\nvt 0.5 "
      "0.5\nvn 0 0 1\n"
      "usemtl skin\ns 1\nf 1/1/1 2/1/1 -2//1\ng rest # of it\nf 1 3 \\\n 4/1\n# end";
  const std::vector<double> uv{0, 0, 0.1, 0, 1, 1, 0, 2.5};
  CHECK(
      writeObj({}, uv, {0, 1, 2, 0, 2, 3}, source) ==
      "# made by hand\nmtllib x.mtl\no thing\nv 0.10 0 0\nv 1 0 0\nv 1.000 1 0\nv 0 1 0\nvn 0 0 1\n"
      "usemtl skin\ns 1\nvt 0 0\nvt 0.1 0\nvt 1 1\nvt 0 2.5\nf 1/1/1 2/2/1 -2/3/1\ng rest # of "
      "it\nf 1/1 3/3 4/4\n# end");
}

TEST_CASE("line ends of the source are kept") {
  const std::string source = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3";
  const std::string out = writeObj({}, {0, 0, 1, 0, 0, 1}, {0, 1, 2}, source);
  CHECK(out == "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvt 1 0\r\nvt 0 1\r\nf 1/1 2/2 3/3\r\n");
}
