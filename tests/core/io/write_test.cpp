#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>

#include "abflat/io.h"
#include "catch.h"
#include "support/meshes.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("a mesh without source text is written completely") {
  const PolygonMesh mesh = renumbered(bumpyGrid(5, 4, 0.3, 1), 2).mesh;
  const Result<PolygonMesh> back = readMesh(writeObj(mesh, {}, {}), MeshFormat::Obj, "a");
  REQUIRE(back.ok());
  CHECK(back.value().positions == mesh.positions);
  CHECK(back.value().faceOffsets == mesh.faceOffsets);
  CHECK(back.value().faceVertices == mesh.faceVertices);
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

TEST_CASE("a byte order mark is kept and no part of the first record") {
  const std::string mark = "\xEF\xBB\xBF", rest = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<double> uv{0, 0, 1, 0, 0, 1};
  const std::string texcoords = "vt 0 0\nvt 1 0\nvt 0 1\n", face = "f 1/1 2/2 3/3\n";
  CHECK(writeObj({}, uv, {0, 1, 2}, mark + "vt 9 9\n" + rest + "f 1/1 2/1 3/1\n") ==
        mark + rest + texcoords + face);
  CHECK(writeObj({}, uv, {0, 1, 2}, mark + "f 1 2 3\n" + rest) == mark + texcoords + face + rest);
}

TEST_CASE("what referred to the old texcoords is rewritten, comments stay") {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\n# C:\\old\\\n";
  const std::string source =
      head + "vt 9 9 # old\nvt \\\n 8 8\nf 1/2 2/1 3/2 # first\nl 1/1 2/2 #line\nl 1 2\np 1\n";
  CHECK(writeObj({}, {0, 0, 1, 0, 0, 1}, {0, 1, 2}, source) ==
        head + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3 # first\nl 1 2 #line\nl 1 2\np 1\n");
}

namespace {

/// The texcoord of every face corner in a result. Reads nothing but plain vt and f lines.
std::vector<double> cornerTexcoords(const std::string& text) {
  std::istringstream lines(text);
  std::vector<double> uv, out;
  for (std::string line, keyword; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> keyword;
    if (keyword == "vt")
      for (std::string word; words >> word;) uv.push_back(std::strtod(word.c_str(), nullptr));
    if (keyword == "f")
      for (std::string word; words >> word;) {
        const std::size_t index = std::stoul(word.substr(word.find('/') + 1)) - 1;
        out.insert(out.end(), {uv.at(2 * index), uv.at(2 * index + 1)});
      }
  }
  return out;
}

/// Random polygons on random vertices, in one of the styles of writing them.
std::string randomObj(std::mt19937_64& random, PolygonMesh& mesh) {
  std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
  const std::string eol = random() % 2 ? "\n" : "\r\n";
  const std::string endings[] = {"", "/1", "/1/1", "//1"};
  std::string text = "o thing" + eol + "vn 0 0 1" + eol;
  mesh.faceOffsets = {0};
  for (int face = 0; face < 20; ++face) {
    while (mesh.vertexCount() < 5 || random() % 2) {
      text += "v";
      for (int d = 0; d < 3; ++d) {
        mesh.positions.push_back(coordinate(random) * std::pow(10, coordinate(random) / 10));
        char number[40];
        std::snprintf(number, sizeof number, " %.17g", mesh.positions.back());
        text += number;
      }
      text += eol;
    }
    text += (random() % 4 ? "vt 0.5 0.25" + eol : "usemtl skin" + eol) + "f";
    for (std::size_t k = 3 + random() % 4; k > 0; --k) {
      const std::size_t v = random() % mesh.vertexCount();
      mesh.faceVertices.push_back(static_cast<std::uint32_t>(v));
      const bool isBackwards = random() % 2;
      text +=
          isBackwards ? " -" + std::to_string(mesh.vertexCount() - v) : " " + std::to_string(v + 1);
      text += endings[random() % 4];
      if (random() % 8 == 0) text += " \\" + eol;
    }
    if (text.substr(text.size() - eol.size()) == eol)
      text += " -1",
          mesh.faceVertices.push_back(static_cast<std::uint32_t>(mesh.vertexCount() - 1));
    text += eol;
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  }
  return text;
}

}  // namespace

TEST_CASE("random meshes come back with their texcoords, bit for bit") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 200; ++i) {
    PolygonMesh wanted;
    const std::string source = randomObj(random, wanted);
    const Result<PolygonMesh> read = readMesh(source, MeshFormat::Obj, "a");
    INFO(read.status().message << "\n" << source);
    REQUIRE(read.ok());
    REQUIRE(read.value().positions == wanted.positions);
    REQUIRE(read.value().faceOffsets == wanted.faceOffsets);
    REQUIRE(read.value().faceVertices == wanted.faceVertices);

    std::vector<double> uv(2 * (1 + random() % 40)), wantedUv;
    for (double& x : uv) x = coordinate(random) * std::pow(10, 20 * coordinate(random));
    std::vector<std::uint32_t> cornerUv;
    while (cornerUv.size() < wanted.faceVertices.size()) {
      cornerUv.push_back(static_cast<std::uint32_t>(random() % (uv.size() / 2)));
      wantedUv.insert(wantedUv.end(), {uv[2 * cornerUv.back()], uv[2 * cornerUv.back() + 1]});
    }
    for (const std::string& from : {source, std::string()}) {
      const std::string text = writeObj(wanted, uv, cornerUv, from);
      REQUIRE(cornerTexcoords(text) == wantedUv);
      const Result<PolygonMesh> back = readMesh(text, MeshFormat::Obj, "a");
      REQUIRE(back.value().positions == wanted.positions);
      REQUIRE(back.value().faceOffsets == wanted.faceOffsets);
      REQUIRE(back.value().faceVertices == wanted.faceVertices);
      // Rewriting its own result changes nothing.
      REQUIRE(writeObj(wanted, uv, cornerUv, text) == text);
    }
  }
}

