#include "support/closed_meshes.h"

#include <cmath>
#include <random>

#include "base/constants.h"
#include "support/isosurface.h"
#include "support/meshes.h"

namespace abflat::test {
namespace {

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

unsigned between(std::mt19937& random, unsigned low, unsigned high) {
  return std::uniform_int_distribution<unsigned>(low, high)(random);
}

/// Spheres that merge into each other.
ClosedMesh blob(std::mt19937& random) {
  std::vector<std::array<double, 4>> balls;
  for (unsigned i = between(random, 1, 5); i > 0; --i)
    balls.push_back({uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4),
                     uniform(random, -0.4, 0.4), uniform(random, 0.25, 0.5)});
  const Field field = [&](double x, double y, double z) {
    double inside = 0;
    for (const auto& [a, b, c, r] : balls)
      inside +=
          std::exp(4 - 4 * ((x - a) * (x - a) + (y - b) * (y - b) + (z - c) * (z - c)) / r / r);
    return 1 - inside;
  };
  return {"blob", -1, isosurface(between(random, 8, 11), field)};
}

/// A torus that is roughened by noise.
ClosedMesh roughTorus(std::mt19937& random) {
  const unsigned columns = between(random, 8, 24), rows = between(random, 6, 14);
  PolygonMesh mesh = torus(columns, rows);
  const double most = uniform(random, 0, 0.12);
  for (double& x : mesh.positions) x += uniform(random, -most, most);
  return {"torus", 1, std::move(mesh)};
}

ClosedMesh chain(std::mt19937& random) {
  const unsigned genus = between(random, 2, 3);
  return {"rings", static_cast<int>(genus),
          isosurface(between(random, 7 * genus, 7 * genus + 2), rings(genus))};
}

ClosedMesh sponge(std::mt19937& random) {
  const double frequency = uniform(random, 1, 2);
  const unsigned seed = between(random, 0, 99), cells = between(random, 7, 9);
  return {"sponge", -1, isosurface(cells, noise(frequency, seed))};
}

/// Squares on the six sides of a box, `squares` along each axis.
PolygonMesh box(const std::array<unsigned, 3>& squares, const std::array<double, 3>& size) {
  std::vector<double> positions;
  std::vector<std::uint32_t> place((squares[0] + 1) * (squares[1] + 1) * (squares[2] + 1),
                                   kNoTexcoord);
  const auto vertexAt = [&](const std::array<unsigned, 3>& at) {
    std::uint32_t& v = place[at[0] + (squares[0] + 1) * (at[1] + (squares[1] + 1) * at[2])];
    if (v == kNoTexcoord) {
      v = static_cast<std::uint32_t>(positions.size() / 3);
      for (std::size_t d = 0; d < 3; ++d) positions.push_back(size[d] * at[d] / squares[d]);
    }
    return v;
  };
  PolygonMesh out;
  out.faceOffsets = {0};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const unsigned side : {0u, squares[axis]}) {
      const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
      const auto corner = [&](unsigned i, unsigned j) {
        std::array<unsigned, 3> at{};
        at[axis] = side;
        at[a] = i;
        at[b] = j;
        return vertexAt(at);
      };
      for (unsigned i = 0; i < squares[a]; ++i)
        for (unsigned j = 0; j < squares[b]; ++j) {
          const std::uint32_t p = corner(i, j), q = corner(i + 1, j), r = corner(i + 1, j + 1),
                              s = corner(i, j + 1);
          if (side == 0)
            out.faceVertices.insert(out.faceVertices.end(), {p, s, r, q});
          else
            out.faceVertices.insert(out.faceVertices.end(), {p, q, r, s});
          out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
        }
    }
  out.positions = std::move(positions);
  return out;
}

ClosedMesh someBox(std::mt19937& random) {
  std::array<unsigned, 3> squares;
  std::array<double, 3> size;
  for (std::size_t d = 0; d < 3; ++d) {
    squares[d] = between(random, 1, 6);
    size[d] = uniform(random, 0.2, 3);
  }
  return {"box", 0, box(squares, size)};
}

/// A bent box that is nearly a sheet.
ClosedMesh plate(std::mt19937& random) {
  const double thickness = std::pow(10, uniform(random, -4, -1)), bend = uniform(random, 0, 1.5);
  PolygonMesh mesh = box({between(random, 3, 12), between(random, 3, 12), 1}, {2, 2, thickness});
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    double* p = &mesh.positions[3 * v];
    p[2] += bend * p[0] * p[1] / 2 + bend * std::sin(2 * p[0]) / 3;
  }
  return {"plate", 0, std::move(mesh)};
}

/// Prisms, antiprisms and bipyramids with polygonal faces.
ClosedMesh polyhedron(std::mt19937& random) {
  const unsigned n = between(random, 3, 12), kind = between(random, 0, 2);
  const double height = uniform(random, 0.1, 4);
  PolygonMesh out;
  out.faceOffsets = {0};
  const auto add = [&](const std::vector<std::uint32_t>& face) {
    out.faceVertices.insert(out.faceVertices.end(), face.begin(), face.end());
    out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
  };
  const auto ring = [&](double z, double turn) {
    for (unsigned i = 0; i < n; ++i) {
      const double angle = 2 * kPi * (i + turn) / n;
      out.positions.insert(out.positions.end(), {std::cos(angle), std::sin(angle), z});
    }
  };
  ring(0, 0);
  if (kind == 2) {
    out.positions.insert(out.positions.end(), {0.1, 0, height, 0, 0.1, -height});
    for (std::uint32_t i = 0; i < n; ++i) {
      add({i, (i + 1) % n, n});
      add({(i + 1) % n, i, n + 1});
    }
    return {"bipyramid", 0, std::move(out)};
  }
  ring(height, kind == 1 ? 0.5 : 0);
  std::vector<std::uint32_t> low, high;
  for (std::uint32_t i = 0; i < n; ++i) {
    low.push_back(n - 1 - i);
    high.push_back(n + i);
    const std::uint32_t j = (i + 1) % n;
    if (kind == 0) {
      add({i, j, n + j, n + i});
    } else {
      add({i, j, n + i});
      add({j, n + j, n + i});
    }
  }
  add(low);
  add(high);
  return {kind == 0 ? "prism" : "antiprism", 0, std::move(out)};
}

