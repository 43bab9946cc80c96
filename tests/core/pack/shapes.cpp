#include "pack/shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace abflat::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  double uniform(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  unsigned index(unsigned count) { return static_cast<unsigned>(random_() % count); }

  /// A strip between two curves of n points: the general case of a disk.
  static PackShape strip(unsigned n, const std::function<void(double, double*, double*)>& curves) {
    PackShape s;
    for (unsigned i = 0; i < n; ++i) {
      double right[2], left[2];
      curves(i / (n - 1.0), right, left);
      s.uv.insert(s.uv.end(), {right[0], right[1], left[0], left[1]});
    }
    for (unsigned i = 0; i + 1 < n; ++i) {
      const unsigned a = 2 * i;
      s.triangles.insert(s.triangles.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
    }
    for (unsigned i = 0; i < n; ++i) s.outline.push_back(2 * i);
    for (unsigned i = n; i-- > 0;) s.outline.push_back(2 * i + 1);
    return s;
  }

  /// A fan around the origin.
  static PackShape fan(unsigned n, const std::function<double(double)>& radius) {
    PackShape s;
    s.uv = {0, 0};
    for (unsigned i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n, r = radius(angle);
      s.uv.insert(s.uv.end(), {r * std::cos(angle), r * std::sin(angle)});
      s.triangles.insert(s.triangles.end(), {0, i + 1, (i + 1) % n + 1});
      s.outline.push_back(i + 1);
    }
    return s;
  }

  PackShape disc() {
    const double squeeze = uniform(0.6, 1);
    PackShape s = fan(48, [](double) { return 1.0; });
    for (std::size_t i = 1; i < s.uv.size(); i += 2) s.uv[i] *= squeeze;
    return s;
  }

  PackShape blob() {
    double size[5], phase[5];
    for (int k = 0; k < 5; ++k) {
      size[k] = uniform(0, 0.35) / (1 + 0.5 * k);
      phase[k] = uniform(0, 2 * kPi);
    }
    return fan(64, [&](double angle) {
      double r = 1;
      for (int k = 0; k < 5; ++k) r += size[k] * std::cos((k + 1) * angle + phase[k]);
      return std::max(r, 0.15);
    });
  }

  PackShape star() {
    const unsigned tips = 4 + index(5);
    const double inner = uniform(0.25, 0.6);
    unsigned i = 0;
    return fan(2 * tips, [&](double) { return i++ % 2 ? inner : 1.0; });
  }

  PackShape spiral() {
    const double turns = uniform(0.6, 2.2), width = uniform(0.03, 0.07);
    return strip(80, [&](double t, double* right, double* left) {
      const double angle = 2 * kPi * turns * t, r = 0.15 + 0.3 * turns * t;
      const double c = std::cos(angle), s = std::sin(angle);
      right[0] = (r + width) * c, right[1] = (r + width) * s;
      left[0] = (r - width) * c, left[1] = (r - width) * s;
    });
  }

  /// A band along a part of a rectangle's sides.
  PackShape letter() {
    const unsigned sides = 2 + index(3);
    const double w = uniform(0.5, 1), h = uniform(0.5, 1), d = uniform(0.1, 0.2);
    const double gap = sides == 4 ? 2.5 * d : 0;
    const double outer[5][2] = {{gap, 0}, {w, 0}, {w, h}, {0, h}, {0, gap}};
    const double inner[5][2] = {{gap, d}, {w - d, d}, {w - d, h - d}, {d, h - d}, {d, gap}};
    return strip(sides + 1, [&](double t, double* right, double* left) {
      const auto i = static_cast<unsigned>(std::lround(t * sides));
      for (int k = 0; k < 2; ++k) right[k] = outer[i][k], left[k] = inner[i][k];
      if (sides == 2 && i == 2) left[1] = h;
      if (sides == 3 && i == 3) left[0] = 0;
    });
  }

  PackShape rectangle(double least) {
    const double h = uniform(least, 1);
    return strip(2, [&](double t, double* right, double* left) {
      right[0] = left[0] = t;
      right[1] = 0, left[1] = h;
    });
  }

  PackShape triangle() {
    PackShape s;
    s.uv = {0, 0, 1, 0, uniform(-0.3, 1.3), uniform(0.2, 1)};
    s.triangles = {0, 1, 2};
    s.outline = {0, 1, 2};
    return s;
  }

  PackShape make(const std::string& kind) {
    static const char* const kKinds[] = {"discs",   "blobs",     "stars",     "spirals",
                                         "letters", "triangles", "rectangles"};
    if (kind == "discs") return disc();
    if (kind == "blobs") return blob();
    if (kind == "stars") return star();
    if (kind == "spirals") return spiral();
    if (kind == "letters") return letter();
    if (kind == "triangles") return triangle();
    if (kind == "rectangles") return rectangle(0.2);
    if (kind == "needles") return rectangle(0.002);
    return make(kKinds[index(7)]);
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace

std::vector<PackShape> makePackShapes(const std::string& kind, std::size_t count, double spread,
                                      unsigned seed) {
  Maker maker(seed);
  std::vector<PackShape> out;
  for (std::size_t i = 0; i < count; ++i) {
    PackShape s = maker.make(kind);
    // Equally many charts in each range from a size to its double.
    const double size = std::pow(spread, -maker.uniform(0, 1)), angle = maker.uniform(0, 2 * kPi);
    const double c = size * std::cos(angle), d = size * std::sin(angle);
    for (std::size_t k = 0; k < s.uv.size(); k += 2) {
      const double x = s.uv[k], y = s.uv[k + 1];
      s.uv[k] = c * x - d * y;
      s.uv[k + 1] = d * x + c * y;
    }
    out.push_back(std::move(s));
  }
  return out;
}

}  // namespace abflat::test
