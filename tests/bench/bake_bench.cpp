// How fast textures are baked: CPU seconds for a map, and for a million of its pixels.
//
//   abflat_bake_bench [SIDE] [OLD_SIDE] [TRIANGLES] [--threads N]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "abflat/bake.h"
#include "abflat/corner_frames.h"

using namespace abflat;

namespace {

constexpr int kBlocks = 4;  ///< charts along u and v, each turned by a quarter

struct Grid {
  std::vector<std::uint32_t> corners;
  std::vector<double> positions, uv, oldUv;
  std::vector<float> normals, tangents;
};

/// A wavy square that fills its old layout and its new one.
Grid makeGrid(int cells) {
  Grid out;
  const auto addCorner = [&](int x, int y, int cellX, int cellY) {
    const int block = std::max(1, cells / kBlocks);
    const double u = double(x) / cells, v = double(y) / cells;
    const int left = cellX / block * block, top = cellY / block * block;
    const int right = std::min(left + block, cells), low = std::min(top + block, cells);
    const double a = double(x - left) / (right - left), b = double(y - top) / (low - top);
    out.corners.push_back(static_cast<std::uint32_t>(out.corners.size()));
    out.oldUv.insert(out.oldUv.end(), {u, v});
    out.uv.insert(out.uv.end(),
                  {(left + b * (right - left)) / cells, (top + (1 - a) * (low - top)) / cells});
    out.positions.insert(out.positions.end(), {u, 1 - v, 0.05 * std::sin(9 * u) * std::cos(7 * v)});
    out.normals.insert(out.normals.end(), {0, 0, 1});
  };
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x)
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {1, 1}})
        addCorner(x + dx, y + dy, x, y);
  return out;
}

std::vector<std::uint8_t> picture(int side) {
  std::vector<std::uint8_t> out;
  out.reserve(4 * std::size_t(side) * std::size_t(side));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const int value : {128 + x % 97, 128 + y % 89, 200, 255})
        out.push_back(static_cast<std::uint8_t>(value));
  return out;
}

BakeInput inputOf(const Grid& grid, MapKind kind) {
  BakeInput out;
  out.triangles.uv = grid.uv;
  out.triangles.oldUv = grid.oldUv;
  out.triangles.materials.assign(grid.corners.size() / 3, 0);
  if (kind == MapKind::Colour) return out;
  const std::vector<bool> isTurned(grid.corners.size() / 3);
  const FrameMesh mesh{grid.corners,   isTurned,
                       grid.positions, grid.normals,
                       grid.tangents,  {{0, static_cast<std::uint32_t>(isTurned.size())}}};
  out.triangles.normals = cornerNormals(mesh);
  out.triangles.oldTangents = oldTangents(mesh, grid.oldUv, out.triangles.normals);
  out.triangles.tangents = newTangents(mesh, grid.uv, out.triangles.normals);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> words;
  int threads = 1;
  for (int i = 1; i < argc; ++i)
    if (!std::strcmp(argv[i], "--threads") && i + 1 < argc)
      threads = std::atoi(argv[++i]);
    else
      words.push_back(std::atoi(argv[i]));
  const auto word = [&words](std::size_t i, int otherwise) {
    return words.size() > i ? words[i] : otherwise;
  };
  const int side = word(0, 2048), oldSide = word(1, 2048), triangles = word(2, 20000);
  if (side < 1 || oldSide < 1 || triangles < 2 || threads < 1) {
    std::fprintf(stderr, "sides and threads are at least 1, triangles at least 2\n");
    return 2;
  }
  const Grid grid = makeGrid(std::max(1, int(std::sqrt(triangles / 2))));
  const std::vector<std::uint8_t> pixels = picture(oldSide);
  for (const MapKind kind : {MapKind::Colour, MapKind::Normal}) {
    BakeInput input = inputOf(grid, kind);
    input.materials.emplace_back().texture = 0;
    BakeTexture& texture = input.textures.emplace_back();
    texture.image = {pixels.data(), static_cast<std::uint32_t>(oldSide),
                     static_cast<std::uint32_t>(oldSide)};
    BakeOptions options;
    options.kind = kind;
    options.width = options.height = static_cast<std::uint32_t>(side);
    options.threads = threads;
    if (kind == MapKind::Normal) texture.space = options.space = ColourSpace::Linear;
    const std::clock_t start = std::clock();
    std::size_t sum = 0;
    const Status status = bake(input, options, [&](auto, auto, const auto& rows) {
      sum += rows.back();
      return true;
    });
    if (!status.ok()) {
      std::fprintf(stderr, "%s\n", status.message.c_str());
      return 1;
    }
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("%-7s %5d from %5d, %7zu triangles: %7.3f CPU s, %6.4f a megapixel%s\n",
                kind == MapKind::Colour ? "colours" : "normals", side, oldSide,
                grid.corners.size() / 3, seconds, seconds / (1e-6 * side * side),
                sum == 0 ? ", empty" : "");
  }
  return 0;
}
