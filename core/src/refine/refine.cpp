#include "refine/refine.h"

#include <algorithm>
#include <cmath>

#include "base/point2.h"
#include "check/validity.h"
#include "mesh/triangle_geometry.h"
#include "refine/boundary_barrier.h"
#include "refine/extended_matrix.h"
#include "refine/foreseen_contacts.h"
#include "refine/layout_energy.h"
#include "refine/refine_system.h"
#include "solve/row_solver.h"

namespace abflat {
namespace {

/// Residual of the linear system, relative to the largest entry of the gradient.
constexpr double kLinearTolerance = 1e-2;
/// The same where springs are so stiff that even a small residual goes a long way.
constexpr double kLinearToleranceHeld = 1e-4;
/// Share of the way to the first triangle without area.
constexpr double kShareOfLongest = 0.9;
/// A step that promises to gain more than this share of the energy above that at rest is followed
/// by one of the Far kind.
constexpr double kFar = 0.15;
/// This share of the whole energy counts as much as all of it above that at rest.
constexpr double kShareOfEnergy = 0.025;
/// Ratio of a step's gain to that of the step before: a better one is not expected, and nothing is
/// concluded from a worse one.
constexpr double kFastest = 0.1, kSlowest = 0.5;
/// How often a step may look ahead: each time solves a system.
constexpr int kRounds = 6;
constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 40;
/// Relative to the energy: smaller changes are indistinguishable from rounding.
constexpr double kRounding = 1e-10;

std::vector<std::uint32_t> rankOfRows(const IdVector<ChartVertex, std::uint32_t>& ofVertices) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t rank : ofVertices) out.insert(out.end(), 2, rank);
  return out;
}

/// Has the effect of scaling every layout by `scale`.
RestTriangles scaledDown(RestTriangles rest, double scale) {
  for (RestTriangle& t : rest) {
    t.c1x *= scale;
    t.c1y *= scale;
    t.c2y *= scale;
  }
  return rest;
}

class Refiner {
 public:
  Refiner(const DiskChart& chart, std::vector<double> uv, const RefineOptions& options)
      : chart_(chart),
        options_(options),
        rest_(restTriangles(chart, uv)),
        uv_(std::move(uv)),
        system_(chart, rest_, options.pool),
        shape_(chart, options.outline),
        springs_(options.level) {
    out_.memory.allowed = options.allowedBytes;
    findHeld();
    matrix_ = std::make_unique<ExtendedMatrix>(system_.matrix(), freeOf(shape_.entries()));
    makeSolver(matrix_->sum());
    if (solver_->eliminationRank()) system_.divide(*solver_->eliminationRank());
    if (!options.outline.isEmpty()) lookAhead();
  }

  Refinement run() {
    const double scale = bestScale(chart_, rest_, options_.energy, uv_);
    if (options_.isFixed.empty())
      for (double& x : uv_) x *= scale;
    else
      rest_ = scaledDown(std::move(rest_), scale);
    shape_.straighten(uv_);
    out_.energyBefore = energy_ = energyOf(uv_);
    const std::vector<double> start = uv_;
    isSimple_ = isSimple(uv_);
    if (std::isfinite(energy_)) iterate();
    out_.energy = layoutEnergy(chart_, rest_, options_.energy, uv_, options_.pool);
    const bool isBetter =
        springs_.isEmpty() ? out_.energy < out_.energyBefore : energy_ < out_.energyBefore;
    if (!isBetter) {
      out_.energy = out_.energyBefore;
      uv_ = start;
    }
    out_.uv = std::move(uv_);
    return std::move(out_);
  }

 private:
  /// The energy does not change when the whole layout moves. So if nothing is fixed, one vertex is
  /// held, and the vertex farthest from it is kept from turning round it.
  void findHeld() {
    isFixed_ = options_.isFixed;
    if (std::find(isFixed_.begin(), isFixed_.end(), 1) != isFixed_.end()) return;
    isFixed_.assign(chart_.vertexCount(), 0);
    held_ = chart_.boundaryVertex(BoundaryIndex(0));
    isFixed_[held_] = 1;
    const Point2 held = pointAt(uv_, held_);
    double most = 0;
    for (const ChartVertex v : chart_.vertices()) {
      const Point2 p = pointAt(uv_, v);
      const double distance = norm(p[0] - held[0], p[1] - held[1]);
      if (distance <= most) continue;
      most = distance;
      far_ = v;
    }
  }

