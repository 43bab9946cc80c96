#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "abflat/draw.h"
#include "draw/panel.h"

namespace abflat {
namespace {

constexpr int kShades = 24;

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector scaled(const Vector& a, double s) { return {s * a[0], s * a[1], s * a[2]}; }
double lengthOf(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector unit(const Vector& a) { return scaled(a, 1 / lengthOf(a)); }

Vector positionOf(const PolygonMesh& mesh, std::uint32_t v) {
  const double* p = &mesh.positions[3 * std::size_t{v}];
  return {p[0], p[1], p[2]};
}

/// Twice the area vector of a polygon.
Vector areaOf(const PolygonMesh& mesh, std::size_t f) {
  Vector sum{};
  const std::uint32_t first = mesh.faceOffsets[f], last = mesh.faceOffsets[f + 1];
  const Vector origin = positionOf(mesh, mesh.faceVertices[first]);
  for (std::uint32_t c = first + 1; c + 1 < last; ++c) {
    const Vector n = cross(minus(positionOf(mesh, mesh.faceVertices[c]), origin),
                           minus(positionOf(mesh, mesh.faceVertices[c + 1]), origin));
    for (std::size_t d = 0; d < 3; ++d) sum[d] += n[d];
  }
  return sum;
}

/// Axes of the picture: right, up, and towards the eye.
struct View {
  Vector right, up, eye;

  Vector operator()(const Vector& p) const { return {dot(p, right), dot(p, up), dot(p, eye)}; }
};

/// A view from where most of the surface shows its outside, a little from the side; "up" is y, or z
/// if y is too close to the line of sight.
View viewOf(const PolygonMesh& mesh) {
  Vector sum{}, size{};
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const Vector n = areaOf(mesh, f);
    for (std::size_t d = 0; d < 3; ++d) {
      sum[d] += n[d];
      size[d] += std::abs(n[d]);
    }
  }
  // A nearly closed surface has no outward side, so it is viewed from where it is largest.
  if (lengthOf(sum) < 0.02 * lengthOf(size)) {
    const auto axis = std::max_element(size.begin(), size.end()) - size.begin();
    sum = {};
    sum[static_cast<std::size_t>(axis)] = 1;
  }
  Vector eye = lengthOf(sum) > 0 ? unit(sum) : Vector{0, 0, 1};
  const Vector up = std::abs(eye[1]) < 0.8 ? Vector{0, 1, 0} : Vector{0, 0, 1};
  const Vector side = unit(cross(up, eye));
  for (std::size_t d = 0; d < 3; ++d) eye[d] += 0.35 * side[d] + 0.25 * up[d];
  eye = unit(eye);
  const Vector right = unit(cross(up, eye));
  return {right, cross(eye, right), eye};
}

struct Face {
  std::size_t index;
  double depth;
};

/// Farthest first, so that nearer ones are painted over them.
std::vector<Face> byDepth(const PolygonMesh& mesh, const std::vector<Vector>& points) {
  std::vector<Face> out;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    double depth = 0;
    const std::uint32_t first = mesh.faceOffsets[f], last = mesh.faceOffsets[f + 1];
    for (std::uint32_t c = first; c < last; ++c) depth += points[mesh.faceVertices[c]][2];
    out.push_back({f, depth / (last - first)});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Face& a, const Face& b) { return a.depth < b.depth; });
  return out;
}

/// 0 dark to kShades bright, by a light from the upper left; the inside is darker.
int shadeOf(const Vector& area, const View& view) {
  if (!(lengthOf(area) > 0)) return 0;
  const Vector n = view(unit(area));
  const double light = (-0.35 * n[0] + 0.5 * n[1] + 0.8 * n[2]) / 1.01;
  const double value =
      n[2] >= 0 ? 0.35 + 0.65 * std::max(light, 0.0) : 0.25 + 0.2 * std::abs(light);
  return static_cast<int>(std::lround(kShades * std::min(value, 1.0)));
}

std::string shadeColour(int shade) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string out = "#";
  for (const auto& [dark, bright] :
       {std::array{52, 246}, std::array{70, 249}, std::array{96, 253}}) {
    const int value = dark + (bright - dark) * shade / kShades;
    out += kDigits[value / 16];
    out += kDigits[value % 16];
  }
  return out;
}

/// Faces from back to front; neighbours of the same shade share an element.
void paintFaces(SvgWriter& out, const PolygonMesh& mesh, const View& view,
                const std::vector<Vector>& points) {
  SvgPath path;
  int shade = -1;
  const auto flush = [&] {
    if (path.isEmpty()) return;
    const std::string colour = shadeColour(shade);
    out.add("path", {{"d", path.data()}, {"fill", colour}, {"stroke", kEdge}, {"stroke-width", 3}});
    path = {};
  };
  for (const Face& face : byDepth(mesh, points)) {
    const int next = shadeOf(areaOf(mesh, face.index), view);
    if (next != shade) flush();
    shade = next;
    for (std::uint32_t c = mesh.faceOffsets[face.index]; c < mesh.faceOffsets[face.index + 1]; ++c)
      path.add(c == mesh.faceOffsets[face.index], points[mesh.faceVertices[c]][0],
               points[mesh.faceVertices[c]][1]);
    path.close();
  }
  flush();
}

/// Points of the picture in path units, fitted into its square; the third is the depth.
std::vector<Vector> fitted(const PolygonMesh& mesh, const View& view, double size) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Vector> out(mesh.vertexCount());
  Vector low{kInfinity, kInfinity, kInfinity}, high = scaled(low, -1);
  for (std::uint32_t v = 0; v < out.size(); ++v) out[v] = view(positionOf(mesh, v));
  for (const std::uint32_t v : mesh.faceVertices)
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], out[v][d]);
      high[d] = std::max(high[d], out[v][d]);
    }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  const double scale = extent > 0 ? kUnitsPerPixel * (size - 2 * kPadding) / extent : 0;
  for (Vector& p : out) {
    p[0] = kUnitsPerPixel * size / 2 + scale * (p[0] - (low[0] + high[0]) / 2);
    p[1] = kUnitsPerPixel * size / 2 - scale * (p[1] - (low[1] + high[1]) / 2);
  }
  return out;
}

}  // namespace

Drawing drawSurface(const PolygonMesh& mesh, const LayoutDrawingOptions& options) {
  SvgWriter out;
  paintTitle(out, options.title);
  openSquare(out);
  if (mesh.faceCount() > 0) {
    const View view = viewOf(mesh);
    paintFaces(out, mesh, view, fitted(mesh, view, options.size));
  }
  out.close("g");
  const std::string faces = std::to_string(mesh.faceCount()) + " faces";
  out.text(kPadding, kTitleHeight + options.size + 16, faces,
           {{"font-size", 13}, {"fill", kMuted}});
  return {options.size, kTitleHeight + options.size, out.take()};
}

}  // namespace abflat
