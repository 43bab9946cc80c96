#include <cmath>
#include <random>

#include "abflat/io.h"
#include "catch.h"
#include "support/instrumented.h"
#include "support/ply_files.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Result<PolygonMesh> ply(const std::string& bytes) {
  return readMesh(bytes, MeshFormat::Ply, "a.ply");
}

void checkPlyError(const std::string& bytes, const std::string& place, const std::string& part) {
  const Result<PolygonMesh> r = ply(bytes);
  INFO(r.status().message);
  CHECK(r.status().code == StatusCode::ParseError);
  CHECK(r.status().message.rfind(place, 0) == 0);
  CHECK(r.status().message.find(part) != std::string::npos);
}

const std::vector<std::vector<double>> kPoints = {{0, 0, 0}, {2, 0, 0}, {2, 1.5, 0.25}, {0, 1, 0}};
const std::vector<double> kPositions = {0, 0, 0, 2, 0, 0, 2, 1.5, 0.25, 0, 1, 0};

PlyTestElement vertices() { return {"vertex", {"float x", "float y", "float z"}, kPoints}; }
PlyTestElement faces() {
  return {"face", {"list uchar int vertex_indices"}, {{4, 0, 1, 2, 3}, {3, 2, 1, 0}}};
}

void checkQuadAndTriangle(const Result<PolygonMesh>& r) {
  INFO(r.status().message);
  REQUIRE(r.ok());
  CHECK(r.value().positions == kPositions);
  CHECK(r.value().faceOffsets == std::vector<std::uint32_t>{0, 4, 7});
  CHECK(r.value().faceVertices == std::vector<std::uint32_t>{0, 1, 2, 3, 2, 1, 0});
}

/// All kinds of lists on vertices and faces, unknown elements, a permuted order.
std::vector<PlyTestElement> richElements() {
  PlyTestElement v{
      "vertex",
      {"uchar red", "double z", "list ushort short links", "float y", "int x", "double weight"},
      {}};
  for (const std::vector<double>& p : kPoints)
    v.rows.push_back({200, p[2], 2, -5, 7, p[1], p[0], 0.1});
  const PlyTestElement f{
      "face",
      {"list char float texcoord", "uchar flags", "list uint ushort vertex_index", "float area"},
      {{2, 0.5, 0.5, 1, 4, 0, 1, 2, 3, 9.5}, {0, 255, 3, 2, 1, 0, 1}}};
  return {{"camera", {"float a", "list int double b"}, {{1, 3, 1, 2, 3}, {2, 0}}},
          f,
          {"empty", {}, {}},
          v,
          {"edge", {"int vertex1", "int vertex2"}, {{0, 1}, {1, 2}}}};
}

}  // namespace

TEST_CASE("PLY: all encodings, line ends and types of numbers", "[ply]") {
  for (const std::string& format : kPlyFormats)
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      INFO(format << " " << end.size());
      checkQuadAndTriangle(ply(plyFile(format, {vertices(), faces()}, end)));
      checkQuadAndTriangle(ply(plyFile(format, {faces(), vertices()}, end)));
      checkQuadAndTriangle(ply(plyFile(format, richElements(), end)));
      PlyTestElement coloured = faces();
      coloured.properties = {"int id", coloured.properties[0], "uchar red", "float area"};
      for (std::vector<double>& row : coloured.rows) {
        row.insert(row.begin(), -7);
        row.insert(row.end(), {255, 0.5});
      }
      checkQuadAndTriangle(ply(plyFile(format, {vertices(), coloured}, end)));
    }
  for (const char* count : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double",
                            "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32"})
    for (const char* index : {"char", "uint8", "short", "uint16", "int", "uint32", "float"})
      for (const std::string& format : kPlyFormats) {
        PlyTestElement f = faces();
        f.properties = {std::string("list ") + count + " " + index + " vertex_index"};
        checkQuadAndTriangle(ply(plyFile(format, {vertices(), f})));
      }
}

TEST_CASE("PLY: binary data may begin with a byte that ends lines", "[ply]") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const PlyTestElement first{"first", {"uchar a", "uchar b"}, {{10, 13}}};
    checkQuadAndTriangle(ply(plyFile("binary_big_endian", {first, vertices(), faces()}, end)));
  }
}

