#include "pack/pack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "catch.h"
#include "pack/level_pose.h"
#include "pack/packing.h"
#include "pack/shapes.h"
#include "pack/texels.h"
#include "support/instrumented.h"

using namespace abflat;
using namespace abflat::test;

namespace {

PackShape rectangle(double width, double height) {
  PackShape s;
  s.uv = {0, 0, width, 0, width, height, 0, height};
  s.triangles = {0, 1, 2, 0, 2, 3};
  s.outline = {0, 1, 2, 3};
  return s;
}

PackShape scaled(PackShape shape, double by) {
  for (double& x : shape.uv) x *= by;
  return shape;
}

void checkBoundOfWork(std::size_t count) {
  const std::vector<PackShape> shapes = makePackShapes("mixed", count, 5, 3);
  PackOptions options = at(512, 2);
  const Packing without = packed(shapes, options);
  double used = 0;
  int tries = 0;
  for (options.work = 1; options.work < 1e8; options.work *= 10) {
    checkPacked(shapes, options);
    const Packing one = packed(shapes, options);
    CHECK(one.utilization >= used);
    CHECK(one.tries >= tries);
    used = one.utilization;
    tries = one.tries;
    ThreadPool pool(3);
    options.pool = &pool;
    const Packing more = packed(shapes, options);
    options.pool = nullptr;
    CHECK(one.scale == more.scale);
    CHECK(one.tries == more.tries);
  }
  CHECK(used == without.utilization);
  CHECK(tries == without.tries);
  options.work = 1;
  CHECK(packed(shapes, options).tries < without.tries);
}

}  // namespace

TEST_CASE("no texel has two charts, and padding lies between them", "[pack]") {
  const char* const kind = GENERATE("mixed", "stars", "spirals", "letters", "needles", "triangles");
  for (const std::size_t count : {1, 3, 30})
    for (const int resolution : {100, 257})
      for (const int padding : {0, 1, 2, 5}) {
        CAPTURE(kind, count, resolution, padding);
        checkPacked(makePackShapes(kind, count, 10, static_cast<unsigned>(count)),
                    at(resolution, padding));
      }
}

TEST_CASE("the margin at the edge of the tile is as asked, whatever the padding", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 12, 5, 8);
  PackOptions options = at(256, 4);
  const double usual = packed(shapes, options).scale;
  for (const int margin : {0, 1, 2, 5, 30}) {
    CAPTURE(margin);
    options.margin = margin;
    checkPacked(shapes, options);
    const double scale = packed(shapes, options).scale;
    if (margin == 2) CHECK(scale == usual);
    if (margin == 30) CHECK(scale < usual);
  }
  options.margin = 127;
  const Result<Packing> crowded = pack(shapes, options);
  CHECK(crowded.status().code == StatusCode::AtlasTooSmall);
  CHECK(crowded.status().message.find("lower the margin") != std::string::npos);
  options.margin = 128;
  CHECK(pack(shapes, options).status().code == StatusCode::InvalidOption);
}

TEST_CASE("the same where cells are larger than texels", "[pack]") {
  for (const std::size_t count : {3, 30})
    for (const int padding : {0, 4, 9}) {
      if (kIsInstrumented && (count > 3 || padding != 4)) continue;
      CAPTURE(count, padding);
      checkPacked(makePackShapes("mixed", count, 5, 8), at(1030, padding));
    }
}

TEST_CASE("thousands of small charts, and tiny ones beside large ones", "[pack]") {
  checkPacked(makePackShapes("mixed", 3000, 4, 1), at(512, 2));
  std::vector<PackShape> shapes = makePackShapes("mixed", 30, 2, 1);
  for (const PackShape& tiny : makePackShapes("mixed", 100, 2, 2))
    shapes.push_back(scaled(tiny, 1e-6));
  checkPacked(shapes, at(128, 2));
  shapes.push_back(scaled(rectangle(1, 1), 0));
  shapes.push_back(rectangle(0.5, 0));
  shapes.push_back(rectangle(0, 0.7));
  shapes.emplace_back();
  const Packing packing = packed(shapes, at(128, 2));
  CHECK(complaint(shapes, packing, at(128, 2)) == "");
}

