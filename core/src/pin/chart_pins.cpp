#include "pin/chart_pins.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/invalid.h"
#include "base/stable_order.h"
#include "mesh/corner_table.h"

namespace abflat {
namespace {

std::string nameOf(const Pin& pin) { return "vertex " + std::to_string(pin.vertex); }

/// A corner at a pinned vertex.
struct Use {
  std::uint32_t vertex, face;
  TexcoordId texcoord;
};

/// All corners at pinned vertices, by vertex.
std::vector<Use> findUses(const InputMesh& mesh, const Texcoords& texcoords,
                          const std::vector<Pin>& pins) {
  std::vector<std::uint8_t> isPinned(mesh.vertexCount(), 0);
  for (const Pin& pin : pins)
    if (pin.vertex < isPinned.size()) isPinned[pin.vertex] = 1;
  std::vector<Use> uses;
  for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
    for (InputCorner c(mesh.firstCorner(f)); c < mesh.firstCorner(f + 1); ++c)
      if (isPinned[mesh.vertex(c)] && texcoords.ofCorner[c].exists())
        uses.push_back({mesh.vertex(c), f, texcoords.ofCorner[c]});
  sortStably(uses, [](const Use& a, const Use& b) { return a.vertex < b.vertex; });
  return uses;
}

/// The first face of each texcoord, as text.
std::string facesToChoose(std::vector<Use> uses) {
  constexpr std::size_t kMost = 8;
  sortStably(uses, [](const Use& a, const Use& b) { return a.texcoord < b.texcoord; });
  std::string out;
  std::size_t count = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (i > 0 && uses[i].texcoord == uses[i - 1].texcoord) continue;
    if (++count <= kMost) out += (out.empty() ? "" : ", ") + std::to_string(uses[i].face);
  }
  return count > kMost ? out + ", ..." : out;
}

Result<TexcoordId> texcoordOf(const InputMesh& mesh, const std::vector<Use>& uses, const Pin& pin) {
  if (pin.vertex >= mesh.vertexCount())
    return invalid(nameOf(pin) + " is pinned, but the mesh has " +
                   std::to_string(mesh.vertexCount()) + " vertices (indices start at 0)");
  if (!std::isfinite(pin.uv[0]) || !std::isfinite(pin.uv[1]))
    return invalid("the uv that " + nameOf(pin) + " is pinned to must be two finite numbers");
  const auto [first, last] =
      std::equal_range(uses.begin(), uses.end(), Use{pin.vertex, 0, {}},
                       [](const Use& a, const Use& b) { return a.vertex < b.vertex; });
  if (first == last)
    return invalid(nameOf(pin) + " is pinned, but no flattened face uses it. Remove the pin");
  const auto chosen = pin.face == kAnyFace ? first : std::find_if(first, last, [&](const Use& u) {
    return u.face == pin.face;
  });
  if (chosen == last)
    return invalid(nameOf(pin) + " is pinned in face " + std::to_string(pin.face) +
                   ", which does not use it. Name a face that does, such as " +
                   std::to_string(first->face));
  const bool isTold = std::all_of(first, last, [&](const Use& u) {
    return u.texcoord == chosen->texcoord || (pin.face != kAnyFace && u.face != pin.face);
  });
  if (!isTold)
    return invalid(
        nameOf(pin) +
        " is pinned, but has several texcoords, one on each side of a seam. Choose one by "
        "naming a face that uses it: " +
        facesToChoose({first, last}));
  return chosen->texcoord;
}

/// A pin and the texcoord that it refers to.
struct Found {
  const Pin* pin;
  TexcoordId texcoord;
};

std::string bothNames(const Found& a, const Found& b) {
  return "vertices " + std::to_string(a.pin->vertex) + " and " + std::to_string(b.pin->vertex);
}

/// Sorts by texcoord.
Status checkApart(std::vector<Found>& found) {
  const auto sameNext = [&](auto&& less) {
    sortStably(found, less);
    return std::adjacent_find(found.begin(), found.end(),
                              [&](const Found& a, const Found& b) { return !less(a, b); });
  };
  const auto place = sameNext([](const Found& a, const Found& b) { return a.pin->uv < b.pin->uv; });
  if (place != found.end() && place->texcoord != (place + 1)->texcoord)
    return invalid(bothNames(*place, *(place + 1)) +
                   " are pinned to the same uv. Every vertex needs its own");
  const auto twice =
      sameNext([](const Found& a, const Found& b) { return a.texcoord < b.texcoord; });
  if (twice == found.end()) return {};
  if (twice->pin->vertex == (twice + 1)->pin->vertex)
    return invalid(nameOf(*twice->pin) + " is pinned twice. Remove one of the two pins");
  return invalid(bothNames(*twice, *(twice + 1)) +
                 " are duplicates and both pinned. Remove one of the two pins");
}

}  // namespace

Result<IdVector<ChartId, std::vector<ChartPin>>> pinsOfCharts(const InputMesh& mesh,
                                                              const Texcoords& texcoords,
                                                              const std::vector<Pin>& pins) {
  const std::size_t charts = texcoords.firstOf.size() - 1;
  IdVector<ChartId, std::vector<ChartPin>> out(charts);
  if (pins.empty()) return out;
  const std::vector<Use> uses = findUses(mesh, texcoords, pins);
  std::vector<Found> found;
  for (const Pin& pin : pins) {
    const Result<TexcoordId> texcoord = texcoordOf(mesh, uses, pin);
    if (!texcoord.ok()) return texcoord.status();
    found.push_back({&pin, texcoord.value()});
  }
  if (Status s = checkApart(found); !s.ok()) return s;
  ChartId chart(0);
  IdVector<ChartId, const Pin*> firstPin(charts, nullptr);
  for (const Found& f : found) {
    while (!(f.texcoord < texcoords.firstOf[ChartId(chart + 1)])) ++chart;
    const ChartVertex vertex(f.texcoord - texcoords.firstOf[chart]);
    out[chart].push_back({vertex, f.pin->uv});
    if (firstPin[chart] == nullptr) firstPin[chart] = f.pin;
  }
  for (const ChartId i : out.ids())
    if (out[i].size() == 1)
      return invalid(nameOf(*firstPin[i]) + " is the only pinned vertex" +
                     (charts > 1 ? " of its chart" : "") +
                     ", which leaves scale and rotation undetermined. Pin two or more, or none");
  return out;
}

}  // namespace abflat