TEST_CASE("PLY: a point cloud, a blank line, padding and a byte order mark are harmless", "[ply]") {
  for (const std::string& format : kPlyFormats) {
    const Result<PolygonMesh> cloud = ply(plyFile(format, {vertices()}));
    REQUIRE(cloud.ok());
    CHECK(cloud.value().vertexCount() == 4);
    CHECK(cloud.value().faceCount() == 0);
    const std::string bytes = plyFile(format, {vertices(), faces()});
    checkQuadAndTriangle(ply(bytes + "\n"));
    checkQuadAndTriangle(ply("\xEF\xBB\xBF" + bytes));
  }
  std::string text = plyFile("ascii", {vertices(), faces()});
  text.replace(text.find("4 0 1 2 3"), 9, "\n  +4\t0.0 1 2 3");
  checkQuadAndTriangle(ply(text));
}

TEST_CASE("PLY: what is wrong in the header is named with its line", "[ply]") {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string xyz =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  checkPlyError("", "a.ply: ", "empty");
  checkPlyError("plyx\n", "a.ply:1: ", "not a PLY file");
  checkPlyError("ply\nformat text 1.0\n", "a.ply:2: ", "'text' is not ascii");
  checkPlyError("ply\nformat ascii 2.0\n", "a.ply:2: ", "version '2.0'");
  checkPlyError("ply\nelement vertex 1\nend_header\n", "a.ply:3: ", "no format");
  checkPlyError(start + "element vertex\n", "a.ply:3: ", "element NAME COUNT");
  checkPlyError(start + "element vertex -1\n", "a.ply:3: ", "element NAME COUNT");
  checkPlyError(start + "property float x\n", "a.ply:3: ", "before any element");
  checkPlyError(start + "element a 1\nproperty real x\n", "a.ply:4: ", "'real' is not a PLY type");
  checkPlyError(start + "element a 1\nproperty list real int x\n", "a.ply:4: ", "'real' is not");
  checkPlyError(start + "element a 1\nproperty float\n", "a.ply:4: ", "property TYPE NAME");
  checkPlyError(start + "element a 1\nelement a 2\n", "a.ply:4: ", "duplicate element 'a'");
  checkPlyError(start + "element a 1\nproperty int b\nproperty int b\n",
                "a.ply:5: ", "duplicate property 'b'");
  checkPlyError(start + "elements a 1\n", "a.ply:3: ", "'elements' is not format");
  checkPlyError(start + xyz, "a.ply:6: ", "has no end_header");
  checkPlyError(start + "element face 0\nend_header\n", "a.ply:4: ", "no element 'vertex'");
  checkPlyError(start + "element vertex 1\nproperty float x\nproperty list int int y\nend_header\n",
                "a.ply:6: ", "no scalar property 'y'");
  checkPlyError(start + xyz + "element face 1\nproperty int vertex_index\nend_header\n0 0 0\n3\n",
                "a.ply:9: ", "no list property 'vertex_indices'");
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  checkPlyError(start + xyz + "element face 0\nproperty list int int vertex_indices\n" + strips +
                    "end_header\n",
                "a.ply:11: ", "both 'face' and 'tristrips'");
  checkPlyError(start + xyz + "element tristrips 1\nproperty int vertex_indices\nend_header\n",
                "a.ply:9: ", "element 'tristrips' has no list property");
}

TEST_CASE("PLY: strips are read as triangles, and written as faces", "[ply]") {
  // The second strip goes on after a vertex that only leads there.
  const PlyTestElement strips{"tristrips",
                              {"uchar id", "list int int vertex_indices"},
                              {{7, 9, 0, 1, 3, 2, -1, 3, 2, 2, 1}, {8, 2, 0, 1}, {9, 0}}};
  const std::vector<std::uint32_t> triangles = {0, 1, 3, 3, 1, 2};
  PlyTestElement edges{"edge", {"int vertex1"}, {{3}, {1}}};
  for (const std::string& format : kPlyFormats)
    for (const std::string end : {"\n", "\r\n"})
      for (const auto& elements : {std::vector<PlyTestElement>{vertices(), strips, edges},
                                   std::vector<PlyTestElement>{strips, edges, vertices()}}) {
        INFO(format);
        const std::string bytes = plyFile(format, elements, end);
        const Result<PolygonMesh> r = ply(bytes);
        INFO(r.status().message);
        REQUIRE(r.ok());
        CHECK(r.value().positions == kPositions);
        CHECK(r.value().faceVertices == triangles);
        CHECK(r.value().faceOffsets == std::vector<std::uint32_t>{0, 3, 6});
        // A seam between the two triangles repeats two vertices.
        const std::vector<double> uv = {0, 0, 1, 0, 0, 1, 0.5, 1, 1, 0.5, 1, 1};
        const std::string written = writePly(r.value(), uv, {0, 1, 2, 3, 4, 5}, bytes);
        CHECK(written.find("tristrips") == std::string::npos);
        CHECK(written.find("element face 2") != std::string::npos);
        CHECK(written.find("element edge 2") != std::string::npos);
        const Result<PolygonMesh> again = ply(written);
        INFO(again.status().message);
        REQUIRE(again.ok());
        CHECK(again.value().vertexCount() == 6);
        for (std::size_t c = 0; c < triangles.size(); ++c) {
          const std::size_t v = again.value().faceVertices[c];
          for (std::size_t d = 0; d < 3; ++d)
            CHECK(again.value().positions[3 * v + d] == kPositions[3 * triangles[c] + d]);
          for (std::size_t d = 0; d < 2; ++d)
            CHECK(again.value().texcoords[2 * again.value().faceTexcoords[c] + d] == uv[2 * c + d]);
        }
      }
}

