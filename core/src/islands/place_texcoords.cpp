#include "islands/place_texcoords.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/round_texcoords.h"

namespace abflat {
namespace {

std::array<double, 2> placed(const IslandStack& stack, const Placement& p, const double* uv) {
  const double around[] = {stack.placed(uv[0], 0), stack.placed(uv[1], 1)};
  return {p.u(around) + p.column(), p.v(around) + p.row()};
}

/// Visits corners with texcoords, with their stacks.
template <class Visit>
void forEachMappedCorner(const PolygonMesh& mesh, const MeshLayout& layout, const Visit& visit) {
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c)
      if (mesh.faceTexcoords[c] != kNoTexcoord) visit(c, mesh.faceTexcoords[c], layout.stackOf(f));
}

/// Per texcoord, the stack of the first corner that uses it.
std::vector<std::optional<std::uint32_t>> firstStacks(const PolygonMesh& mesh,
                                                      const MeshLayout& layout) {
  std::vector<std::optional<std::uint32_t>> out(mesh.texcoords.size() / 2);
  forEachMappedCorner(mesh, layout,
                      [&](std::uint32_t, std::uint32_t texcoord, std::uint32_t stack) {
                        if (!out[texcoord]) out[texcoord] = stack;
                      });
  return out;
}

/// What stays must not change where it has this precision already, nor become infinite.
void roundStill(Precision precision, std::vector<double>& uv) {
  constexpr double kMost = std::numeric_limits<float>::max();
  if (precision == Precision::Double) return;
  for (double& x : uv) x = std::clamp(x, -kMost, kMost);
  if (precision == Precision::Gltf)
    roundForGltf(uv);
  else
    roundToSingle(uv);
}

void roundPlaced(Precision precision, std::vector<double>& uv) {
  if (precision == Precision::Gltf) roundForGltf(uv);
  if (precision == Precision::Single) roundInAtlas(uv);
}

/// `isStill`: per texcoord.
void round(Precision precision, const std::vector<bool>& isStill, std::vector<double>& uv) {
  std::vector<double> still = uv;
  roundStill(precision, still);
  roundPlaced(precision, uv);
  for (std::size_t i = 0; i < uv.size(); ++i)
    if (isStill[i / 2]) uv[i] = still[i];
}

}  // namespace

PlacedTexcoords placeTexcoords(const PolygonMesh& mesh, const MeshLayout& layout,
                               const Packing& packing, const PackLayoutOptions& options) {
  PlacedTexcoords out;
  std::vector<bool> isStill;
  const auto add = [&](std::uint32_t texcoord, std::uint32_t stack) {
    const double* uv = &mesh.texcoords[2 * std::size_t{texcoord}];
    isStill.push_back(options.keepPlaces || (stack != kNoStack && layout.stacks[stack].isFixed));
    const auto [u, v] = stack == kNoStack || isStill.back()
                            ? std::array<double, 2>{uv[0], uv[1]}
                            : placed(layout.stacks[stack], packing.placements[stack], uv);
    out.uv.insert(out.uv.end(), {u, v});
    return static_cast<std::uint32_t>(out.uv.size() / 2 - 1);
  };
  const std::vector<std::optional<std::uint32_t>> stackOf = firstStacks(mesh, layout);
  std::vector<std::uint32_t> number(stackOf.size(), kNoTexcoord);
  for (std::uint32_t t = 0; t < stackOf.size(); ++t)
    if (stackOf[t]) number[t] = add(t, *stackOf[t]);
  // A texcoord stays one unless islands share it that have moved apart.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> others;  // by texcoord and stack
  out.cornerUv.assign(mesh.faceVertices.size(), kNoTexcoord);
  forEachMappedCorner(mesh, layout,
                      [&](std::uint32_t corner, std::uint32_t texcoord, std::uint32_t stack) {
                        out.cornerUv[corner] = number[texcoord];
                        if (stackOf[texcoord] == stack) return;
                        const auto [at, isNew] = others.try_emplace({texcoord, stack}, 0);
                        if (isNew) at->second = add(texcoord, stack);
                        out.cornerUv[corner] = at->second;
                      });
  round(options.precision, isStill, out.uv);
  return out;
}

}  // namespace abflat
