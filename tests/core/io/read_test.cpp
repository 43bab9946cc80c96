#include <cmath>
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

/// Checks the message, which must begin with the place.
void checkError(const Result<PolygonMesh>& r, const std::string& place, const std::string& part) {
  INFO(r.status().message);
  CHECK(r.status().code == StatusCode::ParseError);
  CHECK(r.status().message.rfind(place, 0) == 0);
  CHECK(r.status().message.find(part) != std::string::npos);
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("OBJ: polygons, negative indices, comments, CRLF, joined lines and extra columns") {
  const Result<PolygonMesh> r =
      obj("\xEF\xBB\xBF# head\r\nmtllib a.mtl\r\nv 0 0 0 1 0.5 0.5 # colours\r\n  v +1 0 -0\r\nv "
          "1e0 1. .5\r\nv 0 1 0\r\n"
          "vt 0 0\r\nvn 0 0 1\r\ng left#side\r\nf 1 2/1 3//1 4/1/1\r\nf -4 \\\r\n -3 -1 # "
          "last\r\nl 1 2\r\nf 5 1 2\r\nv 5 5 5");
  INFO(r.status().message);
  REQUIRE(r.ok());
  CHECK(r.value().positions == std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0, 5, 5, 5});
  CHECK(r.value().faceOffsets == std::vector<std::uint32_t>{0, 4, 7, 10});
  CHECK(r.value().faceVertices == std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 3, 4, 0, 1});
}

TEST_CASE("OBJ: what is wrong is named with its line") {
  checkError(obj(""), "a.obj: ", "empty");
  checkError(obj("# nothing\n"), "a.obj ", "no mesh (no v or f lines)");
  checkError(obj("v 0 0 0\nv 1 2"), "a.obj:2: ", "2 coordinates");
  checkError(obj("v 0 0 zero\n"), "a.obj:1: ", "'zero' is not a number");
  checkError(obj("v 0 0 1.5x\n"), "a.obj:1: ", "'1.5x' is not a number");
  checkError(obj("v 0 0 0\nv 0 nan 0\n"), "a.obj:2: ", "not finite");
  checkError(obj("v 0 0 -inf\n"), "a.obj:1: ", "not finite");
  checkError(obj("v 0 0 1e999\n"), "a.obj:1: ", "not finite");
  checkError(obj(kTriangle + "f 1 2\n"), "a.obj:4: ", "2 corners");
  checkError(obj(kTriangle + "\n\nf 1 2 4\n"), "a.obj:6: ", "vertex 4, but the file has 3");
  checkError(obj(kTriangle + "f 1 2 -4\n"), "a.obj:4: ", "vertex -4");
  checkError(obj(kTriangle + "f 0 1 2\n"), "a.obj:4: ", "indices start at 1");
  for (const char* corner : {"x", "+-1", "1/x", "1/2/3/4", "1///", "/1", "//1", "1.5", "1;"})
    checkError(obj(kTriangle + "f 2 3 " + corner + "\n"), "a.obj:4: ", "is not a face corner");
  CHECK(obj(kTriangle).ok());  // a point cloud is readable
}

TEST_CASE("OBJ: comments and names that end in a backslash do not swallow the next line") {
  // With and without a comment after a vertex, which takes a different path through the reader.
  for (const std::string vertex : {"v 9 9 9\n", "v 9 9 9 # first\n"}) {
    const Result<PolygonMesh> r =
        obj("# from C:\\models\\\n" + vertex + "g C:\\a\\\n" + kTriangle + "usemtl b\\\nf 2 3 4\n");
    INFO(r.status().message);
    REQUIRE(r.ok());
    CHECK(r.value().vertexCount() == 4);
    CHECK(r.value().faceVertices == std::vector<std::uint32_t>{1, 2, 3});
  }
}

TEST_CASE("OBJ: a backslash does not swallow a record of its own") {
  const Result<PolygonMesh> r =
      obj("v 9 9 9 \\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0 \\\nf 1 2 3\nl 1/1 2/1 \\\n f 2 3 4\n");
  INFO(r.status().message);
  REQUIRE(r.ok());
  CHECK(r.value().vertexCount() == 4);
  CHECK(r.value().faceVertices == std::vector<std::uint32_t>{0, 1, 2, 1, 2, 3});
  checkError(obj(kTriangle + "f 1 2 3 \\\nf 3 2 1\n"), "a.obj:4: ", "is not a face corner");
}