TEST_CASE("PLY: the entry of a strip that is no vertex is named", "[ply]") {
  const auto file = [](const std::string& format, std::vector<double> entries) {
    entries.insert(entries.begin(), static_cast<double>(entries.size()));
    return plyFile(format, {vertices(), {"tristrips", {"list int int vertex_indices"}, {entries}}});
  };
  for (const double wrong : {4.0, -2.0})
    for (const std::string& format : kPlyFormats) {
      const std::string number = std::to_string(static_cast<int>(wrong));
      checkPlyError(file(format, {0, 1, wrong, 2}), format == "ascii" ? "a.ply:16: " : "a.ply: tri",
                    "entry 2 of the strip is " + number + ", but the file has 4 vertices");
    }
  std::string cut = file("ascii", {0, 1, 2, 3});
  cut.resize(cut.size() - 3);
  checkPlyError(cut, "a.ply:16: ", "only 3 of its 4 entries");
}

// Comparing each name with all others would take minutes.
TEST_CASE("PLY: any number of properties and elements is taken, no name twice", "[ply]") {
  constexpr int kNames = cases(300000, 30000);
  std::string elements, properties, row;
  for (int i = 0; i < kNames; ++i) {
    elements += "element e" + std::to_string(i) + " 0\nproperty int x\n";
    properties += "property uchar p" + std::to_string(i) + "\n";
    row += " 1";
  }
  const std::string head = "ply\nformat ascii 1.0\n" + elements +
                           "element vertex 1\nproperty float x\nproperty float y\n"
                           "property float z\n" +
                           properties;
  const Result<PolygonMesh> r = ply(head + "end_header\n1 2 3" + row + "\n");
  INFO(r.status().message.substr(0, 200));
  REQUIRE(r.ok());
  CHECK(r.value().positions == std::vector<double>{1, 2, 3});
  const std::string line = "a.ply:" + std::to_string(3 * kNames + 7) + ":";
  checkPlyError(head + "property int p7\nend_header\n", line, "duplicate property 'p7'");
  checkPlyError(head + "element e7 0\nend_header\n", line, "duplicate element 'e7'");
}

TEST_CASE("PLY: what is wrong in a text is named with its line", "[ply]") {
  const std::string good = plyFile("ascii", {vertices(), faces()});
  const auto changed = [&](const std::string& what, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(what), what.size(), to);
  };
  checkPlyError(changed("2 1.5 0.25", "2 1.5 x"), "a.ply:14: ", "'x' is not a number");
  checkPlyError(changed("2 1.5 0.25", "2 1.5 nan"),
                "a.ply:14: ", "vertex 2 has the coordinate 'nan'");
  checkPlyError(changed("2 1.5 0.25", "2 -inf 0"),
                "a.ply:14: ", "vertex 2 has the coordinate '-inf'");
  checkPlyError(changed("2 1.5 0.25", "2 1.5"), "a.ply:14: ", "ends before 'z'");
  checkPlyError(changed("2 1.5 0.25", "2 1.5 0 7"), "a.ply:14: ", "more values");
  checkPlyError(changed("3 2 1 0", "2 2 1"), "a.ply:17: ", "2 corners");
  checkPlyError(changed("3 2 1 0", "-3 2 1 0"), "a.ply:17: ", "'-3' is not the length");
  checkPlyError(changed("3 2 1 0", "3 2 1"), "a.ply:17: ", "2 of its 3 corners");
  checkPlyError(changed("3 2 1 0", "3 2 1 4"), "a.ply:17: ", "vertex 4, but the file has 4");
  checkPlyError(changed("3 2 1 0", "3 2 1 -1"), "a.ply:17: ", "vertex -1");
  checkPlyError(changed("3 2 1 0", "3 2 1 0.5"), "a.ply:17: ", "'0.5' is not a vertex number");
  checkPlyError(changed("3 2 1 0\n", ""),
                "a.ply:16: ", "2 elements 'face', but the file ends after 1");
  checkPlyError(good + "3 0 1 2\n", "a.ply:18: ", "goes on after the last row");
  checkPlyError(changed("face 2", "face 4000000000"), "a.ply:17: ", "ends after 2");
  checkPlyError(changed("vertex 4", "vertex 4000000000"), "a.ply:16: ", "more values");
  checkPlyError(changed("vertex 4", "vertex 99999999999"), "a.ply:11: ", "4294967295 vertices");
}