/// Columns and rows of squares between two poles; radius(u, v) for u in [0, 2 pi] and v in [0, pi].
template <class Radius>
PolygonMesh poled(unsigned columns, unsigned rows, const Radius& radius) {
  std::vector<double> p;
  std::vector<std::uint32_t> t;
  const auto add = [&](double u, double v) {
    const double r = radius(u, v);
    p.insert(p.end(),
             {r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u), r * std::cos(v)});
  };
  for (unsigned j = 1; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) add(2 * kPi * i / columns, kPi * j / rows);
  add(0, 0);
  add(0, kPi);
  const std::uint32_t top = columns * (rows - 1), bottom = top + 1;
  for (std::uint32_t i = 0; i < columns; ++i) {
    const std::uint32_t k = (i + 1) % columns, last = columns * (rows - 2);
    t.insert(t.end(), {top, i, k, bottom, last + k, last + i});
    for (std::uint32_t j = 0; j + 2 < rows; ++j) {
      const std::uint32_t a = columns * j, b = a + columns;
      t.insert(t.end(), {a + i, b + i, b + k, a + i, b + k, a + k});
    }
  }
  return makeTriangleMesh(std::move(p), std::move(t));
}

ClosedMesh ellipsoid(std::mt19937& random) {
  const unsigned columns = between(random, 3, 24), rows = between(random, 3, 14);
  PolygonMesh mesh = poled(columns, rows, [](double, double) { return 1; });
  const double size[3] = {1, uniform(random, 0.2, 1), uniform(random, 0.1, 4)};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] *= size[i % 3];
  return {"ellipsoid", 0, std::move(mesh)};
}

/// A surface with arms in all directions.
ClosedMesh spiky(std::mt19937& random) {
  const unsigned arms = between(random, 2, 5);
  const double length = uniform(random, 0.3, 2);
  return {"star", 0, poled(6 * arms, 12, [=](double u, double v) {
            return 1 + length * std::pow(std::sin(arms * u / 2) * std::sin(2 * v), 4);
          })};
}

ClosedMesh several(std::mt19937& random) {
  ClosedMesh out{"parts", 0, {}};
  out.mesh.faceOffsets = {0};
  for (unsigned i = between(random, 2, 5); i > 0; --i) {
    const ClosedMesh part = i % 3 == 0   ? roughTorus(random)
                            : i % 3 == 1 ? polyhedron(random)
                                         : someBox(random);
    out.genus += part.genus;
    const PolygonMesh moved = transformed(part.mesh, uniform(random, 0.05, 1), {3.0 * i, 0, 0});
    const auto first = static_cast<std::uint32_t>(out.mesh.vertexCount());
    out.mesh.positions.insert(out.mesh.positions.end(), moved.positions.begin(),
                              moved.positions.end());
    const auto corners = static_cast<std::uint32_t>(out.mesh.faceVertices.size());
    for (const std::uint32_t v : moved.faceVertices) out.mesh.faceVertices.push_back(first + v);
    for (std::size_t f = 1; f < moved.faceOffsets.size(); ++f)
      out.mesh.faceOffsets.push_back(corners + moved.faceOffsets[f]);
  }
  return out;
}

}  // namespace

ClosedMesh closedMesh(unsigned number) {
  constexpr ClosedMesh (*kFamilies[kClosedFamilies])(std::mt19937&) = {
      blob, roughTorus, chain, sponge, someBox, plate, polyhedron, ellipsoid, spiky, several};
  std::mt19937 random(number);
  return kFamilies[number % kClosedFamilies](random);
}

PolygonMesh grille(unsigned n, double thickness) {
  const unsigned m = 2 * n + 1, row = m + 1, layer = row * row;
  PolygonMesh mesh;
  for (unsigned z = 0; z < 2; ++z)
    for (unsigned x = 0; x < row; ++x)
      for (unsigned y = 0; y < row; ++y)
        mesh.positions.insert(mesh.positions.end(), {1.0 * x, 1.0 * y, z * thickness});
  mesh.faceOffsets = {0};
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.faceVertices.insert(mesh.faceVertices.end(), {a, b, c, d});
    mesh.faceOffsets.push_back(static_cast<std::uint32_t>(mesh.faceVertices.size()));
  };
  const auto isThere = [&](unsigned x, unsigned y) {
    return x < m && y < m && (x % 2 == 0 || y % 2 == 0);
  };
  for (unsigned x = 0; x < m; ++x)
    for (unsigned y = 0; y < m; ++y) {
      if (!isThere(x, y)) continue;
      const std::uint32_t corner[] = {x * row + y, (x + 1) * row + y, (x + 1) * row + y + 1,
                                      x * row + y + 1};
      const auto [a, b, c, d] = corner;
      face(a, d, c, b);
      face(layer + a, layer + b, layer + c, layer + d);
      const bool isWall[] = {!isThere(x, y - 1), !isThere(x + 1, y), !isThere(x, y + 1),
                             !isThere(x - 1, y)};
      for (unsigned k = 0; k < 4; ++k)
        if (isWall[k])
          face(corner[k], corner[(k + 1) % 4], layer + corner[(k + 1) % 4], layer + corner[k]);
    }
  return mesh;
}

}  // namespace abflat::test