TEST_CASE("line ends are \\n, \\r\\n or \\r") {
  const std::string texts[] = {"# c\n" + kTriangle + "f 1 \\\n2 3\ng x\nf 3 2 zz\n",
                               "# c\nOFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 zz 1\n"};
  const std::string places[] = {"a.obj:8: ", "a.off:8: "};
  for (int format = 0; format < 2; ++format)
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string text;
      for (const char c : texts[format]) text += c == '\n' ? end : std::string(1, c);
      INFO(format << " " << end.size());
      checkError(format == 0 ? obj(text) : off(text), places[format], "'zz'");
      text.replace(text.find("zz"), 2, format == 0 ? "1" : "2");
      CHECK((format == 0 ? obj(text) : off(text)).value().faceCount() == 2);
      CHECK(detectFormat("-", text).value() == (format == 0 ? MeshFormat::Obj : MeshFormat::Off));
    }
}

TEST_CASE("messages quote any bytes as short printable text") {
  const std::string junk = "\x01\x1b[2J\xff" + std::string(100000, 'x');
  for (const Result<PolygonMesh>& r : {obj("v 0 0 " + junk), obj(kTriangle + "f 1 2 " + junk),
                                       off(junk), off("OFF\n1 1 0\n0 0 " + junk)}) {
    CHECK(r.status().code == StatusCode::ParseError);
    CHECK(r.status().message.size() < 150);
    for (const char c : r.status().message) CHECK((c >= ' ' && c <= '~'));
  }
}

TEST_CASE("OFF: headers, counts, extra columns and comments") {
  const std::string body = "0 0 0 255 0 0 255\n1 0 0 0 0 0 0 # x\n\n0 1 0 1 1 1 1\n3 0 1 2 9 9 9\n";
  for (const char* header : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "COFF\n# c\n3 1\n", "NOFF\r\n3 1 3\r\n",
                             "STOFF 3 1 0\n", "CNOFF\n3 1 0\n"}) {
    const Result<PolygonMesh> r = off(header + body);
    INFO(header << r.status().message);
    REQUIRE(r.ok());
    CHECK(r.value().positions == std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0});
    CHECK(r.value().faceVertices == std::vector<std::uint32_t>{0, 1, 2});
  }
}

TEST_CASE("OFF: what is wrong is named with its line") {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  checkError(off(""), "a.off: ", "empty");
  checkError(off("PLY\n"), "a.off:1: ", "not an OFF file");
  checkError(off("OFF BINARY\n"), "a.off: ", "ends before");
  checkError(off("OFF\n"), "a.off:1: ", "ends before the vertex and face counts");
  checkError(off("OFF\n3 -1 0\n"), "a.off:2: ", "expected the vertex and face counts");
  checkError(off("OFF\nmany 1 0\n"), "a.off:2: ", "expected the vertex and face counts");
  checkError(off("OFF\n5 1 0\n" + vertices + "3 0 1 2\n"), "a.off:6: ", "ends after 4 vertices");
  checkError(off("OFF\n3 2 0\n" + vertices + "3 0 1 2\n"),
             "a.off:6: ", "2 faces, but the file ends after 1 face");
  checkError(off("OFF\n4 1 0\n" + vertices + "3 0 1 2\n"), "a.off:6: ", "ends after 0 faces");
  checkError(off("OFF\n2 1 0\n" + vertices + "3 0 1 2\n"), "a.off:5: ", "0 corners");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 1 2\n3 0 1 2\n"),
             "a.off:7: ", "3 vertices and 1 face, but there is another face");
  checkError(off("OFF\n9000000000000000000 9000000000000000000 0\n" + vertices),
             "a.off:5: ", "ends after 3 vertices");
  checkError(off("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "a.off:4: ", "2 coordinates");
  checkError(off("OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n"), "a.off:4: ", "not finite");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 1 3\n"),
             "a.off:6: ", "vertex 3, but the file has 3");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 1\n"), "a.off:6: ", "2 of its 3 corners");
  checkError(off("OFF\n3 1 0\n" + vertices + "3 0 -1 2\n"), "a.off:6: ", "vertex -1");
}

TEST_CASE("OFF: remarks behind the last face are ignored") {
  const std::string whole = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* rest :
       {"\n\n", "# end\n", "END\n", "\x1a", "2 0 1\n", "made by hand", "3 0 1 by hand"}) {
    const Result<PolygonMesh> r = off(whole + rest);
    CHECK(r.ok());
    CHECK(r.value().faceCount() == 1);
    CHECK(r.value().faceVertices.size() == 3);
  }
}

