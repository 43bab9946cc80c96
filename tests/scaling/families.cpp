#include "families.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <random>

namespace abflat::scaling {
namespace {

constexpr double kTurn = 6.283185307179586;

/// A mesh in the making.
class Maker {
 public:
  std::uint32_t vertex(double x, double y, double z) {
    mesh_.positions.insert(mesh_.positions.end(), {x, y, z});
    return static_cast<std::uint32_t>(mesh_.vertexCount() - 1);
  }
  void face(std::initializer_list<std::uint32_t> corners) { face(std::vector(corners)); }
  void face(const std::vector<std::uint32_t>& corners) {
    mesh_.faceVertices.insert(mesh_.faceVertices.end(), corners.begin(), corners.end());
    mesh_.faceOffsets.push_back(static_cast<std::uint32_t>(mesh_.faceVertices.size()));
  }
  PolygonMesh done() { return std::move(mesh_); }

 private:
  PolygonMesh mesh_{{}, {0}, {}, {}, {}, {}, {}};
};

unsigned rootOf(double x) { return static_cast<unsigned>(std::lround(std::sqrt(x))); }

/// Vertices of a grid, (columns + 1) x (rows + 1).
template <class Place>
std::vector<std::uint32_t> gridVertices(Maker& out, unsigned columns, unsigned rows, Place place) {
  std::vector<std::uint32_t> v;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i) {
      const std::array<double, 3> p = place(i, j);
      v.push_back(out.vertex(p[0], p[1], p[2]));
    }
  return v;
}

/// As other programs make it: a doubled meridian, and a fan at each pole.
PolygonMesh sphere(unsigned faces) {
  const unsigned rows = std::max(4u, rootOf(faces / 4.0)), columns = 2 * rows;
  Maker out;
  const auto v = gridVertices(out, columns, rows, [&](unsigned i, unsigned j) {
    const double u = kTurn * i / columns, w = kTurn / 2 * j / rows;
    return std::array{-std::cos(u) * std::sin(w), std::cos(w), std::sin(u) * std::sin(w)};
  });
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const std::uint32_t a = v[j * (columns + 1) + i + 1], b = v[j * (columns + 1) + i];
      const std::uint32_t c = v[(j + 1) * (columns + 1) + i],
                          d = v[(j + 1) * (columns + 1) + i + 1];
      if (j > 0) out.face({a, b, d});
      if (j + 1 < rows) out.face({b, c, d});
    }
  return out.done();
}

/// Towers of three levels on a plane.
PolygonMesh city(unsigned faces) {
  const unsigned blocks = std::max(1u, rootOf(faces / 21.0)), n = 3 * blocks;
  Maker out;
  const auto v = gridVertices(out, n, n, [](unsigned i, unsigned j) {
    return std::array<double, 3>{1.0 * i, 1.0 * j, 0.0};
  });
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      std::array<std::uint32_t, 4> base = {v[j * (n + 1) + i], v[j * (n + 1) + i + 1],
                                           v[(j + 1) * (n + 1) + i + 1], v[(j + 1) * (n + 1) + i]};
      for (unsigned level = 1; i % 3 == 1 && j % 3 == 1 && level <= 3; ++level) {
        const std::array<std::uint32_t, 4> top = {
            out.vertex(i, j, level), out.vertex(i + 1.0, j, level),
            out.vertex(i + 1.0, j + 1.0, level), out.vertex(i, j + 1.0, level)};
        for (std::size_t k = 0; k < 4; ++k)
          out.face({base[k], base[(k + 1) % 4], top[(k + 1) % 4], top[k]});
        base = top;
      }
      out.face({base[0], base[1], base[2], base[3]});
    }
  return out.done();
}

/// A strip with long teeth.
PolygonMesh comb(unsigned faces) {
  const unsigned length = 16, teeth = std::max(1u, faces / (length + 2));
  Maker out;
  std::uint32_t low = out.vertex(0, 0, 0), high = out.vertex(0, 1, 0);
  for (unsigned k = 0; k < 2 * teeth; ++k) {
    const std::uint32_t nextLow = out.vertex(k + 1, 0, 0), nextHigh = out.vertex(k + 1, 1, 0);
    out.face({low, nextLow, nextHigh, high});
    std::uint32_t left = high, right = nextHigh;
    for (unsigned l = 1; k % 2 == 0 && l <= length; ++l) {
      const double bend = 0.1 * std::sin(0.7 * l + k);
      const std::uint32_t nextLeft = out.vertex(k, l + 1, bend),
                          nextRight = out.vertex(k + 1, l + 1, bend);
      out.face({left, right, nextRight, nextLeft});
      left = nextLeft;
      right = nextRight;
    }
    low = nextLow;
    high = nextHigh;
  }
  return out.done();
}

