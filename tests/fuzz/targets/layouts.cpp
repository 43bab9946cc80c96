#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "abflat/unwrap.h"
#include "atlas_oracle.h"
#include "expect.h"
#include "layout_cases.h"
#include "round_trip.h"
#include "stack_oracle.h"
#include "targets.h"

namespace abflat::fuzz {
namespace {

/// Too thin for the angles that it has: all of its height is lost beside its longest edge.
bool isFlatOnSurface(const PolygonMesh& mesh, const std::array<std::uint32_t, 3>& vertices) {
  using Vector = std::array<double, 3>;
  double extent = 0;
  for (const std::uint32_t v : mesh.faceVertices)
    for (std::size_t d = 0; d < 3; ++d)
      extent = std::max(extent, std::fabs(mesh.positions[3 * std::size_t{v} + d]));
  std::array<Vector, 3> edges{};
  double longest = 0, shortest = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t d = 0; d < 3; ++d)
      edges[k][d] = mesh.positions[3 * std::size_t{vertices[(k + 1) % 3]} + d] / extent -
                    mesh.positions[3 * std::size_t{vertices[k]} + d] / extent;
    const double length = std::hypot(edges[k][0], edges[k][1], edges[k][2]);
    longest = std::max(longest, length);
    shortest = std::min(shortest, length);
  }
  if (!(shortest > 1e-6)) return true;
  const auto& [a, b, c] = edges;
  const double area =
      std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  return !(area > 1e-6 * longest * longest);
}

/// Triangles of the result, which the texcoords are written for.
AtlasTriangles trianglesOf(const PolygonMesh& mesh, const UnwrapResult& result) {
  AtlasTriangles out;
  const std::size_t count = result.triangles.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = result.triangles[3 * i + k];
      vertices[k] = result.vertexMap[v];
      const std::size_t texcoord = result.vertexUv[v];
      out.uv.insert(out.uv.end(), {result.uv[2 * texcoord], result.uv[2 * texcoord + 1]});
    }
    out.mayBeFlat.push_back(isFlatOnSurface(mesh, vertices));
  }
  return out;
}

/// No triangle is so much smaller than the mesh that an atlas in single precision cannot show it.
bool isOrdinary(const PolygonMesh& mesh) {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double shortest = HUGE_VAL, extent = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
      const std::uint32_t next = c + 1 == mesh.faceOffsets[f + 1] ? mesh.faceOffsets[f] : c + 1;
      const double* p = &mesh.positions[3 * std::size_t{mesh.faceVertices[c]}];
      const double* q = &mesh.positions[3 * std::size_t{mesh.faceVertices[next]}];
      const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
      if (length > 0) shortest = std::min(shortest, length);
      for (std::size_t d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], p[d]);
        high[d] = std::max(high[d], p[d]);
        extent = std::max(extent, high[d] - low[d]);
      }
    }
  return extent < 1e4 * shortest;
}

bool fitsSingle(const PolygonMesh& mesh) {
  return std::all_of(mesh.faceVertices.begin(), mesh.faceVertices.end(), [&](std::uint32_t v) {
    const double* p = &mesh.positions[3 * std::size_t{v}];
    return std::all_of(p, p + 3, [](double x) { return std::fabs(x) < 3.4e38; });
  });
}

/// The chart of each triangle of a glTF, which has those of a material together.
std::vector<std::uint32_t> chartsInGltf(const PolygonMesh& mesh, const UnwrapResult& result) {
  if (mesh.faceMaterials.empty()) return result.chartOfTriangle;
  const auto materialOf = [&](std::size_t t) {
    const auto next = std::upper_bound(mesh.faceOffsets.begin(), mesh.faceOffsets.end(),
                                       result.triangleCorners[3 * t]);
    return mesh.faceMaterials[static_cast<std::size_t>(next - mesh.faceOffsets.begin()) - 1];
  };
  std::vector<std::size_t> order(result.chartOfTriangle.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return materialOf(a) < materialOf(b); });
  std::vector<std::uint32_t> out;
  for (const std::size_t t : order) out.push_back(result.chartOfTriangle[t]);
  return out;
}