TEST_CASE("a search may begin at the density of a former one, and among many charts goes no higher",
          "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 1200, 4, 1);
  PackOptions options = at(512, 2);
  const Packing before = packed(shapes, options);
  for (const double share : {0.5, 1.0, 1.1, 1e3}) {
    options.formerDensity = share * before.texelDensity;
    checkPacked(shapes, options);
    const Packing now = packed(shapes, options);
    CHECK(now.texelDensity > 0.95 * std::min(share, 1.0) * before.texelDensity);
    CHECK(now.texelDensity <= (1 + 1e-9) * options.formerDensity);
    if (share == 1) CHECK(now.tries < before.tries);
  }
}

TEST_CASE("as many texels as charts is enough room", "[pack][quality]") {
  std::vector<PackShape> shapes = makePackShapes("triangles", 400, 3, 1);
  for (const int padding : {0, 1, 2, 3}) {
    const int least = 20 + 19 * padding + 2 * ((padding + 1) / 2);
    checkPacked(shapes, at(least, padding));
    const Result<Packing> none = pack(shapes, at(least - 1, padding));
    CHECK(none.status().code == StatusCode::AtlasTooSmall);
    CHECK(none.status().message.find("Raise the resolution to " + std::to_string(least)) !=
          std::string::npos);
  }
}

TEST_CASE("room for single texels is found where cells are larger", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("triangles", 4, 3, 1);
  checkPacked(shapes, at(582, 290));
  CHECK(pack(shapes, at(581, 290)).status().message.find("resolution to 582") != std::string::npos);
}

TEST_CASE("the unit of the charts does not matter", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 40, 5, 6);
  const PackOptions options = at(300, 2);
  const Packing first = packed(shapes, options);
  for (const double unit : {1e-6, 1e-3, 7.0, 1e6}) {
    std::vector<PackShape> others;
    for (const PackShape& s : shapes) others.push_back(scaled(s, unit));
    const Packing second = packed(others, options);
    CHECK(second.scale * unit == Approx(first.scale).epsilon(1e-9));
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const std::vector<double> a = placed(shapes[i], first.placements[i], false);
      const std::vector<double> b = placed(others[i], second.placements[i], false);
      for (std::size_t k = 0; k < a.size(); ++k) CHECK(std::abs(a[k] - b[k]) < 1e-6);
    }
  }
}

TEST_CASE("charts as small as numbers get are packed, whatever is left of them", "[pack]") {
  for (const double unit : {1e-100, 1e-300, 1e-306, 1e-310, 0.0}) {
    std::vector<PackShape> shapes;
    for (const PackShape& s : makePackShapes("mixed", 12, 5, 6)) shapes.push_back(scaled(s, unit));
    INFO(unit);
    const Packing packing = packed(shapes, at(300, 2));
    CHECK(std::isfinite(packing.scale));
    CHECK(packing.placements.size() == shapes.size());
  }
}

TEST_CASE("threads do not change a packing", "[pack]") {
  for (const std::size_t count : {3, 25, cases(100, 60), cases(300, 3)}) {
    const std::vector<PackShape> shapes = makePackShapes("mixed", count, 5, 6);
    PackOptions options = at(512, 2);
    const Packing one = packed(shapes, options);
    for (const unsigned threads : {2, 3, 8}) {
      ThreadPool pool(threads);
      options.pool = &pool;
      const Packing more = packed(shapes, options);
      CHECK(one.scale == more.scale);
      CHECK(one.tries == more.tries);
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Placement a = one.placements[i], b = more.placements[i];
        CHECK((a.a == b.a && a.b == b.b && a.x == b.x && a.y == b.y && a.tile == b.tile));
      }
    }
  }
}

TEST_CASE("with a bound of work all charts are packed, and the better the more it allows",
          "[pack][quality]") {
  for (const std::size_t count : {2, 5, 25, 100})
    if (count <= cases<std::size_t>(100, 25)) checkBoundOfWork(count);
}

TEST_CASE("with a bound of work hundreds of charts are packed", "[pack][.long]") {
  checkBoundOfWork(300);
}

TEST_CASE("tiles are well used", "[pack]") {
  const auto used = [](const std::vector<PackShape>& shapes) {
    return packed(shapes, at(1024, 2)).utilization;
  };
  CHECK(used({rectangle(2, 2)}) > 0.98);
  CHECK(used(std::vector<PackShape>(4, rectangle(3, 3))) > 0.97);
  CHECK(used(std::vector<PackShape>(64, rectangle(1, 1))) > 0.93);
  // A slightly smaller shape fits into the hole of a frame that has a slit.
  PackShape frame;
  frame.uv = {0,   0,   1,   0,   1,   1,   0,    1,   0,    0.02,  0.1, 0.02,
              0.1, 0.9, 0.9, 0.9, 0.9, 0.1, 0.02, 0.1, 0.02, 0.015, 0,   0.01};
  frame.triangles = {0, 1, 8, 0, 8, 9, 1, 2, 8, 2, 7, 8, 2, 3, 7, 3, 6, 7, 3, 4, 6, 4, 5, 6};
  frame.outline = {};
  CHECK(used({frame, rectangle(0.75, 0.75)}) > 0.85);
  CHECK(used(makePackShapes("mixed", 100, 8, 1)) > 0.65);
}

