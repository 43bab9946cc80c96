#include "support/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace abflat::test {
namespace {

using Index = std::uint64_t;

/// The grid points with their values, and the surface's vertices on the grid's edges.
class Marcher {
 public:
  Marcher(unsigned cells, const Field& field) : n_(cells + 1) {
    value_.resize(static_cast<std::size_t>(n_) * n_ * n_);
    for (Index i = 0; i < value_.size(); ++i) {
      const auto p = point(i);
      value_[i] = field(p[0], p[1], p[2]);
      if (value_[i] == 0) value_[i] = 1e-9;
    }
  }

  PolygonMesh run() {
    // Six tetrahedra around the diagonal of a cell, corners as bits x + 2y + 4z, all of the same
    // handedness.
    constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                       {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    for (Index z = 0; z + 1 < n_; ++z)
      for (Index y = 0; y + 1 < n_; ++y)
        for (Index x = 0; x + 1 < n_; ++x)
          for (const auto& t : kTetrahedra) {
            std::array<Index, 4> c;
            for (std::size_t k = 0; k < 4; ++k)
              c[k] = (x + (t[k] & 1)) + n_ * ((y + (t[k] >> 1 & 1)) + n_ * (z + (t[k] >> 2)));
            tetrahedron(c);
          }
    return makeTriangleMesh(std::move(positions_), std::move(triangles_));
  }

 private:
  std::array<double, 3> point(Index i) const {
    const double s = 2.0 / static_cast<double>(n_ - 1);
    return {s * static_cast<double>(i % n_) - 1, s * static_cast<double>(i / n_ % n_) - 1,
            s * static_cast<double>(i / n_ / n_) - 1};
  }

  std::uint32_t vertexOn(Index a, Index b) {
    const auto key = std::minmax(a, b);
    const auto found = vertices_.find(key);
    if (found != vertices_.end()) return found->second;
    const auto id = static_cast<std::uint32_t>(positions_.size() / 3);
    const auto p = point(key.first), q = point(key.second);
    const double s =
        std::clamp(value_[key.first] / (value_[key.first] - value_[key.second]), 0.02, 0.98);
    for (std::size_t d = 0; d < 3; ++d) positions_.push_back(p[d] + s * (q[d] - p[d]));
    vertices_.emplace(key, id);
    return id;
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles_.insert(triangles_.end(), {a, b, c});
  }

  /// Sorts inside corners first; an odd permutation flips the tetrahedron's orientation.
  void tetrahedron(std::array<Index, 4> c) {
    bool isTurned = false;
    for (std::size_t pass = 0; pass < 3; ++pass)
      for (std::size_t k = 0; k < 3; ++k)
        if (value_[c[k]] > 0 && value_[c[k + 1]] < 0) {
          std::swap(c[k], c[k + 1]);
          isTurned = !isTurned;
        }
    int inside = 0;
    for (const Index i : c) inside += value_[i] < 0;
    if (inside == 0 || inside == 4) return;
    if (isTurned) inside == 1 ? std::swap(c[2], c[3]) : std::swap(c[0], c[1]);
    if (inside == 1) {
      add(vertexOn(c[0], c[1]), vertexOn(c[0], c[2]), vertexOn(c[0], c[3]));
    } else if (inside == 3) {
      add(vertexOn(c[3], c[0]), vertexOn(c[3], c[1]), vertexOn(c[3], c[2]));
    } else {
      const std::uint32_t p = vertexOn(c[0], c[2]), q = vertexOn(c[0], c[3]),
                          r = vertexOn(c[1], c[3]), s = vertexOn(c[1], c[2]);
      add(p, q, r);
      add(p, r, s);
    }
  }

  Index n_;
  std::vector<double> value_, positions_;
  std::vector<std::uint32_t> triangles_;
  std::map<std::pair<Index, Index>, std::uint32_t> vertices_;
};

}  // namespace

PolygonMesh isosurface(unsigned cells, const Field& field) { return Marcher(cells, field).run(); }

Field rings(unsigned genus) {
  if (genus == 0) return [](double x, double y, double z) { return x * x + y * y + z * z - 0.8; };
  const double radius = 0.85 / (genus + 0.35), tube = 0.35 * radius;
  return [=](double x, double y, double z) {
    double least = 1e9;
    for (unsigned i = 0; i < genus; ++i) {
      const double centre = (2 * i + 1.0 - genus) * radius;
      const double ring = std::hypot(x - centre, y) - radius;
      least = std::min(least, std::hypot(ring, z) - tube);
    }
    return least;
  };
}

Field noise(double frequency, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::array<double, 5>> waves;
  for (int i = 0; i < 24; ++i) {
    std::array<double, 5> w;
    double length = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      w[d] = static_cast<double>(random() % 2001) / 1000 - 1;
      length += w[d] * w[d];
    }
    for (std::size_t d = 0; d < 3; ++d) w[d] *= 3.14159 * frequency / std::sqrt(length + 1e-6);
    w[3] = static_cast<double>(random() % 6283) / 1000;
    waves.push_back(w);
  }
  return [=](double x, double y, double z) {
    double sum = 0;
    for (const auto& w : waves) sum += std::sin(w[0] * x + w[1] * y + w[2] * z + w[3]);
    return std::max(sum / 4, 20 * (std::max({std::abs(x), std::abs(y), std::abs(z)}) - 0.93));
  };
}

}  // namespace abflat::test
