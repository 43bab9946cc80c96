#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace abflat::fuzz {
namespace {

constexpr double kTurn = 6.283185307179586;

Point randomPoint(RandomSource& random) {
  return {random.signedUnit(), random.signedUnit(), random.signedUnit()};
}

double share(std::uint32_t i, std::uint32_t n) { return static_cast<double>(i) / n; }

void bend(Shape& shape, RandomSource& random) {
  const double height = random.pick({0.0, 0.1, 1.0, 10.0});
  for (Point& p : shape.points) p[2] += height * random.signedUnit();
}

}  // namespace

PolygonMesh Shape::mesh() const {
  PolygonMesh out;
  for (const Point& p : points) out.positions.insert(out.positions.end(), p.begin(), p.end());
  out.faceOffsets.push_back(0);
  for (const std::vector<std::uint32_t>& face : faces) {
    out.faceVertices.insert(out.faceVertices.end(), face.begin(), face.end());
    out.faceOffsets.push_back(static_cast<std::uint32_t>(out.faceVertices.size()));
  }
  return out;
}

Shape net(const Net& net) {
  Shape out;
  const std::uint32_t across = net.columns + (net.wrapsColumns ? 0 : 1);
  const std::uint32_t down = net.rows + (net.wrapsRows ? 0 : 1);
  for (std::uint32_t j = 0; j < down; ++j)
    for (std::uint32_t i = 0; i < across; ++i)
      out.add({static_cast<double>(i), static_cast<double>(j), 0});
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    if (net.isTwisted && i == across) j = net.rows - j;
    return (j % down) * across + i % across;
  };
  for (std::uint32_t j = 0; j < net.rows; ++j)
    for (std::uint32_t i = 0; i < net.columns; ++i) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (net.isCut) {
        out.faces.push_back({a, b, c});
        out.faces.push_back({a, c, d});
      } else {
        out.faces.push_back({a, b, c, d});
      }
    }
  return out;
}

Shape bumpyNet(RandomSource& random) {
  Net size;
  size.columns = random.between(1, 12);
  size.rows = random.between(1, 12);
  size.isCut = random.flag();
  Shape out = net(size);
  bend(out, random);
  return out;
}

Shape sphere(RandomSource& random) {
  Net size;
  size.columns = random.between(3, 16);
  size.rows = random.between(2, 10);
  size.isCut = true;
  Shape out = net(size);
  const double squash = random.pick({1.0, 0.1, 5.0});
  for (Point& p : out.points) {
    const double u = kTurn * p[0] / size.columns, v = kTurn / 2 * p[1] / size.rows;
    p = {std::cos(u) * std::sin(v), squash * std::cos(v), std::sin(u) * std::sin(v)};
  }
  // Its ends are fans: the triangles that would have no area are left out.
  const std::uint32_t across = size.columns + 1;
  std::vector<std::vector<std::uint32_t>> kept;
  for (const auto& face : out.faces) {
    const auto inRow = [&](std::uint32_t row) {
      return std::count_if(face.begin(), face.end(),
                           [&](std::uint32_t v) { return v / across == row; });
    };
    if (inRow(0) < 2 && inRow(size.rows) < 2) kept.push_back(face);
  }
  out.faces = std::move(kept);
  return out;
}

Shape ring(RandomSource& random) {
  Net size;
  size.columns = random.between(3, 14);
  size.rows = random.between(1, 8);
  size.isCut = random.flag();
  size.wrapsColumns = !random.isOneOf(4);
  size.wrapsRows = size.rows > 2 && random.flag();
  size.isTwisted = !size.wrapsRows && random.isOneOf(4);
  Shape out = net(size);
  const double radius = random.pick({2.0, 1.0, 20.0}), taper = random.pick({0.0, 0.5, 1.0});
  for (Point& p : out.points) {
    const double u = kTurn * share(static_cast<std::uint32_t>(p[0]), size.columns);
    const double h = share(static_cast<std::uint32_t>(p[1]), size.rows);
    if (size.wrapsRows) {
      const double r = radius + std::cos(kTurn * h);
      p = {r * std::cos(u), r * std::sin(u), std::sin(kTurn * h)};
    } else if (size.isTwisted) {
      const double r = radius + (h - 0.5) * std::cos(u / 2);
      p = {r * std::cos(u), r * std::sin(u), (h - 0.5) * std::sin(u / 2)};
    } else {
      const double r = 1 - taper * h;
      p = {r * std::cos(u), r * std::sin(u), radius * h};
    }
  }
  return out;
}