  double energyOf(const std::vector<double>& uv) const {
    const double own = layoutEnergy(chart_, rest_, options_.energy, uv, options_.pool);
    if (!std::isfinite(own)) return own;
    return own + shape_.energy(uv) + springs_.energy(uv) + (barrier_ ? barrier_->energy(uv) : 0);
  }

  bool isSimple(const std::vector<double>& uv) const {
    return findCrossings(boundaryUv(chart_, uv), 1).count == 0;
  }

  void assemble() {
    const ElementCurvature curvature = isFar_ ? ElementCurvature::Far : ElementCurvature::Near;
    system_.assemble({uv_, options_.energy, curvature}, isFixed_);
    gradient_ = system_.gradient();
    if (foreseen_ || !springs_.isEmpty()) addContacts();
    if (!far_.exists()) return;
    const Point2 far = pointAt(uv_, far_), held = pointAt(uv_, held_);
    const double x = far[0] - held[0], y = far[1] - held[1], length = norm(x, y);
    system_.pull(far_, {-y / length, x / length}, 1);
  }

  bool isFixedRow(int row) const { return isFixed_[ChartVertex(row / 2)] != 0; }

  void addContacts() {
    contacts_.clear();
    shape_.addDerivatives(uv_, gradient_, contacts_);
    springs_.addDerivatives(uv_, gradient_, contacts_);
    if (barrier_) barrier_->addDerivatives(uv_, gradient_, contacts_);
    for (int row = 0; row < gradient_.size(); ++row)
      if (isFixedRow(row)) gradient_[row] = 0;
  }

  /// Reach of contacts.
  double reach() const {
    const double size = std::sqrt(surfaceArea(chart_)), least = kContactReachOfTouching * size;
    return BoundaryBarrier(chart_, least).energy(uv_) > 0 ? least : kContactReach * size;
  }

  void lookAhead() {
    if (!foreseen_) foreseen_ = std::make_unique<ForeseenContacts>(chart_, shape_, reach());
  }

  /// The entries without those in fixed rows or columns.
  SparseEntries freeOf(SparseEntries entries) const {
    const auto isFixed = [&](const auto& e) { return isFixedRow(e.row()) || isFixedRow(e.col()); };
    entries.erase(std::remove_if(entries.begin(), entries.end(), isFixed), entries.end());
    return entries;
  }

  void makeSolver(const Eigen::SparseMatrix<double>& matrix) {
    const IdVector<ChartVertex, std::uint32_t>& rank =
        options_.eliminationRank.empty() ? chart_.eliminationRank : options_.eliminationRank;
    solver_ = makeRowSolverWithin(matrix, kinds(), out_.memory, options_.pool, rankOfRows(rank));
  }

  /// False if the system has no solution.
  bool findDirection() {
    if (foreseen_) foreseen_->begin(uv_);
    if (!minimizeModel()) return false;
    for (int i = 0; foreseen_ && i < kRounds && solves_ < options_.maxSolves; ++i) {
      const double length = longest();
      if (!foreseen_->update(uv_, direction_, length, length / (1 << i / 2))) break;
      if (!minimizeModel()) return false;
    }
    if (slope() < 0) return true;
    if (!foreseen_) return false;
    foreseen_->clear();  // together the springs push uphill
    return minimizeModel() && slope() < 0;
  }

  /// Slope of the energy along the direction.
  double slope() {
    slope_ = 0;
    for (std::size_t i = 0; i < direction_.size(); ++i)
      slope_ += gradient_.data()[i] * direction_[i];
    return slope_;
  }

  /// The longest step along the direction without a flip, at most 1.
  double longest() const {
    return std::min(
        1.0, kShareOfLongest * longestStep(chart_, rest_, uv_, direction_, 2, options_.pool));
  }

  /// Includes the foreseen springs.
  bool minimizeModel() {
    ++solves_;
    Eigen::VectorXd b = gradient_;
    SparseEntries contacts = contacts_;
    if (foreseen_) foreseen_->addDerivatives(b, contacts);
    for (int row = 0; row < b.size(); ++row) b[row] = isFixedRow(row) ? 0 : -b[row];
    if (matrix_->add(freeOf(std::move(contacts)))) makeSolver(matrix_->sum());
    solver_->forget();  // iterating with an old factor would cost more than a new one
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    const double share = foreseen_ || !springs_.isEmpty() ? kLinearToleranceHeld : kLinearTolerance;
    const double tolerance = share * b.lpNorm<Eigen::Infinity>();
    if (!solver_->solve(matrix_->sum(), b, tolerance, x) || !x.allFinite()) return false;
    direction_.assign(x.data(), x.data() + x.size());
    return true;
  }

