// Tiles that are not square.

#include <string>

#include "catch.h"
#include "pack/packing.h"
#include "pack/shapes.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("a tile may be wide or high: texels are square, and padding lies between charts",
          "[pack]") {
  const char* const kind = GENERATE("mixed", "stars", "letters", "needles");
  for (const std::size_t count : {1, 3, 30})
    for (const AtlasSize size : {AtlasSize(200, 100), AtlasSize(100, 200), AtlasSize(257, 101),
                                 AtlasSize(1024, 32), AtlasSize(32, 1024)})
      for (const int padding : {0, 2, 5}) {
        CAPTURE(kind, count, size.width, size.height, padding);
        checkPacked(makePackShapes(kind, count, 10, static_cast<unsigned>(count)),
                    at(size, padding));
      }
}

TEST_CASE("a wide tile and a high one are filled alike, and about as well as a square", "[pack]") {
  for (const char* const kind : {"mixed", "letters"})
    for (const std::size_t count : {12, 60}) {
      CAPTURE(kind, count);
      const std::vector<PackShape> shapes = makePackShapes(kind, count, 10, 4);
      const double wide = packed(shapes, at({512, 256}, 2)).utilization;
      const double high = packed(shapes, at({256, 512}, 2)).utilization;
      const double square = packed(shapes, at(362, 2)).utilization;
      // A few long letters leave little choice.
      const double least = count < 60 ? 0.7 : 0.9;
      CHECK(wide > least * square);
      CHECK(high > least * square);
    }
}

TEST_CASE("several tiles may be wide, and a chart too large for them names a size that fits",
          "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 30, 10, 4);
  PackOptions options = at({256, 128}, 2);
  options.udim = true;
  const Packing one = packed(shapes, at({256, 128}, 2));
  options.texelDensity = 1.5 * one.texelDensity;
  CHECK(packed(shapes, options).tiles > 1);
  checkPacked(shapes, options);
  options.texelDensity = 100 * one.texelDensity;
  const Result<Packing> tight = pack(shapes, options);
  CHECK(tight.status().code == StatusCode::AtlasTooSmall);
  CHECK(tight.status().message.find("a tile of 256 x 128 texels") != std::string::npos);
  options = at({16, 64}, 8);
  const Result<Packing> crowded = pack(makePackShapes("mixed", 60, 10, 4), options);
  CHECK(crowded.status().code == StatusCode::AtlasTooSmall);
  CHECK(crowded.status().message.find("Raise the resolution to ") != std::string::npos);
  CHECK(pack(shapes, at({64, 8}, 8)).status().code == StatusCode::InvalidOption);
}
