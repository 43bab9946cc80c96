#include "stack_oracle.h"

#include <array>
#include <map>
#include <set>
#include <utility>

namespace abflat::fuzz {
namespace {

using Point = std::array<double, 2>;
using Edge = std::pair<Point, Point>;

void append(const AtlasTriangles& from, std::size_t i, bool isTurned, AtlasTriangles& to) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double* p = &from.uv[6 * i + 2 * (isTurned ? 2 - k : k)];
    to.uv.insert(to.uv.end(), {p[0], p[1]});
  }
  to.mayBeFlat.push_back(from.mayBeFlat[i]);
}

/// Edges with one triangle, whichever way they run.
std::set<Edge> outlineOf(const AtlasTriangles& chart) {
  std::map<Edge, int> count;
  for (std::size_t i = 0; i < chart.uv.size(); i += 6) {
    const auto at = [&](std::size_t k) {
      return Point{chart.uv[i + 2 * k], chart.uv[i + 2 * k + 1]};
    };
    if (at(0) == at(1) || at(1) == at(2) || at(2) == at(0)) continue;  // covers nothing
    for (std::size_t k = 0; k < 3; ++k) ++count[std::minmax(at(k), at((k + 1) % 3))];
  }
  std::set<Edge> out;
  for (const auto& [edge, times] : count)
    if (times % 2 == 1) out.insert(edge);
  return out;
}

}  // namespace

std::string stackedComplaint(const AtlasTriangles& triangles,
                             const std::vector<std::uint32_t>& chartOf,
                             const UnwrapReport& report) {
  const std::vector<UnwrapChart>& charts = report.charts;
  std::vector<AtlasTriangles> own(charts.size());
  AtlasTriangles lowest;
  for (std::size_t i = 0; i < chartOf.size(); ++i) {
    const bool isChart = chartOf[i] < charts.size();
    if (isChart) append(triangles, i, charts[chartOf[i]].mirrored, own[chartOf[i]]);
    if (!isChart || charts[chartOf[i]].stackedOn < 0) append(triangles, i, false, lowest);
  }
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const int on = charts[c].stackedOn;
    if (on < 0) continue;
    const std::string name = "chart " + std::to_string(c);
    if (charts[static_cast<std::size_t>(on)].stackedOn >= 0) return name + " lies on a stacked one";
    if (outlineOf(own[c]) != outlineOf(own[static_cast<std::size_t>(on)]))
      return name + " has another outline than the one below";
    if (const std::string wrong = complaint(own[c], report.atlas.tiles); !wrong.empty())
      return name + ": " + wrong;
  }
  return complaint(lowest, report.atlas.tiles);
}

}  // namespace abflat::fuzz