TEST_CASE("PLY: what is wrong in binary data is named with its row and byte", "[ply]") {
  const std::string good = plyFile("binary_little_endian", {vertices(), faces()});
  const std::size_t body = good.find("end_header\n") + 11, face = body + 4 * 12;
  const auto changed = [&](std::size_t at, const std::string& to) {
    std::string bytes = good;
    return bytes.replace(at, to.size(), to);
  };
  const auto promising = [&](const std::string& what, const std::string& to) {
    std::string bytes = good;
    return bytes.replace(bytes.find(what), what.size(), to);
  };
  const auto place = [](const std::string& row, std::size_t byte) {
    return "a.ply: " + row + " (byte " + std::to_string(byte) + "): ";
  };
  const std::string nan("\0\0\xc0\x7f", 4);
  checkPlyError(changed(body + 28, nan), place("vertex 2", body + 24), "y is not finite");
  checkPlyError(changed(face, "\2"), "a.ply: face 0 (byte ", "2 corners");
  checkPlyError(changed(face + 1, "\7"), "a.ply: face 0 (byte ", "vertex 7, but the file has 4");
  checkPlyError(changed(face + 4, "\xff"), "a.ply: face 0 (byte ", "vertex -16777216");
  checkPlyError(good.substr(0, good.size() - 1), "a.ply: the file ends at byte ",
                "within 'face' 1");
  checkPlyError(good.substr(0, face), "a.ply: the file ends at byte ",
                "before the 2 elements 'face'");
  checkPlyError(good + "x", "a.ply: the file has 1 bytes", "after");
  checkPlyError(promising("vertex 4", "vertex 4000000000"),
                "a.ply: ", "before the 4000000000 elem");
  checkPlyError(promising("face 2", "face 9000000000000000000"), "a.ply: ", "elements 'face'");
  const std::string other = plyFile(
      "binary_big_endian", {{"strange", {"list int double a"}, {{1, 5}}}, vertices(), faces()});
  std::string negative = other, endless = other;
  const std::size_t at = other.find("end_header\n") + 11;
  checkPlyError(negative.replace(at, 4, "\xff\xff\xff\xff"), place("strange 0", at),
                "length of list 'a' is not a whole");
  checkPlyError(endless.replace(at, 4, "\x7f\xff\xff\xff"), "a.ply: the file ends at byte ",
                "within 'strange' 0");
}

namespace {

/// Whether the mesh can be written with new texcoords and read back as the same mesh.
bool survivesWriting(const PolygonMesh& mesh, const std::string& bytes) {
  std::vector<double> uv;
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
    uv.insert(uv.end(), {static_cast<double>(c % 5), 0.1});
  std::vector<std::uint32_t> cornerUv(mesh.faceVertices.size());
  for (std::size_t c = 0; c < cornerUv.size(); ++c) cornerUv[c] = static_cast<std::uint32_t>(c);
  const Result<PolygonMesh> back = ply(writePly(mesh, uv, cornerUv, bytes));
  if (!back.ok() || back.value().faceOffsets != mesh.faceOffsets) return false;
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
    for (std::size_t d = 0; d < 3; ++d)
      if (back.value().positions[3 * back.value().faceVertices[c] + d] !=
          mesh.positions[3 * mesh.faceVertices[c] + d])
        return false;
  return true;
}

}  // namespace

TEST_CASE("PLY: damaged files are read or refused, never misread", "[ply]") {
  std::mt19937_64 random(3);
  const std::string bytes("\\\r\n\t #/+-.0123456789efvlOnaix\xff\x7f\x80\0", 34);
  for (const std::string& format : kPlyFormats) {
    const std::string whole = plyFile(format, richElements());
    const auto isReadOrRefused = [](const std::string& damaged) {
      const Result<PolygonMesh> r = ply(damaged);
      return r.ok() ? validateArrays(r.value()).ok() && survivesWriting(r.value(), damaged)
                    : r.status().code == StatusCode::ParseError;
    };
    for (std::size_t n = 0; n <= whole.size(); ++n) CHECK(isReadOrRefused(whole.substr(0, n)));
    std::size_t refused = 0, bad = 0;
    for (int i = 0; i < 6000; ++i) {
      std::string damaged = whole;
      for (std::size_t k = 1 + random() % 3; k > 0; --k) {
        const std::size_t at = random() % damaged.size();
        const std::size_t what = random() % 3;
        if (what == 0) damaged[at] = bytes[random() % bytes.size()];
        if (what == 1) damaged.insert(at, 1, bytes[random() % bytes.size()]);
        if (what == 2) damaged.erase(at, 1 + random() % 8);
      }
      refused += !ply(damaged).ok();
      bad += !isReadOrRefused(damaged);
    }
    CHECK(bad == 0);
    CHECK(refused > 1000);
    CHECK(refused < 6000);
  }
}

