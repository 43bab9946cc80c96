#include "seam/make_symmetric.h"

#include <algorithm>
#include <optional>

#include "hole/fill_holes.h"
#include "seam/outline.h"
#include "seam/prediction.h"
#include "seam/seam_value.h"
#include "seam/symmetric_seams.h"

namespace abflat {
namespace {

struct Symmetric {
  Seams seams;
  LogScales u;
  double cost = 0;
};

class SymmetryMaker {
 public:
  explicit SymmetryMaker(const SeamWork& work)
      : work_(work),
        mesh_(work.mesh),
        before_(cutAlong(mesh_, work.seams)),
        was_(predictStretch(mesh_, before_, work.u)) {}

  bool run() {
    std::optional<Symmetric> best;
    bool isSolved = false;
    for (const int from : {1, -1}) {
      Seams seams = mirrored(mesh_, work_.options.mirror, work_.seams, from);
      for (const SurfaceCorner h : seams.ids()) seams[h] = seams[h] || work_.kept[h];
      if (seams == work_.seams) return isSolved;
      isSolved = true;
      std::optional<Symmetric> now = judge(std::move(seams));
      if (now && (!best || now->cost < best->cost)) best = std::move(now);
    }
    if (best) {
      work_.seams = std::move(best->seams);
      work_.u = std::move(best->u);
    }
    return isSolved;
  }

 private:
  std::optional<Symmetric> judge(Seams seams) const {
    CutSurface s = cutAlong(mesh_, seams);
    if (openTouchedHoles(mesh_, s, work_.options.fillHoles, seams)) s = cutAlong(mesh_, seams);
    LogScales u = work_.scale.solve(s, {});
    if (u.empty() || !areFine(s, u)) return {};
    const double cost =
        costOfWhole(mesh_, seams, u, work_.options.maxStretch, work_.options.prices);
    return Symmetric{std::move(seams), std::move(u), cost};
  }

  /// No worse than allowed, or than before.
  bool areFine(const CutSurface& s, const LogScales& u) const {
    const Prediction told = predictStretch(mesh_, s, u);
    const double most = std::max(work_.options.maxStretch,
                                 *std::max_element(was_.stretch.begin(), was_.stretch.end()));
    for (const CutChartId c : s.charts.ids()) {
      const CutChartId old = before_.chartOfTriangle[s.charts[c].firstTriangle];
      if (!s.charts[c].isDisk() || told.stretch[c] > most) return false;
      if (overlapsMore(mesh_, {s, c, u}, {before_, old, work_.u}, work_.options.mostOverlap))
        return false;
    }
    return true;
  }

  const SeamWork work_;
  const SeamMesh& mesh_;
  const CutSurface before_;
  const Prediction was_;
};

}  // namespace

bool makeSymmetric(const SeamWork& work) {
  return work.options.mirror && work.options.listener.tell() && SymmetryMaker(work).run();
}

}  // namespace abflat
