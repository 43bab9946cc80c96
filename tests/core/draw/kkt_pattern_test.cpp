#include "draw/kkt_pattern.h"

#include <set>

#include "abflat/draw.h"
#include "abflat/samples.h"
#include "catch.h"

using namespace abflat;

namespace {

PolygonMesh sampleOf(std::string_view name) {
  for (const Sample& sample : samples())
    if (sample.name == name) return sample.make(1);
  return {};
}

}  // namespace

TEST_CASE("the system matrix is symmetric, with a diagonal Hessian in the log form only",
          "[draw]") {
  const PolygonMesh mesh = sampleOf("head");
  for (const Formulation form : {Formulation::Log, Formulation::Product}) {
    const Result<KktPattern> result = kktPattern(mesh, 1, form);
    REQUIRE(result.ok());
    const KktPattern& p = result.value();
    std::set<std::array<std::uint32_t, 2>> entries(p.entries.begin(), p.entries.end());
    CHECK(entries.size() == p.entries.size());
    const std::size_t angles = p.blocks.front().end;
    bool isSymmetric = true, isHessianDiagonal = true, isRestEmpty = true;
    for (const auto& [r, c] : p.entries) {
      isSymmetric = isSymmetric && entries.count({c, r}) == 1;
      if (r < angles && c < angles) isHessianDiagonal = isHessianDiagonal && r == c;
      if (r >= angles && c >= angles) isRestEmpty = false;
    }
    CHECK(isSymmetric);
    CHECK(isRestEmpty);
    CHECK(isHessianDiagonal == (form == Formulation::Log));
    CHECK((p.hessianEntries == angles) == (form == Formulation::Log));
  }
}

TEST_CASE("blocks follow each other and count what the mesh has", "[draw]") {
  const PolygonMesh mesh = sampleOf("alpha-band");
  const Result<KktPattern> result = kktPattern(mesh, 1, Formulation::Log);
  REQUIRE(result.ok());
  const std::vector<KktBlock>& b = result.value().blocks;
  REQUIRE(b.size() == 5);
  for (std::size_t i = 1; i < b.size(); ++i) CHECK(b[i].begin == b[i - 1].end);
  CHECK(b[0].end == 3 * mesh.faceCount());
  CHECK(b[1].end - b[1].begin == mesh.faceCount());
  CHECK(b[2].end - b[2].begin == b[3].end - b[3].begin);
  // Bounds restrain a band that would cross itself if it were free.
  CHECK(b[4].end > b[4].begin);
  CHECK(b[4].end == result.value().size);
  const Result<KktPattern> free = kktPattern(mesh, 2, Formulation::Log);
  REQUIRE(free.ok());
  CHECK(free.value().blocks[4].begin == free.value().blocks[4].end);
}

TEST_CASE("a mesh that is no disk has no system matrix", "[draw]") {
  CHECK(drawKktMatrix({}, 1, Formulation::Log).status().code == StatusCode::EmptyMesh);
}