PolygonMesh soup(unsigned faces) {
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Maker out;
  for (unsigned f = 0; f < faces; ++f) {
    std::vector<std::uint32_t> face;
    for (int k = 0; k < 3; ++k) {
      const double x = unit(), y = unit();
      face.push_back(out.vertex(x, y, unit()));
    }
    out.face(face);
  }
  return out.done();
}

/// A cone: triangles round one vertex.
PolygonMesh fan(unsigned faces) {
  Maker out;
  const std::uint32_t apex = out.vertex(0, 0, 0.5);
  std::vector<std::uint32_t> rim;
  for (unsigned i = 0; i < faces; ++i)
    rim.push_back(out.vertex(std::cos(kTurn * i / faces), std::sin(kTurn * i / faces), 0));
  for (unsigned i = 0; i < faces; ++i) out.face({apex, rim[i], rim[(i + 1) % faces]});
  return out.done();
}

/// Triangles round one vertex whose angles add up to more than a full turn.
PolygonMesh ruffle(unsigned faces) {
  Maker out;
  const std::uint32_t hub = out.vertex(0, 0, 0);
  std::vector<std::uint32_t> rim;
  for (unsigned i = 0; i < faces; ++i) {
    const double a = kTurn * i / faces;
    rim.push_back(out.vertex(std::cos(a), std::sin(a), 0.8 * std::sin(8 * a)));
  }
  for (unsigned i = 0; i < faces; ++i) out.face({hub, rim[i], rim[(i + 1) % faces]});
  return out.done();
}

/// The same with a rim that goes up and down at random: cut into very many charts.
PolygonMesh tatters(unsigned faces) {
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Maker out;
  const std::uint32_t hub = out.vertex(0, 0, 0.3);
  std::vector<std::uint32_t> rim;
  for (unsigned i = 0; i < faces; ++i) {
    const double a = kTurn * i / faces, r = 0.5 + unit();
    rim.push_back(out.vertex(r * std::cos(a), r * std::sin(a), unit()));
  }
  for (unsigned i = 0; i < faces; ++i) out.face({hub, rim[i], rim[(i + 1) % faces]});
  return out.done();
}

/// One face, every second corner of it reflex.
PolygonMesh star(unsigned faces) {
  const unsigned corners = 2 * (faces / 2 + 1);
  Maker out;
  std::vector<std::uint32_t> rim;
  for (unsigned i = 0; i < corners; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.9, a = kTurn * i / corners;
    rim.push_back(out.vertex(r * std::cos(a), r * std::sin(a), 0));
  }
  out.face(rim);
  return out.done();
}

/// One face that goes back and forth between two places.
PolygonMesh shuttle(unsigned faces) {
  Maker out;
  const std::uint32_t a = out.vertex(0, 0, 0), b = out.vertex(1, 0, 0), c = out.vertex(0, 1, 0);
  out.face({a, b, c});
  std::vector<std::uint32_t> corners;
  for (unsigned i = 0; i < faces; ++i) corners.push_back(i % 2 == 0 ? a : b);
  out.face(corners);
  return out.done();
}

/// Boxes beside each other.
PolygonMesh parts(unsigned faces) {
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  Maker out;
  for (unsigned k = 0; k < faces / 12 + 1; ++k) {
    const std::uint32_t first = out.vertex(2.0 * k, 0, 0);
    for (unsigned i = 1; i < 8; ++i) out.vertex(2.0 * k + (i & 1), i >> 1 & 1, 1.0 * (i >> 2 & 1));
    for (const auto& s : kSides) out.face({first + s[0], first + s[1], first + s[2], first + s[3]});
  }
  return out.done();
}

/// A wavy plate with a hole in every third square of every third row.
PolygonMesh holes(unsigned faces) {
  const unsigned n = std::max(4u, rootOf(9 * faces / 16.0));
  Maker out;
  const auto v = gridVertices(out, n, n, [](unsigned i, unsigned j) {
    return std::array<double, 3>{1.0 * i, 1.0 * j, std::sin(0.3 * i) * std::cos(0.4 * j)};
  });
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i)
      if (i % 3 != 1 || j % 3 != 1)
        out.face({v[j * (n + 1) + i], v[j * (n + 1) + i + 1], v[(j + 1) * (n + 1) + i + 1],
                  v[(j + 1) * (n + 1) + i]});
  return out.done();
}

