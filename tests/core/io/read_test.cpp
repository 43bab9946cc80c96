#include <cmath>
#include <cstring>
#include <random>

#include "abflat/io.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Result<PolygonMesh> obj(const std::string& text) {
  return readMesh(text, MeshFormat::Obj, "a.obj");
}
Result<PolygonMesh> off(const std::string& text) {
  return readMesh(text, MeshFormat::Off, "a.off");
}

/// The message, which must begin with the place.
void checkError(const Result<PolygonMesh>& r, const std::string& place, const std::string& part) {
  INFO(r.status.message);
  CHECK(r.status.code == StatusCode::ParseError);
  CHECK(r.status.message.rfind(place, 0) == 0);
  CHECK(r.status.message.find(part) != std::string::npos);
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("OBJ: polygons, negative indices, comments, CRLF, joined lines and extra columns") {
  const Result<PolygonMesh> r =
      obj("\xEF\xBB\xBF# head\r\nmtllib a.mtl\r\nv 0 0 0 1 0.5 0.5 # colours\r\n  v +1 0 -0\r\nv "
          "1e0 1. .5\r\nv 0 1 0\r\n"
          "vt 0 0\r\nvn 0 0 1\r\ng left#side\r\nf 1 2/1 3//1 4/1/1\r\nf -4 \\\r\n -3 -1 # "
          "last\r\nl 1 2\r\nf 5 1 2\r\nv 5 5 5");
  INFO(r.status.message);
  REQUIRE(r.ok());
  CHECK(r.value.positions == std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0, 5, 5, 5});
  CHECK(r.value.faceOffsets == std::vector<std::uint32_t>{0, 4, 7, 10});
  CHECK(r.value.faceVertices == std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 3, 4, 0, 1});
}

TEST_CASE("OBJ: what is wrong is named with its line") {
  checkError(obj(""), "a.obj: ", "empty");
  checkError(obj("# nothing\n"), "a.obj: ", "no vertices");
  checkError(obj("v 0 0 0\nv 1 2"), "a.obj:2: ", "2 coordinates");
  checkError(obj("v 0 0 zero\n"), "a.obj:1: ", "'zero' is not a number");
  checkError(obj("v 0 0 1.5x\n"), "a.obj:1: ", "'1.5x' is not a number");
  checkError(obj("v 0 0 0\nv 0 nan 0\n"), "a.obj:2: ", "not finite");
  checkError(obj("v 0 0 -inf\n"), "a.obj:1: ", "not finite");
  checkError(obj("v 0 0 1e999\n"), "a.obj:1: ", "not finite");
  checkError(obj(kTriangle + "f 1 2\n"), "a.obj:4: ", "2 corners");
  checkError(obj(kTriangle + "\n\nf 1 2 4\n"), "a.obj:6: ", "vertex 4, but the file has 3");
  checkError(obj(kTriangle + "f 1 2 -4\n"), "a.obj:4: ", "vertex -4");
  checkError(obj(kTriangle + "f 0 1 2\n"), "a.obj:4: ", "counts from 1");
  for (const char* corner : {"x", "1/x", "1/2/3/4", "1//", "1/", "/1", "1.5"})
    checkError(obj(kTriangle + "f 2 3 " + corner + "\n"), "a.obj:4: ", "is not a face corner");
  CHECK(obj(kTriangle).ok());  // a point cloud is readable
}

TEST_CASE("OFF: headers, counts, extra columns and comments") {
  const std::string body = "0 0 0 255 0 0 255\n1 0 0 0 0 0 0 # x\n\n0 1 0 1 1 1 1\n3 0 1 2 9 9 9\n";
  for (const char* header : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "COFF\n# c\n3 1\n", "NOFF\r\n3 1 3\r\n",
                             "STOFF 3 1 0\n", "CNOFF\n3 1 0\n"}) {
    const Result<PolygonMesh> r = off(header + body);
    INFO(header << r.status.message);
    REQUIRE(r.ok());
    CHECK(r.value.positions == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0});
    CHECK(r.value.faceVertices == std::vector<std::uint32_t>{0, 1, 2});
  }
}

