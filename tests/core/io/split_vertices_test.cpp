#include "io/split_vertices.h"

#include <map>
#include <random>

#include "catch.h"

using namespace abflat;

namespace {

using Place = std::array<double, 2>;

Place at(const std::vector<double>& uv, std::size_t i) { return {uv[2 * i], uv[2 * i + 1]}; }

/// Checks for one vertex for each texcoord that a corner of a vertex has, and no others.
void checkSplit(std::size_t vertexCount, const std::vector<std::uint32_t>& faceVertices,
                const std::vector<double>& uv, const std::vector<std::uint32_t>& cornerUv) {
  const SplitVertices split = splitVertices(vertexCount, faceVertices, uv, cornerUv);
  REQUIRE(split.ofCorner.size() == faceVertices.size());
  REQUIRE(split.uv.size() == 2 * (vertexCount + split.copied.size()));
  std::map<std::pair<std::uint32_t, Place>, std::uint32_t> known;
  std::uint32_t copies = 0;
  std::vector<bool> isUsed(vertexCount, false);
  for (std::size_t c = 0; c < faceVertices.size(); ++c) {
    const std::uint32_t v = faceVertices[c], now = split.ofCorner[c];
    REQUIRE(now < vertexCount + split.copied.size());
    CHECK((now < vertexCount ? now : split.copied[now - vertexCount]) == v);
    CHECK(at(split.uv, now) == at(uv, cornerUv[c]));
    const auto [entry, isNew] = known.insert({{v, at(uv, cornerUv[c])}, now});
    CHECK(entry->second == now);
    if (!isNew) continue;
    // The first texcoord stays with the vertex; the others follow in corner order.
    CHECK(now == (isUsed[v] ? static_cast<std::uint32_t>(vertexCount) + copies++ : v));
    isUsed[v] = true;
  }
  CHECK(copies == split.copied.size());
}

}  // namespace

TEST_CASE("vertices are split by the values of texcoords, not by their numbers", "[ply]") {
  std::mt19937 engine(3);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(engine() % n); };
  for (int round = 0; round < 50; ++round) {
    const std::uint32_t vertices = 1 + below(10), texcoords = 1 + below(30);
    std::vector<double> uv;
    for (std::uint32_t i = 0; i < 2 * texcoords; ++i) uv.push_back(below(3) / 4.0);
    std::vector<std::uint32_t> faceVertices, cornerUv;
    for (std::uint32_t c = 3 * below(40); c > 0; --c) {
      faceVertices.push_back(below(vertices));
      cornerUv.push_back(below(texcoords));
    }
    checkSplit(vertices, faceVertices, uv, cornerUv);
  }
}

TEST_CASE("a vertex may have very many texcoords", "[ply]") {
  constexpr std::uint32_t kCount = 300000;  // quadratic time would take an hour
  std::vector<double> uv;
  std::vector<std::uint32_t> faceVertices, cornerUv;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    uv.insert(uv.end(), {i / double{kCount}, 0.5});
    faceVertices.push_back(0);
    cornerUv.push_back(i);
  }
  const SplitVertices split = splitVertices(1, faceVertices, uv, cornerUv);
  CHECK(split.copied.size() == kCount - 1);
  CHECK(split.ofCorner.back() == kCount - 1);
}
