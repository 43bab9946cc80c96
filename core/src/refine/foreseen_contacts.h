#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/outline_shape.h"

namespace abflat {

/// Places where the boundary would cross itself along a step, or an angle would exceed its bound.
/// Springs prevent this in the model of the energy that the step minimises, so that the step is not
/// cut short there.
class ForeseenContacts {
 public:
  /// Keeps references to the chart and the shape.
  ForeseenContacts(const DiskChart& chart, const OutlineShape& shape, double reach);

  /// Of the springs that the last step needed, keeps those that the next one, from `uv`, may need.
  void begin(const std::vector<double>& uv);

  /// Looks along a step that was found with the springs so far: adds springs where it crosses, and
  /// removes those that pull. False if the step cannot be improved: it crosses nowhere, or only
  /// where springs do not help. Angles are checked after `angleLength` of the step.
  bool update(const std::vector<double>& uv, const std::vector<double>& step, double length,
              double angleLength);

  void clear() { springs_.clear(); }

  /// Adds the derivatives of the springs' energy at the `uv` passed to `begin`.
  void addDerivatives(Eigen::VectorXd& gradient, SparseEntries& hessian) const;

 private:
  struct Spring {
    BoundaryIndex point, edge;  ///< equal for an angle
    bool isBeside;              ///< the nearest place of the edge is not one of its ends
    BoundaryContact contact;
    double gap;     ///< before the step
    double target;  ///< smallest allowed gap after the step
    double stiffness;
    double moment = 0;  ///< share of the step at which it was seen to cross
  };

  Spring springAt(const std::vector<double>& now, const std::vector<double>& then,
                  BoundaryIndex point, BoundaryIndex edge) const;
  Spring springAt(const OutlineShape::Bound& bound, const std::vector<double>& uv) const;
  bool updateAngles(const std::vector<double>& uv, const std::vector<double>& step, double length);
  static bool isBefore(const Spring& a, const Spring& b);
  std::vector<Spring>::iterator placeFor(const Spring& spring);
  bool releasePulling(const std::vector<double>& step);
  /// Springs for what the step would go through, in the order in which it does.
  std::vector<Spring> crossed(const std::vector<double>& uv, const std::vector<double>& step,
                              double length, bool& isCrossing) const;
  static void keepFirst(std::vector<Spring>& springs);
  bool add(const Spring& spring);

  const DiskChart& chart_;
  const OutlineShape& shape_;
  double area_, distance_;
  std::vector<Spring> springs_;  ///< by point, then by edge
  bool isCrowded_ = false;       ///< since `begin`
};

}  // namespace abflat
