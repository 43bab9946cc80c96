#include "abflat/pack_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "abflat/inspect.h"
#include "base/counted.h"
#include "base/guarded.h"
#include "base/listener.h"
#include "base/parallel.h"
#include "base/round_texcoords.h"
#include "base/stopwatch.h"
#include "flatten/flatten_chart.h"
#include "islands/check_places.h"
#include "islands/find_islands.h"
#include "islands/stack_islands.h"
#include "islands/stack_shapes.h"
#include "mesh/input_mesh.h"
#include "mesh/triangle_geometry.h"
#include "mesh/triangulate.h"
#include "pack/pack.h"

namespace abflat {
namespace {

Status cancelled() { return {StatusCode::Aborted, "cancelled"}; }

double ratio(double a, double b) { return a > 0 && b > 0 ? a / b : 0; }

/// The number of tiles that have islands, or the area of all tiles around the layout where an
/// island is larger than one.
double roomBefore(const std::vector<IslandStack>& stacks) {
  constexpr double kSide = 1.01;  // islands may be a little beyond their tile
  std::set<std::array<double, 2>> tiles;
  UvBox all;
  bool isWithin = true;
  for (const IslandStack& stack : stacks) {
    tiles.insert({std::floor(stack.middle(0)), std::floor(stack.middle(1))});
    for (const auto& corner : {stack.box.low, stack.box.high}) all.add(corner.data());
    for (std::size_t d = 0; d < 2; ++d)
      isWithin = isWithin && stack.box.high[d] - stack.box.low[d] <= kSide;
  }
  if (isWithin) return static_cast<double>(tiles.size());
  return (std::ceil(all.high[0]) - std::floor(all.low[0])) *
         (std::ceil(all.high[1]) - std::floor(all.low[1]));
}

/// A single call of packLayout.
class LayoutPacker {
 public:
  LayoutPacker(const PolygonMesh& mesh, const PackLayoutOptions& options)
      : mesh_(mesh), options_(options), listener_(options.progress) {}

  Result<PackLayoutResult> run() {
    Stopwatch watch;
    if (Status s = checkInput(); !s.ok()) return s;
    out_.report.options = options_;
    out_.report.input = inspect(mesh_);
    const Listener packing = listener_.part(Stage::Pack, 0, 0.9);
    if (!packing.tell()) return cancelled();
    if (Status s = readIslands(packing); !s.ok()) return s;
    if (Status s = packStacks(packing.part(0.3, 1)); !s.ok()) return s;
    placeTexcoords();
    out_.report.timings.pack = watch.lap();
    if (!listener_.part(Stage::Check, 0.9, 1).tell()) return cancelled();
    describe();
    out_.report.timings.check = watch.lap();
    return std::move(out_);
  }

 private:
  Status checkInput() const {
    if (Status s = validateArrays(mesh_); !s.ok()) return s;
    if (mesh_.faceCount() == 0) return {StatusCode::EmptyMesh, "the mesh has no faces"};
    if (options_.udim && options_.texelDensity == kAutoTexelDensity)
      return {StatusCode::InvalidOption, "udim needs a numeric texel density"};
    if (mesh_.faceTexcoords.empty()) return noTexcoords();
    return {};
  }

  static Status noTexcoords() {
    return {StatusCode::NoTexcoords,
            "no face has texcoords, so there is no layout to pack. Make one with unwrap"};
  }

  /// Finds islands and stacks.
  Status readIslands(const Listener& listener) {
    Islands islands = findIslands(mesh_);
    if (islands.count == 0) return noTexcoords();
    out_.islandOfFace = std::move(islands.ofFace);
    out_.report.islands = islands.count;
    out_.report.unmapped = static_cast<std::size_t>(
        std::count(out_.islandOfFace.begin(), out_.islandOfFace.end(), kNoIsland));
    if (!listener.tell(0.1)) return cancelled();
    listTriangles(triangulate(mesh_), islands.count);
    if (!listener.tell(0.2)) return cancelled();
    const IslandStacks found = stackIslands(triangles_, listener);
    if (listener.isStopped()) return cancelled();
    out_.report.separated = static_cast<std::size_t>(
        std::count(found.overlapsOthers.begin(), found.overlapsOthers.end(), 1));
    stacks_ = listStacks(triangles_, found.first, surfaceArea_);
    stackOf_.resize(islands.count);
    for (std::uint32_t s = 0; s < stacks_.size(); ++s) {
      for (const std::uint32_t i : stacks_[s].islands) stackOf_[i] = s;
      out_.report.stackedIslands += stacks_[s].islands.size() - 1;
      out_.report.stackedStacks += stacks_[s].islands.size() > 1;
    }
    return {};
  }

