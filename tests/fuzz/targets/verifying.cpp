#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "abflat/compare_meshes.h"
#include "abflat/pack_layout.h"
#include "abflat/verify.h"
#include "atlas_oracle.h"
#include "exact_turn.h"
#include "expect.h"
#include "layout_cases.h"
#include "targets.h"

namespace abflat::fuzz {
namespace {

bool has(std::uint8_t faults, UvFault fault) {
  return (faults & static_cast<std::uint8_t>(fault)) != 0;
}

/// A layout and what verify says of it.
struct JudgedMesh {
  const PolygonMesh& mesh;
  const VerifyOptions& options;
  const VerifyResult& result;

  const VerifyReport& report() const { return result.report; }
  std::size_t count() const { return result.faults.size(); }

  /// The corners of a triangle in uv.
  std::array<double, 6> at(std::size_t triangle) const {
    std::array<double, 6> out{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t t = mesh.faceTexcoords[result.triangleCorners[3 * triangle + k]];
      out[2 * k] = mesh.texcoords[2 * t];
      out[2 * k + 1] = mesh.texcoords[2 * t + 1];
    }
    return out;
  }
};

std::vector<std::uint32_t> facesOfTriangles(const JudgedMesh& judged) {
  std::vector<std::uint32_t> out;
  std::uint32_t f = 0;
  for (std::size_t t = 0; t < judged.count(); ++t) {
    while (judged.result.triangleCorners[3 * t] >= judged.mesh.faceOffsets[f + 1]) ++f;
    out.push_back(f);
  }
  return out;
}

/// Triangles of faces that have texcoords.
std::vector<std::size_t> mapped(const JudgedMesh& judged) {
  const std::vector<std::uint32_t> face = facesOfTriangles(judged);
  std::vector<std::size_t> out;
  for (std::size_t t = 0; t < judged.count(); ++t)
    if (judged.result.islandOfFace[face[t]] != kNoIsland) out.push_back(t);
  return out;
}

/// Each triangle is turned or empty where exact arithmetic says so.
void expectTurns(const JudgedMesh& judged) {
  for (const std::size_t t : mapped(judged)) {
    const std::array<double, 6> uv = judged.at(t);
    const int turn = exactTurn(&uv[0], &uv[2], &uv[4]);
    expect(has(judged.result.faults[t], UvFault::Flipped) == (turn < 0), "what runs clockwise");
    expect(has(judged.result.faults[t], UvFault::Empty) == (turn == 0), "what has no area");
  }
}

/// Each triangle overlaps another where exact arithmetic says so.
void expectOverlaps(const JudgedMesh& judged) {
  constexpr std::size_t kMost = 400;
  const std::vector<std::size_t> triangles = mapped(judged);
  if (triangles.size() > kMost) return;
  std::vector<std::array<double, 6>> solid;
  std::vector<std::size_t> number;
  for (const std::size_t t : triangles) {
    std::array<double, 6> uv = judged.at(t);
    const int turn = exactTurn(&uv[0], &uv[2], &uv[4]);
    if (turn == 0) continue;
    if (turn < 0) std::swap_ranges(&uv[2], &uv[4], &uv[4]);
    solid.push_back(uv);
    number.push_back(t);
  }
  std::vector<bool> overlaps(solid.size());
  for (std::size_t i = 0; i < solid.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (doOverlap(solid[i].data(), solid[j].data())) overlaps[i] = overlaps[j] = true;
  for (std::size_t i = 0; i < solid.size(); ++i)
    expect(has(judged.result.faults[number[i]], UvFault::Overlapping) == overlaps[i],
           "what overlaps");
}

void expectFindings(const JudgedMesh& judged) {
  const VerifyReport& report = judged.report();
  expect(report.valid == report.findings.empty(), "what has findings is not valid");
  expect(!verifyReportJson(report).empty(), "a report has a text");
  for (const VerifyFinding& finding : report.findings) {
    expect(!finding.message.empty(), "a finding has a sentence");
    constexpr std::size_t kMostNamed = 100;
    expect(finding.faces.size() <= kMostNamed, "a finding names a hundred faces at most");
    for (const std::uint32_t f : finding.faces)
      expect(f < judged.mesh.faceCount(), "a finding names faces of the mesh");
    for (const std::uint32_t i : finding.islands)
      expect(i < report.islands, "a finding names islands");
  }
}

/// What is exact stays the same when texcoords are halved, unless that rounds one of them.
void expectSameHalved(const JudgedMesh& judged) {
  constexpr double kMost = 1e100;  // larger numbers are no texcoords
  PolygonMesh halved = judged.mesh;
  for (double& x : halved.texcoords) {
    if (!(std::abs(x) <= kMost) || 2 * (x / 2) != x) return;
    x /= 2;
  }
  const Result<VerifyResult> again = verifyLayout(halved, judged.options);
  expect(again.ok(), "a smaller layout can be verified: " + again.status().message);
  const VerifyReport &is = again.value().report, &was = judged.report();
  expect(is.islands == was.islands && is.facesFlipped == was.facesFlipped &&
             is.facesEmpty == was.facesEmpty && is.facesOverlapping == was.facesOverlapping &&
             is.overlappingThemselves == was.overlappingThemselves,
         "the size of a layout does not matter");
}

void expectNoDifference(const PolygonMesh& mesh) {
  const std::vector<CornerAttribute> none;
  const auto differences = compareMeshes({mesh, none}, {mesh, none});
  expect(differences.ok() && differences.value().empty(), "a mesh is what it was made from");
}

}  // namespace

bool verifyMesh(const std::uint8_t* bytes, std::size_t size) {
  const auto [mesh, options] = verifyCase(bytes, size);
  const Result<VerifyResult> result = verifyLayout(mesh, options);
  if (!result.ok()) {
    expectReason(result.status(),
                 {StatusCode::EmptyMesh, StatusCode::InvalidMesh, StatusCode::NoTexcoords});
    return false;
  }
  const JudgedMesh judged{mesh, options, result.value()};
  expectFindings(judged);
  expectTurns(judged);
  expectOverlaps(judged);
  expectSameHalved(judged);
  expectNoDifference(mesh);
  return true;
}

}  // namespace abflat::fuzz
