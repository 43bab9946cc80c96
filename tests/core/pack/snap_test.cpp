// Charts whose sides lie on borders of texels.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "catch.h"
#include "pack/packing.h"
#include "pack/shapes.h"

using namespace abflat;
using namespace abflat::test;

namespace {

/// Least and most of both coordinates, in texels.
std::array<double, 4> boxInTexels(const PackShape& shape, const Placement& p,
                                  const AtlasSize& size) {
  std::array<double, 4> out{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < shape.uv.size(); i += 2) {
    const double at[] = {p.u(&shape.uv[i]) * size.width, p.v(&shape.uv[i]) * size.height};
    for (std::size_t d = 0; d < 2; ++d) {
      out[d] = std::min(out[d], at[d]);
      out[2 + d] = std::max(out[2 + d], at[d]);
    }
  }
  return out;
}

double fromBorder(double x) { return std::abs(x - std::round(x)); }

}  // namespace

TEST_CASE("sides of level charts lie on borders of texels, and charts are as far apart", "[pack]") {
  const char* const kind = GENERATE("rectangles", "letters", "mixed", "needles");
  for (const std::size_t count : {1, 12, 60})
    for (const AtlasSize size : {AtlasSize(256), AtlasSize(256, 128), AtlasSize(100, 300)})
      for (const Rotate rotate : {Rotate::Auto, Rotate::Free, Rotate::Quarter, Rotate::None}) {
        CAPTURE(kind, count, size.width, size.height, rotate);
        const std::vector<PackShape> shapes = makePackShapes(kind, count, 10, 7);
        PackOptions options = at(size, 2);
        options.rotate = rotate;
        options.snapToTexels = true;
        checkPacked(shapes, options);
        const Packing packing = packed(shapes, options);
        std::size_t snapped = 0;
        for (std::size_t i = 0; i < shapes.size(); ++i) {
          const Placement& p = packing.placements[i];
          const std::array<double, 4> box = boxInTexels(shapes[i], p, size);
          for (std::size_t d = 0; d < 2; ++d) {
            const double stretch = d == 0 ? p.stretchU : p.stretchV;
            const double texels = box[2 + d] - box[d];
            CHECK(std::abs(texels - texels / stretch) < 0.51);
            if (stretch == 1) continue;
            ++snapped;
            CHECK(fromBorder(box[d]) < 0.01);
            CHECK(fromBorder(box[2 + d]) < 0.01);
            CHECK(texels > 1.9);
          }
        }
        if (std::string(kind) == "rectangles" && rotate == Rotate::Quarter)
          CHECK(snapped >= shapes.size());
      }
}

TEST_CASE("several tiles hold charts that snap at the density asked for", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("rectangles", 40, 4, 7);
  PackOptions options = at(128, 2);
  options.snapToTexels = options.udim = true;
  options.texelDensity = 2 * packed(shapes, at(128, 2)).texelDensity;
  CHECK(packed(shapes, options).tiles > 1);
  checkPacked(shapes, options);
}