  /// Groups the triangles by island, and measures them.
  void listTriangles(const Triangulation& all, std::uint32_t islands) {
    out_.triangleCorners.assign(all.corner.begin(), all.corner.end());
    std::vector<std::uint32_t>& begin = triangles_.begin;
    begin.assign(islands + 1, 0);
    for (const PolygonFace f : all.face)
      if (const std::uint32_t i = out_.islandOfFace[f]; i != kNoIsland) ++begin[i + 1];
    for (std::uint32_t i = 0; i < islands; ++i) begin[i + 1] += begin[i];
    cornersOf_.resize(begin.back());
    triangles_.uv.resize(6 * cornersOf_.size());
    faceOf_.resize(cornersOf_.size());
    surfaceArea_.assign(islands, 0);
    exponent_ = exponentOf(mesh_);
    std::vector<double> positions = mesh_.positions;
    for (double& x : positions) x = std::ldexp(x, -exponent_);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    std::vector<double> signedArea(islands, 0);
    for (std::size_t t = 0; 3 * t < out_.triangleCorners.size(); ++t) {
      const std::uint32_t face = all.face[SurfaceTriangle(t)], island = out_.islandOfFace[face];
      if (island == kNoIsland) continue;
      const std::uint32_t at = next[island]++;
      faceOf_[at] = face;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t c = cornersOf_[at][k] = out_.triangleCorners[3 * t + k];
        const double* uv = &mesh_.texcoords[2 * std::size_t{mesh_.faceTexcoords[c]}];
        std::copy(uv, uv + 2, &triangles_.uv[6 * std::size_t{at} + 2 * k]);
      }
      const auto& [a, b, c] = cornersOf_[at];
      surfaceArea_[island] +=
          areaOf(positions, {mesh_.faceVertices[a], mesh_.faceVertices[b], mesh_.faceVertices[c]});
      signedArea[island] += doubleArea(&triangles_.uv[6 * std::size_t{at}]);
    }
    out_.report.mirrored = static_cast<std::size_t>(
        std::count_if(signedArea.begin(), signedArea.end(), [](double a) { return a < 0; }));
  }

  Status packStacks(const Listener& listener) {
    setFactors();
    ThreadPool pool(usefulThreads(options_.threads, cornersOf_.size()));
    pool.listen(listener);
    out_.report.threads = pool.threads();
    std::vector<PackShape> shapes;
    shapes.reserve(stacks_.size());
    for (const IslandStack& stack : stacks_) {
      shapes.push_back(shapeOf(stack, triangles_));
      if (!listener.beat(shapes.back().triangles.size())) return cancelled();
    }
    PackOptions how = packOptionsOf(options_);
    how.unit = std::ldexp(1.0, exponent_);
    how.work = usualWork(shapes);
    how.pool = &pool;
    how.listener = listener;
    Result<Packing> packed = pack(std::move(shapes), how);
    if (!packed.ok()) return packed.status();
    packing_ = std::move(packed.value());
    return {};
  }

  /// Shapes have about the area of their surface, so that a texel density can be asked for.
  void setFactors() {
    double onSurface = 0, inUv = 0;
    for (const IslandStack& stack : stacks_) {
      onSurface += stack.surfaceArea;
      inUv += stack.uvArea;
    }
    const double mean = ratio(onSurface, inUv);
    for (IslandStack& stack : stacks_) {
      const double own = ratio(stack.surfaceArea, stack.uvArea);
      const bool isEven = options_.islandSizes == IslandSizes::Even && own > 0;
      const double area = isEven ? own : mean;
      stack.factor = area > 0 ? std::sqrt(area) : 1;
    }
  }

  std::array<double, 2> placed(std::uint32_t stack, const double* uv) const {
    const IslandStack& s = stacks_[stack];
    const Placement& p = packing_.placements[stack];
    const double around[] = {(uv[0] - s.middle(0)) * s.factor, (uv[1] - s.middle(1)) * s.factor};
    return {p.u(around) + p.column(), p.v(around) + p.row()};
  }

  /// A texcoord stays one unless islands share it that have moved apart.
  void placeTexcoords() {
    using Key = std::pair<std::uint32_t, std::uint32_t>;  // a texcoord and its stack
    std::vector<std::uint32_t> stackOf(mesh_.texcoords.size() / 2, kNoIsland);
    std::vector<std::uint8_t> isUsed(stackOf.size(), 0);
    forEachCorner([&](std::uint32_t, std::uint32_t texcoord, std::uint32_t stack) {
      if (!isUsed[texcoord]) stackOf[texcoord] = stack;
      isUsed[texcoord] = 1;
    });
    std::vector<std::uint32_t> number(stackOf.size(), kNoTexcoord);
    for (std::uint32_t t = 0; t < stackOf.size(); ++t)
      if (isUsed[t]) number[t] = addTexcoord(t, stackOf[t]);
    std::map<Key, std::uint32_t> others;
    out_.cornerUv.assign(mesh_.faceVertices.size(), kNoTexcoord);
    forEachCorner([&](std::uint32_t corner, std::uint32_t texcoord, std::uint32_t stack) {
      std::uint32_t& out = out_.cornerUv[corner];
      out = number[texcoord];
      if (stackOf[texcoord] == stack) return;
      const auto [at, isNew] = others.try_emplace({texcoord, stack}, 0);
      if (isNew) at->second = addTexcoord(texcoord, stack);
      out = at->second;
    });
    if (options_.precision == Precision::Single) roundInAtlas(out_.uv);
    if (options_.precision == Precision::Gltf) roundForGltf(out_.uv);
  }

