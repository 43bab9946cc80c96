#include <cmath>
#include <random>

#include "abflat/io.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/ply_files.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Two quads on six vertices, cut along their common edge 1-4: 8 texcoords.
struct Cut {
  std::vector<double> uv{0, 0, 1, 0, 1, 1, 0, 1, 3, 0, 4, 0, 4, 1, 3, 1};
  std::vector<std::uint32_t> cornerUv{0, 1, 2, 3, 4, 5, 6, 7};
};
const std::vector<std::vector<double>> kSheetPoints = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0.5},
                                                       {0, 1, 0}, {1, 1, 0}, {2, 1, 0.5}};

PolygonMesh read(const std::string& bytes) {
  const Result<PolygonMesh> r = readMesh(bytes, MeshFormat::Ply, "a.ply");
  INFO(r.status().message);
  REQUIRE(r.ok());
  return r.value();
}

/// Attributes of vertices and faces, elements before and after, in an unusual order.
std::vector<PlyTestElement> source() {
  PlyTestElement v{
      "vertex", {"float x", "float y", "float z", "uchar red", "list uchar short bones"}, {}};
  for (std::size_t i = 0; i < kSheetPoints.size(); ++i) {
    const double n = static_cast<double>(i);
    v.rows.push_back({kSheetPoints[i][0], kSheetPoints[i][1], kSheetPoints[i][2], 40 * n, 1, -n});
  }
  return {
      {"camera", {"double a"}, {{0.1}}},
      v,
      {"face",
       {"uchar flags", "list uchar int vertex_indices", "float area"},
       {{7, 4, 0, 1, 4, 3, 1}, {8, 4, 1, 2, 5, 4, 1.25}}},
      {"edge", {"int vertex1", "int vertex2"}, {{1, 4}}},
  };
}

/// The expected result: rows keep their numbers, and copies of vertices 1 and 4 follow them.
std::vector<PlyTestElement> expected(const std::string& uvType) {
  std::vector<PlyTestElement> out = source();
  PlyTestElement& v = out[1];
  v.properties.insert(v.properties.end(), {uvType + " s", uvType + " t"});
  v.rows.push_back(v.rows[1]);
  v.rows.push_back(v.rows[4]);
  const double uv[][2] = {{0, 0}, {1, 0}, {4, 0}, {0, 1}, {1, 1}, {4, 1}, {3, 0}, {3, 1}};
  for (std::size_t i = 0; i < v.rows.size(); ++i)
    v.rows[i].insert(v.rows[i].end(), {uv[i][0], uv[i][1]});
  out[2].rows[1] = {8, 4, 6, 2, 5, 7, 1.25};
  return out;
}

std::string rewritten(const std::string& bytes, const Cut& cut = {}) {
  return writePly(read(bytes), cut.uv, cut.cornerUv, bytes);
}

}  // namespace

TEST_CASE("PLY out: vertices are repeated along the seam, all else is kept", "[ply]") {
  for (const std::string& format : kPlyFormats)
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      INFO(format << " " << end.size());
      CHECK(rewritten(plyFile(format, source(), end)) == plyFile(format, expected("float"), end));
    }
}

TEST_CASE("PLY out: texcoords that are no floats are written as double", "[ply]") {
  Cut cut;
  cut.uv[0] = 1.0000000000000002;
  for (const std::string& format : kPlyFormats) {
    std::vector<PlyTestElement> out = expected("double");
    out[1].rows[0][6] = cut.uv[0];
    CHECK(rewritten(plyFile(format, source()), cut) == plyFile(format, out));
  }
}

