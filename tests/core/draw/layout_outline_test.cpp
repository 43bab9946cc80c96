#include "draw/layout_outline.h"

#include <set>

#include "abflat/flatten.h"
#include "abflat/samples.h"
#include "catch.h"

using namespace abflat;

TEST_CASE("the outline has every edge once and the boundary in order", "[draw]") {
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    const Result<FlattenResult> flat = flatten(sample.make(1), {});
    REQUIRE(flat.ok());
    const ChartReport& chart = flat.value().report.charts.front();
    const LayoutOutline outline = outlineOf(flat.value());
    CHECK(outline.boundary.size() == chart.boundaryVertices);
    CHECK(2 * outline.inner.size() + outline.boundary.size() == 3 * chart.faces);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& e : outline.inner)
      CHECK(edges.emplace(std::min(e[0], e[1]), std::max(e[0], e[1])).second);

    std::set<std::pair<std::uint32_t, std::uint32_t>> walked;
    for (const auto& trail : trails(outline.inner, flat.value().uv.size() / 2))
      for (std::size_t i = 1; i < trail.size(); ++i)
        CHECK(walked.emplace(std::min(trail[i - 1], trail[i]), std::max(trail[i - 1], trail[i]))
                  .second);
    CHECK(walked == edges);
  }
}
