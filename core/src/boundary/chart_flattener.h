#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "abflat/chart_report.h"
#include "angle/angle_problem.h"
#include "base/listener.h"
#include "boundary/missed_angles.h"
#include "boundary/straight_runs.h"
#include "chart/disk_chart.h"
#include "check/distortion.h"
#include "check/validity.h"
#include "solve/angle_solution.h"
#include "solve/factor_memory.h"
#include "solve/solver_choice.h"

namespace abflat {

class AngleSolver;

/// How far an attempt got.
enum class Ending : std::uint8_t {
  LaidOut,    ///< its layout has been checked and measured
  GivenUp,    ///< no layout: it would take more Newton steps than are allowed
  Cancelled,  ///< no layout: the listener has stopped
};

/// A layout for certain bounds, and how it was reached.
struct Attempt {
  Ending ending = Ending::LaidOut;
  BoundaryBounds t;
  AngleSolution solution;  ///< without angles if the layout is Tutte's
  std::vector<double> uv;  ///< in chart units
  Validity validity;
  Distortion distortion;
  Solver solver = Solver::ActiveSet;
  std::vector<std::string> fallbacks;  ///< one sentence each
  std::optional<DelaunayReport> delaunay;
  std::optional<RefineReport> refined;
  std::optional<PinReport> pins;
  std::optional<StraightReport> straight;
  bool wasValidUnpinned = false;  ///< only set for pinned layouts
  /// Margin of condition (9), in radians, for attempts that start from this one; none: it is not
  /// asked for.
  std::optional<double> delaunayMargin;
  MissedAngles exceeded;  ///< of the bounds asked for; none if pins come first
  MissedAngles bent;      ///< of the straight runs asked for; none if pins come first

  bool isCancelled() const { return ending == Ending::Cancelled; }
  bool isGivenUp() const { return ending == Ending::GivenUp; }
  bool converged() const {
    const bool isSolved = solver == Solver::Tutte || solver == Solver::Projection;
    return ending == Ending::LaidOut && (isSolved || solution.converged);
  }
  bool hasAskedAngles() const { return exceeded.count == 0 && bent.count == 0; }
  bool valid() const { return converged() && validity.valid() && hasAskedAngles(); }
};

/// checkValidity(), but parts of the boundary that almost touch count as crossings, so that a valid
/// layout stays valid when it is moved and rounded.
Validity checkSeparated(const DiskChart& chart, const std::vector<double>& uv);

/// What is done instead of a factor, and why, in one sentence; empty if the factor fits.
std::string withoutFactorNote(const FactorMemory& memory);

/// What layouts of a chart have to be, beyond maps.
struct LayoutDemands {
  /// Then checkSeparated() decides whether layouts are valid, and angles need not be more exact
  /// than in single precision.
  bool areSeparated = false;
  BoundaryBounds bounds = {};    ///< empty: none; attempts may be made with tighter ones
  StraightPlaces straight = {};  ///< where the boundary goes straight on, whatever the bounds
};

/// How exact the angles of an attempt have to be.
enum class Exactness : std::uint8_t {
  Converged,
  Rough  ///< just good enough to be refined
};

/// Solves, lays out and checks one chart for changing bounds, reusing everything that does not
/// depend on them.
class ChartFlattener {
 public:
  /// Keeps a reference to the chart. `listener` is told of each step and of the stages Layout
  /// and Check.
  ChartFlattener(const DiskChart& chart, SolverOptions options, LayoutDemands demands = {},
                 Listener listener = {}, const SolverChoice& choice = {});
  ~ChartFlattener();
  ChartFlattener(const ChartFlattener&) = delete;
  ChartFlattener& operator=(const ChartFlattener&) = delete;

  /// `warm`: an attempt with other bounds to start from, or null. If the angles are too small to be
  /// drawn, the interior point method takes over, with rising floors of its barrier, unless
  /// condition (9) is asked for.
  Attempt attempt(const BoundaryBounds& t, const Attempt* warm,
                  Exactness exactness = Exactness::Converged);

  /// While it lives, limits the Newton steps of all attempts together: those that would need more
  /// are given up.
  class StepLimit {
   public:
    StepLimit(ChartFlattener& flattener, int steps) : flattener_(flattener) {
      flattener.mostSteps_ = flattener.steps_ + steps;
    }
    ~StepLimit() { flattener_.mostSteps_ = std::numeric_limits<int>::max(); }
    StepLimit(const StepLimit&) = delete;
    StepLimit& operator=(const StepLimit&) = delete;

   private:
    ChartFlattener& flattener_;
  };

  bool isSpent() const { return steps_ > mostSteps_; }

  /// Newton steps taken so far, over all attempts.
  int steps() const { return steps_; }

  /// In a valid layout, different parts of the boundary are at least this far apart.
  double leastDistance(const std::vector<double>& uv) const;

  /// Crossings of the boundary, as the validity of a layout counts them.
  Crossings crossings(const std::vector<double>& uv) const;

  const StraightPlaces& straight() const { return demands_.straight; }

  /// Interior edges, as half-edges, that stay violated when condition (9) is met as far as possible
  /// with the bounds of `from`.
  std::vector<ChartCorner> resistingEdges(const Attempt& from);

  /// Tutte's embedding on a circle, whose arcs along straight runs are chords. It is always a valid
  /// map, up to floating-point precision, but it respects neither angles nor bounds `t` below 1.
  Attempt tutte(const BoundaryBounds& t, const std::string& reason);

  /// Frees factors. After this only Tutte attempts are allowed.
  void endSolving();

  /// See DiskChart; empty if none was found.
  IdVector<ChartVertex, std::uint32_t> eliminationRank() const;

  /// Checks and measures the layout of an attempt, however it was made.
  void measure(Attempt& a);

  /// Adds to the time that the flattener measures itself.
  void addRefining(double seconds) { timings_.refine += seconds; }

  /// Seconds spent so far, over all attempts.
  const Timings& timings() const { return timings_; }

  /// Why factors are not used, in one sentence; empty if they are.
  std::string memoryNote() const;

  const DiskChart& chart() const { return chart_; }

 private:
  /// Counts steps, and ends the solution with the last step allowed.
  SolverOptions counting(SolverOptions options);
  Attempt withoutLayout(const BoundaryBounds& t) const;
  void setAllBounds(const BoundaryBounds& t, std::optional<double> delaunayMargin);
  void layOutAndCheck(Attempt& a);
  Validity check(const std::vector<double>& uv) const;

  const DiskChart& chart_;
  const LayoutDemands demands_;
  AngleProblem problem_;
  std::unique_ptr<AngleSolver> solver_;  ///< until solving has ended
  const Listener listener_;
  Timings timings_;
  int steps_ = 0, mostSteps_ = std::numeric_limits<int>::max();
  IdVector<ChartVertex, std::uint32_t> eliminationRank_;  ///< once solving has ended
};

}  // namespace abflat
