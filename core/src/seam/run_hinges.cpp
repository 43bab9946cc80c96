#include "seam/run_hinges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abflat {
namespace {

/// The edges of the run that begin between two distances along it.
SharedRun partOf(const SeamMesh& mesh, const SharedRun& run, double from, double to) {
  SharedRun out{run.a, run.b, {}, run.begin, 0, 0};
  double passed = 0;
  for (const SurfaceCorner h : run.edges) {
    if (passed < from) ++out.begin;
    if (passed >= from && passed < to) out.add(mesh, h);
    passed += mesh.length[h];
  }
  return out;
}

}  // namespace

std::vector<SharedRun> hingesOf(const SeamMesh& mesh, const RunImages& images, const CutSurface& s,
                                const std::vector<SharedRun>& runs) {
  constexpr double kWidth = 0.15;  // relative to the root of the smaller chart's area
  constexpr int kMost = 5;         // per run
  std::vector<SharedRun> out;
  for (const SharedRun& run : runs) {
    const double width = kWidth * std::sqrt(std::min(s.charts[run.a].area, s.charts[run.b].area));
    // What is its own image can only be joined in its middle.
    const bool isAroundPlane = images.isOwn(run) && !images.isInPlane(run);
    const int slots =
        isAroundPlane ? 1 : static_cast<int>(std::min<double>(kMost, run.length / width));
    for (int k = 0; k < slots; ++k) {
      const int slot = slots / 2 + (k % 2 == 1 ? (k + 1) / 2 : -k / 2);
      const double middle = run.length * (slot + 0.5) / slots;
      SharedRun part = partOf(mesh, run, middle - width / 2, middle + width / 2);
      if (isAroundPlane) part = images.inItself(part);
      if (!part.edges.empty()) out.push_back(std::move(part));
    }
  }
  return out;
}

}  // namespace abflat
