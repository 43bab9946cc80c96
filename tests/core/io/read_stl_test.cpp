#include <cstdint>
#include <cstring>
#include <limits>
#include <random>

#include "abflat/inspect.h"
#include "abflat/io.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

Result<PolygonMesh> stl(const std::string& bytes) {
  return readMesh(bytes, MeshFormat::Stl, "a.stl");
}

void checkStlError(const std::string& bytes, const std::string& place, const std::string& part) {
  const Result<PolygonMesh> r = stl(bytes);
  INFO(r.status().message);
  CHECK(r.status().code == StatusCode::ParseError);
  CHECK(r.status().message.rfind(place, 0) == 0);
  CHECK(r.status().message.find(part) != std::string::npos);
}

std::string littleEndian(std::uint32_t bits) {
  std::string out;
  for (int i = 0; i < 4; ++i) out += static_cast<char>(bits >> (8 * i) & 0xff);
  return out;
}

std::string littleEndian(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return littleEndian(bits);
}

/// A mesh of triangles with coordinates that fit floats.
std::string binaryStl(const PolygonMesh& mesh, const std::string& header = "made by a test") {
  std::string out = header;
  out.resize(80);
  out += littleEndian(static_cast<std::uint32_t>(mesh.faceCount()));
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    for (int d = 0; d < 3; ++d) out += littleEndian(std::numeric_limits<float>::quiet_NaN());
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
        out += littleEndian(static_cast<float>(mesh.positions[3 * mesh.faceVertices[c] + d]));
    out += "zz";
  }
  return out;
}

std::string textStl(const PolygonMesh& mesh) {
  std::string out = "solid a name, or none\n";
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    out += "  facet normal nan nan nan\n    outer loop\n";
    for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
      out += "      vertex";
      for (std::size_t d = 0; d < 3; ++d) {
        char text[40];
        std::snprintf(text, sizeof text, " %.17g", mesh.positions[3 * mesh.faceVertices[c] + d]);
        out += text;
      }
      out += "\n";
    }
    out += "    endloop\n  endfacet\n";
  }
  return out + "endsolid a name, or none\n";
}

PolygonMesh inFloats(PolygonMesh mesh) {
  for (double& x : mesh.positions) x = static_cast<double>(static_cast<float>(x));
  return mesh;
}

/// Checks that faces keep their order and places, and that no two vertices share a place.
void checkSame(const Result<PolygonMesh>& r, const PolygonMesh& mesh) {
  INFO(r.status().message);
  REQUIRE(r.ok());
  CHECK(r.value().faceOffsets == mesh.faceOffsets);
  CHECK(r.value().vertexCount() == mesh.vertexCount());
  REQUIRE(r.value().faceVertices.size() == mesh.faceVertices.size());
  for (std::size_t c = 0; c < mesh.faceVertices.size(); ++c)
    for (std::size_t d = 0; d < 3; ++d)
      CHECK(r.value().positions[3 * r.value().faceVertices[c] + d] ==
            mesh.positions[3 * mesh.faceVertices[c] + d]);
}

std::string replacedFirst(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE("STL: text and binary are welded to the mesh they come from", "[stl]") {
  for (const PolygonMesh& exact : {tetrahedron(), torus(9, 7), bumpyGrid(40, 30, 0.3, 1)}) {
    const PolygonMesh mesh = inFloats(exact);
    checkSame(stl(binaryStl(mesh)), mesh);
    checkSame(stl(binaryStl(mesh, "solid as some programs begin")), mesh);
    checkSame(stl(textStl(mesh)), mesh);
    checkSame(stl(textStl(exact)), exact);
    const MeshSummary before = inspect(mesh), after = inspect(stl(binaryStl(mesh)).value());
    CHECK(before.boundaryEdges == after.boundaryEdges);
    CHECK(before.genus == after.genus);
  }
}

TEST_CASE("STL: line ends, upper case, several solids and no facets", "[stl]") {
  const PolygonMesh mesh = tetrahedron();
  const std::string text = textStl(mesh);
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    checkSame(stl(other), mesh);
  }
  std::string upper = text;
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  checkSame(stl(upper), mesh);
  checkSame(stl("\xEF\xBB\xBF" + text), mesh);
  const Result<PolygonMesh> twice = stl(text + text);
  CHECK(twice.value().faceCount() == 2 * mesh.faceCount());
  CHECK(twice.value().vertexCount() == mesh.vertexCount());
  for (const std::string& nothing : {std::string("solid\nendsolid\n"), binaryStl({})}) {
    const Result<PolygonMesh> r = stl(nothing);
    REQUIRE(r.ok());
    CHECK(r.value().faceCount() == 0);
    CHECK(validateArrays(r.value()).ok());
  }
}

