// Generated from core/schema by scripts/generate.mjs, do not edit.
// clang-format off
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "abflat/generated/names.h"

namespace abflat {

/// How one method flattens a mesh; measures are null without a layout, and where they are infinite.
struct MethodResult {
  /// The method.
  MethodKey method = MethodKey::AbflatAuto;
  /// Its display name, such as "LSCM, free".
  std::string title;
  /// Time to lay out, check and measure, without reading and connectivity, in seconds.
  double seconds = 0;
  /// Mean over corners of ((x - α)/α)², with x the angle in uv and α that in 3D.
  double angularDistortion = std::numeric_limits<double>::quiet_NaN();
  /// Mean over edges of (sL/l - 1)², with L the length in uv, l that in 3D and s = Σl/ΣL.
  double lengthDistortion = std::numeric_limits<double>::quiet_NaN();
  /// Mean by 3D area of |log(uv area / 3D area)| at equal total area: 0 keeps all areas, log 2 =
  /// 0.69 is off by a factor of two.
  double areaDistortion = std::numeric_limits<double>::quiet_NaN();
  /// Ratio of uv area to 3D area at equal total area; negative where a triangle is flipped:
  /// minimum.
  double areaRatioMin = std::numeric_limits<double>::quiet_NaN();
  /// Ratio of uv area to 3D area at equal total area; negative where a triangle is flipped:
  /// maximum.
  double areaRatioMax = std::numeric_limits<double>::quiet_NaN();
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): mean by 3D area.
  double quasiConformalMean = std::numeric_limits<double>::quiet_NaN();
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): maximum.
  double quasiConformalMax = std::numeric_limits<double>::quiet_NaN();
  /// Ratio σ₁/σ₂ of the singular values of the map (1 = conformal): share of the 3D area where it
  /// exceeds 1.25.
  double quasiConformalSheared = std::numeric_limits<double>::quiet_NaN();
  /// Mean by 3D area of (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/4 (1 = isometric).
  double symmetricDirichlet = std::numeric_limits<double>::quiet_NaN();
  /// Triangles that are not positively oriented, by an exact predicate; 0 in a valid layout.
  std::size_t flippedTriangles = 0;
  /// Pairs of boundary edges that cross or touch, by an exact predicate; 0 in a valid layout.
  std::size_t boundaryCrossings = 0;
  /// Whether there is no flipped triangle and no crossing, and the method converged.
  bool valid = false;
  /// Why the layout is not valid or what went wrong, one sentence; empty when it is valid.
  std::string problem;
  /// 2 per output vertex, scaled to the area of the 3D surface; empty without a layout.
  std::vector<double> uv;
};

template <class Visitor>
void visitFields(const MethodResult& r, Visitor& v) {
  v.field("method", r.method);
  v.field("title", r.title);
  v.field("seconds", r.seconds);
  v.field("angularDistortion", r.angularDistortion);
  v.field("lengthDistortion", r.lengthDistortion);
  v.field("areaDistortion", r.areaDistortion);
  v.begin("areaRatio");
  v.field("min", r.areaRatioMin);
  v.field("max", r.areaRatioMax);
  v.end();
  v.begin("quasiConformal");
  v.field("mean", r.quasiConformalMean);
  v.field("max", r.quasiConformalMax);
  v.field("sheared", r.quasiConformalSheared);
  v.end();
  v.field("symmetricDirichlet", r.symmetricDirichlet);
  v.field("flippedTriangles", r.flippedTriangles);
  v.field("boundaryCrossings", r.boundaryCrossings);
  v.field("valid", r.valid);
  v.field("problem", r.problem);
}

}  // namespace abflat
