#include "io/plain_obj_line.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <sstream>

#include "abflat/io.h"
#include "catch.h"

using namespace abflat;

namespace {

Result<PolygonMesh> wholeObj(const std::string& text) {
  return readMesh(text, MeshFormat::Obj, "a.obj");
}

/// Reads `text` line by line and word by word, for texts whose faces only refer to earlier lines.
PolygonMesh slowly(const std::string& text) {
  PolygonMesh mesh;
  mesh.faceOffsets = {0};
  bool hasGroups = false;
  std::istringstream lines(text);
  for (std::string line, keyword, word; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> keyword;
    for (int d = 0; keyword == "v" && d < 3 && words >> word; ++d)
      mesh.positions.push_back(std::strtod(word.c_str(), nullptr));
    for (int d = 0; keyword == "vt" && d < 2 && words >> word; ++d)
      mesh.texcoords.push_back(std::strtod(word.c_str(), nullptr));
    for (int d = 0; keyword == "vn" && d < 3 && words >> word; ++d)
      mesh.normals.push_back(std::strtod(word.c_str(), nullptr));
    if (keyword == "s") hasGroups = true;
    while (keyword == "f" && words >> word) {
      char* end = nullptr;
      const long v = std::strtol(word.c_str(), &end, 10);
      const long vt = *end == '/' && end[1] != '/' ? std::strtol(end + 1, &end, 10) : 0;
      if (*end == '/' && end[1] == '/') ++end;
      const long vn = *end == '/' ? std::strtol(end + 1, nullptr, 10) : 0;
      const auto indexOf = [](long given, std::size_t known) {
        return static_cast<std::uint32_t>(given == 0  ? -1
                                          : given > 0 ? given - 1
                                                      : static_cast<long>(known) + given);
      };
      mesh.faceTexcoords.push_back(indexOf(vt, mesh.texcoords.size() / 2));
      mesh.faceNormals.push_back(indexOf(vn, mesh.normals.size() / 3));
      mesh.faceVertices.push_back(
          static_cast<std::uint32_t>(v > 0 ? v - 1 : static_cast<long>(mesh.vertexCount()) + v));
    }
    if (keyword == "f")
      mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
    keyword.clear();
  }
  bool hasTexcoords = false;
  for (std::uint32_t& t : mesh.faceTexcoords) {
    if (t >= mesh.texcoords.size() / 2) t = kNoTexcoord;
    hasTexcoords = hasTexcoords || t != kNoTexcoord;
  }
  if (!hasTexcoords) mesh.texcoords.clear(), mesh.faceTexcoords.clear();
  bool hasNormals = false;
  for (std::uint32_t& n : mesh.faceNormals) {
    if (n >= mesh.normals.size() / 3) n = kNoNormal;
    hasNormals = hasNormals || n != kNoNormal;
  }
  if (!hasNormals) mesh.normals.clear(), mesh.faceNormals.clear();
  if (hasGroups && !hasNormals) mesh.faceSmoothing.assign(mesh.faceCount(), 0);
  return mesh;
}

bool isSame(const PolygonMesh& a, const PolygonMesh& b) {
  return a.positions.size() == b.positions.size() &&
         (a.positions.empty() ||
          std::memcmp(a.positions.data(), b.positions.data(), 8 * a.positions.size()) == 0) &&
         a.faceOffsets == b.faceOffsets && a.faceVertices == b.faceVertices &&
         a.texcoords == b.texcoords && a.faceTexcoords == b.faceTexcoords &&
         a.normals.size() == b.normals.size() &&
         (a.normals.empty() ||
          std::memcmp(a.normals.data(), b.normals.data(), 8 * a.normals.size()) == 0) &&
         a.faceNormals == b.faceNormals && a.faceSmoothing == b.faceSmoothing;
}

using Random = std::mt19937_64;

std::string pick(Random& random, const std::vector<std::string>& from) {
  return from[random() % from.size()];
}

std::string blanks(Random& random) { return pick(random, {" ", " ", " ", "  ", "\t", " \t "}); }

std::string number(Random& random) {
  const char* formats[] = {"%.17g", "%.3f", "%.9g", "%.16e", "%g", "%.0f.", "%.20f", "%E"};
  const double exponent = std::uniform_real_distribution<double>(-300, 300)(random);
  const double scale = random() % 4 ? 1 : std::pow(10, exponent / (random() % 2 ? 1 : 20));
  char text[400];
  std::snprintf(text, sizeof text, formats[random() % 8],
                scale * std::uniform_real_distribution<double>(-2, 2)(random));
  return text;
}

std::string corner(Random& random, std::size_t vertices) {
  const std::size_t v = random() % vertices;
  return (random() % 3 ? std::to_string(v + 1) : "-" + std::to_string(vertices - v)) +
         pick(random, {"", "/7", "/7/12345", "//9", "//1", "/-1/-2"});
}

std::string randomText(Random& random, std::size_t lines) {
  std::string text;
  for (std::size_t i = 0, vertices = 0; i < lines; ++i) {
    const std::size_t kind = vertices < 3 ? 0 : random() % 5;
    if (kind < 2) {
      text += "v";
      for (int d = 0; d < 3; ++d) text += blanks(random) + number(random);
      text += pick(random, {"", "", " 0.5 1 1", " 1"});
      ++vertices;
    } else if (kind < 4) {
      text += "f";
      for (std::size_t k = 3 + random() % 3; k > 0; --k)
        text += blanks(random) + corner(random, vertices);
    } else {
      text += pick(random, {"vt 1 2", "vt 0.1 -7e3 0", "vt\t3 4", "vt 5 6", "vn 0 0 1",
                            "vn .5 -1e3 2.5", "", "g a\\", "# v 1 2 3", "usemtl f", "s off"});
    }
    text += pick(random, {"\n", "\n", "\n", " \n", "\r\n"});
  }
  return text;
}

/// The text with a comment after every vertex and face, so that none of its lines is plain.
std::string commented(const std::string& text) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const bool isRecord = line.substr(0, 1) == "v" || line.substr(0, 1) == "f";
    if (!line.empty() && line.back() == '\r') line.pop_back();
    out += line + (isRecord ? " # c\n" : "\n");
  }
  return out;
}

}  // namespace

