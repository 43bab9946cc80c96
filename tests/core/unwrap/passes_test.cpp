#include "unwrap/passes.h"

#include "catch.h"
#include "seam/vary_costs.h"
#include "unwrap/search.h"
#include "unwrap/variants.h"

using namespace abflat;

TEST_CASE("passes fill their part of the bar in turn", "[progress]") {
  for (const int passes : {1, 2, 5}) {
    double last = 0;
    const Listener run([&](const Progress& now) {
      last = now.fraction;
      return true;
    });
    Passes now(run, 1000);
    double before = 0;
    for (int k = 0; k < passes; ++k) {
      now.next(passes - 1 - k);
      for (const Listener& part : {now.seams(), now.layouts()}) {
        part.tell(0);
        CHECK(last >= before);
        before = last;
        part.tell(1);
        CHECK(last > before);
        before = last;
      }
    }
    CHECK(last <= Passes::kTo + 1e-12);
    CHECK(last > 0.8 * Passes::kTo);
  }
}

TEST_CASE("a pass takes the more of the bar, the fewer are expected after it", "[progress]") {
  double last = 0;
  const Listener run([&](const Progress& now) {
    last = now.fraction;
    return true;
  });
  Passes few(run, 1000), many(run, 1000);
  many.next(5);
  many.layouts().tell(1);
  const double ofMany = last;
  few.next(5);
  few.expect(0);
  few.layouts().tell(1);
  CHECK(last > ofMany);
  CHECK(last == Approx(Passes::kTo));
}

TEST_CASE("a few searches are expected, however many are worth their time", "[progress]") {
  CHECK(expectedSearches({}, OpenSurface()) == 0);
  const double several = expectedSearches(variantsWorth(100, 0), OpenSurface());
  CHECK(several > 3);
  CHECK(several < 6);
  CHECK(expectedSearches(variantsWorth(50'000, 0.1), OpenSurface()) == 0);
  CHECK(expectedSearches(100) > 3);
  CHECK(expectedSearches(50'000) > 0);
  CHECK(expectedSearches(1'000'000) == 0);
}
