#pragma once

#include "seam/mirror.h"
#include "seam/shared_runs.h"

namespace abflat {

/// The mirror images of runs.
class RunImages {
 public:
  RunImages(const SeamMesh& mesh, const Mirror& mirror) : mesh_(mesh), mirror_(mirror) {}

  /// Whether all of the run has an image.
  bool has(const SharedRun& run) const;
  bool isOwn(const SharedRun& run) const;
  /// Whether the run lies in the plane of symmetry, so that it is between a chart and its image.
  bool isInPlane(const SharedRun& run) const;
  /// The edges of the run whose images are in it as well.
  SharedRun inItself(const SharedRun& run) const;
  /// The run and its image, if that is another one. None if they cannot be joined together. What
  /// has no image is joined alone.
  RunsTogether together(const CutSurface& s, const Seams& kept, const SharedRun& run) const;

 private:
  bool isOn(const SharedRun& run, SurfaceCorner edge) const;
  bool isImageOn(const SharedRun& run, SurfaceCorner edge) const;

  const SeamMesh& mesh_;
  const Mirror& mirror_;
};

}  // namespace abflat
