#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "abflat/pack_layout.h"
#include "abflat/verify.h"
#include "atlas_oracle.h"
#include "exact_turn.h"
#include "expect.h"
#include "layout_cases.h"
#include "round_trip.h"
#include "targets.h"

namespace abflat::fuzz {
namespace {

using Uv = std::complex<double>;

Uv uvAt(const std::vector<double>& uv, std::uint32_t i) {
  return {uv[2 * std::size_t{i}], uv[2 * std::size_t{i} + 1]};
}

struct Box {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};

  void add(Uv p) {
    const double at[] = {p.real(), p.imag()};
    for (int d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], at[d]);
      high[d] = std::max(high[d], at[d]);
    }
  }
  double size() const { return std::max(high[0] - low[0], high[1] - low[1]); }
  bool isApartFrom(const Box& b, double gap) const {
    return low[0] - b.high[0] > gap || b.low[0] - high[0] > gap || low[1] - b.high[1] > gap ||
           b.low[1] - high[1] > gap;
  }
};

/// A mesh, its layout, and what became of it.
struct PackedMesh {
  const PolygonMesh& mesh;
  const PackLayoutResult& result;

  Uv before(std::uint32_t c) const { return uvAt(mesh.texcoords, mesh.faceTexcoords[c]); }
  Uv after(std::uint32_t c) const { return uvAt(result.uv, result.cornerUv[c]); }
};

/// Visits the corners of islands.
template <class Visit>
void forEachCorner(const PackedMesh& p, const Visit& visit) {
  for (std::uint32_t f = 0; f < p.mesh.faceCount(); ++f)
    if (const std::uint32_t island = p.result.islandOfFace[f]; island != kNoIsland)
      for (std::uint32_t c = p.mesh.faceOffsets[f]; c < p.mesh.faceOffsets[f + 1]; ++c)
        visit(island, c);
}

void expectStays(const PackedMesh& p, Precision precision) {
  for (std::uint32_t f = 0; f < p.mesh.faceCount(); ++f)
    for (std::uint32_t c = p.mesh.faceOffsets[f]; c < p.mesh.faceOffsets[f + 1]; ++c) {
      const bool isMissing = p.mesh.faceTexcoords[c] == kNoTexcoord;
      expect((p.result.cornerUv[c] == kNoTexcoord) == isMissing, "corners keep having texcoords");
      if (!isMissing && p.result.islandOfFace[f] == kNoIsland && precision == Precision::Double)
        expect(p.before(c) == p.after(c), "faces that are no island stay where they are");
    }
}

/// Where texels are square and the longer side of the texture is 1.
struct SquareTexels {
  double width = 1, height = 1;

  explicit SquareTexels(const AtlasSize& size)
      : width(size.width / static_cast<double>(size.longer())),
        height(size.height / static_cast<double>(size.longer())) {}
  Uv operator()(Uv p) const { return {width * p.real(), height * p.imag()}; }
  /// Of the unit square.
  double area() const { return width * height; }
};

/// What does not hold of: every island is moved, turned and scaled as a whole.
std::string shapeComplaint(const PackedMesh& p, const AtlasSize& was, const AtlasSize& is,
                           bool isSameScale) {
  constexpr double kNear = 1e-9;
  const SquareTexels before(was), after(is);
  const double scale = p.result.report.scale * std::sqrt(after.area() / before.area());
  struct Similarity {
    std::uint32_t first = 0, farthest = 0;
    bool isSet = false;
  };
  std::vector<Similarity> of(p.result.report.islands);
  const auto way = [&](std::uint32_t from, std::uint32_t to) {
    return before(p.before(to) - p.before(from));
  };
  forEachCorner(p, [&](std::uint32_t island, std::uint32_t c) {
    Similarity& s = of[island];
    if (!s.isSet) s = {c, c, true};
    if (std::abs(way(s.first, c)) > std::abs(way(s.first, s.farthest))) s.farthest = c;
  });
  std::string out;
  forEachCorner(p, [&](std::uint32_t island, std::uint32_t c) {
    const Similarity& s = of[island];
    const Uv reach = way(s.first, s.farthest);
    if (!(std::abs(reach) > 0)) return;
    const Uv turn = after(p.after(s.farthest) - p.after(s.first)) / reach;
    const Uv wanted = turn * way(s.first, c);
    if (!(std::abs(after(p.after(c) - p.after(s.first)) - wanted) < kNear))
      out = "islands keep their shapes";
    if (isSameScale && scale > 0 && !(std::abs(std::abs(turn) - scale) * std::abs(reach) < kNear))
      out = "islands keep their sizes beside each other";
  });
  return out;
}

/// The layout was made for a texture of this shape, or for a square.
void expectShapes(const PackedMesh& p, const AtlasSize& size, bool isSameScale) {
  std::string wrong = shapeComplaint(p, size, size, isSameScale);
  if (!wrong.empty()) wrong = shapeComplaint(p, 1, size, isSameScale);
  expect(wrong.empty(), wrong);
}

