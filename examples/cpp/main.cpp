// Unwraps a mesh made in memory and prints what came of it; with a file name, writes it as OBJ.

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <vector>

#include "abflat/io.h"
#include "abflat/unwrap.h"
#include "abflat/version.h"

namespace {

/// A closed tube of two discs and a side, 3 times as long as it is thick.
abflat::PolygonMesh tube(std::uint32_t sides) {
  constexpr double kPi = 3.141592653589793;
  std::vector<double> positions = {0, 0, 0, 0, 6, 0};
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    for (const double y : {0.0, 6.0})
      positions.insert(positions.end(), {std::cos(angle), y, -std::sin(angle)});
    const std::uint32_t low = 2 + 2 * i, high = low + 1;
    const std::uint32_t nextLow = 2 + 2 * ((i + 1) % sides), nextHigh = nextLow + 1;
    triangles.insert(triangles.end(), {low, nextLow, nextHigh, low, nextHigh, high});
    triangles.insert(triangles.end(), {0, nextLow, low, 1, high, nextHigh});
  }
  return abflat::makeTriangleMesh(std::move(positions), std::move(triangles));
}

}  // namespace

int main(int argc, char** argv) {
  const abflat::PolygonMesh mesh = tube(32);
  abflat::UnwrapOptions options;
  options.resolution = 2048;
  options.padding = 8;
  options.progress = [](const abflat::Progress&) { return true; };  // false would cancel
  const abflat::Result<abflat::UnwrapResult> result = abflat::unwrap(mesh, options);
  if (!result.ok()) {
    std::cerr << result.status().message << "\n";
    return 1;
  }
  const abflat::UnwrapReport& report = result.value().report;
  std::cout << "abflat " << ABFLAT_VERSION << ": " << report.charts.size() << " charts, "
            << (report.valid ? "valid" : "not valid") << "\n";
  if (argc > 1) {
    std::ofstream out(argv[1], std::ios::binary);
    out << abflat::writeObj(mesh, result.value().uv, result.value().cornerUv);
    if (!out.flush()) return 1;
  }
  return report.valid ? 0 : 1;
}