namespace {

/// Everything an OBJ file can contain, in little space.
const std::string kRichObj =
    "\xEF\xBB\xBF# a\\\r\nmtllib a.mtl\r\nv 0 0 0 1 0 0 # red\r\nv 1e0 +0 -.5\r\nv 1 \\\r\n1 "
    "0\r\nv "
    "0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\ng a b\r\nf 1/1/1 2//1 -2/1 \\\r\n 4\r\nl 1/1 2/1\r\nf 1 2 -1";
const std::string kRichOff =
    "CNOFF # a\n5 3 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0\n1 1 0.25\n0 1 -1e-3\n# b\n2 2 2\n3 0 1 2 255 0 "
    "0\n"
    "3 0 2 3\n4 0 1 2 4\nend";

/// Whether a text is either read into a consistent mesh or rejected as it should be.
bool isReadOrRefused(const std::string& text, bool isObj) {
  const Result<PolygonMesh> r = isObj ? obj(text) : off(text);
  return r.ok() ? validateArrays(r.value()).ok() : r.status().code == StatusCode::ParseError;
}

}  // namespace

TEST_CASE("a damaged file is read or refused, never misread into something invalid") {
  REQUIRE(obj(kRichObj).ok());
  REQUIRE(off(kRichOff).ok());
  std::mt19937_64 random(1);
  const std::string bytes = "\\\r\n\t #/+-.0123456789efvlOnaix\xff";
  for (const bool isObj : {true, false}) {
    const std::string& whole = isObj ? kRichObj : kRichOff;
    for (std::size_t n = 0; n <= whole.size(); ++n)
      CHECK(isReadOrRefused(whole.substr(0, n), isObj));
    std::size_t refused = 0, bad = 0;
    for (int i = 0; i < 20000; ++i) {
      std::string text = whole;
      for (std::size_t k = 1 + random() % 4; k > 0; --k) {
        const std::size_t at = random() % text.size();
        const std::size_t what = random() % 4;
        if (what == 0) text[at] = bytes[random() % bytes.size()];
        if (what == 1) text.insert(at, 1, bytes[random() % bytes.size()]);
        if (what == 2 && text.size() > 16) text.erase(at, 1 + random() % 8);
        if (what == 3) text.insert(at, 1, '\0');
      }
      refused += !(isObj ? obj(text) : off(text)).ok();
      bad += !isReadOrRefused(text, isObj);
    }
    CHECK(bad == 0);
    CHECK(refused > 1000);
    CHECK(refused < 19000);
  }
}

TEST_CASE("the format is told by the name, or else by the content") {
  CHECK(detectFormat("dir/A.OBJ", "").value() == MeshFormat::Obj);
  CHECK(detectFormat("a.off", "v 0 0 0").value() == MeshFormat::Off);
  CHECK(detectFormat("-", "# c\n COFF 1 2 3\n").value() == MeshFormat::Off);
  CHECK(detectFormat("-", "# c\no thing\nv 0 0 0\n").value() == MeshFormat::Obj);
  CHECK(detectFormat("a.glb", "glTF").status().code == StatusCode::UnreadableFile);
  CHECK(detectFormat("-", "").status().code == StatusCode::UnreadableFile);
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

TEST_CASE(
    "OBJ: texcoords of corners and materials of faces are kept; unusable texcoords are none") {
  const std::uint32_t no = kNoTexcoord;
  const Result<PolygonMesh> r =
      obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nvt 0.5 0.25 0\nvt 1 # c\nvt nan 0\nvt a b\n"
          "usemtl red\nf 2/1 4/2 3/3\nf 2/4/1 4/-3 3/9\nusemtl a b#c\nf 1//1 2/5 3\nusemtl red\n"
          "f 1 2 3\nvt 7 \\\n 8\n");
  INFO(r.status().message);
  REQUIRE(r.ok());
  CHECK(r.value().faceTexcoords ==
        std::vector<std::uint32_t>{no, no, no, 0, 1, no, no, 1, no, no, 4, no, no, no, no});
  CHECK(r.value().texcoords[0] == 0.5);
  CHECK(r.value().texcoords[1] == 0.25);
  CHECK(r.value().texcoords[2] == 1);
  CHECK(r.value().texcoords[3] == 0);
  CHECK(r.value().texcoords[9] == 8);
  CHECK(r.value().faceMaterials == std::vector<std::uint32_t>{0, 1, 1, 2, 1});
  CHECK(r.value().materialNames == std::vector<std::string>{"", "red", "a b#c"});
  CHECK(validateArrays(r.value()).ok());
  const Result<PolygonMesh> none = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3/2\n");
  REQUIRE(none.ok());
  CHECK(none.value().texcoords.empty());
  CHECK(none.value().faceTexcoords.empty());
  CHECK(none.value().faceMaterials.empty());
}