TEST_CASE("PLY out: old texcoords give way, whatever they are called", "[ply]") {
  const std::string pairs[][2] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
  for (const auto& pair : pairs)
    for (const std::string& format : kPlyFormats) {
      std::vector<PlyTestElement> in = source(), out = expected("float");
      // Not at the end: what follows must be kept.
      in[1].properties.insert(in[1].properties.begin() + 1,
                              {"float " + pair[0], "double " + pair[1]});
      for (std::vector<double>& row : in[1].rows) row.insert(row.begin() + 1, {9, 9});
      in[2].properties.push_back("list uchar float texcoord");
      for (std::vector<double>& row : in[2].rows) row.insert(row.end(), {2, 9, 9});
      out[2].properties.push_back("list uchar float texcoord");
      out[2].rows[0].insert(out[2].rows[0].end(), {8, 0, 0, 1, 0, 1, 1, 0, 1});
      out[2].rows[1].insert(out[2].rows[1].end(), {8, 3, 0, 4, 0, 4, 1, 3, 1});
      CHECK(rewritten(plyFile(format, in)) == plyFile(format, out));
    }
  std::vector<PlyTestElement> in = source(), out = expected("float");
  for (std::vector<PlyTestElement>* elements : {&in, &out}) {
    PlyTestElement& v = (*elements)[1];
    v.properties.insert(v.properties.begin(), "float u");  // without a v it means something else
    for (std::vector<double>& row : v.rows) row.insert(row.begin(), 5);
  }
  CHECK(rewritten(plyFile("ascii", in)) == plyFile("ascii", out));
  for (const std::string& format : kPlyFormats) {
    // There is only a t.
    std::vector<PlyTestElement> timed = source();
    timed[1].properties.insert(timed[1].properties.begin(), "list uchar float t");
    for (std::vector<double>& row : timed[1].rows) row.insert(row.begin(), {2, 5, 5});
    CHECK(rewritten(plyFile(format, timed)) == plyFile(format, expected("float")));
  }
}

TEST_CASE("PLY out: types that are too small for new vertices grow", "[ply]") {
  // A fan of 100 triangles, each with its own texcoords: 300 vertices.
  PlyTestElement v{"vertex", {"float x", "float y", "float z"}, {{0, 0, 1}}};
  PlyTestElement f{"face", {"list uchar char vertex_index"}, {}};
  Cut cut{{}, {}};
  for (std::uint32_t i = 0; i < 100; ++i) {
    v.rows.push_back({std::cos(0.05 * i), std::sin(0.05 * i), 0});
    f.rows.push_back({3, 0, 1.0 + i, 1.0 + (i + 1) % 100});
    for (std::uint32_t k = 0; k < 3; ++k) {
      cut.uv.insert(cut.uv.end(), {i + 0.25 * k, 0.5 * k});
      cut.cornerUv.push_back(3 * i + k);
    }
  }
  for (const std::string& format : kPlyFormats) {
    const std::string bytes = plyFile(format, {v, f}), out = rewritten(bytes, cut);
    CHECK(out.find("property list uchar int vertex_index") != std::string::npos);
    const PolygonMesh before = read(bytes), after = read(out);
    REQUIRE(after.faceVertices.size() == before.faceVertices.size());
    CHECK(after.vertexCount() == 300);
    for (std::size_t c = 0; c < before.faceVertices.size(); ++c)
      for (std::size_t d = 0; d < 3; ++d)
        CHECK(after.positions[3 * after.faceVertices[c] + d] ==
              before.positions[3 * before.faceVertices[c] + d]);
  }
}

TEST_CASE("PLY out: equal texcoords with different numbers need no copy", "[ply]") {
  const Cut cut{{0, 0, 1, 0, 1, 1, 0, 1, 1, 0, 2, 0, 2, 1, 1, 1}, {0, 1, 2, 3, 4, 5, 6, 7}};
  CHECK(read(rewritten(plyFile("ascii", source()), cut)).vertexCount() == 6);
}

TEST_CASE("PLY out: without a source the mesh is written completely", "[ply]") {
  PolygonMesh mesh = renumbered(bumpyGrid(5, 4, 0.3, 1), 2).mesh;
  const std::vector<double> uv(2 * mesh.vertexCount(), 0.5);
  for (const bool isSingle : {false, true}) {
    if (isSingle)
      for (double& x : mesh.positions) x = static_cast<float>(x);
    for (const bool hasUv : {false, true}) {
      const std::string bytes =
          hasUv ? writePly(mesh, uv, mesh.faceVertices) : writePly(mesh, {}, {});
      CHECK((bytes.find("property float x") != std::string::npos) == isSingle);
      CHECK((bytes.find("property float s\nproperty float t\n") != std::string::npos) == hasUv);
      const PolygonMesh back = read(bytes);
      CHECK(back.positions == mesh.positions);
      CHECK(back.faceOffsets == mesh.faceOffsets);
      CHECK(back.faceVertices == mesh.faceVertices);
    }
  }
  const PolygonMesh large = star(200);  // one face with 400 corners
  CHECK(read(writePly(large, {}, {})).faceVertices == large.faceVertices);
}