TEST_CASE("a texcoord that is left out joins no lines, and begins no text with a mark") {
  const std::string plain = "v 1 0 0\nv 0 1 0\n";
  const std::vector<std::string> sources = {
      "v 0 0 \\\n0 \\\nvt 1 1\ng a\n" + plain + "f 1/1 2/1 3/1\n",
      "v 0 0 \\\n0 \\\nvt 1 \\\n 1\n1 2\n" + plain + "f 1 2 3\n",
      "vt 1 1\n\xEF\xBB\xBFv 9 9 9\nv 0 0 0\n" + plain + "f 1 2 3\n",
      "vt 1 1\n\xFF\xFEv 9 9 9\nv 0 0 0\n" + plain + "f 1 2 3\n",
      "vt 1 1\n" + std::string("\0#\0#\n", 5) + "v 0 0 0\n" + plain + "f 1 2 3\n"};
  for (const std::string& source : sources) {
    INFO(source);
    const Result<PolygonMesh> mesh = readMesh(source, MeshFormat::Obj, "a");
    REQUIRE(mesh.ok());
    const Result<PolygonMesh> back = readMesh(
        writeObj(mesh.value(), {0, 0, 1, 0, 0, 1}, {0, 1, 2}, source), MeshFormat::Obj, "b");
    INFO(back.status().message);
    REQUIRE(back.ok());
    CHECK(back.value().positions == mesh.value().positions);
    CHECK(back.value().faceVertices == mesh.value().faceVertices);
    CHECK(back.value().texcoords == std::vector<double>{0, 0, 1, 0, 0, 1});
  }
}

TEST_CASE("lines that are joined with an empty one end there") {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", texcoords = "vt 0 0\nvt 1 0\nvt 0 1\n";
  const std::string source = head + "l 1/1 2/1 \\\n\\\n\nf 1 2 3 \\\n\nl 1/1 2/1\\\n\nf 3 2 1\n";
  CHECK(writeObj({}, {0, 0, 1, 0, 0, 1}, {0, 1, 2, 2, 1, 0}, source) ==
        head + "l 1 2\n" + texcoords + "f 1/1 2/2 3/3\nl 1 2\nf 3/3 2/2 1/1\n");
  CHECK(readMesh(source, MeshFormat::Obj, "a").value().faceCount() == 2);
}

TEST_CASE("line ends of the source are kept, mixed ones too") {
  CHECK(writeObj({}, {0, 0}, {0, 0, 0, 0, 0, 0}, "# a\rv 0 0 0\nf 1 1 1\r\n\nf 1 1 1\n\r\n") ==
        "# a\rv 0 0 0\nvt 0 0\r\nf 1/1 1/1 1/1\r\n\nf 1/1 1/1 1/1\n\r\n");
  const std::string source = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3";
  const std::string out = writeObj({}, {0, 0, 1, 0, 0, 1}, {0, 1, 2}, source);
  CHECK(out == "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvt 1 0\r\nvt 0 1\r\nf 1/1 2/2 3/3\r\n");
}

TEST_CASE("corners without texcoords have none, whatever else they have") {
  const std::string source = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1/1/1 2//1 3\nf 1 2/2 3//1\n";
  const PolygonMesh mesh = readMesh(source, MeshFormat::Obj, "in.obj").value();
  const std::vector<std::uint32_t> cornerUv = {kNoTexcoord, kNoTexcoord, kNoTexcoord,
                                               0,           kNoTexcoord, 0};
  CHECK(writeObj(mesh, {0.5, 0.25}, cornerUv, source) ==
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0.5 0.25\nf 1//1 2//1 3\nf 1/1 2 3/1/1\n");
  const std::string fresh = writeObj(mesh, {0.5, 0.25}, cornerUv);
  CHECK(fresh.substr(fresh.find('f')) == "f 1 2 3\nf 1/1 2 3/1\n");
  const PolygonMesh ply =
      readMesh(writePly(mesh, {0.5, 0.25}, cornerUv), MeshFormat::Ply, "out.ply").value();
  CHECK(ply.vertexCount() == 5);
}