/// One triangle of the result for the oracle, the right way round.
std::array<double, 6> triangleAt(const PackedMesh& p, std::size_t i) {
  std::array<double, 6> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Uv uv = p.after(p.result.triangleCorners[3 * i + k]);
    out[2 * k] = uv.real();
    out[2 * k + 1] = uv.imag();
  }
  if (exactTurn(&out[0], &out[2], &out[4]) < 0) std::swap_ranges(&out[2], &out[4], &out[4]);
  return out;
}

/// Islands lie in tiles, and what clearly lay apart does not overlap.
void expectPlaces(const PackedMesh& p) {
  std::vector<Box> boxes(p.result.report.islands);
  forEachCorner(p, [&](std::uint32_t island, std::uint32_t c) { boxes[island].add(p.before(c)); });
  const PackedVertices vertices = packedVertices(p.mesh, p.result);
  struct Triangle {
    std::array<double, 6> uv;
    Box box;
    std::uint32_t island;
  };
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < vertices.islandOfTriangle.size(); ++i) {
    if (vertices.islandOfTriangle[i] == kNoIsland) continue;
    Triangle t{triangleAt(p, i), {}, vertices.islandOfTriangle[i]};
    for (std::size_t k = 0; k < 3; ++k) t.box.add({t.uv[2 * k], t.uv[2 * k + 1]});
    const std::string wrong =
        complaint({{t.uv.begin(), t.uv.end()}, {true}}, p.result.report.tiles);
    expect(wrong.empty(), "a valid layout: " + wrong);
    triangles.push_back(t);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Triangle &a = triangles[i], &b = triangles[j];
      const Box &wasA = boxes[a.island], &wasB = boxes[b.island];
      // Rounding may close a gap that is hardly there.
      const double gap = 1e-6 * std::max(wasA.size(), wasB.size());
      if (a.island == b.island || !wasA.isApartFrom(wasB, gap) || a.box.isApartFrom(b.box, 0))
        continue;
      AtlasTriangles both{{a.uv.begin(), a.uv.end()}, {true, true}};
      both.uv.insert(both.uv.end(), b.uv.begin(), b.uv.end());
      expect(overlapComplaint(both).empty(), "islands that lay apart do not overlap");
    }
}

/// verify sees the layout that pack was given as pack sees it where that stays.
void expectVerdict(const PolygonMesh& mesh, const PackLayoutOptions& options,
                   const PackLayoutResult& packed) {
  VerifyOptions asked;
  asked.resolution = options.resolution;
  asked.udim = options.udim;
  asked.padding = options.padding;
  const Result<VerifyResult> found = verifyLayout(mesh, asked);
  expect(found.ok(), "what can be packed can be verified: " + found.status().message);
  const VerifyReport& report = found.value().report;
  verifyReportJson(report);
  expect(report.islands == packed.report.islands, "both find the same islands");
  expect(report.valid == report.findings.empty(), "what has findings is not valid");
  if (!options.keepPlaces || options.precision != Precision::Double) return;
  const PackReport& kept = packed.report;
  expect(report.facesOverlapping == kept.facesOverlapping && report.facesEmpty == kept.facesEmpty &&
             report.facesFlipped == kept.facesFlipped,
         "both find the same faults");
}

}  // namespace

bool packMesh(const std::uint8_t* bytes, std::size_t size) {
  const auto [mesh, options] = packCase(bytes, size);
  const Result<PackLayoutResult> result = packLayout(mesh, options);
  if (!result.ok()) {
    expectReason(result.status(),
                 {StatusCode::EmptyMesh, StatusCode::AtlasTooSmall, StatusCode::InvalidOption,
                  StatusCode::InvalidMesh, StatusCode::NoTexcoords});
    return false;
  }
  const PackedMesh packed{mesh, result.value()};
  const PackReport& report = result.value().report;
  packReportJson(report);
  expectStays(packed, options.precision);
  expectVerdict(mesh, options, result.value());
  if (options.keepPlaces && options.precision == Precision::Double)
    forEachCorner(packed, [&](std::uint32_t, std::uint32_t c) {
      expect(packed.before(c) == packed.after(c), "what is to stay stays where it is");
    });
  if (options.precision == Precision::Double && !options.snapToTexels)
    expectShapes(packed, options.resolution, options.islandSizes == IslandSizes::Keep);
  if (report.valid) expectPlaces(packed);
  if (report.unmapped == 0 && options.precision != Precision::Gltf)
    expectFile(mesh, {result.value().uv, result.value().cornerUv},
               options.precision == Precision::Single ? MeshFormat::Ply : MeshFormat::Obj);
  return true;
}

}  // namespace abflat::fuzz
