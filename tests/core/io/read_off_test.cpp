#include <cstring>

#include "abflat/io.h"
#include "catch.h"

using namespace abflat;

namespace {

struct BinaryKind {
  std::string name = "OFF";
  std::size_t extra = 0;  ///< further floats of each vertex
  bool isBigEndian = true, hasColors = true;
};

class BinaryOff {
 public:
  explicit BinaryOff(const BinaryKind& kind) : kind_(kind), bytes_(kind.name + " BINARY\n") {}

  BinaryOff& integer(std::int32_t value) { return put(&value); }
  BinaryOff& real(float value) { return put(&value); }
  BinaryOff& vertex(float x, float y, float z) {
    real(x).real(y).real(z);
    for (std::size_t i = 0; i < kind_.extra; ++i) real(0.5F);
    return *this;
  }
  BinaryOff& face(const std::vector<std::int32_t>& corners, std::int32_t colors) {
    integer(static_cast<std::int32_t>(corners.size()));
    for (const std::int32_t v : corners) integer(v);
    if (!kind_.hasColors) return *this;
    integer(colors);
    for (std::int32_t i = 0; i < colors; ++i) real(1);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  BinaryOff& put(const void* number) {
    const auto* const at = static_cast<const char*>(number);
    const std::int32_t one = 1;
    char isLittle = 0;
    std::memcpy(&isLittle, &one, 1);
    for (std::size_t i = 0; i < 4; ++i)
      bytes_ += at[(isLittle != 0) == kind_.isBigEndian ? 3 - i : i];
    return *this;
  }

  BinaryKind kind_;
  std::string bytes_;
};

std::string pyramid(const BinaryKind& kind) {
  BinaryOff file(kind);
  file.integer(5).integer(3).integer(0);
  file.vertex(0, 0, 0).vertex(1, 0, 0).vertex(1, 1, 0).vertex(0, 1, 0.25F).vertex(0.5F, 0.5F, 2);
  file.face({3, 2, 1, 0}, 0).face({0, 1, 4}, 3).face({1, 2, 4}, 4);
  return file.bytes();
}

Result<PolygonMesh> readBinaryOff(const std::string& bytes) {
  return readMesh(bytes, MeshFormat::Off, "a.off");
}

std::string problemOf(const std::string& bytes) {
  const Result<PolygonMesh> r = readBinaryOff(bytes);
  CHECK(r.status().code == StatusCode::ParseError);
  return r.status().message;
}

}  // namespace

TEST_CASE("OFF: a binary file is the mesh of the text file, in either byte order", "[off]") {
  const Result<PolygonMesh> text = readBinaryOff(
      "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 .25\n.5 .5 2\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n");
  REQUIRE(text.ok());
  for (const bool isBigEndian : {true, false})
    for (const bool hasColors : {true, false})
      for (const BinaryKind& kind :
           {BinaryKind{"OFF", 0}, {"COFF", 4}, {"NOFF", 3}, {"STOFF", 2}, {"STCNOFF", 9}}) {
        BinaryKind now = kind;
        now.isBigEndian = isBigEndian;
        now.hasColors = hasColors;
        INFO(now.name << " " << isBigEndian << hasColors);
        for (const std::string end : {"", "\n"}) {
          const Result<PolygonMesh> r = readBinaryOff(pyramid(now) + end);
          INFO(r.status().message);
          REQUIRE(r.ok());
          CHECK(r.value().positions == text.value().positions);
          CHECK(r.value().faceVertices == text.value().faceVertices);
          CHECK(r.value().faceOffsets == text.value().faceOffsets);
        }
      }
  const std::string bytes = pyramid({});
  const Result<MeshFormat> format = detectFormat("a.bin", bytes);
  REQUIRE(format.ok());
  CHECK(format.value() == MeshFormat::Off);
}

TEST_CASE("OFF: what is wrong in a binary file is named with its place", "[off]") {
  const std::string whole = pyramid({});
  CHECK(problemOf(whole.substr(0, 20)) == "a.off: the file ends before the vertex and face counts");
  // Every shorter file is refused, and none of them is read as something else.
  for (std::size_t size = 23; size < whole.size(); ++size)
    CHECK(problemOf(whole.substr(0, size)).rfind("a.off: the ", 0) == 0);
  CHECK(problemOf(whole + "x") ==
        "a.off: the file has 1 byte after the last face that its header declares");
  BinaryOff wrong({});
  wrong.integer(3).integer(1).integer(0);
  wrong.vertex(0, 0, 0).vertex(1, 0, 0).vertex(0, 1, 0);
  const auto with = [&](const std::vector<std::int32_t>& corners, std::int32_t colors) {
    return problemOf(BinaryOff(wrong).face(corners, colors).bytes());
  };
  CHECK(
      with({0, 1, 3}, 0) ==
      "a.off: face 0 (byte 75): it refers to vertex 3, but the file has 3 vertices (indices start "
      "at 0)");
  CHECK(with({0, 1}, 0) == "a.off: face 0 (byte 63): it has 2 corners; at least 3 are needed");
  CHECK(with({0, 1, 2}, 5) ==
        "a.off: face 0 (byte 79): its colour has 5 components; at most 4 are allowed");
  BinaryOff many({});
  many.integer(1 << 30).integer(1).integer(0);
  CHECK(problemOf(many.bytes()).find("declares 1073741824 vertices and 1 face") !=
        std::string::npos);
}