Shape box(RandomSource& random) {
  const bool isJoined = random.flag();
  const double size[] = {1, random.pick({1.0, 0.01, 30.0}), random.pick({1.0, 3.0, 0.0})};
  constexpr std::array<std::array<int, 4>, 6> kSides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  Shape out;
  const auto corner = [&](int i) {
    return Point{size[0] * (i & 1), size[1] * (i >> 1 & 1), size[2] * (i >> 2 & 1)};
  };
  if (isJoined)
    for (int i = 0; i < 8; ++i) out.add(corner(i));
  for (const auto& side : kSides) {
    std::vector<std::uint32_t> face;
    for (const int i : side)
      face.push_back(isJoined ? static_cast<std::uint32_t>(i) : out.add(corner(i)));
    out.faces.push_back(face);
  }
  return out;
}

Shape city(RandomSource& random) {
  const std::uint32_t blocks = random.between(1, 4), levels = random.between(1, 3), n = 3 * blocks;
  Net size;
  size.columns = size.rows = n;
  size.isCut = false;
  Shape out = net(size);
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t f = 0; f < out.faces.size(); ++f) {
    std::vector<std::uint32_t> base = out.faces[f];
    if ((f % n) % 3 != 1 || (f / n) % 3 != 1) {
      faces.push_back(base);
      continue;
    }
    for (std::uint32_t level = 1; level <= levels; ++level) {
      std::vector<std::uint32_t> top;
      for (const std::uint32_t v : base) {
        Point p = out.points[v];
        p[2] = level;
        top.push_back(out.add(p));
      }
      for (std::size_t k = 0; k < 4; ++k)
        faces.push_back({base[k], base[(k + 1) % 4], top[(k + 1) % 4], top[k]});
      base = top;
    }
    faces.push_back(base);
  }
  out.faces = std::move(faces);
  return out;
}

Shape checkerboard(RandomSource& random) {
  Shape out = bumpyNet(random);
  std::vector<std::vector<std::uint32_t>> kept;
  for (const auto& face : out.faces)
    if (random.flag()) kept.push_back(face);
  out.faces = std::move(kept);
  return out;
}

Shape fan(RandomSource& random) {
  const std::uint32_t n = random.between(3, 60);
  const bool isPolygon = random.flag();
  const double reflex = random.pick({1.0, 0.9, 0.3}), height = random.pick({0.0, 1.0, 5.0});
  Shape out;
  std::vector<std::uint32_t> rim;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = kTurn * share(i, n), r = i % 2 == 0 ? 1 : reflex;
    rim.push_back(out.add({r * std::cos(a), r * std::sin(a), 0}));
  }
  if (isPolygon) {
    out.faces.push_back(rim);
    return out;
  }
  const std::uint32_t apex = out.add({0, 0, height});
  for (std::uint32_t i = 0; i < n; ++i) out.faces.push_back({apex, rim[i], rim[(i + 1) % n]});
  return out;
}

Shape soup(RandomSource& random) {
  Shape out;
  for (std::uint32_t n = random.between(1, 60); n > 0; --n) {
    std::vector<std::uint32_t> face;
    for (int k = 0; k < 3; ++k) face.push_back(out.add(randomPoint(random)));
    out.faces.push_back(face);
  }
  return out;
}

Shape tangle(RandomSource& random) {
  Shape out;
  const std::uint32_t vertices = random.between(3, 20);
  for (std::uint32_t i = 0; i < vertices; ++i) out.add(randomPoint(random));
  for (std::uint32_t n = random.between(1, 40); n > 0; --n) {
    std::vector<std::uint32_t> face;
    for (std::uint32_t k = random.between(3, 5); k > 0; --k) face.push_back(random.below(vertices));
    out.faces.push_back(face);
  }
  return out;
}

Shape polygon(RandomSource& random) {
  Shape out;
  const bool isFlat = random.flag();
  const std::uint32_t vertices = random.between(3, 24);
  for (std::uint32_t i = 0; i < vertices; ++i) {
    Point p = randomPoint(random);
    if (isFlat) p = {std::round(4 * p[0]), std::round(4 * p[1]), 0};
    out.add(p);
  }
  for (std::uint32_t n = random.between(1, 5); n > 0; --n) {
    std::vector<std::uint32_t> face;
    for (std::uint32_t k = random.between(3, 30); k > 0; --k)
      face.push_back(random.below(vertices));
    out.faces.push_back(face);
  }
  return out;
}

}  // namespace abflat::fuzz
