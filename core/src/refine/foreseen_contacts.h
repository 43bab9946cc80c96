#pragma once

#include <vector>

#include "chart/disk_chart.h"
#include "refine/outline_shape.h"

namespace abflat {

/// Places where the boundary would cross itself along a step, or an angle exceed its bound. Springs
/// keep them from it in the model of the energy that the step minimises, so that the step is not
/// cut short there.
class ForeseenContacts {
 public:
  /// Keeps references.
  ForeseenContacts(const DiskChart& chart, const OutlineShape& shape, double reach);

  /// Of the springs that the last step needed, keeps those that the next one from `uv` may need.
  void begin(const std::vector<double>& uv);

  /// Looks along a step that was found with the springs so far: adds some where it crosses, takes
  /// away those that pull. False where the step is as good as it gets: crosses nowhere, or only
  /// where springs do not help.
  /// Angles are looked at after `angleLength` of it.
  bool update(const std::vector<double>& uv, const std::vector<double>& step, double length,
              double angleLength);

  void clear() { springs_.clear(); }

  /// Of the springs' energy where `begin` was told.
  void addDerivatives(Eigen::VectorXd& gradient, SparseEntries& hessian) const;

 private:
  struct Spring {
    BoundaryIndex point, edge;  ///< the same twice: an angle
    bool isBeside;              ///< the point an inner place of the edge
    BoundaryContact contact;
    double gap;     ///< now
    double target;  ///< after the step, at least
    double stiffness;
    double moment = 0;  ///< of the step, where it was seen to cross
  };

  Spring springAt(const std::vector<double>& now, const std::vector<double>& then,
                  BoundaryIndex point, BoundaryIndex edge) const;
  Spring springAt(const OutlineShape::Bound& bound, const std::vector<double>& uv) const;
  bool updateAngles(const std::vector<double>& uv, const std::vector<double>& step, double length);
  static bool isBefore(const Spring& a, const Spring& b);
  std::vector<Spring>::iterator placeFor(const Spring& spring);
  bool releasePulling(const std::vector<double>& step);
  /// What the step would go through, in its order.
  std::vector<Spring> crossed(const std::vector<double>& uv, const std::vector<double>& step,
                              double length, bool& isCrossing) const;
  static void keepFirst(std::vector<Spring>& springs);
  bool add(const Spring& spring);

  const DiskChart& chart_;
  const OutlineShape& shape_;
  double area_, distance_;
  std::vector<Spring> springs_;  ///< by points, then by edges
  bool isCrowded_ = false;       ///< since `begin`
};

}  // namespace abflat