TEST_CASE("OFF: what is wrong is named with its line") {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  checkError(off(""), "a.off: ", "empty");
  checkError(off("PLY\n"), "a.off:1: ", "not an OFF file");
  checkError(off("OFF BINARY\n"), "a.off:1: ", "binary");
  checkError(off("OFF\n"), "a.off:1: ", "ends before the counts");
  checkError(off("OFF\n3 -1 0\n"), "a.off:2: ", "expected the numbers");
  checkError(off("OFF\nmany 1 0\n"), "a.off:2: ", "expected the numbers");
  checkError(off("OFF\n5 1 0\n" + vertices + "3 0 1 2\n"), "a.off:6: ", "ends after 4 vertices");
  checkError(off("OFF\n3 2 0\n" + vertices + "3 0 1 2\n"), "a.off:6: ", "ends after 1 faces");
  checkError(off("OFF\n4 1 0\n" + vertices + "3 0 1 2\n"), "a.off:6: ", "ends after 0 faces");
  checkError(off("OFF\n2 1 0\n" + vertices + "3 0 1 2\n"), "a.off:5: ", "0 corners");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 0 1 2\n"), "a.off:7: ", "goes on");
  checkError(off("OFF\n9000000000000000000 9000000000000000000 0\n" + vertices),
             "a.off:5: ", "ends after 3 vertices");
  checkError(off("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "a.off:4: ", "2 coordinates");
  checkError(off("OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n"), "a.off:4: ", "not finite");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 1 3\n"),
             "a.off:6: ", "vertex 3, but the file has 3");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 1\n"), "a.off:6: ", "2 of its 3 corners");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 -1 2\n"), "a.off:6: ", "vertex -1");
}

TEST_CASE("a file cut off anywhere is read or refused, never misread into something invalid") {
  const std::string whole[] = {writeObj(bumpyGrid(2, 2, 0.3, 1), {}, {}),
                               "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0.25\n0 1 0\n3 0 1 2\n3 0 2 3\n"};
  for (int format = 0; format < 2; ++format)
    for (std::size_t n = 0; n < whole[format].size(); ++n) {
      const Result<PolygonMesh> r =
          format == 0 ? obj(whole[0].substr(0, n)) : off(whole[1].substr(0, n));
      if (r.ok())
        CHECK(validateArrays(r.value).ok());
      else
        CHECK(r.status.code == StatusCode::ParseError);
    }
}

TEST_CASE("the format is told by the name, or else by the content") {
  CHECK(detectFormat("dir/A.OBJ", "").value == MeshFormat::Obj);
  CHECK(detectFormat("a.off", "v 0 0 0").value == MeshFormat::Off);
  CHECK(detectFormat("-", "# c\n COFF 1 2 3\n").value == MeshFormat::Off);
  CHECK(detectFormat("-", "# c\no thing\nv 0 0 0\n").value == MeshFormat::Obj);
  CHECK(detectFormat("a.stl", "solid x\n").status.code == StatusCode::UnreadableFile);
  CHECK(detectFormat("-", "").status.code == StatusCode::UnreadableFile);
}

TEST_CASE("arrays that contradict themselves are refused with the place") {
  PolygonMesh mesh = bumpyGrid(2, 2, 0.3, 1);
  CHECK(validateArrays(mesh).ok());
  PolygonMesh bad = mesh;
  bad.positions[7] = std::nan("");
  CHECK(validateArrays(bad).message.find("vertex 2 ") != std::string::npos);
  bad = mesh;
  bad.faceVertices[4] = 9;
  CHECK(validateArrays(bad).message.find("face 1 refers to vertex 9") != std::string::npos);
  bad = mesh;
  bad.faceOffsets[1] = 2;
  CHECK(validateArrays(bad).message.find("face 0 has fewer than 3") != std::string::npos);
  bad = mesh;
  bad.faceOffsets.back() += 1;
  CHECK_FALSE(validateArrays(bad).ok());
  bad = mesh;
  bad.positions.pop_back();
  CHECK_FALSE(validateArrays(bad).ok());
}