TEST_CASE("OBJ: normals of corners, and what counts as none") {
  const std::uint32_t no = kNoNormal;
  const Result<PolygonMesh> r =
      obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nvn 0 0 1\nvn 1 2 # c\nvn nan 0 1\n"
          "vn 0 0 0\nvn 0 .5 2e-3 7\nf 2//1 4//2 3//3\nf 2/1/4 1/9/-1 3//9\nf 1//-9 2//6 3/1\n"
          "vn 9 8 7\n");
  INFO(r.status().message);
  REQUIRE(r.ok());
  CHECK(r.value().faceNormals ==
        std::vector<std::uint32_t>{no, no, no, 0, no, no, no, 4, no, no, 5, no});
  CHECK(r.value().normals[13] == 0.5);
  CHECK(r.value().normals[14] == 2e-3);
  CHECK(r.value().normals[17] == 7);
  CHECK(validateArrays(r.value()).ok());
  const Result<PolygonMesh> none = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//2\n");
  REQUIRE(none.ok());
  CHECK(none.value().normals.empty());
  CHECK(none.value().faceNormals.empty());
}

TEST_CASE("OBJ: smoothing groups, unless there are normals") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
  const auto groups = [&](const std::string& text) {
    const Result<PolygonMesh> r = obj(points + text);
    REQUIRE(r.ok());
    CHECK(validateArrays(r.value()).ok());
    return r.value().faceSmoothing;
  };
  using Groups = std::vector<std::uint32_t>;
  const std::string f = "f 1 2 3\n";
  CHECK(groups(f).empty());
  CHECK(groups("s off\n" + f) == Groups{0});
  CHECK(groups(f + "s 3 # c\n" + f + "s off\n" + f + "s 4294967295\n" + f + "s 12\r\n" + f) ==
        Groups{0, 3, 0, 0, 12});
  CHECK(groups(f + "s 1\n" + f) == Groups{0, 1});
  CHECK(groups("s 1\n" + f + "s 0\n") == Groups{1});
  CHECK(groups("s 1\n" + f + "f 1//1 2//1 3//1\n").empty());
}

TEST_CASE("what does not fit a mesh beside its faces is named") {
  PolygonMesh mesh = makeTriangleMesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2});
  mesh.texcoords = {0, 0};
  mesh.faceTexcoords = {0, kNoTexcoord, 0};
  mesh.faceMaterials = {7};
  mesh.normals = {0, 0, 1};
  mesh.faceNormals = {kNoNormal, 0, 0};
  mesh.faceSmoothing = {7};
  CHECK(validateArrays(mesh).ok());
  const auto message = [&](auto&& damage) {
    PolygonMesh damaged = mesh;
    damage(damaged);
    const Status s = validateArrays(damaged);
    CHECK(s.code == StatusCode::InvalidMesh);
    return s.message;
  };
  const auto says = [](const std::string& text, const char* part) {
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  says(message([](PolygonMesh& m) { m.faceTexcoords[2] = 1; }), "corner 2 refers");
  says(message([](PolygonMesh& m) { m.faceTexcoords.pop_back(); }), "every face corner");
  says(message([](PolygonMesh& m) { m.texcoords.pop_back(); }), "multiple of 2");
  says(message([](PolygonMesh& m) { m.faceNormals[1] = 1; }), "corner 1 refers to normal 1");
  says(message([](PolygonMesh& m) { m.faceNormals.pop_back(); }), "needs one normal");
  says(message([](PolygonMesh& m) { m.normals.pop_back(); }), "multiple of 3");
  says(message([](PolygonMesh& m) { m.faceSmoothing.push_back(0); }), "smoothing group");
  says(message([](PolygonMesh& m) { m.faceMaterials.push_back(0); }), "material");
}
