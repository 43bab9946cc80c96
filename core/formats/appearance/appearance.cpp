#include "abflat/appearance.h"

#include <cmath>

#include "appearance/readers.h"
#include "appearance/vertex_colors.h"
#include "base/guarded.h"
#include "io/text_lines.h"
#include "mesh/triangle_geometry.h"

namespace abflat {
namespace {

/// Scales normals to length 1; corners whose normal has no direction get kNoNormal.
void makeUnit(Appearance& out) {
  std::vector<std::uint8_t> isUsable(out.normals.size() / 3);
  for (std::size_t i = 0; i < isUsable.size(); ++i) {
    double* n = &out.normals[3 * i];
    const double length = norm(Vec3{n[0], n[1], n[2]});
    isUsable[i] = std::isfinite(length) && length > 0;
    for (std::size_t d = 0; d < 3 && isUsable[i]; ++d) n[d] /= length;
  }
  for (std::uint32_t& n : out.faceNormals)
    if (n >= isUsable.size() || !isUsable[n]) n = kNoNormal;
}

/// Unit normal; points up if the face has no area.
Vec3 normalOf(const PolygonMesh& mesh, std::size_t face) {
  std::vector<Vec3> points;
  for (std::uint32_t c = mesh.faceOffsets[face]; c < mesh.faceOffsets[face + 1]; ++c) {
    const double* p = &mesh.positions[3 * std::size_t{mesh.faceVertices[c]}];
    points.push_back({p[0], p[1], p[2]});
  }
  const Vec3 area = areaVector(points);
  const double length = norm(area);
  if (!std::isfinite(length) || !(length > 0)) return {0, 0, 1};
  return {area[0] / length, area[1] / length, area[2] / length};
}

/// Corners without a normal get that of their face, as for flat shading.
void completeNormals(const PolygonMesh& mesh, Appearance& out) {
  bool hasAny = false;
  for (const std::uint32_t n : out.faceNormals) hasAny = hasAny || n != kNoNormal;
  if (!hasAny) {
    out.normals = {};
    out.faceNormals = {};
    return;
  }
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::uint32_t own = kNoNormal;
    for (std::uint32_t c = mesh.faceOffsets[f]; c < mesh.faceOffsets[f + 1]; ++c) {
      if (out.faceNormals[c] != kNoNormal) continue;
      if (own == kNoNormal) {
        own = static_cast<std::uint32_t>(out.normals.size() / 3);
        const Vec3 normal = normalOf(mesh, f);
        out.normals.insert(out.normals.end(), normal.begin(), normal.end());
      }
      out.faceNormals[c] = own;
    }
  }
}

Appearance appearanceOf(std::string_view bytes, MeshFormat format, const PolygonMesh& mesh,
                        const ReadResource& readResource) {
  Appearance out;
  out.normals = mesh.normals;
  out.faceNormals = mesh.faceNormals;
  if (hasByteOrderMark(bytes)) bytes.remove_prefix(kByteOrderMark.size());
  if (format == MeshFormat::Obj) readObjAppearance(bytes, mesh, readResource, out);
  if (format == MeshFormat::Ply) readPlyAppearance(bytes, readResource, out);
  makeUnit(out);
  completeNormals(mesh, out);
  makeLinear(out.colors);
  return out;
}

}  // namespace

Result<Appearance> readAppearance(std::string_view bytes, MeshFormat format,
                                  const PolygonMesh& mesh, const ReadResource& readResource) {
  return guarded(
      [&]() -> Result<Appearance> { return appearanceOf(bytes, format, mesh, readResource); });
}

}  // namespace abflat
