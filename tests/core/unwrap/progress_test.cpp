#include <algorithm>
#include <set>
#include <vector>

#include "abflat/unwrap.h"
#include "catch.h"
#include "support/meshes.h"
#include "support/unwrapped.h"
#include "unwrap/stage_span.h"

using namespace abflat;
using namespace abflat::test;

TEST_CASE("progress moves while seams are searched for", "[progress]") {
  std::vector<double> shares;
  UnwrapOptions options = severalCharts();
  options.progress = [&](const Progress& now) {
    if (now.stage == Stage::Seams) shares.push_back(now.fraction);
    return true;
  };
  unwrapped(torus(48, 32), options);
  REQUIRE(!shares.empty());
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(std::set<double>(shares.begin(), shares.end()).size() > 10);
  CHECK(shares.front() >= kSeams.from);
  CHECK(shares.back() < kSeams.to);
}

TEST_CASE("progress moves while a single chart is solved", "[progress]") {
  std::vector<double> shares;
  UnwrapOptions options;
  options.progress = [&](const Progress& now) {
    if (now.stage == Stage::Solve) shares.push_back(now.fraction);
    return true;
  };
  unwrapped(bumpyGrid(24, 24, 0.3, 1), options);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(std::set<double>(shares.begin(), shares.end()).size() > 5);
  REQUIRE(!shares.empty());
  CHECK(shares.front() >= kSolve.from);
  CHECK(shares.back() < kSolve.to);
}
