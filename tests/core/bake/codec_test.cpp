#include "bake/codec.h"

#include "bake/baked.h"

using namespace abflat;
using test::encoded;
using test::linearised;

TEST_CASE("numbers and their sRGB values lead to each other") {
  for (const int bits : {8, 16}) {
    const Codec codec(ColourSpace::Srgb, bits);
    const auto most = static_cast<double>(codec.values().size() - 1);
    for (std::uint32_t code = 0; code <= most; ++code) {
      REQUIRE(codec.values()[code] == Approx(linearised(code / most)).epsilon(1e-6));
      REQUIRE(codec.encode(codec.values()[code]) == code);
    }
    for (int i = 0; i <= 1000; ++i)
      REQUIRE(codec.encode(static_cast<float>(i) / 1000) ==
              Approx(most * encoded(i / 1000.0)).margin(0.51));
    CHECK(codec.encode(-1) == 0);
    CHECK(codec.encode(2) == most);
  }
}