TEST_CASE("plain lines mean what a slow reader makes of them") {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const std::string text = randomText(random, 60);
    const Result<PolygonMesh> read = wholeObj(text);
    INFO(read.status().message << "\n" << text);
    REQUIRE(read.ok());
    REQUIRE(isSame(read.value(), slowly(text)));
    const Result<PolygonMesh> careful = wholeObj(commented(text));
    INFO(careful.status().message);
    REQUIRE(careful.ok());
    REQUIRE(isSame(read.value(), careful.value()));
  }
}

TEST_CASE("a damaged line is read or refused alike, plain or not") {
  Random random(4);
  const std::string bytes = "\t /+-.0123456789eEfvlnainx,;_";
  std::size_t refused = 0;
  constexpr int kTexts = 30000;
  for (int i = 0; i < kTexts; ++i) {
    std::string line = randomText(random, 1);
    if (random() % 2) line = "f 1 -1 2/3/4";
    line = line.substr(0, line.find_first_of("\r\n"));
    for (std::size_t k = 1 + random() % 3; k > 0; --k) {
      const std::size_t at = random() % line.size();
      if (random() % 2)
        line[at] = bytes[random() % bytes.size()];
      else
        line.insert(at, 1, bytes[random() % bytes.size()]);
    }
    const std::string head = "v 0 0 0\nv 1 0 0\n";
    const Result<PolygonMesh> one = wholeObj(head + line + "\n"),
                              other = wholeObj(head + line + " #\n");
    INFO(line << "\n" << one.status().message << "\n" << other.status().message);
    REQUIRE(one.status().code == other.status().code);
    REQUIRE(one.status().message == other.status().message);
    REQUIRE((!one.ok() || isSame(one.value(), other.value())));
    refused += !one.ok();
  }
  CHECK(refused > kTexts / 10);
  CHECK(refused < kTexts - kTexts / 10);
}

TEST_CASE("the fast way takes the lines that files consist of, and leaves the others") {
  std::array<double, 3> point;
  std::vector<ObjCorner> corners;
  CHECK(plainVertexLine("v 1 2.5 -3e-7\nv", point) == 14);
  CHECK(point == std::array<double, 3>{1, 2.5, -3e-7});
  CHECK(plainVertexLine("v 1 2 3 0.5 0.5 0.5\r\nv", point) == 21);
  CHECK(plainFaceLine("f 1/2/3 -2//4 5\r", corners) == 16);
  REQUIRE(corners.size() == 3);
  for (const auto& [k, vertex, texcoord, normal] :
       {std::array<std::int64_t, 4>{0, 1, 2, 3}, {1, -2, 0, 4}, {2, 5, 0, 0}}) {
    CHECK(corners[static_cast<std::size_t>(k)].vertex == vertex);
    CHECK(corners[static_cast<std::size_t>(k)].texcoord == texcoord);
    CHECK(corners[static_cast<std::size_t>(k)].normal == normal);
  }
  std::array<double, 2> uv;
  CHECK(plainTexcoordLine("vt 0.5 -1\nf", uv) == 10);
  CHECK(uv == std::array<double, 2>{0.5, -1});
  CHECK(plainTexcoordLine("vt 1 2 0\r\n", uv) == 10);
  for (const char* line : {"vt 1\n", "vt 1 2 # c\n", "vt 1 x\n", "v 1 2\n", "vt 1 2 \\\n"})
    CHECK(plainTexcoordLine(line, uv) == 0);
  CHECK(plainNormalLine("vn 0.5 -1 2e3\nf", point) == 14);
  CHECK(point == std::array<double, 3>{0.5, -1, 2e3});
  for (const char* line : {"vn 1 2\n", "vn 1 2 3 # c\n", "vn 1 2 x\n", "v 1 2 3\n"})
    CHECK(plainNormalLine(line, point) == 0);
  for (const char* line : {"v 1 2 3 # c\n", "v 1 2\n", "v 1 2 3 \\\n", "v 1 2 inf\n", "vt 1 2 3\n"})
    CHECK(plainVertexLine(line, point) == 0);
  for (const char* line : {"f 1 2\n", "f 1 2 0\n", "f 1 2 3 # c\n", "f 1 2 3 \\\n", "f 1 2 3x\n"})
    CHECK(plainFaceLine(line, corners) == 0);
  CHECK(corners.size() == 3);
  CHECK(plainLine("a b\r\nc") == 5);
  CHECK(plainLine("last") == 4);
  CHECK(plainLine("a \\\nb") == 0);
  CHECK(plainLine("a # b\n") == 0);
}
