#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "abflat/pack_layout.h"
#include "mesh/triangulate.h"

namespace abflat {
namespace {

/// A texcoord stays one unless its corners get different coordinates.
class Replacer {
 public:
  explicit Replacer(PolygonMesh& mesh)
      : mesh_(mesh), before_(mesh.faceTexcoords), isTaken_(mesh.texcoords.size() / 2, false) {}

  void set(std::uint32_t corner, double u, double v) {
    const std::uint32_t old = before_[corner];
    if (old == kNoTexcoord || !std::isfinite(u) || !std::isfinite(v)) return;
    const auto next = static_cast<std::uint32_t>(mesh_.texcoords.size() / 2);
    const auto [found, isNew] = numbers_.try_emplace({old, u, v}, isTaken_[old] ? next : old);
    mesh_.faceTexcoords[corner] = found->second;
    if (isNew) put(old, u, v);
  }

 private:
  void put(std::uint32_t old, double u, double v) {
    if (isTaken_[old]) {
      mesh_.texcoords.insert(mesh_.texcoords.end(), {u, v});
      return;
    }
    isTaken_[old] = true;
    mesh_.texcoords[2 * std::size_t{old}] = u;
    mesh_.texcoords[2 * std::size_t{old} + 1] = v;
  }

  PolygonMesh& mesh_;
  std::vector<std::uint32_t> before_;
  std::vector<bool> isTaken_;
  std::map<std::tuple<std::uint32_t, double, double>, std::uint32_t> numbers_;
};

}  // namespace

Status replaceTexcoords(PolygonMesh& mesh, const std::vector<double>& triangleUv) {
  const Triangulation all = triangulate(mesh);
  if (triangleUv.size() != 2 * all.corner.size())
    return {StatusCode::InvalidMesh, "there are " + std::to_string(triangleUv.size()) +
                                         " coordinates for " + std::to_string(all.corner.size()) +
                                         " corners of triangles, not 2 for each"};
  if (mesh.faceTexcoords.empty()) return {};
  Replacer replacer(mesh);
  std::size_t at = 0;
  for (const PolygonCorner corner : all.corner) {
    replacer.set(corner, triangleUv[at], triangleUv[at + 1]);
    at += 2;
  }
  return {};
}

}  // namespace abflat
