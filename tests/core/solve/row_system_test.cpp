#include "solve/row_system.h"

#include <algorithm>
#include <random>

#include "catch.h"
#include "support/meshes.h"
#include "support/problems.h"

using namespace abflat;
using namespace abflat::test;

namespace {

std::vector<TriangleRows> randomRows(std::size_t triangles) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<TriangleRows> out(triangles);
  for (TriangleRows& rows : out) {
    for (double& x : rows.matrix) x = normal(random);
    for (double& x : rows.rightHandSide) x = normal(random);
  }
  return out;
}

}  // namespace

TEST_CASE("rows: what triangles add, with one or two rows per vertex, without those that are off") {
  const DiskChart chart = chartOf(bumpyGrid(5, 4, 0.4, 2));
  const std::vector<TriangleRows> rows = randomRows(chart.triangleCount());
  std::vector<std::uint32_t> firstRow{0};
  IdVector<ChartVertex, std::uint8_t> isOff(chart.vertexCount());
  for (const ChartVertex v : chart.vertices()) {
    firstRow.push_back(firstRow.back() + 1 + v % 2);
    isOff[v] = v % 5 == 1;
  }
  const auto size = static_cast<Eigen::Index>(firstRow.back());
  for (const auto& off : {IdVector<ChartVertex, std::uint8_t>(), isOff}) {
    const auto isUsed = [&](ChartVertex v) { return off.empty() || !off[v]; };
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd wantedSide = Eigen::VectorXd::Constant(size, 2);
    for (const ChartTriangle f : chart.triangles())
      for (std::size_t i = 0; i < 6; ++i) {
        const ChartVertex a = chart.vertexOfCorner[cornerOf(f, i / 2)];
        const std::uint32_t row = firstRow[a] + static_cast<std::uint32_t>(i % 2);
        if (row == firstRow[a + 1] || !isUsed(a)) continue;
        wantedSide[row] += rows[f].rightHandSide[i];
        for (std::size_t j = 0; j < 6; ++j) {
          const ChartVertex b = chart.vertexOfCorner[cornerOf(f, j / 2)];
          const std::uint32_t column = firstRow[b] + static_cast<std::uint32_t>(j % 2);
          if (column == firstRow[b + 1] || !isUsed(b)) continue;
          const std::size_t r = std::max(i, j), c = std::min(i, j);
          wanted(row, column) += rows[f].matrix[r * (r + 1) / 2 + c];
        }
      }
    for (const ChartVertex v : chart.vertices())
      for (std::uint32_t row = firstRow[v]; !isUsed(v) && row < firstRow[v + 1]; ++row) {
        wanted(row, row) = 1;
        wantedSide[row] = 0;
      }
    RowSystem system(chart.vertexOfCorner, firstRow, nullptr);
    for (int time = 0; time < 2; ++time) {
      system.rightHandSide.setConstant(2);
      system.assemble(off, [&](ChartTriangle f) { return rows[f]; });
    }
    const Eigen::MatrixXd found = Eigen::MatrixXd(system.matrix()).selfadjointView<Eigen::Lower>();
    CHECK((found - wanted).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((system.rightHandSide - wantedSide).cwiseAbs().maxCoeff() < 1e-12);
  }
}
