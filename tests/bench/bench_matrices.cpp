#include "bench_matrices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "abflat/io.h"
#include "abflat/samples.h"
#include "angle/angle_problem.h"
#include "chart/disk_chart.h"
#include "mesh/surface.h"
#include "solve/schur_system.h"

namespace abflat::bench {
namespace {

/// Largest shift of a coordinate, in mean edges.
constexpr double kNoise = 0.15;

}  // namespace

PolygonMesh noisyCap(unsigned faces) {
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(faces / 2.0)));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<double> positions;
  for (std::uint32_t j = 0; j <= side; ++j)
    for (std::uint32_t i = 0; i <= side; ++i) {
      const double x = (i + jitter(random)) / side - 0.5, y = (j + jitter(random)) / side - 0.5;
      const double bumps = 0.02 * std::sin(40 * x) * std::cos(33 * y);
      const double z = std::sqrt(1 - x * x - y * y) + bumps + 0.2 * jitter(random) / side;
      positions.insert(positions.end(), {x, y, z});
    }
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const std::uint32_t a = j * (side + 1) + i, b = a + 1, d = a + side + 1, c = d + 1;
      if (random() & 1)
        triangles.insert(triangles.end(), {a, b, c, a, c, d});
      else
        triangles.insert(triangles.end(), {a, b, d, b, c, d});
    }
  return makeTriangleMesh(positions, triangles);
}

PolygonMesh noisyHead(unsigned faces) {
  PolygonMesh (*make)(double) = nullptr;
  for (const Sample& sample : samples())
    if (sample.name == "head") make = sample.make;
  const auto coarse = static_cast<double>(make(1).faceCount());
  const double detail = std::max(kMinSampleDetail, faces / coarse);
  PolygonMesh mesh = make(detail);
  double edges = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t* v = &mesh.faceVertices[mesh.faceOffsets[f]];
    const Eigen::Vector3d a(&mesh.positions[3 * v[0]]), b(&mesh.positions[3 * v[1]]);
    edges += (b - a).norm();
  }
  const double amplitude = kNoise * edges / static_cast<double>(mesh.faceCount());
  // The raw bits, because distributions differ between standard libraries.
  std::mt19937 random(11);
  for (double& x : mesh.positions)
    x += amplitude * (static_cast<double>(random()) / 2147483648.0 - 1);
  return mesh;
}

PolygonMesh subdivided(const PolygonMesh& mesh) {
  std::vector<double> positions = mesh.positions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    const auto [it, isNew] =
        middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions.size() / 3));
    if (isNew)
      for (std::size_t d = 0; d < 3; ++d)
        positions.push_back((mesh.positions[3 * a + d] + mesh.positions[3 * b + d]) / 2);
    return it->second;
  };
  std::vector<std::uint32_t> triangles;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t* v = &mesh.faceVertices[mesh.faceOffsets[f]];
    const std::uint32_t a = between(v[0], v[1]), b = between(v[1], v[2]), c = between(v[2], v[0]);
    triangles.insert(triangles.end(), {v[0], a, c, a, v[1], b, c, b, v[2], a, b, c});
  }
  return makeTriangleMesh(positions, triangles);
}

bool makeMesh(const std::string& what, PolygonMesh& mesh) {
  const std::string head = "head-";
  const bool isHead = what.compare(0, head.size(), head) == 0;
  const std::string number = isHead ? what.substr(head.size()) : what;
  if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos) {
    const auto faces = static_cast<unsigned>(std::stoul(number));
    mesh = isHead ? noisyHead(faces) : noisyCap(faces);
    return true;
  }
  const std::size_t plus = what.find('+');
  const std::string path = what.substr(0, plus);
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const Result<MeshFormat> format = detectFormat(path, bytes);
  Result<PolygonMesh> read = format.ok() ? readMesh(bytes, format.value(), path) : format.status();
  if (!in || !read.ok()) {
    std::fprintf(stderr, "%s cannot be read\n", path.c_str());
    return false;
  }
  mesh = std::move(read.value());
  for (int i = plus == std::string::npos ? 0 : std::atoi(what.c_str() + plus + 1); i > 0; --i)
    mesh = subdivided(mesh);
  return true;
}

Eigen::SparseMatrix<double> cotangentLaplacian(const PolygonMesh& mesh) {
  const auto n = static_cast<int>(mesh.vertexCount());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1e-3);
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const std::uint32_t* v = &mesh.faceVertices[mesh.faceOffsets[f]];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<int>(v[k]), b = static_cast<int>(v[(k + 1) % 3]);
      const Eigen::Vector3d apex(&mesh.positions[3 * v[(k + 2) % 3]]);
      const Eigen::Vector3d p = Eigen::Vector3d(&mesh.positions[3 * v[k]]) - apex;
      const Eigen::Vector3d q = Eigen::Vector3d(&mesh.positions[3 * v[(k + 1) % 3]]) - apex;
      const double cotangent = std::max(1e-3, p.dot(q) / p.cross(q).norm());
      entries.emplace_back(a, a, cotangent);
      entries.emplace_back(b, b, cotangent);
      entries.emplace_back(std::max(a, b), std::min(a, b), -cotangent);
    }
  }
  Eigen::SparseMatrix<double> m(n, n);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

Eigen::SparseMatrix<double> schurMatrix(const PolygonMesh& mesh, std::string& message) {
  const Surface surface = buildSurface(mesh);
  message = surface.summary.disk.message;
  if (!surface.summary.disk.ok()) return {};
  const DiskChart chart = makeDiskChart(mesh, surface);
  AngleProblem problem = buildAngleProblem(chart);
  setBounds(problem, chart, BoundaryBounds(chart.boundary.size(), 1.0));
  const ConstraintRows rows = numberRows(problem);
  SchurSystem schur(problem, rows);
  Linearization lin;
  const std::vector<double> none(rows.count(), 0.0);
  linearize(problem, rows, {problem.target.raw(), none, Curvature::Clamped}, lin);
  // With all bounds active at t = 1 the constraints would depend on each other.
  std::vector<std::uint8_t> active = problem.isBoundary.raw();
  for (std::size_t v = 0; v < active.size(); v += 2) active[v] = 0;
  schur.assemble(lin, active);
  return schur.matrix();
}

}  // namespace abflat::bench