TEST_CASE("a density is kept, and takes as many tiles as it needs", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 60, 3, 2);
  PackOptions options = at(200, 2);
  const double most = packed(shapes, options).texelDensity;
  options.texelDensity = 0.7 * most;
  Packing packing = packed(shapes, options);
  CHECK(packing.scale == options.texelDensity / 200);
  CHECK(packing.tiles == 1);
  CHECK(complaint(shapes, packing, options) == "");

  options.texelDensity = 2.5 * most;
  options.udim = true;
  packing = packed(shapes, options);
  CHECK(packing.scale == options.texelDensity / 200);
  CHECK(packing.tiles >= 5);
  CHECK(packing.tiles <= 10);
  CHECK(complaint(shapes, packing, options) == "");
  CHECK(complaint(shapes, packing, options, true) == "");
}

/// The number that follows these words in the message.
double after(const std::string& words, const Status& status) {
  INFO(status.message);
  CHECK(status.code == StatusCode::AtlasTooSmall);
  const std::size_t at = status.message.find(words);
  REQUIRE(at != std::string::npos);
  return std::stod(status.message.substr(at + words.size()));
}

TEST_CASE("a density that does not fit names one, and a resolution, that do", "[pack]") {
  for (const std::size_t count : {1, 7, 40}) {
    const std::vector<PackShape> shapes = makePackShapes("mixed", count, 3, 2);
    PackOptions options = at(64, 2);
    const double most = packed(shapes, options).texelDensity;
    for (const double factor : {1.0001, 2.5, 8.0}) {
      options = at(64, 2);
      options.texelDensity = factor * most;
      const Result<Packing> tight = pack(shapes, options);
      if (factor < 2 && tight.ok()) continue;
      PackOptions coarser = options, finer = options;
      coarser.texelDensity =
          after("do not fit one tile of 64 texels. Lower the density to ", tight.status());
      CHECK(coarser.texelDensity < options.texelDensity);
      CHECK(coarser.texelDensity > 0.9 * most);
      CHECK(complaint(shapes, packed(shapes, coarser), coarser) == "");
      finer.resolution = static_cast<int>(after("raise the resolution to ", tight.status()));
      CHECK(finer.resolution.width < 1.2 * factor * 64);
      CHECK(complaint(shapes, packed(shapes, finer), finer) == "");
    }
  }
}

TEST_CASE("a chart larger than a tile names the density and resolution that it fits", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 20, 3, 2);
  PackOptions options = at(64, 2);
  options.udim = true;
  options.texelDensity = 8 * packed(shapes, at(64, 2)).texelDensity;
  const Result<Packing> none = pack(shapes, options);
  PackOptions coarser = options, finer = options;
  coarser.texelDensity =
      after("does not fit a tile of 64 texels. Lower the density to ", none.status());
  finer.resolution = static_cast<int>(after("raise the resolution to ", none.status()));
  CHECK(complaint(shapes, packed(shapes, coarser), coarser) == "");
  CHECK(complaint(shapes, packed(shapes, finer), finer) == "");
}

TEST_CASE("fixed charts stay, and others go around them", "[pack]") {
  std::vector<PackShape> shapes = makePackShapes("mixed", 30, 3, 2);
  PackShape fixed = rectangle(0.5, 0.25);
  for (std::size_t i = 0; i < fixed.uv.size(); ++i) fixed.uv[i] += 0.3;
  fixed.isFixed = true;
  shapes.insert(shapes.begin() + 7, fixed);
  PackOptions options = at(256, 2);
  Packing packing = packed(shapes, options);
  CHECK(complaint(shapes, packing, options) == "");
  CHECK(placed(fixed, packing.placements[7], false) == fixed.uv);

  // In another tile.
  options.texelDensity = packing.texelDensity;
  options.udim = true;
  for (std::size_t i = 0; i < fixed.uv.size(); ++i) shapes[7].uv[i] += i % 2 ? 1 : 3;
  packing = packed(shapes, options);
  CHECK(packing.placements[7].tile == 13);
  CHECK(packing.tiles == 14);
  CHECK(complaint(shapes, packing, options) == "");
  options.udim = false;
  CHECK(pack(shapes, options).status().message.find("chart 7 is fixed") == 0);
}