TEST_CASE("STL: 0 and -0 are one place, near places are two", "[stl]") {
  PolygonMesh mesh = tetrahedron();
  for (double& x : mesh.positions) x -= 1;
  const std::string text = textStl(mesh);
  checkSame(stl(replacedFirst(text, "vertex 0 0 0", "vertex -0 0 -0.0")), mesh);
  CHECK(stl(replacedFirst(text, "vertex 0 0 0", "vertex 1e-300 0 0")).value().vertexCount() ==
        mesh.vertexCount() + 1);
}

TEST_CASE("STL: a facet without area stays a face", "[stl]") {
  PolygonMesh mesh = tetrahedron();
  mesh.faceVertices.insert(mesh.faceVertices.end(), {0, 1, 1, 2, 2, 2});
  mesh.faceOffsets.insert(mesh.faceOffsets.end(), {15, 18});
  for (const std::string& bytes : {binaryStl(mesh), textStl(mesh)}) {
    checkSame(stl(bytes), mesh);
    const Status disk = inspect(stl(bytes).value()).disk;
    CHECK(disk.code == StatusCode::DegenerateFace);
    CHECK(disk.message.find("face 4 uses vertex") != std::string::npos);
  }
}

TEST_CASE("STL: what is wrong is named with its place", "[stl]") {
  const std::string text = textStl(tetrahedron());
  checkStlError("", "a.stl: ", "empty");
  checkStlError("hollow\n", "a.stl: ", "does not begin with 'solid'");
  checkStlError(text.substr(0, text.find("endsolid")), "a.stl:29: ", "ends before 'endsolid'");
  checkStlError(text.substr(0, text.find("endloop")),
                "a.stl:6: ", "end of the file. Is it truncated?");
  checkStlError(replacedFirst(text, "outer", "inner"),
                "a.stl:3: ", "expected 'outer', not 'inner'");
  checkStlError(replacedFirst(text, "endloop", "vertex"), "a.stl:7: ", "expected 'endloop'");
  checkStlError(replacedFirst(text, "facet", "fact"),
                "a.stl:2: ", "expected 'facet' or 'endsolid'");
  checkStlError(text + "facet\n", "a.stl:31: ", "expected 'solid'");
  checkStlError(replacedFirst(text, "vertex 1 1 1", "vertex 1 1 zero"),
                "a.stl:4: ", "'zero' is not a");
  checkStlError(replacedFirst(text, "vertex 1 1 1", "vertex 1 1 inf"),
                "a.stl:4: ", "facet 0, vertex 0: the coordinate 'inf' is not finite");

  const std::string binary = binaryStl(tetrahedron());
  checkStlError(binary.substr(0, 83), "a.stl: ", "has 83 bytes");
  checkStlError(binary.substr(0, 200), "a.stl: ",
                "declares 4 facets, or 284 bytes, but the "
                "file has 200. Is it truncated?");
  checkStlError(binary + "x", "a.stl: ", "the file has 285");
  std::string lies = binary;
  checkStlError(lies.replace(80, 4, "\xff\xff\xff\xff"), "a.stl: ", "declares 4294967295 facets");
  std::string infinite = binary;
  infinite.replace(84 + 50 + 12 + 12 + 4, 4, std::string("\0\0\x80\x7f", 4));
  checkStlError(infinite, "a.stl: facet 1 (byte 162): vertex 1 ", "not finite");
}

TEST_CASE("STL: damaged files are read or refused, never misread", "[stl]") {
  std::mt19937_64 random(4);
  const auto isReadOrRefused = [](const std::string& damaged) {
    const Result<PolygonMesh> r = stl(damaged);
    return r.ok() ? validateArrays(r.value()).ok() : r.status().code == StatusCode::ParseError;
  };
  for (const std::string& whole : {binaryStl(tetrahedron(), "solid"), textStl(tetrahedron())}) {
    for (std::size_t n = 0; n <= whole.size(); ++n) CHECK(isReadOrRefused(whole.substr(0, n)));
    std::size_t bad = 0;
    for (int i = 0; i < 6000; ++i) {
      std::string damaged = whole;
      for (std::size_t k = 1 + random() % 3; k > 0; --k) {
        const std::size_t at = random() % damaged.size();
        if (random() % 2 == 0)
          damaged[at] = static_cast<char>(random());
        else if (random() % 4 == 0)
          damaged.erase(at, 1 + random() % 60);
      }
      bad += !isReadOrRefused(damaged);
    }
    CHECK(bad == 0);
  }
}

TEST_CASE("STL: the format is told by the name, or else by the content", "[stl]") {
  CHECK(detectFormat("dir/A.STL", "").value() == MeshFormat::Stl);
  CHECK(detectFormat("-", textStl(tetrahedron())).value() == MeshFormat::Stl);
  CHECK(detectFormat("-", binaryStl(tetrahedron())).value() == MeshFormat::Stl);
}