  std::vector<std::uint8_t> kinds() const {
    std::vector<std::uint8_t> out(2 * chart_.vertices().size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = i % 2;
    return out;
  }

  void iterate() {
    while (out_.steps < options_.maxSteps && solves_ < options_.maxSolves &&
           (!options_.onStep || options_.onStep())) {
      assemble();
      if (!findDirection()) return;
      const double gain = -slope_ / 2;
      isFar_ = gain > kFar * (energy_ - Energy::kAtRest);
      const double small = std::min(energy_ - Energy::kAtRest, kShareOfEnergy * energy_);
      const double least = foreseen_ ? options_.leastHeld : 0;
      const bool isLast = remainder(gain) <= options_.tolerance * small + least + kRounding;
      const Step taken = step();
      lastGain_ = isFull_ ? gain : 0;
      if (taken == Step::Crosses) {
        barrier_ = std::make_unique<BoundaryBarrier>(chart_, reach());
        lookAhead();
        energy_ = energyOf(uv_);
        out_.isHeldApart = true;
        continue;
      }
      out_.steps += taken == Step::Taken;
      out_.isConverged = isLast;
      if (isLast || taken == Step::None) return;
    }
  }

  /// The gain of all steps after the next one, if gains go on shrinking as from the last step to
  /// this one.
  double remainder(double gain) const {
    const double rate = std::max(gain / lastGain_, kFastest);
    return lastGain_ > 0 && rate < kSlowest ? gain * rate / (1 - rate) : gain;
  }

  enum class Step { Taken, None, Crosses };

  Step step() {
    isFull_ = false;
    double length = longest();
    std::vector<double> next(uv_.size());
    for (int i = 0; i < kMostHalvings; ++i, length /= 2) {
      for (std::size_t k = 0; k < uv_.size(); ++k) next[k] = uv_[k] + length * direction_[k];
      shape_.straighten(next);
      const double energy = energyOf(next);
      if (!(energy <= energy_ + kArmijo * length * slope_)) continue;
      const bool isNextSimple = isSimple(next);
      if (isSimple_ && !isNextSimple) {
        if (!barrier_) return Step::Crosses;
        continue;
      }
      isSimple_ = isNextSimple;
      isFull_ = length == 1;
      const bool isLess = energy < energy_;
      energy_ = energy;
      uv_ = std::move(next);
      return isLess ? Step::Taken : Step::None;
    }
    return Step::None;
  }

  const DiskChart& chart_;
  const RefineOptions& options_;
  RestTriangles rest_;
  std::vector<double> uv_, direction_;
  RefineSystem system_;
  OutlineShape shape_;
  LevelSprings springs_;
  std::unique_ptr<BoundaryBarrier> barrier_;  ///< exists once the boundary would cross itself
  std::unique_ptr<ForeseenContacts> foreseen_;
  Eigen::VectorXd gradient_;
  SparseEntries contacts_;
  std::unique_ptr<ExtendedMatrix> matrix_;
  int solves_ = 0;
  bool isSimple_ = true;
  bool isFar_ = true;    ///< far from the minimum
  bool isFull_ = false;  ///< whether the last step was taken in full
  std::unique_ptr<RowSolver> solver_;
  IdVector<ChartVertex, std::uint8_t> isFixed_;
  ChartVertex held_, far_;
  double energy_ = 0, slope_ = 0;
  double lastGain_ = 0;  ///< promised by the last step if that was taken in full; otherwise 0
  Refinement out_;
};

}  // namespace

Refinement refine(const DiskChart& chart, std::vector<double> uv, const RefineOptions& options) {
  return Refiner(chart, std::move(uv), options).run();
}

double energyOf(const DiskChart& chart, const std::vector<double>& uv, const Energy& energy) {
  const RestTriangles rest = restTriangles(chart, uv);
  const double scale = bestScale(chart, rest, energy, uv);
  return layoutEnergy(chart, scaledDown(rest, scale), energy, uv);
}

double stretchBeforeRefining(double stretch, const Energy& energy) {
  return 1 + (stretch - 1) / energy.shareLeft();
}

}  // namespace abflat