TEST_CASE("what cannot be packed is named", "[pack]") {
  const std::vector<PackShape> shapes = makePackShapes("mixed", 3, 3, 2);
  CHECK(pack(shapes, at(0, 0)).status().code == StatusCode::InvalidOption);
  CHECK(pack(shapes, at(8, -1)).status().code == StatusCode::InvalidOption);
  CHECK(pack(shapes, at(8, 8)).status().code == StatusCode::InvalidOption);
  PackOptions options;
  options.texelDensity = std::nan("");
  CHECK(pack(shapes, options).status().code == StatusCode::InvalidOption);
  std::vector<PackShape> broken = shapes;
  broken[1].uv[3] = INFINITY;
  CHECK(pack(broken, {}).status().message.find("chart 1 ") == 0);
  options = {};
  options.listener = Listener([](const Progress&) { return false; });
  CHECK(pack(shapes, options).status().code == StatusCode::Aborted);
  CHECK(packed({}, {}).tiles == 1);
}

TEST_CASE("progress grows from 0 to at most 1", "[pack]") {
  PackOptions options;
  double last = 0;
  int calls = 0;
  options.listener = Listener([&](const Progress& now) {
    CHECK(now.fraction >= last);
    CHECK(now.fraction <= 1);
    last = now.fraction;
    ++calls;
    return true;
  });
  packed(makePackShapes("mixed", 200, 3, 2), options);
  CHECK(calls > 3);
}

TEST_CASE("charts are turned only as far as they may", "[pack]") {
  std::vector<PackShape> shapes = makePackShapes("mixed", 50, 3, 2);
  for (std::size_t i = 0; i < shapes.size(); i += 2) {
    shapes[i].upU = std::sin(0.3 * static_cast<double>(i));
    shapes[i].upV = std::cos(0.3 * static_cast<double>(i));
  }
  for (const Rotate rotate : {Rotate::None, Rotate::Quarter}) {
    PackOptions options;
    options.rotate = rotate;
    const Packing packing = packed(shapes, options);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Loops loops = coveringLoops(shapes[i]);
      const Pose pose =
          levelPose(loops, convexHull(loops.points), {shapes[i].upU, shapes[i].upV}).pose;
      const Placement& p = packing.placements[i];
      const double along = (p.a * pose.cos + p.b * pose.sin) / packing.scale;
      const double across = (p.b * pose.cos - p.a * pose.sin) / packing.scale;
      const double most = std::max(std::abs(along), std::abs(across));
      CHECK((rotate == Rotate::None ? along : most) == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("a chart that stands is turned askew only where that gains texels", "[pack]") {
  constexpr unsigned kSides = 60;
  const auto cosineOf = [&](double width) {
    PackShape ellipse;
    ellipse.upV = 1;
    for (unsigned k = 0; k < kSides; ++k) {
      const double angle = 2 * kPi * k / kSides;
      ellipse.uv.insert(ellipse.uv.end(), {width * std::cos(angle), std::sin(angle)});
      if (k >= 2) ellipse.triangles.insert(ellipse.triangles.end(), {0, k - 1, k});
    }
    const Packing packing = packed({ellipse}, {});
    return packing.placements[0].a / packing.scale;
  };
  // From corner to corner of the square, an ellipse of 1.05 gains 2 %, one of 1.6 gains 20 %.
  CHECK(cosineOf(1.05) == Approx(1));
  CHECK(std::abs(cosineOf(1.6)) == Approx(std::sqrt(0.5)).epsilon(0.1));
}

TEST_CASE("charts that stand are upright where that costs few texels", "[pack]") {
  std::vector<PackShape> shapes = makePackShapes("rectangles", 60, 4, 2);
  for (PackShape& shape : shapes) shape.upV = 1;
  PackOptions options;
  const double freely = packed(makePackShapes("rectangles", 60, 4, 2), options).texelDensity;
  const Packing packing = packed(shapes, options);
  const auto turned = std::count_if(packing.placements.begin(), packing.placements.end(),
                                    [](const Placement& p) { return !(p.a > std::abs(p.b)); });
  CHECK(packing.texelDensity > 0.95 * freely);
  CHECK(turned < 20);
}