  /// Visits corners with texcoords, with their stacks; kNoIsland is that of faces that stay.
  template <class Visit>
  void forEachCorner(const Visit& visit) const {
    for (std::uint32_t f = 0; f < mesh_.faceCount(); ++f) {
      const std::uint32_t island = out_.islandOfFace[f];
      for (std::uint32_t c = mesh_.faceOffsets[f]; c < mesh_.faceOffsets[f + 1]; ++c)
        if (mesh_.faceTexcoords[c] != kNoTexcoord)
          visit(c, mesh_.faceTexcoords[c], island == kNoIsland ? kNoIsland : stackOf_[island]);
    }
  }

  std::uint32_t addTexcoord(std::uint32_t texcoord, std::uint32_t stack) {
    const double* uv = &mesh_.texcoords[2 * std::size_t{texcoord}];
    const auto [u, v] =
        stack == kNoIsland ? std::array<double, 2>{uv[0], uv[1]} : placed(stack, uv);
    out_.uv.insert(out_.uv.end(), {u, v});
    return static_cast<std::uint32_t>(out_.uv.size() / 2 - 1);
  }

  void describe() {
    PackReport& report = out_.report;
    report.resolution = options_.resolution;
    report.padding = options_.padding;
    report.tiles = static_cast<int>(packing_.tiles);
    double before = 0, now = 0, covered = 0, onSurface = 0;
    for (const IslandStack& stack : stacks_) {
      const double growth = packing_.scale * stack.factor * packing_.scale * stack.factor;
      before += stack.uvArea;
      now += stack.uvArea * growth;
      covered += stack.coveredArea;
      onSurface += stack.surfaceArea;
    }
    report.scale = std::sqrt(ratio(now, before));
    report.utilizationBefore = covered / roomBefore(stacks_);
    report.utilization = packing_.utilization;
    report.texelDensity =
        options_.resolution * std::ldexp(std::sqrt(ratio(now, onSurface)), -exponent_);
    addNotes();
    std::string problem = problemOf(placedTriangles(), packing_.tiles);
    report.valid = problem.empty();
    if (!report.valid) report.notes.push_back(std::move(problem));
  }

  PlacedTriangles placedTriangles() const {
    PlacedTriangles out;
    out.face = faceOf_;
    out.uv.reserve(6 * cornersOf_.size());
    for (std::uint32_t i = 0; i < triangles_.islands(); ++i)
      for (std::uint32_t t = triangles_.begin[i]; t < triangles_.begin[i + 1]; ++t) {
        out.stack.push_back(stackOf_[i]);
        for (const std::uint32_t c : cornersOf_[t]) {
          const double* uv = &out_.uv[2 * std::size_t{out_.cornerUv[c]}];
          out.uv.insert(out.uv.end(), {uv[0], uv[1]});
        }
      }
    return out;
  }

  void addNotes() {
    PackReport& report = out_.report;
    const auto note = [&](std::size_t n, const char* one, const char* many) {
      if (n > 0) report.notes.push_back(counted(n, one, many));
    };
    note(report.stackedIslands, "island lies on another and moved together with it",
         "islands lie on others and moved together with them");
    note(report.separated, "island overlapped another by less than half and is apart now",
         "islands overlapped others by less than half and are apart now");
    note(report.unmapped, "face has no texcoords and stays as it was",
         "faces have no texcoords and stay as they were");
  }

  const PolygonMesh& mesh_;
  const PackLayoutOptions& options_;
  const Listener listener_;
  int exponent_ = 0;  ///< areas in 3D are in units of 4^exponent
  IslandTriangles triangles_;
  std::vector<std::array<std::uint32_t, 3>> cornersOf_;  ///< per triangle of these
  std::vector<std::uint32_t> faceOf_;                    ///< likewise
  std::vector<double> surfaceArea_;                      ///< per island
  std::vector<IslandStack> stacks_;
  std::vector<std::uint32_t> stackOf_;  ///< per island
  Packing packing_;
  PackLayoutResult out_;
};

}  // namespace

Result<PackLayoutResult> packLayout(const PolygonMesh& mesh, const PackLayoutOptions& options) {
  return guarded([&]() -> Result<PackLayoutResult> { return LayoutPacker(mesh, options).run(); });
}

}  // namespace abflat