/// Of a GLB: what is in the file is what counts, its triangles included.
void expectValidGltf(const PolygonMesh& mesh, const UnwrapResult& result) {
  const Result<std::string> bytes =
      makeGltf(mesh, result.uv, result.cornerUv, result.triangleCorners, {}, {});
  if (!bytes.ok()) {
    expect(!fitsSingle(mesh), "an atlas can be written as a glTF: " + bytes.status().message);
    return;
  }
  const Result<GltfModel> again =
      abflat::readGltf(bytes.value(), "written", [](const std::string&) {
        return Result<std::string>(Status{StatusCode::UnreadableFile, "there is no such file"});
      });
  expect(again.ok(), "what is written can be read: " + again.status().message);
  const PolygonMesh& read = again.value().mesh;
  AtlasTriangles triangles;
  for (std::size_t f = 0; f < read.faceCount(); ++f) {
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[k] = read.faceVertices[3 * f + k];
      const std::size_t texcoord = read.faceTexcoords[3 * f + k];
      triangles.uv.insert(triangles.uv.end(),
                          {read.texcoords[2 * texcoord], read.texcoords[2 * texcoord + 1]});
    }
    triangles.mayBeFlat.push_back(isFlatOnSurface(read, vertices));
  }
  const std::string wrong = stackedComplaint(triangles, chartsInGltf(mesh, result), result.report);
  expect(wrong.empty(), "a valid glTF: " + wrong);
}

}  // namespace

bool unwrapMesh(const std::uint8_t* bytes, std::size_t size) {
  const auto [mesh, options, isPlain] = unwrapCase(bytes, size);
  const Result<UnwrapResult> result = unwrap(mesh, options);
  if (!result.ok()) {
    expectReason(result.status(), {StatusCode::EmptyMesh, StatusCode::AtlasTooSmall,
                                   StatusCode::InvalidOption, StatusCode::InvalidMesh});
    return false;
  }
  const UnwrapReport& report = result.value().report;
  unwrapReportJson(report);
  if (isPlain && isOrdinary(mesh))
    expect(report.valid, "with the usual options the atlas is valid");
  if (!report.valid) return true;
  const std::string wrong =
      stackedComplaint(trianglesOf(mesh, result.value()), result.value().chartOfTriangle, report);
  expect(wrong.empty(), "a valid atlas: " + wrong);
  if (options.precision == Precision::Gltf)
    expectValidGltf(mesh, result.value());
  else
    expectFile(mesh, {result.value().uv, result.value().cornerUv},
               options.precision == Precision::Single ? MeshFormat::Ply : MeshFormat::Obj);
  return true;
}

bool flattenMesh(const std::uint8_t* bytes, std::size_t size) {
  const auto [mesh, options, precision] = flattenCase(bytes, size);
  Result<FlattenResult> result = flatten(mesh, options);
  if (!result.ok()) {
    expect(!result.status().message.empty(), "a refusal has a reason");
    expect(result.status().code != StatusCode::Internal, result.status().message);
    return false;
  }
  if (precision == Precision::Single) roundToSinglePrecision(mesh, result.value());
  if (precision == Precision::Gltf) roundForGltf(mesh, result.value());
  reportJson(result.value().report);
  if (!result.value().report.valid) return true;
  AtlasTriangles triangles;
  const std::vector<std::uint32_t>& corners = result.value().triangles;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const std::array<std::uint32_t, 3> vertices{corners[i], corners[i + 1], corners[i + 2]};
    for (const std::uint32_t v : vertices)
      triangles.uv.insert(triangles.uv.end(), {result.value().uv[2 * std::size_t{v}],
                                               result.value().uv[2 * std::size_t{v} + 1]});
    triangles.mayBeFlat.push_back(isFlatOnSurface(mesh, vertices));
  }
  const std::string wrong = overlapComplaint(triangles);
  expect(wrong.empty(), "a valid layout: " + wrong);
  return true;
}

}  // namespace abflat::fuzz