TEST_CASE("PLY: the format is told by the name, or else by the content", "[ply]") {
  CHECK(detectFormat("dir/A.PLY", "").value() == MeshFormat::Ply);
  CHECK(detectFormat("-", "ply\r\nformat").value() == MeshFormat::Ply);
  CHECK(detectFormat("-", "plywood\n").status().code == StatusCode::UnreadableFile);
}

TEST_CASE("PLY: normals of vertices, in every encoding and type") {
  for (const std::string& format : kPlyFormats) {
    INFO(format);
    PlyTestElement v{
        "vertex", {"char nz", "float x", "double ny", "float y", "float z", "float nx"}, {}};
    for (const std::vector<double>& p : kPoints) v.rows.push_back({-5, p[0], p[2], p[1], p[2], 1});
    v.rows[1][0] = v.rows[1][5] = 0;  // no direction
    const Result<PolygonMesh> mesh = ply(plyFile(format, {v, faces()}));
    checkQuadAndTriangle(mesh);
    CHECK(mesh.value().normals == std::vector<double>{1, 0, -5, 0, 0, 0, 1, 0.25, -5, 1, 0, -5});
    const std::uint32_t no = kNoNormal;
    CHECK(mesh.value().faceNormals == std::vector<std::uint32_t>{0, no, 2, 3, 2, no, 0});
    v.properties[2] = "double nothing";
    CHECK(ply(plyFile(format, {v, faces()})).value().normals.empty());
    v.properties = {"list uchar char nz", "float x", "double ny", "float y", "float z", "float nx"};
    for (std::vector<double>& row : v.rows) row.insert(row.begin(), 1);
    CHECK(ply(plyFile(format, {v, faces()})).value().faceNormals.empty());
    v.properties = {"list uchar char links", "float x", "float nx", "float y", "float z", "int ny"};
    v.rows.clear();
    for (const std::vector<double>& p : kPoints)
      v.rows.push_back({1, 7, p[0], 0, p[1], p[2], 3, -1});
    v.properties.push_back("float nz");
    CHECK(ply(plyFile(format, {v, faces()})).value().normals ==
          std::vector<double>{0, 3, -1, 0, 3, -1, 0, 3, -1, 0, 3, -1});
  }
}

TEST_CASE("PLY: texcoords of vertices and of corners are kept in every encoding") {
  for (const std::string& format : kPlyFormats) {
    INFO(format);
    PlyTestElement v{
        "vertex", {"float v", "float x", "uchar red", "float y", "float z", "double u"}, {}};
    for (const std::vector<double>& p : kPoints)
      v.rows.push_back({p[1], p[0], 9, p[1], p[2], p[0]});
    const Result<PolygonMesh> ofVertices = ply(plyFile(format, {v, faces()}));
    checkQuadAndTriangle(ofVertices);
    CHECK(ofVertices.value().texcoords == std::vector<double>{0, 0, 2, 0, 2, 1.5, 0, 1});
    CHECK(ofVertices.value().faceTexcoords == ofVertices.value().faceVertices);
    // Texcoords of corners (lists on faces) take precedence over those of vertices; a list of the
    // wrong length is ignored.
    const PlyTestElement f{"face",
                           {"list uchar float texcoord", "list uchar int vertex_indices"},
                           {{2, 0.5, 0.5, 4, 0, 1, 2, 3}, {6, 1, 2, 3, 4, 5, 6, 3, 2, 1, 0}}};
    for (const std::vector<PlyTestElement>& order : {std::vector{v, f}, std::vector{f, v}}) {
      const Result<PolygonMesh> ofCorners = ply(plyFile(format, order));
      checkQuadAndTriangle(ofCorners);
      const std::uint32_t no = kNoTexcoord;
      CHECK(ofCorners.value().texcoords == std::vector<double>{1, 2, 3, 4, 5, 6});
      CHECK(ofCorners.value().faceTexcoords == std::vector<std::uint32_t>{no, no, no, no, 0, 1, 2});
    }
  }
}