/// Two such plates, their holes and borders joined: a handle for each hole.
PolygonMesh handles(unsigned faces) {
  const unsigned n = 3 * std::max(1u, rootOf(faces / 44.0)) + 1;
  Maker out;
  std::array<std::vector<std::uint32_t>, 2> v;
  for (int side = 0; side < 2; ++side)
    v[side] = gridVertices(out, n, n, [&](unsigned i, unsigned j) {
      return std::array<double, 3>{1.0 * i, 1.0 * j, 1.0 * side};
    });
  const auto isSolid = [n](unsigned i, unsigned j) {
    return i < n && j < n && (i % 3 != 1 || j % 3 != 1);  // what is below 0 is above n
  };
  const auto wall = [&](unsigned a, unsigned b) { out.face({v[0][a], v[0][b], v[1][b], v[1][a]}); };
  const auto at = [n](unsigned i, unsigned j) { return j * (n + 1) + i; };
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      if (!isSolid(i, j)) continue;
      const std::array<unsigned, 4> c = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      out.face({v[1][c[0]], v[1][c[1]], v[1][c[2]], v[1][c[3]]});
      out.face({v[0][c[3]], v[0][c[2]], v[0][c[1]], v[0][c[0]]});
      if (!isSolid(i, j - 1)) wall(c[0], c[1]);
      if (!isSolid(i + 1, j)) wall(c[1], c[2]);
      if (!isSolid(i, j + 1)) wall(c[2], c[3]);
      if (!isSolid(i - 1, j)) wall(c[3], c[0]);
    }
  return out.done();
}

/// Squares that have one edge in common.
PolygonMesh pages(unsigned faces) {
  Maker out;
  const std::uint32_t a = out.vertex(0, 0, 0), b = out.vertex(0, 0, 1);
  for (unsigned i = 0; i < faces; ++i) {
    const double x = std::cos(kTurn * i / faces), y = std::sin(kTurn * i / faces);
    out.face({a, b, out.vertex(x, y, 1), out.vertex(x, y, 0)});
  }
  return out.done();
}

/// Triangles that have one vertex in common.
PolygonMesh bouquet(unsigned faces) {
  Maker out;
  const std::uint32_t a = out.vertex(0, 0, 0);
  for (unsigned i = 0; i < faces; ++i) {
    const double x = kTurn * i / faces, y = kTurn * (i + 0.5) / faces;
    out.face({a, out.vertex(std::cos(x), std::sin(x), 0), out.vertex(std::cos(y), std::sin(y), 0)});
  }
  return out.done();
}

/// A small hub with a long spike on each of its edges.
PolygonMesh urchin(unsigned faces) {
  const unsigned n = faces / 2;
  Maker out;
  const std::uint32_t hub = out.vertex(0, 0, 0);
  std::vector<std::uint32_t> near, far;
  for (unsigned i = 0; i < n; ++i) {
    const double a = kTurn * i / n, b = kTurn * (i + 0.5) / n;
    near.push_back(out.vertex(0.01 * std::cos(a), 0.01 * std::sin(a), 0));
    far.push_back(out.vertex(std::cos(b), std::sin(b), 0));
  }
  for (unsigned i = 0; i < n; ++i) {
    out.face({hub, near[i], near[(i + 1) % n]});
    out.face({near[i], far[i], near[(i + 1) % n]});
  }
  return out.done();
}

/// Loose triangles close together, and one far away.
PolygonMesh cluster(unsigned faces) {
  PolygonMesh out = soup(faces);
  for (std::size_t i = out.positions.size() - 9; i < out.positions.size(); ++i)
    out.positions[i] *= 1e6;
  return out;
}

/// A face again and again.
PolygonMesh copies(unsigned faces) {
  Maker out;
  out.vertex(0, 0, 0);
  out.vertex(1, 0, 0);
  out.vertex(0, 1, 0);
  for (unsigned i = 0; i < faces; ++i) out.face({0, 1, 2});
  return out.done();
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = {
      {"sphere", sphere},  {"city", city},       {"comb", comb},       {"soup", soup},
      {"fan", fan},        {"star", star},       {"shuttle", shuttle}, {"parts", parts},
      {"holes", holes},    {"handles", handles}, {"pages", pages},     {"bouquet", bouquet},
      {"urchin", urchin},  {"cluster", cluster}, {"copies", copies},   {"ruffle", ruffle},
      {"tatters", tatters}};
  return all;
}

}  // namespace abflat::scaling
