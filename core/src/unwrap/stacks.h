#pragma once

#include <functional>

#include "seam/scale_seams.h"
#include "unwrap/alike_parts.h"
#include "unwrap/kept.h"

namespace abflat {

/// A surface that is to be cut, and what is known of its triangles and half-edges.
struct UncutParts {
  Surface& surface;
  FixedTriangles& fixed;
  Seams &breaks, &given;
  Scales& scales;
};

/// A surface that has been cut.
struct CutParts {
  Surface& surface;
  FixedTriangles& fixed;
  OpenSurface& open;
  LaidCharts& charts;
};

/// Leaves parts out of a run that are to lie on others of equal shape, and adds them again at its
/// end. Does nothing unless the options ask for it.
class Stacks {
 public:
  /// Faces of `unfit` are left alone; check() adds others.
  Stacks(const InputMesh& input, const WeldedMesh& welded, const UnwrapOptions& options,
         UnfitFaces& unfit)
      : input_(input), welded_(welded), options_(options), unfit_(unfit) {}

  /// Of components that are alike, leaves one in.
  void leaveOutComponents(const UncutParts& parts);

  /// Of charts that are alike, leaves one in. False if all remain.
  bool leaveOutCharts(const IdVector<ChartId, ChartConstraints>& constraints,
                      const CutParts& parts);

  /// Whether anything is left out.
  bool isAny() const { return !model_.empty(); }

  /// Puts all that was left out on what it is like. Returns the seams of the whole surface.
  Seams addAgain(const CutParts& parts);

  /// Then: the chart that each lies on, which is itself if that is none. Empty if nothing was left
  /// out.
  const IdVector<ChartId, ChartId>& modelOf() const { return modelOf_; }

  /// Lists charts that the certificate has not found on their models, or only turned over.
  void check(const UnwrapReport& report);

 private:
  bool mayStack() const;
  void keepOnly(const KeptTriangles& kept, Surface& surface, FixedTriangles& fixed);
  void addMatch(const CornerMatch& found);

  InputMesh input_;
  const WeldedMesh& welded_;
  const UnwrapOptions& options_;
  UnfitFaces& unfit_;
  Surface whole_;      ///< before parts were left out
  CornerMatch model_;  ///< per corner of its polygons, the one whose uv it gets
  IdVector<ChartId, ChartId> modelOf_;
};

/// Runs again without stacking what turns out not to fit: rarely, polygons of a copy whose own
/// triangles turn over in the layout of others.
Result<UnwrapResult> untilStacksFit(std::size_t faces,
                                    const std::function<Result<UnwrapResult>(UnfitFaces&)>& run);

}  // namespace abflat
